/* SPDX-License-Identifier: MIT
 *
 * A raw model is what a file says: places, faces with any number of corners, lines. Each reader fills one.
 */
#ifndef PLB_TAP_MODEL_READ_RAW_MODEL_H
#define PLB_TAP_MODEL_READ_RAW_MODEL_H

#include "base/array.h"
#include "base/error.h"
#include "tap/model/mesh/vector.h"

#include <stdint.h>

typedef struct {
    float red, green, blue; /* 0 to 1 */
} colour;

/* A surface paint is what a face is made of: its colour, and a number by which borders between materials are known. */
typedef struct {
    colour colour;
    uint32_t material;
} surface_paint;

typedef struct {
    uint32_t n;     /* corners */
    uint32_t paint; /* index into paints */
} raw_face;

typedef enum { UP_X, UP_Y, UP_Z } up_axis;

typedef struct {
    ARRAY(vector) places;         /* in the file's unit; those that are not finite are of no use */
    ARRAY(uint32_t) corners;      /* of all faces in a row: indices into places, not yet checked */
    ARRAY(raw_face) faces;
    ARRAY(uint32_t) wires;        /* lines without a face: pairs of indices into places */
    ARRAY(surface_paint) paints;  /* the first is white: no material */
    up_axis up;                   /* as is usual in files of the kind */
    double unit;                  /* mm; 0: the file does not say */
    unsigned long points;         /* without a face or line, met and left out */
    unsigned long curves;         /* free-form curves and surfaces, left out */
    unsigned long libraries;      /* files of materials that are named and not read */
    unsigned long pictures;       /* textures that are named and not read */
} raw_model;

/* Each reads data[0..size) into `m`, which is all zero. False: `err` says why, "LINE: what" where a line is to blame; ERROR_SYNTAX,
 * ERROR_UNSUPPORTED or ERROR_MEMORY. The caller frees in any case. */
bool plb_model_read_obj(const char *data, size_t size, raw_model *m, error *err);
bool plb_model_read_stl(const char *data, size_t size, raw_model *m, error *err);
bool plb_model_read_ply(const char *data, size_t size, raw_model *m, error *err);
bool plb_model_read_off(const char *data, size_t size, raw_model *m, error *err);

void plb_raw_model_free(raw_model *m);

/* Adds a face of n corners, whatever their number; false when out of memory. */
bool plb_raw_model_add_face(raw_model *m, const uint32_t *corners, size_t n, uint32_t paint);
/* Gives the paint of a colour without a material of its own; colours are kept to a sixteenth, so that few serve a whole surface. False
 * when out of memory. */
bool plb_raw_model_tint(raw_model *m, double red, double green, double blue, uint32_t *paint);
/* Gives the paint of a face whose corners have the colours v[corner], the mean of them. */
bool plb_raw_model_mean_tint(raw_model *m, const colour *v, const uint32_t *corners, size_t n, uint32_t *paint);

#endif
