/* SPDX-License-Identifier: MIT
 *
 * This file has the table of formats, recognised by content. The first that fits reads the file.
 */
#include "input/input.h"

#include "input/format/foreign.h"
#include "input/format/model.h"
#include "input/format/scene.h"

#include <string.h>

typedef struct {
    const char *name;
    bool (*recognise)(const char *data, size_t size);
    bool may_be_packed; /* by gzip */
    bool (*read)(const input_source *in, display_list *list, error *err);     /* runs the taps: see its file */
    bool (*count_pages)(const input_source *in, unsigned *pages, error *err); /* NULL: there is always one */
} input_format;

/* A sign of the format lies within so many bytes of the start. */
#define SIGN_BYTES ((size_t)4096)

static bool starts_with(const char *data, size_t size, const char *sign, size_t n)
{
    return size >= n && !memcmp(data, sign, n);
}

static bool contains(const char *data, size_t size, const char *sign)
{
    size_t n = strlen(sign);
    if (size > SIGN_BYTES)
        size = SIGN_BYTES;
    for (size_t i = 0; i + n <= size; i++)
        if (!memcmp(data + i, sign, n))
            return true;
    return false;
}

/* Skips a byte order mark, blanks and ^D. */
static void skip_start(const char **data, size_t *size)
{
    size_t i = starts_with(*data, *size, "\xef\xbb\xbf", 3) ? 3 : 0;
    while (i < *size && memchr(" \t\r\n\f\x04", (*data)[i], 6))
        i++;
    *data += i;
    *size -= i;
}

static bool is_gzip(const char *data, size_t size) { return starts_with(data, size, "\x1f\x8b", 2); }
static bool is_utf16(const char *data, size_t size)
{
    return starts_with(data, size, "\xff\xfe<\0", 4) || starts_with(data, size, "\xfe\xff\0<", 4);
}

static bool is_svg(const char *data, size_t size)
{
    if (is_gzip(data, size) || is_utf16(data, size) || contains(data, size, "<svg"))
        return true;
    skip_start(&data, &size);
    return size > 0 && data[0] == '<';
}

static bool is_postscript(const char *data, size_t size)
{
    if (starts_with(data, size, "\xc5\xd0\xd3\xc6", 4)) /* EPS with a DOS header (EPSF 3.0, section 5.2) */
        return true;
    skip_start(&data, &size);
    if (starts_with(data, size, "\x1b%-12345X", 9) || starts_with(data, size, "@PJL", 4)) /* a printer's job; the tap skips its header */
        return contains(data, size, "\n%!");
    return starts_with(data, size, "%!", 2);
}

static bool is_pdf(const char *data, size_t size)
{
    return contains(data, size < 1024 ? size : 1024, "%PDF-"); /* PDF 1.7, implementation note 13 */
}

/* DXF starts with group code 0 and the word SECTION, after comments (999), or with the sentinel of binary DXF. */
static bool is_dxf(const char *data, size_t size)
{
    if (starts_with(data, size, "AutoCAD Binary DXF", 18))
        return true;
    skip_start(&data, &size);
    return (starts_with(data, size, "0", 1) || starts_with(data, size, "999", 3)) && contains(data, size, "SECTION");
}

/* The display list's own language names itself at the very start. */
static bool is_list(const char *data, size_t size) { return starts_with(data, size, "plumbago-list", 13); }

/* The first that recognises a file reads it, so the order counts: PDF and PostScript may hold "<svg" near their start, and COLLADA
 * begins as SVG does. */
static const input_format formats[] = {
    {"plumbago-list", is_list, false, plb_read_list, NULL},
    {"PostScript", is_postscript, false, plb_read_postscript, plb_count_postscript_pages},
    {"PDF", is_pdf, false, plb_read_pdf, plb_count_pdf_pages},
    {"structured model", plb_is_scene, false, plb_read_scene, NULL},
    {"SVG", is_svg, true, plb_read_svg, NULL},
    {"DXF", is_dxf, false, plb_read_dxf, NULL},
    {"solid model", plb_is_model, false, plb_read_model, NULL},
};

static const input_format *recognise(const char *data, size_t size)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (formats[i].recognise(data, size))
            return &formats[i];
    return NULL;
}

/* Refuses a packed drawing of a format whose reader does not unpack. */
static bool is_packed_drawing(const input_source *in, error *err)
{
    char start[SIGN_BYTES];
    const input_format *inside = is_gzip(in->data, in->size) ? recognise(start, plb_gzip_look_inside(in->data, in->size, start, sizeof start)) : NULL;
    if (!inside || inside->may_be_packed)
        return false;
    plb_fail(err, ERROR_UNSUPPORTED, "%s: packed (gzip) %s: unpack it first (gunzip -c FILE | plumbago -)", in->name, inside->name);
    return true;
}

static const input_format *find_format(const input_source *in, error *err)
{
    const foreign_format *foreign = plb_foreign_find(in->data, in->size);
    const input_format *f = foreign || !in->size ? NULL : recognise(in->data, in->size);
    if (!in->size)
        plb_fail(err, ERROR_SYNTAX, "%s: the file is empty", in->name);
    else if (foreign)
        plb_fail(err, ERROR_UNSUPPORTED, "%s: this is %s: %s", in->name, foreign->what, foreign->help);
    else if (!f)
        plb_fail(err, ERROR_UNSUPPORTED, "%s: not a drawing this program can read (SVG, PDF, PostScript, DXF, a solid model or plumbago-list)", in->name);
    else if (is_packed_drawing(in, err))
        return NULL;
    return f;
}

bool plb_input_count_pages(const input_source *in, unsigned *pages, error *err)
{
    const input_format *f = find_format(in, err);
    *pages = 1;
    return f && (!f->count_pages || f->count_pages(in, pages, err));
}

bool plb_input_read(const input_source *in, display_list *list, error *err)
{
    const input_format *f = find_format(in, err);
    if (!f)
        return false;
    plb_log(&in->say, MESSAGE_DETAIL, "%s: %s", in->name, f->name);
    if (!f->count_pages && in->page > 1)
        return plb_fail(err, ERROR_ARGUMENT, "%s: it has no page %u, only 1", in->name, in->page);
    return f->read(in, list, err);
}
