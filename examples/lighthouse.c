/* SPDX-License-Identifier: MIT
 *
 * A drawing from memory: a lighthouse on its rock, made of paths on a canvas. Fills become hatching, a clip keeps the beams in the
 * sky, and the same drawing is written as pixels and as the hand's paths. Writes lighthouse.png and lighthouse.svg.
 * Build: cc lighthouse.c $(pkg-config --cflags --libs plumbago) -lm -o lighthouse
 */
#include <plumbago.h>

#include <math.h>

/* Draws a closed shape of `n` corners, filled with a grey and outlined. */
static void shape(plb_canvas *c, const double corners[][2], int n, double grey)
{
    for (int pass = 0; pass < 2; pass++) {
        plb_canvas_move_to(c, corners[0][0], corners[0][1]);
        for (int i = 1; i < n; i++)
            plb_canvas_line_to(c, corners[i][0], corners[i][1]);
        plb_canvas_close_path(c);
        plb_canvas_set_colour(c, pass ? 0 : grey, pass ? 0 : grey, pass ? 0 : grey, 1);
        (pass ? plb_canvas_stroke : plb_canvas_fill)(c);
    }
}

static void sky(plb_canvas *c)
{
    /* The beams are dashed and reach only above the horizon. */
    plb_canvas_move_to(c, 5, 5);
    plb_canvas_line_to(c, 115, 5);
    plb_canvas_line_to(c, 115, 92);
    plb_canvas_line_to(c, 5, 92);
    plb_canvas_clip(c);
    plb_canvas_set_dash(c, (const double[]){9, 4}, 2, 0);
    for (int i = -5; i <= 5; i++) {
        plb_canvas_move_to(c, 67, 29 + i);
        plb_canvas_line_to(c, 130, 29 + i * 14.0);
        plb_canvas_stroke(c);
    }
    plb_canvas_set_dash(c, NULL, 0, 0);
    plb_canvas_reset_clip(c);
}

static void tower(plb_canvas *c)
{
    /* The tower grows from the bottom up: each band is somewhat narrower than the one below, every other one is dark. */
    for (int i = 0; i < 5; i++) {
        double y = 104 - i * 14.0, half = 11 - i * 1.2, above = half - 1.2;
        shape(c, (const double[][2]){{60 - half, y}, {60 - above, y - 14}, {60 + above, y - 14}, {60 + half, y}}, 4, i % 2 ? 1 : 0.35);
    }
    shape(c, (const double[][2]){{51, 34}, {69, 34}, {67, 31}, {53, 31}}, 4, 0.6);
    shape(c, (const double[][2]){{56, 31}, {56, 24}, {64, 24}, {64, 31}}, 4, 1);
    shape(c, (const double[][2]){{54, 24}, {60, 17}, {66, 24}}, 3, 0.2);
}

static void sea(plb_canvas *c)
{
    for (int row = 0; row < 7; row++)
        for (double x = 8 + row % 2 * 7; x < 100; x += 24) {
            double y = 112 + row * 5.0;
            plb_canvas_move_to(c, x, y);
            plb_canvas_curve_to(c, x + 4, y - 3, x + 8, y - 3, x + 11, y);
            plb_canvas_stroke(c);
        }
    shape(c, (const double[][2]){{30, 112}, {38, 103}, {49, 105}, {60, 100}, {72, 105}, {84, 102}, {92, 112}}, 7, 0.7);
}

int main(void)
{
    plb_error error;
    plb_canvas *c = plb_canvas_new(120, 150, &error);
    plb_options *options = plb_options_new();
    bool ok = c && options && plb_options_set(options, "pencil", "2H", &error) && plb_options_set(options, "dpi", "150", &error);
    if (ok) {
        sky(c);
        sea(c);
        tower(c);
    }
    plb_drawing *drawing = ok ? plb_canvas_draw(c, options, &error) : NULL;
    ok = drawing && plb_drawing_write(drawing, "lighthouse.png", options, &error) && plb_drawing_write(drawing, "lighthouse.svg", options, &error);
    if (!ok)
        fprintf(stderr, "lighthouse: %s\n", c && options ? error.text : "out of memory");
    plb_drawing_free(drawing);
    plb_options_free(options);
    plb_canvas_free(c);
    return !ok;
}
