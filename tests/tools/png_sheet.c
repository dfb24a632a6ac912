/* SPDX-License-Identifier: MIT
 *
 * png_sheet OUT [-c COLUMNS] [-g GAP] [-m MOST] [-z ZOOM] [-x X,Y,W,H] FILE...: puts pictures on one white sheet, in 8-bit grey,
 * row by row, each at the left top of its cell. -z enlarges the files that follow, every pixel becoming a square of
 * ZOOM by ZOOM; -x cuts a rectangle out of them first (0,0,0,0: all of it, the default); -m brings those that are wider
 * or higher than MOST pixels below that, by a whole number (0: as they are). GAP is the white between cells.
 */
#include "tools/grey_write.h"
#include "tools/png_image.h"

#include <stdbool.h>

#define CELLS_MAX 256

typedef struct {
    grey_image image;
    int most, zoom, x, y, width, height; /* the rectangle to show, in pixels of the image */
} cell;

typedef struct {
    int columns, gap, n;
    cell cells[CELLS_MAX];
} sheet;

static void usage(void)
{
    fprintf(stderr, "usage: png_sheet OUT [-c COLUMNS] [-g GAP] [-m MOST] [-z ZOOM] [-x X,Y,W,H] FILE...\n");
    exit(2);
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* Every `by` by `by` pixels become their mean, in place. */
static void reduce(grey_image *image, int by)
{
    int width = image->width / by, height = image->height / by;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            long sum = 0;
            for (int v = y * by; v < (y + 1) * by; v++)
                for (int u = x * by; u < (x + 1) * by; u++)
                    sum += image->grey[(size_t)v * (size_t)image->width + (size_t)u];
            image->grey[(size_t)y * (size_t)width + (size_t)x] = (uint8_t)(sum / (by * by)); /* behind what is read */
        }
    image->width = width;
    image->height = height;
}

static void add(sheet *s, const cell *as, const char *file)
{
    if (s->n == CELLS_MAX)
        usage();
    cell *c = &s->cells[s->n++];
    *c = *as;
    c->image = read_grey(file);
    int side = c->image.width > c->image.height ? c->image.width : c->image.height;
    if (as->most && side > as->most && c->image.width >= side / as->most + 1 && c->image.height >= side / as->most + 1)
        reduce(&c->image, (side + as->most - 1) / as->most);
    c->x = least(c->x, c->image.width - 1);
    c->y = least(c->y, c->image.height - 1);
    c->width = least(c->width ? c->width : c->image.width, c->image.width - c->x);
    c->height = least(c->height ? c->height : c->image.height, c->image.height - c->y);
}

static void read_rectangle(const char *text, cell *c)
{
    if (sscanf(text, "%d,%d,%d,%d", &c->x, &c->y, &c->width, &c->height) != 4 || c->x < 0 || c->y < 0 || c->width < 0 || c->height < 0)
        usage();
}

static void read_arguments(sheet *s, int argc, char **argv)
{
    cell as = {.zoom = 1};
    for (int k = 2; k < argc; k++) {
        const char *a = argv[k];
        bool option = a[0] == '-' && a[1] && !a[2];
        if (option && ++k == argc)
            usage();
        switch (option ? a[1] : 0) {
        case 0: add(s, &as, a); break;
        case 'c': s->columns = (int)argument(argv[k], 1, CELLS_MAX); break;
        case 'g': s->gap = (int)argument(argv[k], 0, 1000); break;
        case 'm': as.most = (int)argument(argv[k], 0, 100000); break;
        case 'z': as.zoom = (int)argument(argv[k], 1, 64); break;
        case 'x': read_rectangle(argv[k], &as); break;
        default: usage();
        }
    }
}

static void paint(const cell *c, uint8_t *page, int page_width, int left, int top)
{
    for (int y = 0; y < c->height * c->zoom; y++)
        for (int x = 0; x < c->width * c->zoom; x++) {
            size_t from = (size_t)(c->y + y / c->zoom) * (size_t)c->image.width + (size_t)(c->x + x / c->zoom);
            page[(size_t)(top + y) * (size_t)page_width + (size_t)(left + x)] = c->image.grey[from];
        }
}

/* The first pixel of each column and row of cells, and past the last one the size of the page. */
static void lay_out(const sheet *s, int left[CELLS_MAX + 1], int top[CELLS_MAX + 1], int rows)
{
    memset(left, 0, (CELLS_MAX + 1) * sizeof *left);
    memset(top, 0, (CELLS_MAX + 1) * sizeof *top);
    for (int k = 0; k < s->n; k++) {
        const cell *c = &s->cells[k];
        int *w = &left[k % s->columns + 1], *h = &top[k / s->columns + 1];
        *w = c->width * c->zoom > *w ? c->width * c->zoom : *w;
        *h = c->height * c->zoom > *h ? c->height * c->zoom : *h;
    }
    for (int k = 1; k <= s->columns; k++)
        left[k] += left[k - 1] + (k < s->columns ? s->gap : 0);
    for (int k = 1; k <= rows; k++)
        top[k] += top[k - 1] + (k < rows ? s->gap : 0);
}

int main(int argc, char **argv)
{
    static sheet s = {.columns = 1, .gap = 8};
    static int left[CELLS_MAX + 1], top[CELLS_MAX + 1];
    if (argc < 3)
        usage();
    read_arguments(&s, argc, argv);
    if (s.n == 0)
        usage();
    int rows = (s.n + s.columns - 1) / s.columns;
    lay_out(&s, left, top, rows);
    size_t size = (size_t)left[s.columns] * (size_t)top[rows];
    uint8_t *page = malloc(size);
    if (!page) {
        fprintf(stderr, "png_sheet: out of memory\n");
        return 2;
    }
    memset(page, 255, size);
    for (int k = 0; k < s.n; k++)
        paint(&s.cells[k], page, left[s.columns], left[k % s.columns], top[k / s.columns]);
    write_grey(argv[1], left[s.columns], top[rows], page);
    for (int k = 0; k < s.n; k++)
        free(s.cells[k].image.grey);
    free(page);
    return 0;
}
