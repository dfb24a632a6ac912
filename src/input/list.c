/* SPDX-License-Identifier: MIT
 *
 * The program's own language, plumbago-list(5): from the file's bytes, with no other program between.
 */
#include "input/input.h"

#include "list/text/list_read.h"

/* Gives all bytes at once, the first time. */
static bool give_file(void *closure, const char **data, size_t *size)
{
    const input_source **in = closure;
    if (!*in)
        return false;
    *data = (*in)->data;
    *size = (*in)->size;
    *in = NULL;
    return *size > 0;
}

bool plb_read_list(const input_source *in, display_list *list, error *err)
{
    const input_source *once = in;
    error why = {ERROR_NONE, ""};
    list_source from = {.refill = give_file, .closure = (void *)(uintptr_t)&once, .name = in->name, .say = in->say};
    if (plb_list_read(&from, list, &why))
        return true;
    if (why.kind == ERROR_MEMORY)
        return plb_fail(err, why.kind, "%s: %s", in->name, why.text);
    return plb_fail(err, why.kind, "%s:%lu: %s", in->name, from.line, why.text);
}
