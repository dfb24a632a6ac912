/* SPDX-License-Identifier: MIT
 *
 * Reads PostScript: a file's comments say what its page is, its program draws the display list, which is then turned
 * from device space (up, 7200 dpi, the program's origin) to millimetres on the page.
 */
#include "tap/ps/ps.h"
#include "tap/ps/ps_dsc.h"

#include "base/number/units.h"

#include <limits.h>
#include <math.h>
#include <string.h>

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
    p->max_steps = PS_MAX_STEPS;
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

/* Gives the program the page that it may ask for, before it draws. */
static void expect_page(ps *p, const ps_dsc *dsc)
{
    p->area_is_known = dsc->box_sane || dsc->has_media;
    p->pages_are_known = dsc->is_eps || dsc->pages || p->ask->page;
    p->page_width = dsc->has_media ? dsc->media_width : DEFAULT_WIDTH;
    p->page_height = dsc->has_media ? dsc->media_height : DEFAULT_HEIGHT;
    if (!dsc->is_eps || !dsc->box_sane)
        return;
    p->page_origin = (point){dsc->box.x0, dsc->box.y0};
    p->seen_width = dsc->box.x1 - dsc->box.x0;
    p->seen_height = dsc->box.y1 - dsc->box.y0;
}

static void warn(ps_answer *answer, const char *text)
{
    for (int i = 0; i < PS_MAX_WARNINGS; i++)
        if (!answer->warnings[i]) {
            answer->warnings[i] = text;
            return;
        }
}

/* Gives the bounds of what was drawn, in points, with a margin; false: nothing was drawn, or nothing that fits a page. */
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

/* Finds the page of the drawing, in points. An EPS file's page is its BoundingBox; others say it in the program, in a
 * comment, or not at all. A box that cannot be true gives way to the bounds of what was drawn. */
static box choose_page(ps *p, const ps_dsc *dsc, ps_answer *answer)
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
        warn(answer, "the BoundingBox is missing or impossible; the page is what was drawn");
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

/* Says what the user should know of a page that is drawn, by us or by Ghostscript. */
static void remark(const ps *p, const ps_dsc *dsc, ps_answer *answer)
{
    bool is_cut = !p->page_shown && !p->handed_over && !p->finished && (p->state_count > 1 || p->dict_count > 3);
    if (is_cut)
        warn(answer, "the program ends in the middle of its page; drawn is what it holds");
    if (!p->ask->page && (p->another_page || dsc->pages > 1))
        warn(answer, "only the first page is drawn (--page)");
}

/* ---- Ghostscript ------------------------------------------------------------------------------------------ */

/* Tells whether another interpreter may not meet the error; limits, and what was refused on purpose, are final. */
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

/* Fills in what Ghostscript has to know. A page that this reader did not see the end of is shown once more after the
 * program, which changes nothing when the program showed it; where not even its beginning was seen the word decides. */
static void hand_over(ps *p, ps_answer *answer)
{
    bool good = p->err.kind == ERROR_NONE && !p->handed_over, is_seen = p->handed_over && p->page + 1 == p->page_wanted && plb_ps_page_has_something(p);
    unsigned to_come = good ? !p->page_shown : p->page_wanted - p->page; /* sheets behind those that were shown */
    answer->sheet = p->ask->only_count ? 0 : p->sheets + to_come;
    answer->lacks_showpage = good ? !p->page_shown : is_seen || !has_word(p->program, p->main_file->end, "showpage");
}

/* ---- reading ---------------------------------------------------------------------------------------------- */

/* Runs the program up to the page that is wanted. Errors behind that page do not count. */
static bool run(ps *p, const ps_dsc *dsc, const char *program, size_t length)
{
    expect_page(p, dsc);
    p->program = program;
    if (!start(p, program, length))
        return false;
    if (!plb_ps_run(p) && !p->page_shown)
        return false;
    plb_error_clear(&p->err);
    if (!p->page_shown && !p->handed_over && plb_ps_page_has_something(p)) /* a last page that is not shown counts as well */
        p->page++;
    return true;
}

static ps_outcome read_page(ps *p, const char *program, size_t length, ps_answer *answer)
{
    ps_dsc dsc;
    plb_dsc_read(program, length, PS_MAX_PAGE_POINTS, &dsc);
    bool good = run(p, &dsc, program, length), wants_other = !good || p->handed_over || (p->left && !p->ask->only_count);
    if (!good && (!may_be_our_fault(p) || !p->main_file))
        return PS_FAILED;
    if (good && !p->handed_over && !p->page_shown)
        answer->pages = p->page ? p->page : 1;
    if (answer->pages && answer->pages < p->ask->page)
        return PS_DRAWN;
    if (wants_other)
        hand_over(p, answer);
    answer->area = choose_page(p, &dsc, answer);
    if (good && !p->handed_over)
        place_on_page(p, answer->area);
    if (good)
        remark(p, &dsc, answer);
    if (good && (!wants_other || p->ask->alone))
        return PS_DRAWN;
    if (good)
        plb_fail(&p->err, ERROR_UNSUPPORTED, "%d: '%s' is left to Ghostscript", p->left_line, p->left->name);
    return PS_HANDED_OVER;
}

ps_outcome plb_ps_read(const ps_request *ask, display_list *list, ps_answer *answer, error *err)
{
    ps p = {.ask = ask, .list = list, .page_wanted = ask->only_count ? UINT_MAX : ask->page ? ask->page : 1};
    const char *program;
    size_t length;
    *answer = (ps_answer){0};
    plb_ps_find_program(ask->data, ask->size, &program, &length);
    if (!length) {
        plb_fail(err, ERROR_SYNTAX, "the file holds no PostScript");
        return PS_FAILED;
    }
    ps_outcome outcome = read_page(&p, program, length, answer);
    if (outcome != PS_DRAWN)
        plb_fail(err, p.err.kind ? p.err.kind : ERROR_SYNTAX, "%s", p.err.kind ? p.err.text : "the PostScript program failed");
    finish(&p);
    return outcome;
}
