/* SPDX-License-Identifier: MIT
 *
 * This header has eight whole numbers of 16 bits in one register: the compiler's vectors, whose operators work lane by lane, and
 * the few steps that the compiler does not find by itself. Other processors, and builds that do not optimise, get loops
 * with the same bits.
 */
#ifndef PLB_BASE_SIMD16_H
#define PLB_BASE_SIMD16_H

#include <stdint.h>
#include <string.h>

#if defined __SSE2__ && defined __OPTIMIZE__
#include <emmintrin.h>
#define SIMD16_NATIVE 1
#define SIMD16_WASM 0
#elif defined __wasm_simd128__ && defined __OPTIMIZE__
#include <wasm_simd128.h>
#define SIMD16_NATIVE 0
#define SIMD16_WASM 1
#else
#define SIMD16_NATIVE 0
#define SIMD16_WASM 0
#endif

#define SIMD16_LANES 8
typedef int16_t lanes __attribute__((vector_size(2 * SIMD16_LANES)));

static inline lanes simd16_at(const int16_t *from)
{
    lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline void simd16_put(int16_t *to, lanes v)
{
    memcpy(to, &v, sizeof v);
}

static inline lanes simd16_all(int16_t v)
{
    return (lanes){v, v, v, v, v, v, v, v};
}

/* Returns the high halves of the products. */
static inline lanes simd16_high(lanes a, lanes b)
{
#if SIMD16_NATIVE
    return (lanes)_mm_mulhi_epi16((__m128i)a, (__m128i)b);
#elif SIMD16_WASM
    v128_t first = wasm_i32x4_extmul_low_i16x8((v128_t)a, (v128_t)b), second = wasm_i32x4_extmul_high_i16x8((v128_t)a, (v128_t)b);
    return (lanes)wasm_i16x8_shuffle(first, second, 1, 3, 5, 7, 9, 11, 13, 15);
#else
    lanes v = {0};
    for (int i = 0; i < SIMD16_LANES; i++)
        v[i] = (int16_t)((a[i] * b[i]) >> 16);
    return v;
#endif
}

static inline lanes simd16_within(lanes v, int16_t low, int16_t high)
{
#if SIMD16_NATIVE
    return (lanes)_mm_max_epi16(_mm_min_epi16((__m128i)v, _mm_set1_epi16(high)), _mm_set1_epi16(low));
#elif SIMD16_WASM
    return (lanes)wasm_i16x8_max(wasm_i16x8_min((v128_t)v, wasm_i16x8_splat(high)), wasm_i16x8_splat(low));
#else
    for (int i = 0; i < SIMD16_LANES; i++)
        v[i] = v[i] < low ? low : v[i] > high ? high : v[i];
    return v;
#endif
}

/* Adds unsigned numbers; sums beyond 65535 become 65535. */
static inline void simd16_add_within(uint16_t *to, const uint16_t *more)
{
#if SIMD16_NATIVE
    __m128i sum = _mm_adds_epu16(_mm_loadu_si128((const __m128i *)(const void *)to), _mm_loadu_si128((const __m128i *)(const void *)more));
    _mm_storeu_si128((__m128i *)(void *)to, sum);
#elif SIMD16_WASM
    wasm_v128_store(to, wasm_u16x8_add_sat(wasm_v128_load(to), wasm_v128_load(more)));
#else
    for (int i = 0; i < SIMD16_LANES; i++)
        to[i] = (uint16_t)(to[i] + more[i] > 65535 ? 65535 : to[i] + more[i]);
#endif
}

/* Returns eight bytes, each times 256. */
static inline lanes simd16_of_bytes(const int8_t *from)
{
#if SIMD16_NATIVE
    return (lanes)_mm_unpacklo_epi8(_mm_setzero_si128(), _mm_loadl_epi64((const __m128i *)(const void *)from));
#elif SIMD16_WASM
    return (lanes)wasm_i16x8_shl(wasm_i16x8_load8x8(from), 8);
#else
    lanes v = {0};
    for (int i = 0; i < SIMD16_LANES; i++)
        v[i] = (int16_t)(from[i] * 256);
    return v;
#endif
}

/* Turns numbers into signed bytes; those beyond -128 and 127 become -128 and 127. */
static inline void simd16_put_bytes(int8_t *to, lanes v)
{
#if SIMD16_NATIVE
    _mm_storel_epi64((__m128i *)(void *)to, _mm_packs_epi16((__m128i)v, (__m128i)v));
#elif SIMD16_WASM
    wasm_v128_store64_lane(to, wasm_i8x16_narrow_i16x8((v128_t)v, (v128_t)v), 0);
#else
    v = simd16_within(v, -128, 127);
    for (int i = 0; i < SIMD16_LANES; i++)
        to[i] = (int8_t)v[i];
#endif
}

/* Turns numbers into unsigned bytes; those beyond 0 and 255 become 0 and 255. */
static inline void simd16_put_unsigned(uint8_t *to, lanes v)
{
#if SIMD16_NATIVE
    _mm_storel_epi64((__m128i *)(void *)to, _mm_packus_epi16((__m128i)v, (__m128i)v));
#elif SIMD16_WASM
    wasm_v128_store64_lane(to, wasm_u8x16_narrow_i16x8((v128_t)v, (v128_t)v), 0);
#else
    v = simd16_within(v, 0, 255);
    for (int i = 0; i < SIMD16_LANES; i++)
        to[i] = (uint8_t)v[i];
#endif
}

#endif
