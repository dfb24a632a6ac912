/* SPDX-License-Identifier: MIT
 *
 * Writes a file of several pages, drawn one after the other.
 */
#include "api/output/sheet.h"

#include "system/output.h"

#include <string.h>

struct plb_document {
    char *name;
    const picture_format *format;
    output out;
    picture *picture;
    bool broken; /* a page ended in the midst: no further one can follow */
};

static bool open_document(plb_document *t, const char *file, error *err)
{
    t->name = plb_new(strlen(file) + 1, 1);
    if (!t->name)
        return plb_fail_memory(err);
    strcpy(t->name, file);
    t->format = plb_picture_format_of(file, err);
    if (!t->format)
        return false;
    if (!plb_picture_format_has_pages(t->format))
        return plb_fail(err, ERROR_ARGUMENT, "%s: %s holds one page: several need PDF or TIFF", file, plb_picture_format_name(t->format));
    if (!plb_output_open(&t->out, t->name, err))
        return false;
    byte_sink to = plb_sheet_stream(t->out.to);
    t->picture = plb_picture_new(t->format, &to, plb_output_shown(t->name), true, err);
    return t->picture != NULL;
}

plb_document *plb_document_new(const char *file, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_document *t = plb_new(1, sizeof *t);
    if (!t)
        plb_fail_memory(&err);
    else if (!open_document(t, file, &err)) {
        plb_document_free(t);
        t = NULL;
    }
    plb_api_finish(&err, failed);
    return t;
}

bool plb_document_add(plb_document *t, const plb_drawing *d, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const plb_options *o = plb_api_options_for(d, given, &(plb_options){0}, &err);
    if (o && t->broken)
        plb_fail(&err, ERROR_ARGUMENT, "%s: a page of it failed", t->name);
    else if (o)
        t->broken = !plb_sheet_write(t->picture, t->format, d, o, &err);
    return plb_api_finish(&err, failed);
}

bool plb_document_close(plb_document *t, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    if (t->broken)
        plb_fail(&err, ERROR_ARGUMENT, "%s: a page of it failed", t->name);
    else if (plb_picture_end(t->picture, &err))
        plb_output_commit(&t->out, &err);
    plb_document_free(t);
    return plb_api_finish(&err, failed);
}

void plb_document_free(plb_document *t)
{
    if (!t)
        return;
    plb_picture_free(t->picture);
    plb_output_discard(&t->out);
    plb_free(t->name);
    plb_free(t);
}
