/* SPDX-License-Identifier: MIT
 *
 * Circles among the edges of a mesh: the ends of cylinders and holes, which have centre lines on a technical drawing.
 */
#ifndef PLB_TAP_MODEL_LINE_CIRCLES_H
#define PLB_TAP_MODEL_LINE_CIRCLES_H

#include "tap/model/mesh/mesh.h"

typedef struct {
    vector centre, axis; /* in the model's space; the axis has length 1 */
    double radius;
} circle;
typedef ARRAY(circle) circle_list;

/* Adds the rings of creases that lie in a plane and around a centre, of at least CIRCLE_CORNERS corners. */
#define CIRCLE_CORNERS 12
bool plb_find_circles(const mesh *m, circle_list *out, error *err);

#endif
