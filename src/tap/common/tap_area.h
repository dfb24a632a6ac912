/* SPDX-License-Identifier: MIT
 *
 * Finds shapes without an area, whose filling leaves no ink.
 */
#ifndef PLB_TAP_COMMON_TAP_AREA_H
#define PLB_TAP_COMMON_TAP_AREA_H

#include "base/geometry/path.h"

#include <stdbool.h>

/* True when no subpath has an area: a lone line is "filled" by many drawings, because filling is SVG's default. The path
 * is in units of cairo's script surface. */
bool plb_tap_has_no_area(const path *p);

#endif
