/* SPDX-License-Identifier: MIT
 *
 * Draws the strokes band by band (render.h). All threads draw on one band at a time: they take its strokes batch by
 * batch and lay their patches on it; deposits add up to the same whatever the order.
 */
#include "api/render/render.h"

#include "api/pencil/pencils.h"
#include "api/render/bands.h"
#include "base/array.h"
#include "system/thread_team.h"
#include "base/number/units.h"

/* A thread takes so many strokes at a time, and the caller hears of progress after each batch. */
#define BATCH 16
/* A band takes at most so much memory (chosen by measurement: an A0 page at 600 dpi comes in some 20). */
#define BAND_BYTES (48 << 20)
/* A further thread pays for its start when it has so many strokes and pixels to draw. */
#define STROKES_PER_MEMBER 50
#define PIXELS_PER_MEMBER 1e6

/* A layer is a thread's pencil on the page. */
typedef struct {
    page *page;
    pigment with;
} layer;

typedef struct {
    const plb_drawing *d;
    const plb_options *o;
    stroke_options options;
    graphite soft; /* of the drawing's second pencil */
    page *page;
    const uint32_t *index; /* the band's strokes */
    size_t n, band, bands;
    layer layer[THREAD_TEAM_MAX];
    stroke_scratch scratch[THREAD_TEAM_MAX];
    error err[THREAD_TEAM_MAX];
} render_job;

static int members_for(const plb_drawing *d, const plb_options *o, double pixels)
{
    double asked = o->threads > 0 ? o->threads : plb_thread_team_processors();
    double useful = 1 + (double)d->strokes.strokes.n / STROKES_PER_MEMBER + pixels / PIXELS_PER_MEMBER;
    double n = asked < useful ? asked : useful;
    return n < THREAD_TEAM_MAX ? (int)n : THREAD_TEAM_MAX;
}

bool plb_page_plan(const plb_drawing *d, const plb_options *o, page_plan *plan, error *err)
{
    double px = o->dpi / MM_PER_INCH;
    error why = {ERROR_NONE, ""};
    if (!plb_page_size(d->list.width * px, d->list.height * px, &plan->width, &plan->height, &why))
        return plb_fail(err, why.kind, "%s: %s", d->name, why.text);
    plan->top = 0;
    plan->rows = plan->height;
    plan->planes = o->colour ? PIGMENT_PLANES : d->soft ? 2 : 1;
    plan->members = members_for(d, o, (double)plan->width * plan->height);
    return true;
}

void plb_page_plan_rows(page_plan *plan, int multiple)
{
    size_t rows = BAND_BYTES / sizeof(uint16_t) / (size_t)plan->planes / (size_t)plan->width, m = (size_t)multiple;
    rows = rows < m ? m : rows / m * m;
    plan->rows = rows < (size_t)plan->height ? (int)rows : plan->height;
}

static bool lay(void *closure, const patch *p)
{
    layer *l = closure;
    plb_page_lay(l->page, p, &l->with);
    return true;
}

static bool draw_stroke(render_job *c, int member, const stroke *s)
{
    layer *l = &c->layer[member];
    if (l->page != c->page || s->style.colour != l->with.colour)
        plb_pigment_init(&l->with, c->page->ink, s->style.colour);
    l->with.is_soft = s->style.is_soft;
    l->page = c->page;
    return plb_stroke_draw(&c->d->strokes, s, &c->options, &c->scratch[member], lay, l, &c->err[member]);
}

static bool report(const plb_options *o, double done, error *err)
{
    return plb_api_report(o, PROGRESS_PLANNED + (1 - PROGRESS_PLANNED) * done, err);
}

static bool draw_batch(void *closure, int member, size_t batch)
{
    render_job *c = closure;
    if (member == 0 && !report(c->o, ((double)c->band + (double)(batch * BATCH) / (double)c->n) / (double)c->bands, &c->err[member]))
        return false;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH && i < c->n; i++)
        if (!draw_stroke(c, member, &c->d->strokes.strokes.v[c->index[i]]))
            return false;
    return true;
}

/* Passes on the error of the first thread that failed: all fail for want of memory or because a stroke is too long. */
static bool fail(const render_job *c, error *err)
{
    for (int k = 0; k < THREAD_TEAM_MAX; k++)
        if (c->err[k].kind != ERROR_NONE)
            return plb_fail(err, c->err[k].kind, "%s: %s", c->d->name, c->err[k].text);
    return plb_fail_memory(err);
}

static bool draw_bands(render_job *c, const band_strokes *bands, int members, band_sink sink, void *closure, error *err)
{
    do {
        c->index = bands->index + bands->first[c->band];
        c->n = bands->first[c->band + 1] - bands->first[c->band];
        c->options.clip_top = c->page->top;
        c->options.clip_bottom = c->page->top + c->page->rows;
        if (!plb_thread_team_run(members, (c->n + BATCH - 1) / BATCH, draw_batch, c))
            return fail(c, err);
        if (!sink(closure, c->page, err))
            return false;
        c->band++;
    } while (plb_page_next_band(c->page));
    return report(c->o, 1, err);
}

/* Makes the drawing's second pencil ready, where it has one. */
static bool prepare_soft(render_job *c, error *err)
{
    const plb_profile *soft = c->d->soft;
    if (!soft)
        return true;
    plb_graphite_init(&c->soft, soft->p);
    c->options.soft = plb_api_pencil(soft, plb_model_at((size_t)c->o->model), (paper_kind)c->o->paper, err);
    return c->options.soft;
}

/* Makes the sheet that lies behind the graphite, where one is wanted. */
static bool make_sheet(const plb_drawing *d, const plb_options *o, ground **sheet, error *err)
{
    stroke_list strokes = plb_api_strokes_on_page(d);
    *sheet = o->background == PAGE_PAPER ? plb_ground_new(&strokes, o->seed, err) : NULL;
    return *sheet || o->background != PAGE_PAPER;
}

bool plb_render(const plb_drawing *d, const plb_options *o, const render_context *t, const page_plan *plan, band_sink sink, void *closure,
                error *err)
{
    page p = {0};
    ground *sheet = NULL;
    band_strokes bands = {0};
    render_job *c = plb_new(1, sizeof *c);
    if (!c)
        return plb_fail_memory(err);
    c->d = d;
    c->o = o;
    c->options = t->stroke;
    c->page = &p;
    bool ok = prepare_soft(c, err) && make_sheet(d, o, &sheet, err) && plb_page_init(&p, plan->width, plan->height, plan->rows, o->colour, &t->ink, d->soft ? &c->soft : NULL, err) &&
              plb_bands_init(&bands, &d->strokes, &c->options, plan->top, plan->height, plan->rows, plan->members, err);
    if (ok) {
        p.sheet = sheet;
        p.pixel = MM_PER_INCH / o->dpi;
        plb_page_start_at(&p, plan->top);
        c->bands = bands.n;
        ok = draw_bands(c, &bands, plan->members, sink, closure, err);
        for (int k = 0; k < THREAD_TEAM_MAX; k++)
            plb_stroke_scratch_free(&c->scratch[k]);
    }
    plb_free(c);
    plb_ground_free(sheet);
    plb_bands_free(&bands);
    plb_page_free(&p);
    return ok || plb_fail_memory(err);
}
