/* SPDX-License-Identifier: MIT
 *
 * Any bytes as an SVG document for the reader of plain drawings: it refuses and says why, or writes a script that our
 * reader of scripts understands.
 */
#include "fuzz.h"

#include "tap/svg/cairoscript.h"
#include "tap/plain/plain_svg.h"

#include <string.h>

static char *whole;
static size_t length;

static void collect(const char *text, size_t size)
{
    char *more = realloc(whole, length + size + 1);
    fuzz_require(more != NULL);
    whole = more;
    memcpy(whole + length, text, size);
    length += size;
}

static bool give_once(void *closure, const char **data, size_t *size)
{
    bool *given = closure;
    *data = whole;
    *size = length;
    return !*given && (*given = true);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static plain_script script;
    char why[PLAIN_WHY] = "";
    if (!plb_plain_svg((const char *)data, size, &script, why)) {
        fuzz_require(*why && memchr(why, '\0', sizeof why));
        return 0;
    }
    length = 0;
    plb_plain_script_write(&script, collect);
    plb_plain_script_free(&script);
    bool given = false;
    cairoscript_source from = {.refill = give_once, .closure = &given};
    display_list list;
    error err = {ERROR_NONE, ""};
    plb_list_init(&list);
    bool good = plb_read_cairoscript(&from, &list, &err);
    fuzz_require(good ? from.complete && list.width > 0 && list.height > 0 : err.kind == ERROR_LIMIT);
    plb_list_free(&list);
    free(whole);
    whole = NULL;
    return 0;
}
