/* SPDX-License-Identifier: MIT
 *
 * This file takes the steps that capture the grain, in their order.
 */
#include "profile/grain/grain.h"

#include "base/geometry/interpolate.h"

#include <math.h>
#include <string.h>

static bool measure(grain_lines *lines, grain_model *g, error *err)
{
    grain_moments moments;
    plb_grain_section(lines, g);
    if (!plb_grain_modes(lines, g, err))
        return false;
    plb_grain_slow(lines, g);
    if (!plb_grain_darkness(lines, g, err))
        return false;
    plb_grain_scores(lines, g);
    plb_grain_places(lines, g);
    plb_grain_moments(lines, g, &moments);
    plb_grain_chain(&moments, g);
    plb_grain_filter(&moments, g);
    plb_grain_between(lines, &moments, g);
    plb_grain_clamp(g);
    g->present = plb_grain_is_sound(g);
    return true;
}

bool plb_grain_capture(const line_strip strips[], size_t n, grain_model *g, error *err)
{
    grain_lines lines;
    *g = (grain_model){0};
    if (!plb_grain_lines_make(strips, n, &lines, g, err))
        return false;
    bool good = lines.columns < GRAIN_MIN_COLUMNS || measure(&lines, g, err);
    plb_grain_lines_free(&lines);
    if (!g->present)
        *g = (grain_model){0};
    return good;
}

/* ---- a tooth that the lines themselves do not show ---- */

/* How much of a pixel's darkness is the other grain's quantile: where little is expected and where the line is full; beyond
 * that it falls to half. Chosen by eye. */
#define BORROWED_FLANK 0.9
#define BORROWED_FULL 0.55
#define FLANK_LEVEL 0.4
#define MAX_LEVEL 1.4

static double borrowed_at(double level)
{
    double at = clamp((level - FLANK_LEVEL) / (1 - FLANK_LEVEL), 0, 1), over = clamp((level - 1) / (MAX_LEVEL - 1), 0, 1);
    return (BORROWED_FLANK + (BORROWED_FULL - BORROWED_FLANK) * at) * (1 - over / 2);
}

void plb_grain_borrow(grain_model *g, const grain_model *from)
{
    if (!g->present || !from->present)
        return;
    for (int i = 0; i < GRAIN_LEVELS; i++) {
        float share = (float)borrowed_at(plb_grain_levels[i]);
        for (int k = 0; k < GRAIN_SCORES; k++)
            g->darkness[i][k] += share * (from->darkness[i][k] - g->darkness[i][k]);
    }
    memcpy(g->filter, from->filter, sizeof g->filter);
    memcpy(g->place_along, from->place_along, sizeof g->place_along);
    memcpy(g->place_across, from->place_across, sizeof g->place_across);
    g->chain_high = from->chain_high;
    g->chain_low = from->chain_low;
    g->chain_share = from->chain_share;
    g->chain_correlation = from->chain_correlation;
    g->line_mean[3] = from->line_mean[3]; /* correlations along and across, about which a line's own vary */
    g->line_mean[4] = from->line_mean[4];
}
