/* SPDX-License-Identifier: MIT */
#include "base/number/big_integer.h"

#include "base/number/powers.h"

#include <string.h>

void plb_big_set(big_integer *b, uint64_t value)
{
    b->words[0] = (uint32_t)value;
    b->words[1] = (uint32_t)(value >> 32);
    b->n = b->words[1] ? 2 : b->words[0] ? 1 : 0;
}

void plb_big_multiply(big_integer *b, uint32_t factor, uint32_t more)
{
    uint64_t carry = more;
    for (int i = 0; i < b->n; i++) {
        carry += (uint64_t)b->words[i] * factor;
        b->words[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry && b->n < BIG_WORDS)
        b->words[b->n++] = (uint32_t)carry;
}

void plb_big_multiply_fives(big_integer *b, int k)
{
    enum { STEP = 13 }; /* the most that fit into 32 bits */
    for (; k > STEP; k -= STEP)
        plb_big_multiply(b, (uint32_t)power_of_five(STEP), 0);
    plb_big_multiply(b, (uint32_t)power_of_five(k), 0);
}

void plb_big_shift(big_integer *b, int bits)
{
    int words = bits / 32;
    if (!b->n)
        return;
    plb_big_multiply(b, (uint32_t)1 << bits % 32, 0);
    if (b->n + words > BIG_WORDS)
        words = BIG_WORDS - b->n;
    memmove(b->words + words, b->words, (size_t)b->n * sizeof *b->words);
    memset(b->words, 0, (size_t)words * sizeof *b->words);
    b->n += words;
}

int plb_big_bits(const big_integer *b)
{
    return b->n ? b->n * 32 - __builtin_clz(b->words[b->n - 1]) : 0;
}

static bool is_below(const big_integer *a, const big_integer *b)
{
    if (a->n != b->n)
        return a->n < b->n;
    for (int i = a->n - 1; i >= 0; i--)
        if (a->words[i] != b->words[i])
            return a->words[i] < b->words[i];
    return false;
}

/* a = a - b, where b is not above a. */
static void subtract(big_integer *a, const big_integer *b)
{
    int64_t carry = 0;
    for (int i = 0; i < a->n; i++) {
        carry += (int64_t)a->words[i] - (i < b->n ? (int64_t)b->words[i] : 0);
        a->words[i] = (uint32_t)carry;
        carry = carry < 0 ? -1 : 0;
    }
    while (a->n && !a->words[a->n - 1])
        a->n--;
}

uint64_t plb_big_divide(big_integer *a, big_integer *b, bool *exact)
{
    /* One bit of the quotient after the other, the highest first: a doubles until it reaches b times 2 to the power of 64. */
    uint64_t quotient = 0;
    plb_big_shift(b, 64);
    for (int bit = 0; bit < 64; bit++) {
        plb_big_multiply(a, 2, 0);
        bool fits = !is_below(a, b);
        if (fits)
            subtract(a, b);
        quotient = quotient << 1 | fits;
    }
    *exact = !a->n;
    return quotient;
}
