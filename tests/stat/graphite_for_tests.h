/* SPDX-License-Identifier: MIT
 *
 * A made-up pencil with a grain, for tests of the graphite model.
 */
#ifndef PLB_TESTS_GRAPHITE_FOR_TESTS_H
#define PLB_TESTS_GRAPHITE_FOR_TESTS_H

#include "check.h"
#include "stat/pencil_for_tests.h"
#include "stroke/pencil.h"

#include <math.h>

#define DEPTH 90.0
#define WIDTH 6.0

/* A Gaussian section 6 px wide at half depth, no slow modes, grain of a quarter of the depth at every level, white along
 * and across but for a chain of 0.4. */
static void add_grain(profile *p)
{
    grain_model *g = &p->grain;
    memset(g, 0, sizeof *g);
    g->present = true;
    g->reference_width = (float)WIDTH;
    for (int k = 0; k < GRAIN_SECTION; k++) {
        double t = (k + 0.5) * PROFILE_SECTION_STEP / (WIDTH / 2);
        g->section[k] = (float)exp(-log(2) * t * t);
    }
    for (int i = 0; i < GRAIN_LEVELS; i++)
        for (int k = 0; k < GRAIN_SCORES; k++) {
            double z = -3 + 6.0 * k / (GRAIN_SCORES - 1), m = plb_grain_levels[i], v = m + fmin(m, 0.25) * z * 0.5;
            g->darkness[i][k] = (float)(v < 0 ? 0 : v);
        }
    for (int k = 0; k < GRAIN_PLACES; k++)
        g->place_scale[k] = 1;
    g->chain_high = g->chain_low = 0.4f;
    g->chain_share = 0.42f;
    for (int k = 0; k < GRAIN_CLASSES; k++)
        g->filter[k][2][2] = 1;
    g->line_mean[0] = (float)log(DEPTH);
    g->line_mean[1] = (float)log(WIDTH);
    g->line_mean[3] = 0.4f;
}

typedef struct {
    profile *profile;
    pencil *pencil;
    grain grain;
} setup;

static setup prepare_on(paper_kind kind)
{
    setup s = {.profile = profile_for_tests()};
    add_grain(s.profile);
    s.pencil = plb_pencil_on_paper(s.profile, kind, NULL);
    CHECK(s.pencil);
    return s;
}

static setup prepare(void)
{
    return prepare_on(PAPER_NONE);
}

static void clean(setup *s)
{
    plb_grain_free(&s->grain);
    plb_pencil_free(s->pencil);
    free_profile_for_tests(s->profile);
}

#endif
