/* SPDX-License-Identifier: MIT
 *
 * Whole numbers of up to 5,120 bits, not below zero: the exact way between decimal and binary where 128 bits are too few.
 * The largest that reading needs are 800 digits times two to the power of 1,100, the largest that writing needs are
 * a number of 56 bits times ten to the power of 345.
 */
#ifndef PLB_BASE_NUMBER_BIG_INTEGER_H
#define PLB_BASE_NUMBER_BIG_INTEGER_H

#include <stdbool.h>
#include <stdint.h>

#define BIG_WORDS 160

typedef struct {
    int n; /* words in use; the last one is not 0 */
    uint32_t words[BIG_WORDS]; /* the lowest first */
} big_integer;

void plb_big_set(big_integer *b, uint64_t value);
/* b = b * factor + more */
void plb_big_multiply(big_integer *b, uint32_t factor, uint32_t more);
/* b = b times five to the power of k >= 0 */
void plb_big_multiply_fives(big_integer *b, int k);
/* b = b times two to the power of `bits` >= 0 */
void plb_big_shift(big_integer *b, int bits);
/* How many bits it takes; 0 for 0. */
int plb_big_bits(const big_integer *b);
/* Gives the whole part of a / b, which must be below 2 to the power of 64, b not 0; `exact` tells whether nothing is left.
 * It uses both up. */
uint64_t plb_big_divide(big_integer *a, big_integer *b, bool *exact);

#endif
