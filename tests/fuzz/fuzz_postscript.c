/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a PostScript or EPS file; their number says what is asked for.
 */
#include "fuzz.h"

#include "tap/ps/postscript.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    display_list list;
    error err = {ERROR_NONE, ""};
    ps_answer answer;
    ps_request ask = {.data = (const char *)data, .size = size, .page = (unsigned)(size % 3), .alone = size % 4 != 0, .only_count = size % 16 == 5};
    plb_list_init(&list);
    ps_outcome outcome = plb_ps_read(&ask, &list, &answer, &err);
    fuzz_require(outcome == PS_DRAWN || err.kind != ERROR_NONE);
    fuzz_require(outcome != PS_DRAWN || (list.width > 0 && list.height > 0) || answer.pages);
    fuzz_require(outcome != PS_HANDED_OVER || (answer.area.x1 > answer.area.x0 && answer.area.y1 > answer.area.y0));
    plb_list_free(&list);
    return 0;
}
