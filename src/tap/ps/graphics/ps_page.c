/* SPDX-License-Identifier: MIT
 *
 * Ends the pages: showpage ends the reading, setpagedevice and the names of paper sizes say how large the page is
 * (PLRM, section 6).
 */
#include "tap/ps/ps.h"

#include <string.h>

bool plb_ps_set_page_size(ps *p, double width, double height)
{
    if (!(width >= 1 && width <= PS_MAX_PAGE_POINTS && height >= 1 && height <= PS_MAX_PAGE_POINTS))
        return plb_ps_raise(p, PS_RANGECHECK);
    p->page_width = width;
    p->page_height = height;
    p->page_size_said = true;
    return true;
}

/* Drops the items alone: saved graphics states may name the clips. */
static void clear_page(ps *p)
{
    for (size_t i = 0; i < p->list->items.n; i++)
        plb_item_free(&p->list->items.v[i]);
    p->list->items.n = 0;
}

bool plb_ps_page_has_something(const ps *p)
{
    const unsigned long *lost = p->list->omissions.n;
    return p->list->items.n || lost[OMISSION_IMAGE] || lost[OMISSION_TEXT] || lost[OMISSION_PIXEL_TEXT];
}

bool plb_ps_count_list(ps *p, const path *shape)
{
    /* the item itself, its two blocks, and what malloc adds */
    p->list_bytes += sizeof(item) + 96 + shape->ops.n + shape->points.n * sizeof(point);
    return p->list_bytes <= PS_MAX_LIST_BYTES ||
           plb_ps_fail(p, ERROR_LIMIT, "the drawing takes more than %zu MB", PS_MAX_LIST_BYTES >> 20);
}

bool plb_ps_may_mark(ps *p)
{
    if (!p->page_shown)
        return true;
    p->another_page = p->finished = true;
    return false;
}

void plb_ps_omit(ps *p, omission_kind kind)
{
    if (plb_ps_may_mark(p))
        p->list->omissions.n[kind]++;
}

void plb_ps_note_left(ps *p)
{
    if (p->left || p->page_shown)
        return;
    p->left = p->op;
    p->left_line = p->line;
}

/* Where the comments leave open what the page is the program runs on without the thing: it may still say. */
bool plb_ps_leave_to_ghostscript(ps *p, omission_kind kind)
{
    plb_ps_omit(p, kind);
    plb_ps_note_left(p);
    if (p->ask->alone || p->page_shown || p->page + 1 != p->page_wanted || !p->pages_are_known ||
        !(p->area_is_known || p->page_size_said))
        return p->finished;
    return p->handed_over = p->finished = true;
}

/* Pages that have something on them count. After the one that is wanted the program runs on, within bounds of its own,
 * until the next one gets something, unless the user asked for this page. */
static bool op_showpage(ps *p)
{
    if (p->page_shown)
        return true;
    p->sheets++;
    p->page += plb_ps_page_has_something(p);
    if (p->page == p->page_wanted) {
        p->page_shown = true;
        p->finished = p->ask->page != 0;
        if (p->max_steps - p->steps > PS_MAX_STEPS_AFTER)
            p->max_steps = p->steps + PS_MAX_STEPS_AFTER;
        plb_ps_reset_graphics(p);
        return true;
    }
    p->left = NULL;
    clear_page(p);
    p->list->omissions = (omissions){.advice = ""};
    plb_ps_reset_graphics(p);
    return true;
}

static bool op_copypage(ps *p)
{
    (void)p;
    return true;
}

/* Paints the page white: what was drawn is gone. */
static bool op_erasepage(ps *p)
{
    if (!p->page_shown)
        clear_page(p);
    return true;
}

static bool op_setpagedevice(ps *p)
{
    ps_object dict = *ps_args(p, 1), *size = plb_ps_get_text(p, dict.as.dict, "PageSize");
    if (size && size->type == PS_ARRAY && size->n == 2 && ps_is_number(size->as.array[0]) && ps_is_number(size->as.array[1]) &&
        !plb_ps_set_page_size(p, ps_value(size->as.array[0]), ps_value(size->as.array[1])))
        return false;
    plb_ps_reset_graphics(p);
    ps_drop(p, 1);
    return true;
}

static bool put_pair(ps *p, ps_dict *d, const char *key, double a, double b)
{
    ps_object array;
    if (!plb_ps_new_array(p, 2, &array))
        return false;
    array.as.array[0] = ps_real(a);
    array.as.array[1] = ps_real(b);
    return plb_ps_put_text(p, d, key, array);
}

static bool op_currentpagedevice(ps *p)
{
    ps_dict *d = plb_ps_new_dict(p, 8);
    return d && put_pair(p, d, "PageSize", p->page_width, p->page_height) &&
           put_pair(p, d, "HWResolution", 72 * PS_UNITS_PER_POINT, 72 * PS_UNITS_PER_POINT) &&
           plb_ps_put_text(p, d, "ImagingBBox", ps_null()) && plb_ps_put_text(p, d, "Duplex", ps_boolean(false)) &&
           plb_ps_put_text(p, d, "NumCopies", ps_null()) && plb_ps_push(p, ps_of_dict(d));
}

/* These paper sizes, in points, are operators, too. */
static const struct {
    const char *name;
    double width, height;
} papers[] = {
    {"letter", 612, 792}, {"lettersmall", 612, 792}, {"note", 612, 792}, {"legal", 612, 1008}, {"ledger", 1224, 792},
    {"tabloid", 792, 1224}, {"11x17", 792, 1224}, {"a0", 2384, 3370}, {"a1", 1684, 2384}, {"a2", 1191, 1684},
    {"a3", 842, 1191}, {"a4", 595, 842}, {"a4small", 595, 842}, {"a5", 420, 595}, {"a6", 298, 420}, {"b4", 709, 1001},
    {"b5", 499, 709},
};

static bool op_paper(ps *p)
{
    for (size_t i = 0; i < sizeof papers / sizeof *papers; i++)
        if (!strcmp(papers[i].name, p->op->name))
            return plb_ps_set_page_size(p, papers[i].width, papers[i].height);
    return true;
}

const ps_operator plb_ps_page_operators[] = {
    {"showpage", "", op_showpage},
    {"copypage", "", op_copypage},
    {"erasepage", "", op_erasepage},
    {"setpagedevice", "d", op_setpagedevice},
    {"currentpagedevice", "", op_currentpagedevice},
    {"letter", "", op_paper},
    {"lettersmall", "", op_paper},
    {"note", "", op_paper},
    {"legal", "", op_paper},
    {"ledger", "", op_paper},
    {"tabloid", "", op_paper},
    {"11x17", "", op_paper},
    {"a0", "", op_paper},
    {"a1", "", op_paper},
    {"a2", "", op_paper},
    {"a3", "", op_paper},
    {"a4", "", op_paper},
    {"a4small", "", op_paper},
    {"a5", "", op_paper},
    {"a6", "", op_paper},
    {"b4", "", op_paper},
    {"b5", "", op_paper},
    {NULL, NULL, NULL},
};
