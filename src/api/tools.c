/* SPDX-License-Identifier: MIT
 *
 * What a call draws with: the pencil's tables, the graphite's, the arm.
 */
#include "api/drawing.h"

#include <string.h>

#define DEFAULT_PENCIL "HB"

bool plb_api_tools_init(drawing_tools *t, const plb_options *o, error *err)
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
    t->pencil = plb_pencil_new(t->profile->p, err);
    if (!t->pencil) {
        plb_api_tools_free(t);
        return false;
    }
    plb_graphite_init(&t->ink, t->profile->p);
    t->stroke = (stroke_options){.pencil = t->pencil, .seed = o->seed, .squiggle = o->squiggle, .dpi = o->dpi};
    t->stroke.arm = o->arm == PLB_ARM_SPRING ? ARM_SPRING : ARM_JERK;
    return true;
}

void plb_api_tools_free(drawing_tools *t)
{
    plb_pencil_free(t->pencil);
    plb_profile_free(t->own);
    t->pencil = NULL;
    t->own = NULL;
}
