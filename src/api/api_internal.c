/* SPDX-License-Identifier: MIT
 *
 * This file takes errors and messages from the library to its caller.
 */
#include "api/api_internal.h"

#include "base/number/units.h"

#include <string.h>

/* Both enumerations list the same kinds in the same order: plb_status is the caller's, error_kind the library's. */
_Static_assert((int)PLB_OK == ERROR_NONE && (int)PLB_ERROR_CANCELLED == ERROR_CANCELLED && (int)PLB_ERROR_LIMIT == ERROR_LIMIT,
               "plb_status and error_kind must agree");

bool plb_api_fail(plb_error *to, const error *from)
{
    if (to) {
        to->status = (plb_status)from->kind;
        _Static_assert(sizeof to->text >= sizeof from->text, "the text must fit");
        memcpy(to->text, from->text, sizeof from->text);
    }
    return false;
}

bool plb_api_finish(const error *from, plb_error *to)
{
    if (from->kind != ERROR_NONE)
        return plb_api_fail(to, from);
    if (to) {
        to->status = PLB_OK;
        to->text[0] = '\0';
    }
    return true;
}

bool plb_api_report(const plb_options *o, double done, error *err)
{
    return !o->progress || o->progress(o->progress_closure, done) || plb_fail(err, ERROR_CANCELLED, "stopped");
}

static void say(void *closure, message_level level, const char *text)
{
    const api_adaptor *a = closure;
    a->message(a->closure, level == MESSAGE_WARNING ? 0 : 1, text);
}

log_sink plb_api_messenger(const api_adaptor *adaptor)
{
    log_sink m = {adaptor->message ? say : NULL, (void *)(uintptr_t)adaptor};
    return m;
}

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)

const char *plb_version(void)
{
    return TEXT(PLB_VERSION_MAJOR) "." TEXT(PLB_VERSION_MINOR) "." TEXT(PLB_VERSION_PATCH);
}

bool plb_parse_length(const char *text, double *mm)
{
    return plb_read_length(text, mm);
}
