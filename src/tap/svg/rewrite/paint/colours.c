/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/paint/colours.h"

#include "base/geometry/geom.h"
#include "tap/common/tap_colour.h"

#include <math.h>
#include <string.h>

#define MAX_NESTING 8 /* of mixtures in mixtures */

/* A colour is red, green, blue in sRGB's curve, 0 to 1 (beyond: out of gamut), and alpha. */
typedef struct {
    double v[3], alpha;
} colour;

/* The arguments of a function are numbers, each with its unit's meaning left to the caller. */
typedef struct {
    double v[4];
    bool is_share[4]; /* written with % */
    int n;
} arguments;

static bool read_colour(const char *text, size_t length, int depth, colour *c);

/* ---- colour spaces (the fourth colour module of CSS, sections 10 to 15 and its sample code) ------------------------------------- */

static double encode(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055; }

static colour from_linear(double r, double g, double b, double alpha) { return (colour){{encode(r), encode(g), encode(b)}, alpha}; }

static colour from_xyz65(double x, double y, double z, double alpha)
{
    return from_linear(3.2409699419 * x - 1.5373831776 * y - 0.4986107603 * z, -0.9692436363 * x + 1.8759675015 * y + 0.0415550574 * z,
                       0.0556300797 * x - 0.2039769589 * y + 1.0569715142 * z, alpha);
}

static colour from_oklab(double l, double a, double b, double alpha)
{
    double p = l + 0.3963377774 * a + 0.2158037573 * b, q = l - 0.1055613458 * a - 0.0638541728 * b, r = l - 0.0894841775 * a - 1.2914855480 * b;
    p = p * p * p, q = q * q * q, r = r * r * r;
    return from_linear(4.0767416621 * p - 3.3077115913 * q + 0.2309699292 * r, -1.2684380046 * p + 2.6097574011 * q - 0.3413193965 * r,
                       -0.0041960863 * p - 0.7034186147 * q + 1.7076147010 * r, alpha);
}

/* Maps one axis of CIE Lab back to a share of the white point. */
static double from_cube_root(double f) { return f > 6.0 / 29 ? f * f * f : 3 * (6.0 / 29) * (6.0 / 29) * (f - 4.0 / 29); }

static colour from_lab(double l, double a, double b, double alpha)
{
    double f = (l + 16) / 116;
    double x = 0.9642956764 * from_cube_root(f + a / 500), y = from_cube_root(f), z = 0.8251046025 * from_cube_root(f - b / 200);
    /* Adapts from the white point D50 to D65 by Bradford's matrix. */
    return from_xyz65(0.9554734528 * x - 0.0230985369 * y + 0.0632593086 * z, -0.0283697070 * x + 1.0099954580 * y + 0.0210415381 * z,
                      0.0123140017 * x - 0.0205076965 * y + 1.3303659366 * z, alpha);
}

static colour from_hue(double hue, double white, double black, double alpha)
{
    colour c = {{0}, alpha};
    double sum = white + black, h = fmod(fmod(hue, 360) + 360, 360) / 60;
    for (int i = 0; i < 3; i++) {
        double k = fmod(h + (i == 0 ? 0 : i == 1 ? 4 : 2), 6); /* the channel's place on the wheel */
        double pure = fmin(fmax(fabs(k - 3) - 1, 0), 1);
        c.v[i] = sum >= 1 ? white / sum : pure * (1 - sum) + white;
    }
    return c;
}

/* ---- reading ------------------------------------------------------------------------------------------------ */

/* Reads numbers between `at` and `end`, parted by blanks, commas or a stroke before the alpha; `none` is 0. */
static bool read_numbers(const char *at, const char *end, arguments *a)
{
    for (a->n = 0; at < end;) {
        at += strspn(at, " \t\r\n,/");
        if (at >= end)
            break;
        char *after;
        double v = g_ascii_strtod(at, &after);
        if (!strncmp(at, "none", 4))
            v = 0, after = (char *)(guintptr)at + 4;
        if (after == at || a->n == 4)
            return false;
        a->is_share[a->n] = *after == '%';
        if (!strncmp(after, "rad", 3))
            v *= 180 / PLB_PI;
        else if (!strncmp(after, "turn", 4))
            v *= 360;
        a->v[a->n++] = v;
        at = after + (*after == '%') + strspn(after, "abcdefghijklmnopqrstuvwxyz");
    }
    return a->n >= 3;
}

/* Gives argument `i`, of which 100 % stand for `whole`. */
static double value_of(const arguments *a, int i, double whole) { return a->is_share[i] ? a->v[i] / 100 * whole : a->v[i]; }
static double alpha_of(const arguments *a) { return a->n > 3 ? value_of(a, 3, 1) : 1; }

static colour polar(colour (*from)(double, double, double, double), double l, double chroma, double degrees, double alpha)
{
    double h = degrees * PLB_PI / 180;
    return from(l, chroma * cos(h), chroma * sin(h), alpha);
}

/* Makes a colour by the name of its space: wide gamuts are taken as sRGB, whose greys they share. */
static bool read_space(const char *at, const char *end, colour *c)
{
    at += strspn(at, " \t\r\n");
    size_t length = strcspn(at, " \t\r\n");
    arguments a;
    if (!read_numbers(at + length, end, &a))
        return false;
    double v[3] = {value_of(&a, 0, 1), value_of(&a, 1, 1), value_of(&a, 2, 1)};
    if (!strncmp(at, "xyz", 3))
        *c = from_xyz65(v[0], v[1], v[2], alpha_of(&a));
    else if (length == 11 && !strncmp(at, "srgb-linear", length))
        *c = from_linear(v[0], v[1], v[2], alpha_of(&a));
    else
        *c = (colour){{v[0], v[1], v[2]}, alpha_of(&a)};
    return true;
}

static bool read_function(const char *name, size_t length, const char *at, const char *end, colour *c)
{
    arguments a;
    bool same = false;
#define IS(word) (same = length == sizeof word - 1 && !strncmp(name, word, length))
    if (IS("color"))
        return read_space(at, end, c);
    if (!read_numbers(at, end, &a))
        return false;
    double alpha = alpha_of(&a);
    if (IS("oklch"))
        *c = polar(from_oklab, value_of(&a, 0, 1), value_of(&a, 1, 0.4), a.v[2], alpha);
    else if (IS("oklab"))
        *c = from_oklab(value_of(&a, 0, 1), value_of(&a, 1, 0.4), value_of(&a, 2, 0.4), alpha);
    else if (IS("lch"))
        *c = polar(from_lab, value_of(&a, 0, 100), value_of(&a, 1, 150), a.v[2], alpha);
    else if (IS("lab"))
        *c = from_lab(value_of(&a, 0, 100), value_of(&a, 1, 125), value_of(&a, 2, 125), alpha);
    else if (IS("hwb"))
        *c = from_hue(a.v[0], a.v[1] / 100, a.v[2] / 100, alpha);
    else if (IS("hsl") || IS("hsla")) {
        double l = a.v[2] / 100, s = a.v[1] / 100 * fmin(l, 1 - l);
        *c = from_hue(a.v[0], l - s, 1 - l - s, alpha);
    } else if (IS("rgb") || IS("rgba"))
        *c = (colour){{value_of(&a, 0, 255) / 255, value_of(&a, 1, 255) / 255, value_of(&a, 2, 255) / 255}, alpha};
#undef IS
    return same;
}

/* Gives the end of an argument: a comma outside brackets, or `end`. */
static const char *end_of_argument(const char *at, const char *end)
{
    int depth = 0;
    for (; at < end && (depth || *at != ','); at++)
        depth += (*at == '(') - (*at == ')');
    return at;
}

/* Reads "COLOUR 30%" or "30% COLOUR"; the share is -1 where none is said. */
static bool read_part(const char *at, const char *end, int depth, colour *c, double *share)
{
    char *text = g_strstrip(g_strndup(at, (gsize)(end - at)));
    size_t length = strlen(text);
    *share = -1;
    char *after, *last = length && text[length - 1] == '%' ? strrchr(text, ' ') : NULL;
    double v = g_ascii_strtod(text, &after);
    const char *name = text;
    if (after > text && *after == '%') {
        *share = v / 100;
        name = after + 1 + strspn(after + 1, " ");
    } else if (last) {
        *share = g_ascii_strtod(last, NULL) / 100;
        *last = '\0';
    }
    bool ok = read_colour(name, strlen(name), depth + 1, c);
    g_free(text);
    return ok;
}

/* Mixes two colours in the shares p and q, as sRGB, premultiplied (fifth colour module of CSS, section 3). */
static bool read_mix(const char *at, const char *end, int depth, colour *c)
{
    const char *first = end_of_argument(at, end), *second = first < end ? end_of_argument(first + 1, end) : end;
    colour a, b;
    double p, q;
    if (second >= end || !read_part(first + 1, second, depth, &a, &p) || !read_part(second + 1, end, depth, &b, &q))
        return false;
    if (p < 0 && q < 0)
        p = q = 0.5;
    else if (p < 0)
        p = 1 - q;
    else if (q < 0)
        q = 1 - p;
    double sum = p + q, alpha = (a.alpha * p + b.alpha * q) / sum;
    for (int i = 0; i < 3; i++)
        c->v[i] = alpha > 0 ? (a.v[i] * a.alpha * p + b.v[i] * b.alpha * q) / sum / alpha : 0;
    c->alpha = alpha * fmin(sum, 1);
    return sum > 0;
}

static bool read_hex(const char *text, size_t length, colour *c)
{
    double digits[8] = {0};
    for (size_t i = 0; i < length; i++) {
        int digit = g_ascii_xdigit_value(text[i]);
        if (digit < 0 || length > 8)
            return false;
        digits[i] = digit;
    }
    bool is_short = length < 5;
    for (size_t i = 0; i < 3; i++)
        c->v[i] = is_short ? digits[i] / 15 : (digits[2 * i] * 16 + digits[2 * i + 1]) / 255;
    c->alpha = length == 4 ? digits[3] / 15 : length == 8 ? (digits[6] * 16 + digits[7]) / 255 : 1;
    return length == 3 || length == 4 || length == 6 || length == 8;
}

static bool read_name(const char *text, size_t length, colour *c)
{
    unsigned rgb;
    if (length == 11 && !g_ascii_strncasecmp(text, "transparent", 11)) {
        *c = (colour){{0, 0, 0}, 0};
        return true;
    }
    if (!plb_tap_colour(text, text + length, &rgb))
        return false;
    *c = (colour){{(rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0}, 1};
    return true;
}

static bool read_colour(const char *text, size_t length, int depth, colour *c)
{
    if (length && *text == '#')
        return read_hex(text + 1, length - 1, c);
    const char *open = memchr(text, '(', length), *end = text + length - 1;
    if (!open)
        return read_name(text, length, c);
    if (depth > MAX_NESTING || *end != ')')
        return false;
    size_t n = (size_t)(open - text);
    if (n == 9 && !strncmp(text, "color-mix", 9))
        return read_mix(open + 1, end, depth, c);
    if (n == 10 && !strncmp(text, "light-dark", 10)) {
        double ignored;
        return read_part(open + 1, end_of_argument(open + 1, end), depth, c, &ignored);
    }
    return read_function(text, n, open + 1, end, c);
}

/* ---- replacing ---------------------------------------------------------------------------------------------- */

static const char *const functions[] = {"oklch(", "oklab(", "lch(", "lab(", "hwb(", "color(", "color-mix(", "light-dark(", NULL};

/* Gives the first such function in the text, at the start of a word; NULL: none. */
static const char *find_function(const char *text)
{
    const char *first = NULL;
    for (const char *const *f = functions; *f; f++)
        for (const char *at = text; (at = strstr(at, *f)); at++) {
            bool inside_word = at > text && (g_ascii_isalnum(at[-1]) || at[-1] == '-');
            if (!inside_word && (!first || at < first))
                first = at;
        }
    return first;
}

bool plb_colour_is_new(const char *text) { return find_function(text) != NULL; }

static int byte_of(double v) { return (int)lround(fmin(fmax(v, 0), 1) * 255); }

char *plb_colour_replace(const char *text)
{
    GString *out = g_string_new(NULL);
    for (const char *at; (at = find_function(text));) {
        const char *end = strchr(at, '(');
        for (int depth = 0; *end; end++) {
            depth += (*end == '(') - (*end == ')');
            if (depth == 0)
                break;
        }
        end += *end == ')';
        colour c;
        g_string_append_len(out, text, at - text);
        if (read_colour(at, (size_t)(end - at), 0, &c)) {
            char alpha[G_ASCII_DTOSTR_BUF_SIZE];
            g_string_append_printf(out, "rgba(%d,%d,%d,%s)", byte_of(c.v[0]), byte_of(c.v[1]), byte_of(c.v[2]),
                                   g_ascii_formatd(alpha, sizeof alpha, "%.4f", fmin(fmax(c.alpha, 0), 1)));
        } else {
            g_string_append_len(out, at, end - at);
        }
        text = end;
    }
    g_string_append(out, text);
    return g_string_free(out, FALSE);
}
