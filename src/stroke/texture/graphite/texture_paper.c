/* SPDX-License-Identifier: MIT
 *
 * The paper's tooth is a field of heights over the page (Sousa & Buchanan, Computer Graphics Forum 19(1), 2000, take a
 * height field likewise; theirs is scanned, this one is drawn by lot).
 * Input: the kind of paper, a seed, places in mm on the page. Output: heights with mean 0 and variance 1, normal.
 *
 * Two tiles of filtered white noise whose sides are different primes, added: neither repeats visibly, and both together
 * repeat after some 33,000 texels, nearly three metres. A texel is 1/300 inch whatever the page's resolution.
 */
#include "stroke/pencil.h"

#include "base/array.h"
#include "base/number/random.h"
#include "base/number/units.h"
#include "base/simd_clones.h"

#include <math.h>

static const int sides[PAPER_TILES] = {191, 173};

/* How much of the grain is the paper's, and the weight of a texel's neighbours in its height, which sets how broad the
 * hollows are. The first chosen by eye and before the observer, which tells lines on rougher paper from scanned ones more
 * easily; the second so that heights of medium paper correlate as the grain of scanned lines does, .37 with the next texel. */
typedef struct {
    double share, neighbour;
} recipe;
static const recipe recipes[] = {[PAPER_NONE] = {0, 0}, [PAPER_SMOOTH] = {0.07, 0.10}, [PAPER_MEDIUM] = {0.15, 0.20}, [PAPER_ROUGH] = {0.6, 0.28}};

/* White noise along one row of a tile: five numbers of 12 bits from each draw. */
static void white_row(const float normal[], int tile, int row, float out[PAPER_SIDE_MAX])
{
    uint64_t key = random_key((uint64_t)tile, (uint64_t)row, PURPOSE_PAPER);
    for (int k = 0; k < sides[tile]; k += 5) {
        uint64_t bits = random_bits(key, (uint64_t)k);
        for (int i = k; i < k + 5 && i < sides[tile]; i++, bits >>= 12)
            out[i] = normal[bits & (GRAIN_NORMALS - 1)];
    }
}

/* Each element and its two neighbours, `stride` apart on a ring of n. */
static void filter_ring(const float *in, float *out, int n, int stride, float neighbour)
{
    for (int k = 0; k < n; k++) {
        int before = k ? k - 1 : n - 1, after = k + 1 < n ? k + 1 : 0;
        out[k * stride] = in[k * stride] + neighbour * (in[before * stride] + in[after * stride]);
    }
}

static void write_tile(const float *height, int side, float scale, int8_t out[PAPER_SIDE_MAX][PAPER_SIDE_MAX + PAPER_RUN])
{
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side + PAPER_RUN; x++) {
            float v = height[y * side + x % side] * scale;
            out[y][x] = (int8_t)floorf((v > 127 ? 127 : v < -127 ? -127 : v) + 0.5f);
        }
}

static void make_tile(paper *p, int tile, float neighbour, const float normal[], float *a, float *b)
{
    int side = sides[tile];
    for (int y = 0; y < side; y++) {
        float white[PAPER_SIDE_MAX];
        white_row(normal, tile, y, white);
        filter_ring(white, a + y * side, side, 1, neighbour);
    }
    for (int x = 0; x < side; x++)
        filter_ring(a + x, b + x, side, side, neighbour);
    float energy = 1 + 2 * neighbour * neighbour; /* of either filter */
    write_tile(b, side, PAPER_UNIT / (energy * sqrtf(PAPER_TILES)), p->tile[tile]);
}

bool plb_paper_make(paper *p, paper_kind kind, const float normal[])
{
    const recipe *r = &recipes[kind];
    double a = r->neighbour, energy = 1 + 2 * a * a;
    p->share = r->share;
    p->correlation[0] = 1;
    p->correlation[1] = 2 * a / energy;
    p->correlation[2] = a * a / energy;
    float *scratch = plb_new(2 * PAPER_SIDE_MAX * PAPER_SIDE_MAX, sizeof *scratch);
    for (int i = 0; i < PAPER_TILES && scratch && kind != PAPER_NONE; i++)
        make_tile(p, i, (float)a, normal, scratch, scratch + PAPER_SIDE_MAX * PAPER_SIDE_MAX);
    plb_free(scratch);
    return scratch != NULL;
}

paper_sheet plb_paper_sheet(uint64_t seed)
{
    paper_sheet s;
    for (int i = 0; i < PAPER_TILES; i++) {
        uint64_t bits = random_key(seed, (uint64_t)i, PURPOSE_PAPER);
        s.x[i] = (int)((bits & 0xffffffff) % (uint64_t)sides[i]);
        s.y[i] = (int)((bits >> 32) % (uint64_t)sides[i]);
    }
    return s;
}

/* `at`, a whole number that no page is large enough to exceed, on a ring. */
static inline int wrap(int64_t at, int tile)
{
    const uint64_t turns = (uint64_t)1 << 40, side = (uint64_t)sides[tile];
    return (int)(((uint64_t)at + turns * side) % side);
}

static inline int64_t floor_of(double v)
{
    int64_t whole = (int64_t)v;
    return whole - (v < (double)whole);
}

static int16_t height_at(const paper *p, const paper_sheet *sheet, int64_t x, int64_t y)
{
    int sum = 0;
    for (int i = 0; i < PAPER_TILES; i++)
        sum += p->tile[i][wrap(y + sheet->y[i], i)][wrap(x + sheet->x[i], i)];
    return (int16_t)sum;
}

#define TEXELS_PER_MM (1 / MM_PER_PAPER_PX)

/* On a page of the paper's resolution. */
PLB_SIMD_CLONES static void add_rows(const int8_t *restrict a, const int8_t *restrict b, int n, int16_t *restrict out)
{
    for (int k = 0; k < n; k++)
        out[k] = (int16_t)(a[k] + b[k]);
}

/* In which texels, counted from the first one, points number `from` on lie, `texels` apart, number 0 so far `within` it. */
PLB_SIMD_CLONES static void find_texels(float within, float texels, int from, int n, int32_t *restrict at)
{
    for (int k = 0; k < n; k++)
        at[k] = (int32_t)(within + (float)(from + k) * texels);
}

void plb_paper_row(const paper *p, const paper_sheet *sheet, double x, double y, double step, int n, int16_t *out)
{
    double px = x * TEXELS_PER_MM, way = step * TEXELS_PER_MM;
    int64_t first = floor_of(px), row = floor_of(y * TEXELS_PER_MM);
    const int8_t *from[PAPER_TILES];
    for (int i = 0; i < PAPER_TILES; i++)
        from[i] = p->tile[i][wrap(row + sheet->y[i], i)] + wrap(first + sheet->x[i], i);
    if (fabs(way - 1) < 1e-9) {
        add_rows(from[0], from[1], (n + PAPER_BLOCK - 1) & -PAPER_BLOCK, out);
        return;
    }
    int32_t at[PAPER_RUN];
    for (int b = 0; b < n; b += PAPER_RUN) {
        int some = n - b < PAPER_RUN ? n - b : PAPER_RUN;
        find_texels((float)(px - (double)first), (float)way, b, some, at);
        if (way * n < PAPER_RUN - 2)
            for (int k = 0; k < some; k++)
                out[b + k] = (int16_t)(from[0][at[k]] + from[1][at[k]]);
        else /* very coarse pages go round the tiles */
            for (int k = 0; k < some; k++)
                out[b + k] = height_at(p, sheet, first + at[k], row);
    }
}
