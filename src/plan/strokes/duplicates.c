/* SPDX-License-Identifier: MIT
 *
 * Plan, all strokes: doubled lines. Exporters draw shared walls and borders once for each side; a person draws them
 * once. Where a line runs along an earlier one it is left out, as a whole or in part; what is left of it goes on as strokes
 * of their own. Hatching and lettering are left alone.
 */
#include "base/geometry/interpolate.h"
#include "plan/shape/grid.h"
#include "plan/strokes/passes.h"

#include <math.h>
#include <stdlib.h>

/* Lines that cross at a flat angle lie upon each other for a little way: only longer runs are left out (chosen by
 * eye), or such as make up the most of a short stroke. */
#define SHORTEST_RUN_MM 1.0
#define MAX_OF_STROKE 0.9
/* Directions that differ by more than this are no doubles. */
#define MAX_TURN_DEGREES 5.7
/* … of lines as upright as this the one may lead to the right, the other to the left: the sine of twice that. */
#define UPRIGHT 0.2
/* Segments are kept apart on the grid by their direction: in so many parts of half a turn. */
#define DIRECTIONS 8
/* The earlier line must be drawn at least this strongly to stand for the later one. */
#define MIN_PRESSURE 0.8
/* Cells are at least and at most so broad, and between these so many times the mean distance of lines; but so large that
 * the lines are in about so many of them at most. */
#define MIN_CELL_MM 1.0
#define MAX_CELL_MM 3.0
#define CELL_DISTANCES 6.0
#define MAX_CELLS 8e6
/* Looks at neighbours for one segment: where more lines lie upon each other it is a blot anyway. */
#define MAX_DUPLICATE_LOOKS 1024
/* … and for all, some seconds of them: beyond, what lies upon each other stays. */
#define MAX_DUPLICATE_LOOKS_OF_ALL 1e8

typedef struct {
    double from, to; /* arc lengths, mm */
} covered_span;

typedef struct {
    point a, b;
    uint32_t stroke; /* in the list made */
} drawn;

typedef struct {
    stroke_list *made;
    double tolerance, least_cosine, looks;
    grid where;
    ARRAY(drawn) segments; /* of the strokes made, on the grid */
    ARRAY(covered_span) runs;       /* of the stroke at work, that lie upon others */
    ARRAY(point) piece;
} duplicate_finder;

static int compare_runs(const void *a, const void *b)
{
    const covered_span *x = a, *y = b;
    return x->from != y->from ? (x->from > y->from) - (x->from < y->from) : (x->to > y->to) - (x->to < y->to);
}

static bool stands_for(stroke_style earlier, stroke_style later)
{
    return earlier.kind == later.kind && earlier.colour == later.colour && earlier.pressure >= later.pressure * (float)MIN_PRESSURE;
}

/* Computes the part of the segment from a along the unit vector `along`, `length` long, that lies within tolerance of `d`. */
static bool overlap(const duplicate_finder *u, point a, point along, double length, const drawn *d, covered_span *out)
{
    point p = point_sub(d->a, a), q = point_sub(d->b, a);
    double hp = point_cross(along, p), hq = point_cross(along, q), t = u->tolerance;
    if ((hp > t && hq > t) || (hp < -t && hq < -t))
        return false;
    double sp = point_dot(p, along), sq = point_dot(q, along), from = greater(lesser(sp, sq), 0), to = lesser(greater(sp, sq), length);
    if (!(to - from > 1e-9) || fabs(sq - sp) < u->least_cosine * plb_point_distance(d->a, d->b))
        return false;
    double slope = (hq - hp) / (sq - sp); /* where the distance reaches the tolerance the run ends */
    if (fabs(slope) > 1e-12) {
        double s0 = sp + (-t - hp) / slope, s1 = sp + (t - hp) / slope;
        from = fmax(from, fmin(s0, s1));
        to = fmin(to, fmax(s0, s1));
    }
    *out = (covered_span){from, to};
    return to - from > 1e-9;
}

/* Tells how far the middle of a cell lies from a line through a along a unit vector, to the side that is the same for all lines of
 * about that direction, whichever way they are drawn: the mark of the line's entry in that cell. */
static double mark_of(const grid *g, point a, point along, int64_t column, int64_t row)
{
    point middle = {((double)column + 0.5) * g->cell, ((double)row + 0.5) * g->cell};
    double aside = point_cross(along, point_sub(middle, a));
    return along.x < 0 ? -aside : aside;
}

/* Lines of about one direction have marks as far apart as they are at most, and by their turn across half a cell a little more. */
static double most_apart(const duplicate_finder *u)
{
    double turn = 2 * sin(MAX_TURN_DEGREES / 2 * PLB_PI / 180), half_cell = u->where.cell * sqrt(0.5);
    return u->tolerance + turn * half_cell + 1e-5 * u->where.cell; /* and marks are rounded */
}

/* A segment and where it begins: its start, unit direction, length and the stroke's arc length there. */
typedef struct {
    stroke_style like;
    point a, along;
    double length, start;
    int64_t part[2];  /* of the directions that are near enough */
    double apart;     /* how far others' marks may be from its own */
    bool either_way;  /* upright: what is one side of another may be the other of this */
    size_t looks;
} question;

/* A cursor in a cell: the entry to be looked at next, and the asking segment's mark there. The entries of a cell lie all over the memory:
 * several cursors move at once, and each next entry is fetched a round before the cursor needs it. */
#define AT_ONCE 32
typedef struct {
    uint32_t next;
    double mark;
} hash_cursor;

static bool is_apart(const question *q, double own, double mark)
{
    double same = fabs(own - mark), other = q->either_way ? fabs(own + mark) : same;
    return same > q->apart && other > q->apart;
}

static bool add_runs(duplicate_finder *u, const question *q, const uint32_t *found, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const drawn *d = &u->segments.v[found[i]];
        covered_span r;
        if (!overlap(u, q->a, q->along, q->length, d, &r) || !stands_for(u->made->strokes.v[d->stroke].style, q->like))
            continue;
        r = (covered_span){r.from + q->start, r.to + q->start};
        if (!array_push(&u->runs, r))
            return false;
    }
    return true;
}

static bool follow_chains(duplicate_finder *u, question *q, hash_cursor *c, size_t n)
{
    const grid_entry *all = u->where.entries.v;
    while (n > 0 && q->looks < MAX_DUPLICATE_LOOKS) {
        uint32_t found[AT_ONCE];
        size_t kept = 0, some = 0;
        for (size_t i = 0; i < n; i++) {
            const grid_entry *e = &all[c[i].next];
            if (!is_apart(q, c[i].mark, (double)e->mark)) {
                __builtin_prefetch(&u->segments.v[e->value]);
                found[some++] = e->value;
            }
            if (e->next != GRID_END) {
                __builtin_prefetch(&all[e->next]);
                c[kept++] = (hash_cursor){e->next, c[i].mark};
            }
        }
        q->looks += n;
        n = kept;
        if (!add_runs(u, q, found, some))
            return false;
    }
    return true;
}

/* Gives the chains of the walk's next cells, as many as are followed at once. */
static size_t next_chains(const duplicate_finder *u, const question *q, grid_walk *w, hash_cursor out[AT_ONCE])
{
    const uint32_t *head[AT_ONCE];
    double mark[AT_ONCE];
    size_t n = 0, some = 0;
    int64_t column, row;
    while (n + 2 <= AT_ONCE && plb_grid_step(w, &column, &row))
        for (int k = 0; k < (q->part[1] == q->part[0] ? 1 : 2); k++) {
            head[n] = plb_grid_head(&u->where, column, row * DIRECTIONS + q->part[k]);
            __builtin_prefetch(head[n]);
            mark[n++] = mark_of(&u->where, q->a, q->along, column, row);
        }
    for (size_t i = 0; i < n; i++)
        if (*head[i] != GRID_END) {
            __builtin_prefetch(&u->where.entries.v[*head[i]]);
            out[some++] = (hash_cursor){*head[i], mark[i]};
        }
    return n ? some : SIZE_MAX;
}

/* Collects the runs that earlier segments make. */
static bool find_runs(duplicate_finder *u, stroke_style like, point a, point b, double start)
{
    double length = plb_point_distance(a, b);
    question q = {.like = like, .a = a, .along = point_scale(point_sub(b, a), 1 / length), .length = length, .start = start};
    double turn = plb_grid_turn(q.along), most = MAX_TURN_DEGREES / 180;
    q.part[0] = plb_grid_part(turn - most, DIRECTIONS);
    q.part[1] = plb_grid_part(turn + most, DIRECTIONS);
    q.apart = most_apart(u);
    q.either_way = fabs(q.along.x) < UPRIGHT;
    grid_walk w = plb_grid_walk(&u->where, a, b, u->tolerance);
    hash_cursor c[AT_ONCE];
    if (u->looks > MAX_DUPLICATE_LOOKS_OF_ALL)
        return true;
    for (size_t n; q.looks < MAX_DUPLICATE_LOOKS && (n = next_chains(u, &q, &w, c)) != SIZE_MAX;)
        if (!follow_chains(u, &q, c, n))
            return false;
    u->looks += (double)q.looks + 4;
    return true;
}

/* Joins the runs that touch and drops those that are too short to matter. */
static void tidy_runs(duplicate_finder *u, double whole)
{
    size_t n = 0;
    covered_span *v = u->runs.v;
    if (u->runs.n)
        qsort(v, u->runs.n, sizeof *v, compare_runs);
    for (size_t i = 0; i < u->runs.n; i++)
        if (n && v[i].from <= v[n - 1].to + u->tolerance)
            v[n - 1].to = fmax(v[n - 1].to, v[i].to);
        else
            v[n++] = v[i];
    u->runs.n = n;
    n = 0;
    for (size_t i = 0; i < u->runs.n; i++)
        if (v[i].to - v[i].from >= fmin(SHORTEST_RUN_MM, MAX_OF_STROKE * whole))
            v[n++] = v[i];
    u->runs.n = n;
}

static bool put_on_grid(duplicate_finder *u, size_t number)
{
    const stroke *s = &u->made->strokes.v[number];
    for (size_t i = 1; i < s->n; i++) {
        drawn d = {u->made->points.v[s->first + i - 1], u->made->points.v[s->first + i], (uint32_t)number};
        grid_walk w = plb_grid_walk(&u->where, d.a, d.b, 0);
        point way = point_sub(d.b, d.a), along = point_scale(way, 1 / plb_point_length(way));
        int64_t column, row, part = plb_grid_part(plb_grid_turn(way), DIRECTIONS);
        if (!array_push(&u->segments, d))
            return false;
        while (plb_grid_step(&w, &column, &row))
            if (!plb_grid_put_marked(&u->where, column, row * DIRECTIONS + part, (uint32_t)(u->segments.n - 1), mark_of(&u->where, d.a, along, column, row)))
                return false;
    }
    return true;
}

/* Makes a stroke of the part between two arc lengths. */
static bool keep_part(duplicate_finder *u, const stroke *s, const point *at, double from, double to)
{
    double done = 0;
    u->piece.n = 0;
    for (size_t i = 1; i < s->n; i++) {
        double length = plb_point_distance(at[i - 1], at[i]), a = fmax(from - done, 0), b = fmin(to - done, length);
        if (a < b) {
            if (u->piece.n == 0 && !array_push(&u->piece, point_mix(at[i - 1], at[i], a / length)))
                return false;
            if (!array_push(&u->piece, b == length ? at[i] : point_mix(at[i - 1], at[i], b / length)))
                return false;
        }
        done += length;
    }
    stroke part = *s;
    part.closed = false;
    part.corner_first = s->corner_first && from <= 0;
    part.corner_last = s->corner_last && to >= done;
    return u->piece.n < 2 || plb_plan_append(u->made, &part, u->piece.v, u->piece.n);
}

/* Adds the stroke, or the parts that the runs leave of it. */
static bool keep(duplicate_finder *u, const stroke *s, const point *at, double whole)
{
    if (u->runs.n == 0)
        return plb_plan_append(u->made, s, at, s->n);
    double from = 0;
    bool ok = true;
    for (size_t i = 0; ok && i <= u->runs.n; i++) {
        double to = i < u->runs.n ? u->runs.v[i].from : whole;
        if (to - from > 2 * u->tolerance)
            ok = keep_part(u, s, at, from, to);
        from = i < u->runs.n ? u->runs.v[i].to : whole;
    }
    return ok;
}

static bool drop_duplicates(duplicate_finder *u, const stroke *s, const point *at)
{
    double whole = 0;
    size_t before = u->made->strokes.n;
    if (s->style.kind == STROKE_HATCH) /* lies close to others on purpose */
        return plb_plan_append(u->made, s, at, s->n);
    u->runs.n = 0;
    bool ok = true, is_line = s->style.kind == STROKE_LINE || s->style.kind == STROKE_GUIDE;
    if (!is_line)
        return plb_plan_append(u->made, s, at, s->n);
    for (size_t i = 1; ok && i < s->n; i++) {
        ok = find_runs(u, s->style, at[i - 1], at[i], whole);
        whole += plb_point_distance(at[i - 1], at[i]);
    }
    tidy_runs(u, whole);
    ok = ok && keep(u, s, at, whole);
    for (size_t i = before; ok && i < u->made->strokes.n; i++)
        ok = put_on_grid(u, i);
    return ok;
}

static double length_of_all(const stroke_list *list)
{
    double sum = 0;
    for (size_t i = 0; i < list->strokes.n; i++)
        sum += plb_stroke_length(list, &list->strokes.v[i]);
    return sum;
}

static double cell_for(const stroke_list *list, double whole)
{
    double distance = list->width * list->height / fmax(whole, 1);
    return fmax(clamp(CELL_DISTANCES * distance, MIN_CELL_MM, MAX_CELL_MM), whole / MAX_CELLS);
}

bool plb_plan_duplicates(stroke_list *list, double tolerance, error *err)
{
    stroke_list made = {.width = list->width, .height = list->height};
    duplicate_finder u = {.made = &made, .tolerance = tolerance, .least_cosine = cos(MAX_TURN_DEGREES * PLB_PI / 180)};
    double whole = length_of_all(list), cell = cell_for(list, whole);
    bool ok = plb_grid_init(&u.where, cell, list->points.n + (size_t)(whole / cell));
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = drop_duplicates(&u, &list->strokes.v[i], list->points.v + list->strokes.v[i].first);
    plb_grid_free(&u.where);
    array_free(&u.segments);
    array_free(&u.runs);
    array_free(&u.piece);
    plb_plan_replace(list, &made);
    return ok || plb_fail_memory(err);
}
