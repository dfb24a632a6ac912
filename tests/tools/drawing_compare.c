/* SPDX-License-Identifier: MIT
 *
 * drawing_compare PRINT DRAWING [DARKEST]: does a pencil drawing show what the print shows? Both are taken as grey on white, at
 * 96 dpi. Prints
 *
 *     recall R precision P tone T print N areas N drawing N
 *
 * The program first tells apart what the print shows. Its ground is what is left when features thinner than 9 pixels are taken
 * away (a grey closing); if most of the picture's border has one grey of the ground, that is its paper,
 * which a drawing leaves white. Lines are where the print is darker than its ground; areas are where the ground is darker than
 * the paper; their edges are where the ground changes.
 *
 * recall: the share of the pixels of lines, and of edges of areas against something lighter, that have ink of the drawing
 * within 3 pixels. precision: the share of the drawing's ink that lies within 3 pixels of anything the print shows.
 * tone: the share of the blocks of 24 x 24 pixels, of those that lie in areas of one grey, whose mean darkness in the
 * drawing is within 0.1 of the print's; where that is darker than DARKEST (0 paper to 1 black, the default), of DARKEST, as
 * dark as the pencil can be. 1 without such blocks.
 */
#include "tools/distance.h"
#include "tools/png_image.h"

#include <math.h>

#define REACH 4          /* of the closing, pixels: 9 x 9 */
#define TOLERANCE 3.0    /* pixels, Euclidean */
#define SHOWN 8          /* of 255: what is this much darker than its ground is there */
#define EDGE 24          /* of 255: a step of the ground that a hand would outline */
#define DRAWN 20         /* of 255: what counts as ink of the pencil */
#define BLOCK 24         /* pixels */
#define TONE_STEP 0.1    /* of black to white */
#define PAPER_SHARE 0.6  /* of the border */

typedef struct {
    int width, height;
    uint8_t *grey;
} picture;

static size_t index_of(picture p, int x, int y)
{
    return (size_t)y * (size_t)p.width + (size_t)x;
}

/* Puts the image on a page of that size. */
static picture fit(grey_image image, int width, int height)
{
    picture p = {width, height, room((size_t)width * (size_t)height, 1)};
    memset(p.grey, 255, (size_t)width * (size_t)height);
    for (int y = 0; y < image.height; y++)
        memcpy(p.grey + index_of(p, 0, y), image.grey + (size_t)y * (size_t)image.width, (size_t)image.width);
    return p;
}

/* Returns, for each pixel, the lightest or the darkest one within REACH along one axis. */
static picture extreme(picture from, bool across, bool lightest)
{
    picture to = {from.width, from.height, room((size_t)from.width * (size_t)from.height, 1)};
    for (int y = 0; y < from.height; y++)
        for (int x = 0; x < from.width; x++) {
            uint8_t best = from.grey[index_of(from, x, y)];
            for (int k = -REACH; k <= REACH; k++) {
                int u = across ? x + k : x, v = across ? y : y + k;
                if (u < 0 || v < 0 || u >= from.width || v >= from.height)
                    continue;
                uint8_t g = from.grey[index_of(from, u, v)];
                best = (lightest ? g > best : g < best) ? g : best;
            }
            to.grey[index_of(to, x, y)] = best;
        }
    return to;
}

static picture ground_of(picture print)
{
    picture p = print;
    for (int pass = 0; pass < 4; pass++) { /* dilate, then erode, along both axes */
        picture next = extreme(p, pass & 1, pass < 2);
        if (pass)
            free(p.grey);
        p = next;
    }
    return p;
}

/* Returns the grey that most of the border has, or white. */
static int paper_of(picture ground)
{
    long count[256] = {0}, whole = 0;
    for (int x = 0; x < ground.width; x++)
        count[ground.grey[index_of(ground, x, 0)]]++, count[ground.grey[index_of(ground, x, ground.height - 1)]]++, whole += 2;
    for (int y = 0; y < ground.height; y++)
        count[ground.grey[index_of(ground, 0, y)]]++, count[ground.grey[index_of(ground, ground.width - 1, y)]]++, whole += 2;
    for (int g = 128; g < 255; g++)
        if ((double)count[g] > PAPER_SHARE * (double)whole)
            return g;
    return 255;
}

static void leave_white(picture p, int paper)
{
    for (size_t i = 0; i < (size_t)p.width * (size_t)p.height; i++)
        if (p.grey[i] >= paper - 1)
            p.grey[i] = 255;
}

/* Tells whether the pixel is on the dark side of a step of the ground. */
static bool is_edge(picture ground, int x, int y)
{
    static const int dx[] = {1, -1, 0, 0}, dy[] = {0, 0, 1, -1};
    for (int k = 0; k < 4; k++) {
        int u = x + dx[k], v = y + dy[k];
        if (u >= 0 && v >= 0 && u < ground.width && v < ground.height &&
            ground.grey[index_of(ground, u, v)] - ground.grey[index_of(ground, x, y)] >= EDGE)
            return true;
    }
    return false;
}

/* The share of `marked` that lies near what `map` measures from. */
static double share_near(const bool *marked, distance_map map, long *n)
{
    long near = 0;
    *n = 0;
    for (size_t i = 0; i < (size_t)map.width * (size_t)map.height; i++)
        if (marked[i]) {
            ++*n;
            near += map.d[i] <= TOLERANCE * TOLERANCE;
        }
    return *n ? (double)near / (double)*n : 1;
}

/* The mean darkness of the block in both, if it is an area of one grey. */
static bool measure_block(picture ground, picture drawing, double darkest, int x0, int y0, double *wanted, double *found)
{
    int low = 255, high = 0;
    double sum = 0;
    for (int y = y0; y < y0 + BLOCK; y++)
        for (int x = x0; x < x0 + BLOCK; x++) {
            int g = ground.grey[index_of(ground, x, y)];
            low = g < low ? g : low;
            high = g > high ? g : high;
            sum += 255 - drawing.grey[index_of(drawing, x, y)];
        }
    *wanted = fmin(1 - (low + high) / 510.0, darkest);
    *found = sum / 255 / (BLOCK * BLOCK);
    return high - low <= EDGE / 2 && high < 255 - SHOWN;
}

static double compare_tones(picture ground, picture drawing, double darkest)
{
    long blocks = 0, good = 0;
    for (int y = 0; y + BLOCK <= ground.height; y += BLOCK)
        for (int x = 0; x + BLOCK <= ground.width; x += BLOCK) {
            double wanted, found;
            if (measure_block(ground, drawing, darkest, x, y, &wanted, &found)) {
                blocks++;
                good += fabs(wanted - found) <= TONE_STEP;
            }
        }
    return blocks ? (double)good / (double)blocks : 1;
}

int main(int argc, char **argv)
{
    if (argc < 3 || argc > 4) {
        fprintf(stderr, "usage: drawing_compare PRINT DRAWING [DARKEST]\n");
        return 2;
    }
    double darkest = argc > 3 ? argument(argv[3], 0, 1) : 1;
    grey_image a = read_grey(argv[1]), b = read_grey(argv[2]);
    int width = a.width > b.width ? a.width : b.width, height = a.height > b.height ? a.height : b.height;
    picture print = fit(a, width, height), drawing = fit(b, width, height), ground = ground_of(print);
    int paper = paper_of(ground);
    leave_white(print, paper);
    leave_white(ground, paper);
    size_t n = (size_t)width * (size_t)height;
    bool *wanted = room(n, sizeof *wanted), *shown = room(n, sizeof *shown), *drawn = room(n, sizeof *drawn);
    long areas = 0, lines, ink;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            size_t i = index_of(print, x, y);
            bool is_line = ground.grey[i] - print.grey[i] >= SHOWN, is_area = ground.grey[i] <= 255 - SHOWN;
            wanted[i] = is_line || is_edge(ground, x, y);
            shown[i] = is_line || is_area;
            drawn[i] = drawing.grey[i] <= 255 - DRAWN;
            areas += is_area;
        }
    distance_map from_drawn = distances(drawn, width, height), from_shown = distances(shown, width, height);
    double recall = share_near(wanted, from_drawn, &lines), precision = share_near(drawn, from_shown, &ink);
    printf("recall %.4f precision %.4f tone %.4f print %ld areas %ld drawing %ld\n", recall, precision, compare_tones(ground, drawing, darkest), lines, areas, ink);
    void *held[] = {a.grey, b.grey, print.grey, drawing.grey, ground.grey, wanted, shown, drawn, from_drawn.d, from_shown.d};
    for (size_t i = 0; i < sizeof held / sizeof *held; i++)
        free(held[i]);
    return 0;
}
