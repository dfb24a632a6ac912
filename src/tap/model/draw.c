/* SPDX-License-Identifier: MIT
 *
 * See model.h: the table of contents. Faces become a mesh, the mesh a view on paper; the view's lines are found, joined to rows,
 * hidden where something lies before them; light falls on what is seen; tones and lines become items of the list.
 */
#include "tap/model/model.h"

#include "tap/model/sheet.h"

#include <stdio.h>

model_settings plb_model_settings_default(void)
{
    return (model_settings){.from = {35, 22, 0}, .is_upright_by_format = true, .crease = 30, .light = {true, -40, 45}};
}

bool plb_model_read(const char *data, size_t size, model_format format, raw_model *m, error *err)
{
    static bool (*const readers[MODEL_FORMATS])(const char *, size_t, raw_model *, error *) = {
        [MODEL_OBJ] = plb_model_read_obj, [MODEL_STL] = plb_model_read_stl, [MODEL_PLY] = plb_model_read_ply, [MODEL_OFF] = plb_model_read_off};
    return readers[format](data, size, m, err);
}

/* ---- all of it ---- */

static bool make_mesh(raw_model *raw, const model_settings *s, mesh *m, error *err)
{
    up_axis up = s->is_upright_by_format ? raw->up : s->up;
    if (!plb_mesh_make(raw, up, m, err))
        return false;
    plb_raw_model_free(raw);
    return plb_mesh_weld(m, err) && plb_mesh_edges(m, err) && plb_mesh_classify(m, s->crease * PLB_PI / 180, err) && plb_mesh_smooth(m, err);
}

static bool write_single(item_writer *w, const mesh *m, double unit, const model_settings *s)
{
    view v;
    bool ok = plb_view_make(m, s->from, &v, w->err);
    if (ok) {
        double width = v.bounds.x1 - v.bounds.x0, height = v.bounds.y1 - v.bounds.y0;
        double scale = plb_view_scale(width * unit, height * unit, 0, 0);
        plb_view_place(&v, scale * unit, VIEW_MARGIN - v.bounds.x0 * scale * unit, VIEW_MARGIN - v.bounds.y0 * scale * unit);
        plb_view_write_page(w, v.bounds.x1 + VIEW_MARGIN, v.bounds.y1 + VIEW_MARGIN, scale);
        ok = plb_view_write(w, &v, s->hidden == HIDDEN_AUTO ? HIDDEN_NONE : s->hidden, s->light);
    }
    plb_view_free(&v);
    return ok;
}

/* Tells the user what the pencil leaves out. */
static void write_warnings(list_writer *w, const raw_model *raw, const mesh *m)
{
    const struct {
        unsigned long n;
        const char *one, *many;
    } said[] = {
        {raw->libraries, "its materials lie in another file, which is not read: surfaces have no colour", "its materials lie in %lu other files, which are not read: surfaces have no colour"},
        {raw->pictures, "left out: 1 picture on its surfaces", "left out: %lu pictures on its surfaces"},
        {raw->points, "left out: 1 point", "left out: %lu points"},
        {raw->curves, "left out: 1 free-form curve or surface", "left out: %lu free-form curves or surfaces"},
        {m->lost, "left out: 1 face with a corner that is nowhere (no number, or too large)", "left out: %lu faces with a corner that is nowhere (no number, or too large)"},
    };
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        char text[160];
        if (!said[i].n)
            continue;
        snprintf(text, sizeof text, said[i].n == 1 ? said[i].one : said[i].many, said[i].n);
        plb_list_writer_message(w, MESSAGE_WARNING, text);
    }
}

bool plb_model_draw(raw_model *raw, const model_settings *s, list_put put, void *closure, error *err)
{
    list_writer *w = plb_new(1, sizeof *w);
    mesh m = {0};
    double unit = raw->unit > 0 ? raw->unit : 1;
    size_t places = raw->places.n;
    bool ok = w || plb_fail_memory(err);
    ok = ok && make_mesh(raw, s, &m, err);
    if (ok && !m.triangles.n && !m.wires.n)
        ok = plb_fail(err, ERROR_SYNTAX, places ? "it has places, and no face with an area between them" : "it has no faces");
    if (ok) {
        item_writer to = {.w = w, .err = err};
        plb_list_writer_init(w, put, closure);
        write_warnings(w, raw, &m);
        ok = s->sheet == SHEET_NONE ? write_single(&to, &m, unit, s) : plb_sheet_write(&to, &m, unit, s);
        ok = ok && plb_list_writer_end(w);
        plb_item_free(&to.item);
    }
    plb_mesh_free(&m);
    plb_free(w);
    return ok;
}
