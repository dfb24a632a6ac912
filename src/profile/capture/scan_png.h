/* SPDX-License-Identifier: MIT
 *
 * A scan as 8-bit grey, from a PNG.
 */
#ifndef PLB_PROFILE_CAPTURE_SCAN_PNG_H
#define PLB_PROFILE_CAPTURE_SCAN_PNG_H

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>

/* Bounds on a scan: an A3 page at 400 dpi fits. */
#define SCAN_MAX_SIDE 20000
#define SCAN_MAX_PIXELS 64000000

typedef struct {
    int width, height;
    double dpi;    /* as the file says; 0: it does not */
    uint8_t *grey; /* row by row; 0 black, 255 white */
} scan;

/* Reads any kind of PNG; colour is turned to grey as 0.299 R + 0.587 G + 0.114 B of the stored values (ITU-R BT.601),
 * and transparent pixels lie on white. The caller frees with plb_scan_png_free. */
bool plb_scan_png_read(scan *s, const char *file, error *err);
/* Exchanges rows and columns. */
bool plb_scan_png_transpose(const scan *s, scan *out, error *err);
/* Makes every pixel of `out` the mean of `factor` x `factor` pixels, factor > 1; a rest at the right and below is dropped. */
bool plb_scan_reduce(const scan *s, double factor, scan *out, error *err);
void plb_scan_png_free(scan *s);

#endif
