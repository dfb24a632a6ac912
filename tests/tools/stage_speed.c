/* SPDX-License-Identifier: MIT
 *
 * stage_speed FILE DPI HELPER_DIR: CPU seconds of each stage of one drawing, on one thread, as a line of CSV:
 *
 *     tap,read,plan,path,texture,lay,png
 *
 * tap: the processes that read foreign formats; read: what they say, into the display list; texture: graphite along the
 * paths; lay: mapping it and adding it to the page; png: the page as bytes, compressed. Medians of ROUNDS.
 */
#include "api/render/render.h"
#include "base/number/units.h"
#include "input/input.h"
#include "api/output/sheet.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

#define ROUNDS 5
enum { TAP, READ, PLAN, PATH, TEXTURE, LAY, COMPRESS, STAGES };

static double used(int who)
{
    struct rusage u;
    getrusage(who, &u);
    return (double)(u.ru_utime.tv_sec + u.ru_stime.tv_sec) + 1e-6 * (double)(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static double time_reading(const char *file, const plb_options *o)
{
    input_source in = {.name = file, .helper_dir = o->helper_dir, .page = 1};
    in.limits = PROCESS_LIMITS;
    char *data = NULL;
    display_list list;
    plb_list_init(&list);
    double start = now();
    bool ok = plb_input_load(file, &data, &in.size, NULL);
    in.data = data;
    ok = ok && plb_input_read(&in, &list, NULL);
    double passed = now() - start;
    plb_list_free(&list);
    plb_free(data);
    return ok ? passed : 0;
}

static bool ignore_patch(void *closure, const patch *p)
{
    return (void)closure, (void)p, true;
}

static void plain(const void *texture, const sample_row *rows, int n, uint8_t *out)
{
    (void)texture;
    for (const sample_row *at = rows; at < rows + n; out += at++->n)
        memset(out, 100, (size_t)at->n);
}

typedef struct {
    picture *to;
    double seconds;
} writer;

static bool write_band(void *closure, const page *band, error *err)
{
    writer *w = closure;
    double start = now();
    bool ok = plb_picture_add(w->to, band, err);
    w->seconds += now() - start;
    return ok;
}

/* Without texture: the arm, and the arm and the mapping of an even darkness. */
static void time_strokes(const plb_drawing *d, const render_context *t, double *arm, double *map)
{
    stroke_scratch scratch = {0};
    shading texture = {.shade = plain, .whole_pixels = true, .half_width = 9.5, .dpi = PAPER_PX_PER_INCH};
    map_page rows = {.dpi = t->stroke.dpi};
    for (int with_map = 0; with_map < 2; with_map++) {
        double start = now();
        for (size_t i = 0; i < d->strokes.strokes.n; i++) {
            plb_path_sample(&d->strokes, &d->strokes.strokes.v[i], &t->stroke, &scratch.path, NULL);
            if (with_map && scratch.path.n > 1)
                plb_strip_map(&texture, &rows, &scratch.path, scratch.path.closed, &scratch.map, ignore_patch, NULL);
        }
        *(with_map ? map : arm) = now() - start;
    }
    plb_stroke_scratch_free(&scratch);
}

static double time_texture(const plb_drawing *d, const render_context *t)
{
    stroke_scratch scratch = {0};
    double start = now();
    for (size_t i = 0; i < d->strokes.strokes.n; i++)
        plb_stroke_draw(&d->strokes, &d->strokes.strokes.v[i], &t->stroke, &scratch, ignore_patch, NULL, NULL);
    double passed = now() - start;
    plb_stroke_scratch_free(&scratch);
    return passed;
}

static bool time_drawing(const plb_drawing *d, const plb_options *o, double out[STAGES])
{
    render_context t;
    page_plan plan;
    FILE *null = fopen("/dev/null", "wb");
    if (!null || !plb_api_context_init(&t, o, NULL) || !plb_page_plan(d, o, &plan, NULL))
        return false;
    plan.members = 1;
    const picture_format *png = plb_picture_format_named("png");
    picture_page sheet = {.width = plan.width, .height = plan.height, .dpi = o->dpi, .level = 1, .members = 1};
    byte_sink sink = plb_sheet_stream(null);
    plb_page_plan_rows(&plan, plb_picture_rows(png, &sheet));
    writer w = {plb_picture_new(png, &sink, "null", false, NULL), 0};
    double map, texture = time_texture(d, &t), start = now();
    bool ok = w.to && plb_picture_begin_page(w.to, &sheet, NULL) && plb_render(d, o, &t, &plan, write_band, &w, NULL);
    ok = ok && plb_picture_end_page(w.to, NULL) && plb_picture_end(w.to, NULL);
    double all = now() - start;
    time_strokes(d, &t, &out[PATH], &map);
    out[TEXTURE] = texture - map;
    out[LAY] = all - w.seconds - texture + map - out[PATH];
    out[COMPRESS] = w.seconds;
    plb_picture_free(w.to);
    fclose(null);
    return ok;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

int main(int argc, char **argv)
{
    plb_options *o = plb_options_new();
    double all[STAGES][ROUNDS];
    if (argc != 4 || !o || !plb_options_set(o, "dpi", argv[2], NULL) || !plb_options_set(o, "helper-dir", argv[3], NULL) || !plb_options_set(o, "threads", "1", NULL)) {
        fprintf(stderr, "usage: stage_speed FILE DPI HELPER_DIR\n");
        return 2;
    }
    for (int r = 0; r < ROUNDS; r++) {
        double out[STAGES], children = used(RUSAGE_CHILDREN), start = now();
        plb_error e = {PLB_OK, ""};
        plb_drawing *d = plb_drawing_load(argv[1], o, &e);
        double loading = now() - start;
        out[TAP] = used(RUSAGE_CHILDREN) - children;
        out[READ] = time_reading(argv[1], o);
        out[PLAN] = loading - out[READ];
        if (!d || !time_drawing(d, o, out)) {
            fprintf(stderr, "stage_speed: %s\n", e.text);
            return 1;
        }
        plb_drawing_free(d);
        for (int k = 0; k < STAGES; k++)
            all[k][r] = out[k];
    }
    for (int k = 0; k < STAGES; k++) {
        qsort(all[k], ROUNDS, sizeof *all[k], ascending);
        printf("%s%.4f", k ? "," : "", all[k][ROUNDS / 2]);
    }
    printf("\n");
    return 0;
}
