/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a profile, as they are and with magic, version, size and checksum set right (no fuzzer guesses those). One that is
 * accepted may draw a line with each model, and is the same after it is written and read again.
 */
#include "fuzz.h"

#include "api/api_internal.h"
#include "base/array.h"
#include "profile/file/format.h"

#include <cairo.h>
#include <string.h>

#define DRAWN 8 /* one of so many profiles draws: the reader is what is looked at, and drawing takes a hundred times as long */

static void put(uint8_t *at, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

static void draw_lines(profile *p)
{
    cairo_surface_t *page = cairo_image_surface_create(CAIRO_FORMAT_A8, 48, 24);
    struct plb_profile holder = {p, plb_api_rack_new(), 1};
    plb_options *o = plb_options_new();
    fuzz_require(holder.pencil_cache != NULL && o);
    plb_options_set_profile(o, &holder);
    o->dpi = 150;
    for (int hla = 0; hla < 2; hla++) {
        plb_error failed = {PLB_OK, ""};
        fuzz_require(plb_options_set(o, "model", hla ? "hla" : "graphite", NULL));
        bool good = plb_draw_line(page, 4, 10, 40, 14, 1, o, &failed);
        fuzz_require(good || failed.status != PLB_OK);
    }
    cairo_surface_destroy(page);
    plb_options_free(o);
    plb_api_rack_free(holder.pencil_cache);
}

static void write_and_read(profile *p)
{
    error err = {ERROR_NONE, ""};
    size_t n1 = 0, n2 = 0;
    unsigned char *first = plb_profile_serialise(p, &n1, &err);
    fuzz_require(first != NULL);
    profile *again = plb_profile_parse("fuzz again", first, n1, &err);
    fuzz_require(again != NULL);
    unsigned char *second = plb_profile_serialise(again, &n2, &err);
    fuzz_require(second && n1 == n2 && !memcmp(first, second, n1));
    plb_profile_release(again);
    plb_free(first);
    plb_free(second);
}

static void try(const uint8_t *data, size_t size)
{
    error err = {ERROR_NONE, ""};
    profile *p = plb_profile_parse("fuzz", data, size, &err);
    fuzz_require(p || err.kind != ERROR_NONE);
    if (!p)
        return;
    write_and_read(p);
    if (plb_crc32(data, size) % DRAWN == 0)
        draw_lines(p);
    plb_profile_release(p);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    try(data, size);
    if (size < FORMAT_HEADER_SIZE + FORMAT_TRAILER_SIZE)
        return 0;
    uint8_t *right = malloc(size);
    fuzz_require(right != NULL);
    memcpy(right, data, size);
    memcpy(right, FORMAT_MAGIC, FORMAT_MAGIC_SIZE);
    put(right + FORMAT_MAGIC_SIZE, FORMAT_MAJOR | FORMAT_MINOR << 16);
    put(right + FORMAT_MAGIC_SIZE + 4, (uint32_t)size);
    put(right + size - FORMAT_TRAILER_SIZE, plb_crc32(right, size - FORMAT_TRAILER_SIZE));
    if (memcmp(right, data, size))
        try(right, size);
    free(right);
    return 0;
}
