/* SPDX-License-Identifier: MIT
 *
 * A file becomes a display list. Formats are a table (input.c): name, how to recognise it, reader.
 */
#ifndef PLB_INPUT_INPUT_H
#define PLB_INPUT_INPUT_H

#include "base/error.h"
#include "system/process.h"
#include "list/display_list.h"

#include <stddef.h>

typedef struct {
    const char *name;       /* the file's name as messages show it */
    const char *data;       /* all its bytes (may hold NULs); lives as long as the call */
    size_t size;
    const char *helper_dir; /* where tap-svg and its like are looked for first; NULL: beside the program, then the installed place */
    log_sink say;          /* warnings and details */
    unsigned page;          /* which page of several, from 1 */
    process_limits limits;  /* of each foreign program */
} input_source;

/* Recognises the format by content and reads it. On success `list` (initialised by the caller) holds items and a
 * page size in mm. On failure `err` says "NAME:LINE: what" or "NAME: what". */
bool plb_input_read(const input_source *in, display_list *list, error *err);

/* Counts the pages there are to read, at least 1; in->page does not matter. */
bool plb_input_count_pages(const input_source *in, unsigned *pages, error *err);

/* Reads a whole file (or standard input, when `file` is "-") into memory the caller frees with plb_free; at most
 * INPUT_MAX_BYTES. Directories and devices that never end are refused by that limit. */
#define INPUT_MAX_BYTES ((size_t)256 << 20)
bool plb_input_load(const char *file, char **data, size_t *size, error *err);

/* Each format has a reader, with the contract of plb_input_read. */
bool plb_read_svg(const input_source *in, display_list *list, error *err);
bool plb_read_postscript(const input_source *in, display_list *list, error *err);
bool plb_read_dxf(const input_source *in, display_list *list, error *err);
bool plb_read_list(const input_source *in, display_list *list, error *err);
bool plb_read_pdf(const input_source *in, display_list *list, error *err);

/* Formats that can have several pages have a counter of them. */
bool plb_count_postscript_pages(const input_source *in, unsigned *pages, error *err);
bool plb_count_pdf_pages(const input_source *in, unsigned *pages, error *err);

#endif
