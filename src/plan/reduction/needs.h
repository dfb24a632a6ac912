/* SPDX-License-Identifier: MIT
 *
 * The reduction's measurements: what is small on a page. reduction.c shows every subpath of the drawing to each of them;
 * then each says how many times larger a sheet it needs.
 */
#ifndef PLB_PLAN_REDUCTION_NEEDS_H
#define PLB_PLAN_REDUCTION_NEEDS_H

#include "base/array.h"
#include "list/display_list.h"
#include "plan/plan.h"

/* A subpath, flattened: near enough for sizes and distances. */
typedef struct {
    const item *it;
    unsigned number;      /* of the item */
    const point *v;       /* mm; its points lie in another array that grows */
    size_t n;             /* 2 at least; a closed one ends where it starts */
    bool closed;
    unsigned curves;      /* of which it was made … */
    unsigned lines;       /* … and straight pieces; that which closes a fill is one */
    box bounds;
    double length;        /* along the points, mm */
    double area;          /* signed, mm^2; of an open one as if closed */
} subpath;

/* A part is a glyph, a piece of one, a marker or whatever small thing stands by itself: subpaths that lie in or, of lines,
 * upon one another. */
typedef struct {
    box bounds;
    double area, perimeter; /* signed sum of its contours, mm^2; sum, mm */
    double width;           /* of its line, mm; of a fill 0 */
    unsigned number;        /* of the last item that belongs to it */
    unsigned curves, lines, contours;
    bool is_fill, is_open;  /* is_open: some of its lines do not close */
    bool is_pale;           /* it leaves no mark: perhaps a letter on a dark ground, but no marker */
    bool is_lettering;      /* filled in by plb_lettering_need */
} small_part;
typedef ARRAY(small_part) small_parts;

/* Heights of lower-case letters, mm, of each letter that a fill says it shows. */
typedef ARRAY(double) letter_heights;

/* small_parts.c: takes a subpath into the parts, unless it is too large to be one. False when out of memory. */
bool plb_small_parts_add(small_parts *parts, const subpath *s);
/* Sorts the values and returns the one that a share of them falls below; 0 where there are none. */
double plb_low_quantile(double *values, size_t n, double share);
/* Returns the larger side of a box, mm. */
double plb_box_size(box b);

/* lettering_size.c: takes in the letters of a fill that says which it shows. */
bool plb_lettering_add_text(letter_heights *known, const text_run *text);
/* Finds the parts that are lettering, and gives, in `need`, how many times larger they and the letters known must be, whose array
 * grows by the others. False when out of memory, as with the other two. */
bool plb_lettering_need(small_parts *parts, letter_heights *known, double *need);

/* small_shapes.c: the same for the parts that are shapes by themselves, for a pencil of `width` mm. */
bool plb_shapes_need(const small_parts *parts, double width, double *need);

/* line_gaps.c: the lines of a drawing, and how far from each other they lie. */
typedef struct line_gaps line_gaps;
/* Prepares for a page and a pencil of `width` mm; `length`: of all lines together, mm. NULL when out of memory. */
line_gaps *plb_line_gaps_new(const display_list *list, double width, double length);
bool plb_line_gaps_add(line_gaps *g, const subpath *s);
bool plb_line_gaps_need(line_gaps *g, double *need);
void plb_line_gaps_free(line_gaps *g);


#endif
