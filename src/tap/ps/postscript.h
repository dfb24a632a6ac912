/* SPDX-License-Identifier: MIT
 *
 * Turns a PostScript program into a display list, as far as the program is paths: letters of fonts other than Type 3,
 * shadings, filters and resources are Ghostscript's.
 */
#ifndef PLB_TAP_PS_POSTSCRIPT_H
#define PLB_TAP_PS_POSTSCRIPT_H

#include "base/error.h"
#include "base/geometry/geom.h"
#include "list/display_list.h"

#include <stddef.h>

typedef struct {
    const char *data; /* the whole file, headers and all; lives as long as the call */
    size_t size;
    unsigned page;    /* which of several, from 1; 0: the first, and a word if there are others */
    bool alone;       /* there is no Ghostscript: what it would draw is left out and counted, or an error */
    bool only_count;  /* only the number of pages is wanted */
} ps_request;

typedef enum {
    PS_DRAWN,
    PS_FAILED,     /* `err` says why: "LINE: what", or "what" */
    PS_HANDED_OVER /* the same, but Ghostscript may draw it */
} ps_outcome;

#define PS_MAX_WARNINGS 3

typedef struct {
    unsigned pages; /* of the document; 0: not counted to the end */
    const char *warnings[PS_MAX_WARNINGS + 1]; /* ended by NULL */
    /* for Ghostscript: which page, blank ones counted (0: all); does the program end without showing it; what part of the
     * plane it is, in points */
    unsigned sheet;
    bool lacks_showpage;
    box area;
} ps_answer;

/* Draws one page onto `list`, which the caller initialised and frees in every case. A page that the document does not
 * have stays empty: answer->pages tells. */
ps_outcome plb_ps_read(const ps_request *ask, display_list *list, ps_answer *answer, error *err);

/* Gives the PostScript part of a file, without the header and previews of a DOS EPS, or a printer's job header. */
void plb_ps_find_program(const char *data, size_t size, const char **program, size_t *length);

#endif
