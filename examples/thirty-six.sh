#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes thirty-six.svg: the wire frame of a truncated octahedron, a solid of 14 faces, 24 corners
# and 36 edges, in perspective. Corners are the permutations of (0, +-1, +-2); an edge joins two
# corners that lie the square root of two apart.
LC_ALL=C awk 'BEGIN {
    n = 0
    for (zero = 0; zero < 3; zero++) for (one = 0; one < 3; one++) if (one != zero)
        for (s = -1; s <= 1; s += 2) for (t = -1; t <= 1; t += 2) {
            p[n, zero] = 0; p[n, one] = s; p[n, 3 - zero - one] = 2 * t; n++
        }
    for (i = 0; i < n; i++) {                   # turn about y, then about x; look from 9 units away
        a = 0.42; b = 0.30
        x = p[i, 0] * cos(a) + p[i, 2] * sin(a); z = p[i, 2] * cos(a) - p[i, 0] * sin(a)
        y = p[i, 1] * cos(b) - z * sin(b);       z = z * cos(b) + p[i, 1] * sin(b)
        u[i] = 70 + 240 * x / (9 - z); v[i] = 70 - 240 * y / (9 - z)
    }
    print "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
    print "<!-- SPDX-License-Identifier: MIT. Written by thirty-six.sh -->"
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"140mm\" height=\"140mm\" viewBox=\"0 0 140 140\" stroke=\"#000\" stroke-width=\".4\">"
    for (i = 0; i < n; i++) for (j = i + 1; j < n; j++) {
        d = 0; for (k = 0; k < 3; k++) d += (p[i, k] - p[j, k]) ^ 2
        if (d == 2) printf "  <line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\"/>\n", u[i], v[i], u[j], v[j]
    }
    print "</svg>"
}' > thirty-six.svg
