/* SPDX-License-Identifier: MIT
 *
 * The store of glyphs (glyphs.h) is a hash table of shapes. A shape that no longer has room in it is worked out in a
 * place of its own, where the next such shape follows.
 */
#include "plan/letter/glyphs.h"

#include "base/number/random.h"

#include <math.h>
#include <string.h>

/* The lattice has so many steps along the larger side of a small shape: the copies of a letter differ by less, and a stem of a
 * tenth of that is 13 steps broad (chosen by eye). Of large shapes it is as fine as LATTICE_MM. */
#define LATTICE_STEPS 128
#define LATTICE_MM (1.0 / 128)
/* A stroke is so many pixels across: enough for the axis' place, and for hairlines a third as wide. */
#define PIXELS_PER_STEM 8.0
#define DETAIL_PENCILS 0.12 /* what sticks out less than this is not drawn; chosen by eye */
/* A store has room for so many shapes and points of outlines, 16 MB. */
#define MAX_GLYPHS 16384u
#define MAX_POINTS 500000u
#define HEADS 4096u

struct glyph_store {
    double shade_width;
    ARRAY(glyph) glyphs;
    size_t points;         /* of all outlines */
    uint32_t head[HEADS];  /* by the last bits of the code: the latest glyph, counted from 1 */
    glyph asked;           /* the shape in question */
    glyph homeless;        /* a shape without room in the store */
    raster last;           /* of the glyph that was measured last, */
    uint64_t last_code;    /* which has this code */
};

glyph_store *plb_glyphs_new(double shade_width, error *err)
{
    glyph_store *s = plb_new(1, sizeof *s);
    if (s)
        s->shade_width = shade_width;
    else
        plb_fail_memory(err);
    return s;
}

static void free_glyph(glyph *g)
{
    plb_contour_set_free(&g->outline);
    plb_pen_free(&g->axis);
}

void plb_glyphs_free(glyph_store *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < s->glyphs.n; i++)
        free_glyph(&s->glyphs.v[i]);
    array_free(&s->glyphs);
    free_glyph(&s->asked);
    free_glyph(&s->homeless);
    plb_raster_free(&s->last);
    plb_free(s);
}

/* ---- the shape of a part ---- */

static double on_lattice(double v, double step)
{
    return rint(v / step) * step + 0.0; /* no zero below zero: bits are compared */
}

static double length_of(const contour_set *o)
{
    double length = 0;
    for (size_t k = 0; k < o->starts.n; k++) {
        size_t first = o->starts.v[k], end = k + 1 < o->starts.n ? o->starts.v[k + 1] : o->points.n;
        for (size_t i = first; i < end; i++)
            length += plb_point_distance(o->points.v[i], o->points.v[i + 1 < end ? i + 1 : first]);
    }
    return length;
}

static uint64_t hash(const glyph *g)
{
    const contour_set *o = &g->outline;
    uint64_t h = random_fold(o->even_odd, (int64_t)o->points.n, (int64_t)o->starts.n), bits[2];
    for (size_t i = 0; i < o->points.n; i++) {
        memcpy(bits, &o->points.v[i], sizeof bits);
        h = random_fold(h, (int64_t)bits[0], (int64_t)bits[1]);
    }
    memcpy(bits, &g->area, sizeof *bits);
    return random_fold(h, (int64_t)bits[0], 0);
}

/* Makes the part's shape in s->asked. Steps are powers of two, so that nothing is rounded but to the lattice. */
static bool take_shape(glyph_store *s, const letter_part *part, error *err)
{
    glyph *g = &s->asked;
    contour_set *o = &g->outline;
    const contour_set *from = &part->outline;
    double size = fmax(part->bounds.x1 - part->bounds.x0, part->bounds.y1 - part->bounds.y0);
    double whole = exp2(floor(log2(size))), step = fmin(whole / LATTICE_STEPS, LATTICE_MM);
    o->points.n = o->starts.n = 0;
    o->even_odd = from->even_odd;
    if (!array_reserve(&o->points, from->points.n) || !array_reserve(&o->starts, from->starts.n))
        return plb_fail_memory(err);
    for (size_t i = 0; i < from->points.n; i++) {
        point p = point_sub(from->points.v[i], from->points.v[0]);
        o->points.v[o->points.n++] = (point){on_lattice(p.x, step), on_lattice(p.y, step)};
    }
    memcpy(o->starts.v, from->starts.v, from->starts.n * sizeof *from->starts.v);
    o->starts.n = from->starts.n;
    g->area = on_lattice(part->area, whole * step / 8);
    g->perimeter = length_of(o);
    g->code = hash(g);
    return true;
}

static bool is_same(const glyph *a, const glyph *b)
{
    const contour_set *o = &a->outline, *p = &b->outline;
    return a->code == b->code && a->area == b->area && o->even_odd == p->even_odd && o->points.n == p->points.n && o->starts.n == p->starts.n &&
           !memcmp(o->points.v, p->points.v, o->points.n * sizeof(point)) && !memcmp(o->starts.v, p->starts.v, o->starts.n * sizeof(size_t));
}

/* ---- what is known of a shape ---- */

/* Area counts the pixels: contours that overlap are counted once, holes of any direction left out. */
static bool fill_raster(glyph_store *s, glyph *g, error *err)
{
    raster *r = &s->last;
    plb_raster_free(r);
    g->stem = g->perimeter > 0 ? 2 * g->area / g->perimeter : 0;
    for (int attempt = 0; attempt < 2; attempt++) {
        if (!plb_raster_fill(r, &g->outline, g->stem / PIXELS_PER_STEM, err))
            return false;
        double real = 2 * (double)r->area * r->pixel * r->pixel / g->perimeter;
        bool fits = !r->width || real > 0.7 * g->stem;
        if (fits || attempt)
            break;
        g->stem = real;
        plb_raster_free(r);
    }
    g->is_rastered = r->width > 0;
    g->largest = r->largest * r->pixel;
    s->last_code = g->code;
    return true;
}

/* Gives the place of a new glyph: in the store, or beside it where that is full. NULL and `err` when out of memory. */
static glyph *add(glyph_store *s, error *err)
{
    size_t n = s->asked.outline.points.n;
    glyph *g = &s->homeless, made = s->asked;
    if (s->glyphs.n < MAX_GLYPHS && n <= MAX_POINTS - s->points) {
        uint32_t *head = &s->head[made.code % HEADS];
        made.next = *head;
        if (!array_push(&s->glyphs, made)) {
            plb_fail_memory(err);
            return NULL;
        }
        s->points += n;
        *head = (uint32_t)s->glyphs.n;
        g = &s->glyphs.v[s->glyphs.n - 1];
    } else {
        free_glyph(g);
        *g = made;
    }
    memset(&s->asked, 0, sizeof s->asked); /* the glyph has its arrays */
    return g;
}

const glyph *plb_glyph(glyph_store *s, const letter_part *part, error *err)
{
    if (!take_shape(s, part, err))
        return NULL;
    for (uint32_t i = s->head[s->asked.code % HEADS]; i; i = s->glyphs.v[i - 1].next)
        if (is_same(&s->glyphs.v[i - 1], &s->asked))
            return &s->glyphs.v[i - 1];
    glyph *g = add(s, err);
    return g && fill_raster(s, g, err) ? g : NULL;
}

static bool find_axis(glyph_store *s, glyph *g, error *err)
{
    raster *r = &s->last;
    medial m = {0};
    double stem = g->stem / r->pixel, detail = DETAIL_PENCILS * s->shade_width / r->pixel, nib = NIB_PENCILS * s->shade_width / r->pixel;
    bool ok = plb_medial_thin(r, err) && plb_medial_graph(&m, r, err) && plb_medial_prune(&m, stem, detail, err) &&
              plb_medial_corners(&m, r, err) && plb_medial_strokes(&m, r, nib, &g->axis, err) && plb_pen_smooth(&g->axis, stem, err);
    for (size_t i = 0; ok && i < g->axis.points.n; i++) {
        point *at = &g->axis.points.v[i].at;
        *at = point_add(r->origin, point_scale(*at, r->pixel));
    }
    plb_medial_free(&m);
    return ok;
}

const pen *plb_glyph_axis(glyph_store *s, const glyph *known, error *err)
{
    glyph *g = known == &s->homeless ? &s->homeless : &s->glyphs.v[known - s->glyphs.v];
    if (g->has_axis)
        return &g->axis;
    if ((!s->last.width || s->last_code != g->code) && !fill_raster(s, g, err))
        return NULL;
    g->has_axis = find_axis(s, g, err);
    plb_raster_free(&s->last); /* thinned: of no more use */
    return g->has_axis ? &g->axis : NULL;
}
