/* SPDX-License-Identifier: MIT
 *
 * See typeset.h. librsvg and Pango are others' libraries and tell nobody about their text. But Pango asks cairo for the outlines by a
 * function that the linker finds first in the program: the one below, which lets cairo do the work and looks on. The font says which
 * character a glyph is. Should the outlines come about in another way some day, nothing is written down, and the list has paths
 * without characters as before.
 */
#define _GNU_SOURCE
#include "tap/svg/typeset/typeset.h"

#include <cairo-ft.h>
#include <dlfcn.h>
#include <glib.h>

#include <math.h>
#include <string.h>

#include FT_FREETYPE_H

/* A path is looked for among the outlines of so many calls: text that is not painted, or stroked only, leaves its outlines behind. */
#define CALLS_AHEAD 64u
/* Points of the same path differ by no more, in the units of the surface: cairo's are 1/256, and the script is decimal. */
#define SAME_POINT 0.02
/* Outlines of more points are like no other shape. */
#define FEW_POINTS 12u
#define UNKNOWN 0xfffd /* the code of a glyph that is no character by itself */

typedef void (*glyph_path)(cairo_t *cr, const cairo_glyph_t *glyphs, int n);

/* The outlines of one call, in the units of the surface, and what they say. */
typedef struct {
    text_run text;
    ARRAY(point) points; /* of all steps, in order */
} outline_note;

static GQueue notes = G_QUEUE_INIT;

static void free_note(gpointer data)
{
    outline_note *n = data;
    array_free(&n->points);
    array_free(&n->text.characters);
    g_free(n);
}

void plb_typeset_forget(void)
{
    outline_note *n;
    while ((n = g_queue_pop_head(&notes)) != NULL)
        free_note(n);
}

/* ---- characters of glyphs ---- */

/* Gives the lowest code whose glyph that is. A table of the font is kept until another font comes; what it says is asked again of the
 * font itself, because a font may take the place of one that is gone. */
static uint32_t code_of(FT_Face face, unsigned glyph)
{
    static GHashTable *codes;
    static FT_Face known;
    if (face != known) {
        g_clear_pointer(&codes, g_hash_table_destroy);
        codes = g_hash_table_new(NULL, NULL);
        known = face;
        FT_UInt index;
        for (FT_ULong code = FT_Get_First_Char(face, &index); index; code = FT_Get_Next_Char(face, code, &index))
            if (!g_hash_table_contains(codes, GUINT_TO_POINTER(index)))
                g_hash_table_insert(codes, GUINT_TO_POINTER(index), GUINT_TO_POINTER((guint)code));
    }
    uint32_t code = GPOINTER_TO_UINT(g_hash_table_lookup(codes, GUINT_TO_POINTER(glyph)));
    return code && code <= 0x10ffff && FT_Get_Char_Index(face, code) == glyph ? code : UNKNOWN;
}

/* ---- what cairo draws ---- */

/* Adds the points of all steps of the path to `note`, unless that is NULL, and tells how many subpaths there are. */
static bool take_path(cairo_t *cr, outline_note *note, const matrix *to_surface, size_t *subpaths)
{
    cairo_path_t *p = cairo_copy_path(cr);
    bool ok = p->status == CAIRO_STATUS_SUCCESS;
    *subpaths = 0;
    for (int i = 0; ok && i < p->num_data; i += p->data[i].header.length) {
        cairo_path_data_type_t type = p->data[i].header.type;
        bool is_last = i + p->data[i].header.length >= p->num_data;
        if (type == CAIRO_PATH_MOVE_TO && is_last)
            break;
        *subpaths += type == CAIRO_PATH_MOVE_TO;
        for (int k = 1; ok && k < p->data[i].header.length && type != CAIRO_PATH_CLOSE_PATH; k++) {
            point at = plb_matrix_apply(*to_surface, (point){p->data[i + k].point.x, p->data[i + k].point.y});
            ok = array_push(&note->points, at);
        }
    }
    cairo_path_destroy(p);
    return ok;
}

/* Writes the glyphs down one by one. */
static bool add_glyphs(glyph_path real, cairo_t *scratch, FT_Face face, const cairo_glyph_t *glyphs, int n, matrix to_surface, outline_note *note)
{
    for (int i = 0; i < n; i++) {
        size_t subpaths;
        character c = {{0}, 0, plb_matrix_apply(to_surface, (point){glyphs[i].x, glyphs[i].y})};
        cairo_new_path(scratch);
        real(scratch, &glyphs[i], 1);
        if (!take_path(scratch, note, &to_surface, &subpaths))
            return false;
        c.code[0] = code_of(face, (unsigned)glyphs[i].index);
        c.subpaths = (uint32_t)subpaths;
        if (subpaths && !array_push(&note->text.characters, c))
            return false;
    }
    return true;
}

static void write_down(glyph_path real, cairo_t *cr, const cairo_glyph_t *glyphs, int n)
{
    cairo_scaled_font_t *font = cairo_get_scaled_font(cr);
    FT_Face face = cairo_scaled_font_get_type(font) == CAIRO_FONT_TYPE_FT ? cairo_ft_scaled_font_lock_face(font) : NULL;
    if (!face)
        return;
    outline_note *note = g_new0(outline_note, 1);
    cairo_matrix_t m, em;
    cairo_get_matrix(cr, &m);
    cairo_scaled_font_get_font_matrix(font, &em);
    matrix to_surface = {m.xx, m.yx, m.xy, m.yy, m.x0, m.y0}, of_font = {em.xx, em.yx, em.xy, em.yy, 0, 0}, all = plb_matrix_multiply(of_font, to_surface);
    cairo_surface_t *nothing = cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, NULL); /* without bounds: glyphs outside would be dropped */
    cairo_t *scratch = cairo_create(nothing);
    cairo_set_matrix(scratch, &m);
    cairo_set_scaled_font(scratch, font);
    FT_CharMap chosen = face->charmap;
    bool ok = !FT_Select_Charmap(face, FT_ENCODING_UNICODE) && plb_matrix_determinant(all) > 0 && add_glyphs(real, scratch, face, glyphs, n, to_surface, note);
    cairo_destroy(scratch);
    cairo_surface_destroy(nothing);
    if (chosen)
        FT_Set_Charmap(face, chosen);
    cairo_ft_scaled_font_unlock_face(font);
    note->text.em = plb_matrix_expansion(all);
    note->text.degrees = atan2(all.yx, all.xx) * 180 / PLB_PI;
    if (ok && note->text.characters.n && isfinite(note->text.em))
        g_queue_push_tail(&notes, note);
    else
        free_note(note);
}

/* Stands before cairo's own function of that name. */
__attribute__((visibility("default"))) void cairo_glyph_path(cairo_t *cr, const cairo_glyph_t *glyphs, int n)
{
    static glyph_path real;
    if (!real) {
        void *found = dlsym(RTLD_NEXT, "cairo_glyph_path");
        memcpy(&real, &found, sizeof real); /* ISO C has no cast for that */
    }
    if (!real)
        return;
    real(cr, glyphs, n);
    write_down(real, cr, glyphs, n);
}

/* ---- what is recognised ---- */

/* Gives the map that takes the first `n` points of `from` to those of `to`, by three of them that span the most; false: they lie on a line. */
static bool fit_map(const point *from, const point *to, size_t n, matrix *m)
{
    size_t b = 0, c = 0;
    double far = 0, wide = 0;
    for (size_t i = 1; i < n; i++)
        if (plb_point_distance(from[0], from[i]) > far)
            far = plb_point_distance(from[0], from[b = i]);
    point u = point_sub(from[b], from[0]);
    for (size_t i = 1; i < n; i++)
        if (fabs(point_cross(u, point_sub(from[i], from[0]))) > wide)
            wide = fabs(point_cross(u, point_sub(from[c = i], from[0])));
    if (!(wide > 1e-3 * far * far))
        return false;
    point v = point_sub(from[c], from[0]), to_u = point_sub(to[b], to[0]), to_v = point_sub(to[c], to[0]);
    matrix basis = {u.x, u.y, v.x, v.y, from[0].x, from[0].y}, image = {to_u.x, to_u.y, to_v.x, to_v.y, to[0].x, to[0].y}, back;
    if (!plb_matrix_invert(basis, &back))
        return false;
    *m = plb_matrix_multiply(back, image);
    return true;
}

/* Tells whether the map keeps shapes. Of a few corners every map makes some shape that a drawing may have: a bar is an l to one that does not. */
static bool keeps_shapes(matrix m)
{
    double size = fabs(m.xx) + fabs(m.yx) + fabs(m.xy) + fabs(m.yy);
    return fabs(m.xx - m.yy) < 2e-3 * size && fabs(m.xy + m.yx) < 2e-3 * size;
}

/* Tells whether the path goes on from its point number `from` with the outlines under the map. */
static bool goes_on(const outline_note *n, const path *p, size_t from, matrix m)
{
    double slack = SAME_POINT * (1 + plb_matrix_expansion(m));
    if (n->points.n > p->points.n - from || !(plb_matrix_determinant(m) > 0))
        return false;
    for (size_t i = 0; i < n->points.n; i++) {
        point off = point_sub(p->points.v[from + i], plb_matrix_apply(m, n->points.v[i]));
        if (!(fabs(off.x) <= slack && fabs(off.y) <= slack))
            return false;
    }
    return true;
}

/* Tells whether the path begins with the outlines, and under which map: librsvg maps what Pango gave. */
static bool begins_with(const outline_note *n, const path *p, matrix *m)
{
    size_t count = n->points.n;
    return count <= p->points.n && fit_map(n->points.v, p->points.v, count, m) && (count > FEW_POINTS || keeps_shapes(*m)) && goes_on(n, p, 0, *m);
}

/* Adds the note's characters to the text; false where their size or direction is another, or memory is short. */
static bool add_note(text_run *t, const outline_note *n)
{
    if (fabs(t->em - n->text.em) > 0.01 * t->em || fabs(t->degrees - n->text.degrees) > 0.01)
        return false;
    for (size_t i = 0; i < n->text.characters.n; i++)
        if (!array_push(&t->characters, n->text.characters.v[i]))
            return false;
    return true;
}

text_run *plb_typeset_recognise(void *closure, const path *p)
{
    (void)closure;
    GList *l = notes.head;
    matrix m = MATRIX_IDENTITY;
    guint before = 0;
    for (; l && before < CALLS_AHEAD && !begins_with(l->data, p, &m); l = l->next)
        before++;
    if (!l || before == CALLS_AHEAD)
        return NULL;
    /* Those before were not filled. */
    for (; before; before--)
        free_note(g_queue_pop_head(&notes));
    outline_note *first = g_queue_pop_head(&notes);
    text_run *t = plb_text_run_copy(&first->text, 1);
    /* Those behind may go on with the path. */
    size_t from = first->points.n;
    free_note(first);
    while (t && (l = notes.head) != NULL && goes_on(l->data, p, from, m) && add_note(t, l->data)) {
        from += ((outline_note *)l->data)->points.n;
        free_note(g_queue_pop_head(&notes));
    }
    if (t && plb_text_run_map(t, m, true))
        return t;
    plb_text_run_free(t);
    return NULL;
}
