/* SPDX-License-Identifier: MIT
 *
 * Writes a film in which the drawing draws itself: stroke by stroke in the order of the plan, each at the arm's own speed, the pencil lifted and moved in
 * between. A stroke that takes several frames is drawn in each, and of its graphite only what lies between the pencil's places then and before
 * is laid; deposits add up, so the last frame is the drawing as it is written otherwise, pixel for pixel.
 * With the setting `boil` the film is a loop of several tracings of the drawing instead: each stroke has other random numbers in each, the paper is the same.
 */
#include "api/render/render.h"

#include "api/pencil/pencils.h"
#include "base/number/random.h"
#include "base/number/units.h"
#include "film/film.h"
#include "film/timing.h"

#include <math.h>
#include <string.h>

/* A way through the air takes this share of the time of a line as long (chosen by eye). */
#define LIFT_SHARE 0.6
/* Hatching is done to and fro without a look, lettering in small quick movements: in such shares of a line's time (chosen by eye: else the tones
 * of a drawing take all its time, and its lines appear at once). */
static const double hurry[] = {[STROKE_LINE] = 1, [STROKE_HATCH] = 0.1, [STROKE_LETTER] = 0.4, [STROKE_GUIDE] = 1};
/* The page of a film is in memory as a whole: so many pixels at the most. */
#define PIXELS_MAX 1e8
/* Pixels of a stroke lie no farther from its path than this, mm; only places of the path that are so near a patch are looked at. */
#define NEAR_MM 4.0

/* Further tracings stray no farther from the line that is meant, mm: who traces looks at what is there (chosen by eye). */
#define TRACING_MM 0.2

/* When a stroke is drawn, in shares of the film. */
typedef struct {
    double begin, end;
} stroke_time;

typedef struct {
    const plb_drawing *d;
    const plb_options *o;
    stroke_options options;
    page page;
    pigment with;
    graphite soft;
    ground *sheet;
    stroke_scratch scratch;
    path_samples path; /* of the stroke at hand */
    stroke_clock clock;
    stroke_time *times;
    double from, to;   /* what is laid of the stroke at hand: mm along it from where the hand starts */
    bool is_whole;
    patch part;
    ARRAY(path_sample) near;
    int top, bottom;   /* rows that have changed */
    uint8_t *pixels;
    size_t row;
    page_background background;
    film_writer *writer;
} filming;

/* ---- laying a part of a stroke ---- */

/* Gathers the samples near a patch; all, where none is. */
static bool gather(filming *f, const patch *p)
{
    double px = f->options.dpi / MM_PER_INCH, x0 = p->x / px - NEAR_MM, x1 = (p->x + p->width) / px + NEAR_MM, y0 = p->y / px - NEAR_MM, y1 = (p->y + p->height) / px + NEAR_MM;
    f->near.n = 0;
    if (!array_reserve(&f->near, f->path.n))
        return false;
    for (size_t i = 0; i < f->path.n; i++) {
        point at = f->path.v[i].at;
        if (at.x >= x0 && at.x <= x1 && at.y >= y0 && at.y <= y1)
            f->near.v[f->near.n++] = f->path.v[i];
    }
    if (f->near.n == 0) {
        memcpy(f->near.v, f->path.v, f->path.n * sizeof *f->path.v);
        f->near.n = f->path.n;
    }
    return true;
}

/* Returns when the pencil passes a place: the way it has gone then, mm. */
static double passes(const filming *f, point at)
{
    double least = INFINITY, along = 0;
    for (size_t i = 0; i < f->near.n; i++) {
        double x = f->near.v[i].at.x - at.x, y = f->near.v[i].at.y - at.y, d = x * x + y * y;
        if (d < least) {
            least = d;
            along = f->near.v[i].along;
        }
    }
    return f->path.backward ? f->path.v[f->path.n - 1].along - along : along;
}

static bool cut(filming *f, const patch *p)
{
    double mm = MM_PER_INCH / f->options.dpi;
    f->part = *p;
    if (!gather(f, p))
        return false;
    for (int y = 0; y < p->height; y++)
        for (int x = p->from[y]; x < p->to[y]; x++) {
            uint8_t *grey = &f->part.grey[y * p->width + x];
            if (*grey == 255)
                continue;
            double at = passes(f, (point){(p->x + x + 0.5) * mm, (p->y + y + 0.5) * mm});
            if (at <= f->from || at > f->to)
                *grey = 255;
        }
    return true;
}

static bool lay(void *closure, const patch *p)
{
    filming *f = closure;
    if (!f->is_whole && !cut(f, p))
        return false;
    plb_page_lay(&f->page, f->is_whole ? p : &f->part, &f->with);
    f->top = p->y < f->top ? p->y : f->top;
    f->bottom = p->y + p->height > f->bottom ? p->y + p->height : f->bottom;
    return true;
}

/* Draws of a stroke what the hand does between two shares of its time. */
static bool draw(filming *f, const stroke *s, double before, double now, error *err)
{
    f->is_whole = before <= 0 && now >= 1;
    if (!f->is_whole) {
        if (!plb_path_sample(&f->d->strokes, s, &f->options, &f->path, err))
            return false;
        if (!plb_film_clock_set(&f->clock, &f->path))
            return plb_fail_memory(err);
        f->from = before <= 0 ? -1 : plb_film_clock_along(&f->clock, &f->path, before);
        f->to = now >= 1 ? INFINITY : plb_film_clock_along(&f->clock, &f->path, now);
    }
    if (f->with.colour != s->style.colour)
        plb_pigment_init(&f->with, f->page.ink, s->style.colour);
    f->with.is_soft = s->style.is_soft;
    return plb_stroke_draw(&f->d->strokes, s, &f->options, &f->scratch, lay, f, err) || plb_fail_memory(err);
}

/* ---- when ---- */

static bool set_times(filming *f, error *err)
{
    const stroke_list *list = &f->d->strokes;
    double passed = 0, to_page = 1 / f->d->reduction;
    f->times = plb_new(list->strokes.n + 1, sizeof *f->times);
    if (!f->times)
        return plb_fail_memory(err);
    for (size_t i = 0; i < list->strokes.n; i++) {
        const stroke *s = &list->strokes.v[i], *last = i ? s - 1 : NULL;
        point start = list->points.v[s->first], pen = last ? list->points.v[last->first + last->n - 1] : start;
        double share = hurry[s->style.kind];
        passed += LIFT_SHARE * share * plb_film_time(plb_point_distance(pen, start) * to_page);
        f->times[i].begin = passed;
        passed += share * plb_film_time(plb_stroke_length(list, s) * to_page);
        f->times[i].end = passed;
    }
    for (size_t i = 0; passed > 0 && i < list->strokes.n; i++) {
        f->times[i].begin /= passed;
        f->times[i].end /= passed;
    }
    return true;
}

/* ---- frames ---- */

static bool add_frame(filming *f, unsigned duration, error *err)
{
    int top = f->top < 0 ? 0 : f->top, bottom = f->bottom < f->page.height ? f->bottom : f->page.height;
    for (int y = top; y < bottom; y++)
        plb_page_row(&f->page, f->background, y, f->pixels + (size_t)y * f->row);
    f->top = f->page.height;
    f->bottom = 0;
    return plb_film_writer_add(f->writer, f->pixels, f->row, duration, err);
}

/* Draws what happens between two moments, in shares of the film; `next` is the first stroke that is not done yet. */
static bool draw_between(filming *f, double before, double now, size_t *next, error *err)
{
    const stroke_list *list = &f->d->strokes;
    for (size_t i = *next; i < list->strokes.n && (f->times[i].begin < now || now >= 1); i++) {
        double span = f->times[i].end - f->times[i].begin;
        double a = span > 0 ? (before - f->times[i].begin) / span : 0, b = now >= 1 || span <= 0 ? 1 : (now - f->times[i].begin) / span;
        if (!draw(f, &list->strokes.v[i], a, b, err))
            return false;
        if (b >= 1)
            *next = i + 1;
    }
    return true;
}

static bool draw_frames(filming *f, error *err)
{
    int n = (int)ceil(f->o->duration * f->o->fps - 1e-9);
    n = n < 1 ? 1 : n;
    unsigned pause = (unsigned)floor(f->o->pause * f->o->fps + 0.5);
    size_t next = 0;
    f->top = 0;
    f->bottom = f->page.height;
    bool ok = add_frame(f, 1, err);
    for (int k = 1; ok && k <= n; k++) {
        double now = (double)k / n;
        ok = plb_api_report(f->o, PROGRESS_PLANNED + (1 - PROGRESS_PLANNED) * now * 0.999, err) && draw_between(f, (double)(k - 1) / n, now, &next, err) &&
             add_frame(f, k == n ? 1 + pause : 1, err);
    }
    return ok;
}

/* ---- boil ---- */

/* Takes a blank page in the place of the one at hand. */
static bool turn_page(filming *f, error *err)
{
    page old = f->page;
    plb_page_free(&f->page);
    if (!plb_page_init(&f->page, old.width, old.height, old.height, f->o->colour, old.ink, old.soft, err))
        return false;
    f->page.sheet = f->sheet;
    f->page.pixel = old.pixel;
    f->top = 0;
    f->bottom = old.height;
    return true;
}

/* Gives a stroke of tracing number `phase` its random numbers; the first tracing is the drawing itself. The second number tells them from those of further pages. */
static stroke traced(const stroke *s, int phase, double reduction)
{
    stroke again = *s;
    float most = (float)(TRACING_MM * reduction);
    if (phase > 0) {
        again.identity = random_fold(s->identity, phase, 1) | 1;
        again.max_deviation = s->max_deviation > 0 && s->max_deviation < most ? s->max_deviation : most;
    }
    return again;
}

static bool trace_frames(filming *f, error *err)
{
    const stroke_list *list = &f->d->strokes;
    for (int k = 0; k < f->o->boil; k++) {
        if (!plb_api_report(f->o, PROGRESS_PLANNED + (1 - PROGRESS_PLANNED) * 0.999 * k / f->o->boil, err) || !turn_page(f, err))
            return false;
        for (size_t i = 0; i < list->strokes.n; i++) {
            stroke s = traced(&list->strokes.v[i], k, f->d->reduction);
            if (!draw(f, &s, 0, 1, err))
                return false;
        }
        if (!add_frame(f, (unsigned)f->o->hold, err))
            return false;
    }
    return true;
}

/* ---- a film from its beginning to its end ---- */

static bool prepare(filming *f, const render_context *t, const page_plan *plan, error *err)
{
    const plb_profile *soft = f->d->soft;
    f->options = t->stroke;
    if (soft) {
        plb_graphite_init(&f->soft, soft->p);
        f->options.soft = plb_api_pencil(soft, plb_model_at((size_t)f->o->model), (paper_kind)f->o->paper, err);
        if (!f->options.soft)
            return false;
    }
    stroke_list strokes = plb_api_strokes_on_page(f->d);
    f->background = (page_background)f->o->background;
    if (f->background == PAGE_PAPER && !(f->sheet = plb_ground_new(&strokes, f->o->seed, err)))
        return false;
    if (!plb_page_init(&f->page, plan->width, plan->height, plan->height, f->o->colour, &t->ink, soft ? &f->soft : NULL, err))
        return false;
    f->page.sheet = f->sheet;
    f->page.pixel = MM_PER_INCH / f->o->dpi;
    f->options.clip_top = 0;
    f->options.clip_bottom = plan->height;
    plb_pigment_init(&f->with, f->page.ink, 0);
    f->row = (size_t)plan->width * (size_t)plb_page_channels(f->background, f->o->colour);
    f->pixels = plb_new(f->row * (size_t)plan->height, 1);
    return (f->pixels || plb_fail_memory(err)) && set_times(f, err);
}

static bool film_it(filming *f, const char *file, error *err)
{
    render_context t;
    page_plan plan;
    char software[64];
    if (!plb_api_context_for(&t, f->d, f->o, err) || !plb_page_plan(f->d, f->o, &plan, err))
        return false;
    snprintf(software, sizeof software, "Plumbago %s", plb_version());
    const char *const text[] = {"Software", software, NULL};
    film_page sheet = {.width = plan.width, .height = plan.height, .channels = plb_page_channels((page_background)f->o->background, f->o->colour), .rate = f->o->fps,
                      .loops = (unsigned)(f->o->loop >= 0 ? f->o->loop : f->o->boil == 1), .dpi = f->o->dpi, .level = f->o->compress, .members = plan.members, .is_growing = f->o->boil == 1, .text = text};
    if ((double)plan.width * plan.height > PIXELS_MAX)
        return plb_fail(err, ERROR_LIMIT, "%s: a film of %d by %d pixels is too large: lower the resolution", f->d->name, plan.width, plan.height);
    f->writer = plb_film_writer_open(file, &sheet, NULL, err);
    if (!f->writer || !prepare(f, &t, &plan, err) || !(f->o->boil > 1 ? trace_frames : draw_frames)(f, err)) {
        plb_film_writer_abort(f->writer);
        return false;
    }
    return plb_film_writer_close(f->writer, err) && plb_api_report(f->o, 1, err);
}

static void drop(filming *f)
{
    if (!f)
        return;
    plb_page_free(&f->page);
    plb_ground_free(f->sheet);
    plb_stroke_scratch_free(&f->scratch);
    array_free(&f->path);
    array_free(&f->clock.effort);
    array_free(&f->near);
    plb_free(f->times);
    plb_free(f->pixels);
    plb_free(f);
}

bool plb_drawing_write_film(const plb_drawing *d, const char *file, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_options of_call;
    filming *f = plb_new(1, sizeof *f);
    if (!f) {
        plb_fail_memory(&err);
    } else {
        f->d = d;
        f->o = plb_api_options_for(d, given, &of_call, &err);
        if (f->o)
            film_it(f, file, &err);
    }
    drop(f);
    return plb_api_finish(&err, failed);
}
