/* SPDX-License-Identifier: MIT
 *
 * Step 2 of the medial axis thins in the order of distance (Pudney 1998, Distance-ordered homotopic thinning). A pixel
 * goes when the shape stays in one piece and keeps its holes without it ("simple", Rosenfeld 1970) and it is not the
 * tip of a line of the axis. Those nearest to the edge go first, so that what is left lies in the middle.
 */
#include "plan/letter/medial/medial.h"

#include <math.h>

/* Gives the eight neighbours as bits, clockwise from the right. */
static unsigned neighbours(const uint8_t *at, int w)
{
    return (unsigned)(at[1] | at[w + 1] << 1 | at[w] << 2 | at[w - 1] << 3 | at[-1] << 4 | at[-w - 1] << 5 | at[-w] << 6 | at[1 - w] << 7);
}

static int count_bits(unsigned bits)
{
    int n = 0;
    for (; bits; bits &= bits - 1)
        n++;
    return n;
}

/* Simple for eight-connected shapes: exactly one run of background among the four direct neighbours, seen through the
 * corners (Yokoi's number is 1). */
static bool is_simple(unsigned bits)
{
    int runs = 0;
    for (int k = 0; k < 8; k += 2) {
        unsigned here = bits >> k & 1, next = bits >> ((k + 1) & 7) & 1, after = bits >> ((k + 2) & 7) & 1;
        runs += !here && (next || after);
    }
    return runs == 1;
}

typedef enum { KEEP, REMOVE, TIP } verdict;

/* The tip of a line is one pixel with one neighbour, or, of a line still two pixels wide, with two side by side. */
static verdict judge(unsigned bits)
{
    unsigned round = bits | bits << 8;
    bool side_by_side = count_bits(bits) == 2 && (round & round >> 1) != 0;
    return !is_simple(bits) ? KEEP : count_bits(bits) == 1 || side_by_side ? TIP : REMOVE;
}

/* A tip stays where the disc around it does not grow by nearly a whole step towards a neighbour: it then is part of an
 * axis. The axis of a wedge grows by the sine of half its angle: so it stays in wedges sharper than 76 degrees, and a
 * stem's square end gets no forks into its corners. */
#define MIN_RIDGE_SLOPE 0.62

static bool is_ridge(const raster *r, int i)
{
    for (int dy = -1; dy <= 1; dy++)
        for (int dx = -1; dx <= 1; dx++) {
            double step = dx && dy ? 1.41421356 : 1;
            if (r->radius[i + dy * r->width + dx] - r->radius[i] > MIN_RIDGE_SLOPE * step)
                return false;
        }
    return true;
}

/* Distances in eighths of a pixel: the order of removal. */
static int level_of(const raster *r, int i)
{
    return (int)(r->radius[i] * 8);
}

/* Gives the pixels inside, nearest to the edge first: a counting sort. */
static int *sort_by_distance(const raster *r)
{
    int levels = (int)(r->largest * 8) + 2, n = r->width * r->height;
    size_t *count = plb_new((size_t)levels + 1, sizeof *count);
    int *sorted = plb_new(r->area ? r->area : 1, sizeof *sorted);
    if (count && sorted) {
        for (int i = 0; i < n; i++)
            if (r->on[i])
                count[level_of(r, i) + 1]++;
        for (int k = 0; k < levels; k++)
            count[k + 1] += count[k];
        for (int i = 0; i < n; i++)
            if (r->on[i])
                sorted[count[level_of(r, i)]++] = i;
    } else {
        plb_free(sorted);
        sorted = NULL;
    }
    plb_free(count);
    return sorted;
}

bool plb_medial_thin(raster *r, error *err)
{
    uint8_t verdicts[256];
    for (unsigned b = 0; b < 256; b++)
        verdicts[b] = (uint8_t)judge(b);
    int *left = sort_by_distance(r);
    if (!left)
        return plb_fail_memory(err);
    for (size_t n = r->area, before = n + 1; n < before;) {
        before = n;
        size_t kept = 0;
        for (size_t i = 0; i < n; i++) {
            uint8_t *at = r->on + left[i];
            uint8_t v = verdicts[neighbours(at, r->width)];
            if (v == REMOVE || (v == TIP && !is_ridge(r, left[i])))
                *at = 0;
            else
                left[kept++] = left[i];
        }
        n = kept;
    }
    plb_free(left);
    return true;
}
