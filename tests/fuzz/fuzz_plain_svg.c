/* SPDX-License-Identifier: MIT
 *
 * Any bytes as an SVG document for the reader of plain drawings: it refuses and says why, or writes a list that our reader
 * of lists takes.
 */
#include "fuzz.h"

#include "list/text/list_read.h"
#include "tap/plain/plain_svg.h"

#include <string.h>

static bool give_once(void *closure, const char **data, size_t *size)
{
    plain_list *made = closure;
    if (!made->text.n)
        return false;
    *data = made->text.v;
    *size = made->text.n;
    made->text.n = 0;
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static plain_list made;
    char why[PLAIN_WHY] = "";
    if (!plb_plain_svg((const char *)data, size, &made, why)) {
        fuzz_require(*why && memchr(why, '\0', sizeof why));
        return 0;
    }
    list_source from = {.refill = give_once, .closure = &made, .name = "list"};
    display_list list;
    error err = {ERROR_NONE, ""};
    plb_list_init(&list);
    bool good = plb_list_read(&from, &list, &err);
    fuzz_require(good ? from.complete && list.width > 0 && list.height > 0 : err.kind == ERROR_LIMIT);
    plb_list_free(&list);
    plb_plain_list_free(&made);
    return 0;
}
