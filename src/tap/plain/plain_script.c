/* SPDX-License-Identifier: MIT */
#include "tap/plain/plain_script.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BLOCK_BYTES ((size_t)1 << 20)
#define PIECE_MAX ((size_t)1 << 14) /* of what is written at once: the longest is a pattern of dashes */
#define SCRIPT_MAX ((size_t)512 << 20)
#define SAME 1e-5                    /* cairo takes numbers that differ by less for the same */
#define FINE_DASHES 0.2              /* surface units: cairo makes patterns below 0.1 coarser */

struct plain_block {
    plain_block *next;
    size_t used;
    char text[BLOCK_BYTES];
};

/* ---- text --------------------------------------------------------------------------------------------------- */

static bool add_block(plain_script *s)
{
    plain_block *more = s->size > SCRIPT_MAX || s->failed ? NULL : malloc(sizeof *more);
    s->failed = !more;
    if (!more)
        return false;
    more->next = NULL;
    more->used = 0;
    *(s->last ? &s->last->next : &s->first) = more;
    s->last = more;
    return true;
}

/* Where a piece can be written; NULL: there is no room, which the script remembers. */
static char *start_piece(plain_script *s)
{
    bool fits = s->last && s->last->used + PIECE_MAX <= BLOCK_BYTES;
    return fits || add_block(s) ? s->last->text + s->last->used : NULL;
}

static void end_piece(plain_script *s, const char *end)
{
    size_t n = (size_t)(end - (s->last->text + s->last->used));
    s->last->used += n;
    s->size += n;
}

static char *put_text(char *at, const char *text)
{
    size_t n = strlen(text);
    memcpy(at, text, n);
    return at + n;
}

static void write_text(plain_script *s, const char *text)
{
    char *at = start_piece(s);
    if (at)
        end_piece(s, put_text(at, text));
}

/* A number and what it is for. */
static void write_number(plain_script *s, double v, const char *operator)
{
    char *at = start_piece(s);
    if (at)
        end_piece(s, put_text(plb_plain_put_double(at, v), operator));
}

/* ---- surface and path --------------------------------------------------------------------------------------- */

static void write_surface(plain_script *s)
{
    write_text(s, "<< /content //COLOR_ALPHA /width ");
    write_number(s, s->width, " /height ");
    write_number(s, s->height, " >> surface context\n");
    s->is_begun = true;
}

static char *put_points(const plain_script *s, char *at, const plain_point *points, int n, char operator)
{
    for (int i = 0; i < n; i++) {
        *at++ = ' ';
        at = plb_plain_put_fixed(at, &s->digits, points[i].x);
        *at++ = ' ';
        at = plb_plain_put_fixed(at, &s->digits, points[i].y);
    }
    *at++ = ' ';
    *at++ = operator;
    return at;
}

static bool is_written(const plain_script *s)
{
    const plain_path *a = &s->path, *b = &s->written;
    return a->n_ops == b->n_ops && a->n_points == b->n_points && !memcmp(a->ops, b->ops, a->n_ops) &&
           !memcmp(a->points, b->points, a->n_points * sizeof *a->points);
}

/* The path, unless the context has it. */
static void write_path(plain_script *s, bool *written)
{
    static const int counts[] = {[PLAIN_MOVE] = 1, [PLAIN_LINE] = 1, [PLAIN_CURVE] = 3, [PLAIN_CLOSE] = 0};
    static const char operators[] = {[PLAIN_MOVE] = 'm', [PLAIN_LINE] = 'l', [PLAIN_CURVE] = 'c', [PLAIN_CLOSE] = 'h'};
    const plain_path *p = &s->path;
    const plain_point *next = p->points;
    if (*written)
        return;
    *written = true;
    write_text(s, "n");
    for (size_t i = 0; i < p->n_ops; i++) {
        char *at = start_piece(s);
        if (!at)
            return;
        end_piece(s, put_points(s, at, next, counts[p->ops[i]], operators[p->ops[i]]));
        next += counts[p->ops[i]];
    }
    char *at = start_piece(s);
    if (!at)
        return;
    if (p->is_pending)
        at = put_points(s, at, &p->current, 1, 'm');
    *at++ = '\n';
    end_piece(s, at);
}

/* ---- the context -------------------------------------------------------------------------------------------- */

static void write_identity(plain_script *s)
{
    if (s->now.is_turned)
        write_text(s, "identity set-matrix\n");
    s->now.is_turned = false;
}

/* In single precision, as librsvg hands it on. */
static double share_of(unsigned char part) { return (double)((float)part / 255.0f); }

static void write_source(plain_script *s, const plain_paint *p)
{
    plain_paint *now = &s->now.source;
    if (p->red == now->red && p->green == now->green && p->blue == now->blue && p->alpha == now->alpha)
        return;
    *now = *p;
    bool is_opaque = p->alpha == 255;
    if (!is_opaque && !(p->red | p->green | p->blue)) {
        write_number(s, share_of(p->alpha), " a set-source\n");
        return;
    }
    if (is_opaque && p->red == p->green && p->red == p->blue) {
        write_number(s, share_of(p->red), " g set-source\n");
        return;
    }
    write_number(s, share_of(p->red), " ");
    write_number(s, share_of(p->green), " ");
    write_number(s, share_of(p->blue), is_opaque ? " rgb set-source\n" : " ");
    if (!is_opaque)
        write_number(s, share_of(p->alpha), " rgba set-source\n");
}

static void write_rule(plain_script *s, bool even_odd)
{
    if (s->now.even_odd != even_odd)
        write_text(s, even_odd ? "//EVEN_ODD set-fill-rule\n" : "//WINDING set-fill-rule\n");
    s->now.even_odd = even_odd;
}

static bool same_pens(tap_matrix a, tap_matrix b)
{
    return fabs(a.xx - b.xx) < SAME && fabs(a.yx - b.yx) < SAME && fabs(a.xy - b.xy) < SAME && fabs(a.yy - b.yy) < SAME;
}

/* To the last digit, without the translation: what was written for one serves for the other. */
static bool equal_pens(tap_matrix a, tap_matrix b) { return a.xx == b.xx && a.yx == b.yx && a.xy == b.xy && a.yy == b.yy; }

static void make_matrix_text(plain_script *s, tap_matrix m)
{
    char *at = s->matrix_text;
    if (fabs(m.yx) < SAME && fabs(m.xy) < SAME) {
        at = put_text(plb_plain_put_double(at, m.xx), " ");
        at = put_text(plb_plain_put_double(at, m.yy), " scale\n");
    } else {
        *at++ = '[';
        at = put_text(plb_plain_put_double(at, m.xx), " ");
        at = put_text(plb_plain_put_double(at, m.yx), " ");
        at = put_text(plb_plain_put_double(at, m.xy), " ");
        at = put_text(plb_plain_put_double(at, m.yy), " 0 0] set-matrix\n");
    }
    *at = '\0';
    s->matrix = m;
}

/* The pen's matrix; true: it is another than the last line's, so that the whole pen is to be written. */
static bool write_matrix(plain_script *s)
{
    static const tap_matrix identity = {1, 0, 0, 1, 0, 0};
    tap_matrix m = s->path.matrix;
    m.x0 = m.y0 = 0;
    if (same_pens(m, identity)) {
        m = identity;
    } else {
        if (!equal_pens(m, s->matrix))
            make_matrix_text(s, m);
        write_text(s, s->matrix_text);
        s->now.is_turned = true;
    }
    bool is_new = !same_pens(m, s->now.pen_matrix);
    s->now.pen_matrix = is_new ? m : s->now.pen_matrix;
    return is_new;
}

/* ---- the pen ------------------------------------------------------------------------------------------------ */

static bool same_dashes(const plain_pen *a, const plain_pen *b)
{
    if (a->n_dashes != b->n_dashes)
        return false;
    for (int i = 0; i < a->n_dashes; i++)
        if (fabs(a->dashes[i] - b->dashes[i]) > SAME)
            return false;
    return !a->n_dashes || fabs(a->dash_offset - b->dash_offset) < SAME;
}

static void write_dashes(plain_script *s, const plain_pen *p, bool all)
{
    if (all ? !p->n_dashes && !s->now.pen.n_dashes : same_dashes(p, &s->now.pen))
        return;
    write_text(s, "[");
    for (int i = 0; i < p->n_dashes; i++)
        write_number(s, p->dashes[i], i < p->n_dashes - 1 ? " " : "");
    write_text(s, "] ");
    write_number(s, p->dash_offset, " set-dash\n");
}

/* cairo's default is taken for granted, another number is written again when the matrix changes. */
static void write_changed(plain_script *s, double v, double now, double normal, bool all, const char *operator)
{
    if (v != now || (all && fabs(v - normal) >= SAME))
        write_number(s, v, operator);
}

static void write_pen(plain_script *s, const plain_pen *p, bool all)
{
    static const char *const caps[] = {"//LINE_CAP_BUTT set-line-cap\n", "//LINE_CAP_ROUND set-line-cap\n", "//LINE_CAP_SQUARE set-line-cap\n"};
    static const char *const joins[] = {"//LINE_JOIN_MITER set-line-join\n", "//LINE_JOIN_ROUND set-line-join\n", "//LINE_JOIN_BEVEL set-line-join\n"};
    plain_pen *now = &s->now.pen;
    write_changed(s, p->width, now->width, 2, all, " set-line-width\n");
    if (p->cap != now->cap)
        write_text(s, caps[p->cap]);
    if (p->join != now->join)
        write_text(s, joins[p->join]);
    write_changed(s, p->miter_limit, now->miter_limit, 10, all, " set-miter-limit\n");
    write_dashes(s, p, all);
    *now = *p;
}

/* As cairo keeps dashes: the offset lies within one period. False: cairo would draw something else than these. */
static bool normalise_dashes(plain_pen *p, const tap_matrix *m)
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

/* ---- drawing ------------------------------------------------------------------------------------------------ */

static void fill(plain_script *s, const plain_paint *paint, bool even_odd, bool *written)
{
    write_identity(s);
    write_source(s, paint);
    write_rule(s, even_odd);
    write_path(s, written);
    write_text(s, "fill+\n");
}

static bool stroke(plain_script *s, const plain_paint *paint, plain_pen pen, bool *written)
{
    if (!normalise_dashes(&pen, &s->path.matrix))
        return false;
    write_identity(s);
    write_path(s, written);
    write_source(s, paint);
    write_pen(s, &pen, write_matrix(s));
    write_text(s, "stroke+\n");
    return true;
}

bool plb_plain_draw(plain_script *s, const plain_style *style)
{
    const plain_path *p = &s->path;
    plain_paint inside = plb_plain_fill(style), line = plb_plain_stroke(style);
    bool fills = !inside.is_none && !p->is_empty, strokes = !line.is_none && style->pen.width > 0;
    if (p->failed || s->failed || (p->has_current && !p->n_ops) || (p->is_upright && (fills || p->n_ops >= 4)))
        return false;
    if (style->is_hidden || !p->n_ops || !(fills || strokes))
        return true;
    if (!s->is_begun)
        write_surface(s);
    bool was_written = is_written(s), written = was_written;
    if (fills)
        fill(s, &inside, style->even_odd, &written);
    if (strokes && !stroke(s, &line, style->pen, &written))
        return false;
    if (!was_written) {
        plain_path other = s->written;
        s->written = s->path;
        s->path = other;
    }
    return !s->failed;
}

/* ---- the whole ---------------------------------------------------------------------------------------------- */

void plb_plain_script_begin(plain_script *s, const tap_page *p)
{
    tap_placing l = plb_tap_place(p);
    char line[TAP_HEAD_MAX];
    *s = (plain_script){.width = l.width, .height = l.height};
    s->now = (plain_context){.source = {.alpha = 255}, .pen = {.width = 2, .miter_limit = 10}, .pen_matrix = {1, 0, 0, 1, 0, 0}};
    plb_plain_digits(&s->digits);
    plb_tap_head(p, (tap_omissions){0}, line);
    write_text(s, line);
    write_text(s, "%!CairoScript\n");
}

bool plb_plain_script_end(plain_script *s)
{
    if (s->is_begun)
        write_text(s, "pop\n");
    return !s->failed;
}

void plb_plain_script_free(plain_script *s)
{
    while (s->first) {
        plain_block *next = s->first->next;
        free(s->first);
        s->first = next;
    }
    s->last = NULL;
    plb_plain_free(&s->path);
    plb_plain_free(&s->written);
}

void plb_plain_script_write(const plain_script *s, void (*put)(const char *text, size_t size))
{
    for (const plain_block *b = s->first; b; b = b->next)
        put(b->text, b->used);
}
