/* SPDX-License-Identifier: MIT
 *
 * See direction.h. Each triangle has a direction by how its corners' normals turn; over a round surface these are evened out, for a hand
 * follows the form, not the facets.
 */
#include "tap/model/shade/direction.h"

#include "tap/model/shade/shade.h"

/* Cells of a block's side: about 2 mm (chosen by eye: a few strokes). */
#define BLOCK 16
/* The slope counts so much against a principal direction that is not sure (chosen by eye). */
#define SLOPE_WEIGHT 0.15
/* Less sure directions are left to the hand. */
#define SURE 0.1
/* A slope that falls by less than this, sine of the angle, is level: it has no direction. */
#define LEVEL 0.08

void plb_direction_free(direction_field *f)
{
    plb_free(f->triangles);
    plb_key_table_free(&f->places);
    array_free(&f->blocks);
}

/* ---- one triangle ---- */

/* Gives a direction in space as one on the page; `weight` is how sure it is where it lies in the page. */
static page_direction on_page(const view *v, vector d, double weight)
{
    double x = vector_dot(d, v->right), y = -vector_dot(d, v->up), l2 = x * x + y * y;
    if (!(l2 > 1e-6))
        return (page_direction){0, 0};
    return (page_direction){weight * (x * x - y * y) / l2, weight * 2 * x * y / l2};
}

/* Gives the steepest way down a plane with this normal, its length the sine of the angle of its fall. */
static vector down_slope(vector n) { return vector_add((vector){0, 0, -1}, vector_scale(n, n.z)); }

/* Solves the least squares of how normals turn along the sides, dn = S dp with S symmetric, in the plane of e1 and e2 [Rus04, §3.1]; gives S. */
static bool shape_operator(const mesh *m, uint32_t t, vector e1, vector e2, double s[3])
{
    double a[3][4] = {{0}};
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3;
        vector dp = vector_sub(mesh_corner(m, t, l), mesh_corner(m, t, k));
        vector dn = vector_sub(m->smooth.v[m->group.v[3 * (size_t)t + (size_t)l]], m->smooth.v[m->group.v[3 * (size_t)t + (size_t)k]]);
        double x = vector_dot(dp, e1), y = vector_dot(dp, e2), u = vector_dot(dn, e1), w = vector_dot(dn, e2);
        a[0][0] += x * x, a[0][1] += x * y, a[0][3] += x * u;
        a[1][1] += x * x + y * y, a[1][2] += x * y, a[1][3] += y * u + x * w;
        a[2][2] += y * y, a[2][3] += y * w;
    }
    a[1][0] = a[0][1];
    a[2][1] = a[1][2];
    /* Gauss without pivots: the matrix is positive definite. */
    for (int i = 0; i < 3; i++) {
        if (!(a[i][i] > 1e-12 * (a[0][0] + a[2][2])))
            return false;
        for (int k = i + 1; k < 3; k++)
            for (int j = 3; j >= i; j--)
                a[k][j] -= a[i][j] * (a[k][i] / a[i][i]);
    }
    for (int i = 2; i >= 0; i--) {
        s[i] = a[i][3];
        for (int k = i + 1; k < 3; k++)
            s[i] -= a[i][k] * s[k];
        s[i] /= a[i][i];
    }
    return isfinite(s[0]) && isfinite(s[1]) && isfinite(s[2]);
}

/* Gives the direction of least curvature, and how much less it is than the other, 0 to 1. */
static bool least_curved(const mesh *m, uint32_t t, vector *way, double *sure)
{
    vector n = m->normals.v[t], e1 = vector_unit(vector_sub(mesh_corner(m, t, 1), mesh_corner(m, t, 0))), e2 = vector_cross(n, e1);
    double s[3];
    if (!shape_operator(m, t, e1, e2, s))
        return false;
    /* The eigenvalues of S are mean +- apart; one axis is at half the angle of (s0 - s2, 2 s1). */
    double mean = (s[0] + s[2]) / 2, apart = hypot((s[0] - s[2]) / 2, s[1]), angle = atan2(2 * s[1], s[0] - s[2]) / 2;
    double k1 = mean + apart, k2 = mean - apart;
    if (fabs(k1) > fabs(k2))
        angle += PLB_PI / 2; /* the axis of k2 */
    double most = greater(fabs(k1), fabs(k2)), least = lesser(fabs(k1), fabs(k2));
    *sure = most * m->size > 1e-3 ? (most - least) / (most + least) : 0;
    *way = vector_add(vector_scale(e1, cos(angle)), vector_scale(e2, sin(angle)));
    return true;
}

static page_direction direction_of(const direction_field *f, uint32_t t)
{
    const mesh *m = f->v->m;
    vector slope = down_slope(m->normals.v[t]), way;
    double fall = vector_length(slope), sure;
    page_direction d = on_page(f->v, slope, fall > LEVEL ? 1 : 0);
    if (!f->is_round[m->patch.v[t]] || !least_curved(m, t, &way, &sure))
        return d;
    page_direction along = on_page(f->v, way, sure * sure);
    return (page_direction){along.cosine + SLOPE_WEIGHT * d.cosine, along.sine + SLOPE_WEIGHT * d.sine};
}

/* ---- evened out ---- */

static table_key block_key(const direction_field *f, uint32_t t, int x, int y) { return (table_key){{f->v->m->patch.v[t], (uint32_t)(x / BLOCK), (uint32_t)(y / BLOCK), 0}}; }

/* Adds up the directions of each block's cells, one in four each way. */
static bool sum_blocks(direction_field *f, const surface_buffer *b)
{
    for (int y = 2; y < b->height; y += 4)
        for (int x = 2; x < b->width; x += 4) {
            uint32_t t = b->triangle[(size_t)y * (size_t)b->width + (size_t)x], number;
            if (t == NO_TRIANGLE || !f->is_round[f->v->m->patch.v[t]])
                continue;
            if (!plb_key_number(&f->places, block_key(f, t, x, y), &number) || (number == f->blocks.n && !array_push(&f->blocks, ((page_direction){0, 0}))))
                return false;
            f->blocks.v[number].cosine += f->triangles[t].cosine;
            f->blocks.v[number].sine += f->triangles[t].sine;
        }
    return true;
}

/* Adds to each block those around it. */
static bool blur_blocks(direction_field *f)
{
    page_direction *sums = plb_new(f->blocks.n + 1, sizeof *sums);
    for (uint32_t i = 0; sums && i < f->blocks.n; i++) {
        table_key k = f->places.keys.v[i];
        for (int n = 0; n < 9; n++) {
            uint32_t other;
            table_key o = {{k.part[0], k.part[1] + (uint32_t)(n % 3) - 1, k.part[2] + (uint32_t)(n / 3) - 1, 0}};
            if (!plb_key_find(&f->places, o, &other))
                continue;
            double weight = n == 4 ? 2 : 1;
            sums[i].cosine += weight * f->blocks.v[other].cosine;
            sums[i].sine += weight * f->blocks.v[other].sine;
        }
    }
    for (uint32_t i = 0; sums && i < f->blocks.n; i++) {
        double l = hypot(sums[i].cosine, sums[i].sine);
        f->blocks.v[i] = l > 0 ? (page_direction){sums[i].cosine / l, sums[i].sine / l} : (page_direction){0, 0};
    }
    bool ok = sums;
    plb_free(sums);
    return ok;
}

bool plb_find_directions(const view *v, const surface_buffer *b, const unsigned char *is_round, direction_field *f)
{
    *f = (direction_field){.v = v, .is_round = is_round};
    f->triangles = plb_new(v->m->triangles.n + 1, sizeof *f->triangles);
    for (uint32_t t = 0; f->triangles && t < v->m->triangles.n; t++)
        f->triangles[t] = direction_of(f, t);
    return f->triangles && sum_blocks(f, b) && blur_blocks(f);
}

page_direction plb_direction_at(const direction_field *f, uint32_t t, int x, int y)
{
    uint32_t number;
    if (f->is_round[f->v->m->patch.v[t]] && plb_key_find(&f->places, block_key(f, t, x, y), &number))
        return f->blocks.v[number];
    return f->triangles[t];
}

uint32_t plb_direction_sector(page_direction d)
{
    double turn = atan2(d.sine, d.cosine) / (2 * PLB_PI); /* of half a turn: -.5 to .5 */
    return (uint32_t)(int)floor((turn + 1) * SECTORS + .5) % SECTORS;
}

bool plb_direction_angle(page_direction sum, double n, double *degrees)
{
    *degrees = floor(atan2(sum.sine, sum.cosine) * 90 / PLB_PI + .5); /* a hand is no more exact */
    return hypot(sum.cosine, sum.sine) > SURE * n;
}
