/* SPDX-License-Identifier: MIT
 *
 * This file keeps the stroke list and writes its text form for people and for golden tests:
 *
 *     strokes WIDTH HEIGHT
 *     stroke IDENTITY open|closed KIND PRESSURE graphite|soft|COLOUR X Y X Y …
 *
 * in millimetres with three decimals.
 */
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

static void print_touch(FILE *to, stroke_style t)
{
    static const char *const kinds[] = {[STROKE_LINE] = "line", [STROKE_HATCH] = "hatch", [STROKE_LETTER] = "letter", [STROKE_GUIDE] = "guide"};
    fprintf(to, " %s", kinds[t.kind]);
    print_number(to, (double)t.pressure);
    fprintf(to, t.colour ? " #%06lx" : t.is_soft ? " soft" : " graphite", (unsigned long)t.colour);
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
