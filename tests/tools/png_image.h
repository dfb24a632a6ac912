/* SPDX-License-Identifier: MIT
 *
 * A PNG file as 8-bit grey on white, for the test tools. Colour becomes luma (Rec. 601) of the stored values, as they
 * are, without any gamma; transparent pixels show white.
 */
#ifndef PLB_TESTS_PNG_IMAGE_H
#define PLB_TESTS_PNG_IMAGE_H

#include <png.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    int width, height;
    uint8_t *grey; /* row by row */
} grey_image;

static uint8_t grey_of(const uint8_t rgba[4])
{
    double luma = 0.299 * rgba[0] + 0.587 * rgba[1] + 0.114 * rgba[2];
    return (uint8_t)(255 - (255 - luma) * rgba[3] / 255 + 0.5);
}

/* Exits with status 2 and a line on standard error when the file is not a whole PNG. */
static grey_image read_grey(const char *file)
{
    png_image png;
    memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, file)) {
        fprintf(stderr, "%s: %s\n", file, png.message);
        exit(2);
    }
    png.format = PNG_FORMAT_RGBA;
    uint8_t *rgba = malloc(PNG_IMAGE_SIZE(png));
    grey_image image = {(int)png.width, (int)png.height, malloc((size_t)png.width * png.height)};
    if (!rgba || !image.grey || !png_image_finish_read(&png, NULL, rgba, 0, NULL)) {
        fprintf(stderr, "%s: %s\n", file, png.message);
        exit(2);
    }
    for (size_t i = 0; i < (size_t)image.width * (size_t)image.height; i++)
        image.grey[i] = grey_of(rgba + 4 * i);
    free(rgba);
    return image;
}

/* A number from the command line within [low, high], or exit status 2. */
static inline double argument(const char *text, double low, double high)
{
    char *end;
    double value = strtod(text, &end);
    if (*end || end == text || !(value >= low && value <= high)) {
        fprintf(stderr, "'%s' is not a number from %g to %g\n", text, low, high);
        exit(2);
    }
    return value;
}

#endif
