/* SPDX-License-Identifier: MIT
 *
 * Capture from a scan. An even first byte: the rest are the bytes of a PNG file, whose signature and checksums are set right,
 * since no fuzzer guesses those. An odd one: bytes 1 to 4 give width, height and resolution, the rest the grey pixels, over and over.
 */
#define _GNU_SOURCE /* memfd_create */
#include "fuzz.h"

#include "base/array.h"
#include "profile/profile.h"

#include <png.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

/* A PNG of these pixels into `to`. */
static void write_png(FILE *to, const uint8_t *data, size_t size)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    unsigned width = 1 + data[0] * 4u, height = 1 + data[1] * 2u, dpi = data[2] * 8u;
    uint8_t row[1 + 255 * 4];
    if (setjmp(png_jmpbuf(png)))
        abort();
    png_init_io(png, to);
    png_set_compression_level(png, 0);
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    if (dpi)
        png_set_pHYs(png, info, dpi * 10000 / 254, dpi * 10000 / 254, PNG_RESOLUTION_METER);
    png_write_info(png, info);
    size_t at = 0, n = size - 3;
    for (unsigned y = 0; y < height; y++) {
        for (unsigned x = 0; x < width; x++)
            row[x] = n ? data[3 + at++ % n] : 255;
        png_write_row(png, row);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
}

static uint32_t number_at(const uint8_t *at) { return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3]; }

static void put_number(uint8_t *at, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> (24 - 8 * i));
}

/* The signature, and the checksum of each whole chunk: length, type, data, checksum (PNG, section 5.3). */
static void mend_png(uint8_t *data, size_t size)
{
    static const uint8_t signature[8] = {137, 'P', 'N', 'G', 13, 10, 26, 10};
    if (size < sizeof signature)
        return;
    memcpy(data, signature, sizeof signature);
    for (size_t at = sizeof signature; size - at >= 12;) {
        size_t n = number_at(data + at);
        if (n > size - at - 12)
            break;
        put_number(data + at + 8 + n, (uint32_t)crc32(0, data + at + 4, (unsigned)n + 4));
        at += 12 + n;
    }
}

static void write_mended(FILE *to, const uint8_t *data, size_t size)
{
    uint8_t *right = malloc(size);
    fuzz_require(right != NULL);
    memcpy(right, data, size);
    mend_png(right, size);
    fwrite(right, 1, size, to);
    free(right);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 5)
        return 0;
    int fd = memfd_create("scan", 0);
    FILE *to = fdopen(fd, "wb");
    fuzz_require(to != NULL);
    if (data[0] % 2)
        write_png(to, data + 1, size - 1);
    else
        write_mended(to, data + 1, size - 1);
    fflush(to);
    char name[64];
    snprintf(name, sizeof name, "/proc/self/fd/%d", fd);
    const char *files[] = {name};
    capture_options how = plb_capture_defaults();
    how.name = "fuzz";
    error err = {ERROR_NONE, ""};
    profile *p = plb_capture(files, 1, &how, &err);
    fuzz_require(p || err.kind != ERROR_NONE);
    fclose(to);
    if (!p)
        return 0;
    size_t n = 0;
    unsigned char *bytes = plb_profile_serialise(p, &n, &err);
    fuzz_require(bytes != NULL);
    plb_profile_release(p);
    p = plb_profile_parse("captured", bytes, n, &err); /* what is captured can be read */
    fuzz_require(p != NULL);
    plb_profile_release(p);
    plb_free(bytes);
    return 0;
}
