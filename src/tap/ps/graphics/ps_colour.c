/* SPDX-License-Identifier: MIT
 *
 * Turns every PostScript colour into red, green and blue. Device spaces go by the formulas of PLRM, section 7.2;
 * calibrated and ICC spaces count as the device space with as many components; Indexed, Separation and DeviceN are
 * followed to the space they stand on; a pattern has the colour it is given, else a middle grey.
 */
#include "tap/ps/ps.h"

#include <math.h>
#include <string.h>

static double unit(double v)
{
    return v < 0 ? 0 : v > 1 ? 1 : v;
}

static void set_rgb(ps *p, double r, double g, double b)
{
    ps_gs(p)->paint = (paint){PAINT_SOLID, unit(r), unit(g), unit(b), 1};
    ps_gs(p)->pattern = ps_null();
}

static void set_gray(ps *p, const double *v) { set_rgb(p, v[0], v[0], v[0]); }
static void set_red_green_blue(ps *p, const double *v) { set_rgb(p, v[0], v[1], v[2]); }

static void set_cmyk(ps *p, const double *v)
{
    double k = unit(v[3]);
    set_rgb(p, 1 - unit(v[0]) - k, 1 - unit(v[1]) - k, 1 - unit(v[2]) - k);
}

static void set_lab(ps *p, const double *v) { set_rgb(p, v[0] / 100, v[0] / 100, v[0] / 100); }

/* The colours of these families follow from their components alone; `components` 0: the space says their number. */
static const struct {
    const char *name;
    unsigned components;
    void (*set)(ps *p, const double *v);
} families[] = {
    {"DeviceGray", 1, set_gray},   {"DeviceRGB", 3, set_red_green_blue}, {"DeviceCMYK", 4, set_cmyk},
    {"CalGray", 1, set_gray},      {"CalRGB", 3, set_red_green_blue},    {"Lab", 3, set_lab},
    {"CIEBasedA", 1, set_gray},    {"CIEBasedABC", 3, set_red_green_blue}, {"CIEBasedDEF", 3, set_red_green_blue},
    {"CIEBasedDEFG", 4, set_cmyk},
};

static ps_object family_of(ps_object space)
{
    return space.type == PS_ARRAY && space.n ? space.as.array[0] : space;
}

static ps_object element(ps_object space, uint32_t i)
{
    return space.type == PS_ARRAY && i < space.n ? space.as.array[i] : ps_null();
}

/* Gives /N of an ICC profile's dictionary. */
static unsigned icc_components(ps *p, ps_object space)
{
    ps_object dict = element(space, 1), *n = dict.type == PS_DICT ? plb_ps_get_text(p, dict.as.dict, "N") : NULL;
    return n && n->type == PS_INTEGER && (n->as.integer == 1 || n->as.integer == 4) ? (unsigned)n->as.integer : 3;
}

/* Gives the family's place in the table for spaces that need no further look; -1: the family needs one. */
static int simple_family(ps *p, ps_object space)
{
    ps_object family = family_of(space);
    for (size_t i = 0; i < sizeof families / sizeof *families; i++)
        if (plb_ps_text_is(family, families[i].name))
            return (int)i;
    if (plb_ps_text_is(family, "ICCBased"))
        return icc_components(p, space) == 1 ? 0 : icc_components(p, space) == 4 ? 2 : 1;
    return -1;
}

unsigned plb_ps_components(ps *p, ps_object space)
{
    int i = simple_family(p, space);
    if (i >= 0)
        return families[i].components;
    if (plb_ps_text_is(family_of(space), "DeviceN") && element(space, 1).type == PS_ARRAY)
        return element(space, 1).n;
    return plb_ps_text_is(family_of(space), "Pattern") ? 0 : 1; /* Indexed, Separation */
}

static bool colour_from_operands(ps *p, ps_object space);

static bool then_set_colour(ps *p, ps_frame *f)
{
    return colour_from_operands(p, f->subject);
}

/* Runs a tint procedure or lookup procedure, then takes its results as a colour of `alternative`. */
static bool through_procedure(ps *p, ps_object alternative, ps_object proc)
{
    ps_frame *f = plb_ps_push_then(p, then_set_colour);
    if (!f)
        return false;
    f->subject = alternative;
    return plb_ps_execute(p, proc);
}

/* Looks up an Indexed colour in a string: puts the base space's components in the place of the index. */
static bool look_up(ps *p, ps_object table, unsigned components)
{
    int64_t at = (int64_t)floor(ps_value(*ps_args(p, 1))) * components;
    ps_drop(p, 1);
    for (unsigned i = 0; i < components; i++, at++) {
        unsigned char byte = at >= 0 && at < table.n ? (unsigned char)table.as.string[at] : 0;
        if (!plb_ps_push(p, ps_real(byte / 255.0)))
            return false;
    }
    return true;
}

static bool simple_colour(ps *p, int family)
{
    unsigned n = families[family].components;
    double v[4];
    if (!plb_ps_check(p, &"nnnn"[4 - n]))
        return false;
    for (unsigned i = 0; i < n; i++)
        v[i] = ps_value(ps_args(p, n)[i]);
    ps_drop(p, n);
    families[family].set(p, v);
    return true;
}

/* Takes the components of a colour of `space` from the operand stack and sets it. */
static bool colour_from_operands(ps *p, ps_object space)
{
    for (int depth = 0; depth < 8; depth++) {
        int family = simple_family(p, space);
        ps_object name = family_of(space);
        if (family >= 0)
            return simple_colour(p, family);
        if (plb_ps_text_is(name, "Separation") || plb_ps_text_is(name, "DeviceN"))
            return through_procedure(p, element(space, 2), element(space, 3));
        if (!plb_ps_text_is(name, "Indexed") || !plb_ps_check(p, "n"))
            break;
        if (element(space, 3).type != PS_STRING)
            return through_procedure(p, element(space, 1), element(space, 3));
        if (!look_up(p, element(space, 3), plb_ps_components(p, element(space, 1))))
            return false;
        space = element(space, 1);
    }
    return plb_ps_raise(p, PS_RANGECHECK);
}

/* Keeps the operands for `currentcolor`. */
static void remember_operands(ps *p, unsigned n)
{
    ps_state *g = ps_gs(p);
    g->components = n < 4 ? n : 4;
    for (unsigned i = 0; i < g->components; i++)
        g->colour[i] = ps_args(p, n)[i];
}

/* Takes the pattern on top and, when the pattern has no colours of its own, the colour of `space` below it. */
static bool set_pattern(ps *p, ps_object space)
{
    ps_object pattern = *ps_args(p, 1), *type = NULL;
    int family = simple_family(p, space);
    if (pattern.type == PS_DICT)
        type = plb_ps_get_text(p, pattern.as.dict, "PaintType");
    bool uncoloured = type && type->type == PS_INTEGER && type->as.integer == 2 && space.type != PS_NULL;
    unsigned n = uncoloured ? plb_ps_components(p, space) : 0;
    if (p->operand_count < n + 1)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    ps_drop(p, 1);
    set_rgb(p, 0.5, 0.5, 0.5);
    if (n && family < 0)
        ps_drop(p, n);
    else if (n && !simple_colour(p, family))
        return false;
    ps_gs(p)->paint.kind = PAINT_PATTERN;
    ps_gs(p)->pattern = pattern;
    ps_gs(p)->components = 0;
    return true;
}

static bool op_setcolor(ps *p)
{
    ps_object space = ps_gs(p)->colour_space;
    unsigned n = plb_ps_components(p, space);
    if (ps_args(p, 1)->type == PS_DICT)
        return set_pattern(p, element(space, 1));
    if (p->operand_count < n)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    remember_operands(p, n);
    return colour_from_operands(p, space);
}

static bool op_setpattern(ps *p)
{
    ps_object space = ps_gs(p)->colour_space;
    return set_pattern(p, plb_ps_text_is(family_of(space), "Pattern") ? element(space, 1) : space);
}

/* Sets the first colour of a space: black, or the full tint. */
static bool op_setcolorspace(ps *p)
{
    ps_state *g = ps_gs(p);
    ps_object space = *ps_args(p, 1), family = family_of(space);
    if (family.type != PS_NAME)
        return plb_ps_raise(p, PS_TYPECHECK);
    ps_drop(p, 1);
    g->colour_space = space;
    set_rgb(p, 0, 0, 0);
    unsigned n = plb_ps_components(p, space);
    g->components = n < 4 ? n : 4;
    bool tint = plb_ps_text_is(family, "Separation") || plb_ps_text_is(family, "DeviceN");
    for (unsigned i = 0; i < g->components; i++)
        g->colour[i] = ps_real(tint || i == 3);
    return true;
}

/* ---- the short ways --------------------------------------------------------------------------------------- */

static bool set_device(ps *p, const char *name, int family)
{
    unsigned n = families[family].components;
    remember_operands(p, n);
    ps_gs(p)->colour_space = plb_ps_name(p, name);
    return simple_colour(p, family);
}

static bool op_setgray(ps *p) { return set_device(p, "DeviceGray", 0); }
static bool op_setrgbcolor(ps *p) { return set_device(p, "DeviceRGB", 1); }
static bool op_setcmykcolor(ps *p) { return set_device(p, "DeviceCMYK", 2); }

/* Turns a hue, in sixths of the circle, into a colour (Smith, SIGGRAPH 1978). */
static void hsb_to_rgb(double h, double s, double b, double rgb[3])
{
    double sixth = unit(h) * 6;
    for (int i = 0; i < 3; i++) {
        double k = fmod((i == 0 ? 5 : i == 1 ? 3 : 1) + sixth, 6);
        rgb[i] = b - b * s * fmax(0, fmin(fmin(k, 4 - k), 1));
    }
}

static bool op_sethsbcolor(ps *p)
{
    ps_object *v = ps_args(p, 3);
    double rgb[3];
    hsb_to_rgb(ps_value(v[0]), unit(ps_value(v[1])), unit(ps_value(v[2])), rgb);
    for (int i = 0; i < 3; i++)
        v[i] = ps_real(rgb[i]);
    return op_setrgbcolor(p);
}

static double gray_now(ps *p)
{
    paint c = ps_gs(p)->paint;
    return 0.3 * c.red + 0.59 * c.green + 0.11 * c.blue; /* PLRM, section 7.2.1 */
}

static bool op_currentgray(ps *p) { return plb_ps_push(p, ps_real(gray_now(p))); }

static bool push3(ps *p, double a, double b, double c)
{
    return plb_ps_push(p, ps_real(a)) && plb_ps_push(p, ps_real(b)) && plb_ps_push(p, ps_real(c));
}

static bool op_currentrgbcolor(ps *p)
{
    paint c = ps_gs(p)->paint;
    return push3(p, c.red, c.green, c.blue);
}

static bool op_currentcmykcolor(ps *p)
{
    ps_state *g = ps_gs(p);
    if (plb_ps_text_is(family_of(g->colour_space), "DeviceCMYK") && g->components == 4)
        return push3(p, ps_value(g->colour[0]), ps_value(g->colour[1]), ps_value(g->colour[2])) && plb_ps_push(p, g->colour[3]);
    double c = 1 - g->paint.red, m = 1 - g->paint.green, y = 1 - g->paint.blue, k = fmin(c, fmin(m, y));
    return push3(p, c - k, m - k, y - k) && plb_ps_push(p, ps_real(k));
}

static bool op_currenthsbcolor(ps *p)
{
    paint c = ps_gs(p)->paint;
    double high = fmax(c.red, fmax(c.green, c.blue)), low = fmin(c.red, fmin(c.green, c.blue)), d = high - low, h = 0;
    if (d > 0)
        h = high == c.red ? (c.green - c.blue) / d : high == c.green ? 2 + (c.blue - c.red) / d : 4 + (c.red - c.green) / d;
    h /= 6;
    return push3(p, h < 0 ? h + 1 : h, high > 0 ? d / high : 0, high);
}

static bool op_currentcolor(ps *p)
{
    for (unsigned i = 0; i < ps_gs(p)->components; i++)
        if (!plb_ps_push(p, ps_gs(p)->colour[i]))
            return false;
    return true;
}

static bool op_currentcolorspace(ps *p)
{
    ps_object space = ps_gs(p)->colour_space, array;
    if (space.type == PS_ARRAY)
        return plb_ps_push(p, space);
    if (!plb_ps_new_array(p, 1, &array))
        return false;
    array.as.array[0] = space;
    return plb_ps_push(p, array);
}

const ps_operator plb_ps_colour_operators[] = {
    {"setgray", "n", op_setgray},
    {"setrgbcolor", "nnn", op_setrgbcolor},
    {"sethsbcolor", "nnn", op_sethsbcolor},
    {"setcmykcolor", "nnnn", op_setcmykcolor},
    {"setcolor", "x", op_setcolor},
    {"setcolorspace", "x", op_setcolorspace},
    {"setpattern", "x", op_setpattern},
    {"currentgray", "", op_currentgray},
    {"currentrgbcolor", "", op_currentrgbcolor},
    {"currenthsbcolor", "", op_currenthsbcolor},
    {"currentcmykcolor", "", op_currentcmykcolor},
    {"currentcolor", "", op_currentcolor},
    {"currentcolorspace", "", op_currentcolorspace},
    {NULL, NULL, NULL},
};
