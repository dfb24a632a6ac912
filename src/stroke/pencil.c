/* SPDX-License-Identifier: MIT
 *
 * A profile made ready for drawing. Inputs: the profile's histograms, bounds, widths and co-occurrence matrix
 * (001 section 3.2). Output: tables that turn random bits into greys without search.
 */
#include "stroke/pencil.h"

#include <math.h>

/* Computes the quantile function of the centre histogram restricted to [min_mid, max_mid]: entry k is the grey below which
 * the share (k + 1/2) / CENTRE_STEPS of the centre's pixels lies. */
static void tabulate_centre(pencil *p)
{
    const profile *f = p->profile;
    uint64_t total = 0, below = 0;
    for (int g = f->min_mid; g <= f->max_mid; g++)
        total += f->mid[g];
    int g = f->min_mid;
    for (int k = 0; k < CENTRE_STEPS; k++) {
        double want = (k + 0.5) / CENTRE_STEPS * (double)total;
        while (g < f->max_mid && (double)(below + f->mid[g]) <= want)
            below += f->mid[g++];
        p->centre[k] = (uint8_t)g;
    }
}

/* For each grey i the matrix knows, the nearest grey that it has seen beside i; greys it never saw leave their
 * neighbours alone. Ties go to the darker one. */
static void tabulate_nearest(pencil *p)
{
    for (int i = 0; i < PROFILE_GREYS; i++) {
        const uint32_t *row = p->profile->ccm + i * PROFILE_GREYS;
        int last = -1;
        for (int j = 0; j < PROFILE_GREYS; j++) {
            if (row[j])
                last = j;
            p->nearest[i][j] = (uint8_t)(last < 0 ? j : last);
        }
        bool any = last >= 0;
        for (int j = PROFILE_GREYS - 1, next = -1; any && j >= 0; j--) {
            if (row[j])
                next = j;
            int before = p->nearest[i][j];
            bool known_before = before <= j && row[before];
            if (next >= 0 && (!known_before || next - j < j - before))
                p->nearest[i][j] = (uint8_t)next;
        }
    }
}

static int rows_of(double half_width)
{
    return half_width < 0.5 ? 0 : (int)floor(half_width + 0.5);
}

pencil *plb_pencil_new(const profile *f, error *err)
{
    pencil *p = plb_new(1, sizeof *p);
    if (!p) {
        plb_fail_memory(err);
        return NULL;
    }
    p->profile = f;
    p->half_beside = rows_of((f->width_half - 1) / 2);
    p->half_rows = rows_of((f->width_tenth - 1) / 2);
    if (p->half_rows <= p->half_beside)
        p->half_rows = p->half_beside + 1;
    p->beside_low = f->min_range < f->max_mid ? f->min_range : f->max_mid;
    p->beside_span = f->max_mid - p->beside_low + 1;
    p->outside_low = f->max_mid < f->max_range ? f->max_mid : f->max_range;
    p->outside_span = f->max_range - p->outside_low + 1;
    tabulate_centre(p);
    tabulate_nearest(p);
    return p;
}

pencil *plb_pencil_on_paper(const profile *f, paper_kind on, error *err)
{
    pencil *p = plb_pencil_new(f, err);
    if (!p || !f->grain.present || plb_pencil_tabulate_grain(p, on))
        return p;
    plb_fail_memory(err);
    plb_pencil_free(p);
    return NULL;
}

void plb_pencil_free(pencil *p)
{
    if (p)
        plb_free(p->grain);
    plb_free(p);
}
