/* SPDX-License-Identifier: MIT
 *
 * The marks of one item: what a hand would draw for it if nothing clipped or hid it.
 */
#ifndef PLB_PLAN_MARKS_H
#define PLB_PLAN_MARKS_H

#include "plan/hatch/hatch.h"
#include "plan/hidden/occlusion.h"
#include "plan/letter/glyphs.h"
#include "plan/letter/runs.h"
#include "plan/tone/crowd.h"

/* The marks of all items of a drawing go by these. */
typedef struct {
    const display_list *list; /* `inked` */
    display_list inked;       /* the drawing's list, with a dark paint for small white letters on dark areas */
    const plan_options *options;
    clipper *clips;
    occluders *occluders;
    hatcher hatcher;
    glyph_store *glyphs;
    letter_runs *runs;
    cell_groups *cells;
    crowd_part *crowd;  /* of each item */
    double usual_width; /* of the drawing's lines, mm */
} plan_context;

/* Gives the clip of the marks of item number `i`. */
int plb_marks_clip(const plan_context *p, size_t i);
/* Appends the marks of item number `i`, with their styles, to `out`: a line, the passes of a wide line, the strokes of letters, hatching and
 * outline of a fill. *stands_for_next becomes true where the next item is drawn by these marks, too. False and `err` on failure. */
bool plb_plan_marks(const plan_context *p, size_t i, track_list *out, bool *stands_for_next, error *err);

#endif
