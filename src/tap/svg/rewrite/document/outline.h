/* SPDX-License-Identifier: MIT
 *
 * Gives outlines of elements, in px of their own user space: for lengths, boxes and places along a path.
 */
#ifndef PLB_TAP_SVG_REWRITE_DOCUMENT_OUTLINE_H
#define PLB_TAP_SVG_REWRITE_DOCUMENT_OUTLINE_H

#include "base/geometry/path.h"
#include "tap/svg/rewrite/document/node.h"

/* Gives the outline of a basic shape or a path, without its transform; empty for other elements. Freed with
 * plb_path_free. The part before a fault in path data counts (SVG 1.1, F.2). */
path plb_outline(const xmlNode *n);
/* Gives points along an outline: straight pieces, close enough for lengths to 0.1 %. Each subpath but the first is led
 * to by a jump: `jump[i]` true says that no line leads to point i. The caller frees both arrays with g_free. */
size_t plb_outline_points(const path *p, point **at, bool **jump);
/* Gives the length of all pieces, jumps left out. */
double plb_outline_length(const path *p);
/* Gives the box around an element and its contents, under the transforms inside the element but not its own; empty when
 * nothing in it has an outline. */
box plb_outline_box(const xmlNode *n);

/* Gives the map from an element's user space to the px of the outermost drawing: transforms, and the viewBoxes on the
 * way. `itself`: with its own transform. */
matrix plb_outline_to_root(const xmlNode *n, bool itself);
/* Gives the size of the viewport that contains an element (a viewBox's, or the outer size), for percentages. */
box plb_outline_viewport(const xmlNode *n);

#endif
