/* SPDX-License-Identifier: MIT
 *
 * Writes the drawn page as a file, as bytes for a function of the caller's, or into memory.
 */
#include "api/output/sheet.h"

#include "system/output.h"

#include <errno.h>
#include <string.h>

/* ---- formats ---- */

static plb_format shown(const picture_format *f)
{
    return (plb_format){plb_picture_format_name(f), plb_picture_format_suffixes(f), plb_picture_format_has_pages(f), plb_picture_format_has_paths(f),
                        plb_picture_format_is_built(f)};
}

bool plb_format_at(size_t index, plb_format *format)
{
    const picture_format *f = plb_picture_format_at(index);
    if (f)
        *format = shown(f);
    return f != NULL;
}

bool plb_format_of(const char *file, plb_format *format, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const picture_format *f = plb_picture_format_of(file, &err);
    if (f)
        *format = shown(f);
    return plb_api_finish(&err, failed);
}

/* ---- files ---- */

static bool write_file(const plb_drawing *d, const char *file, const picture_format *f, const plb_options *given, error *err)
{
    const plb_options *o = plb_api_options_for(d, given, &(plb_options){0}, err);
    output out;
    if (!o || !plb_output_open(&out, file, err))
        return false;
    byte_sink to = plb_sheet_stream(out.to);
    if (plb_sheet_write_file(&to, plb_output_shown(file), f, d, o, err))
        return plb_output_commit(&out, err);
    plb_output_discard(&out);
    return false;
}

bool plb_drawing_write(const plb_drawing *d, const char *file, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const picture_format *f = plb_picture_format_of(file, &err);
    if (f)
        write_file(d, file, f, o, &err);
    return plb_api_finish(&err, failed);
}

static bool write_as(const char *name, const plb_drawing *d, const char *file, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    const picture_format *f = plb_picture_format_named(name);
    if (plb_picture_format_suits(f, file, &err))
        write_file(d, file, f, o, &err);
    return plb_api_finish(&err, failed);
}

bool plb_drawing_write_png(const plb_drawing *d, const char *file, const plb_options *o, plb_error *failed)
{
    return write_as("png", d, file, o, failed);
}

bool plb_drawing_write_pdf(const plb_drawing *d, const char *file, const plb_options *o, plb_error *failed)
{
    return write_as("pdf", d, file, o, failed);
}

/* ---- functions of the caller's, and memory ---- */

static bool write_to(const plb_drawing *d, const char *format, const byte_sink *to, const plb_options *given, error *err)
{
    const plb_options *o = plb_api_options_for(d, given, &(plb_options){0}, err);
    const picture_format *f = plb_picture_format_named(format);
    if (!f)
        return plb_fail(err, ERROR_ARGUMENT, "there is no format %s", format);
    return o && plb_sheet_write_file(to, "the picture", f, d, o, err);
}

bool plb_drawing_write_to(const plb_drawing *d, const char *format, plb_write_function put, void *closure, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    byte_sink to = {put, closure};
    write_to(d, format, &to, o, &err);
    return plb_api_finish(&err, failed);
}

typedef ARRAY(char) byte_array;

static bool put_in_memory(void *closure, const void *data, size_t n)
{
    byte_array *to = closure;
    if (!array_reserve(to, n)) {
        errno = ENOMEM;
        return false;
    }
    memcpy(to->v + to->n, data, n);
    to->n += n;
    return true;
}

void *plb_drawing_write_memory(const plb_drawing *d, const char *format, size_t *size, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    byte_array bytes = {0};
    byte_sink to = {put_in_memory, &bytes};
    if (!write_to(d, format, &to, o, &err))
        array_free(&bytes);
    *size = bytes.n;
    plb_api_finish(&err, failed);
    return bytes.v;
}

void plb_memory_free(void *bytes)
{
    plb_free(bytes);
}
