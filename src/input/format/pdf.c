/* SPDX-License-Identifier: MIT
 *
 * This file reads PDF: poppler's pdftocairo writes one page as SVG, which goes the way of SVG. Its text arrives as glyph outlines.
 */
#include "input/converter.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "pdftocairo"
/* No document has so many pages: asked for this one, pdftocairo says how many there are. */
#define BEYOND_ALL_PAGES 2000000000u

/* pdftocairo ends with these statuses (pdftocairo(1)) and says these words. */
enum { PDF_DONE, PDF_CANNOT_OPEN, PDF_OUTPUT, PDF_PERMISSION, PDF_OTHER = 99 };

static bool find_program(const input_source *in, char program[PROCESS_PATH_MAX], error *err)
{
    return plb_process_find_installed(PROGRAM, program) ||
           plb_fail(err, ERROR_HELPER, "%s: reading PDF needs the program " PROGRAM " (Debian: poppler-utils), which is not installed", in->name);
}

static bool run(const input_source *in, unsigned page, process *p, converter_bytes *svg, error *err)
{
    char program[PROCESS_PATH_MAX], number[16];
    const char *argv[] = {PROGRAM, "-svg", "-f", number, "-l", number, "-", "-", NULL};
    snprintf(number, sizeof number, "%u", page);
    return find_program(in, program, err) && plb_converter_run(in, PROGRAM, program, argv, p, svg, err);
}

/* "Wrong page range given: the first page (5) can not be after the last page (1).": 1; 0: another message. */
static unsigned long pages_said(const process *p)
{
    static const char before[] = "after the last page (";
    const char *at = strstr(p->message, before);
    return at ? strtoul(at + strlen(before), NULL, 10) : 0;
}

static bool fail_to_read(const input_source *in, process *p, error *err)
{
    if (strstr(p->message, "Incorrect password"))
        return plb_fail(err, ERROR_UNSUPPORTED, "%s: the document is locked by a password", in->name);
    const char *text = plb_converter_message(p);
    return plb_fail(err, p->code == PDF_CANNOT_OPEN || p->code == PDF_OTHER ? ERROR_SYNTAX : ERROR_HELPER, "%s: cannot be read as PDF: %.200s", in->name,
                    *text ? text : PROGRAM " gave up without a word");
}

bool plb_count_pdf_pages(const input_source *in, unsigned *pages, error *err)
{
    process p;
    converter_bytes nothing = {0};
    bool ok = run(in, BEYOND_ALL_PAGES, &p, &nothing, err);
    array_free(&nothing);
    *pages = ok ? (unsigned)pages_said(&p) : 0;
    return *pages > 0 || (ok && fail_to_read(in, &p, err));
}

/* Warns of other pages, where nobody asked for a certain one. */
static void warn_of_others(const input_source *in)
{
    unsigned pages;
    error ignored = {0};
    if (!in->page && plb_count_pdf_pages(in, &pages, &ignored) && pages > 1)
        plb_log(&in->say, MESSAGE_WARNING, "%s: only the first page of %u is drawn (--page)", in->name, pages);
}

bool plb_read_pdf(const input_source *in, display_list *list, error *err)
{
    process p;
    converter_bytes svg = {0};
    bool ok = run(in, in->page ? in->page : 1, &p, &svg, err);
    unsigned long pages = ok ? pages_said(&p) : 0;
    if (ok && pages)
        ok = plb_fail(err, ERROR_ARGUMENT, "%s: it has no page %u, only %lu", in->name, in->page, pages);
    else if (ok && (p.code != PDF_DONE || !svg.n))
        ok = fail_to_read(in, &p, err);
    if (ok) {
        input_source as_svg = *in;
        as_svg.data = svg.v;
        as_svg.size = svg.n;
        warn_of_others(in);
        ok = plb_read_svg(&as_svg, list, err);
    }
    array_free(&svg);
    return ok;
}
