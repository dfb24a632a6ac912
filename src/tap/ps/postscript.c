/* SPDX-License-Identifier: MIT
 *
 * The PostScript reader: a file's comments say what its page is, its program draws the display list, which is then
 * turned from device space (up, 7200 dpi, the origin where the program has it) to millimetres on the page.
 */
#include "input/ghostscript.h"
#include "tap/ps/ps.h"
#include "tap/ps/ps_dsc.h"

#include "base/number/units.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#define MM_PER_POINT (MM_PER_INCH / 72)
/* The page of a file that names none: A4. */
#define DEFAULT_WIDTH 595.0
#define DEFAULT_HEIGHT 842.0
#define MARGIN_POINTS 5.0 /* around a drawing whose page is its own bounds; chosen by eye */

static void finish(ps *p)
{
    while (p->frame_count)
        plb_ps_pop_frame(p);
    plb_ps_restore_to(p, 1);
    plb_ps_free_kept_states(p);
    if (p->state_count)
        plb_ps_release_path(p, ps_gs(p)->path);
    plb_free(p->states);
    plb_free(p->operands);
    plb_free(p->frames);
    plb_free(p->dicts);
    plb_scan_free(&p->scan);
    plb_ps_free_memory(p);
}

static bool start(ps *p, const char *program, size_t length)
{
    p->random = 1;
    p->line = 1;
    p->operands = plb_new(PS_MAX_OPERANDS, sizeof *p->operands);
    p->frames = plb_new(PS_MAX_FRAMES, sizeof *p->frames);
    p->dicts = plb_new(PS_MAX_DICTS, sizeof *p->dicts);
    if (!p->operands || !p->frames || !p->dicts)
        return plb_fail_memory(&p->err);
    plb_scan_init(&p->scan, program, 0);
    if (!plb_ps_make_system(p) || !plb_ps_init_state(p))
        return plb_fail_memory(&p->err);
    p->main_file = plb_ps_new(p, 1, sizeof *p->main_file);
    if (!p->main_file)
        return false;
    *p->main_file = (ps_file){.at = program, .end = program + length, .line = 1};
    return plb_ps_push_source(p, p->main_file);
}

/* What the program finds when it asks for the page, before it draws. */
static void expect_page(ps *p, const ps_dsc *dsc)
{
    p->page_width = dsc->has_media ? dsc->media_width : DEFAULT_WIDTH;
    p->page_height = dsc->has_media ? dsc->media_height : DEFAULT_HEIGHT;
    if (!dsc->is_eps || !dsc->box_sane)
        return;
    p->page_origin = (point){dsc->box.x0, dsc->box.y0};
    p->seen_width = dsc->box.x1 - dsc->box.x0;
    p->seen_height = dsc->box.y1 - dsc->box.y0;
}

/* Bounds of what was drawn, in points, with a margin; false: nothing, or nothing that fits a page. */
static bool drawn_bounds(ps *p, box *out)
{
    const double u = PS_UNITS_PER_POINT;
    box b = plb_list_bounds(p->list);
    if (plb_box_is_empty(b))
        return false;
    *out = (box){b.x0 / u - MARGIN_POINTS, b.y0 / u - MARGIN_POINTS, b.x1 / u + MARGIN_POINTS, b.y1 / u + MARGIN_POINTS};
    return out->x1 - out->x0 <= PS_MAX_PAGE_POINTS && out->y1 - out->y0 <= PS_MAX_PAGE_POINTS;
}

static bool holds_middle_of(box page, box drawn)
{
    double x = (drawn.x0 + drawn.x1) / 2, y = (drawn.y0 + drawn.y1) / 2;
    return x >= page.x0 && x <= page.x1 && y >= page.y0 && y <= page.y1;
}

/* The page of the drawing, in points. An EPS file's is its BoundingBox; others say it in the program, in a comment,
 * or not at all. A box that cannot be true gives way to what was drawn. */
static box choose_page(ps *p, const ps_dsc *dsc)
{
    box drawn = BOX_EMPTY, page = {0, 0, p->page_width, p->page_height};
    bool has_drawn = drawn_bounds(p, &drawn);
    if (dsc->is_eps && dsc->box_sane)
        return dsc->box;
    if (p->page_size_said || dsc->has_media)
        return page;
    if (dsc->box_sane)
        return dsc->box;
    bool empty = dsc->box.x1 == dsc->box.x0 && dsc->box.y1 == dsc->box.y0; /* 0 0 0 0 stands for "unknown" */
    if (has_drawn && ((dsc->has_box && !empty) || !holds_middle_of(page, drawn))) {
        plb_log(&p->in->say, MESSAGE_WARNING, "%s: the BoundingBox is missing or impossible; the page is what was drawn", p->in->name);
        return drawn;
    }
    return page;
}

static void place_on_page(ps *p, box page)
{
    const double mm = MM_PER_POINT / PS_UNITS_PER_POINT;
    plb_list_transform(p->list, (matrix){mm, 0, 0, -mm, -page.x0 * MM_PER_POINT, page.y1 * MM_PER_POINT});
    p->list->width = (page.x1 - page.x0) * MM_PER_POINT;
    p->list->height = (page.y1 - page.y0) * MM_PER_POINT;
}

/* What holds whoever draws the page. */
static void remark(ps *p, const ps_dsc *dsc)
{
    const log_sink *say = &p->in->say;
    const ps_file *f = p->main_file;
    if (!p->page_shown && !p->finished && (p->state_count > 1 || p->dict_count > 3))
        plb_log(say, MESSAGE_WARNING, "%s: the program ends in the middle of its page; drawn is what it holds", p->in->name);
    if (p->page_shown && !p->in->page && (dsc->pages > 1 || plb_dsc_has_page(f->at, (size_t)(f->end - f->at))))
        plb_log(say, MESSAGE_WARNING, "%s: only the first page is drawn (--page)", p->in->name);
}

/* ---- the other way ---------------------------------------------------------------------------------------- */

/* Errors that another interpreter may not meet; limits, and what was refused on purpose, are final. */
static bool may_be_our_fault(const ps *p)
{
    return (p->err.kind == ERROR_UNSUPPORTED || p->err.kind == ERROR_SYNTAX) && p->last_fault != PS_INVALIDFILEACCESS && !p->refused;
}

static bool has_word(const char *text, const char *end, const char *word)
{
    size_t n = strlen(word);
    for (; (size_t)(end - text) >= n; text++)
        if (!memcmp(text, word, n))
            return true;
    return false;
}

/* The page for Ghostscript: as far as our reader came, it knows. */
static gs_page page_of(ps *p, const ps_dsc *dsc, bool good)
{
    const ps_file *f = p->main_file;
    const char *program = p->program;
    gs_page page = {.area = choose_page(p, dsc)};
    page.sheet = p->page_shown ? p->sheets : good ? p->sheets + 1 : p->page_wanted;
    page.lacks_showpage = good ? !p->page_shown : !has_word(program, f->end, "showpage");
    return page;
}

static input_source program_of(const ps *p)
{
    input_source in = *p->in;
    in.data = p->program;
    in.size = (size_t)(p->main_file->end - p->program);
    return in;
}

/* Draws the page anew by Ghostscript; false, with the reason, when that fails: then the list is as it was. */
static bool draw_by_ghostscript(ps *p, const gs_page *page, error *err)
{
    display_list other;
    plb_list_init(&other);
    input_source in = program_of(p);
    if (!plb_read_by_ghostscript(&in, page, &other, err)) {
        plb_list_free(&other);
        return false;
    }
    display_list ours = *p->list;
    *p->list = other;
    plb_list_free(&ours);
    return true;
}

/* What a user can do about text and shades that Ghostscript did not draw. */
static const char *advice_on(const error *why)
{
    if (!plb_ghostscript_is_there())
        return "fonts and shadings need Ghostscript (Debian: ghostscript), which is not installed";
    if (why->kind == ERROR_LIMIT)
        return "fonts and shadings need Ghostscript, which needs more time or memory than it may have";
    return "fonts and shadings need Ghostscript, which fails on this file";
}

/* The next run, with more memory or disk, would draw more: better to fail than to make another picture. */
static bool is_passing(const error *why) { return why->kind == ERROR_MEMORY || why->kind == ERROR_FILE; }

/* Our reader drew the page but for its text or shades: Ghostscript knows fonts. False: Ghostscript
 * could not be run. */
static bool improve(ps *p, const gs_page *page)
{
    error why = {0};
    omissions ours = p->list->omissions;
    const log_sink *say = &p->in->say;
    if (!ours.n[OMISSION_TEXT] && !ours.n[OMISSION_SHADING])
        return true;
    if (plb_ghostscript_is_there() && draw_by_ghostscript(p, page, &why)) {
        omissions *theirs = &p->list->omissions; /* there letters made of pixels count as images and masks */
        theirs->n[OMISSION_IMAGE] = ours.n[OMISSION_IMAGE];
        theirs->n[OMISSION_PIXEL_TEXT] = ours.n[OMISSION_PIXEL_TEXT];
        theirs->n[OMISSION_MASK] = theirs->n[OMISSION_FILTER] = 0;
        plb_log(say, MESSAGE_DETAIL, "%s: read by Ghostscript, for its text or shades", p->in->name);
        return true;
    }
    if (is_passing(&why))
        return plb_fail(&p->err, why.kind, "%s", why.text);
    if (why.kind)
        plb_log(say, MESSAGE_DETAIL, "%s", why.text);
    plb_omissions_advise(&p->list->omissions, advice_on(&why));
    return true;
}

/* Our reader failed. True: Ghostscript did not. */
static bool rescue(ps *p, const ps_dsc *dsc)
{
    error why = {0};
    if (!may_be_our_fault(p) || !p->main_file)
        return false;
    if (!plb_ghostscript_is_there()) {
        if (p->err.kind == ERROR_UNSUPPORTED)
            strncat(p->err.text, "; Ghostscript would help (Debian: ghostscript)", sizeof p->err.text - strlen(p->err.text) - 1);
        return false;
    }
    gs_page page = page_of(p, dsc, false);
    if (!draw_by_ghostscript(p, &page, &why)) {
        if (is_passing(&why))
            p->err = why;
        else
            plb_log(&p->in->say, MESSAGE_DETAIL, "%s", why.text);
        return false;
    }
    plb_log(&p->in->say, MESSAGE_DETAIL, "%s; read by Ghostscript", p->err.text);
    plb_error_clear(&p->err);
    return true;
}

/* ---- reading ---------------------------------------------------------------------------------------------- */

/* Runs the program up to the page that is wanted. */
static bool run(ps *p, const ps_dsc *dsc, const char *program, size_t length)
{
    expect_page(p, dsc);
    p->program = program;
    if (!start(p, program, length) || !plb_ps_run(p))
        return false;
    if (!p->page_shown && plb_ps_page_has_something(p)) /* a last page that is not shown counts as well */
        p->page++;
    return true;
}

static bool read_program(ps *p, const char *program, size_t length)
{
    ps_dsc dsc;
    plb_dsc_read(program, length, PS_MAX_PAGE_POINTS, &dsc);
    p->page_wanted = p->in->page ? p->in->page : 1;
    if (!run(p, &dsc, program, length))
        return rescue(p, &dsc);
    if (p->page < p->page_wanted && p->page_wanted > 1)
        return plb_fail(&p->err, ERROR_ARGUMENT, "%s: it has no page %u, only %u", p->in->name, p->page_wanted, p->page ? p->page : 1);
    gs_page page = page_of(p, &dsc, true);
    place_on_page(p, page.area);
    if (!improve(p, &page))
        return false;
    remark(p, &dsc);
    return true;
}

static bool count_pages(ps *p, const char *program, size_t length)
{
    ps_dsc dsc;
    plb_dsc_read(program, length, PS_MAX_PAGE_POINTS, &dsc);
    p->page_wanted = UINT_MAX;
    if (run(p, &dsc, program, length))
        return true;
    if (!may_be_our_fault(p) || !p->main_file || !plb_ghostscript_is_there())
        return false;
    error why = {0};
    gs_page page = page_of(p, &dsc, false);
    input_source in = program_of(p);
    page.sheet = 0;
    if (!plb_count_pages_by_ghostscript(&in, &page, &p->page, &why))
        return false;
    plb_error_clear(&p->err);
    return true;
}

/* Runs `what` on the file's program. */
static bool with_program(ps *p, bool (*what)(ps *p, const char *program, size_t length), error *err)
{
    const char *program;
    size_t length;
    plb_dsc_find_program(p->in->data, p->in->size, &program, &length);
    if (!length)
        return plb_fail(err, ERROR_SYNTAX, "%s: the file holds no PostScript", p->in->name);
    bool good = what(p, program, length);
    if (!good)
        plb_fail(err, p->err.kind ? p->err.kind : ERROR_SYNTAX, "%s", p->err.kind ? p->err.text : "the PostScript program failed");
    finish(p);
    return good;
}

bool plb_read_postscript(const input_source *in, display_list *list, error *err)
{
    ps p = {.in = in, .list = list};
    return with_program(&p, read_program, err);
}

bool plb_count_postscript_pages(const input_source *in, unsigned *pages, error *err)
{
    display_list list;
    input_source quietly = *in;
    quietly.say = (log_sink){0};
    plb_list_init(&list);
    ps p = {.in = &quietly, .list = &list};
    bool good = with_program(&p, count_pages, err);
    plb_list_free(&list);
    *pages = p.page ? p.page : 1;
    return good;
}
