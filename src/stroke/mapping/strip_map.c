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
 *
 * strip_rows.c has this for the rows of one piece.
 */
#include "base/number/units.h"
#include "stroke/mapping/strip_map.h"
#include "stroke/mapping/strip_rows.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* A patch is handed on when its bounds pass this many pixels, where samples are taken one by one. */
#define PATCH_AREA 2400
/* At most this many samples a page pixel in each direction: enough for 300 dpi pencils at 37 dpi. */
#define MAX_SAMPLES 8
/* Pieces that wait until it is known how far their patch reaches. */
#define MAX_WAITING 32
/* Rows of samples that are asked for at a time, and their samples altogether: a row at least. */
#define ROWS_ASKED 64
#define SAMPLES_ASKED (PATCH_SIDE * MAX_SAMPLES)
/* Samples that are compared at a time. */
#define ROWS_TOGETHER 16
/* Neighbouring pieces become one where the path strays from it by no more than this, page pixels (a tenth of a pixel is
 * not seen; pieces get twice as long). */
#define SAMPLE_STRAY 0.1
/* … and such a piece is no longer than this, page pixels: its bounds should not be much wider than the stroke. */
#define LONGEST_PIECE 48.0

/* Rows of samples whose darkness is not known yet, and where it goes. */
typedef struct {
    int n, samples;
    sample_row row[ROWS_ASKED];
    uint8_t *to[ROWS_ASKED];
} asked_rows;

typedef struct {
    const shading *s;
    double strip_px;      /* strip pixels per page pixel */
    double page_mm;       /* mm per page pixel */
    int samples;          /* per page pixel and direction */
    double half_width;    /* page pixels */
    int top, bottom;        /* rows wanted */
    patch p;
    pixel_box in;               /* what the patch covers */
    piece waiting[MAX_WAITING];
    int n;                /* of them */
    pixel_box wait;             /* what they cover */
    asked_rows asked;
    uint8_t *fine;        /* darkness of each sample, `stride` a row; where pieces meet again in a tight bend, the darker */
    size_t stride;
    uint8_t *kept;        /* samples of pixels that the next patch will go on with */
    uint32_t divisor;     /* 2^18 / samples^2, rounded up: exact for the sums there are */
    patch_sink sink;
    void *closure;
} mapper;

static pixel_box unite(pixel_box a, pixel_box b)
{
    return (pixel_box){a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.x1 > b.x1 ? a.x1 : b.x1, a.y1 > b.y1 ? a.y1 : b.y1};
}

static pixel_box intersect(pixel_box a, pixel_box b)
{
    return (pixel_box){a.x0 > b.x0 ? a.x0 : b.x0, a.y0 > b.y0 ? a.y0 : b.y0, a.x1 < b.x1 ? a.x1 : b.x1, a.y1 < b.y1 ? a.y1 : b.y1};
}

static uint8_t *samples_at(const mapper *m, int x, int y)
{
    return m->fine + (size_t)((y - m->in.y0) * m->samples) * m->stride + (size_t)((x - m->in.x0) * m->samples);
}

/* ---- from samples to the patch ---- */

/* To the right and down. */
static void grow_patch(mapper *m, pixel_box in)
{
    for (int y = m->in.y1 - m->in.y0; y < in.y1 - in.y0; y++) {
        m->p.from[y] = PATCH_SIDE;
        m->p.to[y] = 0;
    }
    m->in = in;
}

static void begin_patch(mapper *m, pixel_box in)
{
    m->in = (pixel_box){in.x0, in.y0, in.x0, in.y0};
    grow_patch(m, in);
}

/* Notes that columns x0 to x1 of a row of the patch have samples. */
static void mark(mapper *m, int row, int x0, int x1)
{
    m->p.from[row] = (uint8_t)(x0 < m->p.from[row] ? x0 : m->p.from[row]);
    m->p.to[row] = (uint8_t)(x1 > m->p.to[row] ? x1 : m->p.to[row]);
}

/* One sample a pixel: n of them as grey, and clears them; in whole blocks, as both are blank beyond: the samples as nothing has
 * been put there, the row as it is. */
static void resolve_single(uint8_t *restrict from, uint8_t *restrict grey, int n)
{
    for (; n > 0; n -= ROWS_TOGETHER, from += ROWS_TOGETHER, grey += ROWS_TOGETHER)
        for (int i = 0; i < ROWS_TOGETHER; i++) {
            grey[i] = (uint8_t)~from[i];
            from[i] = 0;
        }
}

/* Computes the means of the pixels' samples, as grey; row y of the patch, and clears the samples. */
static void resolve(mapper *m, int y, uint8_t *grey)
{
    int x0 = m->p.from[y], x1 = m->p.to[y], n = m->samples;
    uint8_t *from = m->fine + (size_t)(y * n) * m->stride + (size_t)(x0 * n);
    if (n == 1) {
        resolve_single(from, grey + x0, x1 - x0);
        return;
    }
    uint16_t column[PATCH_SIDE * MAX_SAMPLES];
    int width = (x1 - x0) * n;
    memset(column, 0, (size_t)width * sizeof *column);
    for (int j = 0; j < n; j++, from += m->stride) {
        for (int x = 0; x < width; x++)
            column[x] = (uint16_t)(column[x] + from[x]);
        memset(from, 0, (size_t)width);
    }
    for (int x = 0; x < x1 - x0; x++) {
        uint32_t sum = (uint32_t)(n * n / 2);
        for (int i = 0; i < n; i++)
            sum += column[x * n + i];
        grey[x0 + x] = (uint8_t)(255 - ((sum * m->divisor) >> 18));
    }
}

static bool flush(mapper *m)
{
    int w = m->in.x1 - m->in.x0, h = m->in.y1 - m->in.y0;
    bool wanted = w > 0 && h > 0 && m->in.y0 < m->bottom && m->in.y1 > m->top;
    if (wanted) {
        m->p.x = m->in.x0;
        m->p.y = m->in.y0;
        m->p.width = w;
        m->p.height = h;
        memset(m->p.grey, 255, (size_t)(w * h));
        for (int y = 0; y < h; y++)
            if (m->p.from[y] < m->p.to[y])
                resolve(m, y, m->p.grey + y * w);
    }
    m->in = (pixel_box){0};
    return !wanted || m->sink(m->closure, &m->p);
}

static void move_samples(const mapper *m, uint8_t *to, const uint8_t *from, size_t to_stride, size_t from_stride, int width, int height)
{
    for (int y = 0; y < height * m->samples; y++)
        memcpy(to + (size_t)y * to_stride, from + (size_t)y * from_stride, (size_t)(width * m->samples));
}

/* Hands the patch on and begins the next, which will cover `next`. Pixels that have samples of both would be laid twice, each
 * time too light: their samples go over into the new patch. */
static bool begin_next(mapper *m, pixel_box next)
{
    pixel_box both = intersect(next, m->in);
    int w = both.x1 - both.x0, h = both.y1 - both.y0;
    bool keep = m->samples > 1 && w > 0 && h > 0;
    size_t row = keep ? (size_t)(w * m->samples) : 0;
    if (keep) {
        move_samples(m, m->kept, samples_at(m, both.x0, both.y0), row, m->stride, w, h);
        for (int y = 0; y < h * m->samples; y++)
            memset(samples_at(m, both.x0, both.y0) + (size_t)y * m->stride, 0, row);
    }
    if (!flush(m))
        return false;
    begin_patch(m, next);
    for (int y = both.y0; keep && y < both.y1; y++)
        mark(m, y - next.y0, both.x0 - next.x0, both.x1 - next.x0);
    if (keep)
        move_samples(m, samples_at(m, both.x0, both.y0), m->kept, m->stride, row, w, h);
    return true;
}

/* ---- from pieces to samples ---- */

/* Takes the darker of both, for ROWS_TOGETHER samples; `mask`: 0 leaves a sample as it is. */
static void darken_lanes(uint8_t *restrict to, const uint8_t *restrict dark, const uint8_t *restrict mask)
{
    for (int i = 0; i < ROWS_TOGETHER; i++) {
        uint8_t d = dark[i] & mask[i];
        to[i] = d > to[i] ? d : to[i];
    }
}

/* … for n samples; up to ROWS_TOGETHER - 1 beyond are read and, unchanged, written. */
static void darken(uint8_t *to, const uint8_t *dark, int n)
{
    static const uint8_t masks[2 * ROWS_TOGETHER] = {255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255};
    for (; n > 0; n -= ROWS_TOGETHER, to += ROWS_TOGETHER, dark += ROWS_TOGETHER)
        darken_lanes(to, dark, masks + (n < ROWS_TOGETHER ? ROWS_TOGETHER - n : 0));
}

/* Gives the rows that wait their darkness. */
static void shade_asked(mapper *m)
{
    asked_rows *q = &m->asked;
    uint8_t dark[SAMPLES_ASKED + ROWS_TOGETHER], *from = dark;
    m->s->shade(m->s->texture, q->row, q->n, dark);
    memset(dark + q->samples, 0, ROWS_TOGETHER);
    for (int k = 0; k < q->n; from += q->row[k++].n)
        darken(q->to[k], from, q->row[k].n);
    q->n = q->samples = 0;
}

/* Asks for samples first to last of row j, all within the piece: `along` is taken to run evenly between them, as it does on
 * straight lines and nearly on others. They go into `to`, which is blank or has samples already. */
static void ask(mapper *m, const piece_frame *f, const piece_rows *r, int j, int first, int last, uint8_t *to)
{
    asked_rows *q = &m->asked;
    int n = last - first + 1;
    if (q->n == ROWS_ASKED || q->samples + n > SAMPLES_ASKED)
        shade_asked(m);
    double mm = m->page_mm;
    q->row[q->n] = (sample_row){.n = n, .along = r->along[j], .along_step = r->along_step[j],
                                .across = (r->u[j] + first * f->us) * m->strip_px, .across_step = f->us * m->strip_px,
                                .x = (f->x + first * f->step) * mm, .y = r->y[j] * mm, .step = f->step * mm};
    q->to[q->n++] = to + first;
    q->samples += n;
}

/* … one by one, each at its own place. */
static void ask_each(mapper *m, const piece_frame *f, piece_rows *r, int j, uint8_t *to)
{
    r->along_step[j] = 0;
    for (int i = r->first[j]; i <= r->last[j]; i++)
        if (plb_piece_owns(f, r, j, i)) {
            r->along[j] = plb_piece_along(f, r, j, i);
            ask(m, f, r, j, i, i, to);
        }
}

/* Puts rows of samples of a piece into the patch, the first one row number `row` of it. */
static void map_rows(mapper *m, const piece_frame *f, piece_rows *r, int row)
{
    int x = f->k->in.x0 - m->in.x0, n = m->samples;
    uint8_t *to = m->fine + (size_t)row * m->stride + (size_t)(x * n);
    for (int j = 0; j < r->n; j++, to += m->stride) {
        if (r->last[j] < r->first[j])
            continue;
        mark(m, (row + j) / n, x + r->first[j] / n, x + r->last[j] / n + 1);
        if (m->s->one_by_one)
            ask_each(m, f, r, j, to);
        else
            ask(m, f, r, j, r->first[j], r->last[j], to);
    }
}

/* Puts the piece's samples into the patch, which covers the piece. */
static void map_piece(mapper *m, const piece *k)
{
    piece_frame f = plb_piece_frame(k, m->samples, m->strip_px);
    piece_rows r; /* large: only what is used is set */
    int top = k->in.y0 < m->top ? m->top : k->in.y0, bottom = k->in.y1 > m->bottom ? m->bottom : k->in.y1;
    int from = (top - k->in.y0) * m->samples, to = (bottom - k->in.y0) * m->samples;
    for (int j = from; j < to; j += PIECE_ROWS) {
        plb_piece_rows(&f, j, to - j < PIECE_ROWS ? to - j : PIECE_ROWS, &r);
        map_rows(m, &f, &r, (k->in.y0 - m->in.y0) * m->samples + j);
    }
    shade_asked(m);
}

/* ---- from the path to pieces ---- */

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

/* Where the path turns back on itself, as in a scribble, the bisector runs nearly along the pieces and would let them
 * reach far beyond their ends: from this cosine of half the turn on they end straight. */
#define SHARPEST_HALF_TURN 0.6

static point joint_of(point bisector, point along)
{
    return point_dot(bisector, along) < SHARPEST_HALF_TURN ? along : bisector;
}

static piece piece_of(const mapper *m, const path_sample *from, const path_sample *to, double px, bool first, bool last)
{
    piece k = {.p0 = point_scale(from->at, px), .p1 = point_scale(to->at, px), .b0 = from->tangent, .b1 = to->tangent};
    point d = point_sub(k.p1, k.p0);
    k.length = plb_point_length(d);
    k.t = point_scale(d, 1 / k.length);
    k.s0 = from->along * px * m->strip_px;
    k.b0 = joint_of(k.b0, k.t);
    k.b1 = joint_of(k.b1, k.t);
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
    k.in.x0 = clamp_pixel(floor(fmin(k.p0.x, k.p1.x) - r));
    k.in.y0 = clamp_pixel(floor(fmin(k.p0.y, k.p1.y) - r));
    k.in.x1 = clamp_pixel(ceil(fmax(k.p0.x, k.p1.x) + r));
    k.in.y1 = clamp_pixel(ceil(fmax(k.p0.y, k.p1.y) + r));
    return k;
}

static bool fits(pixel_box b)
{
    return b.x1 - b.x0 <= PATCH_SIDE && b.y1 - b.y0 <= PATCH_SIDE;
}

/* Maps the papers' texture: each piece goes into the patch at once, which grows to the right and down only. */
static bool add_at_once(mapper *m, const piece *k)
{
    pixel_box both = unite(m->in, k->in);
    bool goes_on = m->in.x1 > m->in.x0 && both.x0 == m->in.x0 && both.y0 == m->in.y0 && fits(both) &&
                   (both.x1 - both.x0) * (both.y1 - both.y0) <= PATCH_AREA;
    if (!goes_on && !begin_next(m, k->in))
        return false;
    if (goes_on)
        grow_patch(m, both);
    map_piece(m, k);
    return true;
}

/* Makes a patch of the pieces that wait. */
static bool draw_waiting(mapper *m)
{
    if (m->n == 0)
        return true;
    if (!begin_next(m, m->wait))
        return false;
    for (int i = 0; i < m->n; i++)
        map_piece(m, &m->waiting[i]);
    m->n = 0;
    return true;
}

static bool add_piece(mapper *m, const piece *k)
{
    if (m->s->one_by_one)
        return add_at_once(m, k);
    if (m->n > 0 && (m->n == MAX_WAITING || !fits(unite(m->wait, k->in))) && !draw_waiting(m))
        return false;
    m->wait = m->n ? unite(m->wait, k->in) : k->in;
    m->waiting[m->n++] = *k;
    return true;
}

/* A piece whose bounds do not fit a patch goes in windows. */
static bool add_windows(mapper *m, piece k)
{
    pixel_box all = k.in;
    for (int y = all.y0; y < all.y1; y += PATCH_SIDE)
        for (int x = all.x0; x < all.x1; x += PATCH_SIDE) {
            k.in = intersect(all, (pixel_box){x, y, x + PATCH_SIDE, y + PATCH_SIDE});
            if (!add_piece(m, &k))
                return false;
        }
    return true;
}

/* Tells whether the samples between number i and number j of the path lie close to the line from one to the other. */
static bool is_straight(const path_sample *v, size_t i, size_t j, double stray)
{
    point d = point_sub(v[j].at, v[i].at);
    double most = stray * plb_point_length(d);
    for (size_t k = i + 1; k < j; k++)
        if (fabs(point_cross(d, point_sub(v[k].at, v[i].at))) > most)
            return false;
    return true;
}

/* Gives the sample that ends the piece which begins at sample i. */
static size_t end_of_piece(const mapper *m, const path_samples *path, size_t i)
{
    size_t j = i + 1;
    double longest = path->v[i].along + LONGEST_PIECE * m->page_mm;
    while (!m->s->one_by_one && j + 1 < path->n && path->v[j + 1].along <= longest && is_straight(path->v, i, j + 1, SAMPLE_STRAY * m->page_mm))
        j++;
    return j;
}

static bool add_path(mapper *m, const path_samples *path, bool closed, double px)
{
    for (size_t i = 0, j; i + 1 < path->n; i = j) {
        j = end_of_piece(m, path, i);
        if (path->v[i].at.x == path->v[j].at.x && path->v[i].at.y == path->v[j].at.y)
            continue; /* a piece without length has no direction */
        if (!add_windows(m, piece_of(m, path->v + i, path->v + j, px, i == 0 && !closed, j + 1 == path->n && !closed)))
            return false;
    }
    return draw_waiting(m) && flush(m);
}

/* Makes space for the samples of the largest patch, all zero; kept from stroke to stroke. */
static bool make_fine(map_buffer *buffer, size_t size)
{
    if (buffer->size >= size)
        return true;
    plb_free(buffer->fine);
    buffer->fine = plb_new(2 * size, 1); /* the second half: samples kept */
    buffer->size = buffer->fine ? size : 0;
    return buffer->fine != NULL;
}

bool plb_strip_map(const shading *s, const map_page *page, const path_samples *path, bool closed, map_buffer *buffer, patch_sink sink,
                   void *closure)
{
    double px = page->dpi / MM_PER_INCH, reach = STROKE_REACH_MM / MM_PER_INCH * s->dpi;
    bool all = page->top == page->bottom;
    shading within = *s;
    within.half_width = fmin(s->half_width, reach);
    within.beyond = fmin(s->beyond, reach);
    mapper m; /* large: not all of it is set here */
    m.s = &within;
    m.strip_px = s->dpi / page->dpi;
    m.page_mm = MM_PER_INCH / page->dpi;
    double n = s->whole_pixels ? 1 : floor(m.strip_px + 0.5); /* as dense as the texture, nearly */
    m.samples = n < 1 ? 1 : n > MAX_SAMPLES ? MAX_SAMPLES : (int)n;
    m.divisor = (uint32_t)(((1 << 18) + m.samples * m.samples - 1) / (m.samples * m.samples));
    m.half_width = within.half_width / m.strip_px;
    m.top = all ? INT_MIN : page->top;
    m.bottom = all ? INT_MAX : page->bottom;
    m.in = m.wait = (pixel_box){0};
    m.n = m.asked.n = m.asked.samples = 0;
    size_t side = (size_t)(PATCH_SIDE * m.samples);
    m.stride = side + ROWS_TOGETHER; /* what is done in whole blocks stays within the row */
    m.sink = sink;
    m.closure = closure;
    if (!make_fine(buffer, side * m.stride))
        return false;
    m.fine = buffer->fine;
    m.kept = buffer->fine + side * m.stride;
    return add_path(&m, path, closed, px);
}
