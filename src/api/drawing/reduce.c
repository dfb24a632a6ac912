/* SPDX-License-Identifier: MIT
 *
 * The reduction: the hand works on a sheet that is larger than the page, with a pencil as broad as ever, and what it draws is
 * reduced to the page, as illustrators do with what is too small for a pencil. All that the plan and the strokes know is
 * the sheet. Pixels of the page are larger there, and what leaves the library as a place is taken back to the page.
 */
#include "api/pencil/shade.h"
#include "api/pencil/tone.h"
#include "api/pipeline.h"

#include "base/array.h"
#include "plan/reduction/reduction.h"

/* Says how large the sheet is, and how large lettering, lines and small shapes need it to be where they decide. */
static void tell(const plb_drawing *d, const reduction_needs *needs, const log_sink *say)
{
    char why[96] = "as asked for";
    if (needs)
        snprintf(why, sizeof why, "lettering needs %.2g, lines %.2g, small shapes %.2g", needs->lettering, needs->lines, needs->shapes);
    plb_log(say, MESSAGE_DETAIL, "reduction %g: the hand works on a sheet of %.4g by %.4g mm (%s)", d->reduction, d->reduction * d->list.width,
            d->reduction * d->list.height, why);
}

/* Plans the strokes of the sheet, once the tones that its fills ask for are known, and the pencils that make them. */
static bool plan_sheet(plb_drawing *d, const display_list *sheet, plan_options options, const log_sink *say, error *err)
{
    const plb_options *o = d->options;
    plb_profile_free(d->soft);
    d->soft = NULL;
    if (plb_api_needs_tone(sheet, &options) && !(plb_api_find_tone(o, &options, err) && plb_api_find_soft(o, sheet, &options, &d->soft, err)))
        return false;
    if (d->soft)
        plb_log(say, MESSAGE_DETAIL, "what is too dark for %s is shaded with %s", plb_profile_name(o->profile), plb_profile_name(d->soft));
    return plb_plan(sheet, &options, say, &d->strokes, err);
}

/* Plans on a sheet `factor` times as large as the page. */
static bool plan_at(plb_drawing *d, double factor, const plan_options *options, const log_sink *say, error *err)
{
    display_list sheet;
    plan_options of_sheet = *options;
    d->reduction = of_sheet.reduction = factor;
    if (factor <= 1)
        return plan_sheet(d, &d->list, of_sheet, say, err);
    bool ok = plb_list_enlarged(&sheet, &d->list, factor, err) && plan_sheet(d, &sheet, of_sheet, say, err);
    plb_list_free(&sheet);
    return ok;
}

/* Takes the strokes' points to the page. */
static bool place_on_page(plb_drawing *d, error *err)
{
    const point *from = d->strokes.points.v;
    size_t n = d->strokes.points.n;
    if (d->reduction <= 1)
        return true;
    d->page_points = plb_new(n + 1, sizeof *d->page_points);
    for (size_t i = 0; d->page_points && i < n; i++)
        d->page_points[i] = point_scale(from[i], 1 / d->reduction);
    return d->page_points || plb_fail_memory(err);
}

bool plb_api_plan_reduced(plb_drawing *d, const plan_options *options, const log_sink *say, error *err)
{
    reduction_needs needs = {0};
    double asked = d->options->reduction;
    if (!(asked > 0) && !plb_plan_reduction(&d->list, options, &needs, err))
        return false;
    bool ok = plan_at(d, asked > 0 ? asked : needs.factor, options, say, err);
    /* A drawing that its own size lets be drawn is never refused because a larger sheet needs too much pencil. */
    if (!ok && !(asked > 0) && d->reduction > 1 && err->kind == ERROR_LIMIT) {
        plb_log(say, MESSAGE_WARNING, "%s on a sheet %g times larger: the drawing is not reduced", err->text, d->reduction);
        *err = (error){ERROR_NONE, ""};
        ok = plan_at(d, 1, options, say, err);
    } else if (ok)
        tell(d, asked > 0 ? NULL : &needs, say);
    return ok && place_on_page(d, err);
}

stroke_list plb_api_strokes_on_page(const plb_drawing *d)
{
    stroke_list on_page = d->strokes;
    on_page.width = d->list.width;
    on_page.height = d->list.height;
    if (d->page_points)
        on_page.points.v = d->page_points;
    return on_page;
}
