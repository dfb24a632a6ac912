/* SPDX-License-Identifier: MIT
 *
 * PostScript: the tap draws what is paths. Where it meets letters, shadings, filters or resources Ghostscript takes over,
 * if it is installed; where Ghostscript fails on the file the tap draws the rest alone and the user hears what is
 * missing. A Ghostscript that was stopped by a limit, a full disk or a signal is no answer: then the reading fails.
 */
#include "input/format/ghostscript.h"
#include "input/tap.h"

#include "base/number/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define NOT_INSTALLED "fonts and shadings need Ghostscript and pdftocairo (Debian: ghostscript, poppler-utils), which are not installed"
#define FAILS "fonts and shadings need Ghostscript, which fails on this file"
#define WOULD_HELP "; Ghostscript would help (Debian: ghostscript, poppler-utils)"

typedef enum { DRAWN, FAILED, HANDED_OVER } outcome;

typedef struct {
    const char *page; /* --page N, --count or --alone */
    bool alone;
} manner;

/* A handover holds what the tap says of a file that it leaves to Ghostscript. */
typedef struct {
    gs_page page;
    input_source program; /* the file without headers */
    bool is_unknown;      /* it met something that it does not know: no mistake in the file */
    char *reason, *warnings; /* lines in the process's message */
} handover;

/* ---- the tap ---------------------------------------------------------------------------------------------- */

/* "NAME:LINE: what", or "NAME: what". */
static bool fail_with(const input_source *in, error_kind kind, const char *text, const char *help, error *err)
{
    size_t digits = strspn(text, "0123456789");
    return plb_fail(err, kind, "%s:%s%.300s%s", in->name, digits && text[digits] == ':' ? "" : " ", *text ? text : "tap-ps gave up without a word", help);
}

/* Runs the tap onto `list`, which stays as it was unless DRAWN comes of it. */
static outcome run_tap(const input_source *in, manner how, tap *t, display_list *list, error *err)
{
    char number[16];
    int n = 1;
    error why = {ERROR_NONE, ""};
    *t = (tap){.who = "tap-ps", .argv = {"tap-ps"}};
    if (how.alone)
        t->argv[n++] = "--alone";
    if (how.page) {
        t->argv[n++] = how.page;
    } else if (in->page) {
        snprintf(number, sizeof number, "%u", in->page);
        t->argv[n++] = "--page";
        t->argv[n++] = number;
    }
    bool drawn = plb_tap_read(in, t, list, &why);
    t->argv[1] = NULL; /* the number lives here only */
    if (drawn || plb_tap_ended_with(t, TAP_HANDED_OVER))
        return drawn ? DRAWN : HANDED_OVER;
    plb_fail(err, why.kind, "%s", why.text);
    return FAILED;
}

static bool read_numbers(const char *text, double *out, int n)
{
    const char *end = text + strcspn(text, "\n");
    for (int i = 0; i < n; i++) {
        text += strspn(text, " ");
        if (!plb_parse_number(text, end, &out[i], &text) || !isfinite(out[i]))
            return false;
    }
    return true;
}

/* Cuts the first line of `text` off and gives the rest. */
static char *next_line(char *text)
{
    size_t n = strcspn(text, "\n");
    char *rest = text + n + (text[n] != '\0');
    text[n] = '\0';
    return rest;
}

/* Reads what the tap wrote when it handed over; nothing that it says is believed beyond its bounds. */
static bool read_handover(const input_source *in, process *p, handover *out, error *err)
{
    enum { SHEET, LACKS_SHOWPAGE, X0, Y0, X1, Y1, START, LENGTH, UNKNOWN, COUNT };
    const double largest = 1e6;
    double v[COUNT];
    bool good = read_numbers(p->message, v, COUNT) && v[SHEET] >= 0 && v[SHEET] <= largest && v[START] >= 0 && v[LENGTH] >= 0 &&
                v[START] + v[LENGTH] <= (double)in->size && fabs(v[X0]) < largest && fabs(v[Y0]) < largest && v[X1] > v[X0] &&
                v[Y1] > v[Y0] && v[X1] - v[X0] < largest && v[Y1] - v[Y0] < largest;
    if (!good)
        return plb_fail(err, ERROR_HELPER, "%s: cannot read what tap-ps wrote", in->name);
    *out = (handover){.program = *in, .is_unknown = v[UNKNOWN] != 0};
    out->page = (gs_page){.sheet = (unsigned)v[SHEET], .lacks_showpage = v[LACKS_SHOWPAGE] != 0, .area = {v[X0], v[Y0], v[X1], v[Y1]}};
    out->program.data += (size_t)v[START];
    out->program.size = (size_t)v[LENGTH];
    out->reason = next_line(p->message);
    out->warnings = next_line(out->reason);
    return true;
}

static bool has_page(const input_source *in, unsigned long pages, error *err)
{
    return !pages || in->page <= pages || plb_fail(err, ERROR_ARGUMENT, "%s: it has no page %u, only %lu", in->name, in->page, pages);
}

/* ---- Ghostscript ------------------------------------------------------------------------------------------ */

/* Draws the page without Ghostscript; `why` tells what it would need, or do. */
static bool draw_alone(const input_source *in, const char *why, display_list *list, error *err)
{
    tap t;
    handover rest;
    outcome o = run_tap(in, (manner){.alone = true}, &t, list, err);
    if (o == HANDED_OVER)
        return read_handover(in, &t.process, &rest, err) &&
               fail_with(in, rest.is_unknown ? ERROR_UNSUPPORTED : ERROR_SYNTAX, rest.reason, rest.is_unknown && !plb_ghostscript_is_there() ? WOULD_HELP : "", err);
    if (o == FAILED || !has_page(in, t.pages, err))
        return false;
    if (list->omissions.n[OMISSION_TEXT] || list->omissions.n[OMISSION_SHADING])
        plb_omissions_advise(&list->omissions, why);
    return true;
}

/* Ghostscript's answer counts; so does its end by a limit or for want of memory or disk, which another run may not meet.
 * False, with `err` empty: it cannot read the file. */
static bool draw_by_ghostscript(const input_source *in, process *p, display_list *list, error *err)
{
    error why = {ERROR_NONE, ""};
    handover rest;
    if (!read_handover(in, p, &rest, err))
        return false;
    if (!plb_read_by_ghostscript(&rest.program, &rest.page, list, &why)) {
        plb_list_free(list);
        plb_list_init(list);
        if (why.kind != ERROR_UNSUPPORTED && why.kind != ERROR_SYNTAX)
            return plb_fail(err, why.kind, "%s", why.text);
        plb_log(&in->say, MESSAGE_DETAIL, "%s", why.text);
        return false;
    }
    list->omissions.n[OMISSION_MASK] = list->omissions.n[OMISSION_FILTER] = 0; /* so images come that are stencils */
    plb_log(&in->say, MESSAGE_DETAIL, "%s:%s; read by Ghostscript", in->name, rest.reason);
    for (char *line = rest.warnings, *next; *line; line = next) {
        next = next_line(line);
        plb_log(&in->say, MESSAGE_WARNING, "%s: %s", in->name, line);
    }
    return true;
}

bool plb_read_postscript(const input_source *in, display_list *list, error *err)
{
    tap t;
    error why = {ERROR_NONE, ""};
    if (!plb_ghostscript_is_there())
        return draw_alone(in, NOT_INSTALLED, list, err);
    outcome o = run_tap(in, (manner){.alone = false}, &t, list, err);
    if (o != HANDED_OVER)
        return o == DRAWN && has_page(in, t.pages, err);
    if (draw_by_ghostscript(in, &t.process, list, &why))
        return true;
    return why.kind ? plb_fail(err, why.kind, "%s", why.text) : draw_alone(in, FAILS, list, err);
}

bool plb_count_postscript_pages(const input_source *in, unsigned *pages, error *err)
{
    tap t;
    display_list list;
    handover rest;
    error why = {ERROR_NONE, ""};
    bool there = plb_ghostscript_is_there();
    plb_list_init(&list);
    outcome o = run_tap(in, (manner){.page = "--count", .alone = !there}, &t, &list, err);
    plb_list_free(&list);
    *pages = t.pages ? (unsigned)t.pages : 1;
    if (o != HANDED_OVER)
        return o == DRAWN;
    if (!read_handover(in, &t.process, &rest, err))
        return false;
    if (there && plb_count_pages_by_ghostscript(&rest.program, &rest.page, pages, &why))
        return true;
    return why.kind == ERROR_CANCELLED ? plb_fail(err, why.kind, "%s", why.text) :
           fail_with(in, rest.is_unknown ? ERROR_UNSUPPORTED : ERROR_SYNTAX, rest.reason, rest.is_unknown && !there ? WOULD_HELP : "", err);
}
