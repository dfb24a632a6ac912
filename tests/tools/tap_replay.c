/* SPDX-License-Identifier: MIT
 *
 * Does what tap-svg writes show the whole drawing? Replays it by cairo's own interpreter of CairoScript and compares
 * with a reference picture of the same page.
 *
 *     tap_replay REFERENCE.png <SCRIPT        prints RECALL PRECISION
 *
 * The script is recorded, turned back by the head line's matrix and drawn at the reference's size. Recall: the part of
 * the reference's ink that has ink of the replay within a pixel (the turn moves what a raster makes of an edge);
 * precision the same the other way round. Exit status 0 when both are at least 0.99.
 */
#include <cairo-script-interpreter.h>
#include <cairo.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ENOUGH 0.99
#define INK 96   /* alpha that surely is ink */
#define TRACE 16 /* alpha that may be the rim of ink */

typedef struct {
    double width, height; /* mm */
    cairo_matrix_t back;  /* script units to mm */
} head;

static bool read_head(const char *text, head *h)
{
    return sscanf(text, "%%%%Plumbago-tap 1 %lf %lf %lf %lf %lf %lf %lf %lf", &h->width, &h->height, &h->back.xx, &h->back.yx,
                  &h->back.xy, &h->back.yy, &h->back.x0, &h->back.y0) == 8;
}

static char *read_stdin(size_t *size)
{
    size_t room = 1 << 20;
    char *text = malloc(room);
    *size = 0;
    while (text) {
        size_t n = fread(text + *size, 1, room - 1 - *size, stdin);
        if (n == 0)
            break;
        *size += n;
        if (*size == room - 1) {
            char *more = realloc(text, room *= 2);
            if (!more)
                free(text);
            text = more;
        }
    }
    if (text)
        text[*size] = '\0';
    return text;
}

/* The interpreter asks for the page's surface: it gets the recording. */
static cairo_surface_t *give_surface(void *closure, cairo_content_t content, double width, double height, long id)
{
    (void)content, (void)width, (void)height, (void)id;
    return cairo_surface_reference(closure);
}

static cairo_t *give_context(void *closure, cairo_surface_t *surface)
{
    (void)closure;
    return cairo_create(surface);
}

static bool replay(const char *text, size_t size, cairo_surface_t *recording)
{
    cairo_script_interpreter_hooks_t hooks = {.closure = recording, .surface_create = give_surface, .context_create = give_context};
    cairo_script_interpreter_t *csi = cairo_script_interpreter_create();
    cairo_script_interpreter_install_hooks(csi, &hooks);
    cairo_status_t status = CAIRO_STATUS_SUCCESS;
    const int most = 1 << 20;
    for (size_t done = 0; done < size && !status;) {
        size_t part = size - done < (size_t)most ? size - done : (size_t)most;
        const char *end = memchr(text + done + part - 1, '\n', size - (done + part - 1)); /* whole lines only */
        part = end ? (size_t)(end - text) + 1 - done : size - done;
        status = cairo_script_interpreter_feed_string(csi, text + done, (int)part);
        done += part;
    }
    cairo_status_t finished = cairo_script_interpreter_destroy(csi);
    if (status || finished)
        fprintf(stderr, "the interpreter stopped: %s\n", cairo_status_to_string(status ? status : finished));
    return !status && !finished;
}

static cairo_surface_t *draw_back(cairo_surface_t *recording, const head *h, int width, int height)
{
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    cairo_t *cr = cairo_create(image);
    cairo_scale(cr, width / h->width, height / h->height);
    cairo_transform(cr, &h->back);
    cairo_set_source_surface(cr, recording, 0, 0);
    cairo_paint(cr);
    cairo_destroy(cr);
    cairo_surface_flush(image);
    return image;
}

static int alpha_at(cairo_surface_t *image, int x, int y)
{
    const unsigned char *row = cairo_image_surface_get_data(image) + (ptrdiff_t)y * cairo_image_surface_get_stride(image);
    uint32_t pixel;
    memcpy(&pixel, row + 4 * (ptrdiff_t)x, sizeof pixel);
    return (int)(pixel >> 24);
}

static bool has_trace_near(cairo_surface_t *image, int x, int y)
{
    int w = cairo_image_surface_get_width(image), h = cairo_image_surface_get_height(image);
    for (int v = y - 1; v <= y + 1; v++)
        for (int u = x - 1; u <= x + 1; u++)
            if (u >= 0 && v >= 0 && u < w && v < h && alpha_at(image, u, v) >= TRACE)
                return true;
    return false;
}

/* The part of `a`'s ink that `b` has too. */
static double share(cairo_surface_t *a, cairo_surface_t *b)
{
    long ink = 0, found = 0;
    for (int y = 0; y < cairo_image_surface_get_height(a); y++)
        for (int x = 0; x < cairo_image_surface_get_width(a); x++)
            if (alpha_at(a, x, y) >= INK) {
                ink++;
                found += has_trace_near(b, x, y);
            }
    return ink ? (double)found / (double)ink : 1;
}

int main(int argc, char **argv)
{
    head h;
    size_t size;
    char *text = read_stdin(&size);
    if (argc != 2 || !text || !read_head(text, &h)) {
        fprintf(stderr, "usage: tap_replay REFERENCE.png <SCRIPT\n");
        return 2;
    }
    cairo_surface_t *png = cairo_image_surface_create_from_png(argv[1]);
    int width = cairo_image_surface_get_width(png), height = cairo_image_surface_get_height(png);
    cairo_surface_t *reference = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    cairo_t *cr = cairo_create(reference);
    cairo_set_source_surface(cr, png, 0, 0);
    cairo_paint(cr);
    cairo_destroy(cr);
    cairo_surface_flush(reference);
    if (cairo_surface_status(png)) {
        fprintf(stderr, "%s: %s\n", argv[1], cairo_status_to_string(cairo_surface_status(png)));
        return 2;
    }
    cairo_surface_t *recording = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    if (!replay(text, size, recording))
        return 1;
    cairo_surface_t *image = draw_back(recording, &h, width, height);
    double recall = share(reference, image), precision = share(image, reference);
    printf("%.4f %.4f\n", recall, precision);
    cairo_surface_destroy(image);
    cairo_surface_destroy(recording);
    cairo_surface_destroy(reference);
    cairo_surface_destroy(png);
    free(text);
    return recall >= ENOUGH && precision >= ENOUGH ? 0 : 1;
}
