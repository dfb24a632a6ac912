/* SPDX-License-Identifier: MIT
 *
 * Wavefront OBJ: places, faces and lines; the names of materials, whose colours lie in other files and are not read; colours of
 * places, which many programs write behind the coordinates (v X Y Z R G B).
 */
#include "tap/model/read/raw_model.h"

#include "base/number/random.h"
#include "tap/model/read/text.h"

#include <string.h>

typedef struct {
    word name;
    uint32_t paint;
} material;

typedef struct {
    raw_model *m;
    error *err;
    text from;
    unsigned long line;       /* where the statement begins */
    ARRAY(colour) colours;    /* of the places, where some have them */
    ARRAY(uint32_t) corners;  /* of the face at work */
    ARRAY(char) joined;       /* a statement over several lines */
    material *table;          /* of materials by name; a power of two */
    size_t room, materials;
    uint32_t paint;           /* of the faces that follow */
    uint32_t highest;         /* index that a face or line names … */
    unsigned long highest_line; /* … there */
} obj_reader;

static bool fail(const obj_reader *r, const char *what)
{
    return plb_fail(r->err, ERROR_SYNTAX, "%lu: %s", r->line, what);
}

/* ---- places ---- */

static bool add_place(obj_reader *r, word rest)
{
    double v[8];
    int n = 0;
    word w;
    while (n < 8 && plb_text_word(&rest, true, &w))
        if (!plb_word_number(w, &v[n++]))
            return fail(r, "a coordinate is no number");
    if (n < 3)
        return fail(r, "a place needs three coordinates");
    /* A fourth number is a weight, which only rational curves use; six or seven hold a colour. */
    const double *c = n == 6 ? v + 3 : n == 7 ? v + 4 : NULL;
    if (c && !r->colours.n)
        while (r->colours.n < r->m->places.n)
            if (!array_push(&r->colours, ((colour){1, 1, 1})))
                return plb_fail_memory(r->err);
    colour own = c ? (colour){(float)c[0], (float)c[1], (float)c[2]} : (colour){1, 1, 1};
    if ((c || r->colours.n) && !array_push(&r->colours, own))
        return plb_fail_memory(r->err);
    return array_push(&r->m->places, ((vector){v[0], v[1], v[2]})) || plb_fail_memory(r->err);
}

/* ---- materials ---- */

static bool is_same(word a, word b)
{
    return a.end - a.at == b.end - b.at && !memcmp(a.at, b.at, (size_t)(a.end - a.at));
}

/* Gives the place of the name in the table, or the free one where it would go. */
static material *look_up(material *table, size_t room, word name)
{
    uint64_t h = 0;
    for (const char *p = name.at; p < name.end; p++)
        h = random_mix(h ^ (uint64_t)(unsigned char)*p);
    size_t i = h & (room - 1);
    while (table[i].name.at && !is_same(table[i].name, name))
        i = (i + 1) & (room - 1);
    return &table[i];
}

static bool grow_table(obj_reader *r)
{
    size_t room = r->room ? 2 * r->room : 64;
    material *table = plb_new(room, sizeof *table);
    if (!table)
        return plb_fail_memory(r->err);
    for (size_t i = 0; i < r->room; i++)
        if (r->table[i].name.at)
            *look_up(table, room, r->table[i].name) = r->table[i];
    plb_free(r->table);
    r->table = table;
    r->room = room;
    return true;
}

static bool use_material(obj_reader *r, word rest)
{
    word name;
    if (!plb_text_word(&rest, false, &name)) {
        r->paint = 0;
        return true;
    }
    name.end = rest.end; /* names may have blanks in them */
    if (2 * r->materials >= r->room && !grow_table(r))
        return false;
    material *m = look_up(r->table, r->room, name);
    if (!m->name.at) {
        /* The table keeps a copy: a statement over several lines is gone with the next one. */
        size_t n = (size_t)(name.end - name.at);
        char *copy = plb_new(n + 1, 1);
        if (!copy)
            return plb_fail_memory(r->err);
        memcpy(copy, name.at, n);
        *m = (material){{copy, copy + n}, (uint32_t)r->m->paints.n};
        surface_paint p = {{1, 1, 1}, (uint32_t)++r->materials};
        if (!array_push(&r->m->paints, p))
            return plb_fail_memory(r->err);
    }
    r->paint = m->paint;
    return true;
}

/* ---- faces and lines ---- */

/* Reads the place of "7", "7/1", "7//3" or "-2/-2/-2" into the corners. */
static bool add_corner(obj_reader *r, word w)
{
    long long index;
    const char *slash = memchr(w.at, '/', (size_t)(w.end - w.at));
    if (!plb_word_whole((word){w.at, slash ? slash : w.end}, &index))
        return fail(r, "a corner is no number of a place");
    if (index < 0)
        index += (long long)r->m->places.n + 1;
    if (index < 1)
        return plb_fail(r->err, ERROR_SYNTAX, "%lu: a corner names place %lld; they count from 1", r->line, index);
    if (index >= UINT32_MAX)
        return plb_fail(r->err, ERROR_SYNTAX, "%lu: a corner names place %lld, and there are fewer", r->line, index);
    if (index > r->highest) {
        r->highest = (uint32_t)index;
        r->highest_line = r->line;
    }
    return array_push(&r->corners, (uint32_t)(index - 1)) || plb_fail_memory(r->err);
}

static bool read_corners(obj_reader *r, word rest)
{
    word w;
    r->corners.n = 0;
    while (plb_text_word(&rest, true, &w))
        if (!add_corner(r, w))
            return false;
    return true;
}

static bool add_face(obj_reader *r, word rest)
{
    if (!read_corners(r, rest))
        return false;
    uint32_t paint = r->paint;
    bool are_known = r->colours.n > 0; /* all places of the face, so that they have colours */
    for (size_t i = 0; i < r->corners.n; i++)
        are_known = are_known && r->corners.v[i] < r->colours.n;
    if (are_known && !paint && !plb_raw_model_mean_tint(r->m, r->colours.v, r->corners.v, r->corners.n, &paint))
        return plb_fail_memory(r->err);
    return r->corners.n < 3 || plb_raw_model_add_face(r->m, r->corners.v, r->corners.n, paint) || plb_fail_memory(r->err);
}

static bool add_wire(obj_reader *r, word rest)
{
    if (!read_corners(r, rest))
        return false;
    for (size_t i = 1; i < r->corners.n; i++)
        if (!array_push(&r->m->wires, r->corners.v[i - 1]) || !array_push(&r->m->wires, r->corners.v[i]))
            return plb_fail_memory(r->err);
    return true;
}

static bool count_points(obj_reader *r, word rest)
{
    word w;
    while (plb_text_word(&rest, true, &w))
        r->m->points++;
    return true;
}

/* ---- statements ---- */

static bool take_statement(obj_reader *r, word line)
{
    word key;
    if (!plb_text_word(&line, true, &key))
        return true;
    if (plb_word_is(key, "v"))
        return add_place(r, line);
    if (plb_word_is(key, "f") || plb_word_is(key, "fo"))
        return add_face(r, line);
    if (plb_word_is(key, "l"))
        return add_wire(r, line);
    if (plb_word_is(key, "usemtl"))
        return use_material(r, line);
    if (plb_word_is(key, "p"))
        return count_points(r, line);
    r->m->libraries += plb_word_is(key, "mtllib");
    r->m->pictures += plb_word_is(key, "usemap");
    r->m->curves += plb_word_is(key, "curv") || plb_word_is(key, "curv2") || plb_word_is(key, "surf");
    return true; /* groups, normals and the rest say nothing about lines */
}

static bool ends_with_backslash(word line) { return line.end > line.at && line.end[-1] == '\\'; }

/* Puts a statement that goes on in the next lines together. */
static bool join_lines(obj_reader *r, word *line)
{
    r->joined.n = 0;
    for (bool more = true; more;) {
        more = ends_with_backslash(*line);
        size_t n = (size_t)(line->end - line->at) - more;
        if (!array_reserve(&r->joined, n + 1))
            return plb_fail_memory(r->err);
        memcpy(r->joined.v + r->joined.n, line->at, n);
        r->joined.n += n;
        r->joined.v[r->joined.n++] = ' ';
        more = more && plb_text_line(&r->from, line);
    }
    *line = (word){r->joined.v, r->joined.v + r->joined.n};
    return true;
}

static bool read_statements(obj_reader *r)
{
    word line;
    for (;;) {
        r->line = r->from.line;
        if (!plb_text_line(&r->from, &line))
            return true;
        if (ends_with_backslash(line) && !join_lines(r, &line))
            return false;
        if (!take_statement(r, line))
            return false;
    }
}

bool plb_model_read_obj(const char *data, size_t size, raw_model *m, error *err)
{
    obj_reader r = {.m = m, .err = err, .from = {data, data + size, 1}};
    m->up = UP_Y;
    bool ok = array_push(&m->paints, ((surface_paint){{1, 1, 1}, 0})) || plb_fail_memory(err);
    ok = ok && read_statements(&r);
    if (ok && r.highest > m->places.n)
        ok = plb_fail(err, ERROR_SYNTAX, "%lu: a corner names place %lu of %zu", r.highest_line, (unsigned long)r.highest, m->places.n);
    array_free(&r.colours);
    array_free(&r.corners);
    array_free(&r.joined);
    for (size_t i = 0; i < r.room; i++)
        plb_free((void *)r.table[i].name.at);
    plb_free(r.table);
    return ok;
}
