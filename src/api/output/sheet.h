/* SPDX-License-Identifier: MIT
 *
 * Writes a drawing as a page of an open picture, in pixels or in paths, whichever the format holds.
 */
#ifndef PLB_API_OUTPUT_SHEET_H
#define PLB_API_OUTPUT_SHEET_H

#include "api/pipeline.h"
#include "surface/picture/picture.h"

/* Writes the page; `o` are the options that go with the drawing (plb_api_options_for). */
bool plb_sheet_write(picture *p, const picture_format *f, const plb_drawing *d, const plb_options *o, error *err);
/* Writes a file of this one page to a sink; `name` is for messages. */
bool plb_sheet_write_file(const byte_sink *to, const char *name, const picture_format *f, const plb_drawing *d, const plb_options *o, error *err);
/* Makes a sink that writes into an open stream. */
byte_sink plb_sheet_stream(FILE *to);

/* Writes the strokes as paths, a layer for each pencil, for formats of paths (trace.c). */
bool plb_sheet_trace(picture *p, const plb_drawing *d, const plb_options *o, const render_context *t, error *err);

#endif
