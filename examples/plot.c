/* SPDX-License-Identifier: MIT
 *
 * A program that draws its own plot: a swinging that dies away, its envelope dashed, and the energy that is left as bars, in coloured
 * pencils. Writes plot.pdf, or the file that is named.
 * Build: cc plot.c $(pkg-config --cflags --libs plumbago) -lm -o plot
 */
#include <plumbago.h>

#include <math.h>

#define LEFT 12.0
#define RIGHT 132.0
#define TOP 8.0
#define BOTTOM 78.0
#define MIDDLE ((TOP + BOTTOM) / 2)

/* Where a time from 0 to 10 s and a swing from -1 to 1 lie on the page. */
static double at_x(double t) { return LEFT + (RIGHT - LEFT) * t / 10; }
static double at_y(double v) { return MIDDLE - (BOTTOM - TOP) / 2 * v; }

static double swing(double t) { return exp(-t / 4) * cos(4 * t); }
static double envelope(double t) { return exp(-t / 4); }
static double lower_envelope(double t) { return -exp(-t / 4); }

static void axes(plb_canvas *c)
{
    plb_canvas_move_to(c, LEFT, TOP);
    plb_canvas_line_to(c, LEFT, BOTTOM);
    plb_canvas_stroke(c);
    plb_canvas_move_to(c, LEFT, MIDDLE);
    plb_canvas_line_to(c, RIGHT + 4, MIDDLE);
    plb_canvas_stroke(c);
    for (int t = 1; t <= 10; t++) {
        plb_canvas_move_to(c, at_x(t), MIDDLE - 1.2);
        plb_canvas_line_to(c, at_x(t), MIDDLE + 1.2);
        plb_canvas_stroke(c);
    }
}

static void curve(plb_canvas *c, double (*f)(double))
{
    plb_canvas_move_to(c, at_x(0), at_y(f(0)));
    for (int i = 1; i <= 400; i++)
        plb_canvas_line_to(c, at_x(i / 40.0), at_y(f(i / 40.0)));
    plb_canvas_stroke(c);
}

static void bars(plb_canvas *c)
{
    for (int t = 0; t < 10; t++) {
        double left = at_x(t + 0.3), right = at_x(t + 0.7), height = 20 * envelope(t) * envelope(t);
        plb_canvas_move_to(c, left, BOTTOM + 24);
        plb_canvas_line_to(c, left, BOTTOM + 24 - height);
        plb_canvas_line_to(c, right, BOTTOM + 24 - height);
        plb_canvas_line_to(c, right, BOTTOM + 24);
        plb_canvas_close_path(c);
        plb_canvas_fill(c);
    }
}

static void plot(plb_canvas *c)
{
    axes(c);
    plb_canvas_set_colour(c, 0.45, 0.45, 0.45, 1);
    plb_canvas_set_dash(c, (const double[]){3, 2}, 2, 0);
    curve(c, envelope);
    curve(c, lower_envelope);
    plb_canvas_set_dash(c, NULL, 0, 0);
    plb_canvas_set_colour(c, 0.75, 0.15, 0.1, 1);
    plb_canvas_set_width(c, 0.6);
    curve(c, swing);
    plb_canvas_set_colour(c, 0.15, 0.3, 0.65, 1);
    bars(c);
}

int main(int argc, char **argv)
{
    const char *file = argc > 1 ? argv[1] : "plot.pdf";
    plb_error error;
    plb_canvas *c = plb_canvas_new(144, 108, &error);
    plb_options *options = plb_options_new();
    bool ok = c && options && plb_options_set(options, "colour", "on", &error);
    if (ok)
        plot(c);
    plb_drawing *drawing = ok ? plb_canvas_draw(c, options, &error) : NULL;
    ok = drawing && plb_drawing_write(drawing, file, options, &error);
    if (!ok)
        fprintf(stderr, "plot: %s\n", c && options ? error.text : "out of memory");
    plb_drawing_free(drawing);
    plb_options_free(options);
    plb_canvas_free(c);
    return !ok;
}
