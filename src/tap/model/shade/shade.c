/* SPDX-License-Identifier: MIT
 *
 * See shade.h. Each cell gets a tone by the light on the surface that is seen there; cells of one surface and one tone are a region.
 */
#include "tap/model/shade/shade.h"

#include "base/number/random.h"

/* Tones that a hand tells apart: darknesses, from blank paper on, and from which darkness on each is taken (chosen by eye). */
#define TONES 5
static const double tone_darkness[TONES] = {0, .11, .2, .29, .38};
static const double tone_from[TONES] = {-1, .11, .21, .32, .45};
/* A surface turned away from the light is as dark as this (chosen by eye: lines must stand out from it). */
#define DARKEST 0.66
/* A material's own darkness counts so much: light makes the form, and black things are drawn grey (chosen by eye). */
#define LOCAL_TONE 0.45f
#define DIMMEST 0.05f

typedef struct {
    uint32_t patch, paint, tone;
} region_key;

typedef struct {
    const view *v;
    const surface_buffer *b;
    vector to_light; /* in the model's space, length 1 */
    float brightest; /* of the materials */
    uint32_t *table;  /* numbers of regions, by their keys */
    size_t room;
    ARRAY(region_key) regions;
} shader;

/* The light moves with the eye: it comes over the left shoulder wherever one looks from. */
static vector direction_to_light(const view *v, light from)
{
    double a = from.azimuth * PLB_PI / 180, e = from.elevation * PLB_PI / 180;
    vector level = vector_cross(v->right, (vector){0, 0, 1}); /* on the ground, towards the eye */
    vector d = vector_add(vector_scale(v->right, sin(a) * cos(e)), vector_scale(level, cos(a) * cos(e)));
    return vector_add(d, (vector){0, 0, sin(e)});
}

/* Gives the normal of the surface at a place of the triangle, towards the eye. */
static vector normal_at(const view *v, uint32_t t, point at)
{
    const mesh *m = v->m;
    vector a = view_corner(v, t, 0), b = view_corner(v, t, 1), c = view_corner(v, t, 2);
    double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    double wb = area != 0 ? ((at.x - a.x) * (c.y - a.y) - (at.y - a.y) * (c.x - a.x)) / area : 0;
    double wc = area != 0 ? ((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / area : 0;
    const uint32_t *g = m->group.v + 3 * (size_t)t;
    vector n = vector_scale(m->smooth.v[g[0]], 1 - wb - wc);
    n = vector_add(n, vector_add(vector_scale(m->smooth.v[g[1]], wb), vector_scale(m->smooth.v[g[2]], wc)));
    bool is_away = (m->is_turned.v[t] != 0) == (v->is_front.v[t] != 0);
    return vector_unit(is_away ? vector_scale(n, -1) : n);
}

static uint32_t tone_of(const shader *s, uint32_t t, point at)
{
    double towards = vector_dot(normal_at(s->v, t, at), s->to_light); /* -1 to 1 */
    double darkness = DARKEST * (1 - towards) / 2;
    uint32_t tone = 0;
    while (tone + 1 < TONES && darkness >= tone_from[tone + 1])
        tone++;
    return tone;
}

static bool is_same(region_key a, region_key b) { return a.patch == b.patch && a.paint == b.paint && a.tone == b.tone; }

static size_t find_slot(const shader *s, const uint32_t *table, size_t room, region_key k)
{
    size_t i = random_fold(k.patch, k.paint, k.tone) & (room - 1);
    while (table[i] != NO_TRIANGLE && !is_same(s->regions.v[table[i]], k))
        i = (i + 1) & (room - 1);
    return i;
}

static bool grow_table(shader *s)
{
    size_t room = s->room ? 2 * s->room : 256;
    uint32_t *table = plb_new(room, sizeof *table);
    if (!table)
        return false;
    for (size_t i = 0; i < room; i++)
        table[i] = NO_TRIANGLE;
    for (uint32_t i = 0; i < s->regions.n; i++)
        table[find_slot(s, table, room, s->regions.v[i])] = i;
    plb_free(s->table);
    s->table = table;
    s->room = room;
    return true;
}

static bool region_of(shader *s, region_key k, uint32_t *number)
{
    if (2 * s->regions.n >= s->room && !grow_table(s))
        return false;
    size_t i = find_slot(s, s->table, s->room, k);
    *number = s->table[i];
    if (*number != NO_TRIANGLE)
        return true;
    *number = s->table[i] = (uint32_t)s->regions.n;
    return array_push(&s->regions, k);
}

/* Labels the cells with their regions. */
static bool label_cells(shader *s, uint32_t *label)
{
    const surface_buffer *b = s->b;
    region_key last = {NO_TRIANGLE, 0, 0};
    uint32_t number = 0;
    for (int y = 0; y < b->height; y++)
        for (int x = 0; x < b->width; x++) {
            size_t i = (size_t)y * (size_t)b->width + (size_t)x;
            uint32_t t = b->triangle[i];
            label[i] = UINT32_MAX;
            if (t == NO_TRIANGLE)
                continue;
            point at = {b->corner.x + (x + .5) * b->cell, b->corner.y + (y + .5) * b->cell};
            region_key k = {s->v->m->patch.v[t], s->v->m->triangles.v[t].paint, tone_of(s, t, at)};
            if (!is_same(k, last) && !region_of(s, k, &number))
                return false;
            last = k;
            label[i] = number;
        }
    return true;
}

static float brightness(colour c) { return .299f * c.red + .587f * c.green + .114f * c.blue; } /* Rec. 601 */

/* The brightest material on the model is paper. */
static float brightest_of(const mesh *m)
{
    float most = 0;
    for (size_t i = 0; i < m->triangles.n; i++) {
        float b = brightness(m->paints.v[m->triangles.v[i].paint].colour);
        most = b > most ? b : most;
    }
    return most > DIMMEST ? most : DIMMEST;
}

static float on_paper(float part, float brightest, float left)
{
    float p = part / brightest;
    return (1 - LOCAL_TONE * (1 - (p < 1 ? p : 1))) * left;
}

/* The colour on paper: the material's, as far as a drawing shows it, in the light that there is. */
static colour colour_of(const shader *s, region_key k)
{
    colour c = s->v->m->paints.v[k.paint].colour;
    float left = (float)(1 - tone_darkness[k.tone]);
    return (colour){on_paper(c.red, s->brightest, left), on_paper(c.green, s->brightest, left), on_paper(c.blue, s->brightest, left)};
}

bool plb_shade(const view *v, const surface_buffer *b, light from, tone_list *out, error *err)
{
    shader s = {.v = v, .b = b, .to_light = direction_to_light(v, from), .brightest = brightest_of(v->m)};
    uint32_t *label = plb_new((size_t)b->width * (size_t)b->height, sizeof *label);
    bool ok = label && label_cells(&s, label);
    tone_loop *loops_of = ok ? plb_new(s.regions.n + 1, sizeof *loops_of) : NULL;
    ok = ok && loops_of && plb_trace_regions(b, label, (uint32_t)s.regions.n, loops_of, out);
    for (size_t i = 0; ok && i < s.regions.n; i++)
        if (loops_of[i].n)
            ok = array_push(&out->areas, ((tone_area){colour_of(&s, s.regions.v[i]), loops_of[i].first, loops_of[i].n}));
    plb_free(loops_of);
    plb_free(label);
    plb_free(s.table);
    array_free(&s.regions);
    return ok || plb_fail_memory(err);
}

void plb_tone_list_free(tone_list *l)
{
    array_free(&l->points);
    array_free(&l->loops);
    array_free(&l->areas);
}
