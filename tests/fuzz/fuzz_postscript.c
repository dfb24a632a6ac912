/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a PostScript or EPS file.
 */
#include "fuzz.h"

#include "tap/ps/postscript.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    display_list list;
    error err = {ERROR_NONE, ""};
    plb_list_init(&list);
    ps_request ask = {.data = (const char *)data, .size = size, .alone = true};
    ps_answer answer;
    fuzz_require(plb_ps_read(&ask, &list, &answer, &err) == PS_DRAWN || err.kind != ERROR_NONE);
    plb_list_free(&list);
    return 0;
}
