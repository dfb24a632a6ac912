/* SPDX-License-Identifier: MIT */
#include "list/characters.h"

#include <string.h>

text_run *plb_text_run_copy(const text_run *t, double scale)
{
    text_run *copy = plb_new(1, sizeof *copy);
    if (!copy || !array_reserve(&copy->characters, t->characters.n)) {
        plb_free(copy);
        return NULL;
    }
    copy->em = t->em * scale;
    copy->degrees = t->degrees;
    if (t->characters.n)
        memcpy(copy->characters.v, t->characters.v, t->characters.n * sizeof *t->characters.v);
    copy->characters.n = t->characters.n;
    return copy;
}

void plb_text_run_free(text_run *t)
{
    if (!t)
        return;
    array_free(&t->characters);
    plb_free(t);
}

bool plb_text_run_map(text_run *t, matrix m, bool size_too)
{
    double a = t->degrees * PLB_PI / 180, expansion = plb_matrix_expansion(m);
    point along = plb_matrix_apply_vector(m, (point){cos(a), sin(a)});
    bool ok = plb_matrix_determinant(m) > 0 && plb_point_length(along) > 0;
    t->degrees = atan2(along.y, along.x) * 180 / PLB_PI;
    t->em *= size_too ? expansion : 1;
    for (size_t i = 0; i < t->characters.n; i++) {
        t->characters.v[i].at = plb_matrix_apply(m, t->characters.v[i].at);
        ok = ok && isfinite(t->characters.v[i].at.x) && isfinite(t->characters.v[i].at.y);
    }
    return ok && isfinite(t->degrees) && isfinite(t->em) && t->em > 0;
}

size_t plb_text_run_subpaths(const text_run *t)
{
    size_t n = 0;
    for (size_t i = 0; i < t->characters.n; i++)
        n += t->characters.v[i].subpaths;
    return n;
}
