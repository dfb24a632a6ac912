/* SPDX-License-Identifier: MIT
 *
 * Solid models: tap-model reads OBJ, STL, PLY and OFF and draws what is seen. Which of them a file is stands here.
 */
#include "input/format/model.h"

#include "base/number/number.h"
#include "input/tap.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* A sign of the format lies within so many bytes of the start; comments of programs may stand before the first statement. */
#define SIGN_BYTES ((size_t)65536)

/* ---- which format ---- */

static bool is_blank(char c) { return c == ' ' || c == '\t'; }
static bool is_end(char c) { return c == '\n' || c == '\r'; }

static bool starts_with(const char *at, const char *end, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(end - at) >= n && !memcmp(at, word, n);
}

static bool is_ply(const char *data, size_t size)
{
    return size > 4 && starts_with(data, data + size, "ply") && is_end(data[3]);
}

/* The word OFF, perhaps after the letters that say what belongs to a place. */
static bool is_off(const char *data, size_t size)
{
    static const char *const letters[] = {"ST", "C", "N", "4", "n"};
    const char *at = data, *end = data + size;
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (starts_with(at, end, letters[i]) && !starts_with(at, end, "OFF"))
            at += strlen(letters[i]);
    return starts_with(at, end, "OFF") && end - at > 3 && (is_blank(at[3]) || is_end(at[3]) || at[3] == '#');
}

/* Binary STL has no sign but its size: 84 bytes, with a number at the end, and 50 for each triangle. Text says "solid", and soon
 * "facet" or that this was all. */
static bool is_stl(const char *data, size_t size)
{
    enum { HEAD = 84, TRIANGLE = 50 };
    const unsigned char *count = (const unsigned char *)data + HEAD - 4;
    size_t n = size >= HEAD ? count[0] | (size_t)count[1] << 8 | (size_t)count[2] << 16 | (size_t)count[3] << 24 : 0;
    if (size >= HEAD && n > 0 && (size - HEAD) / TRIANGLE == n && (size - HEAD) % TRIANGLE == 0)
        return true;
    const char *at = data, *end = data + (size < SIGN_BYTES ? size : SIGN_BYTES);
    while (at < end && (is_blank(*at) || is_end(*at)))
        at++;
    if (!starts_with(at, end, "solid") && !starts_with(at, end, "SOLID"))
        return false;
    for (; at < end; at++)
        if (starts_with(at, end, "facet") || starts_with(at, end, "FACET") || starts_with(at, end, "endsolid"))
            return true;
    return false;
}

/* Tells whether three numbers follow, or what programs write for one that is none. */
static bool is_place(const char *at, const char *end)
{
    int n = 0;
    for (; at < end && n < 3; n++) {
        while (at < end && is_blank(*at))
            at++;
        if (at == end || !memchr("+-.0123456789nNiI", *at, 17))
            return false;
        while (at < end && !is_blank(*at))
            at++;
    }
    return n == 3;
}

/* Each line of an OBJ begins with one of these words; among them is a place before long. */
static bool is_obj(const char *data, size_t size)
{
    static const char *const keys[] = {"v", "vn", "vt", "vp", "f", "l", "p", "g", "o", "s", "mg", "mtllib", "usemtl", "usemap", "cstype", "deg", "parm", "curv", "curv2", "surf", "end", "bmat", "step", "trim", "hole", "maplib", "lod", "call", "shadow_obj", "trace_obj", "bevel", "c_interp", "d_interp", "vpn"};
    const char *at = data, *end = data + (size < SIGN_BYTES ? size : SIGN_BYTES);
    if (starts_with(at, end, "\xef\xbb\xbf"))
        at += 3;
    while (at < end) {
        while (at < end && (is_blank(*at) || is_end(*at)))
            at++;
        const char *line = at;
        while (at < end && !is_end(*at))
            at++;
        if (line == at || *line == '#')
            continue;
        size_t n = 0, k = 0;
        while (line + n < at && !is_blank(line[n]))
            n++;
        while (k < sizeof keys / sizeof *keys && !(strlen(keys[k]) == n && !memcmp(keys[k], line, n)))
            k++;
        if (k == sizeof keys / sizeof *keys)
            return false;
        if (k == 0)
            return is_place(line + n, at);
    }
    return false;
}

static const struct {
    const char *name;
    bool (*recognise)(const char *data, size_t size);
} formats[] = {{"ply", is_ply}, {"off", is_off}, {"stl", is_stl}, {"obj", is_obj}};

static const char *format_of(const char *data, size_t size)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (formats[i].recognise(data, size))
            return formats[i].name;
    return NULL;
}

bool plb_is_model(const char *data, size_t size) { return format_of(data, size) != NULL; }

/* ---- the tap ---- */

typedef struct {
    char text[TAP_MAX_ARGUMENTS][128];
    int n;
} arguments;

static void add_word(arguments *a, const char *name, const char *value)
{
    snprintf(a->text[a->n++], sizeof a->text[0], "--%s=%s", name, value);
}

static void add_numbers(arguments *a, const char *name, const double *v, int n)
{
    char one[48], two[48], both[100];
    plb_format_number(one, v[0], 9);
    snprintf(both, sizeof both, "%s%s%s", one, n > 1 ? "," : "", n > 1 ? plb_format_number(two, v[1], 9) : "");
    add_word(a, name, both);
}

static void add_look(arguments *a, const model_look *look)
{
    static const char *const ups[] = {NULL, "x", "y", "z"}, *const hidden[] = {NULL, "none", "dashed", "faint"}, *const sheets[] = {NULL, "first-angle", "third-angle"};
    if (look->has_view)
        add_numbers(a, "view", look->view, 2);
    if (look->perspective > 0)
        add_numbers(a, "perspective", &look->perspective, 1);
    if (look->crease > 0)
        add_numbers(a, "crease", &look->crease, 1);
    if (look->has_light && look->is_dark)
        add_word(a, "light", "none");
    else if (look->has_light)
        add_numbers(a, "light", look->light, 2);
    if (ups[look->up])
        add_word(a, "up", ups[look->up]);
    if (hidden[look->hidden])
        add_word(a, "hidden", hidden[look->hidden]);
    if (sheets[look->sheet])
        add_word(a, "sheet", sheets[look->sheet]);
}

bool plb_model_run_tap(const input_source *in, const char *program, const char *format, display_list *list, error *err)
{
    arguments a = {.n = 0};
    tap t = {.who = program, .argv = {program, format}};
    add_look(&a, &in->look);
    for (int i = 0; i < a.n; i++)
        t.argv[2 + i] = a.text[i];
    return plb_tap_read(in, &t, list, err);
}

bool plb_read_model(const input_source *in, display_list *list, error *err)
{
    return plb_model_run_tap(in, "tap-model", format_of(in->data, in->size), list, err);
}
