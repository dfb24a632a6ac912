/* SPDX-License-Identifier: MIT
 *
 * See pencils.h.
 */
#include "api/pencil/pencils.h"

#include "base/array.h"

#include <pthread.h>

#define PAPERS (PAPER_ROUGH + 1)

struct pencil_rack {
    pthread_mutex_t lock;
    pencil *of_papers_model, *on[PAPERS];
};

pencil_rack *plb_api_rack_new(void)
{
    pencil_rack *r = plb_new(1, sizeof *r);
    if (r && pthread_mutex_init(&r->lock, NULL) == 0)
        return r;
    plb_free(r);
    return NULL;
}

void plb_api_rack_free(pencil_rack *r)
{
    if (!r)
        return;
    plb_pencil_free(r->of_papers_model);
    for (int k = 0; k < PAPERS; k++)
        plb_pencil_free(r->on[k]);
    pthread_mutex_destroy(&r->lock);
    plb_free(r);
}

const pencil *plb_api_pencil(const plb_profile *p, line_model model, paper_kind on, error *err)
{
    pencil_rack *r = p->pencil_cache;
    pencil **place = model == MODEL_HLA ? &r->of_papers_model : &r->on[on];
    pthread_mutex_lock(&r->lock);
    if (!*place)
        *place = model == MODEL_HLA ? plb_pencil_new(p->p, err) : plb_pencil_on_paper(p->p, on, err);
    const pencil *found = *place;
    pthread_mutex_unlock(&r->lock);
    return found;
}
