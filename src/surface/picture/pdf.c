/* SPDX-License-Identifier: MIT
 *
 * PDF (ISO 32000-1): pages of the drawings' true size, each of which shows its picture as one image. Its rows are those of the PNG,
 * which PDF reads as they are (predictor 15). Written here rather than by cairo, which holds the whole image in memory and
 * takes none of more than 32,767 pixels a side. A page of graphite on nothing is laid over what lies below by multiplying:
 * white leaves it as it is.
 */
#include "surface/picture/formats.h"

#include "base/array.h"
#include "base/number/number.h"
#include "base/number/units.h"

#include <stdio.h>
#include <string.h>

#define POINTS_PER_INCH 72.0

/* Numbers of objects: the first page's follow the document's; those of further pages follow each other. */
enum { PDF_CATALOG = 1, PDF_PAGES, PDF_FIRST_PAGE, PDF_INFO = 7 };
enum { PAGE_ITSELF, PAGE_CONTENT, PAGE_IMAGE, PAGE_LENGTH, PAGE_OBJECTS };

typedef struct {
    ARRAY(size_t) object_at; /* where in the file each object begins, by its number; 0: not written yet */
} pdf_file;

/* The number of an object of the page at hand, or of another one, from 1. */
static int object_of(unsigned number, int which)
{
    return number == 1 ? PDF_FIRST_PAGE + which : PDF_INFO + 1 + (int)(number - 2) * PAGE_OBJECTS + which;
}

static bool begin_object(picture *p, int number)
{
    pdf_file *f = p->own;
    while (f->object_at.n <= (size_t)number)
        if (!array_push(&f->object_at, 0))
            return false;
    f->object_at.v[number] = p->written;
    return plb_picture_print(p, "%d 0 obj\n", number);
}

/* A text in parentheses. */
static bool put_string(picture *p, const char *text)
{
    bool ok = plb_picture_print(p, "(");
    for (; ok && *text; text++)
        ok = plb_picture_print(p, strchr("()\\", *text) ? "\\%c" : "%c", *text);
    return ok && plb_picture_print(p, ")");
}

/* "Plumbago-Seed" becomes /PlumbagoSeed, and who wrote the file is its producer. */
static bool put_info(picture *p)
{
    bool ok = begin_object(p, PDF_INFO) && plb_picture_print(p, "<<");
    for (const char *const *t = p->page->text; ok && t && t[0]; t += 2) {
        char key[80] = "/";
        size_t n = 1;
        for (const char *c = strcmp(t[0], "Software") ? t[0] : "Producer"; *c && n + 1 < sizeof key; c++)
            if (*c != '-')
                key[n++] = *c;
        key[n] = '\0';
        ok = plb_picture_print(p, " %s ", key) && put_string(p, t[1]);
    }
    return ok && plb_picture_print(p, " >>\nendobj\n");
}

/* The list of pages: at the beginning where one page is all, else at the end, when their number is known. */
static bool put_pages(picture *p, unsigned n)
{
    bool ok = begin_object(p, PDF_PAGES) && plb_picture_print(p, "<< /Type /Pages /Kids [");
    for (unsigned k = 1; ok && k <= n; k++)
        ok = plb_picture_print(p, "%s%d 0 R", k > 1 ? " " : "", object_of(k, PAGE_ITSELF));
    return ok && plb_picture_print(p, "] /Count %u >>\nendobj\n", n);
}

static bool put_page(picture *p)
{
    char width[48], height[48], content[256];
    bool multiply = p->page->background == PAGE_TRANSPARENT;
    plb_format_number(width, p->page->width_mm / MM_PER_INCH * POINTS_PER_INCH, 4);
    plb_format_number(height, p->page->height_mm / MM_PER_INCH * POINTS_PER_INCH, 4);
    int n = snprintf(content, sizeof content, "q %s%s 0 0 %s 0 0 cm /I Do Q", multiply ? "/G gs " : "", width, height);
    int itself = object_of(p->pages, PAGE_ITSELF), content_at = object_of(p->pages, PAGE_CONTENT);
    return begin_object(p, itself) &&
           plb_picture_print(p, "<< /Type /Page /Parent %d 0 R /MediaBox [0 0 %s %s] /Contents %d 0 R\n"
                                "/Resources << /XObject << /I %d 0 R >> /ExtGState << /G << /BM /Multiply >> >> >> >>\nendobj\n",
                             PDF_PAGES, width, height, content_at, object_of(p->pages, PAGE_IMAGE)) &&
           begin_object(p, content_at) && plb_picture_print(p, "<< /Length %d >>\nstream\n%s\nendstream\nendobj\n", n, content);
}

static bool put_image_head(picture *p)
{
    return begin_object(p, object_of(p->pages, PAGE_IMAGE)) &&
           plb_picture_print(p, "<< /Type /XObject /Subtype /Image /Width %d /Height %d /ColorSpace /%s /BitsPerComponent 8 /Filter /FlateDecode\n"
                                "/DecodeParms << /Predictor 15 /Colors %d /BitsPerComponent 8 /Columns %d >> /Length %d 0 R >>\nstream\n",
                             p->page->width, p->page->height, p->channels == 1 ? "DeviceGray" : "DeviceRGB", p->channels, p->page->width,
                             object_of(p->pages, PAGE_LENGTH));
}

static bool begin(picture *p, error *err)
{
    pdf_file *f = p->own = plb_new(1, sizeof *f);
    if (!f)
        return plb_fail_memory(err);
    bool ok = plb_picture_print(p, "%%PDF-1.4\n%%\xe2\xe3\xcf\xd3\n") && begin_object(p, PDF_CATALOG) &&
              plb_picture_print(p, "<< /Type /Catalog /Pages %d 0 R >>\nendobj\n", PDF_PAGES) && (p->several || put_pages(p, 1));
    return ok || plb_picture_fail(p, err);
}

static bool begin_page(picture *p, error *err)
{
    bool ok = put_page(p) && (p->pages > 1 || put_info(p)) && put_image_head(p);
    return (ok || plb_picture_fail(p, err)) && plb_deflated_rows_begin(p, plb_picture_put, err);
}

static bool end_page(picture *p, error *err)
{
    if (!plb_deflated_rows_end(p, err))
        return false;
    bool ok = plb_picture_print(p, "\nendstream\nendobj\n") && begin_object(p, object_of(p->pages, PAGE_LENGTH)) &&
              plb_picture_print(p, "%zu\nendobj\n", plb_deflated_rows_size(p));
    return ok || plb_picture_fail(p, err);
}

static bool end(picture *p, error *err)
{
    pdf_file *f = p->own;
    bool ok = !p->several || put_pages(p, p->pages);
    size_t table = p->written, n = f->object_at.n;
    ok = ok && plb_picture_print(p, "xref\n0 %zu\n0000000000 65535 f \n", n);
    for (size_t k = 1; ok && k < n; k++)
        ok = plb_picture_print(p, "%010zu 00000 n \n", f->object_at.v[k]);
    ok = ok && plb_picture_print(p, "trailer\n<< /Size %zu /Root %d 0 R /Info %d 0 R >>\nstartxref\n%zu\n%%%%EOF\n", n, PDF_CATALOG, PDF_INFO, table);
    return ok || plb_picture_fail(p, err);
}

static void drop(picture *p)
{
    pdf_file *f = p->own;
    if (f)
        array_free(&f->object_at);
    plb_free(f);
    plb_deflated_rows_drop(p);
}

const picture_format plb_pdf_format = {
    .name = "PDF", .suffixes = "pdf", .built = true, .has_pages = true, .multiplies = true,
    .begin = begin, .begin_page = begin_page, .add = plb_deflated_rows_add, .end_page = end_page, .end = end, .drop = drop,
};
