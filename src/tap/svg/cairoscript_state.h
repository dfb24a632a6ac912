/* SPDX-License-Identifier: MIT
 *
 * Holds the state of the CairoScript reader: operand stack, surfaces, patterns and drawing contexts. Only the files
 * cairoscript*.c include this.
 */
#ifndef PLB_TAP_SVG_CAIROSCRIPT_STATE_H
#define PLB_TAP_SVG_CAIROSCRIPT_STATE_H

#include "base/array.h"
#include "base/error.h"
#include "tap/common/scan.h"
#include "list/display_list.h"
#include "list/text/list_write.h"

#include <stdint.h>

typedef enum { OBJECT_SURFACE, OBJECT_PATTERN, OBJECT_CONTEXT } script_kind;

/* Surfaces, patterns and contexts are shared by reference: each place that holds one counts. */
typedef struct {
    script_kind kind;
    unsigned references;
} script_object;

/* A script_surface is drawn on: the page itself, or a group of its own until it is painted somewhere. */
typedef struct {
    script_object head;
    display_list *list; /* the page's (clips, gradients), or `own` */
    display_list own;
    matrix to_list;     /* from this surface's units to the list's */
    double width, height;
    bool is_image;      /* pixels: nothing for us in it */
    size_t held;        /* its part of script_state.held */
} script_surface;

typedef struct {
    script_object head;
    paint paint;             /* solid colour; for gradients the sum over the stops */
    unsigned stops;
    gradient *gradient;      /* own; NULL: none */
    script_surface *surface; /* counted; NULL for colours and gradients */
    matrix matrix;           /* from the user's space to the pattern's */
    bool repeats;
} script_pattern;

typedef struct {
    script_object head;
    script_surface *target; /* counted */
    script_pattern *source; /* counted; NULL: opaque black */
    path path;              /* in the surface's units */
    matrix ctm;             /* acts on the pen alone: paths come in surface units */
    int clip;               /* in target->list */
    bool even_odd;
    bool draws, blends;     /* the operator adds ink; it mixes with what is there as pencils do not */
    bool multiplies;        /* it only darkens what is there */
    line_cap cap;
    double width, dash_offset;
    ARRAY(double) dash;
} script_context;

typedef enum {
    VALUE_MARK,
    VALUE_NUMBER,
    VALUE_NAME,     /* /s12 (number 12), or another name (code of it) */
    VALUE_CONSTANT, /* //NAME */
    VALUE_ARRAY,    /* of numbers */
    VALUE_IDENTITY,
    VALUE_OPAQUE,   /* strings, fonts, dictionaries: carried, never looked into */
    VALUE_OBJECT
} value_kind;

typedef struct {
    value_kind kind;
    union {
        double number;
        int code;
        script_object *object;
        struct {
            uint32_t first, n; /* into script_state.numbers */
        } array;
    };
} script_value;

/* A //CONSTANT has one of these meanings to the operator that takes it. */
enum { CONST_OTHER, CONST_BUTT, CONST_ROUND, CONST_SQUARE, CONST_EVEN_ODD, CONST_EXTEND_NONE, CONST_EXTEND_PAD, CONST_EXTEND_REFLECT, CONST_NO_INK, CONST_BLEND, CONST_MULTIPLY };

/* A /NAME has one of these codes; /s12 is 12. */
#define NAME_TARGET (-1)
#define NAME_SOURCE (-2)
#define NAME_OTHER (-3)

typedef struct {
    int id;
    script_object *object; /* counted */
} script_binding;

typedef struct script_state {
    scanner scan;
    ARRAY(char) text;      /* not run yet */
    size_t part;           /* so much of it is run at once */
    unsigned procedures;   /* how deep in { } it is */
    ARRAY(script_value) stack;
    ARRAY(double) numbers; /* of the arrays on the stack; emptied when there is none */
    size_t arrays;
    ARRAY(script_binding) bindings;
    display_list page; /* its clips and gradients, what was left out; its items go to: */
    list_writer *out;
    matrix written;    /* the map to mm that `out` has */
    matrix to_page;    /* from the outermost surface's units to mm */
    bool has_page;  /* the outermost surface was made */
    text_run *(*say)(void *closure, const path *p); /* NULL: nobody knows what paths say */
    void *say_closure;
    size_t objects, held; /* alive: objects; points on groups, items counted as some */
    error *err;
} script_state;

/* At most so many objects, bindings and values are alive at once; a deep drawing has some hundred. */
#define SCRIPT_MAX_OBJECTS 100000u
#define SCRIPT_MAX_STACK 100000u
#define SCRIPT_ITEM_POINTS 16u /* an item or clip takes the memory of so many points */

/* Each `new` gives one reference, to be released or handed on; NULL and an error on failure. */
script_surface *plb_script_new_surface(script_state *s, display_list *list);
script_pattern *plb_script_new_pattern(script_state *s, paint colour);
script_context *plb_script_new_context(script_state *s, script_surface *target);
void plb_script_release(script_state *s, script_object *o);

bool plb_script_push(script_state *s, script_value v);
/* Pushes and takes over the reference. */
bool plb_script_push_object(script_state *s, script_object *o);
bool plb_script_pop(script_state *s);
/* Gives the value `depth` below the top; NULL and an error when there is none. */
script_value *plb_script_peek(script_state *s, size_t depth);
/* Copies the topmost `n` values, all numbers, and pops them. */
bool plb_script_take(script_state *s, size_t n, double *numbers);
/* Gives the object on top, of that kind; borrowed. NULL and an error when there is none. */
void *plb_script_top(script_state *s, script_kind kind);
/* Pops a value of that kind; an error that speaks of `what` when another is there. */
bool plb_script_pop_kind(script_state *s, value_kind kind, const char *what);
void plb_script_free(script_state *s);

/* The operators stand in two tables, each sorted by name. */
typedef bool (*script_operation)(script_state *s);
typedef struct {
    const char *name;
    script_operation run;
} script_operator;
extern const script_operator plb_script_draw_operators[], plb_script_object_operators[];
extern const size_t plb_script_draw_count, plb_script_object_count;
/* Gives the binding of /s12 (12); NULL: there is none. */
script_binding *plb_script_lookup(script_state *s, int id);

/* cairoscript_paint.c paints. */
bool plb_script_fill(script_state *s, script_context *c);
bool plb_script_stroke(script_state *s, script_context *c);
/* Paints the source all over the clip; `alpha` below 1 for a mask of one opacity. */
bool plb_script_paint(script_state *s, script_context *c, double alpha);
bool plb_script_clip(script_state *s, script_context *c);

/* cairoscript_page.c writes what is on the page to the list. `m` maps the path to mm; widths and dashes are mm already. */
bool plb_script_write_item(script_state *s, const item *it, matrix m);
bool plb_script_write_clip(script_state *s, const clip *c, matrix m);
bool plb_script_is_sane_gradient(const gradient *g);
void plb_script_write_gradient(script_state *s, const gradient *g);

/* cairoscript_gradient.c gives the map from the surface's units to the gradient's, for the path that it fills (in the
 * surface's units; an empty one: the pattern's matrix as it is). */
matrix plb_script_gradient_matrix(const script_state *s, const script_pattern *p, const path *fills);

#endif
