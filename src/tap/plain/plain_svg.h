/* SPDX-License-Identifier: MIT
 *
 * Plain SVG becomes a display list without librsvg and cairo, in a twentieth of the time. Plain is what CAD programs,
 * plotters and scripts write: groups, paths and basic shapes with colours, transforms and a size. librsvg stays the judge
 * of all else and of what the plain means:
 *
 *   - The subset is strict. An element or property that may have an effect and is not on its lists, or a value that is not
 *     written in the way of the specifications, makes the document unplain as a whole, before a byte is written; it then goes
 *     through librsvg as if this file were not there. So does all that is malformed: librsvg says what is wrong with it.
 *   - What is on the lists is drawn as librsvg and cairo draw it: the same page, the same turn, the same points to 1/256
 *     of a surface unit, the same order. A test compares both roads (tests/plain.sh).
 */
#ifndef PLB_TAP_PLAIN_PLAIN_SVG_H
#define PLB_TAP_PLAIN_PLAIN_SVG_H

#include "tap/plain/plain_list.h"

#define PLAIN_WHY 100

/* text[0..size): the document. True: list->text is the whole output, to be released by plb_plain_list_free. False: it
 * is not plain (nothing is to be released), and `why` says what was met first. */
bool plb_plain_svg(const char *text, size_t size, plain_list *list, char why[PLAIN_WHY]);

#endif
