/* SPDX-License-Identifier: MIT
 *
 * Writes what reaches the page to the list at once, for the CairoScript reader. Paths are written in the units in which
 * they come, short numbers, with a map to the page that changes only between groups. A number that is not finite has no
 * place in the list.
 */
#include "tap/svg/cairoscript_state.h"

#include <math.h>

static bool all_finite(const double *v, size_t n)
{
    bool ok = true;
    for (size_t i = 0; i < n; i++)
        ok = ok && isfinite(v[i]);
    return ok;
}

static bool is_finite_path(const path *p)
{
    bool ok = true;
    for (size_t i = 0; i < p->points.n; i++)
        ok = ok && isfinite(p->points.v[i].x) && isfinite(p->points.v[i].y);
    return ok;
}

static bool is_finite_matrix(matrix m) { return all_finite((double[6]){m.xx, m.yx, m.xy, m.yy, m.x0, m.y0}, 6); }

static bool is_same(matrix a, matrix b)
{
    return a.xx == b.xx && a.yx == b.yx && a.xy == b.xy && a.yy == b.yy && a.x0 == b.x0 && a.y0 == b.y0;
}

static void write_matrix(script_state *s, matrix m)
{
    if (!is_same(m, s->written))
        plb_list_writer_matrix(s->out, m);
    s->written = m;
}

/* Tells whether all lengths of a line are such as a list may have. */
static bool is_sane_line(const item *it)
{
    bool ok = it->width >= 0 && isfinite(it->width) && isfinite(it->dash_offset);
    for (size_t i = 0; i < it->dash.n; i++)
        ok = ok && it->dash.v[i] >= 0 && isfinite(it->dash.v[i]);
    return ok;
}

bool plb_script_write_item(script_state *s, const item *it, matrix m)
{
    if (plb_path_is_empty(&it->path))
        return true;
    if (!is_finite_matrix(m) || !is_finite_path(&it->path) || !is_sane_line(it)) {
        s->page.omissions.n[OMISSION_FAR]++;
        return true;
    }
    write_matrix(s, m);
    plb_list_writer_item(s->out, it);
    return true;
}

bool plb_script_write_clip(script_state *s, const clip *c, matrix m)
{
    if (!is_finite_matrix(m) || !is_finite_path(&c->path))
        return plb_fail(s->err, ERROR_LIMIT, "a clip path is at an impossible place");
    write_matrix(s, m);
    plb_list_writer_clip(s->out, c);
    return true;
}

bool plb_script_is_sane_gradient(const gradient *g)
{
    double v[] = {g->from.x, g->from.y, g->from_radius, g->to.x, g->to.y, g->to_radius, g->opacity};
    return is_finite_matrix(g->to_space) && all_finite(v, sizeof v / sizeof *v) && g->from_radius >= 0 && g->to_radius >= 0;
}

void plb_script_write_gradient(script_state *s, const gradient *g)
{
    write_matrix(s, MATRIX_IDENTITY);
    plb_list_writer_gradient(s->out, g);
}
