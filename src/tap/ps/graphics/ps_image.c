/* SPDX-License-Identifier: MIT
 *
 * Reads past PostScript images, so that what follows is understood, and counts them (PLRM, section 4.10). Ghostscript's
 * images would be left out as well, so they are no reason to ask Ghostscript. Glyphs of bitmaps need the same.
 */
#include "tap/ps/ps.h"

#include <math.h>
#include <string.h>

#define MAX_SIDE 1000000.0

/* Reads past `bytes` of data that a procedure hands out in strings. frame: subject an array of the procedures,
 * index the next of them, now the bytes still to come; extra: are we back from a call? */
static bool step_image(ps *p, ps_frame *f)
{
    if (f->extra.n) {
        f->extra.n = 0;
        if (!plb_ps_check(p, "s"))
            return false;
        uint32_t got = ps_args(p, 1)->n;
        ps_drop(p, 1);
        f->now = got ? f->now - got : 0;
    }
    if (f->now <= 0) {
        plb_ps_pop_frame(p);
        return true;
    }
    f->extra.n = 1;
    return plb_ps_execute(p, f->subject.as.array[f->index++ % f->subject.n]);
}

static void skip_file(ps_file *f, double bytes)
{
    size_t left = (size_t)(f->end - f->at), n = bytes >= (double)left ? left : (size_t)bytes;
    for (size_t i = 0; f->line && i < n; i++)
        f->line += f->at[i] == '\n';
    f->at += n;
}

/* Reads past the data of an image: `sources` is an array of `bytes` in all, spread evenly. */
static bool consume(ps *p, ps_object sources, double bytes)
{
    for (uint32_t i = 0; i < sources.n; i++) {
        ps_object source = sources.as.array[i];
        if (source.type == PS_FILE)
            skip_file(source.as.file, bytes / sources.n);
        else if (source.type != PS_STRING && !ps_is_proc(source))
            return plb_ps_raise(p, PS_TYPECHECK);
    }
    if (!sources.n || !ps_is_proc(sources.as.array[0]))
        return true;
    ps_frame *f = plb_ps_push_frame(p, step_image);
    if (!f)
        return false;
    f->subject = sources;
    f->now = bytes;
    return true;
}

static void count_image(ps *p)
{
    if (p->showing)
        plb_ps_note_glyph_image(p);
    else if (!ps_gs(p)->no_output)
        plb_ps_omit(p, OMISSION_IMAGE);
}

/* Gives the number of bytes of an image whose rows are padded; negative: rangecheck raised. */
static double bytes_of(ps *p, double width, double height, double bits_per_pixel)
{
    if (!(width >= 0 && width <= MAX_SIDE && height >= 0 && height <= MAX_SIDE && bits_per_pixel >= 1 && bits_per_pixel <= 1024)) {
        plb_ps_raise(p, PS_RANGECHECK);
        return -1;
    }
    return ceil(width * bits_per_pixel / 8) * height;
}

static bool read_past(ps *p, unsigned drop, const ps_object *sources, uint32_t n, double bytes)
{
    ps_object array;
    if (bytes < 0 || !plb_ps_new_array(p, n, &array))
        return false;
    if (n)
        memcpy(array.as.array, sources, n * sizeof array);
    if (!consume(p, array, bytes))
        return false;
    count_image(p);
    ps_drop(p, drop);
    return true;
}

/* ---- images described by a dictionary --------------------------------------------------------------------- */

static double number_in(ps *p, const ps_dict *d, const char *key, double otherwise)
{
    ps_object *v = plb_ps_get_text(p, d, key);
    return v && ps_is_number(*v) ? ps_value(*v) : otherwise;
}

static double components_of(ps *p, const ps_dict *d, bool is_mask)
{
    ps_object *decode = plb_ps_get_text(p, d, "Decode");
    if (is_mask)
        return 1;
    if (decode && decode->type == PS_ARRAY && decode->n >= 2)
        return decode->n / 2;
    unsigned n = plb_ps_components(p, ps_gs(p)->colour_space);
    return n ? n : 1;
}

static bool dict_image(ps *p, bool is_mask)
{
    const ps_dict *d = ps_args(p, 1)->as.dict;
    ps_object *inner = plb_ps_get_text(p, d, "DataDict"); /* ImageType 3: an image with its mask */
    if (inner && inner->type == PS_DICT)
        d = inner->as.dict;
    ps_object *source = plb_ps_get_text(p, d, "DataSource");
    if (!source)
        return plb_ps_undefined(p, plb_ps_name(p, "DataSource"));
    double bits = is_mask ? 1 : number_in(p, d, "BitsPerComponent", 8);
    double bytes = bytes_of(p, number_in(p, d, "Width", -1), number_in(p, d, "Height", -1), bits * components_of(p, d, is_mask));
    bool several = source->type == PS_ARRAY && !source->executable;
    return read_past(p, 1, several ? source->as.array : source, several ? source->n : 1, bytes);
}

static bool op_image(ps *p)
{
    if (ps_args(p, 1)->type == PS_DICT)
        return dict_image(p, false);
    if (!plb_ps_check(p, "nnnax"))
        return false;
    ps_object *v = ps_args(p, 5);
    return read_past(p, 5, v + 4, 1, bytes_of(p, ps_value(v[0]), ps_value(v[1]), ps_value(v[2])));
}

static bool op_imagemask(ps *p)
{
    if (ps_args(p, 1)->type == PS_DICT)
        return dict_image(p, true);
    if (!plb_ps_check(p, "nnbax"))
        return false;
    ps_object *v = ps_args(p, 5);
    return read_past(p, 5, v + 4, 1, bytes_of(p, ps_value(v[0]), ps_value(v[1]), 1));
}

/* width height bits matrix source … multi components */
static bool op_colorimage(ps *p)
{
    ps_object *v = ps_args(p, 2);
    int32_t components = v[1].as.integer;
    if (components != 1 && components != 3 && components != 4)
        return plb_ps_raise(p, PS_RANGECHECK);
    unsigned sources = v[0].as.boolean ? (unsigned)components : 1, all = sources + 6;
    if (p->operand_count < all)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    v = ps_args(p, all);
    if (!ps_is_number(v[0]) || !ps_is_number(v[1]) || !ps_is_number(v[2]))
        return plb_ps_raise(p, PS_TYPECHECK);
    double bits = ps_value(v[2]) * (sources > 1 ? 1 : components);
    double bytes = bytes_of(p, ps_value(v[0]), ps_value(v[1]), bits);
    return read_past(p, all, v + 4, sources, bytes < 0 ? bytes : bytes * sources);
}

const ps_operator plb_ps_image_operators[] = {
    {"image", "x", op_image},
    {"imagemask", "x", op_imagemask},
    {"colorimage", "bi", op_colorimage},
    {NULL, NULL, NULL},
};
