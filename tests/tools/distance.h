/* SPDX-License-Identifier: MIT
 *
 * How far each pixel of a picture is from the nearest marked one, exactly: Felzenszwalb & Huttenlocher, "Distance
 * transforms of sampled functions", 2012.
 */
#ifndef PLB_TESTS_DISTANCE_H
#define PLB_TESTS_DISTANCE_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FAR 1e20

typedef struct {
    int width, height;
    double *d; /* squared distance of each pixel from the nearest ink */
} distance_map;

/* The lower envelope of parabolas rooted at (q, f[q]): out[q] = min over p of (q - p)^2 + f[p]. */
static void transform_row(const double *f, double *out, int n, int *root, double *from)
{
    int k = 0;
    root[0] = 0;
    from[0] = -FAR;
    from[1] = FAR;
    for (int q = 1; q < n; q++) {
        double s;
        do {
            int r = root[k];
            s = ((f[q] + (double)q * q) - (f[r] + (double)r * r)) / (2.0 * q - 2.0 * r);
        } while (s <= from[k] && --k >= 0);
        k++;
        root[k] = q;
        from[k] = s;
        from[k + 1] = FAR;
    }
    k = 0;
    for (int q = 0; q < n; q++) {
        while (from[k + 1] < q)
            k++;
        out[q] = (double)(q - root[k]) * (q - root[k]) + f[root[k]];
    }
}

static void *room(size_t n, size_t size)
{
    void *p = calloc(n, size);
    if (!p) {
        fprintf(stderr, "out of memory\n");
        exit(2);
    }
    return p;
}

static distance_map distances(const bool *marked, int width, int height)
{
    distance_map map = {width, height, room((size_t)width * (size_t)height, sizeof(double))};
    int n = width > height ? width : height;
    double *in = room((size_t)n, sizeof *in), *out = room((size_t)n, sizeof *out), *from = room((size_t)n + 1, sizeof *from);
    int *root = room((size_t)n, sizeof *root);
    for (int x = 0; x < width; x++) {
        for (int y = 0; y < height; y++)
            in[y] = marked[(size_t)y * (size_t)width + (size_t)x] ? 0 : 1e12;
        transform_row(in, out, height, root, from);
        for (int y = 0; y < height; y++)
            map.d[(size_t)y * (size_t)width + (size_t)x] = out[y];
    }
    for (int y = 0; y < height; y++) {
        double *row = map.d + (size_t)y * (size_t)width;
        transform_row(row, out, width, root, from);
        memcpy(row, out, (size_t)width * sizeof *row);
    }
    free(in);
    free(out);
    free(from);
    free(root);
    return map;
}

#endif
