/* SPDX-License-Identifier: MIT */
#include "profile/capture/line_section.h"

#include <math.h>

static void add_to_bin(section_sums *sums, int bin, double weight, double grey)
{
    if (bin >= PROFILE_SECTION_BINS)
        return;
    sums->n[bin] += weight;
    sums->sum[bin] += weight * grey;
    sums->squares[bin] += weight * grey * grey;
}

/* A pixel counts in the two bins whose middles it lies between, the nearer one more: the figures then change steadily
 * with the stretch. What would fall into the bin before the first one comes back from the other side of the line. */
void plb_section_add(section_sums *sums, const line_strip *s, double stretch)
{
    for (int k = 0; k < s->n; k++)
        for (int o = -s->reach; o <= s->reach && s->usable[k]; o++) {
            double at = strip_distance(s, k, o) * stretch / PROFILE_SECTION_STEP - 0.5, bin = floor(at);
            if (bin >= PROFILE_SECTION_BINS)
                continue;
            add_to_bin(sums, bin < 0 ? 0 : (int)bin, 1 - (at - bin), strip_grey(s, k, o));
            add_to_bin(sums, (int)bin + 1, at - bin, strip_grey(s, k, o));
        }
}

/* Interpolates value `i` of an empty bin from the nearest filled ones; beyond the last: `outside`. */
static double between(const section_sums *sums, const double v[], int i, double outside)
{
    int a = i, b = i;
    while (a >= 0 && sums->n[a] == 0)
        a--;
    while (b < PROFILE_SECTION_BINS && sums->n[b] == 0)
        b++;
    double right = b < PROFILE_SECTION_BINS ? v[b] : outside;
    return a < 0 ? right : b == PROFILE_SECTION_BINS ? outside : v[a] + (right - v[a]) * (i - a) / (b - a);
}

void plb_section_figures(const section_sums *sums, double mean[PROFILE_SECTION_BINS], double sd[PROFILE_SECTION_BINS])
{
    for (int i = 0; i < PROFILE_SECTION_BINS; i++)
        if (sums->n[i] > 0) {
            mean[i] = sums->sum[i] / sums->n[i];
            sd[i] = sqrt(fmax(0, sums->squares[i] / sums->n[i] - mean[i] * mean[i]));
        }
    for (int i = 0; i < PROFILE_SECTION_BINS; i++)
        if (sums->n[i] == 0) {
            mean[i] = between(sums, mean, i, 255);
            sd[i] = between(sums, sd, i, 0);
        }
}

double plb_section_width(const double mean[PROFILE_SECTION_BINS], double share)
{
    int peak = 0, i;
    for (i = 1; i < PROFILE_SECTION_BINS; i++)
        if (mean[i] < mean[peak])
            peak = i;
    double want = share * (255 - mean[peak]);
    for (i = peak; i < PROFILE_SECTION_BINS && 255 - mean[i] >= want; i++)
        ;
    if (want <= 0 || i == PROFILE_SECTION_BINS)
        return 0;
    double inner = 255 - mean[i - 1], outer = 255 - mean[i];
    return 2 * PROFILE_SECTION_STEP * (i - 0.5 + (inner - want) / (inner - outer));
}
