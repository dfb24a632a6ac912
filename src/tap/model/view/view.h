/* SPDX-License-Identifier: MIT
 *
 * A view is a mesh as it is seen from somewhere, on paper: x to the right, y downwards, z towards the eye, all mm. In perspective
 * the depth is the projective one, so that planes stay planes and straight lines straight; from here on every view is a parallel one.
 */
#ifndef PLB_TAP_MODEL_VIEW_VIEW_H
#define PLB_TAP_MODEL_VIEW_VIEW_H

#include "base/geometry/geom.h"
#include "tap/model/mesh/mesh.h"

typedef struct {
    double azimuth;     /* degrees: 0 sees the front, 90 the right side */
    double elevation;   /* degrees above the ground */
    double perspective; /* degrees that the view spans; 0: parallel */
} direction_of_view;

typedef struct {
    const mesh *m;
    vector right, up, toward; /* of the picture, in the model's space, length 1 */
    double distance;          /* of the eye from the middle, in the model's unit; 0: parallel */
    double scale;             /* mm on paper for the model's unit, at the middle */
    ARRAY(vector) at;         /* the places on paper */
    ARRAY(unsigned char) is_front; /* by triangle: the side from which its corners go counter-clockwise is seen */
    box bounds;               /* of the places, mm */
} view;

/* Looks at the mesh; the scale is 1 and the middle of the model lies at 0 0. The mesh is borrowed. */
bool plb_view_make(const mesh *m, direction_of_view from, view *v, error *err);
/* Enlarges the view, then moves it. */
void plb_view_place(view *v, double scale, double x, double y);
void plb_view_free(view *v);

/* Gives the direction to the eye, length 1, from a place of the model. */
vector plb_view_to_eye(const view *v, vector place);

static inline vector view_corner(const view *v, size_t t, int k) { return v->at.v[v->m->triangles.v[t].corner[k]]; }

/* Gives the largest of the preferred scales of ISO 5455 at which so much of the thing, mm, fits the paper beside what is blank in any
 * case, mm on paper; as for DXF. */
double plb_view_scale(double width, double height, double blank_width, double blank_height);

#define VIEW_MARGIN 5.0 /* mm around the drawing, as for DXF; chosen by eye */

#endif
