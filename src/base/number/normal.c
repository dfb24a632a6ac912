/* SPDX-License-Identifier: MIT */
#include "base/number/normal.h"

#include <math.h>

double plb_normal_share(double x)
{
    return 0.5 * erfc(-x / sqrt(2.0));
}

/* Newton's method on the share, from the logistic approximation in the middle and the leading term of the tail. */
double plb_normal_quantile(double p)
{
    if (!(p > 1e-15))
        return -8;
    if (!(p < 1 - 1e-15))
        return 8;
    if (p > 0.5)
        return -plb_normal_quantile(1 - p);
    double x = p < 0.02 ? -sqrt(-2 * log(p)) + 0.5 : -log(1 / p - 1) / 1.702;
    for (int k = 0; k < 60; k++) {
        double density = exp(-x * x / 2) / sqrt(2 * 3.14159265358979323846);
        double step = (plb_normal_share(x) - p) / density;
        step = step > 0.5 ? 0.5 : step < -0.5 ? -0.5 : step;
        x -= step;
        if (fabs(step) < 1e-13)
            break;
    }
    return x;
}
