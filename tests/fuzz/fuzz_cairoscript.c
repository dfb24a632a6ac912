/* SPDX-License-Identifier: MIT
 *
 * Any bytes as the text that cairo writes: it is refused, or becomes a list that our reader of lists takes, unless a limit
 * is in the way. The first byte says in how large pieces they arrive.
 */
#include "fuzz.h"

#include "list/text/list_read.h"
#include "tap/svg/cairoscript.h"

#include <string.h>

typedef struct {
    ARRAY(char) text;
    bool is_given;
} list_text;

static bool keep(void *closure, const char *data, size_t n)
{
    list_text *t = closure;
    fuzz_require(array_reserve(&t->text, n));
    memcpy(t->text.v + t->text.n, data, n);
    t->text.n += n;
    return true;
}

static bool give(void *closure, const char **data, size_t *size)
{
    list_text *t = closure;
    if (t->is_given)
        return false;
    *data = t->text.v;
    *size = t->text.n;
    return t->is_given = true;
}

static bool convert(const char *script, size_t left, size_t piece, list_writer *out, error *err)
{
    omissions lost = {.n = {0}};
    cairoscript *s = plb_cairoscript_new(out, 100, 50, plb_matrix_scale(0.1, 0.1));
    bool ok = true;
    for (size_t n; ok && left; left -= n, script += n) {
        n = left < piece ? left : piece;
        ok = plb_cairoscript_feed(s, script, n, err);
    }
    ok = ok && plb_cairoscript_end(s, &lost, err);
    plb_cairoscript_free(s);
    fuzz_require(ok == (err->kind == ERROR_NONE));
    return ok;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static list_writer out;
    list_text text = {.is_given = false};
    list_source from = {.refill = give, .closure = &text, .name = "list"};
    display_list list;
    error err = {ERROR_NONE, ""};
    if (!size)
        return 0;
    plb_list_init(&list);
    plb_list_writer_init(&out, keep, &text);
    plb_list_writer_page(&out, 100, 50);
    plb_list_writer_matrix(&out, plb_matrix_scale(0.1, 0.1));
    if (convert((const char *)data + 1, size - 1, data[0] ? data[0] : size, &out, &err)) {
        plb_list_writer_end(&out);
        bool good = plb_list_read(&from, &list, &err);
        fuzz_require(good ? from.complete : err.kind == ERROR_LIMIT);
    }
    plb_list_free(&list);
    array_free(&text.text);
    return 0;
}
