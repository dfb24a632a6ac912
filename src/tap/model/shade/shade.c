/* SPDX-License-Identifier: MIT
 *
 * See shade.h. Each cell gets a tone by the light on the surface that is seen there; cells of one surface and one tone are a region.
 */
#include "tap/model/shade/shade.h"

#include "tap/model/shade/direction.h"
#include "tap/model/shade/key_table.h"

/* Tones that a hand tells apart: darknesses, from blank paper on, and from which darkness on each is taken (chosen by eye). */
#define TONES 5
static const double tone_darkness[TONES] = {0, .11, .2, .29, .38};
static const double tone_from[TONES] = {-1, .11, .21, .32, .45};
/* A surface turned away from the light is as dark as this (chosen by eye: lines must stand out from it). */
#define DARKEST 0.66
/* A material's own darkness counts so much: light makes the form, and black things are drawn grey (chosen by eye). */
#define LOCAL_TONE 0.45f
#define DIMMEST 0.05f
#define FLAT 0.9999 /* cosine of a turn that nobody sees */

/* Round surfaces go over from tone to tone: darkness on paper by that of the surface, about a line through the steps above (chosen by eye). */
#define ROUND_BASE (-0.02)
#define ROUND_SLOPE 0.8

/* Sums over the cells of a region: how its darkness changes over the page, by least squares; where its hatching runs. */
typedef struct {
    double n, x, y, d, xx, xy, yy, xd, yd;
    page_direction way;
    box bounds;
} region_sums;

/* A region is what has one patch, one paint, one tone and, on round surfaces, one sector of directions. */
enum { KEY_PATCH, KEY_PAINT, KEY_TONE, KEY_SECTOR };

typedef struct {
    const view *v;
    const surface_buffer *b;
    vector to_light; /* in the model's space, length 1 */
    float brightest; /* of the materials */
    key_table regions;
    ARRAY(region_sums) sums;   /* of the regions */
    unsigned char *is_round;   /* by patch */
    direction_field directions;
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

static double darkness_at(const shader *s, uint32_t t, point at)
{
    double towards = vector_dot(normal_at(s->v, t, at), s->to_light); /* -1 to 1 */
    return DARKEST * (1 - towards) / 2;
}

static uint32_t tone_of(double darkness)
{
    uint32_t tone = 0;
    while (tone + 1 < TONES && darkness >= tone_from[tone + 1])
        tone++;
    return tone;
}

static void add_cell(region_sums *r, point p, double d, page_direction way)
{
    r->n++;
    r->x += p.x, r->y += p.y, r->d += d;
    r->xx += p.x * p.x, r->xy += p.x * p.y, r->yy += p.y * p.y;
    r->xd += p.x * d, r->yd += p.y * d;
    r->way.cosine += way.cosine, r->way.sine += way.sine;
    plb_box_add(&r->bounds, p);
}

/* A patch is round when its surface turns at an edge within it. */
static bool find_round(shader *s)
{
    const mesh *m = s->v->m;
    s->is_round = plb_new((size_t)m->patches + 1, 1);
    for (size_t i = 0; s->is_round && i < m->edges.n; i++) {
        const edge *e = &m->edges.v[i];
        uint32_t t = m->halves.v[e->first].side / 3, u = m->halves.v[e->first + e->n - 1].side / 3;
        if (m->patch.v[t] == m->patch.v[u] && fabs(vector_dot(m->normals.v[t], m->normals.v[u])) < FLAT)
            s->is_round[m->patch.v[t]] = 1;
    }
    return s->is_round;
}

/* Labels the cells with their regions. */
static bool label_cells(shader *s, uint32_t *label)
{
    const surface_buffer *b = s->b;
    table_key last = {{NO_TRIANGLE, 0, 0, 0}};
    uint32_t number = 0;
    for (int y = 0; y < b->height; y++)
        for (int x = 0; x < b->width; x++) {
            size_t i = (size_t)y * (size_t)b->width + (size_t)x;
            uint32_t t = b->triangle[i];
            label[i] = UINT32_MAX;
            if (t == NO_TRIANGLE)
                continue;
            point at = {b->corner.x + (x + .5) * b->cell, b->corner.y + (y + .5) * b->cell};
            double darkness = darkness_at(s, t, at);
            page_direction way = plb_direction_at(&s->directions, t, x, y);
            table_key k = {{s->v->m->patch.v[t], s->v->m->triangles.v[t].paint, tone_of(darkness), s->is_round[s->v->m->patch.v[t]] ? plb_direction_sector(way) : 0}};
            if (!plb_key_is_same(k, last) && !plb_key_number(&s->regions, k, &number))
                return false;
            while (s->sums.n < s->regions.keys.n)
                if (!array_push(&s->sums, ((region_sums){.bounds = BOX_EMPTY})))
                    return false;
            last = k;
            label[i] = number;
            add_cell(&s->sums.v[number], at, darkness, way);
        }
    return true;
}

/* Regions of another direction that are smaller than this, mm2, are hatched in that of their neighbours (chosen by eye: a patch of a
 * hand's strokes has so much). */
#define SMALL_MM2 20.0

static void join_sums(region_sums *to, const region_sums *r)
{
    to->n += r->n;
    to->x += r->x, to->y += r->y, to->d += r->d;
    to->xx += r->xx, to->xy += r->xy, to->yy += r->yy;
    to->xd += r->xd, to->yd += r->yd;
    to->way.cosine += r->way.cosine, to->way.sine += r->way.sine;
    plb_box_add(&to->bounds, (point){r->bounds.x0, r->bounds.y0});
    plb_box_add(&to->bounds, (point){r->bounds.x1, r->bounds.y1});
}

/* Gives the region, other than i, of the same patch, paint and tone whose sector is nearest; the larger one of two; i where there is none. */
static uint32_t next_of_kin(const shader *s, uint32_t i)
{
    table_key k = s->regions.keys.v[i];
    uint32_t best = i, most = SECTORS;
    for (uint32_t n = 0; n < SECTORS; n++) {
        uint32_t other, apart = (n + SECTORS - k.part[KEY_SECTOR]) % SECTORS;
        table_key o = k;
        o.part[KEY_SECTOR] = n;
        apart = apart > SECTORS / 2 ? SECTORS - apart : apart;
        if (!apart || !plb_key_find(&s->regions, o, &other))
            continue;
        if (apart < most || (apart == most && s->sums.v[other].n > s->sums.v[best].n)) {
            best = other;
            most = apart;
        }
    }
    return best;
}

/* Gives small regions to those of nearly the same direction, the smallest sectors first in each patch. */
static bool join_small(shader *s, uint32_t *label)
{
    size_t n = s->regions.keys.n, cells = (size_t)s->b->width * (size_t)s->b->height;
    double small = SMALL_MM2 / (s->b->cell * s->b->cell);
    uint32_t *to = plb_new(n + 1, sizeof *to);
    for (uint32_t i = 0; to && i < n; i++)
        to[i] = i;
    for (uint32_t i = 0; to && i < n; i++) {
        uint32_t kin = s->is_round[s->regions.keys.v[i].part[KEY_PATCH]] && s->sums.v[i].n < small ? next_of_kin(s, i) : i;
        while (to[kin] != kin)
            kin = to[kin];
        if (kin == i)
            continue;
        to[i] = kin;
        join_sums(&s->sums.v[kin], &s->sums.v[i]);
    }
    for (size_t i = 0; to && i < cells; i++)
        while (label[i] != UINT32_MAX && to[label[i]] != label[i])
            label[i] = to[label[i]];
    bool ok = to;
    plb_free(to);
    return ok;
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
static colour colour_of(const shader *s, table_key k, double darkness)
{
    colour c = s->v->m->paints.v[k.part[KEY_PAINT]].colour;
    float left = (float)(1 - darkness);
    return (colour){on_paper(c.red, s->brightest, left), on_paper(c.green, s->brightest, left), on_paper(c.blue, s->brightest, left)};
}

/* The tone of a round surface within its step. */
static double round_darkness(double d, uint32_t tone)
{
    double low = greater(tone_from[tone], 0), high = tone + 1 < TONES ? tone_from[tone + 1] : DARKEST;
    return ROUND_BASE + ROUND_SLOPE * lesser(greater(d, low), high);
}

/* Lays the plane of least squares through the darkness of a region's cells: from where to where it changes, and from what to what. */
static void find_slope(const shader *s, size_t region, tone_area *a)
{
    const region_sums *r = &s->sums.v[region];
    table_key k = s->regions.keys.v[region];
    double x = r->x / r->n, y = r->y / r->n, d = r->d / r->n;
    double xx = r->xx / r->n - x * x, xy = r->xy / r->n - x * y, yy = r->yy / r->n - y * y, xd = r->xd / r->n - x * d, yd = r->yd / r->n - y * d;
    double det = xx * yy - xy * xy;
    point g = det > 1e-9 ? (point){(xd * yy - yd * xy) / det, (yd * xx - xd * xy) / det} : (point){0, 0};
    double steep = plb_point_length(g);
    point way = steep > 0 ? point_scale(g, 1 / steep) : (point){1, 0}, middle = {x, y};
    double reach = (fabs(way.x) * (r->bounds.x1 - r->bounds.x0) + fabs(way.y) * (r->bounds.y1 - r->bounds.y0)) / 2 + s->b->cell;
    a->is_round = true;
    a->from = point_sub(middle, point_scale(way, reach));
    a->to = point_add(middle, point_scale(way, reach));
    a->colours[0] = colour_of(s, k, round_darkness(d - steep * reach, k.part[KEY_TONE]));
    a->colours[1] = colour_of(s, k, round_darkness(d + steep * reach, k.part[KEY_TONE]));
}

static tone_area area_of(const shader *s, size_t region, tone_loop loops)
{
    table_key k = s->regions.keys.v[region];
    tone_area a = {.colour = colour_of(s, k, tone_darkness[k.part[KEY_TONE]]), .first = loops.first, .n = loops.n};
    a.is_directed = plb_direction_angle(s->sums.v[region].way, s->sums.v[region].n, &a.direction);
    if (s->is_round[k.part[KEY_PATCH]] && k.part[KEY_TONE] > 0)
        find_slope(s, region, &a);
    return a;
}

bool plb_shade(const view *v, const surface_buffer *b, light from, tone_list *out, error *err)
{
    shader s = {.v = v, .b = b, .to_light = direction_to_light(v, from), .brightest = brightest_of(v->m)};
    uint32_t *label = plb_new((size_t)b->width * (size_t)b->height, sizeof *label);
    bool ok = label && find_round(&s) && plb_find_directions(v, b, s.is_round, &s.directions) && label_cells(&s, label) && join_small(&s, label);
    tone_loop *loops_of = ok ? plb_new(s.regions.keys.n + 1, sizeof *loops_of) : NULL;
    ok = ok && loops_of && plb_trace_regions(b, label, (uint32_t)s.regions.keys.n, loops_of, out);
    for (size_t i = 0; ok && i < s.regions.keys.n; i++)
        if (loops_of[i].n)
            ok = array_push(&out->areas, area_of(&s, i, loops_of[i]));
    plb_free(loops_of);
    plb_free(label);
    plb_key_table_free(&s.regions);
    plb_direction_free(&s.directions);
    plb_free(s.is_round);
    array_free(&s.sums);
    return ok || plb_fail_memory(err);
}

void plb_tone_list_free(tone_list *l)
{
    array_free(&l->points);
    array_free(&l->loops);
    array_free(&l->areas);
}
