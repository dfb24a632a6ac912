/* SPDX-License-Identifier: MIT
 *
 * The graphite model's tables: what a captured grain needs so that drawing is additions and look-ups.
 * Input: profile.grain. Output: grain_tables.
 */
#include "base/interpolate.h"
#include "base/normal.h"
#include "stroke/pencil.h"

#include <math.h>
#include <stdlib.h>

/* Where the mean section is fainter than this the modes fade with it: they were measured on the line. */
#define FAINT_SECTION 0.15

static void tabulate_normals(grain_tables *t)
{
    for (int k = 0; k < GRAIN_NORMALS / 2; k++) {
        double x = plb_normal_quantile((k + 0.5) / GRAIN_NORMALS);
        t->normal[k] = (float)x;
        t->normal[GRAIN_NORMALS - 1 - k] = (float)-x;
    }
}

/* The field is normal for one line; over lines of different roughness it is a mixture. Its values become scores of that
 * mixture, so that the captured greys come out in their captured shares. */
static void tabulate_scores(grain_tables *t, const grain_model *g)
{
    enum { MIXED = 64 };
    double sd = sqrt((double)g->line_factor[2][0] * g->line_factor[2][0] + (double)g->line_factor[2][1] * g->line_factor[2][1] +
                     (double)g->line_factor[2][2] * g->line_factor[2][2]);
    double rough[MIXED];
    for (int i = 0; i < MIXED; i++)
        rough[i] = exp(g->line_mean[2] + sd * plb_normal_quantile((i + 0.5) / MIXED));
    for (int k = 0; k < GRAIN_MAP; k++) {
        double x = (k - GRAIN_MAP / 2) * 16.0 / (GRAIN_MAP - 1), share = 0;
        for (int i = 0; i < MIXED; i++)
            share += plb_normal_share(x / rough[i]) / MIXED;
        double score = plb_normal_quantile(share) * GRAIN_SCORE_UNIT;
        t->score[k] = (int8_t)(score > 127 ? 127 : score < -127 ? -127 : floor(score + 0.5));
    }
}

static void tabulate_darkness(grain_tables *t, const grain_model *g)
{
    for (int level = 0; level < 256; level++) {
        double m = (double)level / GRAIN_LEVEL_UNIT;
        int i = 0;
        while (i + 2 < GRAIN_LEVELS && m >= plb_grain_levels[i + 1])
            i++;
        double w = (m - plb_grain_levels[i]) / (plb_grain_levels[i + 1] - plb_grain_levels[i]);
        w = w > 1 ? 1 : w;
        for (int k = 0; k < 128; k++) {
            double z = (2 * k + 1 - 128) / (double)GRAIN_SCORE_UNIT, step = 6.0 / (GRAIN_SCORES - 1);
            double low = plb_interpolate(g->darkness[i], GRAIN_SCORES, -3, step, z);
            double high = plb_interpolate(g->darkness[i + 1], GRAIN_SCORES, -3, step, z);
            double v = (low + w * (high - low)) * GRAIN_RELATIVE_UNIT;
            t->darkness[level][k] = (uint16_t)(v < 0 ? 0 : v > 65535 ? 65535 : floor(v + 0.5));
        }
    }
}

static void tabulate_section(grain_tables *t, const grain_model *g)
{
    for (int k = 0; k < GRAIN_MODE_PLACES; k++) {
        double place = fabs((k - GRAIN_MODE_PLACES / 2) * PROFILE_SECTION_STEP);
        double f = plb_interpolate(g->section, GRAIN_SECTION, PROFILE_SECTION_STEP / 2, PROFILE_SECTION_STEP, place);
        double fade = f < FAINT_SECTION ? f / FAINT_SECTION : 1;
        t->section[k] = (float)f;
        for (int i = 0; i < GRAIN_MODES; i++)
            t->mode[i][k] = (float)(g->mode[i][k] * (fade < 0 ? 0 : fade));
    }
}

/* Each mode's coefficient is an Ornstein-Uhlenbeck process smoothed by the Gaussian with which it was captured, here
 * from knot to knot. */
static void tabulate_slow(grain_tables *t, const grain_model *g)
{
    double weight[2 * GRAIN_SMOOTH_KNOTS + 1], sum = 0, sigma = GRAIN_SMOOTH / GRAIN_KNOT;
    int n = 2 * GRAIN_SMOOTH_KNOTS + 1;
    for (int i = 0; i < n; i++)
        sum += weight[i] = exp(-(i - GRAIN_SMOOTH_KNOTS) * (i - GRAIN_SMOOTH_KNOTS) / (2 * sigma * sigma));
    for (int i = 0; i < n; i++)
        t->smooth[i] = (float)(weight[i] / sum);
    for (int k = 0; k < GRAIN_MODES; k++) {
        double keep = g->mode_length[k] > 0 ? exp(-GRAIN_KNOT / (double)g->mode_length[k]) : 0, variance = 0;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                variance += t->smooth[i] * t->smooth[j] * pow(keep, abs(i - j));
        t->knot_keep[k] = (float)keep;
        t->knot_scale[k] = (float)(variance > 0 ? sqrt(g->mode_within[k] / variance) : 0);
    }
}

bool plb_pencil_tabulate_grain(pencil *p)
{
    const grain_model *g = &p->profile->grain;
    grain_tables *t = p->grain = plb_new(1, sizeof *t);
    if (!t)
        return false;
    tabulate_normals(t);
    tabulate_scores(t, g);
    tabulate_darkness(t, g);
    tabulate_section(t, g);
    tabulate_slow(t, g);
    return true;
}
