/* SPDX-License-Identifier: MIT
 *
 * Reduction: how far neighbouring lines lie from each other. Samples are put along the lines, a pencil's width apart, and into
 * a grid; each looks for the nearest line beside it that runs the same way. Lines between two others at even distances
 * are hatching, which is a tone, however dense. Of a drawing with very much line the squares of a chessboard with gaps are looked
 * at: enough for a share.
 */
#include "plan/reduction/needs.h"

#include "base/number/random.h"
#include "plan/reduction/reduction.h"
#include "plan/shape/grid.h"

#include <math.h>

/* Neighbours must lie so many pencil widths apart … */
#define APART_WIDTHS 2.0
/* … but for this share of all lines' length. */
#define CLOSER 0.05
/* Lines closer than this are too close on the largest sheet, too, as where curves approach each other: no reduction helps them. */
#define TOO_CLOSE_WIDTHS (APART_WIDTHS / REDUCTION_MAX)
/* Lines closer than this are one. */
#define SAME_WIDTHS 0.1
/* Gaps to either side are even when they differ by less than this share of their sum (chosen by eye: hatching by hand passes). */
#define EVEN 0.2
/* A line with so many others within reach lies in a texture, which is a tone as well (chosen by eye: walls of two and three lines are none). */
#define MANY 3
/* Lines run side by side when the sine of the angle between them is smaller (6 degrees, chosen by eye: lines that meet at a
 * point, or circles that touch, are no neighbours, contours of a map are). */
#define SAME_WAY 0.1
/* A line of no side longer than this, mm, is a marker, a tick, a piece of a letter or a dash: in clouds they lie anyhow. */
#define SHORT_MM 3.0
#define SHORT_SHARE 0.15 /* of the page's longer side, where that is less */
/* A line that turns back is its own neighbour from so many widths along it on. */
#define ROUND_WIDTHS 4.0
/* When there is more line than this, mm, a share is looked at, in squares of so many mm; and no more samples than these ask for their
 * neighbours (chosen by measurement: 5 ms, and 50 ms where 400 m of line lie on a decimetre). */
#define ENOUGH_MM 10000.0
#define SQUARE_MM 4.0
#define MAX_ASKED 3000u
/* More line than this, mm, is not looked at at all: such a drawing is at the limit of what is drawn anyway. */
#define MAX_MM 1e7

typedef struct {
    point at, way;       /* mm; unit vector */
    uint32_t line;       /* the number of its subpath */
    float along;         /* mm from that one's start */
    bool counts;         /* it lies in a square that is looked at, not just near one */
} gap_sample;

typedef struct {
    int64_t column, row;
    bool is_looked_at;
} looked_square;

struct line_gaps {
    double width, share; /* of the pencil's line, mm; of the squares, 1: all */
    box page;
    uint32_t lines;
    ARRAY(gap_sample) samples;
    grid cells;
    looked_square last; /* that was asked for */
};

line_gaps *plb_line_gaps_new(const display_list *list, double width, double length)
{
    line_gaps *g = plb_new(1, sizeof *g);
    if (!g)
        return NULL;
    g->width = width;
    g->share = length > MAX_MM ? 0 : length > ENOUGH_MM ? ENOUGH_MM / length : 1;
    g->page = (box){0, 0, list->width, list->height};
    g->last.column = INT64_MIN;
    if (plb_grid_init(&g->cells, APART_WIDTHS * width, (size_t)(fmin(length, ENOUGH_MM) / width)))
        return g;
    plb_free(g);
    return NULL;
}

void plb_line_gaps_free(line_gaps *g)
{
    if (!g)
        return;
    array_free(&g->samples);
    plb_grid_free(&g->cells);
    plb_free(g);
}

/* Tells whether the square at a place is looked at. */
static bool is_looked_at(line_gaps *g, double x, double y)
{
    if (g->share >= 1)
        return true;
    int64_t column = (int64_t)floor(x / SQUARE_MM), row = (int64_t)floor(y / SQUARE_MM);
    /* most samples lie in the square of the one before */
    if (column != g->last.column || row != g->last.row)
        g->last = (looked_square){column, row, (double)(random_mix(random_fold(0, column, row)) >> 11) * 0x1p-53 < g->share};
    return g->last.is_looked_at;
}

/* Tells whether a place lies about so near to the edge of its square that the next square may be within reach. */
static bool is_near_edge(double x, double reach)
{
    double inside = x - SQUARE_MM * floor(x / SQUARE_MM);
    return inside < reach * 1.001 || inside > SQUARE_MM - reach * 1.001;
}

static bool add_sample(line_gaps *g, const gap_sample *from)
{
    gap_sample s = *from;
    double x = s.at.x, y = s.at.y, reach = APART_WIDTHS * g->width;
    if (x < g->page.x0 || y < g->page.y0 || x > g->page.x1 || y > g->page.y1)
        return true;
    s.counts = is_looked_at(g, x, y);
    bool is_near = s.counts || (is_near_edge(x, reach) && (is_looked_at(g, x - reach, y) || is_looked_at(g, x + reach, y))) ||
                   (is_near_edge(y, reach) && (is_looked_at(g, x, y - reach) || is_looked_at(g, x, y + reach)));
    if (!is_near)
        return true;
    return g->samples.n < UINT32_MAX && plb_grid_put(&g->cells, plb_grid_cell(&g->cells, x), plb_grid_cell(&g->cells, y), (uint32_t)g->samples.n) && array_push(&g->samples, s);
}

/* Gives the part of a segment, from 0 to 1, that lies on the page; false when there is none. */
static bool cut_to_page(const box *page, point a, point b, double *from, double *to)
{
    double at[2] = {a.x, a.y}, way[2] = {b.x - a.x, b.y - a.y}, low[2] = {page->x0, page->y0}, high[2] = {page->x1, page->y1};
    *from = 0;
    *to = 1;
    for (int k = 0; k < 2; k++) {
        if (fabs(way[k]) < 1e-12 && (at[k] < low[k] || at[k] > high[k]))
            return false;
        if (fabs(way[k]) < 1e-12)
            continue;
        double s = (low[k] - at[k]) / way[k], t = (high[k] - at[k]) / way[k];
        *from = fmax(*from, fmin(s, t));
        *to = fmin(*to, fmax(s, t));
    }
    return *from <= *to;
}

bool plb_line_gaps_add(line_gaps *g, const subpath *s)
{
    double along = 0, next = 0; /* of the place of the next sample */
    uint32_t line = g->lines++;
    if (g->share <= 0 || plb_box_size(s->bounds) < fmin(SHORT_MM, SHORT_SHARE * plb_box_size(g->page)))
        return true;
    for (size_t i = 1; i < s->n; i++) {
        point a = s->v[i - 1], b = s->v[i];
        double length = plb_point_distance(a, b), from, to;
        if (length > 0 && cut_to_page(&g->page, a, b, &from, &to)) {
            gap_sample at = {.way = point_scale(point_sub(b, a), 1 / length), .line = line};
            next = fmax(next, along + from * length);
            for (; next < along + to * length; next += g->width) {
                at.at = point_mix(a, b, (next - along) / length);
                at.along = (float)next;
                if (!add_sample(g, &at))
                    return false;
            }
        }
        along += length;
    }
    return true;
}

/* A look at what lies beside a sample. */
typedef struct {
    double gap[2];         /* to either side, pencil widths */
    uint32_t beside[MANY]; /* the lines there … */
    int n;                 /* … as far as they are counted */
} side_look;

static void count_line(side_look *l, uint32_t line)
{
    for (int i = 0; i < l->n; i++)
        if (l->beside[i] == line)
            return;
    if (l->n < MANY)
        l->beside[l->n++] = line;
}

/* Narrows the gap to either side of sample `s` by that to the sample `t`. */
static void look_at(const line_gaps *g, const gap_sample *s, const gap_sample *t, side_look *l)
{
    if (t->line == s->line && fabs((double)(t->along - s->along)) < ROUND_WIDTHS * g->width)
        return;
    point d = point_sub(t->at, s->at);
    double off = point_cross(s->way, d) / g->width, ahead = fabs(point_dot(s->way, d));
    if (ahead > 0.75 * g->width || fabs(point_cross(s->way, t->way)) > SAME_WAY || fabs(off) < SAME_WIDTHS)
        return;
    if (fabs(off) < APART_WIDTHS)
        count_line(l, t->line);
    l->gap[off < 0] = fmin(l->gap[off < 0], fabs(off));
}

/* Gives the gap beside a sample as a share of what it must be; 1 where there is enough room, hatching, or no help. */
static double share_of_gap(const line_gaps *g, const gap_sample *s)
{
    side_look l = {.gap = {APART_WIDTHS, APART_WIDTHS}};
    int64_t column = plb_grid_cell(&g->cells, s->at.x), row = plb_grid_cell(&g->cells, s->at.y);
    for (int64_t r = row - 1; r <= row + 1; r++)
        for (int64_t c = column - 1; c <= column + 1; c++)
            for (uint32_t e = plb_grid_first(&g->cells, c, r); e != GRID_END; e = g->cells.entries.v[e].next)
                look_at(g, s, &g->samples.v[g->cells.entries.v[e].value], &l);
    double least = fmin(l.gap[0], l.gap[1]), most = fmax(l.gap[0], l.gap[1]);
    bool is_tone = l.n >= MANY || (most < APART_WIDTHS && most - least < EVEN * (most + least));
    return is_tone || least < TOO_CLOSE_WIDTHS ? 1 : least / APART_WIDTHS;
}

bool plb_line_gaps_need(line_gaps *g, double *need)
{
    ARRAY(double) gaps = {0};
    size_t step = g->samples.n / MAX_ASKED + 1;
    bool ok = array_reserve(&gaps, g->samples.n / step + 1);
    for (size_t i = 0; ok && i < g->samples.n; i += step)
        if (g->samples.v[i].counts)
            gaps.v[gaps.n++] = share_of_gap(g, &g->samples.v[i]);
    double least = ok ? plb_low_quantile(gaps.v, gaps.n, CLOSER) : 0;
    *need = least > 0 ? 1 / least : 0;
    array_free(&gaps);
    return ok;
}
