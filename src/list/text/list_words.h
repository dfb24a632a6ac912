/* SPDX-License-Identifier: MIT
 *
 * The writer and the reader of the text form, plumbago-list(5), share these words. Each table is in the order of its enum.
 */
#ifndef PLB_LIST_TEXT_LIST_WORDS_H
#define PLB_LIST_TEXT_LIST_WORDS_H

#define LIST_FIRST_WORD "plumbago-list"
#define LIST_VERSION "1"

static const char *const plb_list_shapes[] = {"linear", "radial"};
static const char *const plb_list_extends[] = {"ends", "pad", "repeat", "reflect"};
static const char *const plb_list_rules[] = {"nonzero", "evenodd"};
static const char *const plb_list_caps[] = {"butt", "round", "square"};
#define LIST_HATCH "hatch"    /* before the direction of a fill's hatching */
#define LIST_TEXT "text"      /* before what a fill says */
#define LIST_CHARACTER "U+" /* before a character's codes, in hexadecimal digits */

static const char *const plb_list_paints[] = {"colour", "gradient", "pattern"};

#endif
