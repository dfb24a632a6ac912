# SPDX-License-Identifier: MIT
# A plain SVG document by chance: awk -v seed=N -f plain_svg.awk. Numbers, separators and properties as the specifications
# allow them and programs write them; only what is plain, and only what cairo has no ways of its own with.
function below(n) { return int(rand() * n) }
function one_of(list,   a, n) { n = split(list, a, "|"); return a[1 + below(n)] }
function number(   k) {
    k = below(10)
    if (k < 3) return below(150) - 50
    if (k < 6) return sprintf("%.*f", 1 + below(7), rand() * 150 - 50)
    if (k < 8) return sprintf("%.3e", rand() * 90)
    if (k < 9) return "+" below(90) "."  below(9)
    return one_of(".5|-.25|0|007|1E1|-0.0|1e-3|33.3333333333333333")
}
function numbers(n,   s, i, v) { # no more between them than there has to be, now and then
    for (i = 0; i < n; i++) { v = number(); s = s (i && !(v ~ /^[-+]/ && below(2)) ? one_of(" |,| , |\n") : "") v }
    return s
}
function arc() { return numbers(3) " " one_of("0|1") one_of("|,| ") one_of("0|1") one_of("|,| ") numbers(2) }
function path(   d, i, c) {
    d = one_of("M|m") numbers(2)
    for (i = below(7); i >= 0; i--) {
        c = one_of("L|l|H|h|V|v|C|c|S|s|Q|q|T|t|A|a|z|Z|M|m")
        d = d one_of("| ") c (c ~ /[zZ]/ ? "" : c ~ /[aA]/ ? arc() : numbers((c ~ /[hHvV]/ ? 1 : c ~ /[cC]/ ? 6 : c ~ /[sSqQ]/ ? 4 : 2) * (1 + below(2))))
    }
    return d (d ~ /[mM][^a-zA-Z]*$/ ? "l9 9" : "")
}
function transform(   f) {
    f = one_of("translate|rotate|rotate|scale|skewX|matrix")
    if (f == "matrix") return "matrix(1." below(99) " ." below(99) "-." below(99) " 1 " numbers(2) ")"
    if (f == "scale") return "scale(" (1 + below(300) / 100) (below(2) ? " -." 1 + below(9) : "") ")"
    return f "(" (f == "skewX" ? below(120) - 60 : f == "rotate" && below(2) ? numbers(3) : number()) ")"
}
function property(   p) {
    p = one_of("fill|stroke|stroke-width|stroke-width|stroke-linecap|stroke-linejoin|stroke-miterlimit|stroke-dasharray|stroke-dashoffset|fill-rule|fill-opacity|stroke-opacity|color|visibility")
    if (p ~ /^(fill|stroke|color)$/) return p ":" one_of("#123|#abcdef|red|black|rgb(1, 20,255)|white" (p == "color" ? "" : "|none|currentColor"))
    if (p ~ /opacity/) return p ":" one_of("1|.5|0.25|0|.999")
    if (p ~ /width/) return p ":" one_of("1|2|.35|3px|1mm|0|2.5e0")
    if (p ~ /cap/) return p ":" one_of("butt|round")
    if (p ~ /join/) return p ":" one_of("miter|round|bevel")
    if (p ~ /miter/) return p ":" one_of("4|1.5|10")
    if (p ~ /array/) return p ":" one_of("none|3 4|5,2.5|1mm|7 , 3 2")
    if (p ~ /offset/) return p ":" one_of("0|3|-70.5")
    return p == "fill-rule" ? p ":" one_of("evenodd|nonzero") : p ":" one_of("visible|visible|hidden")
}
function style(   s, i, p) { # as attributes or as a style
    delete had
    for (i = below(4); i > 0; i--) {
        p = property()
        if (substr(p, 1, index(p, ":")) in had) continue
        had[substr(p, 1, index(p, ":"))]
        s = s (below(3) ? " " substr(p, 1, index(p, ":") - 1) "=\"" substr(p, index(p, ":") + 1) "\"" : " style=\"" p one_of(";|; |") "\"")
        if (s ~ /style=/) break
    }
    return s (below(3) ? "" : " transform=\"" transform() one_of("| |,") transform() "\"")
}
BEGIN {
    srand(seed)
    print "<svg xmlns='http://www.w3.org/2000/svg' width='" one_of("120|40mm|4.5in|200pt") "' height='" one_of("90|3cm|77.7") "' viewBox='" one_of("0 0 100 80|-3,2 240 180|0 0 1e3 700") "'>"
    for (i = 0; i < 30; i++) {
        group = !below(4)
        if (group) print "<g" style() ">"
        print "<path" style() " d=\"" path() "\"/>"
        if (group) print "</g>"
    }
    print "</svg>"
}
