/* SPDX-License-Identifier: MIT
 *
 * The stroke list holds the movements a hand makes, in the order it makes them, in millimetres on paper. `plan` makes it
 * from the display list; `stroke` draws each entry by itself.
 */
#ifndef PLB_LIST_STROKE_LIST_H
#define PLB_LIST_STROKE_LIST_H

#include "base/array.h"
#include "base/geometry/geom.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* A movement serves one of these ends, and the hand makes each kind in its own way. */
typedef enum {
    STROKE_LINE,   /* of the drawing itself */
    STROKE_HATCH,  /* one of many that make a tone */
    STROKE_LETTER, /* lettering: small and careful */
    STROKE_GUIDE   /* a construction line, drawn before the others and faint */
} stroke_kind;

/* A stroke_style says how the pencil touches the paper along one movement. */
typedef struct {
    float pressure;   /* times the hand's usual pressure, > 0: lighter is paler and grainier, heavier darker and broader */
    uint32_t colour;  /* 0xRRGGBB of a coloured pencil; 0: graphite */
    stroke_kind kind;
    bool is_soft;     /* made with the soft pencil that the darks are shaded with, not with the one that draws */
    float breadth;    /* of the lead, times the pencil's captured line, > 0; 0 until the plan knows how worn the point is then */
    float clear;      /* mm of paper that hatching below leaves on either side of it: of letters; 0: the least that keeps the two apart */
    float max_stray;  /* mm: how far the hand may stray, as in stroke.max_deviation, before other strokes are looked at; 0: freely */
    uint64_t company; /* strokes of one company stray together, as one movement gone over again; 0: each by itself */
} stroke_style;
#define STROKE_STYLE_USUAL ((stroke_style){.pressure = 1, .kind = STROKE_LINE})

/* A stroke is one movement of the pencil along a smooth line. */
typedef struct {
    stroke_style style;
    uint64_t identity; /* where its random numbers live: a hash of its shape, distinct for each stroke of a list */
    size_t first, n;   /* its points in stroke_list.points; n >= 2, no two neighbours equal */
    bool closed;       /* ends where it starts, smoothly */
    float max_deviation; /* mm: how far the hand may stray, since another line runs beside this one; 0: as far as it does by itself */
    bool corner_first, corner_last; /* an end where the line goes on round a corner: the pencil is not lifted there */
} stroke;

typedef struct {
    double width, height; /* of the page, mm */
    ARRAY(stroke) strokes;
    ARRAY(point) points;
} stroke_list;

void plb_stroke_list_free(stroke_list *s);
/* Returns the length along the stroke's points, mm. */
double plb_stroke_length(const stroke_list *list, const stroke *s);
/* Writes the text form: one stroke a line after a head line; plumbago(1), --dump=strokes. False on a write error. */
bool plb_stroke_list_print(const stroke_list *s, FILE *to);

#endif
