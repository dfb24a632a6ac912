/* SPDX-License-Identifier: MIT
 *
 * The graphite model's texture is one stroke's part of a field of grain.
 */
#ifndef PLB_STROKE_TEXTURE_GRAPHITE_GRAIN_FIELD_H
#define PLB_STROKE_TEXTURE_GRAPHITE_GRAIN_FIELD_H

#include "base/error.h"
#include "stroke/mapping/strip_map.h"

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
    size_t field_capacity, level_capacity, ends_capacity;
    int plain_first, plain_last; /* between these columns `ends` is 255 */
    int weight_field, weight_paper; /* of the stroke's own field and the paper's heights in the score, of 256 */
    const int8_t *score_correction; /* of this line's roughness: score less field value */
    uint32_t depth;          /* 255 - grey of the line's middle, in 1/256 */
    float narrow;            /* px at the pencil's mean width per px across: this line's own width */
    float half_width, half_reference; /* half the mean width and half the profile's, px: inside places stretch, outside not */
    const void *darkness;    /* the pencil's table for pixels of the page's size */
    int32_t sample_step;     /* a third of a coarse pixel, in steps of place; 0: the page is not coarse */
    float ragged;            /* px by which a point may look beside its own pixel of the field, on finer pages */
    float cap_first, cap_last; /* radius of the round caps at corners, px; 0: none */
    paper_sheet sheet;
} grain;
void plb_grain_free(grain *g);

/* At an end of a stroke the pencil is set down, is lifted, goes on round a corner, or meets its own
 * beginning (both ends of a closed stroke). */
typedef enum { GRAIN_START, GRAIN_LEAVE, GRAIN_CORNER, GRAIN_JOINT } grain_end;
typedef struct {
    grain_end first, last;
    float pressure_first, pressure_last; /* times the usual, changing evenly between the ends; 0: usual */
    bool careful;                        /* as in lettering and hatching: strokes are more alike */
    float breadth;                       /* of the point, times the captured line's; 0: as captured */
} grain_ends;

/* Pages finer than this show single pixels of the field: their edges are broken up. */
#define GRAIN_RAGGED_DPI 375.0

/* Fills `g` for a stroke of `length_px` (of 1/300 inch, as the whole grain is). Needs a profile with a grain. */
bool plb_grain_make(grain *g, double length_px, grain_ends ends, const pencil *p, uint64_t seed, uint64_t identity, error *err);
/* Pages coarser than this have pixels of several of the field, as far down as that; still coarser ones, means of samples. */
#define GRAIN_COARSE_DPI 200.0
#define GRAIN_COARSEST_DPI 67.0

/* Gives the field as a texture of `dpi` px per inch for a page of `page_dpi`. */
shading plb_grain_shading(grain *g, double dpi, double page_dpi);

#endif
