/* SPDX-License-Identifier: MIT
 *
 * Finds the strokes of each band (bands.h). A stroke goes to every band that its path, known from the arm, comes near;
 * its graphite is made again for each, which is cheaper than keeping it, as bands are high.
 */
#include "api/render/bands.h"

#include "base/array.h"
#include "system/thread_team.h"

#include <string.h>

/* A thread takes so many strokes at a time. */
#define BATCH 64

typedef struct {
    int first, last; /* bands; none when last < first */
} span;

typedef struct {
    const stroke_list *list;
    const stroke_options *o;
    int from, rows, bands; /* from: the first band's first row */
    span *spans;
    stroke_scratch scratch[THREAD_TEAM_MAX];
    error err[THREAD_TEAM_MAX];
} finder;

static bool find(finder *f, int member, size_t i)
{
    int top, bottom;
    if (!plb_stroke_rows(f->list, &f->list->strokes.v[i], f->o, &f->scratch[member], &top, &bottom, &f->err[member]))
        return false;
    top -= f->from;
    bottom -= f->from;
    int first = top < 0 ? 0 : top / f->rows, last = bottom <= 0 ? -1 : (bottom - 1) / f->rows;
    f->spans[i] = (span){first, last < f->bands ? last : f->bands - 1};
    return true;
}

static bool find_batch(void *closure, int member, size_t batch)
{
    finder *f = closure;
    size_t end = (batch + 1) * BATCH, n = f->list->strokes.n;
    for (size_t i = batch * BATCH; i < end && i < n; i++)
        if (!find(f, member, i))
            return false;
    return true;
}

/* Counts the strokes of each band, then fills in their indices in order. */
static bool sort(band_strokes *b, const span *spans, size_t n)
{
    for (size_t i = 0; i < n; i++)
        for (int k = spans[i].first; k <= spans[i].last; k++)
            b->first[k + 1]++;
    for (size_t k = 0; k < b->n; k++)
        b->first[k + 1] += b->first[k];
    b->index = plb_new(b->first[b->n] + 1, sizeof *b->index);
    size_t *next = plb_new(b->n + 1, sizeof *next);
    if (b->index && next) {
        memcpy(next, b->first, b->n * sizeof *next);
        for (size_t i = 0; i < n; i++)
            for (int k = spans[i].first; k <= spans[i].last; k++)
                b->index[next[k]++] = (uint32_t)i;
    }
    plb_free(next);
    return b->index && next;
}

bool plb_bands_init(band_strokes *b, const stroke_list *list, const stroke_options *o, int from, int height, int rows, int members, error *err)
{
    size_t n = list->strokes.n;
    *b = (band_strokes){.n = (size_t)((height - from + rows - 1) / rows)};
    b->first = plb_new(b->n + 1, sizeof *b->first);
    finder *f = plb_new(1, sizeof *f);
    span *spans = plb_new(n + 1, sizeof *spans);
    bool ok = b->first && f && spans && n <= UINT32_MAX;
    if (ok) {
        *f = (finder){.list = list, .o = o, .from = from, .rows = rows, .bands = (int)b->n, .spans = spans};
        if (b->n > 1) /* else all lie in it */
            ok = plb_thread_team_run(members, (n + BATCH - 1) / BATCH, find_batch, f);
        ok = ok && sort(b, spans, n);
        for (int k = 0; k < THREAD_TEAM_MAX; k++) {
            if (f->err[k].kind != ERROR_NONE)
                plb_fail(err, f->err[k].kind, "%s", f->err[k].text);
            plb_stroke_scratch_free(&f->scratch[k]);
        }
    }
    plb_free(f);
    plb_free(spans);
    return ok || plb_fail_memory(err);
}

void plb_bands_free(band_strokes *b)
{
    plb_free(b->first);
    plb_free(b->index);
    *b = (band_strokes){0};
}
