/* SPDX-License-Identifier: MIT
 *
 * texture_steps PENCIL LENGTH [SEED [PREFIX]]: the texture of a straight line, LENGTH mm long, after each of its steps
 * (thesis table 4.1), one pixel of the profile a pixel of the picture. Writes
 *
 *     PREFIX1-fill.png      random greys
 *     PREFIX2-ccm.png       after the co-occurrence matrix
 *     PREFIX3-blur.png      after the blur: the finished texture
 *     PREFIX4-no-ccm.png    the same random greys blurred, the co-occurrence matrix left out (tables 4.2 and 4.3)
 *
 * and prints what the passes of the matrix changed: "pixels N passes P changes C1 C2 ...".
 */
#include "stroke/stroke.h"
#include "tools/grey_write.h"

/* Like the first line of a drawing: the identity only has to be some number. */
#define IDENTITY 1

typedef struct {
    const char *prefix;
    const pencil *pencil;
    double length_px;
    uint64_t seed;
    strip strip;
} texture;

static void fill(texture *b)
{
    error err = {0};
    if (!plb_texture_fill(&b->strip, b->length_px, b->pencil, b->seed, IDENTITY, &err)) {
        fprintf(stderr, "texture_steps: %s\n", err.text);
        exit(2);
    }
}

static void save(const texture *b, const char *step)
{
    char file[4096];
    if ((size_t)snprintf(file, sizeof file, "%s%s.png", b->prefix, step) >= sizeof file) {
        fprintf(stderr, "texture_steps: the file name is too long\n");
        exit(2);
    }
    write_grey(file, b->strip.columns, b->strip.rows, b->strip.grey);
}

static void steps(texture *b)
{
    long changes[CCM_MAX_PASSES];
    fill(b);
    save(b, "1-fill");
    int passes = plb_texture_ccm(&b->strip, b->pencil, changes);
    save(b, "2-ccm");
    plb_texture_blur(&b->strip);
    save(b, "3-blur");
    fill(b);
    plb_texture_blur(&b->strip);
    save(b, "4-no-ccm");
    printf("pixels %ld passes %d changes", (long)b->strip.columns * b->strip.rows, passes);
    for (int k = 0; k < passes; k++)
        printf(" %ld", changes[k]);
    putchar('\n');
}

int main(int argc, char **argv)
{
    double length = argc > 2 ? strtod(argv[2], NULL) : 0;
    if (argc < 3 || argc > 5 || !(length > 0 && length <= 1000)) {
        fprintf(stderr, "usage: texture_steps PENCIL LENGTH [SEED [PREFIX]]; LENGTH in mm, at most 1000\n");
        return 2;
    }
    error err = {0};
    profile *p = plb_profile_read(argv[1], &err);
    pencil *ready = p ? plb_pencil_new(p, &err) : NULL;
    if (!ready) {
        fprintf(stderr, "texture_steps: %s\n", err.text);
        plb_profile_release(p);
        return 2;
    }
    texture b = {.prefix = argc > 4 ? argv[4] : "", .pencil = ready, .length_px = length / 25.4 * p->dpi};
    b.seed = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;
    steps(&b);
    plb_strip_free(&b.strip);
    plb_pencil_free(ready);
    plb_profile_release(p);
    return 0;
}
