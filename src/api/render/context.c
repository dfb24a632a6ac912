/* SPDX-License-Identifier: MIT
 *
 * What a call draws with: the pencil's tables, the graphite's, the arm.
 */
#include "api/pipeline.h"

#include "api/pencil/pencils.h"

#include <string.h>

#define DEFAULT_PENCIL "HB"

bool plb_api_context_init(render_context *t, const plb_options *o, error *err)
{
    memset(t, 0, sizeof *t);
    if (!plb_api_check(o, err))
        return false;
    t->profile = o->profile;
    if (!t->profile) {
        plb_error failed = {PLB_OK, ""};
        t->profile = t->own = plb_profile_load(DEFAULT_PENCIL, &failed);
        if (!t->own)
            return plb_fail(err, (error_kind)failed.status, "%s", failed.text);
    }
    static const paper_kind papers[] = {PAPER_MEDIUM, PAPER_SMOOTH, PAPER_ROUGH, PAPER_NONE};
    const line_model *model = plb_model_at(o->model);
    t->pencil = plb_api_pencil(t->profile, model, papers[o->paper], err);
    if (!t->pencil) {
        plb_api_context_free(t);
        return false;
    }
    plb_graphite_init(&t->ink, t->profile->p);
    t->stroke = (stroke_options){.pencil = t->pencil, .seed = o->seed, .squiggle = o->squiggle, .hand = t->profile->p->hand, .dpi = o->dpi, .pressure = o->pressure};
    static const handedness handed[] = {HANDED_RIGHT, HANDED_LEFT, HANDED_NONE};
    t->stroke.handed = handed[o->handed];
    t->stroke.model = model;
    t->stroke.arm = o->arm == PLB_ARM_DEFAULT ? NULL : plb_arm_at(o->arm - 1u); /* plb_arm numbers the table's rows from 1 */
    return true;
}

void plb_api_context_free(render_context *t)
{
    plb_profile_free(t->own); /* and its pencils */
    t->pencil = NULL;
    t->own = NULL;
}
