/* SPDX-License-Identifier: MIT
 *
 * OFF, the object file format of Geomview: a head, places, faces; perhaps with colours of either.
 */
#include "tap/model/read/raw_model.h"

#include "tap/model/read/text.h"

#include <string.h>

typedef struct {
    raw_model *m;
    error *err;
    text from;
    bool has_colours, has_normals, has_texture, has_weight; /* of the places */
    ARRAY(colour) colours;
    ARRAY(uint32_t) corners;
} off_reader;

static bool fail(const off_reader *r, unsigned long line, const char *what)
{
    return plb_fail(r->err, ERROR_SYNTAX, "%lu: %s", line, what);
}

/* Gives the next line that has a word in it, and its number. */
static bool next_line(text *t, word *line, unsigned long *number)
{
    do {
        *number = t->line;
        word look, first;
        if (!plb_text_line(t, line))
            return false;
        look = *line;
        if (plb_text_word(&look, true, &first))
            return true;
    } while (true);
}

/* Reads so many numbers as there are, at most `max`. */
static int read_numbers(word *line, double *v, int max)
{
    int n = 0;
    word w;
    while (n < max && plb_text_word(line, true, &w) && plb_word_number(w, &v[n]))
        n++;
    return n;
}

/* The first word says which numbers belong to a place: [ST][C][N][4]OFF. */
static bool read_key(off_reader *r, word key)
{
    if (key.end - key.at >= 2 && !memcmp(key.at, "ST", 2))
        r->has_texture = true, key.at += 2;
    if (key.at < key.end && *key.at == 'C')
        r->has_colours = true, key.at++;
    if (key.at < key.end && *key.at == 'N')
        r->has_normals = true, key.at++;
    if (key.at < key.end && *key.at == '4')
        r->has_weight = true, key.at++;
    return plb_word_is(key, "OFF");
}

static bool read_places(off_reader *r, size_t n)
{
    word line;
    unsigned long number = r->from.line;
    for (size_t i = 0; i < n; i++) {
        double v[16];
        if (!next_line(&r->from, &line, &number))
            return plb_fail(r->err, ERROR_SYNTAX, "%lu: its head promises %zu places, and %zu follow", number, n, i);
        int have = read_numbers(&line, v, 16), at = 3 + r->has_weight;
        if (have < at)
            return fail(r, number, "a place needs three coordinates");
        double w = r->has_weight && v[3] != 0 ? v[3] : 1;
        at += r->has_normals ? 3 : 0;
        if (!array_push(&r->m->places, ((vector){v[0] / w, v[1] / w, v[2] / w})))
            return plb_fail_memory(r->err);
        bool has = r->has_colours && have >= at + 3;
        double full = has && (v[at] > 1 || v[at + 1] > 1 || v[at + 2] > 1) ? 255 : 1;
        colour c = has ? (colour){(float)(v[at] / full), (float)(v[at + 1] / full), (float)(v[at + 2] / full)} : (colour){1, 1, 1};
        if (r->has_colours && !array_push(&r->colours, c))
            return plb_fail_memory(r->err);
    }
    return true;
}

/* A face's colour follows its corners: three or four numbers, whole ones up to 255 or fractions; a lone one is a number in a table
 * that nobody has. */
static bool read_face_paint(off_reader *r, word line, uint32_t *paint)
{
    double v[4];
    int n = read_numbers(&line, v, 4);
    if (n < 3)
        return !r->colours.n || plb_raw_model_mean_tint(r->m, r->colours.v, r->corners.v, r->corners.n, paint);
    double full = v[0] > 1 || v[1] > 1 || v[2] > 1 ? 255 : 1;
    return plb_raw_model_tint(r->m, v[0] / full, v[1] / full, v[2] / full, paint);
}

static bool read_faces(off_reader *r, size_t n)
{
    word line, w;
    unsigned long number = r->from.line;
    for (size_t i = 0; i < n; i++) {
        long long count, index;
        if (!next_line(&r->from, &line, &number))
            return plb_fail(r->err, ERROR_SYNTAX, "%lu: its head promises %zu faces, and %zu follow", number, n, i);
        if (!plb_text_word(&line, true, &w) || !plb_word_whole(w, &count) || count < 0)
            return fail(r, number, "a face begins with the number of its corners");
        r->corners.n = 0;
        for (long long k = 0; k < count; k++) {
            if (!plb_text_word(&line, true, &w) || !plb_word_whole(w, &index))
                return fail(r, number, "a face has fewer corners than it says");
            if (index < 0 || (unsigned long long)index >= r->m->places.n)
                return plb_fail(r->err, ERROR_SYNTAX, "%lu: a corner names place %lld of %zu", number, index, r->m->places.n);
            if (!array_push(&r->corners, (uint32_t)index))
                return plb_fail_memory(r->err);
        }
        uint32_t paint = 0;
        if (!read_face_paint(r, line, &paint))
            return plb_fail_memory(r->err);
        if (count == 2 && (!array_push(&r->m->wires, r->corners.v[0]) || !array_push(&r->m->wires, r->corners.v[1])))
            return plb_fail_memory(r->err);
        if (count > 2 && !plb_raw_model_add_face(r->m, r->corners.v, r->corners.n, paint))
            return plb_fail_memory(r->err);
    }
    return true;
}

static bool read_all(off_reader *r)
{
    word line, key, w;
    unsigned long number;
    long long counts[2];
    if (!next_line(&r->from, &line, &number) || !plb_text_word(&line, true, &key) || !read_key(r, key))
        return fail(r, 1, "it does not begin with OFF");
    bool is_here = plb_text_word(&line, true, &w);
    if (is_here && plb_word_is(w, "BINARY"))
        return plb_fail(r->err, ERROR_UNSUPPORTED, "binary OFF is not read; save it as text");
    if (!is_here && (!next_line(&r->from, &line, &number) || !plb_text_word(&line, true, &w)))
        return fail(r, number, "it ends behind its head");
    if (!plb_word_whole(w, &counts[0]) || !plb_text_word(&line, true, &w) || !plb_word_whole(w, &counts[1]) || counts[0] < 0 || counts[1] < 0)
        return fail(r, number, "the numbers of places and faces are missing");
    return read_places(r, (size_t)counts[0]) && read_faces(r, (size_t)counts[1]);
}

bool plb_model_read_off(const char *data, size_t size, raw_model *m, error *err)
{
    off_reader r = {.m = m, .err = err, .from = {data, data + size, 1}};
    m->up = UP_Y;
    bool ok = array_push(&m->paints, ((surface_paint){{1, 1, 1}, 0})) || plb_fail_memory(err);
    ok = ok && read_all(&r);
    array_free(&r.colours);
    array_free(&r.corners);
    return ok;
}
