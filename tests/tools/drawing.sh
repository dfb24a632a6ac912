#!/bin/sh
# SPDX-License-Identifier: MIT
# drawing.sh KIND [N]: writes a drawing to measure by, as SVG, to standard output; always the same one.
#   barn       a barn of 40 lines, 800 by 600 px
#   segments   N straight lines as a CAD plan has them, on 2000 by 1500 px: walls, doors, hatching, dimensions
#   curves     N cubic curves, each a path of its own, on 2000 by 1500 px
#   strokes    N lines of 13 mm anywhere on A4
#   labels     N numbers of four digits and a letter in rows and columns on A4, in letters of 2 mm
#   fills      N discs, boxes and triangles of 1 to 3 mm anywhere on A4, each in a colour of its own
#   scatter    N open circles of 1.4 mm, denser in the middle of A4
#   contours   N contour lines of 200 points around four peaks on A4
#   hatching   a page of 6,000 hatch lines in fields of several directions, on 2000 by 1500 px
LC_ALL=C awk -v kind="$1" -v n="${2:-0}" '
function page(w, h, width) {
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"#000\" stroke-width=\"%s\">\n", w, h, width
}
# A4, lying, in units of 1/96 inch.
function sheet() { print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"297mm\" height=\"210mm\" viewBox=\"0 0 1122.5 793.7\" font-family=\"sans-serif\" font-size=\"7\">" }
# Two decimals, as CAD programs write them.
function line(x0, y0, x1, y1) { if (drawn++ < n) printf "<path d=\"M%.2f %.2fL%.2f %.2f\"/>\n", x0, y0, x1, y1 }
function box(x, y, w, h) { line(x, y, x + w, y); line(x + w, y, x + w, y + h); line(x + w, y + h, x, y + h); line(x, y + h, x, y) }
# Uniform in [low, high): a linear congruence whose products stay exact (Park and Miller 1988).
function random(low, high) { state = state * 16807 % 2147483647; return low + (high - low) * state / 2147483647 }

function barn(    k) {
    box(140, 280, 240, 220); line(140, 280, 260, 160); line(260, 160, 380, 280)        # gable: 6
    line(260, 160, 560, 130); line(380, 280, 680, 250); line(560, 130, 680, 250)       # roof: 9
    line(680, 250, 680, 465); line(680, 465, 380, 500)                                 # side: 11
    box(215, 370, 90, 130); line(215, 370, 305, 500); line(305, 370, 215, 500)         # door: 17
    box(240, 225, 40, 40); line(260, 225, 260, 265); line(240, 245, 280, 245)          # loft: 23
    for (k = 1; k <= 8; k++) line(380 + 34 * k, 280 - 3.5 * k, 380 + 34 * k, 500 - 4 * k)           # boards: 31
    for (k = 1; k <= 7; k++) line(260 + 17 * k, 160 + 17 * k, 560 + 15 * k, 130 + 15 * k)           # roofing: 38
    line(40, 520, 380, 500); line(680, 465, 780, 480)                                  # ground: 40
}
# A room of w by h with its corner at (x, y): double walls, a door, a window, dimensions, and then hatching.
function room(x, y, w, h, hatches,    k, t, d) {
    box(x, y, w, h); box(x + 5, y + 5, w - 10, h - 10)
    d = random(.15, .3) * w
    line(x + d, y + h, x + d, y + h - .2 * w); line(x + d, y + h - .2 * w, x + d + .15 * w, y + h - .12 * w)
    line(x + .6 * w, y + 1.7, x + .85 * w, y + 1.7); line(x + .6 * w, y + 3.3, x + .85 * w, y + 3.3)
    line(x, y - 9, x + w, y - 9); line(x, y - 12, x, y - 2); line(x + w, y - 12, x + w, y - 2)
    line(x - 9, y, x - 9, y + h); line(x - 12, y, x - 2, y); line(x - 12, y + h, x - 2, y + h)
    box(x + random(.3, .4) * w, y + random(.3, .4) * h, .25 * w, .3 * h)
    for (k = 0; k < hatches; k++) {                             # at 45 degrees, within the walls
        t = (k + .5) / hatches * (w + h - 20)
        line(x + 5 + (t > h - 10 ? t - h + 10 : 0), y + 5 + (t > h - 10 ? h - 10 : t), \
             x + 5 + (t > w - 10 ? w - 10 : t), y + 5 + (t > w - 10 ? t - w + 10 : 0))
    }
}
function plan(    across, down, w, h, i, j, hatches) {
    hatches = n > 5000 ? 28 : 10
    across = int(sqrt(n / (22 + hatches) * 4 / 3)) + 1
    down = int(n / (22 + hatches) / across) + 1
    w = 1960 / across; h = 1460 / down
    for (j = 0; j < down; j++) for (i = 0; i < across; i++) room(30 + i * w, 30 + j * h, w - 16, h - 16, hatches)
}
function curve(    x, y, k, d) {
    x = random(40, 1960); y = random(40, 1460); d = "M" sprintf("%.2f %.2f", x, y) "C"
    for (k = 0; k < 3; k++) d = d sprintf("%.2f %.2f ", x + random(-60, 60), y + random(-60, 60))
    print "<path d=\"" d "\"/>"
}
function strokes(    k, x, y, turn) {
    for (k = 0; k < n; k++) {
        x = random(50, 740); y = random(50, 1070); turn = random(0, 6.2831853)
        line(x, y, x + 49.13 * cos(turn), y + 49.13 * sin(turn))
    }
}
function hatching(    i, j, k, x, y) {
    for (j = 0; j < 6; j++) for (i = 0; i < 8; i++) {
        x = 20 + 246 * i; y = 20 + 245 * j
        for (k = 0; k < 125; k++) {
            if ((i + j) % 3 == 0) line(x, y + 1.9 * k, x + 236, y + 1.9 * k)
            else if ((i + j) % 3 == 1) line(x + 1.9 * k, y, x + 1.9 * k, y + 236)
            else line(x + (k > 62 ? 3.8 * (k - 62) : 0), y + (k > 62 ? 236 : 3.8 * k), x + (k > 62 ? 236 : 3.8 * k), y + (k > 62 ? 3.8 * (k - 62) : 0))
        }
    }
}
function labels(    k, across) {
    across = int(sqrt(n * .47)) + 1
    for (k = 0; k < n; k++)
        printf "<text x=\"%.2f\" y=\"%.2f\">%s%d</text>\n", 10 + k % across * 1100 / across, 12 + int(k / across) * 775 * across / n, substr("xyPT", k % 4 + 1, 1), k * 7919 % 9000 + 1000
}
function colour() { return sprintf("#%02x%02x%02x", random(0, 256), random(0, 256), random(0, 256)) }
function fills(    k, x, y, s) {
    for (k = 0; k < n; k++) {
        x = random(10, 1100); y = random(10, 780); s = random(2, 5)
        if (k % 3 == 0) printf "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\" fill=\"%s\"/>\n", x, y, s, colour()
        else if (k % 3 == 1) printf "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"%s\"/>\n", x, y, 2 * s, s, colour()
        else printf "<path d=\"M%.2f %.2fl%.2f %.2fh%.2fz\" fill=\"%s\"/>\n", x, y, s, 2 * s, -2 * s, colour()
    }
}
function scatter(    k) {
    for (k = 0; k < n; k++)
        printf "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"2.7\" fill=\"none\" stroke=\"#000\" stroke-width=\".75\"/>\n", \
            560 + random(-180, 180) + random(-180, 180) + random(-180, 180), 397 + random(-120, 120) + random(-120, 120) + random(-120, 120)
}
function contours(    k, j, a, r, x, y, w) {
    for (k = 0; k < n; k++) {
        x = 300 + k % 2 * 500; y = 240 + int(k / 2) % 2 * 300; r = 6 + k * 225 / n
        printf "<path fill=\"none\" stroke=\"#000\" stroke-width=\".75\" d=\"M"
        for (j = 0; j < 200; j++) {
            a = j * .031415926; w = r * (1 + .15 * sin(3 * a + k % 4) + .08 * sin(7 * a))
            printf "%.2f %.2f ", x + w * cos(a), y + .8 * w * sin(a)
        }
        print "z\"/>"
    }
}
BEGIN {
    state = 20081
    if (kind == "barn") { n = 40; page(800, 600, "1.5"); barn() }
    else if (kind == "segments") { page(2000, 1500, "1"); plan() }
    else if (kind == "curves") { page(2000, 1500, "1"); for (k = 0; k < n; k++) curve() }
    else if (kind == "strokes") { page(794, 1123, "1"); strokes() }
    else if (kind == "hatching") { n = 6000; page(2000, 1500, "1"); hatching() }
    else if (kind == "labels") { sheet(); labels() }
    else if (kind == "fills") { sheet(); fills() }
    else if (kind == "scatter") { sheet(); scatter() }
    else if (kind == "contours") { sheet(); contours() }
    else { print "usage: drawing.sh barn|segments|curves|strokes|hatching|labels|fills|scatter|contours [N]" >"/dev/stderr"; exit 2 }
    print "</svg>"
}'
