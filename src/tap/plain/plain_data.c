/* SPDX-License-Identifier: MIT
 *
 * Reads path data (SVG 1.1, section 8.3) and lists of points with librsvg's meaning. Data that are not well-formed are
 * refused as a whole.
 */
#include "tap/plain/plain_path.h"

#include <math.h>
#include <string.h>

typedef struct {
    plain_path *path;
    plain_text text;
    double x, y;           /* where it is */
    double start_x, start_y; /* of the subpath */
    double cubic_x, cubic_y, quadratic_x, quadratic_y; /* the last control point, for smooth curves */
    bool is_relative, is_square;
    unsigned moves;
    bool has_left; /* the subpath has left its start */
} data;

/* ---- what is drawn ------------------------------------------------------------------------------------------ */

static void arrive(data *d, double x, double y)
{
    d->x = d->cubic_x = d->quadratic_x = x;
    d->y = d->cubic_y = d->quadratic_y = y;
}

/* Tells whether librsvg is sure to draw the point in the same way: with square caps only in a single subpath that
 * leaves its start at once. */
static bool is_sure(data *d, double x, double y)
{
    if (d->is_square && !d->has_left && !(fabs(x - d->start_x) > PLAIN_NEAR || fabs(y - d->start_y) > PLAIN_NEAR))
        return false;
    d->has_left = true;
    return true;
}

static bool move(data *d, const double *v)
{
    arrive(d, v[0], v[1]);
    d->start_x = v[0];
    d->start_y = v[1];
    d->has_left = false;
    plb_plain_move(d->path, v[0], v[1]);
    return !d->is_square || d->moves++ == 0;
}

static bool line(data *d, const double *v)
{
    arrive(d, v[0], v[1]);
    plb_plain_line(d->path, v[0], v[1]);
    return is_sure(d, v[0], v[1]);
}

static bool across(data *d, const double *v) { return line(d, (double[2]){v[0], d->y}); }
static bool upright(data *d, const double *v) { return line(d, (double[2]){d->x, v[0]}); }

static bool curve(data *d, const double *v)
{
    plb_plain_curve(d->path, v);
    arrive(d, v[4], v[5]);
    d->cubic_x = v[2];
    d->cubic_y = v[3];
    return is_sure(d, v[4], v[5]);
}

static bool smooth_curve(data *d, const double *v)
{
    double at[6] = {d->x + d->x - d->cubic_x, d->y + d->y - d->cubic_y, v[0], v[1], v[2], v[3]};
    return curve(d, at);
}

static bool quadratic(data *d, const double *v)
{
    double at[6] = {(d->x + 2 * v[0]) / 3, (d->y + 2 * v[1]) / 3, (v[2] + 2 * v[0]) / 3, (v[3] + 2 * v[1]) / 3, v[2], v[3]};
    plb_plain_curve(d->path, at);
    arrive(d, v[2], v[3]);
    d->quadratic_x = v[0];
    d->quadratic_y = v[1];
    return is_sure(d, v[2], v[3]);
}

static bool smooth_quadratic(data *d, const double *v)
{
    double at[4] = {d->x + d->x - d->quadratic_x, d->y + d->y - d->quadratic_y, v[0], v[1]};
    return quadratic(d, at);
}

static bool arc(data *d, const double *v)
{
    plain_arc a = {{d->x, d->y}, {v[5], v[6]}, {fabs(v[0]), fabs(v[1])}, v[2], v[3] != 0, v[4] != 0};
    plb_plain_draw_arc(d->path, &a);
    arrive(d, v[5], v[6]);
    return is_sure(d, v[5], v[6]);
}

static bool close(data *d, const double *v)
{
    (void)v;
    plb_plain_close(d->path);
    arrive(d, d->start_x, d->start_y);
    return !d->is_square || d->has_left;
}

/* ---- commands ----------------------------------------------------------------------------------------------- */

/* `kinds` says what each number is: x and y are places, f a flag, n a plain number. */
typedef struct {
    char letter;
    const char *kinds;
    bool (*draw)(data *d, const double *v);
} command;

static const command commands[] = {
    {'m', "xy", move},          {'l', "xy", line},         {'h', "x", across},
    {'v', "y", upright},        {'c', "xyxyxy", curve},    {'s', "xyxy", smooth_curve},
    {'q', "xyxy", quadratic},   {'t', "xy", smooth_quadratic}, {'a', "nnnffxy", arc},
    {'z', "", close},
};

static const command *find_command(char letter)
{
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (commands[i].letter == (letter | 32))
            return &commands[i];
    return NULL;
}

static bool read_flag(plain_text *t, double *v)
{
    if (t->at == t->end || (*t->at != '0' && *t->at != '1'))
        return false;
    *v = *t->at++ - '0';
    return true;
}

static bool read_value(data *d, char kind, double *v)
{
    if (kind == 'f')
        return read_flag(&d->text, v);
    if (!plb_plain_number(&d->text, v))
        return false;
    if (d->is_relative)
        *v += kind == 'x' ? d->x : kind == 'y' ? d->y : 0;
    return true;
}

/* Reads one set of a command's numbers; commas may stand between any two. */
static bool read_values(data *d, const char *kinds, double v[7])
{
    for (size_t i = 0; kinds[i]; i++) {
        if (i)
            plb_plain_comma(&d->text);
        if (!read_value(d, kinds[i], &v[i]))
            return false;
    }
    return true;
}

/* Tells whether another set of numbers follows, which must be after a comma. */
static bool goes_on(plain_text *t)
{
    plb_plain_blank(t);
    if (t->at < t->end && *t->at == ',') {
        t->at++;
        plb_plain_blank(t);
        return true;
    }
    return t->at < t->end && (*t->at == '-' || *t->at == '+' || *t->at == '.' || (unsigned char)(*t->at - '0') < 10);
}

static bool run_command(data *d, const command *c)
{
    double v[7];
    do {
        if (!read_values(d, c->kinds, v) || !c->draw(d, v))
            return false;
        if (c->letter == 'm')
            c = find_command('l');
    } while (c->letter != 'z' && goes_on(&d->text));
    return true;
}

bool plb_plain_data(plain_path *p, plain_text text, bool square)
{
    data d = {.path = p, .text = text, .is_square = square};
    bool first = true;
    for (plb_plain_blank(&d.text); d.text.at < d.text.end; plb_plain_blank(&d.text)) {
        char letter = *d.text.at++;
        const command *c = find_command(letter);
        if (!c || (first && c->letter != 'm'))
            return false;
        d.is_relative = letter == c->letter;
        first = false;
        plb_plain_blank(&d.text);
        if (!run_command(&d, c) || p->failed)
            return false;
    }
    return true;
}

/* ---- points ------------------------------------------------------------------------------------------------- */

/* Reads a comma or blanks between points; librsvg takes no blanks before the comma, and no comma at the end. */
static bool read_point(plain_text *t, double v[2], bool *more)
{
    if (!plb_plain_css_number(t, &v[0]))
        return false;
    plb_plain_comma(t);
    if (!plb_plain_css_number(t, &v[1]))
        return false;
    bool is_apart = plb_plain_blank(t), has_comma = !is_apart && t->at < t->end && *t->at == ',';
    if (has_comma) {
        t->at++;
        plb_plain_blank(t);
    }
    *more = t->at < t->end;
    return *more ? is_apart || has_comma : !has_comma;
}

bool plb_plain_points(plain_path *p, plain_text points, bool closed, bool square)
{
    data d = {.path = p, .text = points, .is_square = square};
    bool more = true;
    double v[2];
    if (!points.at)
        return false;
    plb_plain_blank(&d.text);
    for (bool first = true; more; first = false)
        if (!read_point(&d.text, v, &more) || !(first ? move : line)(&d, v) || p->failed)
            return false;
    return !closed || close(&d, NULL);
}
