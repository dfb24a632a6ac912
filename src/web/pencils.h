/* SPDX-License-Identifier: MIT
 *
 * The pencils that a page has handed to the core.
 */
#ifndef PLB_WEB_PENCILS_H
#define PLB_WEB_PENCILS_H

#include <stdbool.h>
#include <stddef.h>

/* Keeps the file of a grade: `size` bytes, which must stay where they are. False: there is no such grade. */
bool plb_web_keep_pencil(const char *grade, const unsigned char *data, size_t size);
/* Returns, once, the grade whose file was asked for last and not there; NULL: none was missed. */
const char *plb_web_missing_pencil(void);

#endif
