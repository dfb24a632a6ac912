/* SPDX-License-Identifier: MIT
 *
 * Gives the interpreter its memory: an arena that grows and is freed as a whole, with everything counted against a
 * limit; strings, arrays and names live in the arena.
 */
#include "tap/ps/ps.h"

#include <string.h>

#define BLOCK_BYTES ((size_t)64 << 10)
#define ALIGNMENT 16u

struct ps_block {
    ps_block *next;
    size_t used, capacity;
    _Alignas(ALIGNMENT) char bytes[];
};

static ps_block *new_block(ps *p, size_t bytes)
{
    size_t capacity = bytes > BLOCK_BYTES / 4 ? bytes : BLOCK_BYTES;
    ps_block *b = plb_new(1, sizeof *b + capacity);
    if (!b) {
        plb_fail_memory(&p->err);
        return NULL;
    }
    b->capacity = capacity;
    if (p->blocks && bytes > BLOCK_BYTES / 4) { /* a block of its own, behind the one being filled */
        b->next = p->blocks->next;
        p->blocks->next = b;
    } else {
        b->next = p->blocks;
        p->blocks = b;
    }
    return b;
}

void *plb_ps_new(ps *p, size_t n, size_t size)
{
    if (n > PS_MAX_MEMORY / size || n * size > PS_MAX_MEMORY - p->memory) {
        plb_ps_fail(p, ERROR_LIMIT, "the PostScript program wants more than %zu MB of memory", PS_MAX_MEMORY >> 20);
        return NULL;
    }
    size_t bytes = (n * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    if (!bytes)
        bytes = ALIGNMENT;
    p->memory += bytes;
    ps_block *b = p->blocks;
    if (!b || b->capacity - b->used < bytes)
        b = new_block(p, bytes);
    if (!b)
        return NULL;
    void *at = b->bytes + b->used;
    b->used += bytes;
    return at;
}

void plb_ps_free_memory(ps *p)
{
    while (p->blocks) {
        ps_block *next = p->blocks->next;
        plb_free(p->blocks);
        p->blocks = next;
    }
    array_free(&p->names);
    array_free(&p->changes);
}

bool plb_ps_new_array(ps *p, uint32_t n, ps_object *out)
{
    if (n > PS_MAX_ARRAY)
        return plb_ps_raise(p, PS_LIMITCHECK);
    ps_object *v = plb_ps_new(p, n, sizeof *v);
    if (!v)
        return false;
    *out = (ps_object){.type = PS_ARRAY, .n = n, .as.array = v};
    return plb_ps_charge(p, n / 16);
}

bool plb_ps_new_string(ps *p, const char *text, size_t n, ps_object *out)
{
    if (n > PS_MAX_STRING)
        return plb_ps_raise(p, PS_LIMITCHECK);
    char *s = plb_ps_new(p, n, 1);
    if (!s)
        return false;
    if (text && n)
        memcpy(s, text, n);
    *out = (ps_object){.type = PS_STRING, .n = (uint32_t)n, .as.string = s};
    return plb_ps_charge(p, n / 64);
}

/* ---- names: each text once, so that names are equal when their pointers are -------------------------------- */

/* FNV-1a. */
static uint32_t hash_text(const char *text, size_t n)
{
    uint32_t h = 2166136261u;
    for (size_t i = 0; i < n; i++)
        h = (h ^ (unsigned char)text[i]) * 16777619u;
    return h ^ h >> 15;
}

/* Gives the slot where the name is or would go. */
static const ps_name **find_slot(ps *p, const char *text, size_t n, uint32_t hash)
{
    size_t mask = p->names.capacity - 1, i = hash & mask;
    for (;; i = (i + 1) & mask) {
        const ps_name *at = p->names.v[i];
        p->steps += at != NULL && at->hash == hash && at->length != n; /* made-up collisions cost the file, not us */
        if (!at || (at->hash == hash && at->length == n && !memcmp(at->text, text, n)))
            return &p->names.v[i];
    }
}

static bool grow_names(ps *p)
{
    size_t old = p->names.capacity, capacity = old ? old * 2 : 2048;
    const ps_name **before = p->names.v, **v = plb_new(capacity, sizeof(const ps_name *));
    if (!v)
        return plb_fail_memory(&p->err);
    p->names.v = v;
    p->names.capacity = capacity;
    for (size_t i = 0; i < old; i++)
        if (before[i]) {
            size_t k = before[i]->hash & (capacity - 1);
            while (v[k])
                k = (k + 1) & (capacity - 1);
            v[k] = before[i];
        }
    plb_free(before);
    return true;
}

const ps_name *plb_ps_intern(ps *p, const char *text, size_t n)
{
    uint32_t hash = hash_text(text, n);
    p->steps += n / 32;
    if (!p->names.capacity && !grow_names(p))
        return NULL;
    const ps_name **slot = find_slot(p, text, n, hash);
    if (*slot)
        return *slot;
    if (p->name_count * 2 >= p->names.capacity) {
        if (!grow_names(p))
            return NULL;
        slot = find_slot(p, text, n, hash);
    }
    ps_name *name = plb_ps_new(p, 1, sizeof *name + n + 1);
    if (!name)
        return NULL;
    char *copy = (char *)(name + 1);
    if (n)
        memcpy(copy, text, n);
    *name = (ps_name){copy, (uint32_t)n, hash};
    p->name_count++;
    return *slot = name;
}

ps_object plb_ps_name(ps *p, const char *text)
{
    return (ps_object){.type = PS_NAME, .as.name = plb_ps_intern(p, text, strlen(text))};
}

const char *plb_ps_text(ps_object o, size_t *n)
{
    if (o.type != PS_NAME) {
        *n = o.n;
        return o.as.string;
    }
    *n = o.as.name ? o.as.name->length : 0; /* there is none after an allocation failed */
    return o.as.name ? o.as.name->text : "";
}

bool plb_ps_text_is(ps_object o, const char *text)
{
    size_t n;
    if (o.type != PS_NAME && o.type != PS_STRING)
        return false;
    const char *s = plb_ps_text(o, &n);
    return n == strlen(text) && !memcmp(s, text, n);
}
