/* SPDX-License-Identifier: MIT
 *
 * path_axis DRAWN.svg DRAWN.png: how far the ink of a picture lies beside the paths of an SVG that plumbago wrote from the same
 * drawing. Across each path, every STEP mm, it takes the centre of the darkness within REACH mm; over windows of the path these
 * are averaged, since grain moves each. Lines must lie farther apart than that. Prints "paths N length MM windows N worst MM mean MM
 * twice N", where the last counts paths that are there before. Exit status 2: something cannot be read.
 */
#include "tools/png_image.h"

#include <math.h>

#define STEP 0.1
#define REACH 1.0
#define WINDOW 4.0
#define ENDS 2.0 /* mm that are left out: ends are drawn in ways of their own, and meet other lines */
#define MAX_PATHS 10000

typedef struct {
    grey_image png;
    double px; /* pixels for each mm */
    double sum;
    int n;         /* of the window at hand */
    double left;   /* of the path, mm, up to the next step */
    double passed, until; /* of the path; beyond `until` nothing is measured */
    double length, worst, mean;
    long windows;
} axis;

static double darkness(const axis *a, double x, double y)
{
    int cx = (int)floor(x * a->px), cy = (int)floor(y * a->px);
    bool on = cx >= 0 && cy >= 0 && cx < a->png.width && cy < a->png.height;
    return on ? 255 - a->png.grey[(size_t)cy * (size_t)a->png.width + (size_t)cx] : 0;
}

/* The centre of the ink across a direction (unit vector) at a place. */
static void measure(axis *a, double x, double y, double dx, double dy)
{
    double sum = 0, moment = 0;
    for (double off = -REACH; off <= REACH; off += 0.25 / a->px) {
        double d = darkness(a, x + dy * off, y - dx * off);
        sum += d;
        moment += d * off;
    }
    if (sum <= 0)
        return;
    a->sum += moment / sum;
    if (++a->n >= WINDOW / STEP) {
        double off = fabs(a->sum / a->n);
        a->worst = fmax(a->worst, off);
        a->mean += off;
        a->windows++;
        a->sum = a->n = 0;
    }
}

static void follow(axis *a, double x0, double y0, double x1, double y1)
{
    double l = hypot(x1 - x0, y1 - y0);
    a->passed += l;
    for (; l > 0 && a->left <= l && a->passed - l + a->left < a->until; a->left += STEP)
        measure(a, x0 + (x1 - x0) * a->left / l, y0 + (y1 - y0) * a->left / l, (x1 - x0) / l, (y1 - y0) / l);
    a->left -= l;
}

/* m, l and c, relative, as plumbago writes them. */
static void read_path(axis *a, const char *d, double until)
{
    double x = 0, y = 0;
    a->sum = a->n = 0;
    a->left = ENDS;
    a->passed = 0;
    a->until = until;
    while (*d && *d != '"') {
        char op = *d++, *end;
        double v[6] = {0};
        for (int k = 0; k < (op == 'c' ? 6 : op == 'z' ? 0 : 2); k++, d = end)
            v[k] = strtod(d, &end);
        int n = op == 'c' ? 40 : 1;
        double to_x = v[op == 'c' ? 4 : 0], to_y = v[op == 'c' ? 5 : 1], px = 0, py = 0;
        for (int i = 1; op != 'm' && op != 'z' && i <= n; i++) {
            double t = (double)i / n, s = 1 - t;
            double qx = op == 'l' ? to_x : 3 * s * s * t * v[0] + 3 * s * t * t * v[2] + t * t * t * v[4];
            double qy = op == 'l' ? to_y : 3 * s * s * t * v[1] + 3 * s * t * t * v[3] + t * t * t * v[5];
            follow(a, x + px, y + py, x + qx, y + qy);
            px = qx;
            py = qy;
        }
        x += to_x;
        y += to_y;
    }
}

int main(int argc, char **argv)
{
    static char line[1 << 20];
    static char *seen[MAX_PATHS];
    FILE *svg = argc == 3 ? fopen(argv[1], "r") : NULL;
    axis a = {0};
    int paths = 0, twice = 0;
    if (!svg) {
        fprintf(stderr, "usage: path_axis DRAWN.svg DRAWN.png\n");
        return 2;
    }
    a.png = read_grey(argv[2]);
    while (fgets(line, sizeof line, svg)) {
        char *box = strstr(line, "viewBox=\"0 0 "), *d = strstr(line, "<path d=\"");
        if (box)
            a.px = a.png.width / strtod(box + 13, NULL);
        if (!d || paths == MAX_PATHS)
            continue;
        seen[paths] = strdup(d);
        for (int k = 0; k < paths; k++)
            twice += !strcmp(seen[k], seen[paths]);
        paths++;
        read_path(&a, d + 9, 0);
        a.length += a.passed;
        read_path(&a, d + 9, a.passed - ENDS);
    }
    fclose(svg);
    for (int k = 0; k < paths; k++)
        free(seen[k]);
    free(a.png.grey);
    printf("paths %d length %.1f windows %ld worst %.3f mean %.4f twice %d\n", paths, a.length, a.windows, a.worst, a.windows ? a.mean / (double)a.windows : 0, twice);
    return a.windows == 0;
}
