/* SPDX-License-Identifier: MIT
 *
 * This file makes the graphite model's tables, which a captured grain needs so that drawing is additions and look-ups.
 * Input: profile.grain. Output: grain_tables.
 */
#include "base/array.h"
#include "base/geometry/interpolate.h"
#include "base/number/normal.h"
#include "profile/grain/grain.h"
#include "stroke/pencil.h"

#include <math.h>

/* Computes the quantiles of the normal distribution at the middles of GRAIN_NORMALS equal shares. From one to the next by a step of
 * the second order and one of Newton's. */
static void tabulate_normals(grain_tables *t)
{
    const double share = 1.0 / GRAIN_NORMALS, root = 0.3989422804014327;
    double x = 0, step = share / 2; /* the first quantile is half a share from the median */
    for (int k = GRAIN_NORMALS / 2; k < GRAIN_NORMALS; k++, step = share) {
        double way = step / (root * exp(-x * x / 2));
        x += way + x * way * way / 2;
        x -= (plb_normal_share(x) - (k + 0.5) * share) / (root * exp(-x * x / 2));
        t->normal[k] = (float)x;
        t->normal[GRAIN_NORMALS - 1 - k] = (float)-x;
    }
}

/* The field is normal for one line; over lines of different roughness it is a mixture. Its values become scores of that
 * mixture, so that the captured greys come out in their captured shares. */
#define MIXED 16
#define MAP_STEPS 16 /* of the map, per unit of the field … */
#define MAP_REACH 8  /* … which goes so far */
#define MAP_SIZE (MAP_STEPS * MAP_REACH + 1)

static void map_scores(const grain_model *g, float map[MAP_SIZE])
{
    double sd = sqrt((double)g->line_factor[2][0] * g->line_factor[2][0] + (double)g->line_factor[2][1] * g->line_factor[2][1] +
                     (double)g->line_factor[2][2] * g->line_factor[2][2] + (double)g->volatility * (double)g->volatility);
    double rough[MIXED];
    for (int i = 0; i < MIXED; i++)
        rough[i] = exp(g->line_mean[2] + sd * plb_normal_quantile((i + 0.5) / MIXED));
    for (int k = 0; k < MAP_SIZE; k++) {
        double share = 0;
        for (int i = 0; i < MIXED; i++)
            share += plb_normal_share((double)-k / MAP_STEPS / rough[i]) / MIXED;
        map[k] = (float)-plb_normal_quantile(share);
    }
}

static int8_t to_byte(double v)
{
    return (int8_t)floor((v > 127 ? 127 : v < -127 ? -127 : v) + 0.5);
}

static void tabulate_scores(grain_tables *t, const grain_model *g)
{
    float map[MAP_SIZE];
    map_scores(g, map);
    for (int c = 0; c < ROUGH_CLASSES; c++)
        for (int k = 0; k < 256; k++) {
            double x = (k - 128.0) / FIELD_UNIT, rough = exp((c - ROUGH_CLASSES / 2) * ROUGH_LOG_STEP);
            double score = plb_interpolate(map, MAP_SIZE, 0, 1.0 / MAP_STEPS, fabs(x) * rough);
            t->score_correction[c][k] = to_byte(((x < 0 ? -score : score) - x) * FIELD_UNIT);
        }
}

/* Scores fade into the plain field where the expected darkness falls through these: they were captured on the line. */
#define TAIL_LOW 0.05
#define TAIL_SPAN 0.25
/* The stroke's own grain bears the whole of what depends on the place: the paper has no part in it. */
static double own_part(double both, double of_paper)
{
    return (both - of_paper) / (1 - of_paper);
}

/* The outer rows are those that correlate across least or most, compared with the inner ones. */
static float outermost(const grain_model *g)
{
    float most = 0;
    for (int k = 0; k < GRAIN_PLACES; k++)
        most = fabsf(g->place_across[k]) > fabsf(most) ? g->place_across[k] : most;
    return most;
}

static void tabulate_rows(grain_tables *t, const grain_model *g)
{
    double share = t->paper.share;
    t->outer_across = outermost(g);
    for (int k = 0; k < ROW_PLACES; k++) {
        double place = k * ROW_PLACE_STEP, scale = plb_interpolate(g->place_scale, GRAIN_PLACES, 0.25, 0.5, place);
        double across = plb_interpolate(g->place_across, GRAIN_PLACES, 0.25, 0.5, place);
        t->row_spread[k] = (int16_t)(clamp(sqrt(fmax(own_part(scale * scale, share), 0.05)), 0.1, 1.99) * 16384);
        t->row_along[k] = (float)(plb_interpolate(g->place_along, GRAIN_PLACES, 0.25, 0.5, place) / (1 - share));
        t->row_outer[k] = t->outer_across != 0 ? (int16_t)(clamp(across / (double)t->outer_across, 0, 1) * 32767) : 0;
    }
    t->outer_across /= (float)(1 - share);
}

/* Rows of the table lie less than a step of a level apart at first, and in the end six: where much is expected the grain hides
 * .015 of relative darkness. */
#define ROW_BEND 18.0

static int row_of(int level)
{
    return (int)floor((DARKNESS_ROWS - 1) * log1p(level / ROW_BEND) / log1p(255 / ROW_BEND) + 0.5);
}

static void fill_row(const grain_model *g, double m, uint16_t out[128])
{
    int i = 0;
    while (i + 2 < GRAIN_LEVELS && m >= plb_grain_levels[i + 1])
        i++;
    double w = (m - plb_grain_levels[i]) / (plb_grain_levels[i + 1] - plb_grain_levels[i]);
    w = w > 1 ? 1 : w;
    for (int k = 0; k < 128; k++) {
        double z = (2 * k + 0.5 - 128) / FIELD_UNIT, step = 6.0 / (GRAIN_SCORES - 1);
        double low = plb_interpolate(g->darkness[i], GRAIN_SCORES, -3, step, z);
        double high = plb_interpolate(g->darkness[i + 1], GRAIN_SCORES, -3, step, z);
        double v = (low + w * (high - low)) * GRAIN_RELATIVE_UNIT;
        out[k] = (uint16_t)(v < 0 ? 0 : v > 65535 ? 65535 : floor(v + 0.5));
    }
}
static void tabulate_darkness(grain_tables *t, const grain_model *g)
{
    double sum[DARKNESS_ROWS] = {0}, n[DARKNESS_ROWS] = {0};
    for (int level = 0; level < 256; level++) {
        int row = row_of(level);
        double m = (double)level / GRAIN_LEVEL_UNIT;
        t->at_level[level].row = (uint8_t)row;
        t->at_level[level].share = (uint8_t)(255 * clamp((m - TAIL_LOW) / TAIL_SPAN, 0, 1));
        sum[row] += m;
        n[row]++;
    }
    for (int row = 0; row < DARKNESS_ROWS; row++)
        if (n[row] > 0)
            fill_row(g, sum[row] / n[row], t->darkness[0][row]);
}

/* A coarse pixel is the mean of several fine ones. Their scores have a common part, that of the pixel, and one of their
 * own; what the pixel is to be expected to have, given the common part, is the fine table's mean over the other. So mean and
 * (but for the table's bends) variance are those of the mean of fine pixels. */
#define OWN_PARTS 8     /* values, of equal share, that stand for the distribution of the own part */
#define CORRELATION 0.35 /* of a fine pixel with the next, about, in all pencils */

static double common_part(int pixels)
{
    double along = (1 + 2 * (1 - 1.0 / pixels) * CORRELATION) / pixels; /* of the mean of so many in a row: its variance */
    return along;                                                       /* the root of that of their square's */
}

static void smooth_row(const grain_tables *t, const uint16_t fine[128], double common, uint16_t out[128])
{
    double own[OWN_PARTS];
    for (int j = 0; j < OWN_PARTS; j++)
        own[j] = sqrt(1 - common * common) * (double)t->normal[(2 * j + 1) * GRAIN_NORMALS / (2 * OWN_PARTS)] * (FIELD_UNIT / 2.0);
    for (int k = 0; k < 128; k++) {
        double sum = 0, middle = 63.75 + (k - 63.75) * common;
        for (int j = 0; j < OWN_PARTS; j++) {
            double at = clamp(middle + own[j], 0, 127);
            int i = at < 127 ? (int)at : 126;
            sum += fine[i] + (fine[i + 1] - fine[i]) * (at - i);
        }
        out[k] = (uint16_t)(sum / OWN_PARTS + 0.5);
    }
}

static void tabulate_coarse_darkness(grain_tables *t)
{
    for (int scale = 1; scale < DARKNESS_SCALES; scale++)
        for (int row = 0; row < DARKNESS_ROWS; row++)
            smooth_row(t, t->darkness[0][row], common_part(scale + 1), t->darkness[scale][row]);
}

static int16_t to_short(double v)
{
    return (int16_t)floor((v > 32767 ? 32767 : v < -32767 ? -32767 : v) + 0.5);
}

/* A sum of the section and all modes, each with a coefficient within its bounds, stays within 16 bits: see texture_grain.c. */
#define HIGHEST_ROOT 1.8

/* Beyond the place where the mean section falls below this there is only what strayed into the scans. */
#define STRAY_DARKNESS 0.006f
/* No graphite farther from the centreline than this in any profile, px: scans beyond are paper. */
#define MAX_REACH_PX 7.0

static double reach_of(const grain_model *g)
{
    int k = GRAIN_SECTION;
    while (k > 1 && g->section[k - 1] < STRAY_DARKNESS)
        k--;
    return fmin(k * PROFILE_SECTION_STEP, MAX_REACH_PX);
}

static void tabulate_section(grain_tables *t, const grain_model *g)
{
    t->reach = reach_of(g);
    for (int k = 0; k < GRAIN_MODE_PLACES; k++) {
        double place = fabs((k - GRAIN_MODE_PLACES / 2) * PROFILE_SECTION_STEP);
        bool is_paper = place > t->reach;
        double root = plb_grain_root(g, place), slope = plb_grain_root_slope(root);
        t->root[k] = is_paper ? 0 : to_short(fmin(root, HIGHEST_ROOT) * ROOT_UNIT);
        for (int i = 0; i < GRAIN_MODES; i++)
            t->mode[i][k] = is_paper ? 0 : to_short((double)g->mode[i][k] / slope * 32767);
    }
}

/* A scan that blurs the grain would have blurred the paper's tooth: it has less of a part in it, so that both together correlate
 * as scanned. 1: as sharp as the tooth, or sharper. */
static double sharpness_of(const grain_model *g, const paper *on)
{
    return clamp((1 - (double)g->line_mean[3]) / (1 - on->correlation[1]), 0, 1);
}

bool plb_pencil_tabulate_grain(pencil *p, paper_kind on)
{
    const grain_model *g = &p->profile->grain;
    grain_tables *t = p->grain = plb_new(1, sizeof *t);
    if (!t)
        return false;
    tabulate_normals(t);
    if (!plb_paper_make(&t->paper, on, t->normal))
        return false;
    t->paper.share *= sharpness_of(g, &t->paper);
    tabulate_scores(t, g);
    tabulate_darkness(t, g);
    tabulate_coarse_darkness(t);
    tabulate_section(t, g);
    tabulate_rows(t, g);
    plb_pencil_tabulate_noise(t, g);
    plb_pencil_tabulate_slow(t, g);
    return plb_pencil_tabulate_amplitude(t, g);
}
