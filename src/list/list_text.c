/* SPDX-License-Identifier: MIT
 *
 * The text forms of both lists, for people and for golden tests:
 *
 *     list WIDTH HEIGHT
 *     gradient INDEX linear|radial ends|pad|repeat|reflect FROM TO OPACITY [OFFSET R G B A …]
 *     clip INDEX PARENT nonzero|evenodd PATH
 *     stroke CLIP colour R G B A width MM cap [dash ON OFF … @OFFSET] PATH
 *     fill CLIP colour R G B A nonzero|evenodd PATH
 *
 *     strokes WIDTH HEIGHT
 *     stroke IDENTITY open|closed X Y X Y …
 *
 * FROM and TO are X Y, on the page, and for radial ones a radius. Where an item's colour is a gradient that is known,
 * `gradient@INDEX` stands in place of `colour`; R G B A is then the mean.
 * PATH is M X Y, L X Y, C X Y X Y X Y, Z; millimetres with three decimals.
 */
#include "list/display_list.h"
#include "list/stroke_list.h"

#include "base/number/number.h"

static void print_number(FILE *to, double v)
{
    char text[48];
    fputc(' ', to);
    fputs(plb_format_number(text, v, 3), to);
}

static void print_point(FILE *to, point p)
{
    print_number(to, p.x);
    print_number(to, p.y);
}

static void print_path(FILE *to, const path *p)
{
    static const struct {
        char letter;
        int points;
    } form[] = {{'M', 1}, {'L', 1}, {'C', 3}, {'Z', 0}};
    size_t k = 0;
    for (size_t i = 0; i < p->ops.n; i++) {
        fprintf(to, " %c", form[p->ops.v[i]].letter);
        for (int j = 0; j < form[p->ops.v[i]].points; j++)
            print_point(to, p->points.v[k++]);
    }
    fputc('\n', to);
}

/* Where the offsets 0 and 1 are on the page; a radius in its mean size. */
static void print_ends(FILE *to, const gradient *g)
{
    matrix on_page = MATRIX_IDENTITY;
    plb_matrix_invert(g->to_space, &on_page);
    double f = plb_matrix_expansion(on_page);
    print_point(to, plb_matrix_apply(on_page, g->from));
    if (g->radial)
        print_number(to, g->from_radius * f);
    print_point(to, plb_matrix_apply(on_page, g->to));
    if (g->radial)
        print_number(to, g->to_radius * f);
}

static void print_gradient(FILE *to, size_t index, const gradient *g)
{
    static const char *const extends[] = {"ends", "pad", "repeat", "reflect"};
    fprintf(to, "gradient %zu %s %s", index, g->radial ? "radial" : "linear", extends[g->extend]);
    print_ends(to, g);
    print_number(to, g->opacity);
    for (unsigned i = 0; i < g->n; i++) {
        const gradient_stop *s = &g->stops[i];
        print_number(to, s->offset);
        print_number(to, (double)s->red);
        print_number(to, (double)s->green);
        print_number(to, (double)s->blue);
        print_number(to, (double)s->alpha);
    }
    fputc('\n', to);
}

static void print_paint(FILE *to, const item *it)
{
    static const char *const kinds[] = {"colour", "gradient", "pattern"};
    paint p = it->paint;
    fprintf(to, " %s", kinds[p.kind]);
    if (p.kind == PAINT_GRADIENT && it->gradient)
        fprintf(to, "@%u", it->gradient - 1);
    print_number(to, p.red);
    print_number(to, p.green);
    print_number(to, p.blue);
    print_number(to, p.alpha);
}

static void print_item(FILE *to, const item *it)
{
    static const char *const caps[] = {"butt", "round", "square"};
    fprintf(to, "%s %d", it->kind == ITEM_FILL ? "fill" : "stroke", it->clip);
    print_paint(to, it);
    if (it->kind == ITEM_FILL) {
        fputs(it->even_odd ? " evenodd" : " nonzero", to);
    } else {
        fputs(" width", to);
        print_number(to, it->width);
        fprintf(to, " %s", caps[it->cap]);
        for (size_t k = 0; k < it->dash.n; k++) {
            fputs(k ? "" : " dash", to);
            print_number(to, it->dash.v[k]);
        }
        if (it->dash.n) {
            fputs(" @", to);
            print_number(to, it->dash_offset);
        }
    }
    print_path(to, &it->path);
}

bool plb_list_print(const display_list *list, FILE *to)
{
    fputs("list", to);
    print_point(to, (point){list->width, list->height});
    fputc('\n', to);
    for (size_t i = 0; i < list->gradients.n; i++)
        print_gradient(to, i, &list->gradients.v[i]);
    for (size_t i = 0; i < list->clips.n; i++) {
        const clip *c = &list->clips.v[i];
        fprintf(to, "clip %zu %d %s", i, c->parent, c->even_odd ? "evenodd" : "nonzero");
        print_path(to, &c->path);
    }
    for (size_t i = 0; i < list->items.n; i++)
        print_item(to, &list->items.v[i]);
    return !ferror(to);
}

static void print_touch(FILE *to, stroke_style t)
{
    static const char *const kinds[] = {[STROKE_LINE] = "line", [STROKE_HATCH] = "hatch", [STROKE_LETTER] = "letter", [STROKE_GUIDE] = "guide"};
    fprintf(to, " %s", kinds[t.kind]);
    print_number(to, (double)t.pressure);
    fprintf(to, t.colour ? " #%06lx" : " graphite", (unsigned long)t.colour);
}

bool plb_stroke_list_print(const stroke_list *s, FILE *to)
{
    fputs("strokes", to);
    print_point(to, (point){s->width, s->height});
    fputc('\n', to);
    for (size_t i = 0; i < s->strokes.n; i++) {
        const stroke *it = &s->strokes.v[i];
        fprintf(to, "stroke %016llx %s", (unsigned long long)it->identity, it->closed ? "closed" : "open");
        print_touch(to, it->style);
        for (size_t k = 0; k < it->n; k++)
            print_point(to, s->points.v[it->first + k]);
        fputc('\n', to);
    }
    return !ferror(to);
}

void plb_stroke_list_free(stroke_list *s)
{
    array_free(&s->strokes);
    array_free(&s->points);
}

double plb_stroke_length(const stroke_list *list, const stroke *s)
{
    double sum = 0;
    for (size_t i = s->first + 1; i < s->first + s->n; i++)
        sum += plb_point_distance(list->points.v[i - 1], list->points.v[i]);
    return sum;
}
