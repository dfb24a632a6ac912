/* SPDX-License-Identifier: MIT
 *
 * See shade.h. A person who comes to a dark that the pencil cannot make takes a softer one.
 */
#include "api/pencil/shade.h"

#include "api/pencil/tone.h"
#include "plan/hatch/hatch_lines.h"
#include "plan/hatch/hatch_tone.h"
#include "plan/tone/tone_curve.h"

/* A pencil is soft enough for a dark that it misses by no more than this (chosen by eye: a softer one than needed looks harsh beside the others). */
#define MISSED 0.05
/* A pencil that goes darker by less than this is not worth the change (chosen by eye). */
#define WORTH 0.02

/* Tells whether the fill is an area, in *area: no letter, arrowhead or mark, which asks for no other pencil. */
static bool is_area(const item *fill, double width, bool *area, error *err)
{
    shape s;
    bool solid = true, ok = plb_shape_init(&s, fill, err) && plb_is_solid(&s, width, &solid, err);
    *area = !solid;
    plb_shape_free(&s);
    return ok;
}

/* Finds the darkest of all areas. */
static bool find_darkest(const display_list *list, const plan_options *options, double *darkest, error *err)
{
    tone_curve plain = plb_tone_curve_plain();
    *darkest = 0;
    for (size_t i = 0; i < list->items.n; i++) {
        const item *it = &list->items.v[i];
        tone_source t = plb_tone_source(list, it, options, &plain, false);
        double here = it->kind == ITEM_FILL && plb_may_be_hatched(it, options) ? plb_darkest(&t) : 0;
        bool area = false;
        if (here > *darkest && !is_area(it, options->shade_width, &area, err))
            return false;
        *darkest = area ? here : *darkest;
    }
    return true;
}

/* Gives the index of the hardest grade that is soft enough for this dark, else of the softest. */
static size_t grade_for(double darkness)
{
    size_t i = 0;
    for (; plb_api_tone_of_grade(i + 1); i++) {
        plan_options of_grade = {.tone = *plb_api_tone_of_grade(i)};
        if (plb_tone_within_reach(darkness, &of_grade) >= darkness - MISSED)
            break;
    }
    return i;
}

static plb_profile *load(const plb_options *o, double darkest, error *err)
{
    plb_error failed;
    plb_profile *soft = plb_profile_load(plb_pencil_name(o->shade >= SHADE_GRADES ? (size_t)(o->shade - SHADE_GRADES) : grade_for(darkest)), &failed);
    if (!soft)
        plb_fail(err, ERROR_MEMORY, "%s", failed.text);
    return soft;
}

bool plb_api_find_soft(const plb_options *o, const display_list *list, plan_options *options, plb_profile **soft, error *err)
{
    double reach = options->tone.darkness[TONE_STEPS - 1];
    *soft = NULL;
    if (o->shade == SHADE_SAME || o->colour || options->fill != FILL_HATCH || !plb_model_at((size_t)o->model)->is_measured)
        return true;
    plan_options with = *options;
    with.soft_width = 1; /* is there one that reaches everything, is it asked for? */
    with.soft_tone.darkness[TONE_STEPS - 1] = 1;
    double darkest;
    if (!find_darkest(list, options, &darkest, err))
        return false;
    if (!plb_is_soft_tone(darkest, &with))
        return true;
    plb_profile *found = load(o, darkest, err);
    plb_options other = *o; /* borrows all, but draws with the pencil that was found */
    other.profile = found;
    with.shade_width = found ? plb_profile_width(found) : with.shade_width;
    if (!found || !plb_api_find_tone(&other, &with, err)) {
        plb_profile_free(found);
        return false;
    }
    if (with.tone.darkness[TONE_STEPS - 1] < reach + WORTH) {
        plb_profile_free(found);
        return true;
    }
    options->soft_width = plb_profile_width(found);
    options->soft_tone = with.tone;
    *soft = found;
    return true;
}
