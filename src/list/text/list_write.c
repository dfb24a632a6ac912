/* SPDX-License-Identifier: MIT
 *
 * See list_write.h. Numbers are written shortest, so that they are read back bit for bit.
 */
#include "list/text/list_write.h"

#include "base/number/number.h"
#include "list/text/list_words.h"

#include <string.h>

/* No word or number is longer than this. */
#define PIECE_MAX 64

static void flush(list_writer *w)
{
    if (w->n && !w->failed)
        w->failed = !w->put(w->closure, w->buffer, w->n);
    w->n = 0;
}

/* Returns the place where a piece of that size can be written. */
static char *room_for_piece(list_writer *w)
{
    if (w->n > LIST_WRITER_BYTES - PIECE_MAX)
        flush(w);
    return w->buffer + w->n;
}

static void put_character(list_writer *w, char c)
{
    *room_for_piece(w) = c;
    w->n++;
}

/* Writes a text of at most PIECE_MAX bytes. */
static void put_bytes(list_writer *w, const char *text)
{
    size_t n = strlen(text);
    memcpy(room_for_piece(w), text, n);
    w->n += n;
}

static void put_word(list_writer *w, const char *word)
{
    put_character(w, ' ');
    put_bytes(w, word);
}

static void put_number(list_writer *w, double v)
{
    char *to = room_for_piece(w);
    *to = ' ';
    w->n += 1 + plb_write_number(to + 1, v);
}

static void put_point(list_writer *w, point p)
{
    put_number(w, p.x);
    put_number(w, p.y);
}

static void put_matrix(list_writer *w, matrix m)
{
    const double all[] = {m.xx, m.yx, m.xy, m.yy, m.x0, m.y0};
    for (int i = 0; i < 6; i++)
        put_number(w, all[i]);
}

/* Writes a text for people, on one line. */
static void put_text(list_writer *w, const char *text)
{
    put_character(w, ' ');
    for (; *text; text++)
        put_character(w, (unsigned char)*text < ' ' || *text == 127 ? ' ' : *text);
}

static void put_path(list_writer *w, const path *p)
{
    static const char letters[] = "MLCZ";
    static const unsigned char points[] = {1, 1, 3, 0};
    const point *at = p->points.v;
    for (size_t i = 0; i < p->ops.n; i++) {
        path_op op = p->ops.v[i];
        put_character(w, ' ');
        put_character(w, letters[op]);
        for (unsigned k = 0; k < points[op]; k++)
            put_point(w, *at++);
    }
    put_character(w, '\n');
}

void plb_list_writer_init(list_writer *w, list_put put, void *closure)
{
    w->put = put;
    w->closure = closure;
    w->failed = false;
    w->n = 0;
    put_bytes(w, LIST_FIRST_WORD " " LIST_VERSION "\n");
}

void plb_list_writer_page(list_writer *w, double width, double height)
{
    put_bytes(w, "page");
    put_point(w, (point){width, height});
    put_character(w, '\n');
}

void plb_list_writer_pages(list_writer *w, unsigned long pages)
{
    put_bytes(w, "pages");
    put_number(w, (double)pages);
    put_character(w, '\n');
}

void plb_list_writer_scale(list_writer *w, double scale)
{
    put_bytes(w, "scale");
    put_number(w, scale);
    put_character(w, '\n');
}

void plb_list_writer_matrix(list_writer *w, matrix m)
{
    put_bytes(w, "matrix");
    put_matrix(w, m);
    put_character(w, '\n');
}

void plb_list_writer_omission(list_writer *w, omission_kind kind, unsigned long n, const char *advice)
{
    put_bytes(w, "omit");
    put_word(w, plb_omission_name(kind));
    put_number(w, (double)n);
    if (advice && *advice)
        put_text(w, advice);
    put_character(w, '\n');
}

void plb_list_writer_message(list_writer *w, message_level level, const char *text)
{
    put_bytes(w, level == MESSAGE_WARNING ? "warning" : "detail");
    put_text(w, text);
    put_character(w, '\n');
}

void plb_list_writer_gradient(list_writer *w, const gradient *g)
{
    put_bytes(w, "gradient");
    put_word(w, plb_list_shapes[g->radial]);
    put_word(w, plb_list_extends[g->extend]);
    put_number(w, g->opacity);
    put_matrix(w, g->to_space);
    put_point(w, g->from);
    if (g->radial)
        put_number(w, g->from_radius);
    put_point(w, g->to);
    if (g->radial)
        put_number(w, g->to_radius);
    for (unsigned i = 0; i < g->n; i++) {
        const gradient_stop *s = &g->stops[i];
        const double all[] = {s->offset, (double)s->red, (double)s->green, (double)s->blue, (double)s->alpha};
        for (int k = 0; k < 5; k++)
            put_number(w, all[k]);
    }
    put_character(w, '\n');
}

static void put_clip_number(list_writer *w, int index)
{
    if (index == NO_CLIP)
        put_word(w, "-");
    else
        put_number(w, index);
}

void plb_list_writer_clip(list_writer *w, const clip *c)
{
    put_bytes(w, "clip");
    put_clip_number(w, c->parent);
    put_word(w, plb_list_rules[c->even_odd]);
    put_path(w, &c->path);
}

static void put_paint(list_writer *w, const item *it)
{
    const double all[] = {it->paint.red, it->paint.green, it->paint.blue, it->paint.alpha};
    put_word(w, plb_list_paints[it->paint.kind]);
    if (it->paint.kind == PAINT_GRADIENT && it->gradient) {
        char *at = room_for_piece(w);
        *at = '@';
        w->n += 1 + plb_write_number(at + 1, it->gradient - 1);
    }
    for (int i = 0; i < 4; i++)
        put_number(w, all[i]);
}

/* Writes U+66+69 for a ligature of two letters. */
static void put_character_codes(list_writer *w, const character *c)
{
    static const char digits[] = "0123456789abcdef";
    put_word(w, LIST_CHARACTER);
    for (int i = 0; i < CHARACTER_MAX_CODES && c->code[i]; i++) {
        bool begun = false;
        if (i)
            put_character(w, '+');
        for (int shift = 28; shift >= 0; shift -= 4) {
            unsigned digit = c->code[i] >> shift & 15;
            begun = begun || digit || !shift;
            if (begun)
                put_character(w, digits[digit]);
        }
    }
}

static void put_what_it_says(list_writer *w, const text_run *t)
{
    put_word(w, LIST_TEXT);
    put_number(w, t->em);
    put_number(w, t->degrees);
    for (size_t i = 0; i < t->characters.n; i++) {
        put_character_codes(w, &t->characters.v[i]);
        put_number(w, t->characters.v[i].subpaths);
        put_point(w, t->characters.v[i].at);
    }
}

static void put_pen(list_writer *w, const item *it)
{
    put_word(w, "width");
    put_number(w, it->width);
    put_word(w, plb_list_caps[it->cap]);
    if (!it->dash.n)
        return;
    put_word(w, "dash");
    for (size_t i = 0; i < it->dash.n; i++)
        put_number(w, it->dash.v[i]);
    put_word(w, "@");
    put_number(w, it->dash_offset);
}

void plb_list_writer_item(list_writer *w, const item *it)
{
    put_bytes(w, it->kind == ITEM_FILL ? "fill" : "stroke");
    put_clip_number(w, it->clip);
    put_paint(w, it);
    if (it->kind == ITEM_FILL)
        put_word(w, plb_list_rules[it->even_odd]);
    else
        put_pen(w, it);
    if (it->kind == ITEM_FILL && it->is_directed) {
        put_word(w, LIST_HATCH);
        put_number(w, it->direction);
    }
    if (it->text && it->text->characters.n)
        put_what_it_says(w, it->text);
    put_path(w, &it->path);
}

bool plb_list_writer_end(list_writer *w)
{
    put_bytes(w, "end\n");
    flush(w);
    return !w->failed;
}

bool plb_list_write(const display_list *list, list_put put, void *closure)
{
    list_writer w;
    plb_list_writer_init(&w, put, closure);
    plb_list_writer_page(&w, list->width, list->height);
    if (list->paper_scale != 1)
        plb_list_writer_scale(&w, list->paper_scale);
    for (int kind = 0; kind < OMISSION_KINDS; kind++)
        if (list->omissions.n[kind])
            plb_list_writer_omission(&w, (omission_kind)kind, list->omissions.n[kind], list->omissions.advice);
    for (size_t i = 0; i < list->gradients.n; i++)
        plb_list_writer_gradient(&w, &list->gradients.v[i]);
    for (size_t i = 0; i < list->clips.n; i++)
        plb_list_writer_clip(&w, &list->clips.v[i]);
    for (size_t i = 0; i < list->items.n; i++)
        plb_list_writer_item(&w, &list->items.v[i]);
    return plb_list_writer_end(&w);
}

static bool put_in_file(void *closure, const char *data, size_t n)
{
    return fwrite(data, 1, n, closure) == n;
}

bool plb_list_print(const display_list *list, FILE *to)
{
    return plb_list_write(list, put_in_file, to) && !ferror(to);
}
