/* SPDX-License-Identifier: MIT
 *
 * STL: triangles, as text or as numbers of 32 bits. Which of the two it is the size tells, for both may begin with "solid".
 */
#include "tap/model/read/raw_model.h"

#include "tap/model/read/bytes.h"
#include "tap/model/read/text.h"

#define HEAD_BYTES 84
#define TRIANGLE_BYTES 50

static bool add_triangle(raw_model *m, const vector v[3], error *err)
{
    uint32_t first = (uint32_t)m->places.n, corners[3] = {first, first + 1, first + 2};
    for (int i = 0; i < 3; i++)
        if (!array_push(&m->places, v[i]))
            return plb_fail_memory(err);
    return plb_raw_model_add_face(m, corners, 3, 0) || plb_fail_memory(err);
}

static bool read_binary(const char *data, size_t n, raw_model *m, error *err)
{
    for (size_t i = 0; i < n; i++) {
        const char *at = data + HEAD_BYTES + i * TRIANGLE_BYTES + 12; /* behind the normal */
        vector v[3];
        for (int k = 0; k < 3; k++, at += 12)
            v[k] = (vector){plb_bytes_float(at, false), plb_bytes_float(at + 4, false), plb_bytes_float(at + 8, false)};
        if (!add_triangle(m, v, err))
            return false;
    }
    return true;
}

static bool read_number(text *t, double *value, error *err)
{
    word w;
    return (plb_text_next(t, &w) && plb_word_number(w, value)) || plb_fail(err, ERROR_SYNTAX, "%lu: a vertex needs three numbers", t->line);
}

/* The words "vertex X Y Z" count, three to a facet; the rest says nothing that they do not. */
static bool read_text(const char *data, size_t size, raw_model *m, error *err)
{
    text t = {data, data + size, 1};
    word w;
    vector v[3];
    int n = 0;
    while (plb_text_next(&t, &w)) {
        if (plb_word_is(w, "facet") || plb_word_is(w, "FACET"))
            n = 0;
        if (!plb_word_is(w, "vertex") && !plb_word_is(w, "VERTEX"))
            continue;
        if (n == 3)
            return plb_fail(err, ERROR_SYNTAX, "%lu: a facet has more than three vertices", t.line);
        if (!read_number(&t, &v[n].x, err) || !read_number(&t, &v[n].y, err) || !read_number(&t, &v[n].z, err))
            return false;
        if (++n == 3 && !add_triangle(m, v, err))
            return false;
    }
    return true;
}

bool plb_model_read_stl(const char *data, size_t size, raw_model *m, error *err)
{
    size_t n = size >= HEAD_BYTES ? plb_bytes_whole(data + 80, 4, false) : 0;
    m->up = UP_Z;
    m->unit = 0;
    if (!array_push(&m->paints, ((surface_paint){{1, 1, 1}, 0})))
        return plb_fail_memory(err);
    bool is_binary = size >= HEAD_BYTES && (size - HEAD_BYTES) / TRIANGLE_BYTES == n && (size - HEAD_BYTES) % TRIANGLE_BYTES == 0;
    bool is_text = size >= 5 && (data[0] | 0x20) == 's' && (data[1] | 0x20) == 'o';
    if (is_binary || is_text)
        return is_binary ? read_binary(data, n, m, err) : read_text(data, size, m, err);
    if (size < HEAD_BYTES || n > (size - HEAD_BYTES) / TRIANGLE_BYTES)
        return plb_fail(err, ERROR_SYNTAX, "its head promises %zu triangles, and %zu follow", n, size < HEAD_BYTES ? 0 : (size - HEAD_BYTES) / TRIANGLE_BYTES);
    return read_binary(data, n, m, err); /* something follows the triangles */
}
