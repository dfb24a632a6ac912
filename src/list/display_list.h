/* SPDX-License-Identifier: MIT
 *
 * The display list holds what was drawn, in painting order, in millimetres on paper (x right, y down, origin at the
 * page's top left corner). Readers make the list; `plan` turns it into strokes.
 */
#ifndef PLB_LIST_DISPLAY_LIST_H
#define PLB_LIST_DISPLAY_LIST_H

#include "base/array.h"
#include "base/error.h"
#include "base/geometry/path.h"
#include "list/characters.h"
#include "list/omissions.h"

typedef enum { ITEM_STROKE, ITEM_FILL } item_kind;
typedef enum { PAINT_SOLID, PAINT_GRADIENT, PAINT_PATTERN } paint_kind;
typedef enum { LINE_CAP_BUTT, LINE_CAP_ROUND, LINE_CAP_SQUARE } line_cap;

/* A paint has components in [0, 1], not premultiplied; those of a gradient are its mean colour. */
typedef struct {
    paint_kind kind;
    double red, green, blue, alpha;
} paint;

/* A gradient goes on beyond its ends in one of these ways. */
typedef enum { GRADIENT_ENDS, GRADIENT_PAD, GRADIENT_REPEAT, GRADIENT_REFLECT } gradient_extend;

typedef struct {
    double offset; /* 0 to 1, not below the one before */
    float red, green, blue, alpha;
} gradient_stop;

#define GRADIENT_MAX_STOPS 16 /* where there are more, those that matter least go */

/* A gradient has a colour for each place: between two points, or between two circles. */
typedef struct {
    bool radial;
    gradient_extend extend;
    unsigned n;             /* stops */
    matrix to_space;        /* from mm on paper to the space of these: */
    point from, to;         /* offsets 0 and 1; radial: the circles' centres */
    double from_radius, to_radius;
    double opacity;         /* of the whole, beside that of the stops */
    gradient_stop stops[GRADIENT_MAX_STOPS];
} gradient;

#define NO_CLIP (-1)

/* A clip is one path; things are visible inside it and inside its parent. */
typedef struct {
    path path;
    bool even_odd;
    int parent; /* index of the clip it narrows, always smaller than its own, or NO_CLIP */
} clip;

typedef struct {
    item_kind kind;
    path path;      /* mm */
    paint paint;
    unsigned gradient; /* with PAINT_GRADIENT: 1 + an index into gradients, or 0: only the mean colour is known */
    int clip;       /* index into clips, or NO_CLIP */
    bool even_odd;  /* fills: the rule */
    bool is_directed; /* fills: their hatching runs in this … */
    double direction; /* … direction, degrees clockwise from the right; else the plan chooses */
    text_run *text; /* fills: what the path says; NULL: nothing is known. Owned */
    line_cap cap;   /* strokes, as the rest below */
    double width;   /* mm; 0: the thinnest line */
    ARRAY(double) dash; /* mm, on and off in turn, an even count; empty: solid */
    double dash_offset; /* mm */
} item;

typedef struct {
    double width, height; /* of the page, mm, finite and positive once a reader is done */
    ARRAY(item) items;
    ARRAY(clip) clips;
    ARRAY(gradient) gradients;
    size_t points; /* of all paths together */
    size_t dashes; /* of all items together */
    size_t characters; /* that all items say */
    double paper_scale; /* mm on paper per mm of the thing drawn, where the reader chose it (DXF); else 1 */
    omissions omissions; /* what was met and left out */
} display_list;

/* A file may ask for so much; beyond, a reader stops with ERROR_LIMIT. */
#define LIST_MAX_ITEMS 4000000u
#define LIST_MAX_POINTS 40000000u
#define LIST_MAX_DASHES 40000000u
#define LIST_MAX_GRADIENTS 100000u
#define LIST_MAX_CHARACTERS 4000000u

void plb_list_init(display_list *list);
void plb_list_free(display_list *list);
/* Moves `it` (with its path and dashes, which `it` then no longer owns) to the end; false and `err` when over a
 * limit or out of memory (then `it` still owns them). Items whose path has a point that is not finite or lies
 * beyond 1e7 mm are dropped with true. */
bool plb_list_add(display_list *list, item *it, error *err);
/* Moves a clip path in and gives its index. */
bool plb_list_add_clip(display_list *list, clip *c, int *index, error *err);
/* Adds a gradient, unless it is the last one again, and gives 1 + its index, for item.gradient. */
bool plb_list_add_gradient(display_list *list, const gradient *g, unsigned *index, error *err);
/* Adds a gradient in every case. */
bool plb_list_append_gradient(display_list *list, const gradient *g, error *err);
void plb_item_free(item *it);
/* Maps all that lies on the page by `m` (line widths and dashes by its expansion). */
void plb_list_transform(display_list *list, matrix m);
/* Returns the omissions, to which it adds things that nobody will see and fills that become an even grey. */
omissions plb_list_count_omissions(const display_list *list);
/* Returns the bounds of all items' paths; empty when there are none. */
box plb_list_bounds(const display_list *list);
/* Returns the perceived lightness of a paint on white paper: 0 black to 1 white (Rec. 601 luma, alpha over white). */
double plb_paint_lightness(paint p);

/* Returns the gradient that the item is painted with, borrowed; NULL when none is known. */
const gradient *plb_item_gradient(const display_list *list, const item *it);
/* Returns the gradient's paint at a place (mm), a solid one; alpha 0 where it paints nothing. */
paint plb_gradient_at(const gradient *g, point mm);
/* Tells whether the gradient is at least so opaque (0 to 1) wherever a fill may reach. */
bool plb_gradient_is_opaque(const gradient *g, double opacity);
/* Adds a stop behind the others; where there are too many the one goes whose colour its neighbours make best. */
void plb_gradient_add_stop(gradient *g, gradient_stop stop);

#endif
