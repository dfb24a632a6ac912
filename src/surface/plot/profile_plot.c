/* SPDX-License-Identifier: MIT
 *
 * This file draws a profile as a picture of four panels with axes. All sizes are pixels of the picture, chosen by eye.
 */
#include "surface/plot/profile_plot.h"

#include "base/geometry/geom.h"
#include "base/number/number.h"
#include "system/output.h"
#include "surface/plot/cairo_png.h"
#include "base/number/units.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>

#define PICTURE_WIDTH 1080
#define PICTURE_HEIGHT 920
#define TITLE_HEIGHT 56
#define PANEL_WIDTH (PICTURE_WIDTH / 2)
#define PANEL_HEIGHT ((PICTURE_HEIGHT - TITLE_HEIGHT) / 2)
#define MARGIN_LEFT 72
#define MARGIN_RIGHT 24
#define MARGIN_TOP 34
#define MARGIN_BOTTOM 54
#define FONT_SIZE 13
#define TITLE_SIZE 20
#define TICK 5

/* A panel is one diagram: its place on the picture, and the values that its axes span. */
typedef struct {
    cairo_t *cr;
    double left, top, width, height;
    double x0, x1, y0, y1;
} panel;

static double at_x(const panel *p, double x)
{
    return p->left + (x - p->x0) / (p->x1 - p->x0) * p->width;
}

static double at_y(const panel *p, double y)
{
    return p->top + p->height - (y - p->y0) / (p->y1 - p->y0) * p->height;
}

static panel place(cairo_t *cr, int column, int row)
{
    return (panel){.cr = cr,
                   .left = column * PANEL_WIDTH + MARGIN_LEFT,
                   .top = TITLE_HEIGHT + row * PANEL_HEIGHT + MARGIN_TOP,
                   .width = PANEL_WIDTH - MARGIN_LEFT - MARGIN_RIGHT,
                   .height = PANEL_HEIGHT - MARGIN_TOP - MARGIN_BOTTOM};
}

/* `anchor` 0: the text starts at x, 0.5: is centred there, 1: ends there. */
static void text(cairo_t *cr, double x, double y, double anchor, const char *words)
{
    cairo_text_extents_t size;
    cairo_text_extents(cr, words, &size);
    cairo_move_to(cr, x - anchor * size.x_advance, y);
    cairo_show_text(cr, words);
}

static void number(const panel *p, double x, double y, double anchor, double value)
{
    char digits[48];
    text(p->cr, x, y, anchor, plb_format_number(digits, value, 3));
}

/* Returns a round step that cuts `span` into about five. */
static double tick_step(double span)
{
    double power = pow(10, floor(log10(span / 5))), rest = span / 5 / power;
    return power * (rest < 1.5 ? 1 : rest < 3.5 ? 2 : rest < 7.5 ? 5 : 10);
}

static void x_ticks(const panel *p, double step)
{
    for (int i = (int)ceil(p->x0 / step); i * step <= p->x1; i++) {
        double x = floor(at_x(p, i * step)) + 0.5;
        cairo_move_to(p->cr, x, p->top + p->height);
        cairo_rel_line_to(p->cr, 0, TICK);
        cairo_stroke(p->cr);
        number(p, x, p->top + p->height + TICK + FONT_SIZE, 0.5, i * step);
    }
}

static void y_ticks(const panel *p, double step)
{
    for (int i = (int)ceil(p->y0 / step); i * step <= p->y1; i++) {
        double y = floor(at_y(p, i * step)) + 0.5;
        cairo_move_to(p->cr, p->left, y);
        cairo_rel_line_to(p->cr, -TICK, 0);
        cairo_stroke(p->cr);
        number(p, p->left - TICK - 4, y + FONT_SIZE * 0.35, 1, i * step);
    }
}

/* Draws frame and ticks, and writes what the axes and the panel mean. */
static void axes(const panel *p, double step_x, double step_y, const char *title, const char *x_label, const char *y_label)
{
    cairo_set_source_rgb(p->cr, 0, 0, 0);
    cairo_set_line_width(p->cr, 1);
    cairo_rectangle(p->cr, floor(p->left) - 0.5, floor(p->top) - 0.5, floor(p->width) + 1, floor(p->height) + 1);
    cairo_stroke(p->cr);
    x_ticks(p, step_x);
    y_ticks(p, step_y);
    text(p->cr, p->left + p->width / 2, p->top - 12, 0.5, title);
    text(p->cr, p->left + p->width / 2, p->top + p->height + TICK + 2.4 * FONT_SIZE, 0.5, x_label);
    cairo_save(p->cr);
    cairo_translate(p->cr, p->left - MARGIN_LEFT + FONT_SIZE + 2, p->top + p->height / 2);
    cairo_rotate(p->cr, -PLB_PI / 2);
    text(p->cr, 0, 0, 0.5, y_label);
    cairo_restore(p->cr);
}

/* Draws a dashed line across the panel at x. */
static void mark(const panel *p, double x)
{
    const double dash[] = {4, 4};
    cairo_set_dash(p->cr, dash, 2, 0);
    cairo_set_source_rgb(p->cr, 0.75, 0.1, 0.1);
    cairo_move_to(p->cr, at_x(p, x), p->top);
    cairo_line_to(p->cr, at_x(p, x), p->top + p->height);
    cairo_stroke(p->cr);
    cairo_set_dash(p->cr, NULL, 0, 0);
}

/* Draws a histogram in percent, each bar in its own grey, with the bounds. */
static void draw_histogram(panel p, const uint32_t counts[PROFILE_GREYS], int low, int high, const char *title)
{
    double total = 0, most = 0;
    for (int g = 0; g < PROFILE_GREYS; g++) {
        total += counts[g];
        most = fmax(most, counts[g]);
    }
    p.x0 = 0, p.x1 = PROFILE_GREYS, p.y0 = 0, p.y1 = 105 * most / total;
    for (int g = 0; g < PROFILE_GREYS; g++) {
        double top = at_y(&p, 100 * counts[g] / total);
        cairo_set_source_rgb(p.cr, g * 0.8 / 255, g * 0.8 / 255, g * 0.8 / 255);
        cairo_rectangle(p.cr, at_x(&p, g), top, at_x(&p, g + 1) - at_x(&p, g), p.top + p.height - top);
        cairo_fill(p.cr);
    }
    mark(&p, low);
    mark(&p, high + 1);
    axes(&p, 50, tick_step(p.y1), title, "grey (0 black, 255 paper)", "% of pixels");
}

/* Adds the section's curve, `by` standard deviations off the mean, from the left edge of the line to the right. */
static void section_path(const panel *p, const profile *f, double by, bool backwards)
{
    for (int i = 0; i < 2 * PROFILE_SECTION_BINS; i++) {
        int at = (backwards ? 2 * PROFILE_SECTION_BINS - 1 - i : i) - PROFILE_SECTION_BINS, bin = at < 0 ? -at - 1 : at;
        double x = (at + 0.5) * PROFILE_SECTION_STEP / f->dpi * MM_PER_INCH, grey = f->section_mean[bin] + by * f->section_sd[bin];
        cairo_line_to(p->cr, at_x(p, x), at_y(p, fmin(255, fmax(0, grey))));
    }
}

static void draw_section(panel p, const profile *f)
{
    double half = fmin(f->width_tenth, PROFILE_SECTION_BINS * PROFILE_SECTION_STEP) / f->dpi * MM_PER_INCH;
    p.x0 = -half, p.x1 = half, p.y0 = 0, p.y1 = 260;
    cairo_save(p.cr);
    cairo_rectangle(p.cr, p.left, p.top, p.width, p.height);
    cairo_clip(p.cr);
    cairo_set_source_rgb(p.cr, 0.85, 0.85, 0.85);
    section_path(&p, f, -1, false);
    section_path(&p, f, 1, true);
    cairo_close_path(p.cr);
    cairo_fill(p.cr);
    cairo_set_source_rgb(p.cr, 0, 0, 0);
    cairo_set_line_width(p.cr, 1.5);
    section_path(&p, f, 0, false);
    cairo_stroke(p.cr);
    cairo_set_line_width(p.cr, 1);
    for (int side = -1; side <= 1; side += 2)
        mark(&p, side * f->width_half / 2 / f->dpi * MM_PER_INCH);
    cairo_restore(p.cr);
    axes(&p, tick_step(2 * half), 50, "cross-section, mean and standard deviation", "distance from the centreline, mm (dashed: half depth)", "grey");
}

/* Draws the matrix, its counts on a logarithmic scale from white (none) to black (most). */
static bool draw_ccm(panel p, const profile *f)
{
    p.x0 = 0, p.x1 = PROFILE_GREYS, p.y0 = 0, p.y1 = PROFILE_GREYS;
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, PROFILE_GREYS, PROFILE_GREYS);
    if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS)
        return false;
    uint32_t most = 1;
    for (int i = 0; i < PROFILE_GREYS * PROFILE_GREYS; i++)
        most = f->ccm[i] > most ? f->ccm[i] : most;
    unsigned char *pixels = cairo_image_surface_get_data(image);
    int stride = cairo_image_surface_get_stride(image);
    for (int i = 0; i < PROFILE_GREYS; i++)
        for (int j = 0; j < PROFILE_GREYS; j++) {
            double dark = log1p(f->ccm[i * PROFILE_GREYS + j]) / log1p(most);
            uint32_t grey = (uint32_t)floor(255 * (1 - dark) + 0.5);
            *(uint32_t *)(void *)(pixels + (PROFILE_GREYS - 1 - j) * stride + 4 * i) = grey << 16 | grey << 8 | grey;
        }
    cairo_surface_mark_dirty(image);
    double side = fmin(p.width, p.height);
    p.left += floor((p.width - side) / 2);
    p.width = p.height = side;
    cairo_save(p.cr);
    cairo_translate(p.cr, p.left, p.top);
    cairo_scale(p.cr, p.width / PROFILE_GREYS, p.height / PROFILE_GREYS);
    cairo_set_source_surface(p.cr, image, 0, 0);
    cairo_paint(p.cr);
    cairo_restore(p.cr);
    cairo_surface_destroy(image);
    axes(&p, 50, 50, "co-occurrence along the line (logarithmic)", "grey of a pixel", "grey of the next one");
    return true;
}

static void draw_title(cairo_t *cr, const profile *f)
{
    char words[256], half[48], dpi[48];
    cairo_set_source_rgb(cr, 0, 0, 0);
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, TITLE_SIZE);
    snprintf(words, sizeof words, "%s: centre %d, %s mm wide, %d line%s, %llu px at %s dpi", f->name, plb_profile_centre(f),
             plb_format_number(half, f->width_half / f->dpi * MM_PER_INCH, 2), f->lines, f->lines == 1 ? "" : "s",
             (unsigned long long)f->pixels, plb_format_number(dpi, f->dpi, 1));
    text(cr, PICTURE_WIDTH / 2.0, TITLE_HEIGHT * 0.65, 0.5, words);
    cairo_set_font_size(cr, FONT_SIZE);
}

static bool draw(cairo_t *cr, const profile *f)
{
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    draw_title(cr, f);
    draw_histogram(place(cr, 0, 0), f->mid, f->min_mid, f->max_mid, "centre of the line (dashed: bounds)");
    draw_histogram(place(cr, 1, 0), f->range, f->min_range, f->max_range, "whole line, white left out (dashed: bounds)");
    draw_section(place(cr, 0, 1), f);
    return draw_ccm(place(cr, 1, 1), f) && cairo_status(cr) == CAIRO_STATUS_SUCCESS;
}

static bool write_picture(cairo_surface_t *surface, const char *file, error *err)
{
    output out;
    if (!plb_output_open(&out, file, err))
        return false;
    cairo_status_t status = plb_cairo_write_png(surface, out.to);
    if (status == CAIRO_STATUS_SUCCESS || status == CAIRO_STATUS_WRITE_ERROR)
        return plb_output_commit(&out, err);
    plb_output_discard(&out);
    return plb_fail_memory(err);
}

bool plb_profile_draw(const profile *p, const char *file, error *err)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, PICTURE_WIDTH, PICTURE_HEIGHT);
    cairo_t *cr = cairo_create(surface);
    bool good = draw(cr, p) ? write_picture(surface, file, err) : plb_fail_memory(err);
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    return good;
}
