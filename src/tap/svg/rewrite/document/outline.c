/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/document/outline.h"

#include <math.h>
#include <string.h>

#define PIECES_PER_CURVE 24 /* a quarter of a circle is then short by 0.02 % */

/* ---- path data ---------------------------------------------------------------------------------------------- */

typedef struct {
    path *path;
    point at, start;
    point cubic, quadratic; /* last control points, for smooth curves */
} pen;

static void arrive(pen *p, point to) { p->at = p->cubic = p->quadratic = to; }

static void curve_to(pen *p, point a, point b, point to)
{
    plb_path_curve(p->path, a, b, to);
    arrive(p, to);
    p->cubic = b;
}

static void quadratic_to(pen *p, point a, point to)
{
    plb_path_curve(p->path, point_mix(p->at, a, 2.0 / 3), point_mix(to, a, 2.0 / 3), to);
    arrive(p, to);
    p->quadratic = a;
}

static point mirrored(point about, point p) { return (point){2 * about.x - p.x, 2 * about.y - p.y}; }

/* Draws an elliptical arc by its ends (SVG 1.1, F.6.5 and F.6.6). */
static void arc_to(pen *p, const double v[7])
{
    point to = {v[5], v[6]};
    double rx = fabs(v[0]), ry = fabs(v[1]), turn = v[2] * PLB_PI / 180, c = cos(turn), s = sin(turn);
    if (rx == 0 || ry == 0 || (to.x == p->at.x && to.y == p->at.y)) {
        plb_path_line(p->path, to);
        arrive(p, to);
        return;
    }
    /* Half the chord in the ellipse's frame; radii that do not span the chord grow. */
    double hx = (p->at.x - to.x) / 2, hy = (p->at.y - to.y) / 2, x = c * hx + s * hy, y = -s * hx + c * hy;
    double too_far = x * x / (rx * rx) + y * y / (ry * ry);
    if (too_far > 1)
        rx *= sqrt(too_far), ry *= sqrt(too_far);
    double square = (rx * rx * ry * ry - rx * rx * y * y - ry * ry * x * x) / (rx * rx * y * y + ry * ry * x * x);
    double k = sqrt(fmax(square, 0)) * ((v[3] != 0) == (v[4] != 0) ? -1 : 1), cx = k * rx * y / ry, cy = -k * ry * x / rx;
    double from = atan2((y - cy) / ry, (x - cx) / rx), end = atan2((-y - cy) / ry, (-x - cx) / rx);
    if (v[4] != 0 && end < from)
        end += 2 * PLB_PI;
    if (v[4] == 0 && end > from)
        end -= 2 * PLB_PI;
    /* A unit circle, stretched, turned, moved to the centre. */
    point middle = {c * cx - s * cy + (p->at.x + to.x) / 2, s * cx + c * cy + (p->at.y + to.y) / 2};
    matrix map = {rx * c, rx * s, -ry * s, ry * c, middle.x, middle.y};
    plb_path_arc(p->path, (point){0, 0}, 1, from, end, v[4] == 0, map);
    arrive(p, to);
}

static bool read_number(const char **at, bool flag, double *v)
{
    *at += strspn(*at, " \t\r\n,");
    if (flag && (**at == '0' || **at == '1')) {
        *v = *(*at)++ - '0';
        return true;
    }
    char *end;
    *v = g_ascii_strtod(*at, &end);
    bool is_number = end > *at && isfinite(*v) && !memchr(*at, 'x', (size_t)(end - *at));
    *at = end;
    return is_number;
}

static int count_of(char letter)
{
    switch (letter) {
    case 'm': case 'l': case 't': return 2;
    case 'h': case 'v': return 1;
    case 'c': return 6;
    case 's': case 'q': return 4;
    case 'a': return 7;
    default: return 0;
    }
}

/* Draws one set of a command's numbers, already absolute. */
static void draw_command(pen *p, char letter, const double v[7])
{
    point a = {v[0], v[1]}, b = {v[2], v[3]}, c = {v[4], v[5]};
    switch (letter) {
    case 'm': plb_path_move(p->path, a); arrive(p, a); p->start = a; break;
    case 'l': plb_path_line(p->path, a); arrive(p, a); break;
    case 'h': a.y = p->at.y; plb_path_line(p->path, a); arrive(p, a); break;
    case 'v': a = (point){p->at.x, v[0]}; plb_path_line(p->path, a); arrive(p, a); break;
    case 'c': curve_to(p, a, b, c); break;
    case 's': curve_to(p, mirrored(p->at, p->cubic), a, b); break;
    case 'q': quadratic_to(p, a, b); break;
    case 't': quadratic_to(p, mirrored(p->at, p->quadratic), a); break;
    case 'a': arc_to(p, v); break;
    default: plb_path_close(p->path); arrive(p, p->start); break;
    }
}

static bool read_set(const pen *p, const char **at, char letter, bool is_relative, double v[7])
{
    for (int i = 0; i < count_of(letter); i++) {
        bool is_arc = letter == 'a';
        if (!read_number(at, is_arc && (i == 3 || i == 4), &v[i]))
            return false;
        if (!is_relative || (is_arc && i < 5))
            continue;
        bool is_y = letter == 'v' || (letter != 'h' && (is_arc ? i == 6 : i % 2 == 1));
        v[i] += is_y ? p->at.y : p->at.x;
    }
    return true;
}

static void add_data(path *out, const char *data)
{
    pen p = {.path = out};
    bool begun = false;
    for (const char *at = data + strspn(data, " \t\r\n,"); *at; at += strspn(at, " \t\r\n,")) {
        char letter = g_ascii_tolower(*at);
        bool is_relative = letter == *at;
        if (!strchr("mlhvcsqtaz", letter) || (!begun && letter != 'm'))
            return;
        at++;
        begun = true;
        do {
            double v[7] = {0};
            if (!read_set(&p, &at, letter, is_relative, v))
                return;
            draw_command(&p, letter, v);
            if (letter == 'm')
                letter = 'l';
            at += strspn(at, " \t\r\n,");
        } while (letter != 'z' && *at && strchr("+-.0123456789", *at));
    }
}

/* ---- shapes ------------------------------------------------------------------------------------------------- */

static void add_points(path *out, const xmlNode *n, bool closed)
{
    char *points = plb_node_get(n, "points");
    if (points) {
        char *data = g_strdup_printf("M%s%s", points, closed ? "Z" : "");
        add_data(out, data);
        g_free(data);
    }
    g_free(points);
}

/* Adds a rectangle with square corners, which are near enough for boxes and lengths of dashes. */
static void add_rectangle(path *out, const xmlNode *n, box view)
{
    double x = plb_node_length(n, "x", view.x1, 0), y = plb_node_length(n, "y", view.y1, 0);
    double w = plb_node_length(n, "width", view.x1, 0), h = plb_node_length(n, "height", view.y1, 0);
    if (!(w > 0 && h > 0))
        return;
    plb_path_move(out, (point){x, y});
    plb_path_line(out, (point){x + w, y});
    plb_path_line(out, (point){x + w, y + h});
    plb_path_line(out, (point){x, y + h});
    plb_path_close(out);
}

static void add_ellipse(path *out, const xmlNode *n, box view)
{
    double r = plb_node_length(n, "r", view.x1, 0), rx = plb_node_length(n, "rx", view.x1, r), ry = plb_node_length(n, "ry", view.y1, r);
    matrix m = {rx, 0, 0, ry, plb_node_length(n, "cx", view.x1, 0), plb_node_length(n, "cy", view.y1, 0)};
    if (!(rx > 0 && ry > 0))
        return;
    plb_path_arc(out, (point){0, 0}, 1, 0, 2 * PLB_PI, false, m);
    plb_path_close(out);
}

path plb_outline(const xmlNode *n)
{
    path out = {0};
    box view = plb_outline_viewport(n);
    view = (box){0, 0, view.x1 - view.x0, view.y1 - view.y0};
    if (plb_node_is(n, "path")) {
        char *data = plb_node_get(n, "d");
        add_data(&out, data ? data : "");
        g_free(data);
    } else if (plb_node_is(n, "rect")) {
        add_rectangle(&out, n, view);
    } else if (plb_node_is(n, "circle") || plb_node_is(n, "ellipse")) {
        add_ellipse(&out, n, view);
    } else if (plb_node_is(n, "line")) {
        plb_path_move(&out, (point){plb_node_length(n, "x1", view.x1, 0), plb_node_length(n, "y1", view.y1, 0)});
        plb_path_line(&out, (point){plb_node_length(n, "x2", view.x1, 0), plb_node_length(n, "y2", view.y1, 0)});
    } else if (plb_node_is(n, "polyline") || plb_node_is(n, "polygon")) {
        add_points(&out, n, plb_node_is(n, "polygon"));
    }
    return out;
}

/* ---- measures ----------------------------------------------------------------------------------------------- */

static point on_curve(point a, point b, point c, point d, double t)
{
    point ab = point_mix(a, b, t), bc = point_mix(b, c, t), cd = point_mix(c, d, t);
    return point_mix(point_mix(ab, bc, t), point_mix(bc, cd, t), t);
}

size_t plb_outline_points(const path *p, point **at, bool **jump)
{
    GArray *points = g_array_new(FALSE, FALSE, sizeof(point)), *jumps = g_array_new(FALSE, FALSE, sizeof(bool));
    point now = {0, 0}, start = {0, 0};
    size_t k = 0;
#define ADD(where, is_jump) do { now = (where); bool jumped = (is_jump); g_array_append_val(points, now); g_array_append_val(jumps, jumped); } while (0)
    for (size_t i = 0; i < p->ops.n; i++) {
        const point *v = p->points.v + k;
        switch (p->ops.v[i]) {
        case PATH_MOVE: ADD(v[0], true); start = now; k++; break;
        case PATH_LINE: ADD(v[0], false); k++; break;
        case PATH_CURVE: {
            point from = now;
            for (int j = 1; j <= PIECES_PER_CURVE; j++)
                ADD(on_curve(from, v[0], v[1], v[2], (double)j / PIECES_PER_CURVE), false);
            k += 3;
            break;
        }
        default: ADD(start, false); break;
        }
    }
#undef ADD
    size_t n = points->len;
    *at = (point *)(void *)g_array_free(points, FALSE);
    *jump = (bool *)(void *)g_array_free(jumps, FALSE);
    return n;
}

double plb_outline_length(const path *p)
{
    point *at;
    bool *jump;
    size_t n = plb_outline_points(p, &at, &jump);
    double length = 0;
    for (size_t i = 1; i < n; i++)
        length += jump[i] ? 0 : plb_point_distance(at[i - 1], at[i]);
    g_free(at);
    g_free(jump);
    return length;
}

static void add_box(box *b, const xmlNode *n, matrix m, int depth)
{
    path p = plb_outline(n);
    plb_path_transform(&p, m);
    box own = plb_path_bounds(&p);
    if (!plb_box_is_empty(own)) {
        plb_box_add(b, (point){own.x0, own.y0});
        plb_box_add(b, (point){own.x1, own.y1});
    }
    plb_path_free(&p);
    for (const xmlNode *c = n->children; c && depth < NODE_MAX_DEPTH; c = c->next) {
        if (c->type != XML_ELEMENT_NODE)
            continue;
        char *text = plb_node_get(c, "transform");
        matrix inner;
        if (plb_node_transform(text, &inner))
            add_box(b, c, plb_matrix_multiply(inner, m), depth + 1);
        g_free(text);
    }
}

box plb_outline_box(const xmlNode *n)
{
    box b = BOX_EMPTY;
    add_box(&b, n, MATRIX_IDENTITY, 0);
    return b;
}

/* ---- user spaces -------------------------------------------------------------------------------------------- */

static bool view_box(const xmlNode *n, box *b)
{
    char *text = plb_node_get(n, "viewBox");
    double v[4];
    const char *at = text;
    bool there = text != NULL;
    for (int i = 0; there && i < 4; i++)
        there = read_number(&at, false, &v[i]);
    g_free(text);
    if (there)
        *b = (box){v[0], v[1], v[0] + v[2], v[1] + v[3]};
    return there && v[2] > 0 && v[3] > 0;
}

box plb_outline_viewport(const xmlNode *n)
{
    const xmlNode *svg = n->parent;
    while (svg && !plb_node_is(svg, "svg"))
        svg = svg->parent;
    box view = {0, 0, 100, 100};
    if (svg && !view_box(svg, &view))
        view = (box){0, 0, plb_node_length(svg, "width", 100, 100), plb_node_length(svg, "height", 100, 100)};
    return view;
}

/* Maps an svg element's viewBox: the middle of the box on the middle of the viewport, the smaller scale for both
 * directions, the default of preserveAspectRatio. */
static matrix map_of_view_box(const xmlNode *n)
{
    box view;
    bool is_outermost = !n->parent || n->parent->type != XML_ELEMENT_NODE;
    point at = {is_outermost ? 0 : plb_node_length(n, "x", 100, 0), is_outermost ? 0 : plb_node_length(n, "y", 100, 0)};
    if (!view_box(n, &view))
        return (matrix){1, 0, 0, 1, at.x, at.y};
    double bw = view.x1 - view.x0, bh = view.y1 - view.y0, w = plb_node_length(n, "width", bw, bw), h = plb_node_length(n, "height", bh, bh);
    double k = fmin(w / bw, h / bh);
    return (matrix){k, 0, 0, k, at.x + (w - k * bw) / 2 - k * view.x0, at.y + (h - k * bh) / 2 - k * view.y0};
}

matrix plb_outline_to_root(const xmlNode *n, bool itself)
{
    matrix m = MATRIX_IDENTITY;
    for (const xmlNode *up = itself ? n : n->parent; up && up->type == XML_ELEMENT_NODE; up = up->parent) {
        matrix own = MATRIX_IDENTITY;
        char *text = plb_node_get(up, "transform");
        if (plb_node_is(up, "svg") && up != n)
            m = plb_matrix_multiply(m, map_of_view_box(up));
        if (plb_node_transform(text, &own))
            m = plb_matrix_multiply(m, own);
        g_free(text);
    }
    return m;
}
