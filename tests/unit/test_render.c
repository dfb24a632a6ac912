/* SPDX-License-Identifier: MIT
 *
 * The page in bands and by several threads: the same pixels, the same bytes in files, however it is cut and shared out.
 */
#include "check.h"

#include "api/output/sheet.h"
#include "api/render/render.h"
#include "base/number/random.h"
#include "surface/picture/picture.h"

#define WIDTH_MM 30.0
#define HEIGHT_MM 40.0
#define STROKES 60

/* Strokes of all kinds: short, as tall as the page, off its edges, and curls that cross themselves. */
static bool fill_strokes(stroke_list *list)
{
    bool ok = true;
    for (uint64_t k = 0; ok && k < STROKES; k++) {
        size_t n = k % 4 == 3 ? 40 : 2, first = list->points.n;
        double x = 36 * random_unit(1, 10 * k) - 3, y = 46 * random_unit(1, 10 * k + 1) - 3, far = k % 5 ? 8 : 50;
        double turn = 7 * random_unit(1, 10 * k + 2);
        for (size_t i = 0; ok && i < n; i++) {
            double u = (double)i / (double)(n - 1), r = n > 2 ? 1 + 2 * u : far * u;
            point p = {x + r * cos(turn + (n > 2 ? 9 * u : 0)), y + r * sin(turn + (n > 2 ? 9 * u : 0))};
            ok = array_push(&list->points, p);
        }
        stroke_style t = {1, k % 3 == 0 ? 0xd04020 : k % 3 == 1 ? 0x2060c0 : 0, STROKE_LINE, false, 1, 0, 0, 0};
        stroke s = {.style = t, .identity = k + 1, .first = first, .n = n};
        ok = ok && array_push(&list->strokes, s);
    }
    return ok;
}

static plb_drawing *drawing_for_tests(void)
{
    static char name[] = "drawing";
    plb_drawing *d = calloc(1, sizeof *d);
    d->name = name;
    d->list.width = d->strokes.width = WIDTH_MM;
    d->list.height = d->strokes.height = HEIGHT_MM;
    CHECK(fill_strokes(&d->strokes));
    return d;
}

static void free_drawing(plb_drawing *d)
{
    plb_stroke_list_free(&d->strokes);
    free(d);
}

typedef struct {
    uint8_t *v;
    int next; /* row */
    page_background background;
    int channels;
} whole_page;

static bool take(void *closure, const page *band, error *err)
{
    whole_page *to = closure;
    (void)err;
    CHECK(band->top == to->next);
    for (int y = 0; y < band->rows; y++)
        plb_page_row(band, to->background, band->top + y, to->v + (size_t)(band->top + y) * (size_t)band->width * (size_t)to->channels);
    to->next += band->rows;
    return true;
}

static uint8_t *render(const plb_drawing *d, const plb_options *o, int rows, int members, size_t *size)
{
    render_context t;
    page_plan plan;
    error err = {ERROR_NONE, ""};
    CHECK(plb_api_context_init(&t, o, &err) && plb_page_plan(d, o, &plan, &err));
    plan.rows = rows ? rows : plan.height;
    plan.members = members;
    page_background background = (page_background)o->background;
    whole_page to = {NULL, 0, background, plb_page_channels(background, o->colour)};
    *size = (size_t)plan.width * (size_t)plan.height * (size_t)to.channels;
    to.v = malloc(*size);
    CHECK(plb_render(d, o, &t, &plan, take, &to, &err) && to.next == plan.height);
    return to.v;
}

static void bands_and_threads_change_no_pixel(void)
{
    static const double dpi[] = {60, 110, 300, 500};
    static const int rows[] = {0, 1, 37, 300}, members[] = {2, 1, 8, 3};
    plb_drawing *d = drawing_for_tests();
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < 4; k++) {
            plb_options *o = plb_options_new();
            CHECK(plb_options_set(o, "model", m ? "hla" : "graphite", NULL));
            o->dpi = dpi[k];
            o->colour = k == 1;
            o->background = k % 2 ? PAGE_TRANSPARENT : PAGE_WHITE;
            size_t size, same;
            uint8_t *whole = render(d, o, 0, 1, &size), darkest = 255;
            for (size_t i = 0; i < size; i++)
                darkest = whole[i] < darkest ? whole[i] : darkest;
            CHECK(darkest < 200);
            for (int i = 0; i < 4; i++) {
                if (rows[i] == 1 && k > 0)
                    continue; /* takes long, and says no more */
                uint8_t *cut = render(d, o, rows[i], members[i], &same);
                CHECK(same == size && !memcmp(whole, cut, size));
                free(cut);
            }
            free(whole);
            plb_options_free(o);
        }
    free_drawing(d);
}

static bool add(void *closure, const page *band, error *err)
{
    return plb_picture_add(closure, band, err);
}

/* Graphite is the same grey on the page in colour and on the one in grey, colours are colours, and a page without paper, laid over
 * white, gives the opaque one. */
static void colours_are_laid(void)
{
    plb_drawing *d = drawing_for_tests();
    plb_options *o = plb_options_new();
    size_t size, size3, size4;
    o->dpi = 150;
    uint8_t *grey = render(d, o, 0, 2, &size);
    o->colour = true;
    uint8_t *rgb = render(d, o, 0, 2, &size3);
    o->background = PAGE_TRANSPARENT;
    uint8_t *rgba = render(d, o, 0, 2, &size4);
    CHECK(size3 == 3 * size && size4 == 4 * size);
    long red = 0, blue = 0, plain = 0;
    int off = 0;
    for (size_t i = 0; i < size; i++) {
        const uint8_t *c = rgb + 3 * i, *t = rgba + 4 * i;
        red += c[0] > c[2] + 20;
        blue += c[2] > c[0] + 20;
        plain += c[0] == c[1] && c[1] == c[2] && c[0] == grey[i] && c[0] < 255;
        for (int k = 0; k < 3; k++) {
            int over = (t[k] * t[3] + 255 * (255 - t[3]) + 127) / 255, by = abs(over - c[k]);
            off = by > off ? by : off;
        }
    }
    CHECK(red > 500 && blue > 500 && plain > 500);
    CHECK(off <= 2);
    free(grey);
    free(rgb);
    free(rgba);
    plb_options_free(o);
    free_drawing(d);
}

/* The file that a page cut into bands of `pieces` pieces gives. */
static size_t write(const plb_drawing *d, const picture_format *format, int pieces, int members, char **bytes)
{
    plb_options *o = plb_options_new();
    o->dpi = 900; /* some pieces */
    size_t size = 0;
    render_context t;
    page_plan plan;
    error err = {ERROR_NONE, ""};
    FILE *to = open_memstream(bytes, &size);
    CHECK(plb_api_context_init(&t, o, &err) && plb_page_plan(d, o, &plan, &err));
    picture_page sheet = {.width = plan.width, .height = plan.height, .dpi = o->dpi, .level = 1, .members = members, .width_mm = WIDTH_MM, .height_mm = HEIGHT_MM};
    byte_sink sink = plb_sheet_stream(to);
    int rows = plb_picture_rows(format, &sheet);
    CHECK(rows * 2 < plan.height);
    plan.rows = pieces ? pieces * rows : plan.height;
    plan.members = members;
    picture *p = plb_picture_new(format, &sink, "picture", false, &err);
    CHECK(p && plb_picture_begin_page(p, &sheet, &err) && plb_render(d, o, &t, &plan, add, p, &err));
    CHECK(plb_picture_end_page(p, &err) && plb_picture_end(p, &err));
    plb_picture_free(p);
    plb_options_free(o);
    fclose(to);
    return size;
}

static void files_are_the_same(void)
{
    plb_drawing *d = drawing_for_tests();
    const picture_format *f;
    for (size_t i = 0; (f = plb_picture_format_at(i)); i++) {
        if (plb_picture_format_has_paths(f) || !plb_picture_format_is_built(f))
            continue;
        char *whole, *cut;
        size_t size = write(d, f, 0, 1, &whole);
        CHECK(size > 10000);
        for (int k = 1; k < 4; k++) {
            CHECK(write(d, f, k, k * 2, &cut) == size && !memcmp(whole, cut, size));
            free(cut);
        }
        free(whole);
    }
    free_drawing(d);
}

/* A stroke of which no bound is known stops all threads; the error is the caller's. */
static void an_error_reaches_the_caller(void)
{
    plb_drawing *d = drawing_for_tests();
    d->strokes.points.v[d->strokes.strokes.v[20].first].x = 1e9;
    plb_options *o = plb_options_new();
    o->dpi = 60;
    render_context t;
    page_plan plan;
    for (int rows = 0; rows < 2; rows++) {
        error err = {ERROR_NONE, ""};
        CHECK(plb_api_context_init(&t, o, &err) && plb_page_plan(d, o, &plan, &err));
        plan.members = 4;
        plan.rows = rows ? 20 : plan.height;
        whole_page to = {malloc((size_t)plan.width * (size_t)plan.height), 0, PAGE_WHITE, 1};
        CHECK(!plb_render(d, o, &t, &plan, take, &to, &err) && err.kind == ERROR_LIMIT && strstr(err.text, "longer"));
        free(to.v);
    }
    plb_options_free(o);
    free_drawing(d);
}

static const pencil *pencil_for(const plb_options *o)
{
    render_context t;
    CHECK(plb_api_context_init(&t, o, NULL));
    return t.pencil;
}

/* A profile's pencils are made once for each model and paper, whoever asks. */
static void pencils_are_made_once(void)
{
    plb_options *o = plb_options_new(), *other = plb_options_new();
    CHECK(plb_options_set(o, "pencil", "2H", NULL) && plb_options_set(other, "pencil", "2H", NULL));
    plb_options *rough = plb_options_copy(o), *papers_model = plb_options_copy(o);
    CHECK(plb_options_set(rough, "paper", "rough", NULL) && plb_options_set(papers_model, "model", "hla", NULL));
    const pencil *made = pencil_for(o);
    CHECK(pencil_for(o) == made && pencil_for(rough) != made && pencil_for(other) != made);
    CHECK(pencil_for(papers_model) != made && pencil_for(papers_model) == pencil_for(papers_model));
    CHECK(plb_options_set(rough, "model", "hla", NULL)); /* which knows no paper */
    CHECK(pencil_for(papers_model) == pencil_for(rough));
    plb_options_free(o);
    plb_options_free(other);
    plb_options_free(rough);
    plb_options_free(papers_model);
}

int main(void)
{
    RUN(pencils_are_made_once);
    RUN(bands_and_threads_change_no_pixel);
    RUN(colours_are_laid);
    RUN(files_are_the_same);
    RUN(an_error_reaches_the_caller);
    CHECK_EXIT;
}
