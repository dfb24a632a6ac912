/* SPDX-License-Identifier: MIT
 *
 * The field of normal numbers that a stroke of the graphite model makes: by the loops written for vectors, and by the place.
 */
#include "check.h"

#include "base/geometry/interpolate.h"
#include "base/number/random.h"
#include "stat/graphite_for_tests.h"

static const grain_ends NO_ENDS = {GRAIN_JOINT, GRAIN_JOINT, 1, 1, false, 1}, FORWARD = {GRAIN_START, GRAIN_LEAVE, 1, 1, false, 1};

static long high_half(long a, long b)
{
    return (a * b) >> 16;
}

static long innovation(const grain_tables *t, int class, uint64_t key, uint64_t column, int row)
{
    long sum = 0;
    for (uint64_t i = 0; i < GRAIN_TAPS; i++)
        sum += t->noise[class][i][(random_bits(key, column + i) & (NOISE_LENGTH - 1)) + (uint64_t)row];
    return sum;
}

/* The field again, one number after the other: what the loops for vectors must come to, byte for byte. A chain of one value. */
static void spell_out_field(const grain *g, uint64_t key, uint64_t columns, int8_t *out)
{
    const grain_tables *t = g->pencil->grain;
    uint64_t region = random_bits(key, columns + GRAIN_TAPS);
    for (int r = 0; r < g->rows; r++) {
        int at = (int)fmin(fabs((double)(r - g->rows / 2)) * (double)g->narrow / ROW_PLACE_STEP + 0.5, ROW_PLACES - 1);
        double a = clamp((double)(t->chain_high + t->row_along[at]), -0.3, 0.95);
        long state = 0, keep = lround(a * 32767), fresh = lround(sqrt(1 - a * a) * 32767);
        for (uint64_t s = 0; s < columns; s++) {
            long inner = innovation(t, 0, key, s, r), outer = innovation(t, 3, key, s, r);
            long fresh_here = t->outer_across > 0 ? inner + 2 * high_half(outer - inner, t->row_outer[at]) : inner;
            state = 2 * ((s ? high_half(state, keep) : 0) + high_half(fresh_here, s ? fresh : 32767));
            long patch_row = (long)((region >> 32) % NOISE_PAD) + r, amplitude = t->amplitude[(region + s) & (AMPLITUDE_LENGTH - 1)][patch_row];
            long v = (high_half(high_half(state, t->row_spread[at]), amplitude * 256) + 2) >> 2;
            out[s * (uint64_t)g->rows + (uint64_t)r] = (int8_t)(v > 127 ? 127 : v < -127 ? -127 : v);
        }
    }
}

/* A pencil whose grain depends on the place in every way that there is. */
static setup prepare_by_place(void)
{
    setup s = prepare();
    grain_model *g = &s.profile->grain;
    plb_pencil_free(s.pencil);
    for (int k = 0; k < GRAIN_PLACES; k++) {
        g->place_scale[k] = 0.8f + 0.05f * (float)k;
        g->place_along[k] = 0.3f - 0.05f * (float)k;
        g->place_across[k] = 0.3f * (float)k / (GRAIN_PLACES - 1);
    }
    g->filter[3][2][1] = g->filter[3][2][3] = 0.3f;
    g->filter[3][2][2] = 0.906f;
    g->volatility = 0.3f;
    g->volatility_across = 0.5f;
    s.pencil = plb_pencil_on_paper(s.profile, PAPER_NONE, NULL);
    CHECK(s.pencil && s.pencil->grain->outer_across > 0);
    return s;
}

static long count_wrong(const setup *s, uint64_t columns, uint64_t id)
{
    static int8_t want[300 * 100];
    long wrong = 0;
    spell_out_field(&s->grain, random_key(1, id, PURPOSE_GRAIN), columns, want);
    for (int c = 0; c < (int)columns; c++)
        for (int r = 0; r < s->grain.rows; r++)
            wrong += want[c * s->grain.rows + r] != s->grain.field[c * s->grain.stride + r];
    return wrong;
}

static void vectors_and_numbers_one_by_one_agree(void)
{
    for (int turn = 0; turn < 2; turn++) {
        setup s = turn ? prepare_by_place() : prepare();
        for (uint64_t id = 1; id <= 20; id++) {
            CHECK(plb_grain_make(&s.grain, 300, FORWARD, s.pencil, 1, id, NULL));
            CHECK(count_wrong(&s, 300, id) == 0);
        }
        clean(&s);
    }
}

/* Strokes show at each place the spread and the correlation along that the profile gives for it. */
static void the_grain_depends_on_the_place(void)
{
    setup s = prepare_by_place();
    static const int places[] = {0, 2, 4};
    for (int i = 0; i < 3; i++) {
        double squares = 0, next = 0, n = 0, at = places[i];
        for (uint64_t id = 1; id <= 80; id++) {
            CHECK(plb_grain_make(&s.grain, 400, NO_ENDS, s.pencil, 1, id, NULL));
            for (int c = 0; c + 1 < s.grain.columns; c++, n++) {
                const int8_t *here = s.grain.field + c * s.grain.stride + s.grain.rows / 2 + places[i];
                squares += here[0] * here[0];
                next += here[0] * here[s.grain.stride];
            }
        }
        double scale = fmax(0.8, 0.775 + 0.1 * at), along = 0.4 + fmin(0.3, 0.325 - 0.1 * at);
        CHECK_RANGE(sqrt(squares / n) / FIELD_UNIT / scale, 0.9, 1.15); /* patches of roughness add to it */
        CHECK_RANGE(next / squares - along, -0.07, 0.07);
    }
    clean(&s);
}

int main(void)
{
    RUN(vectors_and_numbers_one_by_one_agree);
    RUN(the_grain_depends_on_the_place);
    CHECK_EXIT;
}
