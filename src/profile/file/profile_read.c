/* SPDX-License-Identifier: MIT
 *
 * A profile from bytes: magic, version, size and checksum first, then one section after the other. Sections of an
 * unknown tag are skipped, so that later versions can add some. pencil(5) has the table.
 */
#include "profile/file/format.h"
#include "profile/grain/grain.h"
#include "profile/histogram.h"
#include "profile/profile.h"

#include "base/array.h"

#include <string.h>

/* The unread part of a section (or of the file). */
typedef struct {
    const unsigned char *at, *end;
} cursor;

/* Reads a little-endian number of `n` bytes. */
static bool take(cursor *c, size_t n, uint64_t *value)
{
    if ((size_t)(c->end - c->at) < n)
        return false;
    *value = 0;
    for (size_t i = 0; i < n; i++)
        *value |= (uint64_t)c->at[i] << 8 * i;
    c->at += n;
    return true;
}

static bool take_leb(cursor *c, uint32_t *value)
{
    uint64_t sum = 0, byte = 0x80;
    for (int shift = 0; byte & 0x80; shift += 7) {
        if (shift > 28 || !take(c, 1, &byte))
            return false;
        sum |= (byte & 0x7f) << shift;
    }
    *value = (uint32_t)sum;
    return sum <= FORMAT_MAX_COUNT;
}

static bool take_fixed(cursor *c, size_t n, double unit, double *value)
{
    uint64_t u;
    if (!take(c, n, &u))
        return false;
    *value = (double)u / unit;
    return true;
}

static bool within(double value, double low, double high)
{
    return value >= low && value <= high;
}

/* ---- sections: each reads the whole of its cursor, or returns false ---- */

static bool read_name(cursor *c, profile *p)
{
    size_t n = (size_t)(c->end - c->at);
    if (n == 0 || n >= sizeof p->name || !plb_text_is_clean((const char *)c->at, n, false))
        return false;
    memcpy(p->name, c->at, n);
    c->at = c->end;
    return true;
}

static bool read_scan(cursor *c, profile *p)
{
    uint64_t lines, pixels, paper;
    if (!take_fixed(c, 4, FORMAT_MILLI, &p->dpi) || !take_fixed(c, 4, FORMAT_MILLI, &p->width_half) ||
        !take_fixed(c, 4, FORMAT_MILLI, &p->width_tenth) || !take(c, 4, &lines) || !take(c, 8, &pixels) || !take(c, 1, &paper))
        return false;
    if (lines < 1 || lines > FORMAT_MAX_LINES || pixels < 1 || pixels > FORMAT_MAX_PIXELS || paper < 1)
        return false;
    p->lines = (int)lines;
    p->pixels = pixels;
    p->paper = (int)paper;
    return within(p->dpi, FORMAT_MIN_DPI, FORMAT_MAX_DPI) && p->width_half > 0 &&
           within(p->width_tenth, p->width_half, FORMAT_MAX_WIDTH);
}

static bool read_histogram(cursor *c, uint32_t counts[PROFILE_GREYS])
{
    uint64_t count, total = 0;
    for (int g = 0; g < PROFILE_GREYS; g++) {
        if (!take(c, 4, &count))
            return false;
        counts[g] = (uint32_t)count;
        total += count;
    }
    /* Something but white: percentiles exist. */
    return total <= FORMAT_MAX_COUNT && total > counts[PROFILE_GREYS - 1];
}

static bool read_mid(cursor *c, profile *p)
{
    return read_histogram(c, p->mid);
}

static bool read_range(cursor *c, profile *p)
{
    return read_histogram(c, p->range) && p->range[PROFILE_GREYS - 1] == 0;
}

static bool read_bounds(cursor *c, profile *p)
{
    int *const bounds[] = {&p->min_mid, &p->max_mid, &p->min_range, &p->max_range};
    for (size_t i = 0; i < 4; i++) {
        uint64_t grey;
        if (!take(c, 1, &grey))
            return false;
        *bounds[i] = (int)grey;
    }
    return p->min_mid <= p->max_mid && p->min_range <= p->max_mid && p->max_mid <= p->max_range && p->max_range < PROFILE_GREYS - 1;
}

static bool read_section(cursor *c, profile *p)
{
    uint64_t bins;
    double step;
    if (!take(c, 2, &bins) || !take_fixed(c, 2, FORMAT_MILLI, &step) || bins != PROFILE_SECTION_BINS || step != PROFILE_SECTION_STEP)
        return false;
    for (int k = 0; k < PROFILE_SECTION_BINS; k++)
        if (!take_fixed(c, 2, FORMAT_GREY, &p->section_mean[k]) || !take_fixed(c, 2, FORMAT_GREY, &p->section_sd[k]) ||
            p->section_mean[k] > 255 || p->section_sd[k] > 128)
            return false;
    return true;
}

static bool read_ccm(cursor *c, profile *p)
{
    const uint32_t max_cells = PROFILE_GREYS * PROFILE_GREYS;
    uint64_t cells, total = 0;
    if (!take(c, 4, &cells) || cells < 1 || cells > max_cells)
        return false;
    for (uint32_t next = 0; cells > 0; cells--) {
        uint32_t gap, count;
        if (!take_leb(c, &gap) || !take_leb(c, &count) || gap < 1 || gap > max_cells - next || count < 1)
            return false;
        next += gap;
        p->ccm[next - 1] = count;
        total += count;
    }
    return total <= FORMAT_MAX_COUNT;
}

/* Reads an IEEE 754 number of single precision. */
static bool take_float(cursor *c, float *value)
{
    uint64_t u;
    if (!take(c, 4, &u))
        return false;
    uint32_t bits = (uint32_t)u;
    memcpy(value, &bits, sizeof bits);
    return true;
}

static bool read_grain(cursor *c, profile *p)
{
    grain_model *g = &p->grain;
    for (size_t i = 0; i < GRAIN_MODES; i++) {
        uint64_t odd;
        if (!take(c, 1, &odd) || odd > 1)
            return false;
        g->mode_is_odd[i] = odd == 1;
    }
    for (size_t f = 0; f < GRAIN_FIELDS; f++) {
        float *values = (float *)(void *)((char *)g + plb_grain_fields[f].offset);
        for (size_t i = 0; i < plb_grain_fields[f].count; i++)
            if (!take_float(c, &values[i]))
                return false;
    }
    g->present = plb_grain_is_sound(g);
    return g->present;
}

static bool read_hand(cursor *c, profile *p)
{
    return take_fixed(c, 2, FORMAT_MILLI, &p->hand) && p->hand > 0 && p->hand <= FORMAT_MAX_HAND;
}

static bool read_provenance(cursor *c, profile *p)
{
    size_t n = (size_t)(c->end - c->at);
    if (n > FORMAT_MAX_TEXT || !plb_text_is_clean((const char *)c->at, n, true))
        return false;
    memcpy(p->provenance, c->at, n);
    c->at = c->end;
    return true;
}

static const struct {
    char tag[5];
    bool (*read)(cursor *, profile *);
    bool optional;
} sections[] = {
    {"NAME", read_name, false},   {"SCAN", read_scan, false},    {"HMID", read_mid, false}, {"HRNG", read_range, false},
    {"BNDS", read_bounds, false}, {"SECT", read_section, false}, {"COOC", read_ccm, false}, {"PROV", read_provenance, false},
    {"GRAI", read_grain, true}, /* since version 1.1 */
    {"HAND", read_hand, true},  /* since version 1.2 */
};
#define FILE_SECTIONS (sizeof sections / sizeof *sections)

/* ---- the file ---- */

static bool check_frame(const char *name, const unsigned char *data, size_t size, error *err)
{
    if (size < FORMAT_MAGIC_SIZE || memcmp(data, FORMAT_MAGIC, FORMAT_MAGIC_SIZE) != 0)
        return plb_fail(err, ERROR_SYNTAX, "%s: not a pencil profile", name);
    if (size < FORMAT_HEADER_SIZE + FORMAT_TRAILER_SIZE)
        return plb_fail(err, ERROR_SYNTAX, "%s: pencil profile cut short", name);
    cursor c = {data + FORMAT_MAGIC_SIZE, data + size};
    uint64_t major = 0, minor = 0, stated = 0, crc = 0;
    take(&c, 2, &major);
    take(&c, 2, &minor);
    take(&c, 4, &stated);
    if (major != FORMAT_MAJOR)
        return plb_fail(err, ERROR_UNSUPPORTED, "%s: pencil profile of version %u.%u; version %d is understood", name, (unsigned)major, (unsigned)minor, FORMAT_MAJOR);
    if (size != stated)
        return plb_fail(err, ERROR_SYNTAX, "%s: pencil profile %s", name, size < stated ? "cut short" : "longer than it says");
    c.at = data + size - FORMAT_TRAILER_SIZE;
    take(&c, 4, &crc);
    if (crc != plb_crc32(data, size - FORMAT_TRAILER_SIZE))
        return plb_fail(err, ERROR_SYNTAX, "%s: pencil profile damaged (its checksum is wrong)", name);
    return true;
}

/* The grain had fewer numbers in versions of the program before: its section is then sound, but of no use. */
static bool is_grain_of_another_time(const char *tag, cursor body)
{
    size_t floats = 0;
    for (size_t f = 0; f < GRAIN_FIELDS; f++)
        floats += plb_grain_fields[f].count;
    return !memcmp(tag, "GRAI", 4) && (size_t)(body.end - body.at) != GRAIN_MODES + 4 * floats;
}

/* Reads one section and marks its entry in `seen`. */
static bool parse_one(const char *name, const char *tag, cursor body, bool seen[FILE_SECTIONS], profile *p, error *err)
{
    size_t i = 0;
    while (i < FILE_SECTIONS && memcmp(tag, sections[i].tag, 4) != 0)
        i++;
    if (i == FILE_SECTIONS)
        return true;
    if (seen[i])
        return plb_fail(err, ERROR_SYNTAX, "%s: pencil profile has two %s sections", name, sections[i].tag);
    seen[i] = true;
    if (is_grain_of_another_time(tag, body))
        return plb_fail(err, ERROR_UNSUPPORTED, "%s: pencil profile with a GRAI section of another version of plumbago; capture it again", name);
    if (!sections[i].read(&body, p) || body.at != body.end)
        return plb_fail(err, ERROR_SYNTAX, "%s: pencil profile has a malformed %s section", name, sections[i].tag);
    return true;
}

static bool parse_sections(const char *name, cursor c, profile *p, error *err)
{
    bool seen[FILE_SECTIONS] = {false};
    for (int n = 0; c.at < c.end; n++) {
        const char *tag = (const char *)c.at;
        uint64_t skipped, length;
        if (n == FORMAT_MAX_SECTIONS)
            return plb_fail(err, ERROR_LIMIT, "%s: pencil profile has more than %d sections", name, FORMAT_MAX_SECTIONS);
        if (!take(&c, 4, &skipped) || !take(&c, 4, &length) || length > (uint64_t)(c.end - c.at))
            return plb_fail(err, ERROR_SYNTAX, "%s: pencil profile has a section that runs past its end", name);
        if (!parse_one(name, tag, (cursor){c.at, c.at + length}, seen, p, err))
            return false;
        c.at += length;
    }
    for (size_t i = 0; i < FILE_SECTIONS; i++)
        if (!seen[i] && !sections[i].optional)
            return plb_fail(err, ERROR_SYNTAX, "%s: pencil profile lacks the section %s", name, sections[i].tag);
    return true;
}

profile *plb_profile_parse(const char *name, const unsigned char *data, size_t size, error *err)
{
    if (!check_frame(name, data, size, err))
        return NULL;
    profile *p = plb_new(1, sizeof *p);
    if (p) {
        p->ccm = plb_new(PROFILE_GREYS * PROFILE_GREYS, sizeof *p->ccm);
        p->provenance = plb_new(size, 1); /* the text is shorter than the file */
    }
    cursor body = {data + FORMAT_HEADER_SIZE, data + size - FORMAT_TRAILER_SIZE};
    bool good = p && p->ccm && p->provenance ? parse_sections(name, body, p, err) : plb_fail_memory(err);
    if (!good) {
        plb_profile_release(p);
        return NULL;
    }
    return p;
}

void plb_profile_release(profile *p)
{
    if (!p)
        return;
    plb_free(p->ccm);
    plb_free(p->provenance);
    plb_free(p);
}

int plb_profile_centre(const profile *p)
{
    return plb_histogram_percentile(p->mid, PROFILE_GREYS, 0.5);
}
