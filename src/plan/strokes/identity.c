/* SPDX-License-Identifier: MIT
 *
 * Plan, last step: each stroke gets its identity, the address of its random numbers. It is a hash of the stroke's shape
 * alone, so that nothing else in the drawing, nor the order of drawing, changes how a stroke looks.
 */
#include "base/number/random.h"
#include "plan/strokes/passes.h"

#include <math.h>

/* Identities hash positions in this unit, so that rounding noise does not change a stroke. */
#define STROKE_IDENTITY_UNIT_MM 0.001

/* Identities given so far: open addressing, 0 marks an empty place. */
typedef struct {
    uint64_t *key;
    size_t n, capacity;
} identity_set;

/* Tells whether `key` was new to the set, in *fresh; false when out of memory. */
static bool insert(identity_set *s, uint64_t key, bool *fresh)
{
    if (s->n * 2 >= s->capacity) {
        identity_set bigger = {plb_new(s->capacity ? s->capacity * 2 : 1024, sizeof(uint64_t)), 0, s->capacity ? s->capacity * 2 : 1024};
        bool ignored;
        if (!bigger.key)
            return false;
        for (size_t i = 0; i < s->capacity; i++)
            if (s->key[i])
                insert(&bigger, s->key[i], &ignored);
        plb_free(s->key);
        *s = bigger;
    }
    size_t at = random_mix(key) & (s->capacity - 1);
    while (s->key[at] && s->key[at] != key)
        at = (at + 1) & (s->capacity - 1);
    *fresh = s->key[at] != key;
    if (*fresh) {
        s->key[at] = key;
        s->n++;
    }
    return true;
}

/* Hashes a stroke, the same from both ends: from the end that is farther left, or higher. */
static uint64_t hash_shape(const point *at, size_t n, bool closed)
{
    uint64_t h = closed ? 0x9ae16a3b2f90404fu : 0xc3a5c85c97cb3127u;
    bool back = at[0].x != at[n - 1].x ? at[0].x > at[n - 1].x : at[0].y > at[n - 1].y;
    for (size_t i = 0; i < n; i++) {
        point p = at[back ? n - 1 - i : i];
        h = random_fold(h, llround(p.x / STROKE_IDENTITY_UNIT_MM), llround(p.y / STROKE_IDENTITY_UNIT_MM));
    }
    return h | 1;
}

/* The second stroke of one shape, and the third, step on from there, so that no two share their random numbers. */
static bool identify(identity_set *given, const stroke_list *list, stroke *s)
{
    bool fresh = false;
    for (uint64_t h = hash_shape(list->points.v + s->first, s->n, s->closed); !fresh; h = random_mix(h) | 1) {
        if (!insert(given, h, &fresh))
            return false;
        s->identity = h;
    }
    return true;
}

bool plb_plan_identify(stroke_list *list, error *err)
{
    identity_set given = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < list->strokes.n; i++)
        ok = identify(&given, list, &list->strokes.v[i]);
    plb_free(given.key);
    return ok || plb_fail_memory(err);
}
