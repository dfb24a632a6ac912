/* SPDX-License-Identifier: MIT
 *
 * Says what every stage of a stroke may ask: the options of the line, the same for all strokes of a drawing.
 */
#ifndef PLB_STROKE_OPTIONS_H
#define PLB_STROKE_OPTIONS_H

#include <stdint.h>

/* A row of the table of line models (texture/models.h) and of the table of arms (arm/arm.h). */
typedef struct line_model line_model;
typedef struct arm_model arm_model;
typedef enum { HANDED_NONE, HANDED_RIGHT, HANDED_LEFT } handedness; /* NONE: no direction is drawn in another way */
/* The sheet that the pencil draws on. */
typedef enum { PAPER_NONE, PAPER_SMOOTH, PAPER_MEDIUM, PAPER_ROUGH } paper_kind;
/* A profile made ready for drawing: tables computed once. Immutable; shared by all strokes and threads. */
typedef struct pencil pencil;

typedef struct {
    const pencil *pencil, *soft; /* soft: of soft strokes; NULL where there are none */
    uint64_t seed;
    const line_model *model; /* NULL: the papers' */
    const arm_model *arm;    /* NULL: the model's own */
    handedness handed;
    double squiggle; /* largest deviation D, mm, >= 0; negative: the arm's own */
    double hand;     /* how far the pencil's own hand strays where no squiggle says, times a free hand; 0: as 1 */
    double dpi;      /* of the page's pixels */
    int clip_top, clip_bottom; /* only the page's rows [top, bottom) are wanted; both 0: all */
    double pressure; /* times each stroke's own; 0: as 1 */
} stroke_options;

#endif
