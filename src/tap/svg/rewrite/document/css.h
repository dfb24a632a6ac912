/* SPDX-License-Identifier: MIT
 *
 * Tells which declaration of a property wins for an element, in the style sheets of a document (CSS Cascade 4, section
 * 6; Selectors 3). The steps need the values that librsvg would misread; librsvg itself does the rest.
 */
#ifndef PLB_TAP_SVG_REWRITE_DOCUMENT_CSS_H
#define PLB_TAP_SVG_REWRITE_DOCUMENT_CSS_H

#include <glib.h>
#include <libxml/tree.h>
#include <stdbool.h>

typedef struct css_sheet css_sheet;

/* Reads all style elements of the document, in order; freed with plb_css_free. */
css_sheet *plb_css_new(xmlDoc *doc);
void plb_css_free(css_sheet *sheet);

/* Gives the declarations that apply to `n`, from its attributes, the rules and its style attribute: for each property
 * the one that wins. The table maps names to values (strings of the table); a value that ends in "!important" keeps the
 * mark. Freed with g_hash_table_destroy. */
GHashTable *plb_css_declared(const css_sheet *sheet, const xmlNode *n);
/* Gives the winning value of one property on the element itself, without "!important"; NULL: none. The caller frees it. */
char *plb_css_value(const css_sheet *sheet, const xmlNode *n, const char *property);
/* Gives what the element's style attribute alone says of a property, without "!important"; NULL: nothing. */
char *plb_css_in_style(const xmlNode *n, const char *property);
/* Gives the winning value on the element or the nearest ancestor that has one. */
char *plb_css_inherited(const css_sheet *sheet, const xmlNode *n, const char *property);

/* Sets a property in the style attribute, in place of its value there; NULL takes the property out of the style
 * attribute and out of the attributes. */
void plb_css_set(xmlNode *n, const char *property, const char *value);

#endif
