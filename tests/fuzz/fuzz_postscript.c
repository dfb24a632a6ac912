/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a PostScript or EPS file.
 */
#include "fuzz.h"

#include "input/input.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    display_list list;
    error err = {ERROR_NONE, ""};
    plb_list_init(&list);
    input_source in = {.name = "fuzz", .data = (const char *)data, .size = size};
    bool good = plb_read_postscript(&in, &list, &err);
    fuzz_require(good || err.kind != ERROR_NONE);
    plb_list_free(&list);
    return 0;
}
