/* SPDX-License-Identifier: MIT
 *
 * Copies a display list onto a larger sheet.
 */
#include "plan/reduction/reduction.h"

#include <string.h>

/* Copies the elements of an array into an empty one. */
#define COPY(to, from) (array_reserve((to), (from)->n) && ((from)->n == 0 || memcpy((to)->v, (from)->v, (from)->n * sizeof *(from)->v)) && ((to)->n = (from)->n, true))

static bool copy_path(path *to, const path *from)
{
    return COPY(&to->ops, &from->ops) && COPY(&to->points, &from->points);
}

/* Copies what the item owns, too. */
static bool copy_item(item *to, const item *from)
{
    *to = *from;
    memset(&to->path, 0, sizeof to->path);
    memset(&to->dash, 0, sizeof to->dash);
    to->text = from->text ? plb_text_run_copy(from->text, 1) : NULL;
    return (to->text || !from->text) && copy_path(&to->path, &from->path) && COPY(&to->dash, &from->dash);
}

static bool copy_clip(clip *to, const clip *from)
{
    *to = *from;
    memset(&to->path, 0, sizeof to->path);
    return copy_path(&to->path, &from->path);
}

bool plb_list_enlarged(display_list *out, const display_list *list, double factor, error *err)
{
    plb_list_init(out);
    bool ok = array_reserve(&out->items, list->items.n) && array_reserve(&out->clips, list->clips.n) && COPY(&out->gradients, &list->gradients);
    for (size_t i = 0; ok && i < list->items.n; i++)
        ok = copy_item(&out->items.v[out->items.n++], &list->items.v[i]);
    for (size_t i = 0; ok && i < list->clips.n; i++)
        ok = copy_clip(&out->clips.v[out->clips.n++], &list->clips.v[i]);
    if (!ok)
        return plb_fail_memory(err);
    out->width = list->width * factor;
    out->height = list->height * factor;
    out->points = list->points;
    out->dashes = list->dashes;
    out->characters = list->characters;
    out->paper_scale = list->paper_scale;
    out->omissions = list->omissions;
    plb_list_transform(out, plb_matrix_scale(factor, factor));
    return true;
}
