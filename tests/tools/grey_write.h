/* SPDX-License-Identifier: MIT
 *
 * Writes 8-bit grey as PNG, for the test tools.
 */
#ifndef PLB_TESTS_GREY_WRITE_H
#define PLB_TESTS_GREY_WRITE_H

#include <png.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* `grey` has width × height bytes, row by row, stored as they are. Exits with status 2 and a line on standard error
 * when the file cannot be written. */
static inline void write_grey(const char *file, int width, int height, const uint8_t *grey)
{
    png_image png;
    memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    png.width = (png_uint_32)width;
    png.height = (png_uint_32)height;
    png.format = PNG_FORMAT_GRAY;
    if (!png_image_write_to_file(&png, file, 0, grey, 0, NULL)) {
        fprintf(stderr, "%s: %s\n", file, png.message);
        exit(2);
    }
}

#endif
