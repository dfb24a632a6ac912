/* SPDX-License-Identifier: MIT
 *
 * Keeps dictionaries: entries in the order of their making (so that `forall` is the same on every machine), found by a
 * linear search while they are few and by a hash index when they are many; and the journal that lets `restore` put old
 * values back.
 */
#include "tap/ps/ps.h"

#include <string.h>

#define SMALL 8u /* entries that are searched one by one */

bool plb_ps_equal(ps_object a, ps_object b)
{
    size_t an, bn;
    bool a_text = a.type == PS_NAME || a.type == PS_STRING, b_text = b.type == PS_NAME || b.type == PS_STRING;
    if (a_text && b_text) {
        const char *at = plb_ps_text(a, &an), *bt = plb_ps_text(b, &bn);
        return an == bn && !memcmp(at, bt, an);
    }
    if (ps_is_number(a) && ps_is_number(b))
        return ps_value(a) == ps_value(b);
    if (a.type != b.type)
        return false;
    switch (a.type) {
    case PS_BOOLEAN: return a.as.boolean == b.as.boolean;
    case PS_ARRAY: return a.n == b.n && (a.n == 0 || a.as.array == b.as.array);
    case PS_DICT: return a.as.dict == b.as.dict;
    case PS_OPERATOR: return a.as.op == b.as.op;
    case PS_FILE: return a.as.file == b.as.file;
    case PS_SAVE: case PS_FONT_ID: case PS_GSTATE: return a.as.save == b.as.save;
    default: return true;
    }
}

/* Keys are compared after plb_ps_get and plb_ps_put made names of strings. */
static bool same_key(ps_object a, ps_object b)
{
    if (a.type == PS_NAME || b.type == PS_NAME)
        return a.type == b.type && a.as.name == b.as.name;
    return a.type != PS_NULL && plb_ps_equal(a, b);
}

static uint32_t hash_key(ps_object key)
{
    if (key.type == PS_NAME)
        return key.as.name->hash;
    if (!ps_is_number(key))
        return key.type; /* booleans, operators, composite objects: rare as keys, and pointers differ from run to run */
    double v = ps_value(key);
    uint64_t bits;
    v += 0.0; /* -0 is 0 */
    memcpy(&bits, &v, sizeof bits);
    bits = (bits ^ bits >> 32) * 0x9e3779b97f4a7c15u;
    return (uint32_t)(bits >> 32);
}

ps_dict *plb_ps_new_dict(ps *p, uint32_t size)
{
    ps_dict *d = plb_ps_new(p, 1, sizeof *d);
    if (!d)
        return NULL;
    d->stated = size;
    d->born = (uint16_t)p->save_now;
    return d;
}

static ps_entry *find(ps *p, const ps_dict *d, ps_object key)
{
    if (!d->index) {
        for (uint32_t i = 0; i < d->used; i++)
            if (same_key(d->entries[i].key, key))
                return &d->entries[i];
        return NULL;
    }
    uint32_t mask = d->index_size - 1, i = hash_key(key) & mask;
    for (unsigned probes = 0; d->index[i]; i = (i + 1) & mask, probes++) {
        ps_entry *e = &d->entries[d->index[i] - 1];
        if (same_key(e->key, key))
            return e;
        p->steps += probes > 8; /* made-up collisions are paid for */
    }
    return NULL;
}

static void index_entry(ps_dict *d, uint32_t number)
{
    uint32_t mask = d->index_size - 1, i = hash_key(d->entries[number].key) & mask;
    while (d->index[i])
        i = (i + 1) & mask;
    d->index[i] = number + 1;
}

/* Makes space for one more entry: the first time as many as stated, then twice as many; removed entries fall out. */
static bool grow(ps *p, ps_dict *d)
{
    uint32_t capacity = d->capacity ? d->live * 2 : d->stated < SMALL ? d->stated : SMALL;
    if (capacity < 4)
        capacity = d->capacity ? 8 : capacity ? capacity : 4;
    if (capacity > 4 * PS_MAX_ARRAY)
        return plb_ps_raise(p, PS_DICTFULL);
    ps_entry *entries = plb_ps_new(p, capacity, sizeof *entries);
    if (!entries)
        return false;
    uint32_t n = 0, size = 0;
    for (uint32_t i = 0; i < d->used; i++)
        if (d->entries[i].key.type != PS_NULL)
            entries[n++] = d->entries[i];
    for (size = 16; size < capacity * 2;)
        size *= 2;
    uint32_t *index = capacity > SMALL ? plb_ps_new(p, size, sizeof *index) : NULL;
    if (capacity > SMALL && !index)
        return false;
    d->entries = entries;
    d->used = d->live = n;
    d->capacity = capacity;
    d->index = index;
    d->index_size = size;
    for (uint32_t i = 0; index && i < n; i++)
        index_entry(d, i);
    return plb_ps_charge(p, n / 8);
}

static bool make_key(ps *p, ps_object *key)
{
    if (key->type == PS_NULL)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (key->type == PS_STRING) {
        const ps_name *name = plb_ps_intern(p, key->as.string, key->n);
        *key = (ps_object){.type = PS_NAME, .as.name = name};
        return name != NULL;
    }
    key->stamp = 0;
    return true;
}

ps_object *plb_ps_get(ps *p, const ps_dict *d, ps_object key)
{
    if (!make_key(p, &key))
        return NULL;
    ps_entry *e = find(p, d, key);
    return e ? &e->value : NULL;
}

ps_object *plb_ps_get_text(ps *p, const ps_dict *d, const char *key)
{
    ps_object name = plb_ps_name(p, key);
    return name.as.name ? plb_ps_get(p, d, name) : NULL;
}

/* Writes down what `restore` has to put back: once for each entry and save. */
static bool remember(ps *p, ps_dict *d, const ps_entry *e, ps_object key)
{
    if (!p->save_now || d->born == (uint16_t)p->save_now || (e && e->key.stamp == (uint16_t)p->save_now))
        return true;
    ps_change change = {d, {key, ps_null()}, e != NULL, p->save_now};
    if (e)
        change.old = *e;
    if (p->changes.n > PS_MAX_MEMORY / sizeof change / 2)
        return plb_ps_raise(p, PS_VMERROR);
    return array_push(&p->changes, change) || plb_fail_memory(&p->err);
}

static bool put(ps *p, ps_dict *d, ps_object key, ps_object value)
{
    ps_entry *e = find(p, d, key);
    if (!e) {
        if (d->used == d->capacity && !grow(p, d))
            return false;
        e = &d->entries[d->used++];
        e->key = key;
        d->live++;
        if (d->index)
            index_entry(d, d->used - 1);
    }
    e->value = value;
    e->key.stamp = key.stamp;
    return true;
}

bool plb_ps_put(ps *p, ps_dict *d, ps_object key, ps_object value)
{
    if (!make_key(p, &key))
        return false;
    if (p->save_now) {
        if (!remember(p, d, find(p, d, key), key))
            return false;
        key.stamp = (uint16_t)p->save_now;
    }
    return put(p, d, key, value);
}

bool plb_ps_put_text(ps *p, ps_dict *d, const char *key, ps_object value)
{
    ps_object name = plb_ps_name(p, key);
    return name.as.name && plb_ps_put(p, d, name, value);
}

bool plb_ps_add_operators(ps *p, ps_dict *d, const ps_operator *table)
{
    for (; table->name; table++)
        if (!plb_ps_put_text(p, d, table->name, (ps_object){.type = PS_OPERATOR, .executable = true, .as.op = table}))
            return false;
    return true;
}

/* The entry stays in place without a key that anything equals; its index slot stays taken. */
static void erase(ps *p, ps_dict *d, ps_object key)
{
    ps_entry *e = find(p, d, key);
    if (!e)
        return;
    *e = (ps_entry){ps_null(), ps_null()};
    d->live--;
}

void plb_ps_remove(ps *p, ps_dict *d, ps_object key)
{
    if (!make_key(p, &key))
        return;
    ps_entry *e = find(p, d, key);
    if (e && remember(p, d, e, key))
        erase(p, d, key);
}

bool plb_ps_roll_back(ps *p, uint32_t save)
{
    while (p->changes.n && p->changes.v[p->changes.n - 1].save >= save) {
        ps_change c = p->changes.v[--p->changes.n];
        if (!c.was_there)
            erase(p, c.dict, c.old.key);
        else if (!put(p, c.dict, c.old.key, c.old.value))
            return false;
        if (!plb_ps_charge(p, 1))
            return false;
    }
    return true;
}

ps_object *plb_ps_lookup(ps *p, ps_object key, ps_dict **where)
{
    if (!make_key(p, &key))
        return NULL;
    for (uint32_t i = p->dict_count; i-- > 0;) {
        ps_entry *e = find(p, p->dicts[i], key);
        if (e) {
            if (where)
                *where = p->dicts[i];
            return &e->value;
        }
        p->steps += i % 8 == 0;
    }
    return NULL;
}
