/* SPDX-License-Identifier: MIT
 *
 * PostScript filters (PLRM, section 3.13). A filter is decoded when it is first read from, whole: the text
 * encodings, run lengths and LZW. Of the others (Flate, DCT …), which carry images, only the end is looked for, so
 * that reading can go on behind it.
 */
#include "tap/ps/ps.h"

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

/* LZW with codes of 9 to 12 bits, the high ones first (PLRM, section 3.13.3; Welch, IEEE Computer 17, 1984). A code
 * above 257 stands for the string of `before` and one byte more. */
#define LZW_CODES 4096

typedef struct {
    uint16_t before[LZW_CODES], length[LZW_CODES];
    uint8_t last[LZW_CODES], first[LZW_CODES];
    int next, width, have;
    uint32_t bits;
} lzw;

static int lzw_code(ps_file *f, lzw *z)
{
    while (z->have < z->width) {
        int c = take(f);
        if (c < 0)
            return 257;
        z->bits = z->bits << 8 | (uint32_t)c;
        z->have += 8;
    }
    z->have -= z->width;
    return (int)(z->bits >> z->have & ((1u << z->width) - 1));
}

static bool lzw_put(const lzw *z, bytes *out, int code)
{
    size_t n = code < 256 ? 1 : z->length[code];
    if (out->n >= PS_MAX_STRING)
        return true;
    if (!array_reserve(out, n))
        return false;
    out->n += n;
    for (size_t i = out->n; code >= 256; code = z->before[code])
        out->v[--i] = (char)z->last[code];
    out->v[out->n - n] = (char)code;
    return true;
}

/* Enters the string of `before` and the byte `c`; the width grows one code early, as in PDF and TIFF. */
static void lzw_enter(lzw *z, int before, int c)
{
    if (z->next >= LZW_CODES)
        return;
    z->before[z->next] = (uint16_t)before;
    z->last[z->next] = (uint8_t)c;
    z->first[z->next] = before < 256 ? (uint8_t)before : z->first[before];
    z->length[z->next] = (uint16_t)((before < 256 ? 1 : z->length[before]) + 1);
    z->next++;
    if (z->next + 1 >= 1 << z->width && z->width < 12)
        z->width++;
}

static bool decode_lzw(ps_file *f, bytes *out)
{
    static const lzw start = {.next = 258, .width = 9};
    lzw z = start;
    int before = -1;
    for (int code; (code = lzw_code(f, &z)) != 257;) {
        if (code == 256) {
            z.next = start.next;
            z.width = start.width;
            before = -1;
            continue;
        }
        if (before < 0 ? code > 255 : code > z.next || (code == z.next && z.next >= LZW_CODES))
            return true; /* broken data end here */
        if (before >= 0) {
            int next = code == z.next ? before : code;
            lzw_enter(&z, before, next < 256 ? next : z.first[next]);
        }
        if (!lzw_put(&z, out, code))
            return false;
        before = code;
    }
    return true;
}

static bool open_decoder(ps *p, ps_file *f, bool (*decode)(ps_file *, bytes *))
{
    bytes out = {0};
    ps_object copy;
    const char *start = f->source->at;
    bool good = decode(f->source, &out) || plb_fail_memory(&p->err);
    if (out.n > PS_MAX_STRING)
        out.n = PS_MAX_STRING;
    good = good && plb_ps_charge(p, (size_t)(f->source->at - start) / 8) && plb_ps_new_string(p, out.v, out.n, &copy);
    array_free(&out);
    if (!good)
        return false;
    f->at = copy.as.string;
    f->end = f->at + copy.n;
    return true;
}

static bool open_hex(ps *p, ps_file *f) { return open_decoder(p, f, decode_hex); }
static bool open_ascii85(ps *p, ps_file *f) { return open_decoder(p, f, decode_ascii85); }
static bool open_lzw(ps *p, ps_file *f) { return open_decoder(p, f, decode_lzw); }
static bool open_run_length(ps *p, ps_file *f) { return open_decoder(p, f, decode_run_length); }

static const char *find(const char *at, const char *end, const char *mark, size_t n)
{
    while ((size_t)(end - at) >= n && (at = memchr(at, mark[0], (size_t)(end - at) - n + 1)) != NULL) {
        if (!memcmp(at, mark, n))
            return at;
        at++;
    }
    return NULL;
}

/* SubFileDecode: what lies before the mark that comes after `count` others, as it is; the source goes on behind. */
static bool open_sub_file(ps *p, ps_file *f)
{
    ps_file *from = f->source;
    const char *start = from->at, *end = from->end, *next = end;
    size_t left = (size_t)(end - start), count = f->count > 0 ? (size_t)f->count : 0;
    if (!f->mark.n && count) {
        next = end = start + (count < left ? count : left);
    } else if (f->mark.n) {
        const char *at = start;
        for (size_t i = 0; (at = find(at, from->end, f->mark.as.string, f->mark.n)) != NULL; at += f->mark.n)
            if (i++ >= count) {
                next = at + f->mark.n;
                end = count ? next : at;
                break;
            }
    }
    f->at = start;
    f->end = end;
    f->line = from->line;
    while (from->at < next)
        take(from);
    return plb_ps_charge(p, (size_t)(next - start) / 16);
}

/* A JPEG ends at its marker; of other binary data only the DSC comment behind them tells. */
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

/* Nothing is decoded: a file of no bytes. */
static bool open_opaque(ps *p, ps_file *f)
{
    ps_file *from = f->source;
    bool is_raw = from->line != 0 && !from->opaque;
    f->opaque = from->opaque ? from->opaque : f->filter;
    if (is_raw)
        return skip_binary(p, from, f->filter);
    from->at = from->end;
    return true;
}

/* ---- procedures as sources -------------------------------------------------------------------------------- */

typedef struct {
    ps_file *file;
    bytes got;
} pulling;

static bool open_procedure(ps *p, ps_file *f)
{
    f->open = open_procedure;
    p->pull = f;
    return false;
}

static void drop_pull(ps *p, ps_frame *f)
{
    pulling *now = f->data;
    (void)p;
    array_free(&now->got);
}

/* All strings have come: they are the file. */
static bool end_pull(ps *p, pulling *now)
{
    ps_object copy;
    if (!plb_ps_new_string(p, now->got.v, now->got.n, &copy))
        return false;
    now->file->at = copy.as.string;
    now->file->end = copy.as.string + copy.n;
    now->file->open = NULL;
    plb_ps_pop_frame(p);
    return true;
}

/* Frame: index: are we back from a call? */
static bool step_pull(ps *p, ps_frame *f)
{
    pulling *now = f->data;
    if (f->index) {
        if (!plb_ps_check(p, "s"))
            return false;
        ps_object s = *ps_args(p, 1);
        ps_drop(p, 1);
        for (uint32_t i = 0; i < s.n; i++)
            if (!put(&now->got, s.as.string[i]))
                return plb_fail_memory(&p->err);
        if (!plb_ps_charge(p, s.n / 8))
            return false;
        if (!s.n || (now->file->until >= 0 && memchr(s.as.string, now->file->until, s.n)))
            return end_pull(p, now);
    }
    f->index = 1;
    return plb_ps_execute(p, now->file->proc);
}

static bool step_retry(ps *p, ps_frame *f)
{
    ps_object what = f->body;
    plb_ps_pop_frame(p);
    return plb_ps_execute(p, what);
}

bool plb_ps_start_pull(ps *p)
{
    ps_object what = p->retry;
    pulling *now = plb_ps_new(p, 1, sizeof *now);
    if (p->op)
        what = (ps_object){.type = PS_OPERATOR, .executable = true, .n = (uint32_t)p->line, .as.op = p->op};
    ps_frame *retry = now ? plb_ps_push_frame(p, step_retry) : NULL;
    ps_frame *f = retry ? plb_ps_push_frame(p, step_pull) : NULL;
    if (f) {
        retry->body = what;
        *now = (pulling){.file = p->pull};
        f->data = now;
        f->drop = drop_pull;
    }
    p->pull = NULL;
    return f != NULL;
}

/* Innermost first, and not by recursion: filters stand on filters as deep as the file likes. */
bool plb_ps_open_file(ps *p, ps_file *f)
{
    while (f->open) {
        ps_file *first = f;
        while (first->source && first->source->open && plb_ps_charge(p, 1))
            first = first->source;
        bool (*open)(ps *, ps_file *) = first->source && first->source->opaque ? open_opaque : first->open;
        first->open = NULL;
        if (p->err.kind != ERROR_NONE || !open(p, first))
            return false;
    }
    return true;
}

static const struct {
    const char *name;
    bool (*open)(ps *p, ps_file *f);
} filters[] = {
    {"ASCIIHexDecode", open_hex},   {"ASCII85Decode", open_ascii85}, {"RunLengthDecode", open_run_length},
    {"SubFileDecode", open_sub_file}, {"LZWDecode", open_lzw},    {"FlateDecode", open_opaque},
    {"DCTDecode", open_opaque},     {"CCITTFaxDecode", open_opaque}, {"ReusableStreamDecode", open_opaque},
};

/* ---- the operator ----------------------------------------------------------------------------------------- */

/* The stream a filter stands on; a string and a procedure are one too. */
static ps_file *source_of(ps *p, ps_object o, ps_object filter)
{
    if (o.type == PS_FILE)
        return o.as.file;
    if (o.type == PS_STRING)
        return plb_ps_file_of_string(p, o);
    if (!ps_is_proc(o)) {
        plb_ps_raise(p, PS_TYPECHECK);
        return NULL;
    }
    ps_file *f = plb_ps_new(p, 1, sizeof *f);
    if (f) {
        *f = (ps_file){.at = "", .open = open_procedure, .proc = o};
        f->end = f->at;
        f->until = plb_ps_text_is(filter, "ASCII85Decode") ? '~' : plb_ps_text_is(filter, "ASCIIHexDecode") ? '>' : -1;
    }
    return f;
}

/* SubFileDecode's count and mark, from the operands above its source or from the dictionary there. */
static bool sub_file_parameters(ps *p, ps_file *f)
{
    const ps_object *v = ps_args(p, 3), *count = &v[0], *mark = &v[1];
    if (v[1].type == PS_DICT) {
        count = plb_ps_get_text(p, v[1].as.dict, "EODCount");
        mark = plb_ps_get_text(p, v[1].as.dict, "EODString");
    }
    if (!count || !mark || count->type != PS_INTEGER || mark->type != PS_STRING)
        return plb_ps_raise(p, PS_TYPECHECK);
    f->count = count->as.integer;
    f->mark = *mark;
    return true;
}

/* source [dictionary] [count string] name */
static bool op_filter(ps *p)
{
    ps_object name = *ps_args(p, 1);
    bool is_sub_file = plb_ps_text_is(name, "SubFileDecode");
    size_t which = 0, known = sizeof filters / sizeof *filters;
    while (which < known && !plb_ps_text_is(name, filters[which].name))
        which++;
    if (which == known)
        return plb_ps_undefined(p, name);
    if (p->operand_count < 2)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    unsigned drop = ps_args(p, 2)->type == PS_DICT ? 3 : is_sub_file ? 4 : 2;
    if (p->operand_count < drop)
        return plb_ps_raise(p, PS_STACKUNDERFLOW);
    ps_file *from = source_of(p, *ps_args(p, drop), name), *f = from ? plb_ps_new(p, 1, sizeof *f) : NULL;
    if (!f)
        return false;
    *f = (ps_file){.at = "", .source = from, .open = filters[which].open, .filter = filters[which].name};
    f->end = f->at;
    return (!is_sub_file || sub_file_parameters(p, f)) && plb_ps_give(p, drop, ps_of_file(f));
}

const ps_operator plb_ps_filter_operators[] = {
    {"filter", "k", op_filter},
    {NULL, NULL, NULL},
};
