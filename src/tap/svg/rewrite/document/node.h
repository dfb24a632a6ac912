/* SPDX-License-Identifier: MIT
 *
 * Handles the elements of an SVG document and their attributes for the rewriting steps. Names are compared without
 * their namespace's prefix. Strings that a function gives are the caller's, freed with g_free, unless said otherwise.
 */
#ifndef PLB_TAP_SVG_REWRITE_DOCUMENT_NODE_H
#define PLB_TAP_SVG_REWRITE_DOCUMENT_NODE_H

#include "base/geometry/geom.h"

#include <glib.h>
#include <libxml/tree.h>
#include <stdbool.h>

/* A step looks at elements down to this depth: librsvg itself refuses deeper documents. */
#define NODE_MAX_DEPTH 1000

bool plb_node_is(const xmlNode *n, const char *name);
/* Tells whether `n` is one of the NULL-terminated names. */
bool plb_node_is_any(const xmlNode *n, const char *const names[]);
/* Tells whether `n` is a basic shape or a path, which have an outline. */
bool plb_node_is_shape(const xmlNode *n);
/* Tells whether `n` is a clip path, mask, pattern or marker, or lies in one: others are drawn by it. */
bool plb_node_is_definition(const xmlNode *n);

/* Gives the text of an attribute; NULL when the element has none of that name. */
char *plb_node_get(const xmlNode *n, const char *name);
void plb_node_set(xmlNode *n, const char *name, const char *value);
void plb_node_set_number(xmlNode *n, const char *name, double value);
void plb_node_remove(xmlNode *n, const char *name);
/* Gives the attribute as a length in px (em: 16, ex: 8); `share_of` is what 100 % stand for; `otherwise` where it is
 * absent or no length. */
double plb_node_length(const xmlNode *n, const char *name, double share_of, double otherwise);

/* Gives the next element in document order within `top`; NULL at the end. */
xmlNode *plb_node_next(const xmlNode *n, const xmlNode *top);
/* Makes an element of SVG's namespace as that of `like`, not yet in the document. */
xmlNode *plb_node_new(const xmlNode *like, const char *name);
/* Puts a new group in the place of `n` and `n` into the group. */
xmlNode *plb_node_wrap(xmlNode *n);
/* Takes `n` out of the document and frees it. */
void plb_node_drop(xmlNode *n);
/* Gives the element that `href` or `url(#...)` in `text` refers to; NULL: none. `ids`: of plb_node_ids. */
xmlNode *plb_node_referred(GHashTable *ids, const char *text);
/* Makes a table from ids to elements, the first of each; freed with g_hash_table_destroy. Borrows the document. */
GHashTable *plb_node_ids(xmlDoc *doc);
/* Gives `n` an id of its own unless it has one, and returns the id. */
char *plb_node_name(xmlNode *n, GHashTable *ids, const char *stem);

/* Reads the transformation that a `transform` attribute's text says, in CSS's spelling or SVG's; identity where `text`
 * is NULL; false when the text is not well-formed. */
bool plb_node_transform(const char *text, matrix *m);
/* Writes "matrix(a b c d e f)". */
char *plb_node_matrix_text(matrix m);

#endif
