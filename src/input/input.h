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

/* A solid model is seen, and drawn, so; other formats take no notice. */
typedef enum { MODEL_UP_AUTO, MODEL_UP_X, MODEL_UP_Y, MODEL_UP_Z } model_up;
typedef enum { MODEL_HIDDEN_AUTO, MODEL_HIDDEN_NONE, MODEL_HIDDEN_DASHED, MODEL_HIDDEN_FAINT } model_hidden;
typedef enum { MODEL_SHEET_NONE, MODEL_SHEET_FIRST_ANGLE, MODEL_SHEET_THIRD_ANGLE } model_sheet;
#define MODEL_DARK 0 /* the light's word for none */
typedef struct {
    bool has_view, has_light, is_dark; /* else what the tap does by itself */
    double view[2], light[2];          /* degrees: azimuth and elevation */
    double perspective;                /* degrees in view; 0: parallel */
    double crease;                     /* degrees; 0: what the tap does by itself */
    model_up up;
    model_hidden hidden;
    model_sheet sheet;
} model_look;

typedef struct {
    const char *name;       /* the file's name as messages show it */
    const char *data;       /* all its bytes (may hold NULs); lives as long as the call */
    size_t size;
    const char *helper_dir; /* where tap-svg and its like are looked for first; NULL: beside the program, then the installed place */
    log_sink say;          /* warnings and details */
    unsigned page;          /* which page of several, from 1 */
    process_limits limits;  /* of each foreign program */
    model_look look;
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
bool plb_read_model(const input_source *in, display_list *list, error *err);
bool plb_read_scene(const input_source *in, display_list *list, error *err);
bool plb_read_list(const input_source *in, display_list *list, error *err);
bool plb_read_pdf(const input_source *in, display_list *list, error *err);

/* Formats that can have several pages have a counter of them. */
bool plb_count_postscript_pages(const input_source *in, unsigned *pages, error *err);
bool plb_count_pdf_pages(const input_source *in, unsigned *pages, error *err);

#endif
