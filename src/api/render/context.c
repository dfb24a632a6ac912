/* SPDX-License-Identifier: MIT
 *
 * Makes what a call draws with: the pencil's tables, the graphite's, the arm.
 */
#include "api/pipeline.h"

#include "api/pencil/pencils.h"
#include "api/settings/page_fit.h"
#include "base/geometry/interpolate.h"
#include "plan/habits/habits.h"
#include "system/thread_team.h"

#include <math.h>
#include <string.h>

const plb_options *plb_api_options_for(const plb_drawing *d, const plb_options *given, plb_options *out, error *err)
{
    *out = given ? *given : *d->options;
    bool ok = (!given || (plb_api_check(given, err) && plb_api_check_same(given, d->options, d->name, err))) &&
              plb_page_dpi(out, d->list.width, d->list.height, &out->dpi, err);
    return ok ? out : NULL;
}

const plb_options *plb_api_options_checked(const plb_options *given, plb_options **own, error *err)
{
    *own = given ? NULL : plb_options_new();
    const plb_options *o = given ? given : *own;
    if (!o)
        plb_fail_memory(err);
    return o && plb_api_check(o, err) ? o : NULL;
}

bool plb_api_context_init(render_context *t, const plb_options *o, error *err)
{
    memset(t, 0, sizeof *t);
    t->profile = o->profile;
    const line_model *model = plb_model_at((size_t)o->model);
    t->pencil = plb_api_pencil(t->profile, model, (paper_kind)o->paper, err);
    if (!t->pencil)
        return false;
    plb_graphite_init(&t->ink, t->profile->p);
    t->stroke = (stroke_options){.pencil = t->pencil, .seed = o->seed, .squiggle = o->squiggle, .hand = t->profile->p->hand, .dpi = o->dpi, .pressure = o->pressure};
    t->stroke.handed = (handedness)o->handed;
    t->stroke.model = model;
    t->stroke.arm = o->arm == ARM_AUTO ? NULL : plb_arm_at((size_t)o->arm);
    return true;
}

/* A sharp point draws lines this broad, mm: hard leads as four writers of hdBPMN drew them, 3 px at 300 dpi; soft ones, whose own
 * lines are the broadest that the eight grades have, a little more, because they crumble (chosen by eye). */
#define SHARP_MM 0.25
#define SHARP_SOFT_MM 0.3
#define HARD_LINE_MM 0.42
#define SOFT_LINE_MM 0.64

double plb_api_point(const plb_options *o)
{
    double width = plb_profile_width(o->profile), soft = clamp((width - HARD_LINE_MM) / (SOFT_LINE_MM - HARD_LINE_MM), 0, 1);
    bool is_sharp = o->point == POINT_SHARP && plb_model_at((size_t)o->model)->is_measured;
    return is_sharp ? fmin((SHARP_MM + (SHARP_SOFT_MM - SHARP_MM) * soft) / width, 1) : 1;
}

bool plb_api_context_for(render_context *t, const plb_drawing *d, const plb_options *o, error *err)
{
    bool ok = plb_api_context_init(t, o, err);
    t->stroke.dpi /= d->reduction;
    return ok;
}

plan_options plb_api_plan_options(const plb_options *o)
{
    plan_options plan = plb_plan_options_default();
    plan.text = (text_style)o->text;
    plan.lettering = (lettering_style)o->lettering;
    plan.fill = (fill_style)o->fill;
    plan.is_touched = plb_model_at((size_t)o->model)->is_measured;
    plan.is_free = plan.is_touched && o->squiggle != 0;
    plan.point = plb_api_point(o);
    plan.shade_width = plb_profile_width(o->profile);
    plan.pencil_width = plan.shade_width * fmin(plan.point * plb_wear_mean(&plan), 1);
    plan.max_length = 1000 * o->limit_length;
    plan.ruler = (ruler_use)o->ruler;
    plan.overshoot = o->overshoot;
    plan.restate = o->restate;
    plan.construction = o->construction;
    plan.seed = o->seed;
    plan.threads = o->threads > 0 ? o->threads : plb_thread_team_processors();
    plan.colour = o->colour;
    return plan;
}
