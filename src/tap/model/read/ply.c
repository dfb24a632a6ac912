/* SPDX-License-Identifier: MIT
 *
 * PLY, the polygon format of Stanford: a head that says which elements follow and what each consists of; then these, as text or as bytes of
 * either order. Places (vertex), faces (face) and strips of triangles (tristrips) count; the rest is passed over.
 */
#include "tap/model/read/raw_model.h"

#include "tap/model/read/bytes.h"
#include "tap/model/read/text.h"

#include <string.h>

#define MAX_ELEMENTS 32
#define MAX_PROPERTIES 64

typedef enum { TYPE_NONE, TYPE_SIGNED, TYPE_UNSIGNED, TYPE_FLOAT } type_kind;
typedef struct {
    type_kind kind;
    int bytes;
} number_type;

typedef enum { MEANS_NOTHING, MEANS_X, MEANS_Y, MEANS_Z, MEANS_RED, MEANS_GREEN, MEANS_BLUE, MEANS_CORNERS, MEANINGS } meaning;

typedef struct {
    meaning means;
    number_type type, count; /* count.kind is TYPE_NONE: no list */
} property;

typedef enum { ELEMENT_OTHER, ELEMENT_VERTEX, ELEMENT_FACE, ELEMENT_STRIP } element_kind;
typedef struct {
    element_kind kind;
    unsigned long long n;
    int properties;
    property property[MAX_PROPERTIES];
} element;

typedef struct {
    raw_model *m;
    error *err;
    text from; /* its rest; `at` alone counts when it is binary */
    bool is_binary, is_big;
    int elements;
    element element[MAX_ELEMENTS];
    ARRAY(colour) colours;
    ARRAY(uint32_t) corners;
    double value[MEANINGS]; /* of the element at work */
} ply_reader;

static bool fail(const ply_reader *r, const char *what)
{
    return r->is_binary ? plb_fail(r->err, ERROR_SYNTAX, "%s", what) : plb_fail(r->err, ERROR_SYNTAX, "%lu: %s", r->from.line, what);
}

/* ---- the head ---- */

static number_type type_of(word w)
{
    static const struct {
        const char *name, *other;
        number_type type;
    } names[] = {
        {"char", "int8", {TYPE_SIGNED, 1}}, {"uchar", "uint8", {TYPE_UNSIGNED, 1}}, {"short", "int16", {TYPE_SIGNED, 2}},
        {"ushort", "uint16", {TYPE_UNSIGNED, 2}}, {"int", "int32", {TYPE_SIGNED, 4}}, {"uint", "uint32", {TYPE_UNSIGNED, 4}},
        {"float", "float32", {TYPE_FLOAT, 4}}, {"double", "float64", {TYPE_FLOAT, 8}},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (plb_word_is(w, names[i].name) || plb_word_is(w, names[i].other))
            return names[i].type;
    return (number_type){TYPE_NONE, 0};
}

static meaning meaning_of(element_kind kind, word name)
{
    static const struct {
        const char *name;
        meaning means;
    } places[] = {{"x", MEANS_X}, {"y", MEANS_Y}, {"z", MEANS_Z}}, tints[] = {{"red", MEANS_RED}, {"green", MEANS_GREEN}, {"blue", MEANS_BLUE}, {"diffuse_red", MEANS_RED}, {"diffuse_green", MEANS_GREEN}, {"diffuse_blue", MEANS_BLUE}, {"r", MEANS_RED}, {"g", MEANS_GREEN}, {"b", MEANS_BLUE}},
      lists[] = {{"vertex_indices", MEANS_CORNERS}, {"vertex_index", MEANS_CORNERS}};
    for (size_t i = 0; kind == ELEMENT_VERTEX && i < sizeof places / sizeof *places; i++)
        if (plb_word_is(name, places[i].name))
            return places[i].means;
    for (size_t i = 0; kind != ELEMENT_OTHER && i < sizeof tints / sizeof *tints; i++)
        if (plb_word_is(name, tints[i].name))
            return tints[i].means;
    for (size_t i = 0; kind > ELEMENT_VERTEX && i < sizeof lists / sizeof *lists; i++)
        if (plb_word_is(name, lists[i].name))
            return lists[i].means;
    return MEANS_NOTHING;
}

static bool take_property(ply_reader *r, word line)
{
    word w;
    property p = {MEANS_NOTHING, {TYPE_NONE, 0}, {TYPE_NONE, 0}};
    if (!r->elements)
        return fail(r, "a property before the first element");
    element *e = &r->element[r->elements - 1];
    if (e->properties == MAX_PROPERTIES)
        return fail(r, "an element has too many properties");
    bool ok = plb_text_word(&line, false, &w), is_list = ok && plb_word_is(w, "list");
    if (is_list) {
        ok = plb_text_word(&line, false, &w);
        p.count = ok ? type_of(w) : p.count;
        ok = ok && p.count.kind && plb_text_word(&line, false, &w);
    }
    p.type = ok ? type_of(w) : p.type;
    if (!p.type.kind || !plb_text_word(&line, false, &w))
        return fail(r, "a property without type or name");
    p.means = meaning_of(e->kind, w);
    if (is_list != (p.means == MEANS_CORNERS))
        p.means = MEANS_NOTHING;
    e->property[e->properties++] = p;
    return true;
}

static bool take_element(ply_reader *r, word line)
{
    word name, w;
    long long n;
    if (!plb_text_word(&line, false, &name) || !plb_text_word(&line, false, &w) || !plb_word_whole(w, &n) || n < 0)
        return fail(r, "an element without name or number");
    if (r->elements == MAX_ELEMENTS)
        return fail(r, "it has too many kinds of elements");
    element *e = &r->element[r->elements++];
    e->n = (unsigned long long)n;
    e->kind = plb_word_is(name, "vertex") ? ELEMENT_VERTEX : plb_word_is(name, "face") ? ELEMENT_FACE : plb_word_is(name, "tristrips") ? ELEMENT_STRIP : ELEMENT_OTHER;
    return true;
}

static bool take_format(ply_reader *r, word line)
{
    word w;
    if (plb_text_word(&line, false, &w) && plb_word_is(w, "ascii"))
        return true;
    r->is_big = plb_word_is(w, "binary_big_endian");
    r->is_binary = r->is_big || plb_word_is(w, "binary_little_endian");
    return r->is_binary || plb_fail(r->err, ERROR_SYNTAX, "2: the format is neither ascii nor binary_little_endian or binary_big_endian");
}

static bool read_head(ply_reader *r)
{
    word line, key;
    bool has_format = false;
    while (plb_text_line(&r->from, &line)) {
        if (!plb_text_word(&line, false, &key) || plb_word_is(key, "ply") || plb_word_is(key, "comment") || plb_word_is(key, "obj_info"))
            continue;
        if (plb_word_is(key, "end_header"))
            return has_format || fail(r, "the head names no format");
        bool is_format = plb_word_is(key, "format");
        has_format = has_format || is_format;
        bool ok = is_format ? take_format(r, line) : plb_word_is(key, "element") ? take_element(r, line) : !plb_word_is(key, "property") || take_property(r, line);
        if (!ok)
            return false;
    }
    return fail(r, "the head does not end");
}

/* ---- the elements ---- */

static bool read_value(ply_reader *r, number_type t, double *v)
{
    word w;
    if (!r->is_binary) /* comments there are none, but nobody else begins a number with '#' */
        return (plb_text_next(&r->from, &w) && plb_word_number(w, v)) || fail(r, "it ends early, or a word is no number");
    if (r->from.end - r->from.at < t.bytes)
        return fail(r, "it ends early");
    const char *at = r->from.at;
    r->from.at += t.bytes;
    if (t.kind == TYPE_FLOAT) {
        *v = t.bytes == 4 ? plb_bytes_float(at, r->is_big) : plb_bytes_double(at, r->is_big);
        return true;
    }
    uint64_t u = plb_bytes_whole(at, t.bytes, r->is_big), sign = (uint64_t)1 << (8 * t.bytes - 1);
    *v = t.kind == TYPE_SIGNED && (u & sign) ? (double)u - 2 * (double)sign : (double)u;
    return true;
}

static bool read_list(ply_reader *r, const property *p)
{
    double n, v;
    if (!read_value(r, p->count, &n))
        return false;
    if (!(n >= 0 && n < 4e9))
        return fail(r, "a list of impossible length");
    if (p->means == MEANS_CORNERS)
        r->corners.n = 0;
    for (double i = 0; i < n; i++) {
        if (!read_value(r, p->type, &v))
            return false;
        if (p->means != MEANS_CORNERS)
            continue;
        /* A strip begins again behind -1, which is kept as the highest number. */
        uint32_t index = v >= 0 && v < 4e9 ? (uint32_t)v : UINT32_MAX;
        if (!array_push(&r->corners, index))
            return plb_fail_memory(r->err);
    }
    return true;
}

static bool add_place(ply_reader *r, bool has_colours, double full)
{
    const double *v = r->value;
    colour c = {(float)(v[MEANS_RED] / full), (float)(v[MEANS_GREEN] / full), (float)(v[MEANS_BLUE] / full)};
    bool ok = array_push(&r->m->places, ((vector){v[MEANS_X], v[MEANS_Y], v[MEANS_Z]})) && (!has_colours || array_push(&r->colours, c));
    return ok || plb_fail_memory(r->err);
}

static bool add_polygon(ply_reader *r, const uint32_t *corners, size_t n, bool has_colours, double full)
{
    uint32_t paint = 0;
    const double *v = r->value;
    for (size_t i = 0; i < n; i++)
        if (corners[i] >= r->m->places.n) {
            if (corners[i] == UINT32_MAX)
                return fail(r, "a corner names a place below 0");
            return r->is_binary ? plb_fail(r->err, ERROR_SYNTAX, "a corner names place %lu of %zu", (unsigned long)corners[i], r->m->places.n)
                                : plb_fail(r->err, ERROR_SYNTAX, "%lu: a corner names place %lu of %zu", r->from.line, (unsigned long)corners[i], r->m->places.n);
        }
    bool ok = true;
    if (has_colours)
        ok = plb_raw_model_tint(r->m, v[MEANS_RED] / full, v[MEANS_GREEN] / full, v[MEANS_BLUE] / full, &paint);
    else if (r->colours.n)
        ok = plb_raw_model_mean_tint(r->m, r->colours.v, corners, n, &paint);
    return (ok && (n < 3 || plb_raw_model_add_face(r->m, corners, n, paint))) || plb_fail_memory(r->err);
}

/* Every three neighbours of a strip are a triangle, each second one turned over. */
static bool add_strip(ply_reader *r, bool has_colours, double full)
{
    size_t first = 0;
    for (size_t i = 0; i < r->corners.n; i++) {
        const uint32_t *c = r->corners.v + i;
        if (*c == UINT32_MAX) {
            first = i + 1;
            continue;
        }
        if (i < first + 2)
            continue;
        bool is_turned = (i - first) % 2;
        uint32_t t[3] = {c[-2], is_turned ? c[0] : c[-1], is_turned ? c[-1] : c[0]};
        if (!add_polygon(r, t, 3, has_colours, full))
            return false;
    }
    return true;
}

static bool read_elements(ply_reader *r, const element *e)
{
    bool has[MEANINGS] = {false};
    double full = 255;
    for (int k = 0; k < e->properties; k++) {
        has[e->property[k].means] = true;
        if (e->property[k].means == MEANS_RED && e->property[k].type.kind == TYPE_FLOAT)
            full = 1;
    }
    bool has_colours = has[MEANS_RED] && has[MEANS_GREEN] && has[MEANS_BLUE];
    if (!e->properties)
        return true;
    if (e->kind == ELEMENT_VERTEX && !(has[MEANS_X] && has[MEANS_Y] && has[MEANS_Z]))
        return fail(r, "its places have no x, y and z");
    for (unsigned long long i = 0; i < e->n; i++) {
        r->corners.n = 0;
        for (int k = 0; k < e->properties; k++) {
            const property *p = &e->property[k];
            if (!(p->count.kind ? read_list(r, p) : read_value(r, p->type, &r->value[p->means])))
                return false;
        }
        bool ok = e->kind == ELEMENT_VERTEX ? add_place(r, has_colours, full) : e->kind == ELEMENT_FACE ? add_polygon(r, r->corners.v, r->corners.n, has_colours, full) : e->kind != ELEMENT_STRIP || add_strip(r, has_colours, full);
        if (!ok)
            return false;
    }
    return true;
}

bool plb_model_read_ply(const char *data, size_t size, raw_model *m, error *err)
{
    ply_reader *r = plb_new(1, sizeof *r);
    if (!r || !array_push(&m->paints, ((surface_paint){{1, 1, 1}, 0}))) {
        plb_free(r);
        return plb_fail_memory(err);
    }
    r->m = m;
    r->err = err;
    r->from = (text){data, data + size, 1};
    m->up = UP_Y;
    bool ok = read_head(r);
    for (int i = 0; ok && i < r->elements; i++)
        ok = read_elements(r, &r->element[i]);
    array_free(&r->colours);
    array_free(&r->corners);
    plb_free(r);
    return ok;
}
