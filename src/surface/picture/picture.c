/* SPDX-License-Identifier: MIT
 *
 * See picture.h: the table of formats, and a file from its beginning to its end.
 */
#include "surface/picture/picture.h"

#include "base/array.h"
#include "surface/picture/formats.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* To add a format, write its file and its row. */
static const picture_format *const formats[] = {&plb_png_format, &plb_pdf_format, &plb_svg_format, &plb_jpeg_format, &plb_webp_format, &plb_tiff_format};
#define FORMATS (sizeof formats / sizeof *formats)

/* ---- which format ---- */

const picture_format *plb_picture_format_at(size_t index)
{
    return index < FORMATS ? formats[index] : NULL;
}

/* ASCII letters alone: suffixes do not depend on a locale. */
static bool same_word(const char *a, const char *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if ((a[i] >= 'A' && a[i] <= 'Z' ? a[i] + 32 : a[i]) != b[i])
            return false;
    return true;
}

static bool has_suffix(const picture_format *f, const char *suffix)
{
    for (const char *at = f->suffixes; *at;) {
        size_t n = strcspn(at, " ");
        if (strlen(suffix) == n && same_word(suffix, at, n))
            return true;
        at += n + (at[n] == ' ');
    }
    return false;
}

const picture_format *plb_picture_format_named(const char *name)
{
    for (size_t i = 0; i < FORMATS; i++)
        if (has_suffix(formats[i], name) || !strcmp(formats[i]->name, name))
            return formats[i];
    return NULL;
}

/* From its dot on; NULL: none. */
static const char *suffix_of(const char *file)
{
    const char *slash = strrchr(file, '/'), *base = slash ? slash + 1 : file, *dot = strrchr(base, '.');
    return dot && dot > base ? dot : NULL;
}

const picture_format *plb_picture_format_of(const char *file, error *err)
{
    const char *dot = suffix_of(file);
    if (!dot)
        return formats[0];
    for (size_t i = 0; i < FORMATS; i++)
        if (has_suffix(formats[i], dot + 1))
            return formats[i];
    char known[128] = "";
    for (size_t i = 0, n = 0; i < FORMATS; i++)
        n += (size_t)snprintf(known + n, sizeof known - n, "%s.%.*s", i == 0 ? "" : i + 1 < FORMATS ? ", " : " or ", (int)strcspn(formats[i]->suffixes, " "), formats[i]->suffixes);
    plb_fail(err, ERROR_ARGUMENT, "%s: no picture is written with the suffix %s: end the name in %s", file, dot, known);
    return NULL;
}

bool plb_picture_format_suits(const picture_format *f, const char *file, error *err)
{
    const picture_format *promised = plb_picture_format_of(file, err);
    if (!promised || promised == f || !suffix_of(file))
        return promised != NULL;
    return plb_fail(err, ERROR_ARGUMENT, "%s: %s is written, which such a name does not promise", file, f->name);
}

const char *plb_picture_format_name(const picture_format *f) { return f->name; }
const char *plb_picture_format_suffixes(const picture_format *f) { return f->suffixes; }
bool plb_picture_format_has_pages(const picture_format *f) { return f->has_pages; }
bool plb_picture_format_has_paths(const picture_format *f) { return f->has_paths; }
bool plb_picture_format_is_built(const picture_format *f) { return f->built; }

/* ---- a file from its begin to its end ---- */

picture *plb_picture_new(const picture_format *f, const byte_sink *to, const char *name, bool several, error *err)
{
    picture *p = NULL;
    if (!f->built)
        plb_fail(err, ERROR_UNSUPPORTED, "%s: this build writes no %s: install %s and build again", name, f->name, f->package);
    else if (!(p = plb_new(1, sizeof *p)))
        plb_fail_memory(err);
    if (!p)
        return NULL;
    *p = (picture){.format = f, .to = *to, .name = name, .several = several};
    errno = 0;
    if (!f->begin || f->begin(p, err))
        return p;
    plb_picture_free(p);
    return NULL;
}

void plb_picture_free(picture *p)
{
    if (p && p->format->drop)
        p->format->drop(p);
    plb_free(p);
}

static bool check_page(const picture *p, const picture_page *sheet, error *err)
{
    const picture_format *f = p->format;
    if (f->max_side && (sheet->width > f->max_side || sheet->height > f->max_side))
        return plb_fail(err, ERROR_LIMIT, "%s: %s holds at most %d pixels a side, not %d by %d: lower the resolution, or write PNG", p->name, f->name, f->max_side, sheet->width, sheet->height);
    if (sheet->background == PAGE_TRANSPARENT && !f->see_through && !f->multiplies)
        return plb_fail(err, ERROR_ARGUMENT, "%s: %s cannot be without background: write PNG", p->name, f->name);
    return true;
}

bool plb_picture_begin_page(picture *p, const picture_page *sheet, error *err)
{
    if (!check_page(p, sheet, err))
        return false;
    p->page = sheet;
    p->channels = plb_page_channels(plb_picture_background(p->format, sheet), sheet->colour);
    p->pages++;
    errno = 0;
    return p->format->begin_page(p, err);
}

bool plb_picture_add(picture *p, const page *band, error *err)
{
    p->band = band;
    errno = 0;
    return p->format->add(p, err);
}

bool plb_picture_begin_layer(picture *p, const picture_layer *layer, error *err)
{
    errno = 0;
    return p->format->begin_layer(p, layer, err);
}

bool plb_picture_add_path(picture *p, const path *drawn, double width, double opacity, error *err)
{
    errno = 0;
    return p->format->add_path(p, drawn, width, opacity, err);
}

bool plb_picture_end_page(picture *p, error *err)
{
    errno = 0;
    return p->format->end_page(p, err);
}

bool plb_picture_end(picture *p, error *err)
{
    errno = 0;
    return !p->format->end || p->format->end(p, err);
}
