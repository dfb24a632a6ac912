/* SPDX-License-Identifier: MIT
 *
 * Capture, second step: a line that was found becomes a strip.
 */
#ifndef PLB_PROFILE_CAPTURE_LINE_STRAIGHTEN_H
#define PLB_PROFILE_CAPTURE_LINE_STRAIGHTEN_H

#include "profile/capture/line_find.h"
#include "profile/capture/line_strip.h"

/* Straightens the line; `unit` is 1/300 inch in pixels. The caller frees `out`. */
bool plb_line_strip_make(const scan *s, const line_track *t, double unit, int paper, line_strip *out, error *err);
void plb_line_strip_free(line_strip *strip);

#endif
