/* SPDX-License-Identifier: MIT
 *
 * Declares the steps that rewrite a document into one that librsvg 2.54 draws right. Each takes the document that the
 * step before left.
 */
#ifndef PLB_TAP_SVG_REWRITE_STEPS_H
#define PLB_TAP_SVG_REWRITE_STEPS_H

#include "tap/svg/rewrite/document/css.h"
#include "tap/svg/rewrite/document/node.h"
#include "tap/svg/rewrite/rewrite.h"

/* The steps share this state. */
typedef struct {
    xmlDoc *doc;
    css_sheet *sheet;
    GHashTable *ids; /* of plb_node_ids; new elements that others refer to are added */
    rewrite_report *report;
    unsigned renders; /* how often librsvg was asked, in all */
    bool changed;     /* a step has changed the document */
} rewriting;

/* values.c turns var(), modern colours and the property d into what librsvg knows, in the style attribute of each element. */
void plb_rewrite_values(rewriting *r);
/* labels.c decides what a switch shows; HTML in foreignObject becomes a line of text; the notice that text is not SVG goes. */
void plb_rewrite_labels(rewriting *r);
/* Puts `n` into a new group that takes over its transformation, and the other properties that act on all of it when `whole`:
 * so the group's user space is that of the element, and nothing acts twice. */
xmlNode *plb_rewrite_wrap(rewriting *r, xmlNode *n, bool whole);

/* images.c turns images that are SVG into nested drawings. */
void plb_rewrite_images(rewriting *r);
/* text.c places text one character at a time: lists of places, text on a path, text of a given length. */
void plb_rewrite_text(rewriting *r);
/* transforms.c resolves transform-origin and transform-box. */
void plb_rewrite_transforms(rewriting *r);
/* strokes.c keeps the width of non-scaling strokes, and scales dashes by pathLength. */
void plb_rewrite_strokes(rewriting *r);
/* filters.c gives an element the colour that its filter makes. */
void plb_rewrite_filters(rewriting *r);
/* patterns.c lays out tiles of lines and dots. */
void plb_rewrite_patterns(rewriting *r);
/* masks.c turns masks of black and white, and clip paths that are clipped themselves, into plain clip paths. */
void plb_rewrite_masks(rewriting *r);

#endif
