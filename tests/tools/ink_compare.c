/* SPDX-License-Identifier: MIT
 *
 * ink_compare A B [TOLERANCE [THRESHOLD_A [THRESHOLD_B]]]: does the ink of two pictures lie in the same places?
 * Both are taken as grey on white; ink is every pixel darker than white by the picture's threshold or more (default
 * 8 of 255 for A, the clean reference, where anything not white was drawn; 26, a tenth, for B, the pencil). Prints
 *
 *     recall R precision P mean M ink A B
 *
 * recall: the share of A's ink that has ink of B within TOLERANCE pixels (default 3, Euclidean); precision: the same the
 * other way round; mean: the mean of both. Without ink in one picture only, both are 0; without any in either, 1.
 * The distance is exact: Felzenszwalb & Huttenlocher, "Distance transforms of sampled functions", 2012.
 */
#include "tools/png_image.h"

#include <math.h>

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

static bool is_ink(grey_image image, int x, int y, int threshold)
{
    return x < image.width && y < image.height && image.grey[(size_t)y * (size_t)image.width + (size_t)x] <= 255 - threshold;
}

static distance_map distances(grey_image image, int width, int height, int threshold)
{
    distance_map map = {width, height, room((size_t)width * (size_t)height, sizeof(double))};
    int n = width > height ? width : height;
    double *in = room((size_t)n, sizeof *in), *out = room((size_t)n, sizeof *out), *from = room((size_t)n + 1, sizeof *from);
    int *root = room((size_t)n, sizeof *root);
    for (int x = 0; x < width; x++) {
        for (int y = 0; y < height; y++)
            in[y] = is_ink(image, x, y, threshold) ? 0 : 1e12;
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

/* How many pixels of ink `image` has, and how many of them lie within `tolerance` of the ink that `map` measures from. */
static void count(grey_image image, int threshold, distance_map map, double tolerance, long *ink, long *near)
{
    *ink = *near = 0;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++)
            if (is_ink(image, x, y, threshold)) {
                ++*ink;
                *near += map.d[(size_t)y * (size_t)map.width + (size_t)x] <= tolerance * tolerance;
            }
}

static double share(long part, long whole, long other)
{
    return whole ? (double)part / (double)whole : other ? 0 : 1;
}

int main(int argc, char **argv)
{
    if (argc < 3 || argc > 6) {
        fprintf(stderr, "usage: ink_compare A B [TOLERANCE [THRESHOLD_A [THRESHOLD_B]]]\n");
        return 2;
    }
    double tolerance = argc > 3 ? argument(argv[3], 0, 1000) : 3;
    int threshold_a = argc > 4 ? (int)argument(argv[4], 1, 255) : 8;
    int threshold_b = argc > 5 ? (int)argument(argv[5], 1, 255) : 26;
    grey_image a = read_grey(argv[1]), b = read_grey(argv[2]);
    int width = a.width > b.width ? a.width : b.width, height = a.height > b.height ? a.height : b.height;
    distance_map from_a = distances(a, width, height, threshold_a), from_b = distances(b, width, height, threshold_b);
    long ink_a, near_a, ink_b, near_b;
    count(a, threshold_a, from_b, tolerance, &ink_a, &near_a);
    count(b, threshold_b, from_a, tolerance, &ink_b, &near_b);
    double recall = share(near_a, ink_a, ink_b), precision = share(near_b, ink_b, ink_a);
    printf("recall %.4f precision %.4f mean %.4f ink %ld %ld\n", recall, precision, (recall + precision) / 2, ink_a, ink_b);
    free(a.grey);
    free(b.grey);
    free(from_a.d);
    free(from_b.d);
    return 0;
}
