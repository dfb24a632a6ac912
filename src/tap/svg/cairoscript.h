/* SPDX-License-Identifier: MIT
 *
 * The text that tap-svg writes becomes a display list. The language is CairoScript as cairo 1.16's script surface
 * writes it (cairo-script-surface.c): a stack language without loops or definitions, so that reading it takes time
 * and memory in proportion to its length.
 */
#ifndef PLB_TAP_SVG_CAIROSCRIPT_H
#define PLB_TAP_SVG_CAIROSCRIPT_H

#include "base/error.h"
#include "list/display_list.h"

#include <stddef.h>

typedef struct {
    /* Gives more bytes (and true), or false at the end of the text. */
    bool (*refill)(void *closure, const char **data, size_t *size);
    void *closure;
    bool complete; /* set by the reader: the whole text was read and understood */
} cairoscript_source;

/* Reads the text into `list` (initialised by the caller): page size, items, clips, counts. On failure what was read
 * so far stays in `list`, and `err` says what is wrong with the tap's text, without a file name. */
bool plb_read_cairoscript(cairoscript_source *from, display_list *list, error *err);

#endif
