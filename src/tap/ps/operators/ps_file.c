/* SPDX-License-Identifier: MIT
 *
 * Holds the operators on files, which can read only what the input itself holds. Operators that would open, run, delete
 * or rename a file are refused (PLRM, section 3.8).
 */
#include "tap/ps/ps.h"

#include <string.h>

static bool op_currentfile(ps *p)
{
    return plb_ps_push(p, ps_of_file(plb_ps_current_file(p)));
}

/* Reads one byte, -1 at the end. */
static int next_byte(ps_file *f)
{
    if (f->at >= f->end)
        return -1;
    if (f->line)
        f->line += *f->at == '\n';
    return (unsigned char)*f->at++;
}

static bool op_read(ps *p)
{
    int c = next_byte(ps_args(p, 1)->as.file);
    if (c < 0)
        return plb_ps_give(p, 1, ps_boolean(false));
    return plb_ps_give(p, 1, ps_integer(c)) && plb_ps_push(p, ps_boolean(true));
}

/* Leaves the part of the string that was filled and whether all went well. */
static bool give_part(ps *p, ps_object s, uint32_t n, bool good)
{
    s.n = n;
    return plb_ps_charge(p, n / 16) && plb_ps_give(p, 2, s) && plb_ps_push(p, ps_boolean(good));
}

static bool op_readstring(ps *p)
{
    ps_object *v = ps_args(p, 2), s = v[1];
    ps_file *f = v[0].as.file;
    uint32_t n = 0;
    for (int c; n < s.n && (c = next_byte(f)) >= 0; n++)
        s.as.string[n] = (char)c;
    return give_part(p, s, n, n == s.n);
}

static int hex_value(int c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Reads the next hexadecimal digit, others passed over; -1 at the end. */
static int next_digit(ps_file *f)
{
    int c;
    while ((c = next_byte(f)) >= 0)
        if (hex_value(c) >= 0)
            return hex_value(c);
    return -1;
}

static bool op_readhexstring(ps *p)
{
    ps_object *v = ps_args(p, 2), s = v[1];
    ps_file *f = v[0].as.file;
    uint32_t n = 0;
    for (; n < s.n; n++) {
        int high = next_digit(f), low = high < 0 ? -1 : next_digit(f);
        if (low < 0)
            break;
        s.as.string[n] = (char)(high << 4 | low);
    }
    return give_part(p, s, n, n == s.n);
}

static bool op_readline(ps *p)
{
    ps_object *v = ps_args(p, 2), s = v[1];
    ps_file *f = v[0].as.file;
    uint32_t n = 0;
    int c;
    while ((c = next_byte(f)) >= 0 && c != '\n' && c != '\r') {
        if (n >= s.n)
            return plb_ps_raise(p, PS_RANGECHECK);
        s.as.string[n++] = (char)c;
    }
    if (c == '\r' && f->at < f->end && *f->at == '\n')
        next_byte(f);
    return give_part(p, s, n, c >= 0);
}

/* Leaves the rest of the string that was read from, the object, true; or only false. */
static bool op_token(ps *p)
{
    ps_object from = *ps_args(p, 1), o;
    bool ended, is_string = from.type == PS_STRING;
    if (!is_string && from.type != PS_FILE)
        return plb_ps_raise(p, PS_TYPECHECK);
    ps_file *f = is_string ? plb_ps_file_of_string(p, from) : from.as.file;
    if (!f || !plb_ps_read_object(p, f, &o, &ended))
        return false;
    if (ended)
        return plb_ps_give(p, 1, ps_boolean(false));
    if (is_string) {
        from.as.string += from.n - (size_t)(f->end - f->at);
        from.n = (uint32_t)(f->end - f->at);
        return plb_ps_give(p, 1, from) && plb_ps_push(p, o) && plb_ps_push(p, ps_boolean(true));
    }
    return plb_ps_give(p, 1, o) && plb_ps_push(p, ps_boolean(true));
}

static bool op_closefile(ps *p)
{
    ps_file *f = ps_args(p, 1)->as.file;
    f->at = f->end;
    ps_drop(p, 1);
    return true;
}

static bool op_bytesavailable(ps *p)
{
    const ps_file *f = ps_args(p, 1)->as.file;
    size_t left = (size_t)(f->end - f->at);
    return plb_ps_give(p, 1, ps_integer(left > INT32_MAX ? INT32_MAX : (int32_t)left));
}

/* Tells the status: true of an open file; a file of a name is not to be found. */
static bool op_status(ps *p)
{
    return plb_ps_give(p, 1, ps_boolean(ps_args(p, 1)->type == PS_FILE));
}

static bool op_drop_one(ps *p) { ps_drop(p, 1); return true; }
static bool op_drop_two(ps *p) { ps_drop(p, 2); return true; }

/* Finds a file by name: only the standard streams have names here. */
static bool op_file(ps *p)
{
    ps_object name = *ps_args(p, 2);
    bool is_output = plb_ps_text_is(name, "%stdout") || plb_ps_text_is(name, "%stderr");
    if (plb_ps_text_is(name, "%stdin"))
        return plb_ps_give(p, 2, ps_of_file(p->main_file));
    if (!is_output)
        return plb_ps_refuse(p);
    ps_file *f = plb_ps_new(p, 1, sizeof *f);
    if (!f)
        return false;
    *f = (ps_file){.at = "", .end = "", .is_string = true};
    f->end = f->at;
    return plb_ps_give(p, 2, ps_of_file(f));
}

/* Passes over the encrypted part of a Type 1 font, `currentfile eexec`, whose letters are not drawn. Its effects happen
 * here: the font dictionary on the stack is defined, and a mark left for `cleartomark`. */
static bool skip_encrypted(ps_file *f)
{
    static const char word[] = "cleartomark";
    const size_t n = sizeof word - 1;
    const char *at = f->at;
    while ((size_t)(f->end - at) >= n && (at = memchr(at, 'c', (size_t)(f->end - at) - n + 1)) != NULL) {
        if (!memcmp(at, word, n)) {
            for (; f->at < at; f->at++)
                if (f->line)
                    f->line += *f->at == '\n';
            return true;
        }
        at++;
    }
    return false;
}

static bool op_eexec(ps *p)
{
    ps_object from = *ps_args(p, 1);
    if (from.type != PS_FILE)
        return plb_ps_raise(p, PS_TYPECHECK);
    if (!skip_encrypted(from.as.file))
        return plb_ps_fail(p, ERROR_UNSUPPORTED, "an encrypted font whose end cannot be found");
    ps_drop(p, 1);
    ps_object *font = p->operand_count ? ps_args(p, 1) : NULL;
    ps_object *name = font && font->type == PS_DICT ? plb_ps_get_text(p, font->as.dict, "FontName") : NULL;
    if (name) {
        if (!plb_ps_define_font(p, *name, *font))
            return false;
        ps_drop(p, 1);
    }
    return plb_ps_push(p, ps_mark());
}

const ps_operator plb_ps_file_operators[] = {
    {"currentfile", "", op_currentfile},
    {"read", "f", op_read},
    {"readstring", "fs", op_readstring},
    {"readhexstring", "fs", op_readhexstring},
    {"readline", "fs", op_readline},
    {"token", "x", op_token},
    {"closefile", "f", op_closefile},
    {"flushfile", "f", op_closefile},
    {"resetfile", "f", op_drop_one},
    {"bytesavailable", "f", op_bytesavailable},
    {"status", "x", op_status},
    {"write", "fi", op_drop_two},
    {"writestring", "fs", op_drop_two},
    {"writehexstring", "fs", op_drop_two},
    {"eexec", "x", op_eexec},
    {"file", "ss", op_file},
    {"run", "s", plb_ps_refuse},
    {"deletefile", "s", plb_ps_refuse},
    {"renamefile", "ss", plb_ps_refuse},
    {"filenameforall", "sxs", plb_ps_refuse},
    {"fileposition", "f", plb_ps_refuse},
    {"setfileposition", "fi", plb_ps_refuse},
    {NULL, NULL, NULL},
};
