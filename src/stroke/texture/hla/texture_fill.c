/* SPDX-License-Identifier: MIT
 *
 * Stage 3 of a stroke fills it with random greys (001 section 3.2 and figure 3; thesis section 4.2 and table 4.1, "grey filled").
 * Input: the length of the path in pixels of the profile. Output: a strip whose
 *
 *   - centre row replicates the centre histogram in [min_mid, max_mid],
 *   - rows beside it are uniform in [min_range, max_mid],
 *   - rows further out are uniform in [max_mid, max_range],
 *
 * within a margin of paper that the later steps need. "Beside" reaches to half the width at half depth, "further
 * out" to half the width at a tenth of depth: the papers speak of a predefined width and give no figure.
 */
#include "base/number/random.h"
#include "stroke/pencil.h"

#include <math.h>
#include <string.h>

/* 64 MiB of strip is a line of half a kilometre. */
#define STRIP_MAX ((size_t)64 << 20)

static bool resize(strip *s, int columns, int rows, error *err)
{
    size_t need = (size_t)columns * (size_t)rows;
    if (need > STRIP_MAX)
        return plb_fail(err, ERROR_LIMIT, "a stroke is too long: %d pixels", columns);
    if (need > s->capacity) {
        plb_strip_free(s);
        s->grey = plb_new(need, 1);
        s->spare = plb_new(need, 1);
        if (!s->grey || !s->spare) {
            plb_strip_free(s);
            return plb_fail_memory(err);
        }
        s->capacity = need;
    }
    s->columns = columns;
    s->rows = rows;
    memset(s->grey, 255, need);
    return true;
}

void plb_strip_free(strip *s)
{
    plb_free(s->grey);
    plb_free(s->spare);
    memset(s, 0, sizeof *s);
}

void plb_texture_wrap(strip *s)
{
    int n = s->columns - 2 * STRIP_MARGIN;
    for (int y = 0; y < s->rows; y++) {
        uint8_t *row = s->grey + (size_t)y * (size_t)s->columns;
        for (int k = 0; k < STRIP_MARGIN; k++) { /* n may be smaller than the margin */
            row[STRIP_MARGIN - 1 - k] = row[STRIP_MARGIN + n - 1 - k % n];
            row[STRIP_MARGIN + n + k] = row[STRIP_MARGIN + k % n];
        }
    }
}

static void fill_centre(uint8_t *row, int n, const pencil *p, uint64_t key)
{
    for (int x = 0; x < n; x++)
        row[x] = p->centre[random_bits(key, (uint64_t)x) >> 52]; /* 12 bits: CENTRE_STEPS */
}

/* Uniform in [low, low + span): 16 random bits a pixel, four pixels a draw. */
static void fill_uniform(uint8_t *row, int n, int low, int span, uint64_t key, uint64_t row_number)
{
    uint64_t bits = 0;
    for (int x = 0; x < n; x++) {
        if (x % 4 == 0)
            bits = random_bits(key, (row_number << 40) + (uint64_t)x);
        row[x] = (uint8_t)(low + (int)(((bits & 0xffff) * (uint64_t)span) >> 16));
        bits >>= 16;
    }
}

bool plb_texture_fill(strip *s, double length_px, const pencil *p, uint64_t seed, uint64_t identity, error *err)
{
    if (!(length_px <= (double)STRIP_MAX))
        return plb_fail(err, ERROR_LIMIT, "a stroke is too long");
    int n = length_px < 1 ? 1 : (int)floor(length_px + 0.5);
    int half = p->half_rows, columns = n + 2 * STRIP_MARGIN, rows = 2 * (half + STRIP_MARGIN) + 1;
    if (!resize(s, columns, rows, err))
        return false;
    uint64_t beside = random_key(seed, identity, PURPOSE_BESIDE), outside = random_key(seed, identity, PURPOSE_OUTSIDE);
    for (int k = -half; k <= half; k++) {
        uint8_t *row = s->grey + (size_t)(k + half + STRIP_MARGIN) * (size_t)columns + STRIP_MARGIN;
        if (k == 0)
            fill_centre(row, n, p, random_key(seed, identity, PURPOSE_CENTRE));
        else if (k >= -p->half_beside && k <= p->half_beside)
            fill_uniform(row, n, p->beside_low, p->beside_span, beside, (uint64_t)(k + half));
        else
            fill_uniform(row, n, p->outside_low, p->outside_span, outside, (uint64_t)(k + half));
    }
    return true;
}
