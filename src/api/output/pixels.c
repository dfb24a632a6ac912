/* SPDX-License-Identifier: MIT
 *
 * Draws a part of the page into pixels of the caller's.
 */
#include "api/render/render.h"

#include "base/array.h"

#include <string.h>

typedef struct {
    const plb_pixels *to;
    page_background background;
    int right;    /* column of the page behind the last one wanted */
    int channels; /* of the page's rows … */
    int wanted;   /* … and of the caller's */
    uint8_t *row;
} pixel_target;

/* Converts pixels of the page to the caller's format: grey becomes red, green and blue; pixels without alpha are opaque. */
static void convert(const pixel_target *t, const uint8_t *from, uint8_t *to, int n)
{
    bool grey = t->channels < PIGMENT_PLANES, wants_grey = t->wanted < PIGMENT_PLANES;
    for (int x = 0; x < n; x++, from += t->channels, to += t->wanted) {
        for (int k = 0; k < (wants_grey ? 1 : PIGMENT_PLANES); k++)
            to[k] = from[grey ? 0 : k];
        if (t->wanted % 2 == 0)
            to[t->wanted - 1] = t->channels % 2 ? 255 : from[t->channels - 1];
    }
}

static bool copy_band(void *closure, const page *band, error *err)
{
    const pixel_target *t = closure;
    const plb_pixels *to = t->to;
    (void)err;
    int left = to->x > 0 ? to->x : 0;
    for (int y = band->top; y < band->top + band->rows; y++) {
        uint8_t *out = (uint8_t *)to->data + (size_t)(y - to->y) * to->stride + (size_t)(left - to->x) * (size_t)t->wanted;
        plb_page_row(band, t->background, y, t->row);
        convert(t, t->row + (size_t)left * (size_t)t->channels, out, t->right - left);
    }
    return true;
}

static bool check_pixels(const plb_pixels *to, const plb_options *o, error *err)
{
    if (!to->data || to->width < 1 || to->height < 1 || to->x < -1000000 || to->y < -1000000 || to->width > 1000000 || to->height > 1000000 || to->format > PLB_PIXELS_RGBA ||
        to->stride < (size_t)to->width * (size_t)(to->format + 1))
        return plb_fail(err, ERROR_ARGUMENT, "the pixels need a format, a size and a stride of at least a row");
    if (o->colour && to->format < PLB_PIXELS_RGB)
        return plb_fail(err, ERROR_ARGUMENT, "grey pixels hold no colours");
    return true;
}

static bool render(const plb_drawing *d, const plb_pixels *to, const plb_options *o, error *err)
{
    render_context t;
    page_plan plan;
    if (!check_pixels(to, o, err) || !plb_api_context_for(&t, d, o, err) || !plb_page_plan(d, o, &plan, err))
        return false;
    int wanted = (int)to->format + 1, bottom = to->y + to->height, right = to->x + to->width;
    page_background background = wanted % 2 == 0 || o->background == PAGE_PAPER ? (page_background)o->background : PAGE_WHITE;
    pixel_target target = {to, background, right < plan.width ? right : plan.width, plb_page_channels(background, o->colour), wanted, NULL};
    plan.height = bottom < plan.height ? bottom : plan.height;
    plan.top = to->y > 0 ? to->y : 0;
    if (plan.top >= plan.height || target.right <= 0 || to->x >= plan.width)
        return true; /* beside the page */
    plb_page_plan_rows(&plan, 1);
    target.row = plb_new((size_t)plan.width, (size_t)target.channels);
    bool ok = target.row ? plb_render(d, o, &t, &plan, copy_band, &target, err) : plb_fail_memory(err);
    plb_free(target.row);
    return ok;
}

bool plb_drawing_render_pixels(const plb_drawing *d, const plb_pixels *to, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const plb_options *o = plb_api_options_for(d, given, &(plb_options){0}, &err);
    if (o)
        render(d, to, o, &err);
    return plb_api_finish(&err, failed);
}

bool plb_drawing_size(const plb_drawing *d, int *width, int *height, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    page_plan plan = {0};
    const plb_options *o = plb_api_options_for(d, given, &(plb_options){0}, &err);
    if (o)
        plb_page_plan(d, o, &plan, &err);
    *width = plan.width;
    *height = plan.height;
    return plb_api_finish(&err, failed);
}
