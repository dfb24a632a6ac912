/* SPDX-License-Identifier: MIT
 *
 * This header stands in for cairo's where there is none: the public header names a surface, and nothing in the browser's core has one.
 */
#ifndef PLB_WEB_STAND_IN_CAIRO_H
#define PLB_WEB_STAND_IN_CAIRO_H

typedef struct cairo_surface cairo_surface_t;

#endif
