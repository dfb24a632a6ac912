/* SPDX-License-Identifier: MIT
 *
 * One stroke of the pencil: the path of the arm, then the graphite along it. This folder is the science; it reads no
 * file, draws on no surface and knows no clock. The model and its sources are told in plumbago(7).
 */
#ifndef PLB_STROKE_STROKE_H
#define PLB_STROKE_STROKE_H

#include "base/array.h"
#include "base/error.h"
#include "base/patch.h"
#include "list/stroke_list.h"
#include "profile/hand.h"
#include "profile/profile.h"

typedef enum {
    MODEL_HLA,     /* the papers' algorithm */
    MODEL_GRAPHITE /* as measured on real lines */
} line_model;
typedef enum { ARM_JERK, ARM_SPRING, ARM_HAND, ARM_LOGNORMAL, ARM_TORQUE } arm_model;
typedef enum { HANDED_NONE, HANDED_RIGHT, HANDED_LEFT } handedness; /* NONE: no direction is drawn in another way */

/* A profile made ready for drawing: tables computed once. Immutable; shared by all strokes and threads. */
typedef struct pencil pencil;
/* What the pencil draws on. */
typedef enum { PAPER_NONE, PAPER_SMOOTH, PAPER_MEDIUM, PAPER_ROUGH } paper_kind;
/* For the papers' model, and for the graphite model on a paper. Both borrow `p`, which must live longer. NULL and `err` when
 * out of memory. */
pencil *plb_pencil_new(const profile *p, error *err);
pencil *plb_pencil_on_paper(const profile *p, paper_kind on, error *err);
void plb_pencil_free(pencil *p);

typedef struct {
    const pencil *pencil;
    uint64_t seed;
    line_model model;
    arm_model arm;
    handedness handed;
    double squiggle; /* largest deviation D, mm, >= 0; negative: the arm's own */
    double hand;     /* how far the pencil's own hand strays where no squiggle says, times a free hand; 0: as 1 */
    double dpi;      /* of the page's pixels */
    int clip_top, clip_bottom; /* only the page's rows [top, foot) are wanted; both 0: all */
    double pressure; /* times each stroke's own; 0: as 1 */
} stroke_options;

/* ---- stages, each usable and testable alone ---- */

/* A control point in the line's own frame: how far along the line, how far off it (to the left of its direction). */
typedef struct {
    double along, off; /* mm */
} control;
#define CONTROLS_MAX 16

/* The control points of a line of `length` mm, whose last point lies `way` from its first (path_controls.c; 001 section
 * 3.1). Their count, at most CONTROLS_MAX. */
size_t plb_path_controls(double length, point way, uint64_t identity, const stroke_options *o, control out[CONTROLS_MAX]);
/* The share of the way that an arm has done at the share tau of the time. */
double plb_arm_progress(uint64_t identity, const stroke_options *o, double tau);
/* By Plamondon's delta-lognormal, and how far its arc bows out, as a share -1 to 1 (path_lognormal.c). */
double plb_lognormal_progress(uint64_t key, double tau);
double plb_lognormal_bow(uint64_t key);
/* How far the movement of least change of torque bows out, mm to the left of `way` (path_torque.c). */
double plb_torque_bow(point way, handedness handed);
/* The largest deviation D in force for a line of `length` mm, in mm: it shrinks with short lines (plumbago(7)). */
double plb_path_squiggle(double length, const stroke_options *o);

/* How a free hand deviates from one line: ARM_HAND's, instead of D at control points. path_hand.c fills the modes,
 * path_direction.c and path_hooks.c the rest. All in the line's own frame, first to last, to the left; mm. */
#define HAND_WAVES 32 /* of the longest lines; the first HAND_MODES as measured, the others as these fall off */
typedef struct {
    double length;
    bool closed;
    int waves;                 /* so many modes are not shorter than a hand makes */
    double strength;           /* 1: a free hand */
    double amplitude[HAND_WAVES];
    double late;               /* the second half of the way deviates so much more, and the first less (a share) */
    double lean, drift;        /* of the way's second half, and of its free end */
    bool backward;             /* the hand draws from last to first */
    double hook_first, hook_last, hook_reach; /* of free ends, and over which length */
} hand;
hand plb_hand(double length, bool closed, uint64_t identity, const stroke_options *o);
/* On a curve the modes go by how far it reaches, `extent` in mm, instead of by its length. */
void plb_hand_reach(hand *h, double extent);
/* How far off the line the hand is at `along` mm from its start: mm to the left of the direction. */
double plb_hand_off(const hand *h, double along);

/* Whether a hand draws a line from its last point to its first; `way` leads from first to last (path_direction.c). */
bool plb_hand_backward(point way, handedness handed);
/* What depends on the direction in which a line is drawn. `free_end`: no other line goes on where it ends. */
void plb_hand_direct(hand *h, point way, bool free_end, const stroke_options *o);
/* The pressure at the beginning and at the end of the movement, times the usual. */
void plb_hand_pressure(point way, double length, const stroke_options *o, float *begin, float *end);
/* Hooks at the ends that are free (path_hooks.c). */
void plb_hand_hooks(hand *h, bool free_first, bool free_last, uint64_t identity, const stroke_options *o);

/* Keeps the deviation within about `room` mm of the line: another one runs beside it (path_hand.c). */
void plb_hand_keep(hand *h, double room);

/* A point of a drawn path. */
typedef struct {
    point at;      /* mm on the page */
    point tangent; /* unit vector */
    double along;  /* arc length from the start, mm */
} path_sample;
/* A drawn path: an ARRAY of samples, and how it is drawn. */
typedef struct {
    path_sample *v;
    size_t n, room;
    bool closed;   /* ends where it starts, smoothly: what goes along it runs on across the joint */
    bool backward; /* the hand starts at the last sample: there the pencil is set down, at the first it is lifted */
    float pressure_first, pressure_last; /* times the stroke's own pressure; evenly changing along the path; usually 1 */
} path_samples;

/* The drawn path of stroke `s`, sampled closely enough to be joined by straight lines (path.c). `out` is
 * replaced. */
bool plb_path_sample(const stroke_list *list, const stroke *s, const stroke_options *o, path_samples *out, error *err);
/* The control points as places on the page, for --dump=controls. */
size_t plb_path_control_points(const stroke_list *list, const stroke *s, const stroke_options *o, point out[CONTROLS_MAX]);

/* The texture in the strip frame: `columns` along the line, `rows` across (odd, the middle row is the centreline),
 * one byte a pixel of the profile's resolution, 255 = paper; row by row. */
#define STRIP_MARGIN 2 /* pixels of paper around it: one for the blur, one for interpolation */
typedef struct {
    int columns, rows;
    size_t room;
    uint8_t *grey, *spare; /* spare: of the same size, for the blur */
} strip;
void plb_strip_free(strip *s);

/* Each step of 001 section 3.2 by itself (texture_fill.c, texture_ccm.c, texture_blur.c). */
bool plb_texture_fill(strip *s, double length_px, const pencil *p, uint64_t seed, uint64_t identity, error *err);
/* Returns the number of passes; `changes` (may be NULL, else room for CCM_MAX_PASSES) gets the changes of each. */
#define CCM_MAX_PASSES 32
int plb_texture_ccm(strip *s, const pencil *p, long changes[CCM_MAX_PASSES]);
void plb_texture_blur(strip *s);
/* Lets a closed line's texture run on across its joint: the margins at the ends take the columns of the other end. */
void plb_texture_wrap(strip *s);
/* All three in order; `closed` strokes are wrapped. */
bool plb_texture(strip *s, double length_px, bool closed, const pencil *p, uint64_t seed, uint64_t identity, error *err);

/* Evenly spaced samples of a texture, a row of them on the page. */
typedef struct {
    int n;
    double along, along_step;   /* the first one's place and the way to each next, px of the texture from the line's start */
    double across, across_step; /* … and from its centreline, positive to the right */
    double x, y, step;          /* the first one's place on the page and the way to each next (in x), mm */
} sample_row;

/* A texture in the strip frame, as the mapping asks for it. */
typedef struct {
    const void *texture;
    /* Darkness, 0 to 255, of each sample of `n` rows, one after the other, into `out`. */
    void (*shade)(const void *texture, const sample_row *rows, int n, uint8_t *out);
    bool one_by_one;   /* rows have one sample: each at its exact place, no matter what it costs */
    double half_width; /* px: farther across there is none */
    double beyond;     /* px: how far it reaches beyond the ends of an open line */
    double dpi;        /* of its pixels */
    bool whole_pixels; /* a sample stands for a whole pixel of the page, however coarse that is */
} shading;

/* The papers' strip as such a texture (bilinear between its pixels). */
shading plb_strip_shading(const strip *s, double dpi);
/* Its greys darker or paler, as `pressure` has it. */
void plb_strip_press(strip *s, double pressure);

/* Room for mapping, kept from stroke to stroke. */
typedef struct {
    uint8_t *fine;
    size_t size;
} map_room;

/* No pencil leaves graphite farther than this from its path, whatever a profile says. */
#define STROKE_REACH_MM 4.0

/* The page as the mapping sees it: its resolution, and the rows [top, foot) that are wanted. */
typedef struct {
    double dpi;
    int top, foot;
} map_page;

/* Lays the texture along the path and hands out the patches it makes on the page (strip_map.c). A pixel of the page belongs
 * to one patch of a stroke only, except where the stroke crosses itself. The rows wanted get the same pixels whatever
 * others are. */
bool plb_strip_map(const shading *s, const map_page *page, const path_samples *path, bool closed, map_room *room, patch_sink sink,
                   void *closure);

/* ---- the graphite model (texture_grain.c, texture_shade.c, texture_paper.c) ---- */

/* Where the sheet of paper lies under the page: another seed, another place. */
#define PAPER_TILES 2
typedef struct {
    int x[PAPER_TILES], y[PAPER_TILES]; /* texels, 0 to the tile's side */
} paper_sheet;

/* The texture of one stroke: its own part of a field of normal scores, and what the scores mean at each place. */
typedef struct {
    const pencil *pencil;
    int columns, rows;       /* px along and across; rows odd */
    int stride;              /* of a column of the field */
    int8_t *field;           /* [column][row] */
    uint8_t *level;          /* [knot][place]: expected darkness */
    uint8_t *ends;           /* [column]: pressure, of 255; 255 but near the ends */
    size_t field_room, level_room, ends_room;
    int plain_first, plain_last; /* between these columns `ends` is 255 */
    int weight_field, weight_paper; /* of the stroke's own field and the paper's heights in the score, of 256 */
    const int8_t *bend;      /* of this line's roughness: score less field value */
    uint32_t depth;          /* 255 - grey of the line's middle, in 1/256 */
    float narrow;            /* px at the pencil's mean width per px across: this line's own width */
    float half_width, half_reference; /* half the mean width and half the profile's, px: inside places stretch, outside not */
    const void *darkness;    /* the pencil's table for pixels of the page's size */
    int32_t foot;            /* a third of a coarse pixel, in steps of place; 0: the page is not coarse */
    float ragged;            /* px by which a point may look beside its own pixel of the field, on finer pages */
    float cap_first, cap_last; /* radius of the round caps at corners, px; 0: none */
    paper_sheet sheet;
} grain;
void plb_grain_free(grain *g);

/* What happens at the two ends of a stroke: the pencil is set down, lifted, goes on round a corner, or meets its own
 * beginning (both ends of a closed stroke). */
typedef enum { GRAIN_START, GRAIN_LEAVE, GRAIN_CORNER, GRAIN_JOINT } grain_end;
typedef struct {
    grain_end first, last;
    float pressure_first, pressure_last; /* times the usual, changing evenly between the ends; 0: usual */
    bool careful;                        /* as in lettering: a fine point, and strokes more alike */
} grain_ends;

/* Pages finer than this show single pixels of the field: their edges are broken up. */
#define GRAIN_RAGGED_DPI 375.0

/* Fills `g` for a stroke of `length_px` (of 1/300 inch, as the whole grain is). Needs a profile with a grain. */
bool plb_grain_make(grain *g, double length_px, grain_ends ends, const pencil *p, uint64_t seed, uint64_t identity, error *err);
/* Pages coarser than this have pixels of several of the field, as far down as that; still coarser ones, means of samples. */
#define GRAIN_COARSE_DPI 200.0
#define GRAIN_COARSEST_DPI 67.0

/* As a texture of `dpi` px per inch for a page of `page_dpi`. */
shading plb_grain_shading(grain *g, double dpi, double page_dpi);

/* Room that a thread keeps from stroke to stroke. */
typedef struct {
    path_samples path;
    strip strip;
    grain grain;
    map_room map;
} stroke_scratch;
void plb_stroke_scratch_free(stroke_scratch *s);

/* The whole stroke. False and `err` when out of memory, over a limit, or when the sink stops it. */
bool plb_stroke_draw(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, patch_sink sink,
                     void *closure, error *err);

/* Rows [top, foot) of the page that the stroke may touch, of options->dpi. */
bool plb_stroke_rows(const stroke_list *list, const stroke *s, const stroke_options *o, stroke_scratch *scratch, int *top, int *foot,
                     error *err);

#endif
