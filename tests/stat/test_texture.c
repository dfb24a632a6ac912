/* SPDX-License-Identifier: MIT
 *
 * The texture, each step by itself, over many strokes: histogram bounds of the fill, the co-occurrence pass, the blur.
 */
#include "check.h"

#include "stat/pencil_for_tests.h"
#include "stroke/pencil.h"

typedef struct {
    profile *profile;
    pencil *pencil;
    strip strip;
} setup;

static setup prepare(void)
{
    setup s = {.profile = profile_for_tests()};
    s.pencil = plb_pencil_new(s.profile, NULL);
    return s;
}

static void clean(setup *s)
{
    plb_strip_free(&s->strip);
    plb_pencil_free(s->pencil);
    free_profile_for_tests(s->profile);
}

static int row_offset(const strip *s, int y)
{
    int k = y - s->rows / 2;
    return k < 0 ? -k : k;
}

static void fill_keeps_its_bounds(void)
{
    setup s = prepare();
    for (uint64_t seed = 1; seed <= 100; seed++) {
        CHECK(plb_texture_fill(&s.strip, 157, s.pencil, seed, 7 * seed, NULL));
        CHECK(s.strip.columns == 157 + 4 && s.strip.rows % 2 == 1);
        for (int y = 0; y < s.strip.rows; y++)
            for (int x = 0; x < s.strip.columns; x++) {
                int g = s.strip.grey[y * s.strip.columns + x], k = row_offset(&s.strip, y);
                bool margin = x < 2 || x >= s.strip.columns - 2 || k > s.pencil->half_rows;
                if (margin)
                    CHECK(g == 255);
                else if (k == 0)
                    CHECK(g >= 100 && g <= 180);
                else if (k <= s.pencil->half_beside)
                    CHECK(g >= 90 && g <= 180);
                else
                    CHECK(g >= 180 && g <= 250);
            }
    }
    clean(&s);
}

/* The centre's histogram is the profile's: largest difference of the cumulated shares (Kolmogorov's statistic). */
static void centre_replicates_the_histogram(void)
{
    setup s = prepare();
    double seen[256] = {0}, total = 0, want = 0, have = 0, all = 0, worst = 0;
    for (uint64_t seed = 1; seed <= 400; seed++) {
        CHECK(plb_texture_fill(&s.strip, 200, s.pencil, seed, 3, NULL));
        for (int x = 2; x < s.strip.columns - 2; x++, total++)
            seen[s.strip.grey[s.strip.rows / 2 * s.strip.columns + x]]++;
    }
    for (int g = 0; g < 256; g++)
        all += s.profile->mid[g];
    for (int g = 0; g < 256; g++) {
        want += s.profile->mid[g] / all;
        have += seen[g] / total;
        worst = fmax(worst, fabs(want - have));
    }
    CHECK_RANGE(worst, 0, 1.63 / sqrt(total) + 1.0 / CENTRE_STEPS); /* 1 % level, and the table's own step */
    clean(&s);
}

static void rows_beside_are_uniform(void)
{
    setup s = prepare();
    double seen[256] = {0}, total = 0;
    for (uint64_t seed = 1; seed <= 400; seed++) {
        CHECK(plb_texture_fill(&s.strip, 200, s.pencil, seed, 3, NULL));
        for (int x = 2; x < s.strip.columns - 2; x++, total++)
            seen[s.strip.grey[(s.strip.rows / 2 + 1) * s.strip.columns + x]]++;
    }
    for (int g = 90; g <= 180; g++)
        CHECK_RANGE(seen[g] / total * 91, 0.8, 1.2);
    clean(&s);
}

/* Counts the neighbouring pairs that the matrix does not know. */
static long unknown_pairs(const strip *s, const profile *p)
{
    long n = 0;
    for (int y = 2; y < s->rows - 2; y++)
        for (int x = 2; x + 1 < s->columns - 2; x++) {
            const uint8_t *g = s->grey + y * s->columns + x;
            n += p->ccm[g[0] * PROFILE_GREYS + g[1]] == 0;
        }
    return n;
}

static void ccm_removes_unknown_pairs(void)
{
    setup s = prepare();
    for (uint64_t seed = 1; seed <= 50; seed++) {
        long changes[CCM_MAX_PASSES];
        CHECK(plb_texture_fill(&s.strip, 300, s.pencil, seed, 5, NULL));
        long before = unknown_pairs(&s.strip, s.profile);
        int passes = plb_texture_ccm(&s.strip, s.pencil, changes);
        long after = unknown_pairs(&s.strip, s.profile);
        CHECK(before > 500);
        CHECK_RANGE((double)after / (double)before, 0, 0.35);
        CHECK(passes >= 2 && passes <= CCM_MAX_PASSES);
        for (int k = 1; k + 1 < passes; k++) /* it ends with the first pass that no longer falls by a tenth */
            CHECK((double)changes[k] <= 0.9 * (double)changes[k - 1]);
        CHECK(passes == CCM_MAX_PASSES || changes[passes - 1] == 0 || (double)changes[passes - 1] > 0.9 * (double)changes[passes - 2]);
    }
    clean(&s);
}

static void nearest_table_is_nearest(void)
{
    setup s = prepare();
    uint32_t *ccm = s.profile->ccm;
    memset(ccm, 0, PROFILE_GREYS * PROFILE_GREYS * sizeof *ccm);
    static const int known[] = {3, 90, 91, 200};
    for (int k = 0; k < 4; k++)
        ccm[7 * PROFILE_GREYS + known[k]] = 1;
    pencil *p = plb_pencil_new(s.profile, NULL);
    for (int j = 0; j < PROFILE_GREYS; j++) {
        int best = known[0];
        for (int k = 1; k < 4; k++)
            if (abs(known[k] - j) < abs(best - j))
                best = known[k];
        CHECK(p->nearest[7][j] == best);
        CHECK(p->nearest[8][j] == j); /* a grey the matrix never saw leaves its neighbours alone */
    }
    plb_pencil_free(p);
    clean(&s);
}

static void blur_is_the_gaussian(void)
{
    uint8_t grey[49], spare[49];
    memset(grey, 255, sizeof grey);
    grey[3 * 7 + 3] = 255 - 160;
    strip s = {7, 7, 49, grey, spare};
    plb_texture_blur(&s);
    static const int weight[3][3] = {{10, 20, 10}, {20, 40, 20}, {10, 20, 10}}; /* 160 / 16 … */
    for (int y = 0; y < 7; y++)
        for (int x = 0; x < 7; x++) {
            bool near = abs(y - 3) <= 1 && abs(x - 3) <= 1;
            CHECK(255 - grey[y * 7 + x] == (near ? weight[y - 2][x - 2] : 0));
        }
}

static void no_two_strokes_share_a_texture(void)
{
    setup s = prepare();
    uint8_t first[200];
    CHECK(plb_texture_fill(&s.strip, 200, s.pencil, 1, 1, NULL));
    memcpy(first, s.strip.grey + s.strip.rows / 2 * s.strip.columns + 2, 200);
    for (uint64_t id = 2; id <= 100; id++) {
        CHECK(plb_texture_fill(&s.strip, 200, s.pencil, 1, id, NULL));
        int same = 0;
        for (int x = 0; x < 200; x++)
            same += s.strip.grey[s.strip.rows / 2 * s.strip.columns + 2 + x] == first[x];
        CHECK(same < 25); /* chance alone makes 3 */
    }
    clean(&s);
}

int main(void)
{
    RUN(fill_keeps_its_bounds);
    RUN(centre_replicates_the_histogram);
    RUN(rows_beside_are_uniform);
    RUN(ccm_removes_unknown_pairs);
    RUN(nearest_table_is_nearest);
    RUN(blur_is_the_gaussian);
    RUN(no_two_strokes_share_a_texture);
    CHECK_EXIT;
}
