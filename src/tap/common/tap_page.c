/* SPDX-License-Identifier: MIT */
#include "tap/common/tap_page.h"

#include <math.h>
#include <stdio.h>

#define PAGE_UNITS 4096.0             /* of the longer side: a step of cairo's 24.8 numbers is 1 um on an A0 sheet */
#define PAGE_UNITS_MAX 32768.0       /* fonts fail beyond */
/* The script surface forgets what is below 1e-5 in a pen's matrix. KiCad's drawings are 3e8 user units wide: there the
 * page gets more units, so that the turn's sine (0.33) of a user unit stays above. */
#define UNITS_PER_USER_UNIT 6.5e-5
#define FIT_MAX 6.0                  /* of a page like a hair; chosen by eye */

tap_page plb_tap_page(void) { return (tap_page){.units = PAGE_UNITS}; }

/* As a browser sizes an image: a missing extent follows from the viewBox, a percentage is of it. */
bool plb_tap_page_size(tap_page *p, tap_extent w, tap_extent h, const double *box)
{
    if (!box && (w.is_share || h.is_share))
        return false;
    p->width = w.value;
    p->height = h.value;
    if (!box)
        return true;
    p->units = fmin(fmax(p->units, UNITS_PER_USER_UNIT * fmax(box[0], box[1])), PAGE_UNITS_MAX);
    p->width = w.value * (w.is_share ? box[0] : 1);
    p->height = h.value * (h.is_share ? box[1] : 1);
    if (!w.is_share && h.is_share && box[0] > 0)
        p->height = p->width * box[1] / box[0];
    if (!h.is_share && w.is_share && box[1] > 0)
        p->width = p->height * box[0] / box[1];
    return true;
}

bool plb_tap_page_is_there(const tap_page *p) { return p->width > 0 && p->height > 0; }
bool plb_tap_page_is_fit(const tap_page *p) { return p->width <= TAP_PX_MAX && p->height <= TAP_PX_MAX; }

tap_placing plb_tap_place(const tap_page *p)
{
    double scale = p->units / fmax(p->width, p->height), w = p->width * scale, h = p->height * scale;
    double a = TAP_TURN_DEGREES * TAP_PI / 180, c = cos(a), s = sin(a);
    tap_placing l = {.turn = {c, s, -s, c, h * s, 0}, .scale = scale, .width = w * c + h * s, .height = w * s + h * c};
    l.fit = fmin(FIT_MAX, fmax(l.width / p->width, l.height / p->height) / scale);
    return l;
}

tap_matrix plb_tap_multiply(tap_matrix first, tap_matrix then)
{
    return (tap_matrix){
        .xx = first.xx * then.xx + first.yx * then.xy,
        .yx = first.xx * then.yx + first.yx * then.yy,
        .xy = first.xy * then.xx + first.yy * then.xy,
        .yy = first.xy * then.yx + first.yy * then.yy,
        .x0 = first.x0 * then.xx + first.y0 * then.xy + then.x0,
        .y0 = first.x0 * then.yx + first.y0 * then.yy + then.y0,
    };
}

/* In the order in which cairo calculates it, so that not the last digit depends on who does. */
static tap_matrix invert(tap_matrix m)
{
    double k = 1 / (m.xx * m.yy - m.yx * m.xy);
    return (tap_matrix){m.yy * k, -m.yx * k, -m.xy * k, m.xx * k, (m.xy * m.y0 - m.yy * m.x0) * k, (m.yx * m.x0 - m.xx * m.y0) * k};
}

size_t plb_tap_head(const tap_page *p, tap_omissions lost, char line[TAP_HEAD_MAX])
{
    tap_placing l = plb_tap_place(p);
    tap_matrix back = invert(l.turn);
    double k = TAP_MM_PER_PX / l.scale;
    int n = snprintf(line, TAP_HEAD_MAX, "%%%%Plumbago-tap 1 %.9g %.9g %.12g %.12g %.12g %.12g %.12g %.12g %lu %lu %lu %lu\n",
                     p->width * TAP_MM_PER_PX, p->height * TAP_MM_PER_PX, back.xx * k, back.yx * k, back.xy * k, back.yy * k,
                     back.x0 * k, back.y0 * k, lost.images, lost.masks, lost.filters, lost.foreign);
    return (size_t)n;
}
