/* SPDX-License-Identifier: MIT
 *
 * Keeps PostScript fonts as dictionaries: findfont, definefont, scalefont and their kin (PLRM, sections 5.1 to 5.3).
 * The letters of a font are not drawn, except those of Type 3, which are procedures (ps_text.c); fonts that the file
 * does not bring are stand-ins with the dictionary a program expects.
 */
#include "tap/ps/ps.h"

#include <string.h>

/* The table names the ASCII characters 32 to 126 in StandardEncoding (PLRM, appendix E.5). */
static const char *const ascii_names[] = {
    "space", "exclam", "quotedbl", "numbersign", "dollar", "percent", "ampersand", "quoteright", "parenleft", "parenright",
    "asterisk", "plus", "comma", "hyphen", "period", "slash", "zero", "one", "two", "three", "four", "five", "six", "seven",
    "eight", "nine", "colon", "semicolon", "less", "equal", "greater", "question", "at", "A", "B", "C", "D", "E", "F", "G",
    "H", "I", "J", "K", "L", "M", "N", "O", "P", "Q", "R", "S", "T", "U", "V", "W", "X", "Y", "Z", "bracketleft",
    "backslash", "bracketright", "asciicircum", "underscore", "quoteleft", "a", "b", "c", "d", "e", "f", "g", "h", "i",
    "j", "k", "l", "m", "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z", "braceleft", "bar",
    "braceright", "asciitilde",
};

static bool make_encoding(ps *p, ps_object *out)
{
    if (!plb_ps_new_array(p, 256, out))
        return false;
    ps_object none = plb_ps_name(p, ".notdef");
    for (unsigned i = 0; i < 256; i++) {
        out->as.array[i] = i >= 32 && i <= 126 ? plb_ps_name(p, ascii_names[i - 32]) : none;
        if (!out->as.array[i].as.name)
            return false;
    }
    return true;
}

bool plb_ps_make_fonts(ps *p)
{
    p->fonts = plb_ps_new_dict(p, 64);
    p->built_in_fonts = plb_ps_new_dict(p, 64);
    return p->fonts && p->built_in_fonts && make_encoding(p, &p->standard_encoding) && make_encoding(p, &p->latin1_encoding) &&
           plb_ps_put_text(p, p->systemdict, "FontDirectory", ps_of_dict(p->fonts)) &&
           plb_ps_put_text(p, p->systemdict, "GlobalFontDirectory", ps_of_dict(p->fonts)) &&
           plb_ps_put_text(p, p->systemdict, "SharedFontDirectory", ps_of_dict(p->fonts)) &&
           plb_ps_put_text(p, p->systemdict, "StandardEncoding", p->standard_encoding) &&
           plb_ps_put_text(p, p->systemdict, "ISOLatin1Encoding", p->latin1_encoding);
}

static bool new_matrix(ps *p, matrix m, ps_object *out)
{
    if (!plb_ps_new_array(p, 6, out))
        return false;
    plb_ps_put_matrix(*out, m);
    return true;
}

static bool put_new_dict(ps *p, ps_dict *d, const char *key)
{
    ps_dict *empty = plb_ps_new_dict(p, 4);
    return empty && plb_ps_put_text(p, d, key, ps_of_dict(empty));
}

static bool put_box(ps *p, ps_dict *d)
{
    static const int bounds[4] = {-168, -218, 1000, 898};
    ps_object array;
    if (!plb_ps_new_array(p, 4, &array))
        return false;
    for (int i = 0; i < 4; i++)
        array.as.array[i] = ps_integer(bounds[i]);
    array.executable = true;
    return plb_ps_put_text(p, d, "FontBBox", array);
}

/* Makes the stand-in for a font that the file does not bring. */
static bool make_built_in(ps *p, ps_object key, ps_object *font)
{
    ps_dict *d = plb_ps_new_dict(p, 12);
    ps_object m;
    if (!d || !new_matrix(p, plb_matrix_scale(0.001, 0.001), &m))
        return false;
    *font = ps_of_dict(d);
    key.executable = false;
    return plb_ps_put_text(p, d, "FontType", ps_integer(1)) && plb_ps_put_text(p, d, "PaintType", ps_integer(0)) &&
           plb_ps_put_text(p, d, "FontName", key) && plb_ps_put_text(p, d, "FontMatrix", m) && put_box(p, d) &&
           plb_ps_put_text(p, d, "Encoding", p->standard_encoding) &&
           plb_ps_put_text(p, d, "FID", (ps_object){.type = PS_FONT_ID}) && put_new_dict(p, d, "CharStrings") &&
           put_new_dict(p, d, "Private") && put_new_dict(p, d, "FontInfo") && plb_ps_put(p, p->built_in_fonts, key, *font);
}

bool plb_ps_find_font(ps *p, ps_object key, ps_object *font)
{
    ps_object *found = plb_ps_get(p, p->fonts, key);
    if (!found)
        found = plb_ps_get(p, p->built_in_fonts, key);
    if (found) {
        *font = *found;
        return true;
    }
    return (key.type == PS_NAME || key.type == PS_STRING) ? make_built_in(p, key, font) : plb_ps_raise(p, PS_INVALIDFONT);
}

/* Programs look into these, which an embedded font has in its encrypted part. */
bool plb_ps_define_font(ps *p, ps_object key, ps_object font)
{
    if (font.type != PS_DICT)
        return plb_ps_raise(p, PS_TYPECHECK);
    ps_dict *d = font.as.dict;
    if (!plb_ps_get_text(p, d, "CharStrings") && !put_new_dict(p, d, "CharStrings"))
        return false;
    if (!plb_ps_get_text(p, d, "Private") && !put_new_dict(p, d, "Private"))
        return false;
    return plb_ps_put_text(p, d, "FID", (ps_object){.type = PS_FONT_ID}) && plb_ps_put(p, p->fonts, key, font);
}

static bool op_findfont(ps *p)
{
    ps_object font = {0};
    return plb_ps_find_font(p, *ps_args(p, 1), &font) && plb_ps_give(p, 1, font);
}

static bool op_definefont(ps *p)
{
    ps_object *v = ps_args(p, 2), font = v[1];
    return plb_ps_define_font(p, v[0], font) && plb_ps_give(p, 2, font);
}

static bool op_undefinefont(ps *p)
{
    plb_ps_remove(p, p->fonts, *ps_args(p, 1));
    ps_drop(p, 1);
    return true;
}

/* Copies a font; `m` follows the matrix of the copy. */
static bool changed_font(ps *p, ps_object font, matrix m, ps_object *out)
{
    const ps_dict *from = font.as.dict;
    ps_object *old = plb_ps_get_text(p, from, "FontMatrix"), array;
    matrix now;
    ps_dict *d = plb_ps_new_dict(p, from->live);
    if (!d)
        return false;
    if (!old)
        return plb_ps_raise(p, PS_INVALIDFONT);
    if (!plb_ps_get_matrix(p, *old, &now) || !new_matrix(p, plb_matrix_multiply(now, m), &array))
        return false;
    for (uint32_t i = 0; i < from->used; i++)
        if (from->entries[i].key.type != PS_NULL && !plb_ps_put(p, d, from->entries[i].key, from->entries[i].value))
            return false;
    *out = ps_of_dict(d);
    return plb_ps_charge(p, from->used) && plb_ps_put_text(p, d, "FontMatrix", array);
}

static bool op_scalefont(ps *p)
{
    ps_object *v = ps_args(p, 2), font;
    double size = ps_value(v[1]);
    return changed_font(p, v[0], plb_matrix_scale(size, size), &font) && plb_ps_give(p, 2, font);
}

static bool op_makefont(ps *p)
{
    ps_object *v = ps_args(p, 2), font;
    matrix m;
    return plb_ps_get_matrix(p, v[1], &m) && changed_font(p, v[0], m, &font) && plb_ps_give(p, 2, font);
}

static bool op_setfont(ps *p)
{
    ps_gs(p)->font = *ps_args(p, 1);
    ps_drop(p, 1);
    return true;
}

static bool op_selectfont(ps *p)
{
    ps_object *v = ps_args(p, 2), size = v[1], font, scaled;
    matrix m = plb_matrix_scale(ps_value(size), ps_value(size));
    if (!ps_is_number(size) && !plb_ps_get_matrix(p, size, &m))
        return false;
    if (!plb_ps_find_font(p, v[0], &font) || !changed_font(p, font, m, &scaled))
        return false;
    ps_gs(p)->font = scaled;
    ps_drop(p, 2);
    return true;
}

static bool op_currentfont(ps *p)
{
    ps_object font = ps_gs(p)->font;
    if (font.type != PS_DICT && !make_built_in(p, plb_ps_name(p, "Courier"), &font))
        return false;
    return plb_ps_push(p, font);
}

static bool op_findencoding(ps *p)
{
    bool latin1 = plb_ps_text_is(*ps_args(p, 1), "ISOLatin1Encoding");
    return plb_ps_give(p, 1, latin1 ? p->latin1_encoding : p->standard_encoding);
}

static bool op_composefont(ps *p)
{
    ps_object *v = ps_args(p, 3), font;
    return make_built_in(p, v[0], &font) && plb_ps_give(p, 3, font);
}

static bool op_drop_one(ps *p) { ps_drop(p, 1); return true; }

static bool op_setcacheparams(ps *p)
{
    uint32_t n;
    if (!plb_ps_count_to_mark(p, &n))
        return false;
    ps_drop(p, n + 1);
    return true;
}

static bool op_currentcacheparams(ps *p)
{
    return plb_ps_push(p, ps_mark()) && plb_ps_push(p, ps_integer(0)) && plb_ps_push(p, ps_integer(100000));
}

static bool op_cachestatus(ps *p)
{
    for (int i = 0; i < 7; i++)
        if (!plb_ps_push(p, ps_integer(0)))
            return false;
    return true;
}

const ps_operator plb_ps_font_operators[] = {
    {"findfont", "x", op_findfont},
    {"definefont", "xd", op_definefont},
    {"undefinefont", "x", op_undefinefont},
    {"scalefont", "dn", op_scalefont},
    {"makefont", "da", op_makefont},
    {"setfont", "d", op_setfont},
    {"selectfont", "xx", op_selectfont},
    {"currentfont", "", op_currentfont},
    {"rootfont", "", op_currentfont},
    {"findencoding", "k", op_findencoding},
    {"composefont", "kxa", op_composefont},
    {"setcachelimit", "n", op_drop_one},
    {"setcacheparams", "", op_setcacheparams},
    {"currentcacheparams", "", op_currentcacheparams},
    {"cachestatus", "", op_cachestatus},
    {NULL, NULL, NULL},
};
