/* SPDX-License-Identifier: MIT
 *
 * The words of the text form that its writer and its reader share, plumbago-list(5). Each table is in the order of its enum.
 */
#ifndef PLB_LIST_LIST_WORDS_H
#define PLB_LIST_LIST_WORDS_H

#define LIST_FIRST_WORD "plumbago-list"
#define LIST_VERSION "1"

static const char *const plb_list_shapes[] = {"linear", "radial"};
static const char *const plb_list_extends[] = {"ends", "pad", "repeat", "reflect"};
static const char *const plb_list_rules[] = {"nonzero", "evenodd"};
static const char *const plb_list_caps[] = {"butt", "round", "square"};
static const char *const plb_list_paints[] = {"colour", "gradient", "pattern"};

#endif
