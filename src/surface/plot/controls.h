/* SPDX-License-Identifier: MIT
 *
 * This header draws a picture in the manner of the papers' Figure 3.2: the path of each stroke, its control points as red dots.
 */
#ifndef PLB_SURFACE_PLOT_CONTROLS_H
#define PLB_SURFACE_PLOT_CONTROLS_H

#include "base/error.h"
#include "base/geometry/geom.h"

#include <stddef.h>
#include <stdio.h>

typedef struct controls_picture controls_picture;

/* Makes a page of width × height mm at `dpi`. NULL and `err` on failure. */
controls_picture *plb_controls_new(double width, double height, double dpi, error *err);
void plb_controls_free(controls_picture *c);
/* Add a path, and dots; all points are in mm on the page. */
void plb_controls_add_path(controls_picture *c, const point *at, size_t n);
void plb_controls_add_dots(controls_picture *c, const point *at, size_t n);
/* Writes the picture as PNG. `name` is for messages. */
bool plb_controls_write(controls_picture *c, FILE *to, const char *name, error *err);

#endif
