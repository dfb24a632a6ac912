/* SPDX-License-Identifier: MIT */
#include "tap/plain/plain_list.h"

#include "base/number/number.h"
#include "tap/common/tap_area.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define LIST_BYTES ((size_t)512 << 20)
#define STEPS 256.0     /* of a unit of cairo's fixed-point numbers */
#define SAME 1e-5       /* cairo takes matrices that differ by less for the same */
#define FINE_DASHES 0.2 /* surface units: cairo makes patterns below 0.1 coarser */

static bool keep(void *closure, const char *data, size_t n)
{
    plain_list *s = closure;
    if (n > LIST_BYTES - s->text.n || !array_reserve(&s->text, n))
        return false;
    memcpy(s->text.v + s->text.n, data, n);
    s->text.n += n;
    return true;
}

/* ---- numbers ------------------------------------------------------------------------------------------------ */

/* Gives the value of a number that cairo has printed into a script: six places; below 0.1 six digits. */
static double as_cairo_prints(double v)
{
    char text[400];
    int places = 6;
    if (fabs(v) < 0.1) {
        snprintf(text, sizeof text, "%.18f", fabs(v));
        places += (int)strspn(text + 2, "0");
    }
    int n = snprintf(text, sizeof text, "%.*f", places < 18 ? places : 18, v);
    plb_parse_number(text, text + n, &v, NULL);
    return v;
}

/* Gives the value of a printed coordinate of so many `steps`. Between .1 and .01 there are seven places; below, eight are exact. */
static double coordinate(int32_t steps)
{
    double v = steps / STEPS, size = fabs(v), places = size >= 0.1 ? 1e6 : size >= 0.01 ? 1e7 : 1e8;
    return rint(v * places) / places;
}

static bool make_path(plain_list *s)
{
    const plain_path *from = &s->path;
    path *to = &s->drawn;
    plb_path_clear(to);
    if (!array_reserve(&to->ops, from->n_ops) || !array_reserve(&to->points, from->n_points))
        return false;
    memcpy(to->ops.v, from->ops, from->n_ops);
    for (size_t i = 0; i < from->n_points; i++)
        to->points.v[i] = (point){coordinate(from->points[i].x), coordinate(from->points[i].y)};
    to->ops.n = from->n_ops;
    to->points.n = from->n_points;
    return true;
}

static paint colour(const plain_list *s, const plain_paint *p)
{
    return (paint){PAINT_SOLID, s->shares[p->red], s->shares[p->green], s->shares[p->blue], s->shares[p->alpha]};
}

/* ---- the pen ------------------------------------------------------------------------------------------------ */

/* Keeps dashes as cairo does: the offset lies within one period. False: cairo would draw other dashes than these. */
static bool normalise_dashes(plain_pen *p, const matrix *m)
{
    double on = 0, off = 0;
    if (!p->n_dashes) {
        p->dash_offset = 0;
        return true;
    }
    for (int i = 0; i < p->n_dashes; i++)
        *(i % 2 ? &off : &on) += p->dashes[i];
    double whole = on + off;
    if (p->n_dashes % 2) {
        on = whole;
        whole *= 2;
    }
    double size = sqrt(m->xx * m->xx + m->yx * m->yx + m->xy * m->xy + m->yy * m->yy);
    if (!(whole - on > 0.01 && whole * size > FINE_DASHES))
        return false;
    p->dash_offset = fmod(p->dash_offset, whole);
    if (p->dash_offset < 0)
        p->dash_offset += whole;
    return true;
}

/* Gives the factor by which lengths of the pen grow on paper. */
static double pen_scale(const plain_list *s, matrix m)
{
    bool is_unit = fabs(m.xx - 1) < SAME && fabs(m.yy - 1) < SAME && fabs(m.yx) < SAME && fabs(m.xy) < SAME;
    bool is_upright = fabs(m.yx) < SAME && fabs(m.xy) < SAME;
    matrix pen = MATRIX_IDENTITY;
    if (!is_unit) {
        pen.xx = as_cairo_prints(m.xx);
        pen.yy = as_cairo_prints(m.yy);
        pen.yx = is_upright ? 0 : as_cairo_prints(m.yx);
        pen.xy = is_upright ? 0 : as_cairo_prints(m.xy);
    }
    return plb_matrix_expansion(pen) * plb_matrix_expansion(s->to_page);
}

static bool same_pen(const plain_pen *a, const plain_pen *b)
{
    return a->width == b->width && a->cap == b->cap && a->n_dashes == b->n_dashes && a->dash_offset == b->dash_offset &&
           !memcmp(a->dashes, b->dashes, (size_t)a->n_dashes * sizeof *a->dashes);
}

/* Tells whether two matrices agree to the last digit but for the translation: lines under both have the same width. */
static bool same_matrix(const matrix *a, const matrix *b) { return a->xx == b->xx && a->yx == b->yx && a->xy == b->xy && a->yy == b->yy; }

/* Makes s->line for a pen; false: not plain, or no memory. An odd pattern of dashes is written twice. */
static bool make_line(plain_list *s, const plain_pen *wanted, const matrix *m)
{
    static const line_cap caps[] = {[PLAIN_BUTT] = LINE_CAP_BUTT, [PLAIN_ROUND] = LINE_CAP_ROUND, [PLAIN_SQUARE] = LINE_CAP_SQUARE};
    if (s->has_pen && same_pen(wanted, &s->pen) && same_matrix(m, &s->pen_matrix))
        return true;
    s->has_pen = false;
    plain_pen pen = *wanted;
    if (!normalise_dashes(&pen, m))
        return false;
    item *line = &s->line;
    double scale = pen_scale(s, *m);
    size_t n = (size_t)pen.n_dashes, all = n % 2 ? 2 * n : n;
    line->dash.n = 0;
    if (!array_reserve(&line->dash, all))
        return false;
    line->kind = ITEM_STROKE;
    line->clip = NO_CLIP;
    line->cap = caps[pen.cap];
    line->width = as_cairo_prints(pen.width) * scale;
    line->dash_offset = as_cairo_prints(pen.dash_offset) * scale;
    for (size_t i = 0; i < all; i++)
        line->dash.v[line->dash.n++] = as_cairo_prints(pen.dashes[i % n]) * scale;
    s->pen = *wanted;
    s->pen_matrix = *m;
    return s->has_pen = true;
}

/* ---- drawing ------------------------------------------------------------------------------------------------ */

static void fill(plain_list *s, const plain_paint *p, bool even_odd)
{
    item it = {.kind = ITEM_FILL, .path = s->drawn, .paint = colour(s, p), .clip = NO_CLIP, .even_odd = even_odd};
    if (!plb_tap_has_no_area(&it.path))
        plb_list_writer_item(&s->out, &it);
}

static bool stroke(plain_list *s, const plain_paint *p, const plain_pen *pen)
{
    if (!make_line(s, pen, &s->path.matrix))
        return false;
    item it = s->line;
    it.path = s->drawn;
    it.paint = colour(s, p);
    plb_list_writer_item(&s->out, &it);
    return true;
}

bool plb_plain_draw(plain_list *s, const plain_style *style)
{
    const plain_path *p = &s->path;
    plain_paint inside = plb_plain_fill(style), line = plb_plain_stroke(style);
    bool fills = !inside.is_none && !p->is_empty, strokes = !line.is_none && style->pen.width > 0;
    if (p->failed || (p->has_current && !p->n_ops) || (p->is_upright && (fills || p->n_ops >= 4)))
        return false;
    if (style->is_hidden || !p->n_ops || !(fills || strokes))
        return true;
    if (!make_path(s))
        return false;
    if (fills)
        fill(s, &inside, style->even_odd);
    return !strokes || stroke(s, &line, &style->pen);
}

/* ---- the whole ---------------------------------------------------------------------------------------------- */

void plb_plain_list_begin(plain_list *s, const tap_page *p)
{
    *s = (plain_list){.has_pen = false};
    for (int i = 0; i < 256; i++) /* in single precision, as librsvg hands them on */
        s->shares[i] = as_cairo_prints((double)((float)i / 255.0f));
    tap_sheet sheet = plb_tap_sheet(p);
    s->to_page = sheet.to_page;
    plb_list_writer_init(&s->out, keep, s);
    plb_list_writer_page(&s->out, sheet.width, sheet.height);
    plb_list_writer_matrix(&s->out, sheet.to_page);
}

bool plb_plain_list_end(plain_list *s) { return plb_list_writer_end(&s->out); }

void plb_plain_list_free(plain_list *s)
{
    plb_plain_free(&s->path);
    plb_path_free(&s->drawn);
    array_free(&s->line.dash);
    array_free(&s->text);
}
