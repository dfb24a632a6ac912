/* SPDX-License-Identifier: MIT
 *
 * The style sheets of a document: which declaration of a property wins for an element (CSS Cascade 4, section 6; Selectors
 * 3). It serves the steps that need to know a value which librsvg would misread; librsvg itself does the rest.
 */
#ifndef PLB_TAP_SVG_REWRITE_CSS_H
#define PLB_TAP_SVG_REWRITE_CSS_H

#include <glib.h>
#include <libxml/tree.h>
#include <stdbool.h>

typedef struct css_sheet css_sheet;

/* All style elements of the document, in order; freed with plb_css_free. */
css_sheet *plb_css_new(xmlDoc *doc);
void plb_css_free(css_sheet *sheet);

/* The declarations that apply to `n`, from its attributes, the rules and its style attribute: for each property the one
 * that wins. A table from names to values (strings of the table); a value that ends in "!important" keeps that. Freed with
 * g_hash_table_destroy. */
GHashTable *plb_css_declared(const css_sheet *sheet, const xmlNode *n);
/* The winning value of one property on the element itself; NULL: none. The caller's, without "!important". */
char *plb_css_value(const css_sheet *sheet, const xmlNode *n, const char *property);
/* The same, or the nearest ancestor's. */
char *plb_css_inherited(const css_sheet *sheet, const xmlNode *n, const char *property);

/* Sets a property in the style attribute, in place of what it says there now; NULL takes the property out of the style
 * attribute and out of the attributes. */
void plb_css_set(xmlNode *n, const char *property, const char *value);

#endif
