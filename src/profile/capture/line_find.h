/* SPDX-License-Identifier: MIT
 *
 * Capture, first step: where the line of a scan runs.
 */
#ifndef PLB_PROFILE_CAPTURE_LINE_FIND_H
#define PLB_PROFILE_CAPTURE_LINE_FIND_H

#include "profile/capture/scan_png.h"

/* A line that goes through the scan roughly along x: in column x0 + k it covers the rows top[k] to bottom[k] - 1;
 * top[k] == bottom[k] where it was not seen (another mark crosses). */
typedef struct {
    int x0, n;
    int *top, *bottom;
    double score; /* darkness summed along it; 0: no line */
} line_track;

/* Finds the darkest long line of `s` that is less than 45 degrees off the x axis. `unit` is 1/300 inch in pixels; `paper`
 * the grey of the paper. A scan without a line gives n = 0. The caller frees. */
bool plb_line_find(const scan *s, double unit, int paper, line_track *t, error *err);
void plb_line_track_free(line_track *t);

#endif
