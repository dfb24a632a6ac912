/* SPDX-License-Identifier: MIT
 *
 * The table of line models: see models.h.
 */
#include "stroke/texture/models.h"

#include <string.h>

static const line_model *const models[] = {&plb_model_hla, &plb_model_graphite};

const line_model *plb_model_at(size_t i)
{
    return i < sizeof models / sizeof *models ? models[i] : NULL;
}

const line_model *plb_model_lookup(const char *name)
{
    const line_model *model;
    for (size_t i = 0; (model = plb_model_at(i)) && strcmp(model->name, name) != 0;)
        i++;
    return model;
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
