/* SPDX-License-Identifier: MIT
 *
 * png_stats FILE [THRESHOLD]: what a picture holds, as grey on white: "min M mean M max M ink N box X0 Y0 X1 Y1".
 * Ink is every pixel darker than white by THRESHOLD (default 25) or more; the box bounds it.
 */
#include "tools/png_image.h"

int main(int argc, char **argv)
{
    if (argc != 2 && argc != 3) {
        fprintf(stderr, "usage: png_stats FILE [THRESHOLD]\n");
        return 2;
    }
    grey_image image = read_grey(argv[1]);
    int threshold = argc == 3 ? (int)argument(argv[2], 1, 255) : 25;
    int min = 255, max = 0, x0 = image.width, y0 = image.height, x1 = -1, y1 = -1;
    long ink = 0;
    double sum = 0;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            int grey = image.grey[(size_t)y * (size_t)image.width + (size_t)x];
            sum += grey;
            min = grey < min ? grey : min;
            max = grey > max ? grey : max;
            if (grey > 255 - threshold)
                continue;
            ink++;
            x0 = x < x0 ? x : x0;
            x1 = x > x1 ? x : x1;
            y0 = y < y0 ? y : y0;
            y1 = y > y1 ? y : y1;
        }
    printf("min %d mean %.3f max %d ink %ld box %d %d %d %d\n", min, sum / image.width / image.height, max, ink, x0, y0, x1, y1);
    free(image.grey);
    return 0;
}
