/* SPDX-License-Identifier: MIT
 *
 * Defaults of the drawing options, their check, and what they mean for the plan.
 */
#include "api/pipeline.h"

#include "system/thread_team.h"
#include "system/process.h"

#include <math.h>
#include <string.h>

plb_options plb_options_default(void)
{
    plb_options o;
    memset(&o, 0, sizeof o);
    o.seed = 1;
    o.model = PLB_MODEL_GRAPHITE;
    o.squiggle = -1; /* the arm's own */
    o.dpi = 300;
    o.pressure = 1;
    o.compress = 1;
    o.limit_time = PROCESS_LIMITS.seconds;
    o.limit_memory = (double)(PROCESS_LIMITS.memory >> 20);
    return o;
}

bool plb_api_check(const plb_options *o, error *err)
{
    if (!(o->dpi >= 10 && o->dpi <= 4800))
        return plb_fail(err, ERROR_ARGUMENT, "the resolution must be 10 to 4800 dpi");
    if (o->paper > PLB_PAPER_NONE)
        return plb_fail(err, ERROR_ARGUMENT, "there is no such paper");
    if (!(o->pressure >= 0.2 && o->pressure <= 3))
        return plb_fail(err, ERROR_ARGUMENT, "the pressure must be 0.2 to 3 times the usual");
    if (!(o->scale >= 0 && o->scale <= 1e4))
        return plb_fail(err, ERROR_ARGUMENT, "the scale must be at most 10000");
    if (!(o->width >= 0 && o->height >= 0 && o->width <= 1e5 && o->height <= 1e5))
        return plb_fail(err, ERROR_ARGUMENT, "the page's size must be at most 100 m");
    if (o->threads < 0 || o->threads > THREAD_TEAM_MAX || o->compress < 0 || o->compress > 9)
        return plb_fail(err, ERROR_ARGUMENT, "threads must be 0 to %d, the compression 0 to 9", THREAD_TEAM_MAX);
    if (!(o->squiggle <= 1000))
        return plb_fail(err, ERROR_ARGUMENT, "the squiggle must be at most 1 m");
    if (!(o->limit_time >= 1 && o->limit_time <= 1e6 && o->limit_memory >= 64 && o->limit_memory <= 1e6))
        return plb_fail(err, ERROR_ARGUMENT, "the limits must be 1 to 1e6 seconds and 64 to 1e6 MiB");
    if (!plb_model_at(o->model) || (o->arm != PLB_ARM_DEFAULT && !plb_arm_at(o->arm - 1u)) || o->background > PLB_BACKGROUND_NONE || o->handed > PLB_HAND_NONE)
        return plb_fail(err, ERROR_ARGUMENT, "there is no such model, arm, hand or background");
    if (!(o->overshoot >= 0 && o->overshoot <= 100 && o->restate >= 0 && o->restate <= 1))
        return plb_fail(err, ERROR_ARGUMENT, "lines run past corners by 0 to 100 mm, and a share of 0 to 1 is drawn twice");
    if (o->fill > PLB_FILL_NONE || o->text > PLB_TEXT_NONE)
        return plb_fail(err, ERROR_ARGUMENT, "there is no such way with fills or text");
    return true;
}

static double width_of(const plb_options *o)
{
    return o->profile ? plb_profile_width(o->profile) : plb_plan_options_default().pencil_width;
}

plan_options plb_api_plan_options(const plb_options *o)
{
    static const fill_style fills[] = {[PLB_FILL_HATCH] = FILL_HATCH, [PLB_FILL_OUTLINE] = FILL_OUTLINE, [PLB_FILL_NONE] = FILL_NONE};
    static const text_style texts[] = {[PLB_TEXT_HAND] = TEXT_HAND, [PLB_TEXT_OUTLINE] = TEXT_OUTLINE, [PLB_TEXT_NONE] = TEXT_NONE};
    plan_options how = plb_plan_options_default();
    how.text = texts[o->text];
    how.fill = fills[o->fill];
    how.pencil_width = width_of(o);
    how.overshoot = o->overshoot;
    how.restate = o->restate;
    how.construction = o->construction;
    how.seed = o->seed;
    how.threads = o->threads > 0 ? o->threads : plb_thread_team_processors();
    how.colour = o->colour;
    return how;
}
