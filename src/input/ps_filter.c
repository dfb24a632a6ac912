/* SPDX-License-Identifier: MIT
 *
 * PostScript filters (PLRM, section 3.13). The text encodings and run lengths are decoded at once, whole; of the
 * others (LZW, Flate, DCT …), which carry images, only the end is looked for, so that reading can go on behind it.
 */
#include "input/ps.h"

#include <string.h>

typedef ARRAY(char) bytes;

static int take(ps_file *f)
{
    if (f->at >= f->end)
        return -1;
    if (f->line)
        f->line += *f->at == '\n';
    return (unsigned char)*f->at++;
}

/* What is decoded beyond a string's limit is dropped: only images are that long. */
static bool put(bytes *out, int c)
{
    return out->n >= PS_MAX_STRING || array_push(out, (char)c);
}

/* Each decoder reads from `f` up to its end mark; false: out of memory. */
static bool decode_hex(ps_file *f, bytes *out)
{
    int high = -1;
    for (int c; (c = take(f)) >= 0 && c != '>';) {
        int v = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
        if (v < 0)
            continue;
        if (high >= 0 && !put(out, high << 4 | v))
            return false;
        high = high >= 0 ? -1 : v;
    }
    return high < 0 || put(out, high << 4);
}

static bool put_group(bytes *out, uint64_t group, int n)
{
    for (int i = 0; i < n; i++)
        if (!put(out, (int)(group >> (24 - 8 * i) & 255)))
            return false;
    return true;
}

static bool decode_ascii85(ps_file *f, bytes *out)
{
    uint64_t group = 0;
    int count = 0;
    for (int c; (c = take(f)) >= 0 && c != '~';) {
        if (c == 'z' && !count && !put_group(out, 0, 4))
            return false;
        if (c < '!' || c > 'u')
            continue;
        group = group * 85 + (uint64_t)(c - '!');
        if (++count < 5)
            continue;
        if (!put_group(out, group, 4))
            return false;
        group = 0;
        count = 0;
    }
    if (f->at < f->end && *f->at == '>')
        f->at++;
    if (count < 2)
        return true;
    for (int i = count; i < 5; i++)
        group = group * 85 + 84;
    return put_group(out, group, count - 1);
}

static bool decode_run_length(ps_file *f, bytes *out)
{
    for (int n; (n = take(f)) >= 0 && n != 128;) {
        int copies = n < 128 ? 1 : 257 - n, literals = n < 128 ? n + 1 : 1;
        for (int i = 0; i < literals; i++) {
            int c = take(f);
            for (int k = 0; c >= 0 && k < copies; k++)
                if (!put(out, c))
                    return false;
        }
    }
    return true;
}

static const struct {
    const char *name;
    bool (*decode)(ps_file *f, bytes *out);
} decoders[] = {
    {"ASCIIHexDecode", decode_hex},
    {"ASCII85Decode", decode_ascii85},
    {"RunLengthDecode", decode_run_length},
};

static ps_file *new_file(ps *p, const char *at, size_t n)
{
    ps_file *f = plb_ps_new(p, 1, sizeof *f);
    if (f)
        *f = (ps_file){.at = at, .end = at + n};
    return f;
}

static ps_file *decoded_file(ps *p, ps_file *from, size_t which)
{
    bytes out = {0};
    const char *start = from->at;
    ps_object copy;
    ps_file *f = NULL;
    if (!decoders[which].decode(from, &out))
        plb_fail_memory(&p->err);
    else if (plb_ps_charge(p, (size_t)(from->at - start) / 8) && plb_ps_new_string(p, out.v, out.n, &copy))
        f = new_file(p, copy.as.string, copy.n);
    array_free(&out);
    return f;
}

/* ---- SubFileDecode: up to a string ------------------------------------------------------------------------ */

static const char *find(const char *at, const char *end, const char *mark, size_t n)
{
    while ((size_t)(end - at) >= n && (at = memchr(at, mark[0], (size_t)(end - at) - n + 1)) != NULL) {
        if (!memcmp(at, mark, n))
            return at;
        at++;
    }
    return NULL;
}

/* What lies before the mark after `count` others, as it is; `from` goes on behind it. */
static ps_file *sub_file(ps *p, ps_file *from, int32_t count, ps_object mark)
{
    const char *start = from->at, *end = from->end, *next = end;
    size_t left = (size_t)(from->end - start);
    if (!mark.n && count > 0) {
        next = end = start + ((size_t)count < left ? (size_t)count : left);
    } else if (mark.n) {
        const char *at = start;
        for (int32_t i = 0; (at = find(at, from->end, mark.as.string, mark.n)) != NULL; at += mark.n)
            if (i++ >= count) {
                next = at + mark.n;
                end = count ? next : at;
                break;
            }
    }
    ps_file *f = new_file(p, start, (size_t)(end - start));
    if (!f || !plb_ps_charge(p, (size_t)(next - start) / 16))
        return NULL;
    f->line = from->line;
    while (from->at < next)
        take(from);
    return f;
}

static bool op_sub_file(ps *p, ps_file *from)
{
    ps_object *v = ps_args(p, 3), count = v[0], mark = v[1];
    bool given = count.type == PS_INTEGER && mark.type == PS_STRING;
    unsigned drop = given ? 4 : 3;
    if (!given && v[1].type == PS_DICT) {
        ps_object *c = plb_ps_get_text(p, v[1].as.dict, "EODCount"), *m = plb_ps_get_text(p, v[1].as.dict, "EODString");
        given = c && m && c->type == PS_INTEGER && m->type == PS_STRING;
        if (given) {
            count = *c;
            mark = *m;
        }
    }
    if (!given)
        return plb_ps_raise(p, PS_TYPECHECK);
    ps_file *f = sub_file(p, from, count.as.integer, mark);
    return f && plb_ps_give(p, drop, ps_of_file(f));
}

/* ---- filters that are only passed over -------------------------------------------------------------------- */

static const char *const closed_filters[] = {
    "LZWDecode", "FlateDecode", "DCTDecode", "CCITTFaxDecode", "ReusableStreamDecode",
};

/* A JPEG ends at its marker; of the others only the DSC comment behind them tells. */
static bool skip_binary(ps *p, ps_file *f, const char *name)
{
    static const char *const ends[] = {"%%EndBinary", "%%EndData"};
    const char *at = NULL;
    if (!strcmp(name, "DCTDecode")) {
        at = find(f->at, f->end, "\xff\xd9", 2);
        at = at ? at + 2 : NULL;
    }
    for (int i = 0; i < 2 && !at; i++)
        at = find(f->at, f->end, ends[i], strlen(ends[i]));
    if (!at)
        return plb_ps_fail(p, ERROR_UNSUPPORTED, "the end of data encoded by the filter '%s' cannot be found", name);
    while (f->at < at)
        take(f);
    return true;
}

static bool closed_filter(ps *p, ps_file *from, const char *name, unsigned drop)
{
    bool is_raw = from->line != 0 && !from->opaque;
    if (is_raw && !skip_binary(p, from, name))
        return false;
    ps_file *f = new_file(p, from->at, 0);
    if (!f)
        return false;
    f->opaque = from->opaque ? from->opaque : name;
    if (!is_raw)
        from->at = from->end;
    return plb_ps_give(p, drop, ps_of_file(f));
}

/* The stream a filter stands on; a string is one too. */
static ps_file *source_of(ps *p, ps_object o)
{
    if (o.type == PS_FILE)
        return o.as.file;
    if (o.type == PS_STRING)
        return plb_ps_file_of_string(p, o);
    if (ps_is_proc(o))
        plb_ps_fail(p, ERROR_UNSUPPORTED, "a filter that reads from a procedure is not known to this program");
    else
        plb_ps_raise(p, PS_TYPECHECK);
    return NULL;
}

static bool named_filter(ps *p, ps_object name, ps_file *from, unsigned drop)
{
    for (size_t i = 0; i < sizeof decoders / sizeof *decoders; i++)
        if (plb_ps_text_is(name, decoders[i].name)) {
            if (from->opaque)
                return closed_filter(p, from, decoders[i].name, drop);
            ps_file *f = decoded_file(p, from, i);
            return f && plb_ps_give(p, drop, ps_of_file(f));
        }
    for (size_t i = 0; i < sizeof closed_filters / sizeof *closed_filters; i++)
        if (plb_ps_text_is(name, closed_filters[i]))
            return closed_filter(p, from, closed_filters[i], drop);
    return plb_ps_undefined(p, name);
}

/* source [dictionary] [count string] name */
static bool op_filter(ps *p)
{
    ps_object name = *ps_args(p, 1);
    bool is_sub_file = plb_ps_text_is(name, "SubFileDecode");
    if (p->operand_count < 2 || (is_sub_file && p->operand_count < 3))
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    unsigned drop = 2;
    if (is_sub_file)
        drop = ps_args(p, 2)->type == PS_DICT ? 3 : 4;
    else if (ps_args(p, 2)->type == PS_DICT)
        drop = 3;
    if (p->operand_count < drop)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    ps_file *from = source_of(p, *ps_args(p, drop));
    if (!from)
        return false;
    if (is_sub_file && from->opaque)
        return closed_filter(p, from, "SubFileDecode", drop);
    return is_sub_file ? op_sub_file(p, from) : named_filter(p, name, from, drop);
}

const ps_operator plb_ps_filter_operators[] = {
    {"filter", "k", op_filter},
    {NULL, NULL, NULL},
};
