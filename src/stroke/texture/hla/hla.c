/* SPDX-License-Identifier: MIT
 *
 * The papers' model takes random greys, applies the co-occurrence matrix and blurs once (001 section 3.2).
 */
#include "base/number/units.h"
#include "stroke/pencil.h"
#include "stroke/texture/models.h"

bool plb_texture(strip *s, double length_px, bool closed, const pencil *p, uint64_t seed, uint64_t identity, error *err)
{
    if (!plb_texture_fill(s, length_px, p, seed, identity, err))
        return false;
    plb_texture_ccm(s, p, NULL);
    if (closed)
        plb_texture_wrap(s);
    plb_texture_blur(s);
    if (closed)
        plb_texture_wrap(s);
    return true;
}

static pencil *prepare(const profile *p, paper_kind on, error *err)
{
    (void)on;
    return plb_pencil_new(p, err);
}

static bool make(const path_samples *path, const stroke *s, const stroke_options *o, texture_buffers *b, shading *out, error *err)
{
    double dpi = o->pencil->profile->dpi, length_px = path->v[path->n - 1].along / MM_PER_INCH * dpi, pressure = stroke_pressure(s, o);
    if (!plb_texture(&b->strip, length_px, s->closed, o->pencil, o->seed, s->identity, err))
        return false;
    if (pressure != 1) /* at the usual one they are the papers' greys, bit for bit */
        plb_strip_press(&b->strip, pressure);
    *out = plb_strip_shading(&b->strip, dpi);
    return true;
}

const line_model plb_model_hla = {
    .name = "hla",
    .about = "the papers' algorithm",
    .arm = &plb_arm_jerk,
    .prepare = prepare,
    .make = make,
};
