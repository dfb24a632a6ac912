/* SPDX-License-Identifier: MIT
 *
 * This file has the table of line models (models.h).
 */
#include "stroke/texture/models.h"

static const line_model *const models[] = {&plb_model_hla, &plb_model_graphite};

const line_model *plb_model_at(size_t i)
{
    return i < sizeof models / sizeof *models ? models[i] : NULL;
}

const line_model *plb_model_of(const stroke_options *o)
{
    return o->model ? o->model : &plb_model_hla;
}

const arm_model *plb_arm_of(const stroke_options *o)
{
    return o->arm ? o->arm : plb_model_of(o)->arm;
}

void plb_texture_buffers_free(texture_buffers *b)
{
    plb_strip_free(&b->strip);
    plb_grain_free(&b->grain);
}
