/* SPDX-License-Identifier: MIT
 *
 * TIFF by libtiff: deflated strips of grey, or of red, green and blue, with alpha or without; several pages. Such a file is not
 * written in order, so it is made in memory, compressed, and written at its end. libtiff is loaded when the first page begins:
 * it brings libraries whose start takes 2 ms, a tenth of a small drawing's time.
 */
#include "surface/picture/formats.h"

#ifdef PLB_TIFF_LIBRARY

#include "base/array.h"

#include <dlfcn.h>
#include <errno.h>
#include <string.h>

#include <tiffio.h>

/* Files that might not fit into 4 GiB are written as BigTIFF. */
#define BIG_BYTES 3e9

/* These functions of libtiff are used. */
typedef struct {
    __typeof__(TIFFOpenOptionsAlloc) *new_options;
    __typeof__(TIFFOpenOptionsFree) *free_options;
    __typeof__(TIFFOpenOptionsSetErrorHandlerExtR) *set_error_handler;
    __typeof__(TIFFOpenOptionsSetWarningHandlerExtR) *set_warning_handler;
    __typeof__(TIFFClientOpenExt) *open;
    __typeof__(TIFFSetField) *set_field;
    __typeof__(TIFFWriteEncodedStrip) *write_strip;
    __typeof__(TIFFWriteDirectory) *write_directory;
    __typeof__(TIFFClose) *close;
} tiff_functions;

typedef struct {
    void *library;
    tiff_functions lib;
    TIFF *tiff;
    struct {
        uint8_t *v;
        size_t n, capacity, at;
    } file;
    bool no_memory;
    char why[256]; /* libtiff's words */
    uint8_t *strip;
    size_t strip_size;
} tiff_file;

/* ---- the library ---- */

/* Finds the functions by their names; false when the library lacks one. */
static bool find_functions(tiff_file *f)
{
    tiff_functions *lib = &f->lib;
    const struct {
        void *function; /* a pointer to a function, which dlsym gives as an object's (POSIX, dlsym) */
        const char *name;
    } all[] = {
        {&lib->new_options, "TIFFOpenOptionsAlloc"},
        {&lib->free_options, "TIFFOpenOptionsFree"},
        {&lib->set_error_handler, "TIFFOpenOptionsSetErrorHandlerExtR"},
        {&lib->set_warning_handler, "TIFFOpenOptionsSetWarningHandlerExtR"},
        {&lib->open, "TIFFClientOpenExt"},
        {&lib->set_field, "TIFFSetField"},
        {&lib->write_strip, "TIFFWriteEncodedStrip"},
        {&lib->write_directory, "TIFFWriteDirectory"},
        {&lib->close, "TIFFClose"},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        void *at = dlsym(f->library, all[i].name);
        if (!at)
            return false;
        memcpy(all[i].function, &at, sizeof at);
    }
    return true;
}

static bool load_library(tiff_file *f, const picture *p, error *err)
{
    if (!f->library)
        f->library = dlopen(PLB_TIFF_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    return (f->library && find_functions(f)) ||
           plb_fail(err, ERROR_HELPER, "%s: TIFF cannot be written: the library " PLB_TIFF_LIBRARY " is %s", p->name, f->library ? "another one" : "not here");
}

/* ---- the file in memory ---- */

static tmsize_t read_bytes(thandle_t h, void *to, tmsize_t n)
{
    tiff_file *f = h;
    size_t left = f->file.at < f->file.n ? f->file.n - f->file.at : 0, take = (size_t)n < left ? (size_t)n : left;
    memcpy(to, f->file.v + f->file.at, take);
    f->file.at += take;
    return (tmsize_t)take;
}

static tmsize_t write_bytes(thandle_t h, void *from, tmsize_t n)
{
    tiff_file *f = h;
    size_t end = f->file.at + (size_t)n;
    if (end > f->file.n) {
        if (!array_reserve(&f->file, end - f->file.n)) {
            f->no_memory = true;
            return 0;
        }
        memset(f->file.v + f->file.n, 0, end - f->file.n);
        f->file.n = end;
    }
    memcpy(f->file.v + f->file.at, from, (size_t)n);
    f->file.at = end;
    return n;
}

static toff_t seek_bytes(thandle_t h, toff_t to, int whence)
{
    tiff_file *f = h;
    f->file.at = whence == SEEK_SET ? (size_t)to : (whence == SEEK_CUR ? f->file.at : f->file.n) + (size_t)to;
    return f->file.at;
}

static toff_t size_of_file(thandle_t h) { return ((tiff_file *)h)->file.n; }
static int close_file(thandle_t h) { return (void)h, 0; }

static int on_error(TIFF *t, void *closure, const char *module, const char *format, va_list args)
{
    tiff_file *f = closure;
    (void)t;
    (void)module;
    vsnprintf(f->why, sizeof f->why, format, args);
    return 1; /* said: nothing is printed */
}

static int on_warning(TIFF *t, void *closure, const char *module, const char *format, va_list args)
{
    return (void)t, (void)closure, (void)module, (void)format, (void)args, 1;
}

static bool fail(const picture *p, error *err)
{
    const tiff_file *f = p->own;
    if (f->no_memory || !f->why[0])
        return plb_fail_memory(err);
    return plb_fail(err, ERROR_FILE, "%s: cannot be written: %s", p->name, f->why);
}

/* ---- pages ---- */

static bool open_file(tiff_file *f, const picture *p)
{
    double bytes = (double)p->page->width * p->page->height * p->channels;
    TIFFOpenOptions *o = f->lib.new_options();
    if (!o)
        return false;
    f->lib.set_error_handler(o, on_error, f);
    f->lib.set_warning_handler(o, on_warning, f);
    f->tiff = f->lib.open("picture", bytes > BIG_BYTES ? "w8l" : "wl", f, read_bytes, write_bytes, seek_bytes, close_file, size_of_file, NULL, NULL, o);
    f->lib.free_options(o);
    return f->tiff != NULL;
}

static bool set_tags(const tiff_file *f, const picture *p)
{
    TIFF *t = f->tiff;
    __typeof__(TIFFSetField) *set = f->lib.set_field;
    const picture_page *sheet = p->page;
    uint16_t colours = p->channels < PIGMENT_PLANES ? 1 : PIGMENT_PLANES, alpha = EXTRASAMPLE_UNASSALPHA;
    char *lines = plb_picture_lines(sheet);
    bool ok = lines && set(t, TIFFTAG_IMAGEWIDTH, (uint32_t)sheet->width) && set(t, TIFFTAG_IMAGELENGTH, (uint32_t)sheet->height) &&
              set(t, TIFFTAG_BITSPERSAMPLE, 8) && set(t, TIFFTAG_SAMPLESPERPIXEL, p->channels) &&
              set(t, TIFFTAG_PHOTOMETRIC, colours == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB) &&
              set(t, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) && set(t, TIFFTAG_ROWSPERSTRIP, (uint32_t)plb_picture_rows(p->format, sheet)) &&
              set(t, TIFFTAG_COMPRESSION, sheet->level > 0 ? COMPRESSION_ADOBE_DEFLATE : COMPRESSION_NONE) &&
              set(t, TIFFTAG_XRESOLUTION, sheet->dpi) && set(t, TIFFTAG_YRESOLUTION, sheet->dpi) &&
              set(t, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH) && set(t, TIFFTAG_IMAGEDESCRIPTION, lines);
    ok = ok && (sheet->level == 0 || set(t, TIFFTAG_ZIPQUALITY, sheet->level));
    ok = ok && (p->channels == colours || set(t, TIFFTAG_EXTRASAMPLES, 1, &alpha));
    ok = ok && (!p->several || set(t, TIFFTAG_SUBFILETYPE, FILETYPE_PAGE));
    plb_free(lines);
    return ok;
}

static bool begin_page(picture *p, error *err)
{
    tiff_file *f = p->own ? p->own : plb_new(1, sizeof *f);
    if (!f)
        return plb_fail_memory(err);
    p->own = f;
    if (!load_library(f, p, err))
        return false;
    plb_free(f->strip);
    f->strip_size = (size_t)p->page->width * (size_t)p->channels;
    f->strip = plb_new((size_t)plb_picture_rows(p->format, p->page), f->strip_size);
    return f->strip && (f->tiff || open_file(f, p)) && set_tags(f, p) ? true : fail(p, err);
}

static bool add(picture *p, error *err)
{
    tiff_file *f = p->own;
    int rows = plb_picture_rows(p->format, p->page), bottom = p->band->top + p->band->rows;
    for (int y = p->band->top; y < bottom; y += rows) {
        int n = bottom - y < rows ? bottom - y : rows;
        for (int k = 0; k < n; k++)
            plb_picture_row(p, y + k, f->strip + (size_t)k * f->strip_size);
        if (f->lib.write_strip(f->tiff, (uint32_t)(y / rows), f->strip, (tmsize_t)((size_t)n * f->strip_size)) < 0)
            return fail(p, err);
    }
    return true;
}

static bool end_page(picture *p, error *err)
{
    tiff_file *f = p->own;
    return f->lib.write_directory(f->tiff) ? true : fail(p, err);
}

static bool end(picture *p, error *err)
{
    tiff_file *f = p->own;
    if (!f)
        return true;
    f->lib.close(f->tiff);
    f->tiff = NULL;
    return plb_picture_put(p, f->file.v, f->file.n) || plb_picture_fail(p, err);
}

static void drop(picture *p)
{
    tiff_file *f = p->own;
    if (!f)
        return;
    if (f->tiff)
        f->lib.close(f->tiff);
    if (f->library)
        dlclose(f->library);
    plb_free(f->strip);
    plb_free(f->file.v);
    plb_free(f);
}

#define TIFF_FUNCTIONS .built = true, .begin_page = begin_page, .add = add, .end_page = end_page, .end = end, .drop = drop
#else
#define TIFF_FUNCTIONS .built = false
#endif

const picture_format plb_tiff_format = {.name = "TIFF", .suffixes = "tif tiff", .package = "libtiff-dev", .see_through = true, .has_pages = true, TIFF_FUNCTIONS};
