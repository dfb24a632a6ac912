/* SPDX-License-Identifier: MIT
 *
 * See key_table.h.
 */
#include "tap/model/shade/key_table.h"

#include "base/number/random.h"

#define NO_NUMBER UINT32_MAX
#define FIRST_SIZE 256

static size_t find_slot(const table_key *keys, const uint32_t *slots, size_t size, table_key k)
{
    size_t i = random_fold(random_fold(k.part[0], k.part[1], k.part[2]), k.part[3], 0) & (size - 1);
    while (slots[i] != NO_NUMBER && !plb_key_is_same(keys[slots[i]], k))
        i = (i + 1) & (size - 1);
    return i;
}

static bool grow(key_table *t)
{
    size_t size = t->size ? 2 * t->size : FIRST_SIZE;
    uint32_t *slots = plb_new(size, sizeof *slots);
    if (!slots)
        return false;
    for (size_t i = 0; i < size; i++)
        slots[i] = NO_NUMBER;
    for (uint32_t i = 0; i < t->keys.n; i++)
        slots[find_slot(t->keys.v, slots, size, t->keys.v[i])] = i;
    plb_free(t->slots);
    t->slots = slots;
    t->size = size;
    return true;
}

bool plb_key_find(const key_table *t, table_key k, uint32_t *number)
{
    if (!t->size)
        return false;
    *number = t->slots[find_slot(t->keys.v, t->slots, t->size, k)];
    return *number != NO_NUMBER;
}

bool plb_key_number(key_table *t, table_key k, uint32_t *number)
{
    if (plb_key_find(t, k, number))
        return true;
    if (2 * t->keys.n >= t->size && !grow(t))
        return false;
    *number = (uint32_t)t->keys.n;
    t->slots[find_slot(t->keys.v, t->slots, t->size, k)] = *number;
    return array_push(&t->keys, k);
}

void plb_key_table_free(key_table *t)
{
    array_free(&t->keys);
    plb_free(t->slots);
    *t = (key_table){0};
}
