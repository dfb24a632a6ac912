/* SPDX-License-Identifier: MIT */
#include "base/geometry/interpolate.h"

double plb_interpolate(const float v[], int n, double first, double step, double x)
{
    double at = clamp((x - first) / step, 0, n - 1);
    int k = at < n - 1 ? (int)at : n - 2;
    return v[k] + ((double)v[k + 1] - v[k]) * (at - k);
}
