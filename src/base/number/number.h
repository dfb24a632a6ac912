/* SPDX-License-Identifier: MIT
 *
 * Numbers as text, the same in every locale.
 */
#ifndef PLB_BASE_NUMBER_NUMBER_H
#define PLB_BASE_NUMBER_NUMBER_H

#include <stdbool.h>
#include <stddef.h>

/* Reads a decimal number "-12.5e-3" that starts at `text` and ends before `end`; `next` (may be NULL) gets the
 * first byte not read. False when there is no number; overflow gives an infinity. The double is
 * the nearest to what the text says, however many digits it has. */
bool plb_parse_number(const char *text, const char *end, double *value, const char **next);

/* Writes `value` with `decimals` (0 to 9) digits after the point, trailing zeros cut, into `out` (at least 48
 * bytes); values beyond 1e15 and non-finite ones are written as "inf", "-inf" or "nan". Returns `out`. */
char *plb_format_number(char out[48], double value, int decimals);

/* Writes the shortest text that plb_parse_number reads back as the same finite double, bit for bit, and a zero byte; of
 * several texts so short, the nearest to it. Gives its length. */
#define NUMBER_TEXT_MAX 32
size_t plb_write_number(char out[NUMBER_TEXT_MAX], double value);

#endif
