/* SPDX-License-Identifier: MIT */
#include "tap/common/tap_page.h"

#include "base/number/number.h"

#include <math.h>
#include <stdio.h>

#define PAGE_UNITS 4096.0             /* of the longer side: a step of cairo's 24.8 numbers is 1 um on an A0 sheet */
#define PAGE_UNITS_MAX 32768.0       /* fonts fail beyond */
/* The script surface forgets what is below 1e-5 in a pen's matrix. KiCad's drawings are 3e8 user units wide: there the
 * page gets more units, so that the turn's sine (0.33) of a user unit stays above. */
#define UNITS_PER_USER_UNIT 6.5e-5
#define FIT_MAX 6.0                  /* of a page like a hair; chosen by eye */

tap_page plb_tap_page(void) { return (tap_page){.units = PAGE_UNITS}; }

/* Sizes the page as a browser sizes an image: a missing extent follows from the viewBox, a percentage is a share of the viewBox. */
bool plb_tap_page_size(tap_page *p, tap_extent w, tap_extent h, const double *view)
{
    if (!view && (w.is_share || h.is_share))
        return false;
    p->width = w.value;
    p->height = h.value;
    if (!view)
        return true;
    p->units = fmin(fmax(p->units, UNITS_PER_USER_UNIT * fmax(view[0], view[1])), PAGE_UNITS_MAX);
    p->width = w.value * (w.is_share ? view[0] : 1);
    p->height = h.value * (h.is_share ? view[1] : 1);
    if (!w.is_share && h.is_share && view[0] > 0)
        p->height = p->width * view[1] / view[0];
    if (!h.is_share && w.is_share && view[1] > 0)
        p->width = p->height * view[0] / view[1];
    return true;
}

bool plb_tap_page_is_there(const tap_page *p) { return p->width > 0 && p->height > 0; }
bool plb_tap_page_is_fit(const tap_page *p) { return p->width <= TAP_PX_MAX && p->height <= TAP_PX_MAX; }

tap_placing plb_tap_place(const tap_page *p)
{
    double scale = p->units / fmax(p->width, p->height), w = p->width * scale, h = p->height * scale;
    double a = TAP_TURN_DEGREES * PLB_PI / 180, c = cos(a), s = sin(a);
    tap_placing l = {.turn = {c, s, -s, c, h * s, 0}, .scale = scale, .width = w * c + h * s, .height = w * s + h * c};
    l.fit = fmin(FIT_MAX, fmax(l.width / p->width, l.height / p->height) / scale);
    return l;
}

/* Inverts `m` in the order in which cairo calculates, so that the last digit is the same. */
static matrix invert(matrix m)
{
    double k = 1 / (m.xx * m.yy - m.yx * m.xy);
    return (matrix){m.yy * k, -m.yx * k, -m.xy * k, m.xx * k, (m.xy * m.y0 - m.yy * m.x0) * k, (m.yx * m.x0 - m.xx * m.y0) * k};
}

/* Gives the number that a reader finds when `v` is printed with so many significant digits: coordinates that a matrix
 * of 12 digits turns back lie where they did before, far below the step of cairo's numbers. */
static double as_printed(double v, int digits)
{
    char text[40];
    int n = snprintf(text, sizeof text, "%.*g", digits, v);
    plb_parse_number(text, text + n, &v, NULL);
    return v;
}

tap_sheet plb_tap_sheet(const tap_page *p)
{
    tap_placing l = plb_tap_place(p);
    matrix back = invert(l.turn);
    double k = TAP_MM_PER_PX / l.scale, *v[] = {&back.xx, &back.yx, &back.xy, &back.yy, &back.x0, &back.y0};
    for (size_t i = 0; i < sizeof v / sizeof *v; i++)
        *v[i] = as_printed(*v[i] * k, 12);
    return (tap_sheet){as_printed(p->width * TAP_MM_PER_PX, 9), as_printed(p->height * TAP_MM_PER_PX, 9), back};
}
