/* SPDX-License-Identifier: MIT
 *
 * Fits the drawing to its page (page_fit.h). A page is given by name, by both sides, by one, or by nothing; a picture
 * of WxH pixels gives its shape to a page that is not given.
 */
#include "api/settings/page_fit.h"

#include "base/number/units.h"

#include <math.h>

#define MAX_SIDE 1e5 /* mm */

typedef struct {
    double width, height; /* mm; 0: not given */
} page_sides;

/* A named page lies like the drawing, upright or across, unless its name says portrait or landscape. */
static page_sides named_page(const page_choice *p, bool is_wide)
{
    bool turned = p->turn == PAGE_LANDSCAPE || (p->turn == PAGE_AS_DRAWN && is_wide);
    return turned ? (page_sides){p->height, p->width} : (page_sides){p->width, p->height};
}

/* Makes a page with the shape of the picture: around a side that is given, else around the drawing, which is `w` by `h` with margins. */
static page_sides shaped_page(const plb_options *o, double w, double h)
{
    double shape = (double)o->pixels.width / o->pixels.height;
    if (o->width > 0)
        return (page_sides){o->width, o->width / shape};
    if (o->height > 0)
        return (page_sides){o->height * shape, o->height};
    return w > h * shape ? (page_sides){w, w / shape} : (page_sides){h * shape, h};
}

bool plb_page_fit(const plb_options *o, double width, double height, double paper_scale, page_fit *out, error *err)
{
    double f = o->scale > 0 ? o->scale / paper_scale : 1, margins = 2 * o->margin;
    page_sides page = {o->width, o->height};
    if (o->page_size.width > 0)
        page = named_page(&o->page_size, width > height);
    else if (o->pixels.height > 0 && !(page.width > 0 && page.height > 0))
        page = shaped_page(o, width * f + margins, height * f + margins);
    /* Scales the drawing so that it fills the sides that are given, or keeps its scale where none is. */
    double sx = (page.width - margins) / width, sy = (page.height - margins) / height;
    if ((page.width > 0 && !(sx > 0)) || (page.height > 0 && !(sy > 0)))
        return plb_fail(err, ERROR_ARGUMENT, "margins of %g mm leave nothing of the page", o->margin);
    bool keeps_scale = o->scale > 0 || (o->page_size.width <= 0 && o->width <= 0 && o->height <= 0);
    if (!keeps_scale)
        f = page.width > 0 && page.height > 0 ? fmin(sx, sy) : page.width > 0 ? sx : sy;
    double w = page.width > 0 ? page.width : width * f + margins, h = page.height > 0 ? page.height : height * f + margins;
    if (!(w > 0 && h > 0 && w <= MAX_SIDE && h <= MAX_SIDE))
        return plb_fail(err, ERROR_LIMIT, "a page of %g by %g mm cannot be drawn", w, h);
    *out = (page_fit){w, h, f, (w - width * f) / 2, (h - height * f) / 2};
    return true;
}

bool plb_page_dpi(const plb_options *o, double width, double height, double *dpi, error *err)
{
    *dpi = o->dpi;
    if (o->pixels.width <= 0)
        return true;
    double across = o->pixels.width * MM_PER_INCH / width, down = o->pixels.height * MM_PER_INCH / height;
    *dpi = o->pixels.height > 0 ? fmin(across, down) : across;
    const plb_setting *row = &plb_setting_find("dpi")->shown;
    return (*dpi >= row->min && *dpi <= row->max) ||
           plb_fail(err, ERROR_ARGUMENT, "pixels ask for %.3g pixels per inch on a page of %.4g by %.4g mm; %g to %g can be drawn", *dpi, width, height, row->min, row->max);
}
