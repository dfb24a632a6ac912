/* SPDX-License-Identifier: MIT */
#include "tap/plain/plain_style.h"

#include "tap/common/tap_colour.h"

#include <math.h>
#include <string.h>

plain_style plb_plain_style(void)
{
    return (plain_style){.stroke = {.is_none = true}, .pen = {.width = 1, .miter_limit = 4}, .fill_opacity = 1, .stroke_opacity = 1};
}

/* librsvg keeps opacities in steps of 1/255. */
static plain_paint resolve(const plain_style *s, plain_paint p, double opacity)
{
    if (p.is_current)
        p = s->colour;
    p.alpha = (unsigned char)round(opacity * 255);
    p.is_none = p.is_none || !p.alpha;
    return p;
}

plain_paint plb_plain_fill(const plain_style *s) { return resolve(s, s->fill, s->fill_opacity); }
plain_paint plb_plain_stroke(const plain_style *s) { return resolve(s, s->stroke, s->stroke_opacity); }

/* ---- properties --------------------------------------------------------------------------------------------- */

static bool set_solid(plain_paint *p, plain_text value)
{
    unsigned rgb;
    if (!plb_tap_colour(value.at, value.end, &rgb))
        return false;
    *p = (plain_paint){.red = (unsigned char)(rgb >> 16), .green = (unsigned char)(rgb >> 8 & 255), .blue = (unsigned char)(rgb & 255)};
    return true;
}

static bool set_paint(plain_paint *p, plain_text value)
{
    if (plb_plain_is(value, "none")) {
        *p = (plain_paint){.is_none = true};
        return true;
    }
    if (plb_plain_is(value, "currentColor")) {
        *p = (plain_paint){.is_current = true};
        return true;
    }
    return set_solid(p, value);
}

static bool set_fill(plain_style *s, plain_text value) { return set_paint(&s->fill, value); }
static bool set_stroke(plain_style *s, plain_text value) { return set_paint(&s->stroke, value); }

static bool set_colour(plain_style *s, plain_text value) { return set_solid(&s->colour, value); }

static bool read_opacity(plain_text value, double *v)
{
    bool ok = plb_plain_css_number(&value, v) && value.at == value.end;
    *v = fmin(fmax(*v, 0), 1);
    return ok;
}

static bool set_fill_opacity(plain_style *s, plain_text value) { return read_opacity(value, &s->fill_opacity); }
static bool set_stroke_opacity(plain_style *s, plain_text value) { return read_opacity(value, &s->stroke_opacity); }

static bool set_width(plain_style *s, plain_text value) { return plb_plain_length(value, &s->pen.width) && s->pen.width >= 0; }

static bool set_miter_limit(plain_style *s, plain_text value)
{
    return plb_plain_css_number(&value, &s->pen.miter_limit) && value.at == value.end && s->pen.miter_limit >= 1;
}

/* Gives the index of the value among the words; -1: it is none of them. */
static int find_word(plain_text value, const char *const words[], int n)
{
    while (n-- && !plb_plain_is(value, words[n])) {}
    return n;
}

static bool set_cap(plain_style *s, plain_text value)
{
    static const char *const words[] = {[PLAIN_BUTT] = "butt", [PLAIN_ROUND] = "round", [PLAIN_SQUARE] = "square"};
    int found = find_word(value, words, 3);
    s->pen.cap = (plain_cap)(found < 0 ? 0 : found);
    return found >= 0;
}

static bool set_join(plain_style *s, plain_text value)
{
    static const char *const words[] = {[PLAIN_MITER] = "miter", [PLAIN_ROUNDED] = "round", [PLAIN_BEVEL] = "bevel"};
    int found = find_word(value, words, 3);
    s->pen.join = (plain_join)(found < 0 ? 0 : found);
    return found >= 0;
}

static bool set_rule(plain_style *s, plain_text value)
{
    s->even_odd = plb_plain_is(value, "evenodd");
    return s->even_odd || plb_plain_is(value, "nonzero");
}

/* Reads dashes; refuses dashes without length, which have meanings of their own to librsvg and cairo, unless there are no others. */
static bool set_dashes(plain_style *s, plain_text value)
{
    double *dashes = s->pen.dashes;
    int n = 0, zeros = 0;
    s->pen.n_dashes = 0;
    if (plb_plain_is(value, "none"))
        return true;
    for (const char *before = NULL; value.at < value.end && value.at != before; n++) {
        if (n == PLAIN_DASHES || !plb_plain_next_length(&value, &dashes[n]) || dashes[n] < 0)
            return false;
        zeros += dashes[n] == 0;
        before = value.at;
        plb_plain_comma(&value);
    }
    if (!n || value.at < value.end || value.end[-1] == ',' || (zeros && zeros < n))
        return false;
    s->pen.n_dashes = zeros ? 0 : n;
    return true;
}

static bool set_dash_offset(plain_style *s, plain_text value) { return plb_plain_length(value, &s->pen.dash_offset); }

static bool set_visibility(plain_style *s, plain_text value)
{
    s->is_hidden = plb_plain_is(value, "hidden") || plb_plain_is(value, "collapse");
    return s->is_hidden || plb_plain_is(value, "visible");
}

static bool set_display(plain_style *s, plain_text value)
{
    s->is_gone = plb_plain_is(value, "none");
    return s->is_gone || plb_plain_is(value, "inline") || plb_plain_is(value, "block");
}

/* Opaque. */
static bool is_one(plain_style *s, plain_text value)
{
    double v;
    (void)s;
    return plb_plain_css_number(&value, &v) && value.at == value.end && v >= 1;
}

static bool is_none(plain_style *s, plain_text value)
{
    (void)s;
    return plb_plain_is(value, "none");
}

/* Tells whether the inside is painted before the line. */
static bool is_usual_order(plain_style *s, plain_text value)
{
    static const char *const words[] = {"normal", "fill", "fill stroke", "fill stroke markers", "markers fill stroke", NULL};
    (void)s;
    return plb_plain_is_any(value, words);
}

static bool is_normal(plain_style *s, plain_text value)
{
    (void)s;
    return plb_plain_is(value, "normal") || plb_plain_is(value, "auto");
}

typedef struct {
    const char *name;
    bool (*set)(plain_style *s, plain_text value);
} property;

static const property properties[] = {
    {"fill", set_fill},
    {"stroke", set_stroke},
    {"color", set_colour},
    {"fill-opacity", set_fill_opacity},
    {"stroke-opacity", set_stroke_opacity},
    {"stroke-width", set_width},
    {"stroke-linecap", set_cap},
    {"stroke-linejoin", set_join},
    {"stroke-miterlimit", set_miter_limit},
    {"stroke-dasharray", set_dashes},
    {"stroke-dashoffset", set_dash_offset},
    {"fill-rule", set_rule},
    {"visibility", set_visibility},
    {"display", set_display},
    {"opacity", is_one},
    {"clip-path", is_none},
    {"mask", is_none},
    {"filter", is_none},
    {"marker", is_none},
    {"marker-start", is_none},
    {"marker-mid", is_none},
    {"marker-end", is_none},
    {"vector-effect", is_none},
    {"paint-order", is_usual_order},
    {"mix-blend-mode", is_normal},
    {"isolation", is_normal},
};

/* These properties are more than this reader knows, in one version of SVG or CSS or another, and whether or not librsvg
 * knows them. All others have no effect at all, or none without text, gradients and filters. */
static const char *const beyond[] = {
    "transform", "transform-origin", "transform-box", "translate", "rotate", "scale", "offset", "offset-path", "offset-distance",
    "offset-position", "offset-anchor", "offset-rotate", "perspective", "zoom", "clip", "contain", "content", "all", "mask-image",
    "mask-border", "mask-border-source", "backdrop-filter", "will-change", "stroke-alignment", "stroke-align", "stroke-dashcorner",
    "stroke-dashadjust", "stroke-dash-corner", "stroke-dash-justify", "stroke-image", "stroke-position", "fill-image", "pathLength",
    "requiredFeatures", "requiredExtensions", "systemLanguage", "externalResourcesRequired", "d", "x", "y", "width", "height",
    "cx", "cy", "r", "rx", "ry", NULL,
};

bool plb_plain_property(plain_style *s, plain_text name, plain_text value)
{
    for (size_t i = 0; i < sizeof properties / sizeof *properties; i++)
        if (plb_plain_is(name, properties[i].name))
            return properties[i].set(s, plb_plain_trim(value));
    return !plb_plain_is_any(name, beyond);
}

/* ---- style attributes --------------------------------------------------------------------------------------- */

/* Gives the end of a declaration: a semicolon outside of quotes. NULL: CSS reads the text in ways of its own, as lines
 * that end within quotes, and brackets that are not closed before the semicolon. */
static const char *end_of_declaration(plain_text t)
{
    char quote = '\0';
    int open = 0;
    for (; t.at < t.end && (quote || *t.at != ';'); t.at++) {
        if (memchr("\\!{}[]@*<", *t.at, 9) || (quote && *t.at == '\n'))
            return NULL;
        if (*t.at == quote)
            quote = '\0';
        else if (!quote && (*t.at == '"' || *t.at == '\''))
            quote = *t.at;
        else if (!quote)
            open += (*t.at == '(') - (*t.at == ')');
        if (open < 0)
            return NULL;
    }
    return quote || open ? NULL : t.at;
}

/* Tells whether a property is written in lower case: CSS reads capital letters like small ones, librsvg does not. */
static bool is_lower_word(plain_text t)
{
    const char *at = t.at;
    while (at < t.end && ((*at >= 'a' && *at <= 'z') || *at == '-' || (*at >= '0' && *at <= '9')))
        at++;
    return at == t.end && at > t.at;
}

static bool read_declaration(plain_style *s, plain_text t)
{
    t = plb_plain_trim(t);
    const char *colon = t.at == t.end ? NULL : memchr(t.at, ':', (size_t)(t.end - t.at));
    if (!colon)
        return t.at == t.end;
    plain_text name = plb_plain_trim((plain_text){t.at, colon});
    return is_lower_word(name) && plb_plain_property(s, name, (plain_text){colon + 1, t.end});
}

bool plb_plain_declarations(plain_style *s, plain_text style)
{
    while (style.at < style.end) {
        const char *end = end_of_declaration(style);
        if (!end || !read_declaration(s, (plain_text){style.at, end}))
            return false;
        style.at = end < style.end ? end + 1 : end;
    }
    return true;
}

/* ---- transforms --------------------------------------------------------------------------------------------- */

/* Brings an angle into one turn from 0 on. */
double plb_plain_radians(double degrees)
{
    double turn = fmod(degrees * (PLB_PI / 180), PLB_PI * 2);
    return turn < 0 ? turn + PLB_PI * 2 : turn;
}

static matrix translation(double x, double y) { return (matrix){1, 0, 0, 1, x, y}; }

static matrix rotation(double degrees)
{
    double a = plb_plain_radians(degrees), c = cos(a), s = sin(a);
    return (matrix){c, s, -s, c, 0, 0};
}

static bool make_matrix(const double *v, int n, matrix *m)
{
    (void)n;
    *m = (matrix){v[0], v[1], v[2], v[3], v[4], v[5]};
    return true;
}

static bool make_translation(const double *v, int n, matrix *m)
{
    *m = translation(v[0], n > 1 ? v[1] : 0);
    return true;
}

static bool make_scale(const double *v, int n, matrix *m)
{
    *m = (matrix){v[0], 0, 0, n > 1 ? v[1] : v[0], 0, 0};
    return true;
}

static bool make_rotation(const double *v, int n, matrix *m)
{
    *m = n > 1 ? plb_matrix_multiply(translation(-v[1], -v[2]), plb_matrix_multiply(rotation(v[0]), translation(v[1], v[2]))) : rotation(v[0]);
    return n != 2;
}

static bool make_skew_x(const double *v, int n, matrix *m)
{
    (void)n;
    *m = (matrix){1, 0, tan(plb_plain_radians(v[0])), 1, 0, 0};
    return true;
}

static bool make_skew_y(const double *v, int n, matrix *m)
{
    (void)n;
    *m = (matrix){1, tan(plb_plain_radians(v[0])), 0, 1, 0, 0};
    return true;
}

typedef struct {
    const char *name;
    int least, most; /* numbers */
    bool (*make)(const double *v, int n, matrix *m);
} function;

static const function functions[] = {
    {"matrix", 6, 6, make_matrix}, {"translate", 1, 2, make_translation}, {"scale", 1, 2, make_scale},
    {"rotate", 1, 3, make_rotation}, {"skewX", 1, 1, make_skew_x},        {"skewY", 1, 1, make_skew_y},
};

static const function *find_function(plain_text *t)
{
    plain_text name = {t->at, t->at};
    while (name.end < t->end && ((*name.end | 32) >= 'a' && (*name.end | 32) <= 'z'))
        name.end++;
    t->at = name.end;
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (plb_plain_is(name, functions[i].name))
            return &functions[i];
    return NULL;
}

/* Reads ( NUMBERS ), with commas between them. */
static bool read_arguments(plain_text *t, const function *f, double v[6], int *n)
{
    plb_plain_blank(t);
    if (t->at == t->end || *t->at++ != '(')
        return false;
    plb_plain_blank(t);
    for (*n = 0; t->at < t->end && *t->at != ')'; ++*n) {
        if (*n == f->most || !plb_plain_css_number(t, &v[*n]))
            return false;
        plb_plain_comma(t);
    }
    return *n >= f->least && t->at < t->end && t->at[-1] != ',' && *t->at++ == ')';
}

/* Tells whether the matrix is far from singular. */
static bool is_regular(matrix m)
{
    double size = fabs(m.xx) + fabs(m.yx) + fabs(m.xy) + fabs(m.yy), det = fabs(m.xx * m.yy - m.yx * m.xy);
    return isfinite(size) && isfinite(m.x0) && isfinite(m.y0) && det > 1e-9 * size * size;
}

bool plb_plain_transform(plain_text t, matrix *m)
{
    double v[6];
    int n;
    *m = (matrix){1, 0, 0, 1, 0, 0};
    t = plb_plain_trim(t);
    while (t.at < t.end) {
        const function *f = find_function(&t);
        matrix one;
        if (!f || !read_arguments(&t, f, v, &n) || !f->make(v, n, &one))
            return false;
        *m = plb_matrix_multiply(one, *m);
        plb_plain_comma(&t);
    }
    return is_regular(*m);
}
