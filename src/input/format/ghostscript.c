/* SPDX-License-Identifier: MIT
 *
 * See ghostscript.h. The page is set from outside (FIXEDMEDIA, Install), so that it is the one that our reader found
 * whatever the program says; -dEPSCrop would take the BoundingBox of EPS alone.
 */
#include "input/format/ghostscript.h"

#include "base/number/number.h"
#include "base/number/units.h"
#include "input/converter.h"
#include "system/scratch.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PROGRAM "gs"
#define WHO "Ghostscript"
#define DISK_IS_FULL "/ioerror" /* in its message; it reads no file but ours and writes none but temporary ones */

bool plb_ghostscript_is_there(void)
{
    char program[PROCESS_PATH_MAX];
    return plb_process_find_installed(PROGRAM, program) && plb_process_find_installed("pdftocairo", program);
}

/* A call holds the arguments, and the texts of those that vary. */
typedef struct {
    char first[32], last[32], width[48], height[48], install[160];
    const char *argv[32];
} arguments;

/* The upper left corner of the area is that of the page, which has a whole number of points. */
static void set_arguments(arguments *a, const gs_page *page)
{
    double w = ceil(page->area.x1 - page->area.x0), h = ceil(page->area.y1 - page->area.y0);
    snprintf(a->first, sizeof a->first, "-dFirstPage=%u", page->sheet ? page->sheet : 1);
    snprintf(a->last, sizeof a->last, "-dLastPage=%u", page->sheet ? page->sheet : 1000000u);
    char x[48], y[48]; /* at most 48 bytes each: number.h */
    snprintf(a->width, sizeof a->width, "-dDEVICEWIDTHPOINTS=%ld", lround(fmax(w, 1)));
    snprintf(a->height, sizeof a->height, "-dDEVICEHEIGHTPOINTS=%ld", lround(fmax(h, 1)));
    snprintf(a->install, sizeof a->install, "<< /Install { %s %s translate } >> setpagedevice", plb_format_number(x, -page->area.x0, 6),
             plb_format_number(y, h - page->area.y1, 6));
    const char *all[] = {PROGRAM, "-q", "-dSAFER", "-dBATCH", "-dNOPAUSE", "-sDEVICE=pdfwrite", "-dFIXEDMEDIA",
                         "-dAutoRotatePages=/None", "-dCompressPages=false", "-sstdout=%stderr", "-sOutputFile=-", a->first,
                         a->last, a->width, a->height, "-c", a->install, "-f", "-", page->lacks_showpage ? "-c" : NULL, "showpage",
                         NULL};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        a->argv[i] = all[i];
}

static bool make_pdf(const input_source *in, const gs_page *page, converter_bytes *pdf, error *err)
{
    char program[PROCESS_PATH_MAX];
    scratch temporary;
    process p;
    arguments a;
    error why = {0};
    if (!plb_process_find_installed(PROGRAM, program))
        return plb_fail(err, ERROR_HELPER, "%s: Ghostscript (gs) is not installed", in->name);
    if (!plb_scratch_open(&temporary, &why))
        return plb_fail(err, why.kind, "%s: %s", in->name, why.text);
    set_arguments(&a, page);
    input_source with_folder = *in;
    with_folder.limits.scratch = temporary.folder;
    bool ok = plb_converter_run(&with_folder, WHO, program, a.argv, &p, pdf, &why);
    plb_scratch_close(&temporary);
    if (!ok)
        return plb_fail(err, p.pid < 0 ? ERROR_FILE : why.kind, "%s", why.text);
    if (p.code != 0 || !pdf->n) {
        const char *text = plb_converter_message(&p);
        return plb_fail(err, strstr(text, DISK_IS_FULL) ? ERROR_FILE : ERROR_UNSUPPORTED, "%s: Ghostscript: %.200s", in->name, text);
    }
    return true;
}

static input_source as_pdf(const input_source *in, const converter_bytes *pdf)
{
    input_source made = *in;
    made.data = pdf->v;
    made.size = pdf->n;
    made.page = 1;
    return made;
}

bool plb_read_by_ghostscript(const input_source *in, const gs_page *page, display_list *list, error *err)
{
    converter_bytes pdf = {0};
    bool ok = make_pdf(in, page, &pdf, err);
    if (ok) {
        input_source from = as_pdf(in, &pdf);
        ok = plb_read_pdf(&from, list, err);
    }
    array_free(&pdf);
    list->width = (page->area.x1 - page->area.x0) * MM_PER_POINT;
    list->height = (page->area.y1 - page->area.y0) * MM_PER_POINT;
    return ok;
}

bool plb_count_pages_by_ghostscript(const input_source *in, const gs_page *page, unsigned *pages, error *err)
{
    converter_bytes pdf = {0};
    bool ok = make_pdf(in, page, &pdf, err);
    if (ok) {
        input_source from = as_pdf(in, &pdf);
        ok = plb_count_pdf_pages(&from, pages, err);
    }
    array_free(&pdf);
    return ok;
}
