/* SPDX-License-Identifier: MIT
 *
 * Runs of lettering: see runs.h. One pass over the list measures each fill roughly (curves as a few chords), and adds it to the
 * run of the fill before where the two are neighbours.
 */
#include "plan/letter/runs.h"

#include <math.h>
#include <stdlib.h>

/* Neighbours are at most so far apart, in sizes of the larger one, and one is at least such a part of the other (chosen by eye: a
 * space is .3, a stop .12). */
#define NEAR_SIZES 0.8
#define LIKE_SIZE 0.08
/* Stems of neighbours differ by no more than this factor, unless one is a dot, a comma or a dash: of so few contours, and smaller than such a part of the other. */
#define LIKE_STEM 1.5
#define SMALL_SIZE 0.4
#define SMALL_CONTOURS 2
/* Larger fills, mm, or fills of more points are no single letters; a page of text in one fill is measured all the same. */
#define LARGEST_MM 60.0
#define MAX_POINTS 100000u
/* A curve is measured as so many chords: its length is right to 2 %. */
#define CHORDS 4
/* The size that is not passed by this share of the outer contours, dots among them, is that of most letters. */
#define SIZE_SHARE 0.75
/* Stem to size: above, a run is bold. Words, capitals and digits of twelve families: regular .08 to .123 (words without tall letters to .141), bold
 * .130 to .205, most of them above .15. */
#define BOLD 0.148
/* A run of fewer contours is not bold: bars and arrows are as thick as bold letters. */
#define BOLD_CONTOURS 3

struct letter_runs {
    ARRAY(letter_run) runs;
    ARRAY(uint32_t) of; /* each item: its run, counted from 1; 0: none */
};

typedef struct {
    box bounds;
    double area, perimeter;
    double size; /* of the largest contour: its longer side */
    unsigned contours;
} measure;

/* The run that grows. */
typedef struct {
    letter_runs *out;
    const item *last; /* its last fill */
    measure at;       /* of that */
    double area, perimeter;
    size_t fills;
    ARRAY(double) sizes; /* of all contours; of holes below 0 once a fill is done */
} run_maker;

static double size_of(box b)
{
    return fmax(b.x1 - b.x0, b.y1 - b.y0);
}

static double stem_of(const measure *m)
{
    return m->perimeter > 0 ? 2 * m->area / m->perimeter : 0;
}

/* ---- one fill ---- */

static void add_chord(measure *m, point from, point to)
{
    m->area += point_cross(from, to) / 2;
    m->perimeter += plb_point_distance(from, to);
    plb_box_add(&m->bounds, to);
}

static point curve_at(point from, const point *c, double t)
{
    double u = 1 - t;
    double a = u * u * u, b = 3 * u * u * t, d = 3 * u * t * t, e = t * t * t;
    return (point){a * from.x + b * c[0].x + d * c[1].x + e * c[2].x, a * from.y + b * c[0].y + d * c[1].y + e * c[2].y};
}

/* Adds the contour `c`, which is closed by a chord, to the fill's measure. */
static bool end_contour(run_maker *k, measure *fill, measure *c, point at, point first)
{
    if (plb_box_is_empty(c->bounds))
        return true;
    add_chord(c, at, first);
    fill->area += c->area;
    fill->perimeter += c->perimeter;
    plb_box_add(&fill->bounds, (point){c->bounds.x0, c->bounds.y0});
    plb_box_add(&fill->bounds, (point){c->bounds.x1, c->bounds.y1});
    double size = size_of(c->bounds), marked = c->area < 0 ? -size : size;
    fill->size = fmax(fill->size, size);
    fill->contours++;
    return array_push(&k->sizes, marked);
}

/* Measures a fill from its first point on, so that areas keep their digits far from the page's corner. */
static bool measure_fill(run_maker *k, const path *p, measure *fill)
{
    const point *v = p->points.v;
    point origin = p->points.n ? v[0] : (point){0, 0}, at = {0, 0}, first = at;
    measure c = {.bounds = BOX_EMPTY};
    size_t before = k->sizes.n;
    bool ok = true;
    *fill = c;
    for (size_t i = 0; ok && i < p->ops.n; i++) {
        switch ((path_op)p->ops.v[i]) {
        case PATH_MOVE:
            ok = end_contour(k, fill, &c, at, first);
            c = (measure){.bounds = BOX_EMPTY};
            first = at = point_sub(*v++, origin);
            break;
        case PATH_LINE: {
            point to = point_sub(*v++, origin);
            add_chord(&c, at, to);
            at = to;
            break;
        }
        case PATH_CURVE: {
            point by[3] = {point_sub(v[0], origin), point_sub(v[1], origin), point_sub(v[2], origin)}, from = at;
            for (int n = 1; n <= CHORDS; n++) {
                point to = curve_at(from, by, (double)n / CHORDS);
                add_chord(&c, at, to);
                at = to;
            }
            v += 3;
            break;
        }
        case PATH_CLOSE:
            break;
        }
    }
    ok = ok && end_contour(k, fill, &c, at, first);
    fill->bounds = (box){fill->bounds.x0 + origin.x, fill->bounds.y0 + origin.y, fill->bounds.x1 + origin.x, fill->bounds.y1 + origin.y};
    if (fill->area < 0)
        for (size_t i = before; i < k->sizes.n; i++)
            k->sizes.v[i] = -k->sizes.v[i];
    fill->area = fabs(fill->area);
    return ok;
}

/* ---- runs ---- */

static bool is_like(paint a, paint b)
{
    return a.kind == b.kind && a.red == b.red && a.green == b.green && a.blue == b.blue && a.alpha == b.alpha;
}

static bool goes_on(const run_maker *k, const item *it, const measure *m)
{
    if (!k->fills || !is_like(k->last->paint, it->paint))
        return false;
    box a = k->at.bounds, b = m->bounds;
    double p = k->at.size, q = m->size, larger = fmax(p, q);
    double apart = fmax(fmax(b.x0 - a.x1, a.x0 - b.x1), fmax(b.y0 - a.y1, a.y0 - b.y1));
    double s = stem_of(&k->at), t = stem_of(m);
    unsigned of_smaller = p < q ? k->at.contours : m->contours;
    bool is_like_stem = fmax(s, t) <= LIKE_STEM * fmin(s, t) || (fmin(p, q) < SMALL_SIZE * larger && of_smaller <= SMALL_CONTOURS);
    return larger <= LARGEST_MM && fmin(p, q) >= LIKE_SIZE * larger && apart <= NEAR_SIZES * larger && is_like_stem;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Writes the run's figures down; its contours from number `n` on are the next run's. */
static void end_run(run_maker *k, size_t n)
{
    if (k->fills && n) {
        letter_run *r = &k->out->runs.v[k->out->runs.n - 1];
        r->fills = k->fills;
        r->stem = k->perimeter > 0 ? 2 * k->area / k->perimeter : 0;
        qsort(k->sizes.v, n, sizeof *k->sizes.v, compare);
        size_t holes = 0;
        while (holes < n && k->sizes.v[holes] < 0)
            holes++;
        r->size = holes < n ? k->sizes.v[holes + (size_t)(SIZE_SHARE * (double)(n - holes - 1))] : 0;
        r->is_bold = n - holes >= BOLD_CONTOURS && r->stem > BOLD * r->size;
    }
    for (size_t i = n; i < k->sizes.n; i++)
        k->sizes.v[i - n] = k->sizes.v[i];
    k->sizes.n -= n;
    k->area = k->perimeter = 0;
    k->fills = 0;
}

static bool add_fill(run_maker *k, const item *it, uint32_t *of)
{
    size_t before = k->sizes.n;
    measure m;
    letter_run none = {0};
    if (it->path.points.n > MAX_POINTS) {
        end_run(k, k->sizes.n);
        return true;
    }
    if (!measure_fill(k, &it->path, &m))
        return false;
    if (!goes_on(k, it, &m)) {
        end_run(k, before);
        if (!array_push(&k->out->runs, none))
            return false;
    }
    k->last = it;
    k->at = m;
    k->area += m.area;
    k->perimeter += m.perimeter;
    k->fills++;
    *of = (uint32_t)k->out->runs.n;
    return true;
}

letter_runs *plb_letter_runs_new(const display_list *list, error *err)
{
    letter_runs *r = plb_new(1, sizeof *r);
    run_maker k = {.out = r};
    bool ok = r && array_reserve(&r->of, list->items.n);
    for (size_t i = 0; ok && i < list->items.n; i++) {
        uint32_t of = 0;
        ok = list->items.v[i].kind != ITEM_FILL || add_fill(&k, &list->items.v[i], &of);
        if (ok)
            r->of.v[r->of.n++] = of;
    }
    if (ok)
        end_run(&k, k.sizes.n);
    array_free(&k.sizes);
    if (ok)
        return r;
    plb_letter_runs_free(r);
    plb_fail_memory(err);
    return NULL;
}

void plb_letter_runs_free(letter_runs *r)
{
    if (!r)
        return;
    array_free(&r->runs);
    array_free(&r->of);
    plb_free(r);
}

letter_run plb_letter_run_at(const letter_runs *r, size_t i)
{
    return i < r->of.n && r->of.v[i] ? r->runs.v[r->of.v[i] - 1] : (letter_run){0};
}
