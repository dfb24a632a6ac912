/* SPDX-License-Identifier: MIT
 *
 * core_speed [DPI [STROKES [PENCIL]]]: how many strokes of 13 mm (157 px at 300 dpi) one core draws in a second, how the
 * time is shared by the stages, and how far that is from the cost of writing the strokes' pixels once, measured in the
 * same run. Times are CPU time of this thread; the best of three rounds counts.
 */
#include "api/pipeline.h"
#include "base/number/random.h"
#include "base/number/units.h"
#include "surface/page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define STROKE_MM 13.0
#define SIDE_MM 200.0
#define ROUNDS 3

typedef struct {
    stroke_list list;
    render_context tools;
    stroke_scratch scratch;
    page page;
    long patches, pixels, marked; /* handed out: patches, their pixels, those with graphite */
} bench;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static bool throw_away(void *closure, const patch *p)
{
    return (void)closure, (void)p, true;
}

static bool count(void *closure, const patch *p)
{
    bench *b = closure;
    b->patches++;
    b->pixels += p->width * p->height;
    for (int i = 0; i < p->width * p->height; i++)
        b->marked += p->grey[i] < 255;
    return true;
}

static bool lay(void *closure, const patch *p)
{
    plb_page_lay(&((bench *)closure)->page, p, NULL);
    return true;
}

static void plain(const void *texture, const sample_row *rows, int n, uint8_t *out)
{
    (void)texture;
    for (const sample_row *at = rows; at < rows + n; out += at++->n)
        memset(out, 100, (size_t)at->n);
}

/* ---- the stages, each with all before it ---- */

static bool trace(bench *b, const stroke *s)
{
    return plb_path_sample(&b->list, s, &b->tools.stroke, &b->scratch.path, NULL);
}

static bool map(bench *b, const stroke *s)
{
    shading texture = {.shade = plain, .whole_pixels = true, .half_width = 9.5, .dpi = PAPER_PX_PER_INCH}; /* as wide as the usual pencils */
    map_page rows = {.dpi = b->tools.stroke.dpi};
    return trace(b, s) && plb_strip_map(&texture, &rows, &b->scratch.path, false, &b->scratch.map, throw_away, NULL);
}

static bool draw_to(bench *b, const stroke *s, patch_sink sink)
{
    return plb_stroke_draw(&b->list, s, &b->tools.stroke, &b->scratch, sink, b, NULL);
}
static bool texture(bench *b, const stroke *s) { return draw_to(b, s, throw_away); }
static bool measure(bench *b, const stroke *s) { return draw_to(b, s, count); }
static bool all(bench *b, const stroke *s) { return draw_to(b, s, lay); }

/* Seconds a stroke. */
static double time_of(bench *b, bool (*stage)(bench *, const stroke *))
{
    double best = HUGE_VAL;
    for (int r = 0; r < ROUNDS; r++) {
        double start = now();
        for (size_t i = 0; i < b->list.strokes.n; i++)
            if (!stage(b, &b->list.strokes.v[i]))
                exit(1);
        best = fmin(best, now() - start);
    }
    return best / (double)b->list.strokes.n;
}

/* Seconds for writing so many pixels of the page, two bytes each, once, over memory that no cache holds. */
static double time_of_writing(double pixels)
{
    size_t size = (size_t)256 << 20;
    char *v = malloc(size);
    unsigned sum = 0;
    double best = HUGE_VAL;
    for (int r = 0; v && r < ROUNDS + 1; r++) {
        double start = now();
        memset(v, r, size);
        sum += (unsigned)v[(size_t)rand() % size]; /* so that it is really done */
        best = r ? fmin(best, now() - start) : best; /* the first round asks the system for the memory */
    }
    free(v);
    return sum == 12345 ? 0 : best / (double)size * pixels * 2;
}

static bool prepare(bench *b, double dpi, size_t n, const char *grade)
{
    plb_options *o = plb_options_new(); /* until the program ends: its pencil draws */
    bool ok = o && plb_options_set(o, "pencil", grade, NULL) && plb_options_set_number(o, "dpi", dpi, NULL) && plb_api_context_init(&b->tools, o, NULL);
    int side = (int)(SIDE_MM / MM_PER_INCH * dpi);
    ok = ok && plb_page_init(&b->page, side, side, side, false, &b->tools.ink, NULL, NULL);
    for (uint64_t k = 0; ok && k < n; k++) {
        double turn = 2 * PLB_PI * random_unit(1, 3 * k), x = SIDE_MM * random_unit(1, 3 * k + 1), y = SIDE_MM * random_unit(1, 3 * k + 2);
        stroke s = {.style = STROKE_STYLE_USUAL, .identity = k + 1, .first = b->list.points.n, .n = 2};
        point from = {x, y}, to = {x + STROKE_MM * cos(turn), y + STROKE_MM * sin(turn)};
        ok = array_push(&b->list.points, from) && array_push(&b->list.points, to) && array_push(&b->list.strokes, s);
    }
    return ok;
}

int main(int argc, char **argv)
{
    static bench b;
    double dpi = argc > 1 ? atof(argv[1]) : 300, n = argc > 2 ? atof(argv[2]) : 10000;
    if (!(dpi >= 10 && n >= 1) || !prepare(&b, dpi, (size_t)n, argc > 3 ? argv[3] : "HB")) {
        fprintf(stderr, "usage: core_speed [DPI [STROKES [PENCIL]]]\n");
        return 2;
    }
    double to_path = time_of(&b, trace), to_map = time_of(&b, map), to_texture = time_of(&b, texture), to_all = time_of(&b, all);
    time_of(&b, measure);
    double strokes = n * ROUNDS, marked = (double)b.marked / strokes, bound = time_of_writing(marked);
    printf("%.0f strokes of %g mm at %g dpi, on one core\n", n, STROKE_MM, dpi);
    printf("stroke %.2f us: %.0f strokes/s\n", to_all * 1e6, 1 / to_all);
    printf("path %.2f us, mapping %.2f us, texture %.2f us, laying %.2f us\n", to_path * 1e6, (to_map - to_path) * 1e6,
           (to_texture - to_map) * 1e6, (to_all - to_texture) * 1e6);
    printf("patches %.1f, their pixels %.0f, with graphite %.0f\n", (double)b.patches / strokes, (double)b.pixels / strokes, marked);
    printf("writing those once %.2f us: the stroke takes %.1f times as long\n", bound * 1e6, to_all / bound);
    plb_stroke_list_free(&b.list);
    plb_stroke_scratch_free(&b.scratch);
    plb_page_free(&b.page);
    return 0;
}
