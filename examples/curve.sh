#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes curve.svg: a scarf in the wind, twenty curves that flow from one edge of the cloth to
# the other. The two edges are given by their points (joints with equal handles on either side,
# so that every mixture of the two is smooth); the curves between are mixed from them.
LC_ALL=C awk 'BEGIN {
    n = split("12 62  40 2    71 12  88 46 105 80   154 58 170 40 186 22  200 22 211 40", first)
    m = split("22 108 44 60   52 77  74 97  96 117  146 108 158 84 170 60  190 62 208 92", last)
    print "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
    print "<!-- SPDX-License-Identifier: MIT. Written by curve.sh -->"
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"220mm\" height=\"130mm\" viewBox=\"0 0 220 130\" fill=\"none\" stroke=\"#000\" stroke-width=\".4\">"
    curves = 20
    for (c = 0; c < curves; c++) {
        t = c / (curves - 1)
        t += 0.04 * sin(4 * 3.14159265 * t)     # folds: the curves crowd and part
        d = ""
        for (i = 1; i <= n; i += 2) {
            joint = int((i + 1) / 6)             # a joint moves with its handles
            w = t + 0.45 * sin(joint * 2.1 + 4 * t) * t * (1 - t)
            d = d sprintf("%s%.2f %.2f", i == 1 ? "M" : i == 3 ? "C" : " ", first[i] + (last[i] - first[i]) * w, first[i + 1] + (last[i + 1] - first[i + 1]) * w)
        }
        printf "  <path d=\"%s\"/>\n", d
    }
    print "</svg>"
}' > curve.svg
