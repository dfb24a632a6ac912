/* SPDX-License-Identifier: MIT
 *
 * A scan at a lower resolution: every pixel the mean of those it covers.
 */
#include "profile/capture/scan_png.h"

#include "base/array.h"

#include <math.h>

/* Tells how much of pixel `i` lies between `from` and `to`. */
static double overlap(int i, double from, double to)
{
    double a = from > i ? from : i, b = to < i + 1 ? to : i + 1;
    return b > a ? b - a : 0;
}

/* Gives the mean over the square of side `side` at (x, y). */
static double mean_of_square(const scan *s, double x, double y, double side)
{
    double sum = 0, area = 0;
    for (int j = (int)y; j < s->height && j < y + side; j++)
        for (int i = (int)x; i < s->width && i < x + side; i++) {
            double w = overlap(i, x, x + side) * overlap(j, y, y + side);
            sum += w * s->grey[(size_t)j * (size_t)s->width + (size_t)i];
            area += w;
        }
    return area > 0 ? sum / area : 255;
}

bool plb_scan_reduce(const scan *s, double factor, scan *out, error *err)
{
    *out = (scan){.width = (int)fmax(1, s->width / factor), .height = (int)fmax(1, s->height / factor), .dpi = s->dpi / factor};
    out->grey = plb_new((size_t)out->width * (size_t)out->height, 1);
    if (!out->grey)
        return plb_fail_memory(err);
    for (int y = 0; y < out->height; y++)
        for (int x = 0; x < out->width; x++)
            out->grey[(size_t)y * (size_t)out->width + (size_t)x] = (uint8_t)(mean_of_square(s, x * factor, y * factor, factor) + 0.5);
    return true;
}
