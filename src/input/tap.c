/* SPDX-License-Identifier: MIT
 *
 * See tap.h.
 */
#include "input/tap.h"

#include "input/converter.h"
#include "list/text/list_read.h"

#include <string.h>

static bool refill(void *closure, const char **data, size_t *size)
{
    return plb_process_read(closure, data, size);
}

bool plb_tap_ended_with(const tap *t, tap_status status)
{
    return t->process.end == PROCESS_EXITED && t->process.code == (int)status;
}

/* "NAME: text", or "NAME:LINE: text" when the text starts with the line's number and a colon. */
static bool fail_with_message(const input_source *in, const char *program, process *p, error_kind kind, error *err)
{
    const char *text = plb_converter_message(p);
    size_t digits = strspn(text, "0123456789");
    bool has_line = digits && text[digits] == ':';
    if (!*text)
        return plb_fail(err, kind, "%s: %s gave up without a word", in->name, program);
    return plb_fail(err, kind, "%s:%s%.400s", in->name, has_line ? "" : " ", text);
}

bool plb_tap_explain_status(const input_source *in, const char *program, process *p, error *err)
{
    static const error_kind kinds[] = {[TAP_MALFORMED] = ERROR_SYNTAX, [TAP_REFUSED] = ERROR_UNSUPPORTED, [TAP_LIMIT] = ERROR_LIMIT,
                                       [TAP_MISSING] = ERROR_HELPER};
    if (p->code == TAP_HANDED_OVER) /* its message stays as it is: it tells the other program what to do */
        return plb_fail(err, ERROR_UNSUPPORTED, "%s: %s leaves it to another program", in->name, program);
    if (p->code >= 0 && p->code < TAP_HANDED_OVER && kinds[p->code])
        return fail_with_message(in, program, p, kinds[p->code], err);
    return plb_fail(err, ERROR_HELPER, "%s: the helper %s failed (status %d): %.200s", in->name, program, p->code, plb_converter_message(p));
}

/* Says why the tap did not succeed. */
static bool explain_end(const input_source *in, tap *t, error *err)
{
    error why = {ERROR_NONE, ""};
    if (plb_converter_ended_by_itself(in, t->who, &t->process, &why))
        return plb_tap_explain_status(in, t->argv[0], &t->process, err);
    t->crashed = why.kind == ERROR_HELPER;
    return plb_fail(err, why.kind, "%s", why.text);
}

/* Says what is wrong with the text itself: a limit is the drawing's fault, all else the tap's. */
static bool fail_to_read(const input_source *in, const tap *t, unsigned long line, const error *why, error *err)
{
    if (why->kind == ERROR_LIMIT || why->kind == ERROR_MEMORY)
        return plb_fail(err, why->kind, "%s: %s", in->name, why->text);
    return plb_fail(err, ERROR_HELPER, "%s: cannot read what %s wrote: line %lu: %s", in->name, t->argv[0], line, why->text);
}

bool plb_tap_read(const input_source *in, tap *t, display_list *list, error *err)
{
    char program[PROCESS_PATH_MAX];
    process *p = &t->process;
    error why = {ERROR_NONE, ""};
    t->pages = 0;
    t->crashed = false;
    *p = (process){.pid = -1, .end = PROCESS_RUNNING};
    if (!plb_process_find(in->helper_dir, t->argv[0], program, &why) || !plb_converter_start(in, t->who, program, t->argv, p, &why))
        return plb_fail(err, why.kind, "%s: %s", in->name, why.text);
    list_source from = {.refill = refill, .closure = p, .name = in->name, .say = in->say};
    plb_list_read(&from, list, &why);
    bool stopped_early = !from.complete && p->out >= 0;
    plb_process_finish(p);
    if (from.complete && plb_tap_ended_with(t, TAP_DONE)) {
        t->pages = from.pages;
        return true;
    }
    plb_list_free(list);
    plb_list_init(list);
    /* A tap that dies leaves half a list: its death is the reason, not the half. */
    if (!stopped_early && !plb_tap_ended_with(t, TAP_DONE))
        return explain_end(in, t, err);
    return fail_to_read(in, t, from.line, &why, err);
}
