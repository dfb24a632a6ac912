/* SPDX-License-Identifier: MIT
 *
 * A profile as bytes and as a file: header, sections, checksum, all little-endian. pencil(5) has the table.
 */
#include "profile/file/format.h"
#include "profile/grain/grain.h"
#include "profile/profile.h"

#include "base/array.h"
#include "system/output.h"

#include <math.h>
#include <string.h>

typedef struct {
    ARRAY(unsigned char) bytes;
    bool full; /* out of memory: the bytes are incomplete */
} buffer;

static void put_bytes(buffer *b, const void *data, size_t n)
{
    if (b->full || !array_reserve(&b->bytes, n)) {
        b->full = true;
        return;
    }
    memcpy(b->bytes.v + b->bytes.n, data, n);
    b->bytes.n += n;
}

/* Writes the `n` low bytes of `value`, lowest first. */
static void put(buffer *b, uint64_t value, size_t n)
{
    unsigned char byte[8];
    for (size_t i = 0; i < n; i++)
        byte[i] = (unsigned char)(value >> 8 * i);
    put_bytes(b, byte, n);
}

/* Writes LEB128: seven bits a byte, lowest first, the high bit says that more follow. */
static void put_leb(buffer *b, uint32_t value)
{
    for (; value > 0x7f; value >>= 7)
        put(b, (value & 0x7f) | 0x80, 1);
    put(b, value, 1);
}

static void put_fixed(buffer *b, double value, double unit, size_t n)
{
    put(b, (uint64_t)floor(value * unit + 0.5), n);
}

static void write_name(buffer *b, const profile *p)
{
    put_bytes(b, p->name, strlen(p->name));
}

static void write_scan(buffer *b, const profile *p)
{
    put_fixed(b, p->dpi, FORMAT_MILLI, 4);
    put_fixed(b, p->width_half, FORMAT_MILLI, 4);
    put_fixed(b, p->width_tenth, FORMAT_MILLI, 4);
    put(b, (uint64_t)p->lines, 4);
    put(b, p->pixels, 8);
    put(b, (uint64_t)p->paper, 1);
}

static void write_histogram(buffer *b, const uint32_t counts[PROFILE_GREYS])
{
    for (int g = 0; g < PROFILE_GREYS; g++)
        put(b, counts[g], 4);
}

static void write_mid(buffer *b, const profile *p)
{
    write_histogram(b, p->mid);
}

static void write_range(buffer *b, const profile *p)
{
    write_histogram(b, p->range);
}

static void write_bounds(buffer *b, const profile *p)
{
    const int bounds[] = {p->min_mid, p->max_mid, p->min_range, p->max_range};
    for (size_t i = 0; i < 4; i++)
        put(b, (uint64_t)bounds[i], 1);
}

static void write_section(buffer *b, const profile *p)
{
    put(b, PROFILE_SECTION_BINS, 2);
    put_fixed(b, PROFILE_SECTION_STEP, FORMAT_MILLI, 2);
    for (int k = 0; k < PROFILE_SECTION_BINS; k++) {
        put_fixed(b, p->section_mean[k], FORMAT_GREY, 2);
        put_fixed(b, p->section_sd[k], FORMAT_GREY, 2);
    }
}

static void write_ccm(buffer *b, const profile *p)
{
    uint32_t cells = 0, last = 0;
    for (uint32_t i = 0; i < PROFILE_GREYS * PROFILE_GREYS; i++)
        cells += p->ccm[i] != 0;
    put(b, cells, 4);
    for (uint32_t i = 0; i < PROFILE_GREYS * PROFILE_GREYS; i++)
        if (p->ccm[i]) {
            put_leb(b, i + 1 - last);
            put_leb(b, p->ccm[i]);
            last = i + 1;
        }
}

/* Writes an IEEE 754 number of single precision: its bits as a number. */
static void put_float(buffer *b, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put(b, bits, 4);
}

static void write_grain(buffer *b, const profile *p)
{
    for (size_t i = 0; i < GRAIN_MODES; i++)
        put(b, p->grain.mode_is_odd[i], 1);
    for (size_t f = 0; f < GRAIN_FIELDS; f++) {
        const float *values = (const float *)(const void *)((const char *)&p->grain + plb_grain_fields[f].offset);
        for (size_t i = 0; i < plb_grain_fields[f].count; i++)
            put_float(b, values[i]);
    }
}

static void write_hand(buffer *b, const profile *p)
{
    put_fixed(b, p->hand, FORMAT_MILLI, 2);
}

static void write_provenance(buffer *b, const profile *p)
{
    put_bytes(b, p->provenance, strlen(p->provenance));
}

static const struct {
    char tag[5];
    void (*write)(buffer *, const profile *);
} sections[] = {
    {"NAME", write_name},   {"SCAN", write_scan},    {"HMID", write_mid}, {"HRNG", write_range},
    {"BNDS", write_bounds}, {"SECT", write_section}, {"COOC", write_ccm}, {"GRAI", write_grain},
    {"HAND", write_hand},   {"PROV", write_provenance},
};

/* Sections that say nothing are left out. */
static bool is_left_out(void (*write)(buffer *, const profile *), const profile *p)
{
    return (write == write_grain && !p->grain.present) || (write == write_hand && p->hand == 0);
}

static void patch_u32(buffer *b, size_t at, size_t value)
{
    for (size_t i = 0; i < 4 && !b->full; i++)
        b->bytes.v[at + i] = (unsigned char)(value >> 8 * i);
}

unsigned char *plb_profile_serialise(const profile *p, size_t *size, error *err)
{
    buffer b = {0};
    put_bytes(&b, FORMAT_MAGIC, FORMAT_MAGIC_SIZE);
    put(&b, FORMAT_MAJOR, 2);
    put(&b, FORMAT_MINOR, 2);
    put(&b, 0, 4);
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        if (is_left_out(sections[i].write, p))
            continue;
        put_bytes(&b, sections[i].tag, 4);
        size_t length_at = b.bytes.n;
        put(&b, 0, 4);
        sections[i].write(&b, p);
        patch_u32(&b, length_at, b.bytes.n - length_at - 4);
    }
    patch_u32(&b, FORMAT_HEADER_SIZE - 4, b.bytes.n + FORMAT_TRAILER_SIZE);
    put(&b, b.full ? 0 : plb_crc32(b.bytes.v, b.bytes.n), 4);
    if (b.full) {
        array_free(&b.bytes);
        plb_fail_memory(err);
        return NULL;
    }
    *size = b.bytes.n;
    return b.bytes.v;
}

bool plb_profile_write(const profile *p, const char *file, error *err)
{
    size_t size;
    output out;
    unsigned char *data = plb_profile_serialise(p, &size, err);
    bool good = data && plb_output_open(&out, file, err);
    if (good) {
        fwrite(data, 1, size, out.to); /* a short write shows when committing */
        good = plb_output_commit(&out, err);
    }
    plb_free(data);
    return good;
}
