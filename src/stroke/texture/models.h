/* SPDX-License-Identifier: MIT
 *
 * The line models: each row of the table is one way to make the texture of a line. To add a model, write a file with its row and name
 * the row in models.c; the command line, the library's checks and the tests of all models read the table.
 */
#ifndef PLB_STROKE_TEXTURE_MODELS_H
#define PLB_STROKE_TEXTURE_MODELS_H

#include "profile/profile.h"
#include "stroke/arm/arm.h"
#include "stroke/texture/graphite/grain_field.h"
#include "stroke/texture/hla/strip.h"

/* The buffers of the models' textures, kept from stroke to stroke. */
typedef struct {
    strip strip;
    grain grain;
} texture_buffers;
void plb_texture_buffers_free(texture_buffers *b);

struct line_model {
    const char *name, *about;
    const arm_model *arm; /* which draws where no arm is chosen */
    bool is_measured;     /* the free hand's direction, ends and memory of curves show, as measured; the papers know neither */
    bool on_paper;        /* the paper shows */
    /* The pencil of a profile, on a paper if the paper shows. The pencil borrows `p`, which must live longer. NULL and `err`
     * when out of memory. */
    pencil *(*prepare)(const profile *p, paper_kind on, error *err);
    /* Makes the texture of stroke `s`, whose drawn path is `path`, in `b`, and says in `out` how to read the texture. False and `err`
     * when out of memory or over a limit. */
    bool (*make)(const path_samples *path, const stroke *s, const stroke_options *o, texture_buffers *b, shading *out, error *err);
};

/* models.c: the table. Row i; NULL past the last. */
const line_model *plb_model_at(size_t i);
/* Gives the model and the arm that the options mean. */
const line_model *plb_model_of(const stroke_options *o);
const arm_model *plb_arm_of(const stroke_options *o);
/* Tells how hard stroke `s` is pressed, times the usual. */
static inline double stroke_pressure(const stroke *s, const stroke_options *o)
{
    double own = s->style.pressure > 0 ? (double)s->style.pressure : 1;
    return o->pressure > 0 ? own * o->pressure : own;
}

/* Gives the pencils of the papers' model and of the graphite model on a paper, as `prepare` gives them. */
pencil *plb_pencil_new(const profile *p, error *err);
pencil *plb_pencil_on_paper(const profile *p, paper_kind on, error *err);
void plb_pencil_free(pencil *p);

/* The rows, each in a file of its own (hla/hla.c, graphite/graphite.c). */
extern const line_model plb_model_hla, plb_model_graphite;

#endif
