/* SPDX-License-Identifier: MIT
 *
 * A canvas is a display list in the making: a program's own drawing, without a file. A call that fails is remembered and told
 * at the end, so that a program need not look after each line.
 */
#include "api/pipeline.h"

#include "base/array.h"

#include <math.h>
#include <string.h>

struct plb_canvas {
    display_list list;
    path path;       /* at hand */
    item pen;        /* how the next item is painted; its path is empty */
    error failed;    /* the first failure */
};

/* A canvas begins with this paint and this pen. */
static item usual_pen(void)
{
    return (item){.paint = {PAINT_SOLID, 0, 0, 0, 1}, .clip = NO_CLIP, .width = 0.35};
}

plb_canvas *plb_canvas_new(double width, double height, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_canvas *c = NULL;
    if (!(width > 0 && height > 0 && width <= 1e5 && height <= 1e5))
        plb_fail(&err, ERROR_ARGUMENT, "a page of %g by %g mm cannot be drawn", width, height);
    else if (!(c = plb_new(1, sizeof *c)))
        plb_fail_memory(&err);
    if (c) {
        plb_list_init(&c->list);
        c->list.width = width;
        c->list.height = height;
        c->pen = usual_pen();
    }
    plb_api_finish(&err, failed);
    return c;
}

void plb_canvas_free(plb_canvas *c)
{
    if (!c)
        return;
    plb_list_free(&c->list);
    plb_path_free(&c->path);
    plb_item_free(&c->pen);
    plb_free(c);
}

/* ---- paths ---- */

/* Tells whether work goes on: nothing has failed, and the numbers are finite. */
static bool goes_on(plb_canvas *c, const double *v, int n)
{
    for (int i = 0; i < n; i++)
        if (!isfinite(v[i]))
            plb_fail(&c->failed, ERROR_ARGUMENT, "a coordinate is no number");
    return c->failed.kind == ERROR_NONE;
}

static void keep(plb_canvas *c, bool ok)
{
    if (!ok)
        plb_fail_memory(&c->failed);
}

/* A line or curve without a current point begins at its own first point, as in cairo. */
static bool has_begun(plb_canvas *c, point at)
{
    if (c->path.ops.n > 0)
        return true;
    keep(c, plb_path_move(&c->path, at));
    return false;
}

void plb_canvas_move_to(plb_canvas *c, double x, double y)
{
    if (goes_on(c, (double[]){x, y}, 2))
        keep(c, plb_path_move(&c->path, (point){x, y}));
}

void plb_canvas_line_to(plb_canvas *c, double x, double y)
{
    if (goes_on(c, (double[]){x, y}, 2) && has_begun(c, (point){x, y}))
        keep(c, plb_path_line(&c->path, (point){x, y}));
}

void plb_canvas_curve_to(plb_canvas *c, double x1, double y1, double x2, double y2, double x3, double y3)
{
    if (!goes_on(c, (double[]){x1, y1, x2, y2, x3, y3}, 6))
        return;
    has_begun(c, (point){x1, y1});
    keep(c, plb_path_curve(&c->path, (point){x1, y1}, (point){x2, y2}, (point){x3, y3}));
}

void plb_canvas_arc(plb_canvas *c, double x, double y, double radius, double from, double to)
{
    if (!goes_on(c, (double[]){x, y, radius, from, to}, 5))
        return;
    if (!(radius > 0 && fabs(to - from) <= 1e4))
        plb_fail(&c->failed, ERROR_ARGUMENT, "an arc needs a radius above 0 and at most some turns");
    else
        keep(c, plb_path_arc(&c->path, (point){x, y}, radius, from, to, to < from, MATRIX_IDENTITY));
}

void plb_canvas_close_path(plb_canvas *c)
{
    if (goes_on(c, NULL, 0) && c->path.ops.n > 0)
        keep(c, plb_path_close(&c->path));
}

/* ---- the pen ---- */

static bool is_share(double v) { return v >= 0 && v <= 1; }

void plb_canvas_set_colour(plb_canvas *c, double red, double green, double blue, double alpha)
{
    if (is_share(red) && is_share(green) && is_share(blue) && is_share(alpha))
        c->pen.paint = (paint){PAINT_SOLID, red, green, blue, alpha};
    else
        plb_fail(&c->failed, ERROR_ARGUMENT, "the parts of a colour are 0 to 1");
}

void plb_canvas_set_width(plb_canvas *c, double mm)
{
    if (mm >= 0 && mm <= 1000)
        c->pen.width = mm;
    else
        plb_fail(&c->failed, ERROR_ARGUMENT, "a line's width is 0 to 1000 mm");
}

void plb_canvas_set_cap(plb_canvas *c, plb_cap cap)
{
    static const line_cap caps[] = {[PLB_CAP_BUTT] = LINE_CAP_BUTT, [PLB_CAP_ROUND] = LINE_CAP_ROUND, [PLB_CAP_SQUARE] = LINE_CAP_SQUARE};
    if (cap <= PLB_CAP_SQUARE)
        c->pen.cap = caps[cap];
    else
        plb_fail(&c->failed, ERROR_ARGUMENT, "there is no such cap");
}

void plb_canvas_set_even_odd(plb_canvas *c, bool even_odd)
{
    c->pen.even_odd = even_odd;
}

void plb_canvas_set_dash(plb_canvas *c, const double *mm, size_t n, double offset)
{
    double sum = 0;
    bool sane = isfinite(offset) && n <= 1000;
    for (size_t i = 0; sane && i < n; i++) {
        sane = mm[i] >= 0 && mm[i] <= 1e5;
        sum += mm[i];
    }
    if (!sane || (n > 0 && !(sum > 0))) {
        plb_fail(&c->failed, ERROR_ARGUMENT, "dashes are lengths of 0 to 100 m, and not all 0");
        return;
    }
    size_t all = n % 2 ? 2 * n : n; /* an odd count is gone through twice */
    c->pen.dash.n = 0;
    if (!array_reserve(&c->pen.dash, all)) {
        plb_fail_memory(&c->failed);
        return;
    }
    for (size_t i = 0; i < all; i++)
        c->pen.dash.v[c->pen.dash.n++] = mm[i % n];
    c->pen.dash_offset = offset;
}

/* ---- painting ---- */

/* Makes an item with the pen's paint and a copy of its dashes. */
static bool copy_pen(const plb_canvas *c, item_kind kind, item *it)
{
    *it = c->pen;
    it->kind = kind;
    memset(&it->dash, 0, sizeof it->dash);
    if (kind != ITEM_STROKE || c->pen.dash.n == 0)
        return true;
    if (!array_reserve(&it->dash, c->pen.dash.n))
        return false;
    memcpy(it->dash.v, c->pen.dash.v, c->pen.dash.n * sizeof *it->dash.v);
    it->dash.n = c->pen.dash.n;
    return true;
}

/* Makes an item of the current path, which is empty afterwards. */
static void add_item(plb_canvas *c, item_kind kind)
{
    item it;
    if (c->failed.kind != ERROR_NONE || c->path.ops.n == 0)
        return;
    if (!copy_pen(c, kind, &it)) {
        plb_fail_memory(&c->failed);
        return;
    }
    it.path = c->path;
    memset(&c->path, 0, sizeof c->path);
    if (!plb_list_add(&c->list, &it, &c->failed))
        plb_item_free(&it);
}

void plb_canvas_stroke(plb_canvas *c)
{
    add_item(c, ITEM_STROKE);
}

void plb_canvas_fill(plb_canvas *c)
{
    add_item(c, ITEM_FILL);
}

void plb_canvas_clip(plb_canvas *c)
{
    clip k = {.path = c->path, .even_odd = c->pen.even_odd, .parent = c->pen.clip};
    if (c->failed.kind != ERROR_NONE)
        return;
    memset(&c->path, 0, sizeof c->path);
    if (!plb_list_add_clip(&c->list, &k, &c->pen.clip, &c->failed))
        plb_path_free(&k.path);
}

void plb_canvas_reset_clip(plb_canvas *c)
{
    c->pen.clip = NO_CLIP;
}

/* ---- the drawing ---- */

/* Moves the items on the canvas into the drawing; the page and the pen stay. */
static void hand_over(plb_canvas *c, plb_drawing *d)
{
    d->list = c->list;
    plb_list_init(&c->list);
    c->list.width = d->list.width;
    c->list.height = d->list.height;
    c->pen.clip = NO_CLIP;
    plb_path_clear(&c->path);
}

plb_drawing *plb_canvas_draw(plb_canvas *c, const plb_options *given, plb_error *failed)
{
    error err = c->failed;
    plb_options *own = NULL;
    const plb_options *o = err.kind == ERROR_NONE ? plb_api_options_checked(given, &own, &err) : NULL;
    plb_drawing *d = o ? plb_api_drawing_new("canvas", o, &err) : NULL;
    if (d) {
        api_adaptor adaptor = {o->message, o->message_closure};
        log_sink say = plb_api_messenger(&adaptor);
        hand_over(c, d);
        if (!plb_api_plan(d, &say, &err)) {
            plb_drawing_free(d);
            d = NULL;
        }
    }
    plb_options_free(own);
    plb_api_finish(&err, failed);
    return d;
}
