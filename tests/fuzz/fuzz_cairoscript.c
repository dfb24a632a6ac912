/* SPDX-License-Identifier: MIT
 *
 * Any bytes as the text that the tap writes. The first byte says in how large pieces they arrive.
 */
#include "fuzz.h"

#include "tap/svg/cairoscript.h"

typedef struct {
    const char *at, *end;
    size_t piece;
} pieces;

static bool refill(void *closure, const char **data, size_t *size)
{
    pieces *p = closure;
    size_t left = (size_t)(p->end - p->at);
    if (!left)
        return false;
    *data = p->at;
    *size = left < p->piece ? left : p->piece;
    p->at += *size;
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (!size)
        return 0;
    pieces p = {(const char *)data + 1, (const char *)data + size, data[0] ? data[0] : size};
    cairoscript_source from = {.refill = refill, .closure = &p};
    display_list list;
    error err = {ERROR_NONE, ""};
    plb_list_init(&list);
    bool good = plb_read_cairoscript(&from, &list, &err);
    fuzz_require(good ? from.complete && list.width > 0 && list.height > 0 : err.kind != ERROR_NONE);
    plb_list_free(&list);
    return 0;
}
