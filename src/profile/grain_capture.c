/* SPDX-License-Identifier: MIT
 *
 * Capture of the grain: the order of the steps.
 */
#include "profile/grain.h"

#include <math.h>

static bool measure(grain_lines *lines, double width, grain_model *g, error *err)
{
    grain_moments moments;
    plb_grain_section(lines, g);
    if (!plb_grain_modes(lines, g, err))
        return false;
    plb_grain_slow(lines, g);
    if (!plb_grain_darkness(lines, g, err))
        return false;
    plb_grain_scores(lines, g);
    plb_grain_moments(lines, g, &moments);
    plb_grain_chain(&moments, g);
    plb_grain_filter(&moments, g);
    plb_grain_between(lines, &moments, g);
    if (width > 0)
        g->line_mean[1] = (float)log(width);
    plb_grain_clamp(g);
    g->present = plb_grain_is_sound(g);
    return true;
}

bool plb_grain_capture(const line_strip strips[], size_t n, double width, grain_model *g, error *err)
{
    grain_lines lines;
    *g = (grain_model){0};
    if (!plb_grain_lines_make(strips, n, &lines, g, err))
        return false;
    bool good = lines.columns < GRAIN_MIN_COLUMNS || measure(&lines, width, g, err);
    plb_grain_lines_free(&lines);
    if (!g->present)
        *g = (grain_model){0};
    return good;
}
