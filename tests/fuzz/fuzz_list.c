/* SPDX-License-Identifier: MIT
 *
 * Any bytes as the display list's text form. The first byte says in how large pieces they arrive. What is read must come back
 * the same when it is written and read again.
 */
#include "fuzz.h"

#include "base/array.h"
#include "list/text/list_read.h"
#include "list/text/list_write.h"

#include <string.h>

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

typedef ARRAY(char) text;

static bool put(void *closure, const char *data, size_t n)
{
    text *t = closure;
    if (!array_reserve(t, n))
        return false;
    memcpy(t->v + t->n, data, n);
    t->n += n;
    return true;
}

static bool read_pieces(pieces p, display_list *list)
{
    error err = {ERROR_NONE, ""};
    list_source from = {.refill = refill, .closure = &p, .name = "it"};
    plb_list_init(list);
    bool good = plb_list_read(&from, list, &err);
    fuzz_require(good ? from.complete && list->width > 0 && list->height > 0 : err.kind != ERROR_NONE && from.line > 0);
    return good;
}

static void comes_back(const display_list *list)
{
    text first = {0}, second = {0};
    display_list again;
    fuzz_require(plb_list_write(list, put, &first));
    fuzz_require(read_pieces((pieces){first.v, first.v + first.n, 4096}, &again));
    fuzz_require(plb_list_write(&again, put, &second));
    fuzz_require(first.n == second.n && !memcmp(first.v, second.v, first.n));
    plb_list_free(&again);
    array_free(&first);
    array_free(&second);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    display_list list;
    if (!size)
        return 0;
    pieces p = {(const char *)data + 1, (const char *)data + size, data[0] ? data[0] : size};
    if (read_pieces(p, &list))
        comes_back(&list);
    plb_list_free(&list);
    return 0;
}
