/* SPDX-License-Identifier: MIT
 *
 * One stroke of the pencil: the path of the arm, then the graphite along it. This folder is the science; it reads no
 * file, draws on no surface and knows no clock. The model and its sources are told in plumbago(7).
 *
 *     base line  ── arm/, path/ ──▶  path  ── texture/ ──▶  texture along the path  ── mapping/ ──▶  patches on the page
 */
#ifndef PLB_STROKE_STROKE_H
#define PLB_STROKE_STROKE_H

#include "base/patch.h"
#include "stroke/arm/arm.h"
#include "stroke/arm/hand.h"
#include "stroke/mapping/strip_map.h"
#include "stroke/texture/models.h"

/* path/trajectory.c: the drawn path of stroke `s`, sampled closely enough to be joined by straight lines. `out` is replaced. */
bool plb_path_sample(const stroke_list *list, const stroke *s, const stroke_options *o, path_samples *out, error *err);
/* Gives the control points as places on the page, for --dump=controls; their count. */
size_t plb_path_control_points(const stroke_list *list, const stroke *s, const stroke_options *o, point out[CONTROLS_MAX]);

/* Buffers that a thread keeps from stroke to stroke. */
typedef struct {
    path_samples path;
    texture_buffers texture;
    map_buffer map;
} stroke_scratch;
void plb_stroke_scratch_free(stroke_scratch *s);

/* Draws the whole stroke. False and `err` when out of memory, over a limit, or when the sink stops it. */
bool plb_stroke_draw(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, patch_sink sink,
                     void *closure, error *err);

/* Gives the rows [top, bottom) of the page that the stroke may touch, of options->dpi. */
bool plb_stroke_rows(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, int *top, int *bottom,
                     error *err);

#endif
