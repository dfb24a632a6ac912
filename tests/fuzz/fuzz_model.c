/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a solid model, of the format that their first letters name or else OBJ; their number says how it is seen. It is refused, and
 * why is said, or a list comes that our reader of lists takes.
 */
#include "fuzz.h"

#include "list/text/list_read.h"
#include "tap/model/model.h"

#include <string.h>

typedef ARRAY(char) bytes;

static bool put(void *closure, const char *data, size_t n)
{
    bytes *to = closure;
    if (!array_reserve(to, n))
        return false;
    memcpy(to->v + to->n, data, n);
    to->n += n;
    return true;
}

static bool give_once(void *closure, const char **data, size_t *size)
{
    bytes *made = closure;
    if (!made->n)
        return false;
    *data = made->v;
    *size = made->n;
    made->n = 0;
    return true;
}

static model_format format_of(const char *data, size_t size)
{
    if (size > 4 && !memcmp(data, "ply", 3))
        return MODEL_PLY;
    if (size > 4 && (!memcmp(data, "OFF", 3) || !memcmp(data, "COFF", 4)))
        return MODEL_OFF;
    return size > 4 && (!memcmp(data, "solid", 5) || !memcmp(data, "STL", 3)) ? MODEL_STL : MODEL_OBJ;
}

static model_settings settings_of(size_t size)
{
    model_settings s = plb_model_settings_default();
    s.from.perspective = size % 3 == 1 ? 40 : 0;
    s.hidden = (hidden_style)(size % 4);
    s.sheet = size % 7 == 5 ? SHEET_FIRST_ANGLE : size % 11 == 3 ? SHEET_THIRD_ANGLE : SHEET_NONE;
    s.light.is_on = size % 5 != 2;
    return s;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    raw_model raw = {0};
    bytes made = {0};
    error err = {ERROR_NONE, ""};
    model_settings s = settings_of(size);
    bool good = plb_model_read((const char *)data, size, format_of((const char *)data, size), &raw, &err) && plb_model_draw(&raw, &s, put, &made, &err);
    fuzz_require(good || err.kind != ERROR_NONE);
    if (good) {
        list_source from = {.refill = give_once, .closure = &made, .name = "list"};
        display_list list;
        plb_list_init(&list);
        bool is_read = plb_list_read(&from, &list, &err);
        fuzz_require(is_read ? from.complete && list.width > 0 && list.height > 0 : err.kind == ERROR_LIMIT);
        plb_list_free(&list);
    }
    plb_raw_model_free(&raw);
    array_free(&made);
    return 0;
}
