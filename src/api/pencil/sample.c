/* SPDX-License-Identifier: MIT
 *
 * Draws the lines that a capture compares with its scans, with the usual options.
 */
#include "api/pipeline.h"
#include "api/pencil/sample.h"

#include "base/number/random.h"
#include "base/number/units.h"

#include <math.h>

#define MARGIN 36 /* px at 300 dpi, at either end of a line: 3 mm */

typedef struct {
    uint8_t *grey;
    int width, height;
} picture;

static bool lay_on_picture(void *closure, const patch *p)
{
    const picture *to = closure;
    for (int y = 0; y < p->height; y++)
        for (int x = p->from[y]; x < p->to[y]; x++) {
            int px = p->x + x, py = p->y + y;
            if (px < 0 || py < 0 || px >= to->width || py >= to->height)
                continue;
            uint8_t *g = &to->grey[(size_t)py * (size_t)to->width + (size_t)px], v = p->grey[y * p->width + x];
            *g = v < *g ? v : *g;
        }
    return true;
}

bool plb_api_sample(void *closure, const profile *p, int lines, int width, int height, uint8_t *grey, error *err)
{
    (void)closure;
    const double mm = MM_PER_INCH / PAPER_PX_PER_INCH;
    pencil *made = plb_pencil_on_paper(p, PAPER_MEDIUM, err);
    if (!made)
        return false;
    double strays = fmin(p->hand, 1); /* one that strays farther than a free one would leave the picture */
    stroke_options o = {.pencil = made, .model = &plb_model_graphite, .arm = &plb_arm_hand, .handed = HANDED_RIGHT, .squiggle = -1, .hand = strays, .dpi = PAPER_PX_PER_INCH};
    stroke_scratch scratch = {0};
    bool good = true;
    for (int i = 0; i < lines && good; i++) {
        /* The lines cross the rows of pixels at all angles, and each lies on paper of its own. */
        double y = (height / 2 + (double)i / lines) * mm;
        point ends[2] = {{MARGIN * mm, y}, {(width - MARGIN) * mm, y}};
        stroke one = {.style = STROKE_STYLE_USUAL, .identity = random_mix((uint64_t)i), .n = 2};
        stroke_list list = {.strokes = {&one, 1, 1}, .points = {ends, 2, 2}};
        picture to = {grey + (size_t)i * (size_t)width * (size_t)height, width, height};
        o.seed = (uint64_t)i;
        good = plb_stroke_draw(&list, &one, &o, &scratch, lay_on_picture, &to, err);
    }
    plb_stroke_scratch_free(&scratch);
    plb_pencil_free(made);
    return good;
}
