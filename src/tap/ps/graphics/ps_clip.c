/* SPDX-License-Identifier: MIT
 *
 * Narrows the clip: each PostScript clip becomes an entry of the display list that narrows the one before it (PLRM,
 * section 4.4.3).
 */
#include "tap/ps/ps.h"

#include <math.h>

static box intersection(box a, box b)
{
    return (box){fmax(a.x0, b.x0), fmax(a.y0, b.y0), fmin(a.x1, b.x1), fmin(a.y1, b.y1)};
}

static box page_bounds(const ps *p)
{
    const double u = PS_UNITS_PER_POINT;
    double width = p->page_width, height = p->page_height, x = 0, y = 0;
    if (p->seen_width > 0) {
        width = p->seen_width;
        height = p->seen_height;
        x = p->page_origin.x;
        y = p->page_origin.y;
    }
    return (box){x * u, y * u, (x + width) * u, (y + height) * u};
}

box plb_ps_clip_bounds(ps *p)
{
    box b = page_bounds(p);
    if (ps_gs(p)->nothing_visible)
        return (box){b.x0, b.y0, b.x0, b.y0};
    for (int i = ps_gs(p)->clip; i != NO_CLIP; i = p->list->clips.v[i].parent) {
        const path *shape = &p->list->clips.v[i].path;
        b = intersection(b, plb_path_bounds(shape));
        p->steps += shape->points.n / 8 + 1;
    }
    return b.x1 < b.x0 || b.y1 < b.y0 ? (box){b.x0, b.y0, b.x0, b.y0} : b;
}

static bool encloses_nothing(const path *shape)
{
    for (size_t i = 0; i < shape->ops.n; i++)
        if (shape->ops.v[i] == PATH_LINE || shape->ops.v[i] == PATH_CURVE)
            return false;
    return true;
}

/* Tells whether the new clip is the one already there: programs repeat clips around every object. */
static bool is_repeated(ps *p, const path *shape, bool even_odd)
{
    int i = ps_gs(p)->clip;
    return i != NO_CLIP && p->list->clips.v[i].even_odd == even_odd && plb_path_equal(&p->list->clips.v[i].path, shape);
}

bool plb_ps_clip_to_path(ps *p, bool even_odd)
{
    ps_state *g = ps_gs(p);
    const path *shape = &g->path->path;
    clip c = {.even_odd = even_odd, .parent = g->clip};
    if (g->is_outline || p->page_shown) /* the area of a line is not known here: leave it unclipped; the list is complete */
        return true;
    if (encloses_nothing(shape)) {
        g->nothing_visible = true;
        return true;
    }
    if (!plb_ps_charge(p, shape->points.n / 4))
        return false;
    if (is_repeated(p, shape, even_odd))
        return true;
    if (!plb_ps_count_list(p, shape))
        return false;
    bool good = plb_path_append(&c.path, shape, MATRIX_IDENTITY) || plb_fail_memory(&p->err);
    good = good && plb_list_add_clip(p->list, &c, &g->clip, &p->err);
    plb_path_free(&c.path);
    return good;
}

static bool op_clip(ps *p) { return plb_ps_clip_to_path(p, false); }
static bool op_eoclip(ps *p) { return plb_ps_clip_to_path(p, true); }

static bool op_initclip(ps *p)
{
    ps_gs(p)->clip = NO_CLIP;
    ps_gs(p)->nothing_visible = false;
    return true;
}

/* A ps_kept_clip is a clip that clipsave put aside in this graphics state; the last comes first. */
struct ps_kept_clip {
    struct ps_kept_clip *below;
    int clip;
    bool nothing_visible;
};

static bool op_clipsave(ps *p)
{
    ps_state *g = ps_gs(p);
    struct ps_kept_clip *kept = plb_ps_new(p, 1, sizeof *kept);
    if (!kept)
        return false;
    *kept = (struct ps_kept_clip){g->kept_clips, g->clip, g->nothing_visible};
    g->kept_clips = kept;
    return true;
}

static bool op_cliprestore(ps *p)
{
    ps_state *g = ps_gs(p);
    if (!g->kept_clips)
        return op_initclip(p);
    g->clip = g->kept_clips->clip;
    g->nothing_visible = g->kept_clips->nothing_visible;
    g->kept_clips = g->kept_clips->below;
    return true;
}

/* Gives the one clip there is, or the box of several: their exact common area is nobody's path. */
static bool op_clippath(ps *p)
{
    const ps_state *g = ps_gs(p);
    path shape = {0};
    bool good;
    if (g->clip != NO_CLIP && !g->nothing_visible && p->list->clips.v[g->clip].parent == NO_CLIP) {
        good = plb_path_append(&shape, &p->list->clips.v[g->clip].path, MATRIX_IDENTITY);
    } else {
        box b = plb_ps_clip_bounds(p);
        good = plb_path_move(&shape, (point){b.x0, b.y0}) && plb_path_line(&shape, (point){b.x1, b.y0}) &&
               plb_path_line(&shape, (point){b.x1, b.y1}) && plb_path_line(&shape, (point){b.x0, b.y1}) &&
               plb_path_close(&shape);
    }
    good = good ? plb_ps_charge(p, shape.points.n / 8) && plb_ps_replace_path(p, &shape) : plb_fail_memory(&p->err);
    plb_path_free(&shape);
    return good;
}

const ps_operator plb_ps_clip_operators[] = {
    {"clip", "", op_clip},
    {"eoclip", "", op_eoclip},
    {"clipsave", "", op_clipsave},
    {"cliprestore", "", op_cliprestore},
    {"initclip", "", op_initclip},
    {"clippath", "", op_clippath},
    {NULL, NULL, NULL},
};
