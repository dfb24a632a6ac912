/* SPDX-License-Identifier: MIT
 *
 * The display list becomes strokes that a person would make: outlines of fills, dashes, clipped pieces, corners.
 */
#ifndef PLB_PLAN_PLAN_H
#define PLB_PLAN_PLAN_H

#include "base/error.h"
#include "list/display_list.h"
#include "list/stroke_list.h"

/* A plan holds at most so many strokes and points; beyond: ERROR_LIMIT. */
#define PLAN_MAX_STROKES 5000000u
#define PLAN_MAX_POINTS 60000000u

typedef enum { FILL_HATCH, FILL_OUTLINE, FILL_NONE } fill_style;
typedef enum { TEXT_HAND, TEXT_OUTLINE, TEXT_NONE } text_style;
/* Characters are the middle lines of the font's, or, where they are known, those of a hand's alphabet. */
typedef enum { LETTERING_FONT, LETTERING_HAND } lettering_style;
/* Which straight lines are drawn along a ruler: none, the long ones that lie level or upright, all. */
typedef enum { RULER_NONE, RULER_AUTO, RULER_ALL } ruler_use;
/* A tone_scale says how dark a pencil's hatching comes out: the mean darkness (0 paper, 1 black) of an area hatched
 * with each of TONE_STEPS efforts, evenly from the faintest to the darkest; rising (hatch_tone.c). */
#define TONE_STEPS 9
#define TONE_FAINTEST 0.1 /* a darkness that is hatched whatever the scale */
typedef struct {
    double darkness[TONE_STEPS];
} tone_scale;

typedef struct {
    fill_style fill;
    text_style text;
    lettering_style lettering;
    bool colour;         /* each stroke in its paint's own colour */
    double pencil_width; /* of a line at half depth, mm: what one stroke of an outline or a letter covers */
    double shade_width;  /* … and what one of hatching, solids and wide lines covers, which are made with the side of the lead */
    double point;        /* breadth of a freshly sharpened point, times the pencil's captured line (habits/touch.c); 1: a blunt one, never sharpened */
    bool is_touched;     /* pressure and point change over the page, as measured; the papers know no such thing */
    bool is_free;        /* the hand strays, so dashes are uneven and askew and corners are not met exactly */
    tone_scale tone;     /* what the pencil's hatching comes to */
    double soft_width;   /* of the line of a softer pencil, mm, for what the pencil cannot reach; 0: there is none */
    tone_scale soft_tone; /* … and what its hatching comes to */
    ruler_use ruler;
    double overshoot;    /* how far lines run past corners at most, mm; 0: they meet */
    double restate;      /* the share of long lines that are drawn twice */
    bool construction;   /* faint lines beyond long lines, and axes of circles */
    double reduction;    /* the sheet is so many times larger than the page; what is reduced is drawn firmly, to keep its contrast; 1 or more */
    double max_length;   /* of all strokes together, mm; a plan that needs more is an ERROR_LIMIT */
    int threads;         /* at most so many share the work; the strokes are the same */
    uint64_t seed;       /* of the unevenness that a plan itself has: dashes, hatching */
} plan_options;
plan_options plb_plan_options_default(void);

/* Fills `out`, which the caller frees on success; on failure it is empty. */
bool plb_plan(const display_list *list, const plan_options *o, const log_sink *say, stroke_list *out, error *err);

#endif
