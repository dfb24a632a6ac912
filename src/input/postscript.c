/* SPDX-License-Identifier: MIT
 *
 * PostScript: the tap draws what is paths. Where it meets letters, shadings, filters or resources Ghostscript takes over,
 * if it is installed; where Ghostscript fails on the file the tap draws the rest alone and the user hears what is
 * missing. A Ghostscript that was stopped by a limit, a full disk or a signal is no answer: then the reading fails.
 */
#include "input/ghostscript.h"
#include "tap/ps/postscript.h"

#include <string.h>

static ps_request request_of(const input_source *in, bool alone, bool only_count)
{
    return (ps_request){.data = in->data, .size = in->size, .page = in->page, .alone = alone, .only_count = only_count};
}

/* "NAME:LINE: what", or "NAME: what". */
static bool fail_with(const input_source *in, ps_outcome outcome, const error *why, error *err)
{
    size_t digits = strspn(why->text, "0123456789");
    bool has_line = digits && why->text[digits] == ':';
    bool is_missed = outcome == PS_HANDED_OVER && why->kind == ERROR_UNSUPPORTED && !plb_ghostscript_is_there();
    return plb_fail(err, why->kind, "%s:%s%s%s", in->name, has_line ? "" : " ", why->text,
                    is_missed ? "; Ghostscript would help (Debian: ghostscript, poppler-utils)" : "");
}

static void pass_on(const input_source *in, const ps_answer *answer)
{
    for (int i = 0; answer->warnings[i]; i++)
        plb_log(&in->say, MESSAGE_WARNING, "%s: %s", in->name, answer->warnings[i]);
}

static gs_page page_of(const input_source *in, const ps_answer *answer, input_source *program)
{
    *program = *in;
    plb_ps_find_program(in->data, in->size, &program->data, &program->size);
    return (gs_page){.sheet = answer->sheet, .lacks_showpage = answer->lacks_showpage, .area = answer->area};
}

/* Draws the page without Ghostscript: `why` it is not asked, or no help. */
static bool draw_alone(const input_source *in, const char *why, display_list *list, error *err)
{
    ps_request ask = request_of(in, true, false);
    ps_answer answer;
    error reason = {0};
    ps_outcome outcome = plb_ps_read(&ask, list, &answer, &reason);
    if (outcome != PS_DRAWN)
        return fail_with(in, outcome, &reason, err);
    if (answer.pages && in->page > answer.pages)
        return plb_fail(err, ERROR_ARGUMENT, "%s: it has no page %u, only %u", in->name, in->page, answer.pages);
    if (list->omissions.n[OMISSION_TEXT] || list->omissions.n[OMISSION_SHADING])
        plb_omissions_advise(&list->omissions, why);
    pass_on(in, &answer);
    return true;
}

/* Ghostscript's answer counts; so does its end by a limit or for want of memory or disk, which another run may not meet.
 * False, with `err` empty: it cannot read the file. */
static bool draw_by_ghostscript(const input_source *in, const ps_answer *answer, const error *reason, display_list *list, error *err)
{
    error why = {0};
    input_source program;
    gs_page page = page_of(in, answer, &program);
    if (!plb_read_by_ghostscript(&program, &page, list, &why)) {
        plb_list_free(list);
        plb_list_init(list);
        if (why.kind != ERROR_UNSUPPORTED && why.kind != ERROR_SYNTAX)
            return plb_fail(err, why.kind, "%s", why.text);
        plb_log(&in->say, MESSAGE_DETAIL, "%s", why.text);
        return false;
    }
    list->omissions.n[OMISSION_MASK] = list->omissions.n[OMISSION_FILTER] = 0; /* so images come that are stencils */
    plb_log(&in->say, MESSAGE_DETAIL, "%s:%s; read by Ghostscript", in->name, reason->text);
    pass_on(in, answer);
    return true;
}

bool plb_read_postscript(const input_source *in, display_list *list, error *err)
{
    if (!plb_ghostscript_is_there())
        return draw_alone(in, "fonts and shadings need Ghostscript and pdftocairo (Debian: ghostscript, poppler-utils), which are not installed", list, err);
    ps_request ask = request_of(in, false, false);
    ps_answer answer;
    error reason = {0};
    ps_outcome outcome = plb_ps_read(&ask, list, &answer, &reason);
    if (outcome == PS_FAILED)
        return fail_with(in, outcome, &reason, err);
    if (outcome == PS_HANDED_OVER) {
        plb_list_free(list);
        plb_list_init(list);
        return draw_by_ghostscript(in, &answer, &reason, list, err) ||
               (!err->kind && draw_alone(in, "fonts and shadings need Ghostscript, which fails on this file", list, err));
    }
    if (answer.pages && in->page > answer.pages)
        return plb_fail(err, ERROR_ARGUMENT, "%s: it has no page %u, only %u", in->name, in->page, answer.pages);
    pass_on(in, &answer);
    return true;
}

bool plb_count_postscript_pages(const input_source *in, unsigned *pages, error *err)
{
    ps_request ask = request_of(in, !plb_ghostscript_is_there(), true);
    ps_answer answer;
    display_list list;
    error reason = {0};
    plb_list_init(&list);
    ps_outcome outcome = plb_ps_read(&ask, &list, &answer, &reason);
    plb_list_free(&list);
    *pages = answer.pages;
    if (outcome == PS_DRAWN)
        return true;
    input_source program;
    gs_page page = page_of(in, &answer, &program);
    error why = {0};
    return (outcome == PS_HANDED_OVER && plb_count_pages_by_ghostscript(&program, &page, pages, &why)) || fail_with(in, outcome, &reason, err);
}
