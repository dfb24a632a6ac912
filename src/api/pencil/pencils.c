/* SPDX-License-Identifier: MIT
 *
 * See pencils.h.
 */
#include "api/pencil/pencils.h"

#include "base/array.h"

#include <pthread.h>

typedef struct {
    const line_model *model;
    paper_kind on;
    pencil *made;
} place;

struct pencil_rack {
    pthread_mutex_t lock;
    ARRAY(place) places;
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
    for (size_t k = 0; k < r->places.n; k++)
        plb_pencil_free(r->places.v[k].made);
    array_free(&r->places);
    pthread_mutex_destroy(&r->lock);
    plb_free(r);
}

static pencil *find_or_make(pencil_rack *r, const profile *p, const line_model *model, paper_kind on, error *err)
{
    for (size_t k = 0; k < r->places.n; k++)
        if (r->places.v[k].model == model && r->places.v[k].on == on)
            return r->places.v[k].made;
    place added = {model, on, model->prepare(p, on, err)};
    if (added.made && !array_push(&r->places, added)) {
        plb_fail_memory(err);
        plb_pencil_free(added.made);
        return NULL;
    }
    return added.made;
}

const pencil *plb_api_pencil(const plb_profile *p, const line_model *model, paper_kind on, error *err)
{
    pencil_rack *r = p->pencil_cache;
    pthread_mutex_lock(&r->lock);
    const pencil *found = find_or_make(r, p->p, model, model->on_paper ? on : PAPER_NONE, err);
    pthread_mutex_unlock(&r->lock);
    return found;
}
