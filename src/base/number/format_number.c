/* SPDX-License-Identifier: MIT
 *
 * A number to a fixed count of decimals.
 */
#include "base/number/number.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static double power_of_ten(int e)
{
    double r = 1;
    for (; e > 0; e--)
        r *= 10;
    return r;
}

char *plb_format_number(char out[48], double value, int decimals)
{
    if (isnan(value) || fabs(value) > 1e15)
        return strcpy(out, isnan(value) ? "nan" : value < 0 ? "-inf" : "inf");
    double scale = power_of_ten(decimals), whole = floor(fabs(value));
    uint64_t fraction = (uint64_t)floor((fabs(value) - whole) * scale + 0.5);
    if ((double)fraction >= scale) {
        whole += 1;
        fraction = 0;
    }
    bool minus = value < 0 && (whole > 0 || fraction > 0);
    int n = snprintf(out, 48, "%s%llu", minus ? "-" : "", (unsigned long long)whole);
    if (fraction) {
        n += snprintf(out + n, 48 - (size_t)n, ".%0*llu", decimals, (unsigned long long)fraction);
        while (out[n - 1] == '0')
            out[--n] = '\0';
    }
    return out;
}
