/* SPDX-License-Identifier: MIT
 *
 * This file takes a drawing from a file's bytes to strokes: read, fit to the page, plan.
 */
#include "api/pipeline.h"

#include "api/settings/page_fit.h"
#include "base/array.h"
#include "base/number/random.h"

#include <math.h>
#include <string.h>

/* Brings the drawing to the place on its page that the options ask for. */
static bool fit(display_list *list, const plb_options *o, error *err)
{
    page_fit fitted;
    if (!plb_page_fit(o, list->width, list->height, list->paper_scale, &fitted, err))
        return false;
    matrix m = plb_matrix_scale(fitted.factor, fitted.factor);
    m.x0 = fitted.x0;
    m.y0 = fitted.y0;
    if (fitted.factor != 1 || m.x0 != 0 || m.y0 != 0)
        plb_list_transform(list, m);
    list->width = fitted.width;
    list->height = fitted.height;
    return true;
}

/* Reports each kind of omission, so that nothing is left out silently. */
static void report_omissions(const plb_drawing *d, const omissions *left_out, const log_sink *say)
{
    plb_omissions_report(left_out, d->name, say);
    if (d->strokes.strokes.n == 0)
        plb_log(say, MESSAGE_WARNING, "%s: nothing in it leaves a mark: the page is empty", d->name);
}

/* Gives the strokes of each page identities of their own, so a line that two pages share is drawn in two ways. */
static void mark_page(stroke_list *s, unsigned number)
{
    for (size_t i = 0; number > 1 && i < s->strokes.n; i++)
        s->strokes.v[i].identity = random_fold(s->strokes.v[i].identity, number, 0);
}

typedef struct {
    const char *name;
    const log_sink *say;
} named_sink;

/* Adds the drawing's name to a message, because the plan knows no files. */
static void say_named(void *closure, message_level level, const char *text)
{
    const named_sink *to = closure;
    plb_log(to->say, level, "%s: %s", to->name, text);
}

/* Runs the stages in order, from the display list to strokes. */
static bool plan(plb_drawing *d, const log_sink *say, error *err)
{
    const plb_options *o = d->options;
    plan_options options = plb_api_plan_options(o);
    return fit(&d->list, o, err) && plb_api_plan_reduced(d, &options, say, err) && plb_api_report(o, PROGRESS_PLANNED, err);
}

bool plb_api_plan(plb_drawing *d, const log_sink *say, error *err)
{
    named_sink named = {d->name, say};
    log_sink to_named = {say_named, &named};
    error late = {ERROR_NONE, ""};
    omissions left_out = plb_list_count_omissions(&d->list);
    if (!plan(d, &to_named, &late))
        return plb_fail(err, late.kind, "%s: %s", d->name, late.text);
    mark_page(&d->strokes, (unsigned)d->options->page);
    report_omissions(d, &left_out, say);
    return true;
}

plb_drawing *plb_api_drawing_new(const char *name, const plb_options *o, error *err)
{
    plb_drawing *d = plb_new(1, sizeof *d);
    if (d) {
        plb_list_init(&d->list);
        d->reduction = 1;
        d->name = plb_new(strlen(name) + 1, 1);
        d->options = plb_options_copy(o);
    }
    if (d && d->name && d->options) {
        strcpy(d->name, name);
        return d;
    }
    plb_fail_memory(err);
    plb_drawing_free(d);
    return NULL;
}

plb_drawing *plb_api_draw(const input_source *in, const plb_options *o, error *err)
{
    plb_drawing *d = plb_api_drawing_new(in->name, o, err);
    if (d && plb_api_report(o, 0, err) && plb_input_read(in, &d->list, err) && plb_api_report(o, PROGRESS_READ, err) && plb_api_plan(d, &in->say, err))
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
    plb_profile_free(d->soft);
    plb_list_free(&d->list);
    plb_stroke_list_free(&d->strokes);
    plb_free(d->page_points);
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
