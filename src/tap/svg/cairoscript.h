/* SPDX-License-Identifier: MIT
 *
 * The text that cairo's script surface writes becomes a display list while it is written. The language is CairoScript
 * as cairo 1.16 has it (cairo-script-surface.c): a stack language without loops or definitions, so that reading it
 * takes time and memory in proportion to its length. What reaches the page goes out at once; only groups are kept until
 * they are painted.
 */
#ifndef PLB_TAP_SVG_CAIROSCRIPT_H
#define PLB_TAP_SVG_CAIROSCRIPT_H

#include "base/error.h"
#include "list/display_list.h"
#include "list/text/list_write.h"

#include <stddef.h>

typedef struct script_state cairoscript;

/* Makes a reader that writes items, clips and gradients to `out`, which lives as long and has its page already: of so
 * many mm, and with `to_page`, from the units of the script's outermost surface, as its matrix. NULL: out of memory. */
cairoscript *plb_cairoscript_new(list_writer *out, double width, double height, matrix to_page);
/* Lets `say` tell what a filled path says, in the path's units; NULL: nothing. The text that `say` returns is the reader's. */
void plb_cairoscript_listen(cairoscript *s, text_run *(*say)(void *closure, const path *p), void *closure);
/* Takes more of the text, in pieces of any size. False and `err`: the text is no such script, or goes beyond the
 * limits; then nothing more is to be fed. */
bool plb_cairoscript_feed(cairoscript *s, const char *data, size_t n, error *err);
/* Reads the rest of the text, which is whole, and adds the omissions to `lost`. */
bool plb_cairoscript_end(cairoscript *s, omissions *lost, error *err);
void plb_cairoscript_free(cairoscript *s);

#endif
