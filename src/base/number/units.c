/* SPDX-License-Identifier: MIT */
#include "base/number/units.h"

#include "base/number/number.h"

#include <math.h>
#include <string.h>

static const struct {
    const char *name;
    double mm;
} units[] = {
    {"mm", 1}, {"cm", 10}, {"in", MM_PER_INCH}, {"pt", MM_PER_INCH / 72}, {"px", MM_PER_INCH / 96}, {"", MM_PER_INCH / 96},
};

bool plb_read_length(const char *text, double *mm)
{
    const char *end = text + strlen(text), *p;
    double value, divisor = 1;
    if (!plb_parse_number(text, end, &value, &p))
        return false;
    if (*p == '/' && (!plb_parse_number(p + 1, end, &divisor, &p) || divisor == 0))
        return false;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (!strcmp(p, units[i].name)) {
            *mm = value / divisor * units[i].mm;
            return isfinite(*mm);
        }
    return false;
}
