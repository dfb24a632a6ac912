/* SPDX-License-Identifier: MIT
 *
 * From a file's bytes to strokes: read, fit to the page, plan.
 */
#include "api/pipeline.h"

#include "api/pencil/tone.h"
#include "base/array.h"
#include "base/number/random.h"

#include <math.h>
#include <string.h>

/* Brings the drawing to the size that the options ask for. With both sides given it is fitted into them and centred. */
static bool fit(display_list *list, const plb_options *o, error *err)
{
    double sx = o->width / list->width, sy = o->height / list->height, f = o->scale > 0 ? o->scale / list->paper_scale : 1;
    if (o->width > 0 && o->height > 0)
        f = fmin(sx, sy);
    else if (o->width > 0 || o->height > 0)
        f = o->width > 0 ? sx : sy;
    double w = o->width > 0 ? o->width : list->width * f, h = o->height > 0 ? o->height : list->height * f;
    if (!(w > 0 && h > 0 && w <= 1e5 && h <= 1e5))
        return plb_fail(err, ERROR_LIMIT, "a page of %g by %g mm cannot be drawn", w, h);
    matrix m = plb_matrix_scale(f, f);
    m.x0 = (w - list->width * f) / 2;
    m.y0 = (h - list->height * f) / 2;
    if (f != 1 || m.x0 != 0 || m.y0 != 0)
        plb_list_transform(list, m);
    list->width = w;
    list->height = h;
    list->paper_scale *= f;
    return true;
}

/* Nothing is left out silently. */
static void report_omissions(const plb_drawing *d, const omissions *left_out, const log_sink *say)
{
    plb_omissions_report(left_out, d->name, say);
    if (d->strokes.strokes.n == 0)
        plb_log(say, MESSAGE_WARNING, "%s: nothing in it leaves a mark: the page is empty", d->name);
}

static bool set_name(plb_drawing *d, const char *name, error *err)
{
    d->name = plb_new(strlen(name) + 1, 1);
    if (!d->name)
        return plb_fail_memory(err);
    strcpy(d->name, name);
    return true;
}

/* The same line on two pages is drawn twice, so it differs. */
static void mark_page(stroke_list *s, unsigned number)
{
    for (size_t i = 0; number > 1 && i < s->strokes.n; i++)
        s->strokes.v[i].identity = random_fold(s->strokes.v[i].identity, number, 0);
}

/* The plan knows no files: what it says gets the drawing's name here. */
static void say_named(void *closure, message_level level, const char *text)
{
    const input_source *in = closure;
    plb_log(&in->say, level, "%s: %s", in->name, text);
}

static bool draw(plb_drawing *d, const input_source *in, const plb_options *o, error *err)
{
    if (!plb_input_read(in, &d->list, err) || !set_name(d, in->name, err))
        return false;
    plan_options how = plb_api_plan_options(o);
    log_sink named = {say_named, (void *)(uintptr_t)in};
    error late = {ERROR_NONE, ""};
    omissions left_out = plb_list_count_omissions(&d->list);
    if (!fit(&d->list, o, &late) || (plb_api_needs_tone(&d->list, &how) && !plb_api_measure_tone(o, &how, &late)) ||
        !plb_plan(&d->list, &how, &named, &d->strokes, &late))
        return plb_fail(err, late.kind, "%s: %s", d->name, late.text);
    mark_page(&d->strokes, (unsigned)o->page);
    report_omissions(d, &left_out, &in->say);
    return true;
}

plb_drawing *plb_api_draw(const input_source *in, const plb_options *o, error *err)
{
    plb_drawing *d = plb_new(1, sizeof *d);
    if (!d) {
        plb_fail_memory(err);
        return NULL;
    }
    plb_list_init(&d->list);
    d->options = plb_options_copy(o);
    if (d->options ? draw(d, in, o, err) : plb_fail_memory(err))
        return d;
    plb_drawing_free(d);
    return NULL;
}

void plb_drawing_free(plb_drawing *d)
{
    if (!d)
        return;
    plb_free(d->name);
    plb_options_free(d->options);
    plb_list_free(&d->list);
    plb_stroke_list_free(&d->strokes);
    plb_free(d);
}

double plb_drawing_width(const plb_drawing *d)
{
    return d->list.width;
}

double plb_drawing_height(const plb_drawing *d)
{
    return d->list.height;
}

size_t plb_drawing_strokes(const plb_drawing *d)
{
    return d->strokes.strokes.n;
}
