/* SPDX-License-Identifier: MIT
 *
 * Stage 5 of a stroke blurs it by one pass of a 3 × 3 Gaussian (001 section 3.2 and figure 5; thesis section 4.2), weights
 * 1 2 1 / 2 4 2 / 1 2 1 over 16. The paper around the line takes part: it softens the rim.
 */
#include "stroke/texture/hla/strip.h"

#include <string.h>

void plb_texture_blur(strip *s)
{
    size_t w = (size_t)s->columns;
    memcpy(s->spare, s->grey, w * (size_t)s->rows);
    for (size_t y = 1; y + 1 < (size_t)s->rows; y++)
        for (size_t x = 1; x + 1 < w; x++) {
            const uint8_t *a = s->spare + (y - 1) * w + x, *b = a + w, *c = b + w;
            int sum = a[-1] + 2 * a[0] + a[1] + 2 * (b[-1] + 2 * b[0] + b[1]) + c[-1] + 2 * c[0] + c[1];
            s->grey[y * w + x] = (uint8_t)((sum + 8) >> 4);
        }
}
