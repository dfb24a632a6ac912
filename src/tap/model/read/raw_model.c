/* SPDX-License-Identifier: MIT
 *
 * See raw_model.h.
 */
#include "tap/model/read/raw_model.h"

/* A colour's parts are kept in so many steps (chosen by eye: a pencil tells no more apart). */
#define TINTS 15

void plb_raw_model_free(raw_model *m)
{
    array_free(&m->places);
    array_free(&m->corners);
    array_free(&m->faces);
    array_free(&m->wires);
    array_free(&m->paints);
}

bool plb_raw_model_add_face(raw_model *m, const uint32_t *corners, size_t n, uint32_t paint)
{
    raw_face f = {(uint32_t)n, paint};
    if (!array_reserve(&m->corners, n) || !array_push(&m->faces, f))
        return false;
    for (size_t i = 0; i < n; i++)
        m->corners.v[m->corners.n++] = corners[i];
    return true;
}

static float step_of(double part)
{
    return (float)(floor((part < 0 ? 0 : part > 1 ? 1 : part) * TINTS + .5) / TINTS);
}

bool plb_raw_model_tint(raw_model *m, double red, double green, double blue, uint32_t *paint)
{
    surface_paint p = {{step_of(red), step_of(green), step_of(blue)}, 0};
    /* Neighbours in the file are mostly of one colour: the last ones are looked at first. */
    for (size_t k = m->paints.n; k-- > 0;) {
        const colour *c = &m->paints.v[k].colour;
        if (!m->paints.v[k].material && c->red == p.colour.red && c->green == p.colour.green && c->blue == p.colour.blue) {
            *paint = (uint32_t)k;
            return true;
        }
    }
    *paint = (uint32_t)m->paints.n;
    return array_push(&m->paints, p);
}

bool plb_raw_model_mean_tint(raw_model *m, const colour *v, const uint32_t *corners, size_t n, uint32_t *paint)
{
    double red = 0, green = 0, blue = 0;
    for (size_t i = 0; i < n; i++) {
        red += (double)v[corners[i]].red;
        green += (double)v[corners[i]].green;
        blue += (double)v[corners[i]].blue;
    }
    double share = n ? 1 / (double)n : 0;
    return plb_raw_model_tint(m, red * share, green * share, blue * share, paint);
}
