/* SPDX-License-Identifier: MIT
 *
 * A key table gives each key that it meets a number, from 0 on.
 */
#ifndef PLB_TAP_MODEL_SHADE_KEY_TABLE_H
#define PLB_TAP_MODEL_SHADE_KEY_TABLE_H

#include "base/array.h"

#include <stdint.h>

typedef struct {
    uint32_t part[4];
} table_key;

typedef struct {
    ARRAY(table_key) keys; /* by their numbers */
    uint32_t *slots;       /* numbers, by a hash of their keys */
    size_t size;           /* of slots, a power of two */
} key_table;

static inline bool plb_key_is_same(table_key a, table_key b)
{
    return a.part[0] == b.part[0] && a.part[1] == b.part[1] && a.part[2] == b.part[2] && a.part[3] == b.part[3];
}

/* Gives the number of the key, which is a new one where it has none yet. False when out of memory. */
bool plb_key_number(key_table *t, table_key k, uint32_t *number);
/* Gives the number of the key; false where it has none. */
bool plb_key_find(const key_table *t, table_key k, uint32_t *number);
void plb_key_table_free(key_table *t);

#endif
