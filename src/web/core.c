/* SPDX-License-Identifier: MIT
 *
 * This file is what the script calls: the library's calls, with texts and pixels at addresses of the instance's memory. Each
 * function that can fail leaves why in the text that web_error returns.
 */
#include "api/plumbago.h"
#include "base/array.h"
#include "web/pencils.h"

#include <string.h>

#define EXPORT(name) __attribute__((export_name(#name)))

/* The script's own functions: one takes warnings (level 0) and details (1), the other says whether the work goes on. */
__attribute__((import_module("plumbago"), import_name("message"))) void plb_web_message(int level, const char *text, size_t size);
__attribute__((import_module("plumbago"), import_name("progress"))) int plb_web_progress(double done);

/* A WebAssembly instance is one process with one thread: this is its state. */
static plb_error last;

static void say(void *closure, int level, const char *text)
{
    (void)closure;
    plb_web_message(level, text, strlen(text));
}

static bool report(void *closure, double done)
{
    (void)closure;
    return plb_web_progress(done) != 0;
}

EXPORT(web_error) const char *plb_web_error(void)
{
    return last.text;
}

EXPORT(web_missing) const char *plb_web_missing(void)
{
    return plb_web_missing_pencil();
}

/* Returns `size` bytes for the script, NULL when there are none; web_free takes them back. */
EXPORT(web_new) void *plb_web_new(size_t size)
{
    return plb_new(size, 1);
}

EXPORT(web_free) void plb_web_free(void *bytes)
{
    plb_free(bytes);
}

/* Keeps a pencil's file, whose bytes then belong to the core. */
EXPORT(web_pencil) bool plb_web_pencil(const char *grade, const unsigned char *data, size_t size)
{
    return plb_web_keep_pencil(grade, data, size);
}

/* Returns a copy of `from`, which shares its pencil, or options with the defaults for NULL; the script frees them with
 * web_options_free. NULL: the pencil HB is missing, or memory. */
EXPORT(web_options) plb_options *plb_web_options(const plb_options *from)
{
    plb_options *o = from ? plb_options_copy(from) : plb_options_new();
    if (o)
        plb_options_set_message(o, say, NULL), plb_options_set_progress(o, report, NULL);
    return o;
}

EXPORT(web_options_free) void plb_web_options_free(plb_options *o)
{
    plb_options_free(o);
}

EXPORT(web_set) bool plb_web_set(plb_options *o, const char *name, const char *value)
{
    return plb_options_set(o, name, value, &last);
}

/* Plans the drawing of a list's text, plumbago-list(5). The script frees the result; NULL: it fails. */
EXPORT(web_draw) plb_drawing *plb_web_draw(const char *text, size_t size, const plb_options *o)
{
    plb_file *f = plb_file_from_memory(text, size, "list", &last);
    plb_drawing *d = f ? plb_file_draw(f, o, &last) : NULL;
    plb_file_free(f);
    return d;
}

EXPORT(web_drawing_free) void plb_web_drawing_free(plb_drawing *d)
{
    plb_drawing_free(d);
}

/* Gives the page: width and height in mm, then in pixels, then the number of strokes. */
EXPORT(web_page) bool plb_web_page(const plb_drawing *d, const plb_options *o, double page[5])
{
    int width, height;
    if (!plb_drawing_size(d, &width, &height, o, &last))
        return false;
    page[0] = plb_drawing_width(d);
    page[1] = plb_drawing_height(d);
    page[2] = width;
    page[3] = height;
    page[4] = (double)plb_drawing_strokes(d);
    return true;
}

/* Draws `height` rows of the page, from row `top`, as red, green, blue and alpha. */
EXPORT(web_render) bool plb_web_render(const plb_drawing *d, const plb_options *o, void *pixels, int width, int top, int height)
{
    plb_pixels to = {.data = pixels, .stride = (size_t)width * 4, .format = PLB_PIXELS_RGBA, .y = top, .width = width, .height = height};
    return plb_drawing_render_pixels(d, &to, o, &last);
}

/* Gives the figures of a stroke: kind, pressure, colour, width in mm, closed. */
EXPORT(web_stroke) bool plb_web_stroke(const plb_drawing *d, size_t index, double figures[5])
{
    plb_stroke s;
    if (!plb_drawing_stroke(d, index, &s))
        return false;
    figures[0] = s.kind;
    figures[1] = s.pressure;
    figures[2] = s.colour;
    figures[3] = s.width;
    figures[4] = s.closed;
    return true;
}

/* Returns the path of the hand along a stroke, `*n` points in mm, which the script frees; NULL: it fails. */
EXPORT(web_trace) plb_point *plb_web_trace(const plb_drawing *d, size_t index, size_t *n, const plb_options *o)
{
    return plb_drawing_trace(d, index, n, o, &last);
}
