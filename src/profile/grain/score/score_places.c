/* SPDX-License-Identifier: MIT
 *
 * The seventh step of the capture measures how the correlation of the scores depends on the distance from the centreline. The
 * flanks of a line run on more smoothly than its core.
 *
 * Where little is expected many pixels show nothing: their scores are known only to lie below a limit (they are censored).
 * They count as the mean of what lies below it; the correlation of normal scores that have that of the censored ones is found
 * by expanding the censoring in Hermite polynomials, in which a correlation r becomes the sum of c_k² r^k (Mehler's formula).
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include "base/number/normal.h"

#include <math.h>

#define CORRELATION_STEP 0.5          /* px */
#define MIN_LEVEL 0.015f      /* below it there is paper and what strayed onto it; chosen by eye */
#define MIN_PLACE_PAIRS 150              /* pairs for a place's own correlation; chosen by eye */
#define DEGREES 10              /* of the expansion: r^10 of the correlations met is below a thousandth */
#define EXPANSION_END 5.0            /* of the scores at which the expansion is integrated … */
#define GRID_STEP 0.05          /* … and their distance */
#define HALVINGS 20
#define ROOT_TURN 2.5066282746310002 /* root of two pi */

static double density(double z)
{
    return exp(-z * z / 2) / ROOT_TURN;
}

/* ---- censored scores ---- */

/* Gives the mean of a normal number below `z`. */
static double mean_below(double z)
{
    return -density(z) / fmax(plb_normal_share(z), 1e-6);
}

/* Computes the squares of the coefficients c_1 … of a normal number that counts as its mean below `limit`. */
static void expand(double limit, double squares[DEGREES])
{
    double c[DEGREES] = {0}, low = mean_below(limit);
    for (double z = -EXPANSION_END; z <= EXPANSION_END; z += GRID_STEP) {
        double weight = (z < limit ? low : z) * density(z) * GRID_STEP, before = 1, h = z;
        for (int k = 1; k <= DEGREES; k++) { /* H_{k+1} = (z H_k - root(k) H_{k-1}) / root(k + 1), of unit norm */
            c[k - 1] += weight * h;
            double next = (z * h - sqrt(k) * before) / sqrt(k + 1);
            before = h;
            h = next;
        }
    }
    for (int k = 0; k < DEGREES; k++)
        squares[k] = c[k] * c[k];
}

/* Gives the correlation of normal scores whose censored ones correlate by r. */
static double uncensored(double r, double limit)
{
    double squares[DEGREES], low = -1, high = 1, total = 0;
    expand(limit, squares);
    for (int k = 0; k < DEGREES; k++)
        total += squares[k];
    for (int i = 0; i < HALVINGS; i++) {
        double middle = (low + high) / 2, power = 1, sum = 0;
        for (int k = 0; k < DEGREES; k++)
            sum += squares[k] * (power *= middle);
        *(sum < r * total ? &low : &high) = middle;
    }
    return (low + high) / 2;
}

/* ---- sums by place ---- */

/* Sums over the pairs of one distance whose middle lies at one place. */
typedef struct {
    double near, first, second, n; /* sum of products; of squares of either */
    double distant, first_distant, m;  /* of pairs far apart along the line */
    double limits;                 /* sum of what share of the pixels shows nothing */
} pair_sums;

static void add_pair(pair_sums *s, const double a[2], const double b[2])
{
    s->near += a[0] * b[0];
    s->first += a[0] * a[0];
    s->second += b[0] * b[0];
    s->limits += (plb_normal_share(a[1]) + plb_normal_share(b[1])) / 2;
    s->n++;
}

/* Computes the censored score of a pixel and its limit. */
static bool score_at(const grain_line *l, const grain_model *g, int k, int o, double out[2])
{
    int i = k * GRAIN_ROWS + o;
    if (k >= l->n || o >= GRAIN_ROWS || !l->usable[k] || l->level[i] < MIN_LEVEL)
        return false;
    out[1] = plb_grain_bare_score(g, l->level[i], 0.5 / l->depth);
    out[0] = l->dark[i] > 0 ? plb_grain_score(g, l->level[i], l->dark[i]) : mean_below(out[1]);
    return true;
}

typedef struct {
    pair_sums along[GRAIN_PLACES], across[GRAIN_PLACES], core_along, core_across;
} place_sums;

static int bin_of(double place)
{
    return (int)fmin(fabs(place) / CORRELATION_STEP, GRAIN_PLACES - 1);
}

static void add_pixel(const grain_line *l, const grain_model *g, int k, int o, place_sums *s)
{
    double here[2], there[2];
    if (!score_at(l, g, k, o, here))
        return;
    double place = l->place[k * GRAIN_ROWS + o];
    bool is_core = l->level[k * GRAIN_ROWS + o] >= GRAIN_CORE;
    pair_sums *along = &s->along[bin_of(place)];
    if (score_at(l, g, k + 1, o, there)) {
        add_pair(along, here, there);
        if (is_core)
            add_pair(&s->core_along, here, there);
    }
    if (score_at(l, g, k, o + 1, there)) {
        add_pair(&s->across[bin_of(place + 0.5)], here, there);
        if (is_core)
            add_pair(&s->core_across, here, there);
    }
    for (int d = GRAIN_FAR_FROM; d <= GRAIN_FAR_TO; d += 2)
        if (score_at(l, g, k + d, o, there)) {
            along->distant += here[0] * there[0];
            along->first_distant += here[0] * here[0];
            along->m++;
        }
}

/* ---- correlations ---- */

static double correlation_of(const pair_sums *s, double slow)
{
    double r = s->near / fmax(sqrt(s->first * s->second), 1e-9), share = s->n > 0 ? s->limits / s->n : 0;
    return uncensored(clamp((r - slow) / fmax(1 - slow, 0.1), -1, 1), share > 1e-4 ? plb_normal_quantile(fmin(share, 0.99)) : -EXPANSION_END);
}

/* Finds by how much places correlate beyond the core; smoothed, and beyond the last place with enough pairs as there. */
static void relate(const pair_sums by_place[GRAIN_PLACES], const pair_sums along[GRAIN_PLACES], const pair_sums *core, float out[GRAIN_PLACES])
{
    double weighted[GRAIN_PLACES], weight[GRAIN_PLACES], smooth[GRAIN_PLACES], weights[GRAIN_PLACES];
    for (int k = 0; k < GRAIN_PLACES; k++) {
        double slow = along[k].m > 0 ? fmax(0, along[k].distant / fmax(along[k].first_distant, 1e-9)) : 0;
        weight[k] = by_place[k].n;
        weighted[k] = weight[k] > 0 ? weight[k] * (correlation_of(&by_place[k], slow) - correlation_of(core, 0)) : 0;
    }
    plb_smooth_folded(weighted, smooth, GRAIN_PLACES);
    plb_smooth_folded(weight, weights, GRAIN_PLACES);
    for (int k = 0; k < GRAIN_PLACES; k++)
        out[k] = weights[k] > MIN_PLACE_PAIRS ? (float)(smooth[k] / weights[k]) : k > 0 ? out[k - 1] : 0;
}

void plb_grain_places(const grain_lines *lines, grain_model *g)
{
    place_sums s = {0};
    for (size_t j = 0; j < lines->n; j++)
        for (int k = 0; k < lines->v[j].n; k++)
            for (int o = 0; o < GRAIN_ROWS; o++)
                add_pixel(&lines->v[j], g, k, o, &s);
    relate(s.along, s.along, &s.core_along, g->place_along);
    relate(s.across, s.along, &s.core_across, g->place_across);
}
