/* SPDX-License-Identifier: MIT
 *
 * Reads the structuring comments of PostScript files: a search through the lines that start with %%, aware of documents
 * within the document. What they say is checked before it is believed.
 */
#include "tap/ps/ps_dsc.h"

#include "tap/ps/postscript.h"

#include "base/number/number.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static uint32_t little_endian(const char *p)
{
    const unsigned char *u = (const unsigned char *)p;
    return u[0] | (uint32_t)u[1] << 8 | (uint32_t)u[2] << 16 | (uint32_t)u[3] << 24;
}

void plb_ps_find_program(const char *data, size_t size, const char **program, size_t *length)
{
    *program = data;
    *length = size;
    if (size >= 30 && !memcmp(data, "\xc5\xd0\xd3\xc6", 4)) {
        size_t at = little_endian(data + 4), n = little_endian(data + 8);
        if (at > size)
            at = size;
        *program = data + at;
        *length = n < size - at ? n : size - at;
        return;
    }
    if (size > 1 && (data[0] == 27 || data[0] == '@')) /* a printer's job header */
        for (size_t i = 0; i + 2 < size && i < 4096; i++)
            if (!memcmp(data + i, "%!", 2)) {
                *program = data + i;
                *length = size - i;
                return;
            }
}

/* Reads one line after the other; false at the end. */
static bool next_line(const char **at, const char *end, const char **line, size_t *n)
{
    if (*at >= end)
        return false;
    const char *p = *at;
    while (p < end && *p != '\n' && *p != '\r')
        p++;
    *line = *at;
    *n = (size_t)(p - *at);
    *at = p < end ? p + 1 : p;
    return true;
}

/* Gives the text after `key` at the start of a line; NULL: another line. */
static const char *value_of(const char *line, size_t n, const char *key)
{
    size_t k = strlen(key);
    return n >= k && !memcmp(line, key, k) ? line + k : NULL;
}

static const char *skip_blanks(const char *p, const char *end)
{
    while (p < end && (*p == ' ' || *p == '\t'))
        p++;
    return p;
}

static int read_numbers(const char *p, const char *end, double *out, int n)
{
    int got = 0;
    while (got < n && plb_parse_number(skip_blanks(p, end), end, &out[got], &p))
        got++;
    return got;
}

static bool is_sane(box b, double largest)
{
    return b.x1 > b.x0 && b.y1 > b.y0 && b.x1 - b.x0 <= largest && b.y1 - b.y0 <= largest && b.x0 >= -largest &&
           b.y0 >= -largest && b.x1 <= 2 * largest && b.y1 <= 2 * largest;
}

/* Reads a box from a line; `(atend)` asks for the last one of the file, else the first one counts. */
typedef struct {
    bool found, at_end;
    double v[4];
} box_comment;

static void read_box(box_comment *b, const char *value, const char *end)
{
    double v[4];
    value = skip_blanks(value, end);
    if (value < end && *value == '(') {
        b->at_end = true;
        return;
    }
    if ((b->found && !b->at_end) || read_numbers(value, end, v, 4) != 4)
        return;
    b->found = true;
    memcpy(b->v, v, sizeof v);
}

static void read_media(ps_dsc *out, const char *p, const char *end, double largest)
{
    double v[2];
    p = skip_blanks(p, end);
    while (p < end && *p != ' ' && *p != '\t') /* its name */
        p++;
    if (out->has_media || read_numbers(p, end, v, 2) != 2 || !is_sane((box){0, 0, v[0], v[1]}, largest))
        return;
    out->has_media = true;
    out->media_width = v[0];
    out->media_height = v[1];
}

static box as_box(const double v[4])
{
    return (box){v[0], v[1], v[2], v[3]};
}

static void settle_box(const box_comment *plain, const box_comment *fine, double largest, ps_dsc *out)
{
    box b = as_box(plain->v), h = as_box(fine->v);
    out->has_box = plain->found || fine->found;
    out->box = plain->found ? b : h;
    out->box_sane = out->has_box && is_sane(out->box, largest);
    bool agrees = h.x0 >= b.x0 - 1.5 && h.y0 >= b.y0 - 1.5 && h.x1 <= b.x1 + 1.5 && h.y1 <= b.y1 + 1.5;
    if (out->box_sane && plain->found && fine->found && agrees && is_sane(h, largest))
        out->box = h;
}

void plb_dsc_read(const char *program, size_t length, double largest, ps_dsc *out)
{
    const char *at = program, *end = program + length, *line, *value;
    box_comment plain = {0}, fine = {0};
    size_t n;
    int depth = 0;
    *out = (ps_dsc){0};
    for (bool first = true; next_line(&at, end, &line, &n); first = false) {
        const char *stop = line + n;
        if (first && value_of(line, n, "%!PS-Adobe"))
            for (size_t i = 0; i + 4 <= n; i++)
                out->is_eps |= !memcmp(line + i, "EPSF", 4);
        if (n < 8 || line[0] != '%' || line[1] != '%')
            continue;
        if (value_of(line, n, "%%BeginDocument"))
            depth++;
        else if (value_of(line, n, "%%EndDocument") && depth)
            depth--;
        if (depth)
            continue;
        if ((value = value_of(line, n, "%%BoundingBox:")) != NULL)
            read_box(&plain, value, stop);
        else if ((value = value_of(line, n, "%%HiResBoundingBox:")) != NULL)
            read_box(&fine, value, stop);
        else if ((value = value_of(line, n, "%%DocumentMedia:")) != NULL)
            read_media(out, value, stop, largest);
        else if ((value = value_of(line, n, "%%Pages:")) != NULL) {
            double pages;
            if (read_numbers(value, stop, &pages, 1) == 1 && pages >= 0 && pages < 1e6)
                out->pages = (int)pages;
        }
    }
    settle_box(&plain, &fine, largest, out);
}
