/* SPDX-License-Identifier: MIT
 *
 * Groups of cells: see cells.h. Two fills adjoin when they share corners. Fills that do are joined into groups (union-find); a group
 * of few tones is a chart, whose parts are told apart by other means.
 */
#include "plan/tone/cells.h"

#include "base/geometry/interpolate.h"
#include "plan/hatch/hatch_sections.h"
#include "plan/item/weight.h"
#include "plan/shape/flatten.h"
#include "plan/shape/grid.h"

#include <math.h>
#include <stdlib.h>

/* Corners no farther apart are one, mm: drawings are written with two or three decimals. */
#define SAME_CORNER_MM 0.06
/* A cell shares so many corners with others. */
#define SHARED_CORNERS 1
/* A group has at least so many cells and paints, and half of its cells are no broader (twice the area over the perimeter) than so many
 * mm: squares of 6 mm (chosen by eye: a pie of eight slices is none, a colour bar is one). */
#define LEAST_CELLS 8
#define LEAST_PAINTS 8
#define BROADEST_MM 3.0
/* More corners are not looked at. */
#define MAX_CORNERS 4000000u
/* A field has at most so many squares, of at least this side, mm; so many to the breadth of a narrow cell. */
#define MAX_SQUARES 1000000.0
#define LEAST_SQUARE_MM 0.05
#define SQUARES_PER_CELL 4.0
/* Breadths are sorted to find the one that this part of the cells does not reach: the finest of the group. */
#define FINE_PART 0.1
/* A pencil is as broad as small cells are: its lines run over into the neighbours, which takes contrast from all of them. So each square differs from
 * the mean within SHARPEN_MM by more, by the factor SHARPEN / breadth - SHARPEN_FROM (chosen by measurement on squares of .6 and 1 mm of random greys). */
#define SHARPEN_MM 0.55
#define SHARPEN 0.2
#define SHARPEN_FROM 0.2

typedef struct {
    size_t item;
    double breadth; /* mm */
    uint32_t shared; /* corners */
    uint32_t parent; /* union-find */
} cell;

typedef struct {
    point at;
    uint32_t cell;
} corner;

typedef struct {
    size_t first, n; /* of the cells in `members` */
    size_t end, last; /* items: of all cells, of those that are seen */
    double finest;
    box bounds;
    int clip;        /* of the hatching: each cell is kept in the box of its own */
} cell_group;

struct cell_groups {
    const display_list *list;
    const occluders *occluders;
    uint32_t *of_item; /* one more than the group's number */
    ARRAY(cell_group) groups;
    ARRAY(size_t) members; /* items, group by group, in painting order */
};

typedef struct {
    const display_list *list;
    ARRAY(cell) cells;
    ARRAY(corner) corners;
    grid where;
} search;

/* ---- which fills adjoin ---- */

static bool is_plain(const item *it)
{
    return it->kind == ITEM_FILL && it->paint.kind == PAINT_SOLID && it->paint.alpha > 0.95 && it->path.ops.n > 2;
}

static uint32_t find_root(search *s, uint32_t k)
{
    cell *c = s->cells.v;
    while (c[k].parent != k)
        k = c[k].parent = c[c[k].parent].parent;
    return k;
}

/* Joins the cell with those that have a corner here, and puts its own corner down. */
static bool add_corner(search *s, uint32_t k, point at)
{
    int64_t column = plb_grid_cell(&s->where, at.x), row = plb_grid_cell(&s->where, at.y);
    bool is_shared = false, is_there = false;
    for (int64_t y = row - 1; y <= row + 1; y++)
        for (int64_t x = column - 1; x <= column + 1; x++)
            for (uint32_t e = plb_grid_first(&s->where, x, y); e != GRID_END; e = s->where.entries.v[e].next) {
                const corner *c = &s->corners.v[s->where.entries.v[e].value];
                if (fabs(c->at.x - at.x) > SAME_CORNER_MM || fabs(c->at.y - at.y) > SAME_CORNER_MM)
                    continue;
                if (c->cell == k) {
                    is_there = true;
                    continue;
                }
                is_shared = true;
                s->cells.v[c->cell].shared++;
                s->cells.v[find_root(s, c->cell)].parent = find_root(s, k);
            }
    s->cells.v[k].shared += is_shared;
    if (is_there)
        return true;
    /* Where many meet the first four know of each other, which is enough to join them. */
    return array_push(&s->corners, ((corner){at, k})) && plb_grid_put(&s->where, column, row, (uint32_t)(s->corners.n - 1));
}

static bool add_corners(search *s, uint32_t k, const path *p)
{
    const point *at = p->points.v;
    bool ok = true;
    for (size_t i = 0; ok && i < p->ops.n; i++) {
        int n = p->ops.v[i] == PATH_CURVE ? 3 : p->ops.v[i] != PATH_CLOSE;
        at += n;
        ok = !n || add_corner(s, k, at[-1]);
    }
    return ok;
}

static bool collect(search *s)
{
    const display_list *list = s->list;
    size_t corners = 0;
    for (size_t i = 0; i < list->items.n; i++)
        if (is_plain(&list->items.v[i])) {
            cell c = {.item = i, .breadth = plb_fill_breadth(&list->items.v[i].path), .parent = (uint32_t)s->cells.n};
            corners += list->items.v[i].path.points.n;
            if (!array_push(&s->cells, c))
                return false;
        }
    if (s->cells.n < LEAST_CELLS || corners > MAX_CORNERS)
        return true;
    bool ok = plb_grid_init(&s->where, SAME_CORNER_MM, corners);
    for (size_t k = 0; ok && k < s->cells.n; k++)
        ok = add_corners(s, (uint32_t)k, &list->items.v[s->cells.v[k].item].path);
    return ok;
}

/* ---- which groups count ---- */

static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool is_same_colour(const paint *a, const paint *b)
{
    return a->red == b->red && a->green == b->green && a->blue == b->blue;
}

/* Paints that were seen, up to as many as a group needs. */
typedef struct {
    const paint *seen[LEAST_PAINTS];
    int n;
} palette;

static void see(palette *all, const paint *p)
{
    int same = 0;
    while (same < all->n && !is_same_colour(all->seen[same], p))
        same++;
    if (same == all->n && all->n < LEAST_PAINTS)
        all->seen[all->n++] = p;
}

static bool has_many_paints(const cell_groups *g, const cell_group *c)
{
    palette all = {.n = 0};
    for (size_t k = 0; k < c->n && all.n < LEAST_PAINTS; k++)
        see(&all, &g->list->items.v[g->members.v[c->first + k]].paint);
    return all.n == LEAST_PAINTS;
}

bool plb_cells_may_be(const display_list *list)
{
    palette all = {.n = 0};
    for (size_t i = 0; i < list->items.n && all.n < LEAST_PAINTS; i++)
        if (is_plain(&list->items.v[i]))
            see(&all, &list->items.v[i].paint);
    return all.n == LEAST_PAINTS;
}

static bool meets(box a, box b) { return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1; }

/* Tells whether a large fill was painted between the cells and upon them. */
static bool is_interrupted(const cell_groups *g, const cell_group *c, const uint32_t *root_of, uint32_t root)
{
    for (size_t i = g->members.v[c->first]; i < c->end; i++) {
        const item *it = &g->list->items.v[i];
        box b = plb_path_bounds(&it->path);
        if (it->kind == ITEM_FILL && root_of[i] != root && fmin(b.x1 - b.x0, b.y1 - b.y0) > BROADEST_MM && meets(b, c->bounds))
            return true;
    }
    return false;
}

static int clip_of(const cell_groups *g, const cell_group *c, size_t k) { return g->list->items.v[g->members.v[c->first + k]].clip; }

/* Gives the clip that more than half of the cells have (Boyer & Moore's vote), or none. */
static int usual_clip(const cell_groups *g, const cell_group *c)
{
    int usual = NO_CLIP;
    size_t votes = 0, have = 0;
    for (size_t k = 0; k < c->n; k++) {
        int other = clip_of(g, c, k);
        usual = votes ? usual : other;
        votes = votes == 0 || usual == other ? votes + 1 : votes - 1;
    }
    for (size_t k = 0; k < c->n; k++)
        have += clip_of(g, c, k) == usual;
    return 2 * have > c->n ? usual : NO_CLIP;
}

/* Finds bounds, breadth, ends and clip. */
static bool measure(cell_groups *g, cell_group *c, const search *s, const uint32_t *cell_of)
{
    double *breadths = plb_new(c->n, sizeof *breadths);
    if (!breadths)
        return false;
    c->clip = usual_clip(g, c);
    c->bounds = BOX_EMPTY;
    c->last = SIZE_MAX;
    for (size_t k = 0; k < c->n; k++) {
        size_t i = g->members.v[c->first + k];
        box b = plb_path_bounds(&g->list->items.v[i].path);
        breadths[k] = s->cells.v[cell_of[i] - 1].breadth;
        plb_box_add(&c->bounds, (point){b.x0, b.y0});
        plb_box_add(&c->bounds, (point){b.x1, b.y1});
        c->end = i;
        if (plb_leaves_mark(&g->list->items.v[i]) && !plb_occluders_hide_item(g->occluders, i))
            c->last = i;
    }
    qsort(breadths, c->n, sizeof *breadths, compare_numbers);
    c->finest = breadths[c->n / 2] <= BROADEST_MM ? breadths[(size_t)(FINE_PART * (double)c->n)] : 0;
    plb_free(breadths);
    return true;
}

/* Takes the group of the cells of one root, which are the last members; members that come to nothing are taken out again. */
static bool close_group(cell_groups *g, search *s, const uint32_t *cell_of, const uint32_t *root_of, uint32_t root, size_t first)
{
    cell_group c = {.first = first, .n = g->members.n - first};
    if (c.n >= LEAST_CELLS && !measure(g, &c, s, cell_of))
        return false;
    if (c.n < LEAST_CELLS || !(c.finest > 0) || !has_many_paints(g, &c) || is_interrupted(g, &c, root_of, root)) {
        g->members.n = first;
        return true;
    }
    for (size_t k = 0; k < c.n; k++)
        g->of_item[g->members.v[first + k]] = (uint32_t)g->groups.n + 1;
    return array_push(&g->groups, c);
}

typedef struct {
    uint32_t root;
    size_t item;
} membership;

static int compare_memberships(const void *a, const void *b)
{
    const membership *x = a, *y = b;
    return x->root != y->root ? (x->root < y->root ? -1 : 1) : (x->item > y->item) - (x->item < y->item);
}

/* Sorts the cells by their group, then by painting order. */
static bool make_groups(cell_groups *g, search *s)
{
    size_t n = 0;
    uint32_t *cell_of = plb_new(g->list->items.n, sizeof *cell_of), *root_of = plb_new(g->list->items.n, sizeof *root_of);
    membership *all = plb_new(s->cells.n, sizeof *all);
    bool ok = cell_of && root_of && all && array_reserve(&g->members, s->cells.n);
    for (uint32_t k = 0; ok && k < s->cells.n; k++) {
        const cell *c = &s->cells.v[k];
        if (c->shared < SHARED_CORNERS)
            continue;
        cell_of[c->item] = k + 1;
        root_of[c->item] = find_root(s, k) + 1;
        all[n++] = (membership){root_of[c->item], c->item};
    }
    if (ok && n)
        qsort(all, n, sizeof *all, compare_memberships);
    for (size_t k = 0, first = 0; ok && k < n; k++) {
        g->members.v[g->members.n++] = all[k].item;
        if (k + 1 < n && all[k + 1].root == all[k].root)
            continue;
        ok = close_group(g, s, cell_of, root_of, all[k].root, first);
        first = g->members.n;
    }
    plb_free(cell_of);
    plb_free(root_of);
    plb_free(all);
    return ok;
}

cell_groups *plb_cells_new(const display_list *list, const occluders *o, error *err)
{
    search s = {.list = list};
    cell_groups *g = plb_new(1, sizeof *g);
    bool ok = g;
    if (ok) {
        g->list = list;
        g->occluders = o;
        g->of_item = plb_new(list->items.n, sizeof *g->of_item);
        ok = g->of_item && (!plb_cells_may_be(list) || (collect(&s) && make_groups(g, &s)));
    }
    array_free(&s.cells);
    array_free(&s.corners);
    plb_grid_free(&s.where);
    if (ok)
        return g;
    plb_cells_free(g);
    plb_fail_memory(err);
    return NULL;
}

void plb_cells_free(cell_groups *g)
{
    if (!g)
        return;
    plb_free(g->of_item);
    array_free(&g->groups);
    array_free(&g->members);
    plb_free(g);
}

uint32_t plb_cells_group(const cell_groups *g, size_t i) { return g->of_item[i]; }
bool plb_cells_is_last(const cell_groups *g, size_t i) { return g->of_item[i] && g->groups.v[g->of_item[i] - 1].last == i; }

int plb_cells_clip(const cell_groups *g, size_t i) { return g->groups.v[g->of_item[i] - 1].clip; }

/* ---- the field ---- */

static int square_of(double at, double from, double square, int n)
{
    double k = ceil((at - from) / square - .5);
    return k <= 0 ? 0 : k >= n ? n : (int)k;
}

/* Gives the box that the cell and its clips leave. */
static box seen_box(const display_list *list, const item *it)
{
    box b = plb_path_bounds(&it->path);
    for (int k = it->clip; k != NO_CLIP; k = list->clips.v[k].parent) {
        box c = plb_path_bounds(&list->clips.v[k].path);
        b = (box){fmax(b.x0, c.x0), fmax(b.y0, c.y0), fmin(b.x1, c.x1), fmin(b.y1, c.y1)};
    }
    return b;
}

/* Paints the squares whose middles lie in the shape and in the box of its clips. */
static bool paint_cell(tone_field *f, const display_list *list, const item *it, error *err)
{
    track_list lines = {0};
    shape_edges edges = {0};
    sections k = {0};
    bool ok = plb_plan_flatten(&it->path, true, &lines, err);
    for (size_t t = 0; ok && t < lines.tracks.n; t++) {
        track line = plb_track_at(&lines, t);
        for (size_t i = 0; ok && i < line.n; i++)
            ok = array_push(&edges, ((shape_edge){line.v[i].at, line.v[(i + 1) % line.n].at})) || plb_fail_memory(err);
    }
    box b = seen_box(list, it);
    int left = square_of(b.x0, f->bounds.x0, f->square, f->columns), right = square_of(b.x1, f->bounds.x0, f->square, f->columns);
    ok = ok && plb_sections_init(&k, &edges, it->even_odd, plb_frame(0), 0, err);
    float darkness = (float)(1 - plb_paint_lightness(it->paint));
    int row = square_of(b.y0, f->bounds.y0, f->square, f->rows), last = square_of(b.y1, f->bounds.y0, f->square, f->rows);
    for (; ok && row < last; row++) {
        ok = plb_sections_at(&k, f->bounds.y0 + (row + .5) * f->square, 0, err);
        for (size_t i = 0; ok && i < k.spans.n; i++)
            for (int x = (int)fmax(left, square_of(k.spans.v[i].from, f->bounds.x0, f->square, f->columns)); x < right && x < square_of(k.spans.v[i].to, f->bounds.x0, f->square, f->columns); x++)
                f->darkness[(size_t)row * (size_t)f->columns + (size_t)x] = darkness;
    }
    plb_sections_free(&k);
    array_free(&edges);
    plb_tracks_free(&lines);
    return ok;
}

/* Averages along lines of n squares that lie `step` apart, `lines` of them `next` apart, over `reach` squares to either side. */
static void average(const float *from, float *to, int n, size_t step, int lines, size_t next, int reach)
{
    for (int l = 0; l < lines; l++) {
        const float *v = from + (size_t)l * next;
        double sum = 0;
        for (int k = 0; k < reach && k < n; k++)
            sum += (double)v[(size_t)k * step];
        for (int k = 0; k < n; k++) {
            int first = k > reach ? k - reach : 0, last = k + reach < n ? k + reach : n - 1;
            if (k + reach < n)
                sum += (double)v[(size_t)last * step];
            if (k > reach)
                sum -= (double)v[(size_t)(first - 1) * step];
            to[(size_t)l * next + (size_t)k * step] = (float)(sum / (last - first + 1));
        }
    }
}

/* Gives small cells back the contrast that the breadth of the pencil will take. */
static bool sharpen(tone_field *f)
{
    double by = SHARPEN / f->finest - SHARPEN_FROM;
    size_t n = (size_t)f->columns * (size_t)f->rows, columns = (size_t)f->columns;
    int reach = (int)(SHARPEN_MM / f->square + .5);
    if (by <= 0)
        return true;
    float *rows = plb_new(n, sizeof *rows), *mean = plb_new(n, sizeof *mean);
    if (rows && mean) {
        average(f->darkness, rows, f->columns, 1, f->rows, columns, reach);
        average(rows, mean, f->rows, columns, f->columns, 1, reach);
        for (size_t k = 0; k < n; k++)
            f->darkness[k] = (float)clamp((double)f->darkness[k] + by * (double)(f->darkness[k] - mean[k]), 0, 1);
    }
    bool ok = rows && mean;
    plb_free(rows);
    plb_free(mean);
    return ok;
}

bool plb_cells_field(const cell_groups *g, uint32_t group, tone_field *f, error *err)
{
    const cell_group *c = &g->groups.v[group - 1];
    box b = {fmax(c->bounds.x0, 0), fmax(c->bounds.y0, 0), fmin(c->bounds.x1, g->list->width), fmin(c->bounds.y1, g->list->height)};
    double w = fmax(b.x1 - b.x0, LEAST_SQUARE_MM), h = fmax(b.y1 - b.y0, LEAST_SQUARE_MM);
    double square = fmax(fmax(c->finest / SQUARES_PER_CELL, LEAST_SQUARE_MM), sqrt(w * h / MAX_SQUARES));
    *f = (tone_field){.bounds = b, .square = square, .columns = (int)ceil(w / square), .rows = (int)ceil(h / square), .finest = c->finest};
    f->darkness = plb_new((size_t)f->columns * (size_t)f->rows, sizeof *f->darkness);
    bool ok = f->darkness || plb_fail_memory(err);
    for (size_t k = 0; ok && k < c->n; k++)
        ok = paint_cell(f, g->list, &g->list->items.v[g->members.v[c->first + k]], err);
    return ok && (sharpen(f) || plb_fail_memory(err));
}

void plb_field_free(tone_field *f)
{
    plb_free(f->darkness);
}

double plb_field_at(const tone_field *f, point at)
{
    double x = floor((at.x - f->bounds.x0) / f->square), y = floor((at.y - f->bounds.y0) / f->square);
    bool is_inside = x >= 0 && y >= 0 && x < f->columns && y < f->rows;
    return is_inside ? (double)f->darkness[(size_t)y * (size_t)f->columns + (size_t)x] : 0;
}
