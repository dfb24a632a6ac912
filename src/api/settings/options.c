/* SPDX-License-Identifier: MIT
 *
 * Makes the options of a call, changes them by name and checks them. Their defaults are those of the table.
 */
#include "api/settings/settings.h"

#include "api/api_internal.h"
#include "base/array.h"

#include <stdio.h>
#include <string.h>

plb_options *plb_options_new(void)
{
    plb_options *o = plb_new(1, sizeof *o);
    const setting *s;
    for (size_t i = 0; o && (s = plb_setting_row(i)); i++)
        if (!plb_setting_store(s, o, s->shown.usual, NULL)) {
            plb_options_free(o);
            o = NULL;
        }
    return o;
}

plb_options *plb_options_copy(const plb_options *from)
{
    plb_options *o = plb_new(1, sizeof *o);
    if (!o)
        return NULL;
    *o = *from;
    o->profile = plb_api_profile_share(from->profile);
    o->helper_dir = from->helper_dir ? plb_new(strlen(from->helper_dir) + 1, 1) : NULL;
    if (o->helper_dir)
        strcpy(o->helper_dir, from->helper_dir);
    if (!o->helper_dir == !from->helper_dir)
        return o;
    plb_options_free(o);
    return NULL;
}

void plb_options_free(plb_options *o)
{
    if (!o)
        return;
    plb_profile_free(o->profile);
    plb_free(o->helper_dir);
    plb_free(o);
}

/* ---- by name ---- */

/* Fails, and names the setting that was probably meant. */
static void refuse_name(const char *name, error *err)
{
    const char *nearest = NULL;
    size_t least = PLB_NAME_FAR;
    const setting *s;
    for (size_t i = 0; (s = plb_setting_row(i)); i++) {
        size_t away = plb_name_distance(s->shown.name, name, strlen(name));
        if (away < least) {
            least = away;
            nearest = s->shown.name;
        }
    }
    if (nearest)
        plb_fail(err, ERROR_ARGUMENT, "unknown setting '%.80s'; did you mean '%s'?", name, nearest);
    else
        plb_fail(err, ERROR_ARGUMENT, "unknown setting '%.80s'", name);
}

static const setting *find(const char *name, error *err)
{
    const setting *s = plb_setting_find(name);
    if (!s)
        refuse_name(name, err);
    return s;
}

bool plb_options_set(plb_options *o, const char *name, const char *value, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const setting *s = find(name, &err);
    if (s)
        plb_setting_store(s, o, value, &err);
    return plb_api_finish(&err, failed);
}

bool plb_options_set_number(plb_options *o, const char *name, double value, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const setting *s = find(name, &err);
    bool is_double = s && (s->shown.kind == PLB_SETTING_NUMBER || s->shown.kind == PLB_SETTING_LENGTH || s->shown.kind == PLB_SETTING_RATIO);
    if (s && !is_double && s->shown.kind != PLB_SETTING_WHOLE)
        plb_fail(&err, ERROR_ARGUMENT, "%s takes no number", name);
    else if (s && !(value >= s->shown.min && value <= s->shown.max && (is_double || value == (double)(int)value)))
        plb_fail(&err, ERROR_ARGUMENT, "%s takes %g to %g %s; not %g", name, s->shown.min, s->shown.max, s->shown.unit, value);
    else if (s && is_double)
        *(double *)(void *)((char *)o + s->offset) = value;
    else if (s)
        *(int *)(void *)((char *)o + s->offset) = (int)value;
    return plb_api_finish(&err, failed);
}

bool plb_options_get(const plb_options *o, const char *name, char *text, size_t size)
{
    const setting *s = plb_setting_find(name);
    return s && plb_setting_print(s, o, text, size);
}

/* ---- what is no text ---- */

void plb_options_set_profile(plb_options *o, const plb_profile *pencil)
{
    plb_profile *shared = plb_api_profile_share(pencil);
    plb_profile_free(o->profile);
    o->profile = shared;
}

void plb_options_set_seed(plb_options *o, uint64_t seed)
{
    o->seed = seed;
}

void plb_options_set_message(plb_options *o, plb_message_function message, void *closure)
{
    o->message = message;
    o->message_closure = closure;
}

void plb_options_set_progress(plb_options *o, plb_progress_function progress, void *closure)
{
    o->progress = progress;
    o->progress_closure = closure;
}

/* ---- checks of several at once ---- */

bool plb_api_check(const plb_options *o, error *err)
{
    static const char *const apart[][2] = {{"scale", "width"}, {"scale", "height"}, {"page-size", "width"}, {"page-size", "height"}, {"pixels", "dpi"}};
    for (size_t i = 0; i < sizeof apart / sizeof *apart; i++)
        if (!plb_setting_is_usual(plb_setting_find(apart[i][0]), o) && !plb_setting_is_usual(plb_setting_find(apart[i][1]), o))
            return plb_fail(err, ERROR_ARGUMENT, "%s and %s do not go together", apart[i][0], apart[i][1]);
    return true;
}

bool plb_options_check(const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_api_check(o, &err);
    return plb_api_finish(&err, failed);
}

bool plb_api_check_same(const plb_options *o, const plb_options *loaded, const char *name, error *err)
{
    const setting *s;
    for (size_t i = 0; (s = plb_setting_row(i)); i++) {
        unsigned calls = s->shown.calls;
        if (!(calls & PLB_COUNTS_LOADING) || (calls & PLB_COUNTS_FREELY) || plb_setting_is_equal(s, o, loaded))
            continue;
        char now[64] = "another", then[64] = "another";
        plb_setting_print(s, o, now, sizeof now);
        plb_setting_print(s, loaded, then, sizeof then);
        return plb_fail(err, ERROR_ARGUMENT, "%s: %s counts when a drawing is loaded; this one was loaded with %s, not %s", name, s->shown.name, then, now);
    }
    return true;
}
