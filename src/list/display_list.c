/* SPDX-License-Identifier: MIT
 *
 * This file appends to the display list, measures it and maps it.
 */
#include "list/display_list.h"

#include <math.h>
#include <string.h>

/* No page reaches 10 km. Points beyond come from broken files and would only cost precision. */
#define FARTHEST_MM 1e7

void plb_list_init(display_list *list)
{
    memset(list, 0, sizeof *list);
    list->paper_scale = 1;
}

void plb_item_free(item *it)
{
    plb_path_free(&it->path);
    array_free(&it->dash);
    plb_text_run_free(it->text);
    it->text = NULL;
}

void plb_list_free(display_list *list)
{
    for (size_t i = 0; i < list->items.n; i++)
        plb_item_free(&list->items.v[i]);
    for (size_t i = 0; i < list->clips.n; i++)
        plb_path_free(&list->clips.v[i].path);
    array_free(&list->items);
    array_free(&list->clips);
    array_free(&list->gradients);
}

static bool is_on_earth(const path *p)
{
    for (size_t i = 0; i < p->points.n; i++)
        if (!(fabs(p->points.v[i].x) < FARTHEST_MM && fabs(p->points.v[i].y) < FARTHEST_MM))
            return false;
    return true;
}

bool plb_list_add(display_list *list, item *it, error *err)
{
    bool is_far = !is_on_earth(&it->path);
    if (plb_path_is_empty(&it->path) || is_far) {
        list->omissions.n[OMISSION_FAR] += is_far;
        plb_item_free(it);
        return true;
    }
    if (list->items.n >= LIST_MAX_ITEMS || it->path.points.n > LIST_MAX_POINTS - list->points)
        return plb_fail(err, ERROR_LIMIT, "the drawing has more than %u items or %u points", LIST_MAX_ITEMS, LIST_MAX_POINTS);
    if (it->dash.n > LIST_MAX_DASHES - list->dashes)
        return plb_fail(err, ERROR_LIMIT, "the drawing has more than %u dashes", LIST_MAX_DASHES);
    if (!array_push(&list->items, *it))
        return plb_fail_memory(err);
    list->points += it->path.points.n;
    list->dashes += it->dash.n;
    list->characters += it->text ? it->text->characters.n : 0;
    memset(it, 0, sizeof *it);
    return true;
}

bool plb_list_add_clip(display_list *list, clip *c, int *index, error *err)
{
    if (list->clips.n >= LIST_MAX_ITEMS || c->path.points.n > LIST_MAX_POINTS - list->points)
        return plb_fail(err, ERROR_LIMIT, "the drawing has more than %u clips or %u points", LIST_MAX_ITEMS, LIST_MAX_POINTS);
    if (!array_push(&list->clips, *c))
        return plb_fail_memory(err);
    list->points += c->path.points.n;
    *index = (int)list->clips.n - 1;
    memset(c, 0, sizeof *c);
    return true;
}

void plb_list_transform(display_list *list, matrix m)
{
    double f = plb_matrix_expansion(m);
    for (size_t i = 0; i < list->items.n; i++) {
        item *it = &list->items.v[i];
        plb_path_transform(&it->path, m);
        if (it->text && !plb_text_run_map(it->text, m, true)) {
            plb_text_run_free(it->text);
            it->text = NULL;
        }
        if (it->is_directed)
            it->direction = plb_matrix_turn(m, it->direction);
        it->width *= f;
        it->dash_offset *= f;
        for (size_t k = 0; k < it->dash.n; k++)
            it->dash.v[k] *= f;
    }
    for (size_t i = 0; i < list->clips.n; i++)
        plb_path_transform(&list->clips.v[i].path, m);
    matrix back = MATRIX_IDENTITY;
    plb_matrix_invert(m, &back);
    for (size_t i = 0; i < list->gradients.n; i++)
        list->gradients.v[i].to_space = plb_matrix_multiply(back, list->gradients.v[i].to_space);
}

/* Tells whether no part of the box, widened by half the line's width, lies on the page. */
static bool is_off_page(const display_list *list, const item *it)
{
    box b = plb_path_bounds(&it->path);
    double more = it->kind == ITEM_STROKE ? it->width / 2 : 0;
    return b.x1 + more < 0 || b.y1 + more < 0 || b.x0 - more > list->width || b.y0 - more > list->height;
}

omissions plb_list_count_omissions(const display_list *list)
{
    omissions all = list->omissions;
    for (size_t i = 0; i < list->items.n; i++) {
        const item *it = &list->items.v[i];
        if (!(it->paint.alpha > 0))
            all.n[OMISSION_INVISIBLE]++;
        else if (is_off_page(list, it))
            all.n[OMISSION_OFF_PAGE]++;
        else if (it->paint.kind == PAINT_PATTERN)
            all.n[OMISSION_PATTERN]++;
    }
    return all;
}

box plb_list_bounds(const display_list *list)
{
    box all = BOX_EMPTY;
    for (size_t i = 0; i < list->items.n; i++) {
        box b = plb_path_bounds(&list->items.v[i].path);
        plb_box_add(&all, (point){b.x0, b.y0});
        plb_box_add(&all, (point){b.x1, b.y1});
    }
    return all;
}

double plb_paint_lightness(paint p)
{
    double luma = 0.299 * p.red + 0.587 * p.green + 0.114 * p.blue;
    return 1 - p.alpha * (1 - luma);
}
