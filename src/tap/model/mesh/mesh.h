/* SPDX-License-Identifier: MIT
 *
 * A mesh is a model made ready: triangles with common corners, which of them meet in an edge, which edges are seen, and the normals of
 * the smooth surfaces that the triangles stand for.
 */
#ifndef PLB_TAP_MODEL_MESH_MESH_H
#define PLB_TAP_MODEL_MESH_MESH_H

#include "tap/model/read/raw_model.h"

#define NO_TRIANGLE UINT32_MAX

typedef struct {
    uint32_t corner[3]; /* indices into places */
    uint32_t face;      /* the polygon it is part of: triangles of one polygon have the same number */
    uint32_t paint;
} triangle;

/* A half edge is a side of a triangle, or the part of one between two places that other triangles have on it. */
typedef struct {
    uint32_t a, b; /* places, a < b */
    uint32_t side; /* 3 * triangle + k: the side from corner k to the next */
} half_edge;

typedef enum {
    EDGE_SMOOTH,   /* the surface goes on, or turns a little: seen only where its outline happens to be */
    EDGE_BORDER,   /* the surface ends */
    EDGE_CREASE,   /* it turns sharply, or surfaces meet */
    EDGE_MATERIAL, /* the surface goes on, of another material */
} edge_kind;

typedef struct {
    uint32_t a, b;     /* places, a < b */
    uint32_t first, n; /* its half edges */
    edge_kind kind;
    bool is_coarse;    /* smooth, yet it turns so far that the outline of the surface runs along it */
} edge;

typedef struct {
    ARRAY(vector) places;      /* in the model's unit, z upwards */
    ARRAY(triangle) triangles; /* with an area, no two of the same corners */
    ARRAY(vector) normals;     /* of the triangles, length 1, by the order of the corners */
    ARRAY(half_edge) halves;   /* grouped by edges */
    ARRAY(edge) edges;
    ARRAY(uint32_t) side_edge; /* by 3 * triangle + side: the edge, NO_TRIANGLE where the side is in several */
    ARRAY(uint32_t) patch;     /* by triangle: the number of the smooth surface that it is part of */
    ARRAY(unsigned char) is_turned; /* by triangle: its corners go round the other way than most of its patch's */
    ARRAY(uint32_t) group;     /* by 3 * triangle + corner: an index into `smooth` */
    ARRAY(vector) smooth;      /* normals of the smooth surface there, length 1; sides as most of the patch's triangles have them */
    ARRAY(uint32_t) wires;     /* pairs of places */
    ARRAY(surface_paint) paints;
    uint32_t patches;
    double size;               /* diagonal of the box around all */
    unsigned long lost;        /* faces left out because a corner is nowhere */
} mesh;

/* The steps, in order; each false when out of memory. */

/* Cuts faces into triangles by clipping ears and takes the places over, z upwards. Takes `from`'s paints and wires. */
bool plb_mesh_make(raw_model *from, up_axis up, mesh *m, error *err);
/* Makes one place of those that lie together, and drops triangles without an area or of the same corners. */
bool plb_mesh_weld(mesh *m, error *err);
/* Finds the edges; where a place lies within the side of a triangle at the surface's border, the side is cut there. */
bool plb_mesh_edges(mesh *m, error *err);
/* Says which edges are seen; `crease` is the angle, radians, from which a turn is sharp. */
bool plb_mesh_classify(mesh *m, double crease, error *err);
/* Finds the smooth surfaces and their normals. */
bool plb_mesh_smooth(mesh *m, error *err);

void plb_mesh_free(mesh *m);

/* Puts triangles for the polygon corners[0..n) into `out`, three numbers from 0 to n - 1 for each; they fill it without
 * its dents and holes (which a line to the rim makes part of the outline). At most 3 * (n - 2). */
typedef ARRAY(uint32_t) number_list;
bool plb_polygon_triangles(const vector *corners, size_t n, number_list *out, error *err);

static inline vector mesh_corner(const mesh *m, size_t t, int k) { return m->places.v[m->triangles.v[t].corner[k]]; }

#endif
