/* SPDX-License-Identifier: MIT
 *
 * Ghostscript reads PostScript beyond our own reader: it makes PDF of one page, which goes the way of PDF.
 */
#ifndef PLB_INPUT_FORMAT_GHOSTSCRIPT_H
#define PLB_INPUT_FORMAT_GHOSTSCRIPT_H

#include "input/input.h"

typedef struct {
    unsigned sheet;      /* which page, from 1, blank ones counted; 0: all */
    bool lacks_showpage; /* the program ends without showing it */
    box area;            /* what of the plane the page is, points */
} gs_page;

/* It, and what reads the PDF that it makes. */
bool plb_ghostscript_is_there(void);

/* Reads `in`, a program without headers, onto `list`, whose page becomes page->area. ERROR_FILE: it could not be run, for
 * want of temporary files, descriptors or processes. */
bool plb_read_by_ghostscript(const input_source *in, const gs_page *page, display_list *list, error *err);
bool plb_count_pages_by_ghostscript(const input_source *in, const gs_page *page, unsigned *pages, error *err);

#endif
