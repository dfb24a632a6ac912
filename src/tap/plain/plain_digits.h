/* SPDX-License-Identifier: MIT
 *
 * Numbers as cairo prints them into a script: six places, or six significant digits below 0.1; no zeros at the end.
 */
#ifndef PLB_TAP_PLAIN_PLAIN_DIGITS_H
#define PLB_TAP_PLAIN_PLAIN_DIGITS_H

#include <stdint.h>

#define PLAIN_STEPS 256.0    /* of a fixed-point number's unit */
#define PLAIN_SMALL 25       /* the largest number of steps below 0.1 */
#define PLAIN_DIGITS_MAX 400 /* bytes that a double may need */

/* A point and digits, or nothing. */
typedef struct {
    char text[15];
    unsigned char length;
} plain_fraction;

/* All that fixed-point numbers can have after their whole part. */
typedef struct {
    plain_fraction part[256], small[PLAIN_SMALL + 1];
} plain_digits;

void plb_plain_digits(plain_digits *d);

/* Both write at `at` and return where the number ends; not terminated. 30 bytes are enough for the first. */
char *plb_plain_put_fixed(char *at, const plain_digits *d, int32_t v);
char *plb_plain_put_double(char *at, double v);

#endif
