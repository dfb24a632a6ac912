/* SPDX-License-Identifier: MIT
 *
 * Files that users take for drawings and that are none for us: named as what they are, with what would help.
 */
#ifndef PLB_INPUT_FORMAT_FOREIGN_H
#define PLB_INPUT_FORMAT_FOREIGN_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *what, *help;
} foreign_format;

/* Gives what the file is; NULL: nothing that is known here. */
const foreign_format *plb_foreign_find(const char *data, size_t size);

/* Unpacks the first bytes of a gzip file into `start`; gives how many. */
size_t plb_gzip_look_inside(const char *data, size_t size, char *start, size_t room);

#endif
