/* SPDX-License-Identifier: MIT
 *
 * png_compare A B [X0 Y0 X1 Y1]: compares two pictures as grey on white, pixel by pixel; with a box, only pixels outside
 * of it (x0 <= x < x1) count. Prints "different N max M box X0 Y0 X1 Y1", where the last box bounds the pixels
 * that differ. Exit status 0: the same; 1: not.
 */
#include "tools/png_image.h"

typedef struct {
    long n;
    int max;
    int x0, y0, x1, y1;
} difference;

static void note(difference *d, int x, int y, int by)
{
    if (d->n++ == 0) {
        d->x0 = d->x1 = x;
        d->y0 = d->y1 = y;
    }
    d->max = by > d->max ? by : d->max;
    d->x0 = x < d->x0 ? x : d->x0;
    d->x1 = x > d->x1 ? x : d->x1;
    d->y0 = y < d->y0 ? y : d->y0;
    d->y1 = y > d->y1 ? y : d->y1;
}

static difference compare(grey_image a, grey_image b, const int skip[4])
{
    difference d = {0};
    for (int y = 0; y < a.height; y++)
        for (int x = 0; x < a.width; x++) {
            size_t i = (size_t)y * (size_t)a.width + (size_t)x;
            bool skipped = x >= skip[0] && x < skip[2] && y >= skip[1] && y < skip[3];
            if (!skipped && a.grey[i] != b.grey[i])
                note(&d, x, y, abs(a.grey[i] - b.grey[i]));
        }
    return d;
}

int main(int argc, char **argv)
{
    if (argc != 3 && argc != 7) {
        fprintf(stderr, "usage: png_compare A B [X0 Y0 X1 Y1]\n");
        return 2;
    }
    grey_image a = read_grey(argv[1]), b = read_grey(argv[2]);
    int skip[4] = {0, 0, 0, 0};
    for (int i = 3; i < argc; i++)
        skip[i - 3] = (int)argument(argv[i], -1e6, 1e6);
    if (a.width != b.width || a.height != b.height) {
        printf("different size %d %d and %d %d\n", a.width, a.height, b.width, b.height);
        return 1;
    }
    difference d = compare(a, b, skip);
    printf("different %ld max %d box %d %d %d %d\n", d.n, d.max, d.x0, d.y0, d.x1, d.y1);
    free(a.grey);
    free(b.grey);
    return d.n != 0;
}
