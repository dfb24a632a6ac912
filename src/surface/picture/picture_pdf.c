/* SPDX-License-Identifier: MIT
 *
 * PDF (ISO 32000-1): one page of the drawing's true size that shows the picture as one image. Its rows are those of the PNG,
 * which PDF reads as they are (predictor 15). Written here rather than by cairo, which holds the whole image in memory and
 * takes none of more than 32,767 pixels a side. A page of graphite on nothing is laid over what lies below by multiplying:
 * white leaves it as it is.
 */
#include "surface/picture/picture_formats.h"

#include "base/number/number.h"
#include "base/number/units.h"

#include <stdarg.h>
#include <string.h>

#define POINTS_PER_INCH 72.0

enum { PDF_CATALOG = 1, PDF_PAGES, PDF_PAGE, PDF_CONTENT, PDF_IMAGE, PDF_LENGTH, PDF_INFO };

static bool put(picture *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool put(picture *p, const char *format, ...)
{
    char text[1024];
    va_list args;
    va_start(args, format);
    int n = vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return n >= 0 && n < (int)sizeof text && picture_put(p, text, (size_t)n);
}

static bool begin_object(picture *p, int number)
{
    p->object_at[number] = p->written;
    return put(p, "%d 0 obj\n", number);
}

/* A text in parentheses. */
static bool put_string(picture *p, const char *text)
{
    bool ok = put(p, "(");
    for (; ok && *text; text++)
        ok = put(p, strchr("()\\", *text) ? "\\%c" : "%c", *text);
    return ok && put(p, ")");
}

/* "Plumbago-Seed" becomes /PlumbagoSeed, and who wrote the file is its producer. */
static bool put_info(picture *p)
{
    bool ok = begin_object(p, PDF_INFO) && put(p, "<<");
    for (const char *const *t = p->o->text; ok && t && t[0]; t += 2) {
        char key[80] = "/";
        size_t n = 1;
        for (const char *c = strcmp(t[0], "Software") ? t[0] : "Producer"; *c && n + 1 < sizeof key; c++)
            if (*c != '-')
                key[n++] = *c;
        key[n] = '\0';
        ok = put(p, " %s ", key) && put_string(p, t[1]);
    }
    return ok && put(p, " >>\nendobj\n");
}

static bool put_page(picture *p, const char *width, const char *height)
{
    bool multiply = p->o->background == PAGE_TRANSPARENT;
    char content[256];
    int n = snprintf(content, sizeof content, "q %s%s 0 0 %s 0 0 cm /I Do Q", multiply ? "/G gs " : "", width, height);
    return begin_object(p, PDF_PAGE) &&
           put(p, "<< /Type /Page /Parent %d 0 R /MediaBox [0 0 %s %s] /Contents %d 0 R\n"
                  "/Resources << /XObject << /I %d 0 R >> /ExtGState << /G << /BM /Multiply >> >> >> >>\nendobj\n",
               PDF_PAGES, width, height, PDF_CONTENT, PDF_IMAGE) &&
           begin_object(p, PDF_CONTENT) && put(p, "<< /Length %d >>\nstream\n%s\nendstream\nendobj\n", n, content);
}

bool plb_pdf_head(picture *p)
{
    char width[48], height[48];
    plb_format_number(width, p->o->width_mm / MM_PER_INCH * POINTS_PER_INCH, 4);
    plb_format_number(height, p->o->height_mm / MM_PER_INCH * POINTS_PER_INCH, 4);
    return put(p, "%%PDF-1.4\n%%\xe2\xe3\xcf\xd3\n") && begin_object(p, PDF_CATALOG) &&
           put(p, "<< /Type /Catalog /Pages %d 0 R >>\nendobj\n", PDF_PAGES) && begin_object(p, PDF_PAGES) &&
           put(p, "<< /Type /Pages /Kids [%d 0 R] /Count 1 >>\nendobj\n", PDF_PAGE) && put_page(p, width, height) && put_info(p) &&
           begin_object(p, PDF_IMAGE) &&
           put(p, "<< /Type /XObject /Subtype /Image /Width %d /Height %d /ColorSpace /%s /BitsPerComponent 8 /Filter /FlateDecode\n"
                  "/DecodeParms << /Predictor 15 /Colors %d /BitsPerComponent 8 /Columns %d >> /Length %d 0 R >>\nstream\n",
               p->width, p->height, p->channels == 1 ? "DeviceGray" : "DeviceRGB", p->channels, p->width, PDF_LENGTH);
}

bool plb_pdf_data(picture *p, const void *data, size_t n)
{
    return picture_put(p, data, n);
}

bool plb_pdf_tail(picture *p)
{
    bool ok = put(p, "\nendstream\nendobj\n") && begin_object(p, PDF_LENGTH) && put(p, "%zu\nendobj\n", p->data_size);
    size_t table = p->written;
    ok = ok && put(p, "xref\n0 %d\n0000000000 65535 f \n", PICTURE_OBJECTS);
    for (int k = 1; ok && k < PICTURE_OBJECTS; k++)
        ok = put(p, "%010zu 00000 n \n", p->object_at[k]);
    return ok && put(p, "trailer\n<< /Size %d /Root %d 0 R /Info %d 0 R >>\nstartxref\n%zu\n%%%%EOF\n", PICTURE_OBJECTS, PDF_CATALOG, PDF_INFO, table);
}
