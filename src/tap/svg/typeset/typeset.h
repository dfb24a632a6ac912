/* SPDX-License-Identifier: MIT
 *
 * Text reaches cairo as outlines. So that the list can say which characters they are, each glyph whose outline Pango asks for is
 * written down, and a fill whose path is made of such outlines is recognised by them.
 */
#ifndef PLB_TAP_SVG_TYPESET_TYPESET_H
#define PLB_TAP_SVG_TYPESET_TYPESET_H

#include "base/geometry/path.h"
#include "list/characters.h"

/* Forgets all glyphs: the document is drawn once more. */
void plb_typeset_forget(void);
/* Returns what the path says, in its own units (the size as well), or NULL where it does not begin with the outlines of glyphs written
 * down lately. The caller frees it. `closure` is not used. */
text_run *plb_typeset_recognise(void *closure, const path *p);

#endif
