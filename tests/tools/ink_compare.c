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
 */
#include "tools/distance.h"
#include "tools/png_image.h"

#include <math.h>

static bool is_ink(grey_image image, int x, int y, int threshold)
{
    return x < image.width && y < image.height && image.grey[(size_t)y * (size_t)image.width + (size_t)x] <= 255 - threshold;
}

static distance_map distances_to_ink(grey_image image, int width, int height, int threshold)
{
    bool *marked = room((size_t)width * (size_t)height, sizeof *marked);
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++)
            marked[(size_t)y * (size_t)width + (size_t)x] = is_ink(image, x, y, threshold);
    distance_map map = distances(marked, width, height);
    free(marked);
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
    distance_map from_a = distances_to_ink(a, width, height, threshold_a), from_b = distances_to_ink(b, width, height, threshold_b);
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
