/* SPDX-License-Identifier: MIT
 *
 * Stroke, stage 6: the strip is laid along the path.
 * Input: a texture (pixels of the profile), the drawn path (mm). Output: patches (pixels of the page).
 *
 * Each straight piece of the path owns the pixels between the two lines that bisect its joints, so every pixel beside
 * a smooth path belongs to one piece, and a joint shows neither gap nor overlap: both pieces see a pixel on their
 * common bisector at the same distance, and `along` is interpolated between the bisectors. Where a page pixel covers
 * several pixels of the texture it is the mean of a grid of samples.
 *
 *     piece i:   a(q) = (q - P_i) . B_i >= 0,   b(q) = (q - P_i+1) . B_i+1 < 0,   B the tangent at the joint
 *                across(q) = cross(T_i, q - P_i),   along(q) = s_i + len_i a / (a - b)
 */
#include "base/units.h"
#include "stroke/stroke.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* A patch is handed on when its bounds pass this many pixels (chosen by measurement: a diagonal's patches stay
 * mostly line, a level line's patches long). */
#define PATCH_AREA 2400
/* At most this many samples a page pixel in each direction: enough for 300 dpi pencils at 37 dpi. */
#define MOST_SAMPLES 8

typedef struct {
    const shading *s;
    double strip_px;      /* strip pixels per page pixel */
    double page_mm;       /* mm per page pixel */
    int samples;          /* per page pixel and direction */
    double half_width;    /* page pixels */
    int top, foot;        /* rows wanted */
    patch p;
    int x1, y1;           /* the patch covers [p.x, x1) × [p.y, y1); empty when x1 <= p.x */
    uint8_t *fine;        /* darkness of each sample, `stride` a row; where pieces meet again in a tight bend, the darker */
    size_t stride;
    uint8_t *kept;        /* room for samples of pixels that the next patch will go on with */
    patch_sink sink;
    void *closure;
} mapper;

/* A piece of the path in page pixels. */
typedef struct {
    point p0, p1, b0, b1, t;
    double length, s0; /* s0 in strip pixels */
    double left, right; /* how far it reaches to either side, page pixels */
    int x0, y0, x1, y1; /* page pixels it may touch */
} piece;

/* The mean of a pixel's samples, as grey. */
static uint8_t resolve(const mapper *m, int x, int y)
{
    const uint8_t *from = m->fine + (size_t)(y * m->samples) * m->stride + (size_t)(x * m->samples);
    if (m->samples == 1)
        return (uint8_t)(255 - *from);
    int sum = 0, n = m->samples * m->samples;
    for (int j = 0; j < m->samples; j++, from += m->stride)
        for (int i = 0; i < m->samples; i++)
            sum += from[i];
    return (uint8_t)(255 - (sum + n / 2) / n);
}

static bool flush(mapper *m)
{
    bool ok = true;
    int w = m->x1 - m->p.x, h = m->y1 - m->p.y;
    if (w > 0 && h > 0 && m->p.y < m->foot && m->y1 > m->top) {
        m->p.width = w;
        m->p.height = h;
        for (int y = 0; y < h; y++)
            for (int x = 0; x < w; x++)
                m->p.grey[y * w + x] = resolve(m, x, y);
        ok = m->sink(m->closure, &m->p);
        for (int y = 0; y < h * m->samples; y++)
            memset(m->fine + (size_t)y * m->stride, 0, (size_t)(w * m->samples));
    }
    m->x1 = m->p.x = 0;
    return ok;
}

static void move_samples(const mapper *m, uint8_t *to, const uint8_t *from, size_t to_stride, size_t from_stride, int width, int height)
{
    for (int y = 0; y < height * m->samples; y++)
        memcpy(to + (size_t)y * to_stride, from + (size_t)y * from_stride, (size_t)(width * m->samples));
}

static uint8_t *samples_at(const mapper *m, int x, int y)
{
    return m->fine + (size_t)((y - m->p.y) * m->samples) * m->stride + (size_t)((x - m->p.x) * m->samples);
}

/* Hands the patch on and begins the next at the piece. Pixels that have samples of both would be laid twice, each time too
 * light: their samples go over into the new patch. */
static bool begin_next(mapper *m, const piece *k)
{
    int x0 = k->x0 > m->p.x ? k->x0 : m->p.x, y0 = k->y0 > m->p.y ? k->y0 : m->p.y;
    int w = (k->x1 < m->x1 ? k->x1 : m->x1) - x0, h = (k->y1 < m->y1 ? k->y1 : m->y1) - y0;
    bool keep = m->samples > 1 && w > 0 && h > 0;
    size_t row = keep ? (size_t)(w * m->samples) : 0;
    if (keep) {
        move_samples(m, m->kept, samples_at(m, x0, y0), row, m->stride, w, h);
        for (int y = 0; y < h * m->samples; y++)
            memset(samples_at(m, x0, y0) + (size_t)y * m->stride, 0, row);
    }
    if (!flush(m))
        return false;
    m->p.x = k->x0;
    m->p.y = k->y0;
    m->x1 = k->x1;
    m->y1 = k->y1;
    if (keep)
        move_samples(m, samples_at(m, x0, y0), m->kept, m->stride, row, w, h);
    return true;
}

/* Makes room in the patch for the piece; false when the sink stops. */
static bool make_room(mapper *m, const piece *k)
{
    if (m->x1 <= m->p.x)
        return begin_next(m, k);
    int x0 = k->x0 < m->p.x ? k->x0 : m->p.x, y0 = k->y0 < m->p.y ? k->y0 : m->p.y;
    int x1 = k->x1 > m->x1 ? k->x1 : m->x1, y1 = k->y1 > m->y1 ? k->y1 : m->y1;
    bool fits = x0 == m->p.x && y0 == m->p.y && x1 - x0 <= PATCH_SIDE && y1 - y0 <= PATCH_SIDE && (x1 - x0) * (y1 - y0) <= PATCH_AREA;
    if (!fits)
        return begin_next(m, k);
    m->x1 = x1;
    m->y1 = y1;
    return true;
}

/* Narrows [*low, *high] to the x where c0 + c1 x >= 0. */
static void narrow(double c0, double c1, double *low, double *high)
{
    if (c1 > 0 && -c0 / c1 > *low)
        *low = -c0 / c1;
    else if (c1 < 0 && -c0 / c1 < *high)
        *high = -c0 / c1;
    else if (c1 == 0 && c0 < 0)
        *high = *low - 1;
}

/* A row of samples of one piece: the quantities of the banner at sample 0, and their steps. */
typedef struct {
    const piece *k;
    double step, a, b, u, us; /* step: page px from sample to sample */
    double x, y;              /* of sample 0, page px */
} row_frame;

static double row_a(const row_frame *r, int i)
{
    return r->a + i * r->k->b0.x * r->step;
}

static double row_b(const row_frame *r, int i)
{
    return r->b + i * r->k->b1.x * r->step;
}

static bool is_in_piece(const row_frame *r, int i)
{
    double u = r->u + i * r->us;
    return !(row_a(r, i) < 0 || row_b(r, i) >= 0 || u > r->k->right || u < -r->k->left);
}

static double row_along(const mapper *m, const row_frame *r, int i)
{
    double a = row_a(r, i), b = row_b(r, i);
    return r->k->s0 + r->k->length * m->strip_px * a / (a - b);
}

/* Samples first to last, all within the piece: `along` is taken to run evenly between them, as it does on straight lines
 * and nearly on others. */
static void shade_run(const mapper *m, const row_frame *r, int first, int last, uint8_t *to)
{
    uint8_t dark[PATCH_SIDE * MOST_SAMPLES];
    double along = row_along(m, r, first), mm = m->page_mm;
    sample_row at = {last - first + 1, along, 0, (r->u + first * r->us) * m->strip_px, r->us * m->strip_px,
                     (r->x + first * r->step) * mm, r->y * mm, r->step * mm};
    if (last > first)
        at.along_step = (row_along(m, r, last) - along) / (last - first);
    m->s->row(m->s->texture, &at, dark);
    for (int i = 0; i < at.n; i++)
        to[first + i] = dark[i] > to[first + i] ? dark[i] : to[first + i];
}

static void shade_one_by_one(const mapper *m, const row_frame *r, int first, int last, uint8_t *to)
{
    for (int i = first; i <= last; i++)
        if (is_in_piece(r, i))
            shade_run(m, r, i, i, to);
}

/* One row of samples of one piece, at height y (page pixels). */
static void map_row(const mapper *m, const piece *k, double y, uint8_t *to)
{
    double step = 1.0 / m->samples, x = k->x0 + step / 2;
    row_frame r = {.k = k, .step = step, .us = -k->t.y * step, .x = x, .y = y};
    double dy0 = y - k->p0.y, dy1 = y - k->p1.y;
    r.a = (x - k->p0.x) * k->b0.x + dy0 * k->b0.y;
    r.b = (x - k->p1.x) * k->b1.x + dy1 * k->b1.y;
    r.u = k->t.x * dy0 - k->t.y * (x - k->p0.x);
    double low = -0.5, high = (double)(k->x1 - k->x0) * m->samples - 0.5;
    narrow(r.a, k->b0.x * step, &low, &high);
    narrow(-r.b, -k->b1.x * step, &low, &high);
    narrow(k->left + r.u, r.us, &low, &high);
    narrow(k->right - r.u, -r.us, &low, &high);
    if (!(low <= high)) /* and so both fit an int */
        return;
    int first = low < 0 ? 0 : (int)ceil(low - 1e-9), last = (int)floor(high + 1e-9);
    if (m->s->one_by_one) {
        shade_one_by_one(m, &r, first, last, to);
        return;
    }
    while (first <= last && !is_in_piece(&r, first))
        first++;
    while (first <= last && !is_in_piece(&r, last))
        last--;
    if (first <= last)
        shade_run(m, &r, first, last, to);
}

static int clamp_pixel(double v)
{
    return v < -1e6 ? -1000000 : v > 1e6 ? 1000000 : (int)v;
}

/* On the inside of a bend tighter than the line is wide, the pieces would meet again beyond the centre of curvature:
 * they stop a little short of it. */
#define SHORT_OF_CENTRE 0.85

static void set_reach(piece *k, double half_width)
{
    double turn = point_cross(k->b0, k->b1); /* its sine; positive: to the right, as y goes down */
    double inside = fabs(turn) > 1e-6 ? SHORT_OF_CENTRE * k->length / fabs(turn) : half_width;
    k->left = k->right = half_width;
    if (inside < half_width)
        *(turn > 0 ? &k->right : &k->left) = inside;
}

static piece piece_of(const mapper *m, const path_sample *from, const path_sample *to, double px, bool first, bool last)
{
    piece k = {.p0 = point_scale(from->at, px), .p1 = point_scale(to->at, px), .b0 = from->tangent, .b1 = to->tangent};
    point d = point_sub(k.p1, k.p0);
    k.length = plb_point_length(d);
    k.t = point_scale(d, 1 / k.length);
    k.s0 = from->along * px * m->strip_px;
    double over = m->s->beyond / m->strip_px;
    if (first || last) {
        if (first) {
            k.p0 = point_sub(k.p0, point_scale(k.t, over));
            k.s0 -= m->s->beyond;
            k.b0 = k.t;
        }
        if (last) {
            k.p1 = point_add(k.p1, point_scale(k.t, over));
            k.b1 = k.t;
        }
        k.length += (first + last) * over;
    }
    set_reach(&k, m->half_width);
    double r = m->half_width + 1;
    k.x0 = clamp_pixel(floor(fmin(k.p0.x, k.p1.x) - r));
    k.y0 = clamp_pixel(floor(fmin(k.p0.y, k.p1.y) - r));
    k.x1 = clamp_pixel(ceil(fmax(k.p0.x, k.p1.x) + r));
    k.y1 = clamp_pixel(ceil(fmax(k.p0.y, k.p1.y) + r));
    return k;
}

/* A piece whose bounds do not fit a patch is mapped in windows. */
static bool map_window(mapper *m, piece k)
{
    if (!make_room(m, &k))
        return false;
    int from = k.y0 < m->top ? m->top - k.y0 : 0, to = (k.y1 > m->foot ? m->foot : k.y1) - k.y0;
    for (int j = from * m->samples; j < to * m->samples; j++) {
        size_t row = (size_t)((k.y0 - m->p.y) * m->samples + j), column = (size_t)((k.x0 - m->p.x) * m->samples);
        map_row(m, &k, k.y0 + (j + 0.5) / m->samples, m->fine + row * m->stride + column);
    }
    return true;
}

static bool map_piece(mapper *m, piece k)
{
    for (int y = k.y0; y < k.y1; y += PATCH_SIDE)
        for (int x = k.x0; x < k.x1; x += PATCH_SIDE) {
            piece window = k;
            window.x0 = x;
            window.y0 = y;
            window.x1 = x + PATCH_SIDE < k.x1 ? x + PATCH_SIDE : k.x1;
            window.y1 = y + PATCH_SIDE < k.y1 ? y + PATCH_SIDE : k.y1;
            if (!map_window(m, window))
                return false;
        }
    return true;
}

/* Room for the samples of the largest patch, all zero; kept from stroke to stroke. */
static bool make_fine(map_room *room, size_t side)
{
    if (room->size >= side * side)
        return true;
    plb_free(room->fine);
    room->fine = plb_new(2 * side * side, 1); /* the second half: samples kept */
    room->size = room->fine ? side * side : 0;
    return room->fine != NULL;
}

bool plb_strip_map(const shading *s, const map_page *page, const path_samples *path, bool closed, map_room *room, patch_sink sink,
                   void *closure)
{
    double px = page->dpi / MM_PER_INCH, reach = STROKE_REACH_MM / MM_PER_INCH * s->dpi;
    bool all = page->top == page->foot;
    shading within = *s;
    within.half_width = fmin(s->half_width, reach);
    within.beyond = fmin(s->beyond, reach);
    mapper m = {.s = &within, .strip_px = s->dpi / page->dpi, .page_mm = MM_PER_INCH / page->dpi, .sink = sink, .closure = closure};
    m.top = all ? INT_MIN : page->top;
    m.foot = all ? INT_MAX : page->foot;
    double n = floor(m.strip_px + 0.5); /* as dense as the texture, nearly */
    m.samples = n < 1 ? 1 : n > MOST_SAMPLES ? MOST_SAMPLES : (int)n;
    m.half_width = within.half_width / m.strip_px;
    m.stride = (size_t)(PATCH_SIDE * m.samples);
    if (!make_fine(room, m.stride))
        return false;
    m.fine = room->fine;
    m.kept = room->fine + m.stride * m.stride;
    bool ok = true;
    for (size_t i = 0; ok && i + 1 < path->n; i++)
        ok = map_piece(&m, piece_of(&m, path->v + i, path->v + i + 1, px, i == 0 && !closed, i + 2 == path->n && !closed));
    return ok && flush(&m);
}
