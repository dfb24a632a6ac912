/* SPDX-License-Identifier: MIT
 *
 * The profile format: what is written is what is read; every damage is noticed; nothing a file says is believed
 * unchecked. And the eight pencils that are built in.
 */
#include "check.h"

#include "base/array.h"
#include "profile/file/format.h"
#include "profile/histogram.h"
#include "profile/profile.h"

#include <unistd.h>

/* ---- material ---- */

/* Makes a small profile with every field different. */
static profile *make_small(void)
{
    profile *p = plb_new(1, sizeof *p);
    p->ccm = plb_new(PROFILE_GREYS * PROFILE_GREYS, sizeof *p->ccm);
    p->provenance = plb_new(64, 1);
    strcpy(p->name, "Bleistift \303\244");
    strcpy(p->provenance, "first line\nsecond: \342\202\254\n");
    p->dpi = 299.999;
    p->width_half = 3.25;
    p->width_tenth = 6.125;
    p->paper = 251;
    p->lines = 3;
    p->pixels = 5000000000u;
    p->min_mid = 40, p->max_mid = 90, p->min_range = 30, p->max_range = 240;
    for (int g = 40; g < 90; g++)
        p->mid[g] = (uint32_t)(g * 7);
    p->mid[255] = 2;
    for (int g = 30; g < 255; g++)
        p->range[g] = (uint32_t)(100000 + g);
    for (int k = 0; k < PROFILE_SECTION_BINS; k++) {
        p->section_mean[k] = 60 + 3 * k + 1 / 256.0;
        p->section_sd[k] = 40 - k / 2.0;
    }
    p->ccm[0] = 1;
    p->ccm[40 * 256 + 41] = 127;
    p->ccm[40 * 256 + 42] = 128;
    p->ccm[200 * 256 + 7] = 16384;
    p->ccm[65535] = 2000000;
    return p;
}

static bool equal(const profile *a, const profile *b)
{
    return !strcmp(a->name, b->name) && !strcmp(a->provenance, b->provenance) && a->dpi == b->dpi && a->width_half == b->width_half &&
           a->width_tenth == b->width_tenth && a->paper == b->paper && a->lines == b->lines && a->pixels == b->pixels &&
           !memcmp(a->mid, b->mid, sizeof a->mid) && !memcmp(a->range, b->range, sizeof a->range) && a->min_mid == b->min_mid &&
           a->max_mid == b->max_mid && a->min_range == b->min_range && a->max_range == b->max_range &&
           !memcmp(a->section_mean, b->section_mean, sizeof a->section_mean) &&
           !memcmp(a->section_sd, b->section_sd, sizeof a->section_sd) &&
           !memcmp(a->ccm, b->ccm, PROFILE_GREYS * PROFILE_GREYS * sizeof *a->ccm);
}

typedef struct {
    unsigned char *v;
    size_t n;
} bytes;

static bytes small_bytes(void)
{
    profile *p = make_small();
    bytes b = {0};
    b.v = plb_profile_serialise(p, &b.n, NULL);
    plb_profile_release(p);
    return b;
}

static void put_le(unsigned char *at, size_t value, int n)
{
    for (int i = 0; i < n; i++)
        at[i] = (unsigned char)(value >> 8 * i);
}

/* Makes size and checksum right again, so that what is wrong is found by the reader of the section. */
static void seal(bytes *b)
{
    put_le(b->v + 12, b->n, 4);
    put_le(b->v + b->n - 4, plb_crc32(b->v, b->n - 4), 4);
}

static size_t length_at(const unsigned char *tag)
{
    return tag[4] | (size_t)tag[5] << 8 | (size_t)tag[6] << 16 | (size_t)tag[7] << 24;
}

/* Where a section starts (at its tag). */
static size_t find_section(const bytes *b, const char *tag)
{
    size_t at = FORMAT_HEADER_SIZE;
    while (at + 12 < b->n && memcmp(b->v + at, tag, 4) != 0)
        at += 8 + length_at(b->v + at);
    return at;
}

/* Replaces the content of a section (NULL: takes the section out). */
static bytes replace(const bytes *b, const char *tag, const void *content, size_t n)
{
    size_t at = find_section(b, tag), end = at + 8 + length_at(b->v + at), head = content ? at + 8 : at;
    bytes out = {malloc(b->n + n + 8), head + n + b->n - end};
    memcpy(out.v, b->v, head);
    if (n)
        memcpy(out.v + head, content, n);
    memcpy(out.v + head + n, b->v + end, b->n - end);
    if (content)
        put_le(out.v + at + 4, n, 4);
    seal(&out);
    return out;
}

/* The kind of error of parsing these bytes; ERROR_NONE when they are a profile. */
static error_kind parse(const bytes *b, error *err)
{
    *err = (error){0};
    unsigned char *exact = malloc(b->n ? b->n : 1); /* so that the sanitiser sees every byte too far */
    memcpy(exact, b->v, b->n);
    profile *p = plb_profile_parse("x.pencil", exact, b->n, err);
    if ((p == NULL) != (err->kind != ERROR_NONE) || (!p && strncmp(err->text, "x.pencil: ", 10)) || strchr(err->text, '\n'))
        printf("FAIL parse: result and error disagree: %s\n", err->text), check_any_failed = true;
    plb_profile_release(p);
    free(exact);
    return err->kind;
}

/* ---- what is written is what is read ---- */

static void round_trip(void)
{
    profile *p = make_small(), *q = NULL;
    error err = {0};
    size_t n, m;
    unsigned char *a = plb_profile_serialise(p, &n, &err), *b = NULL;
    CHECK(a && (q = plb_profile_parse("x", a, n, &err)));
    if (q) {
        CHECK(equal(p, q));
        b = plb_profile_serialise(q, &m, &err);
        CHECK(b && m == n && !memcmp(a, b, n));
    }
    plb_free(a);
    plb_free(b);
    plb_profile_release(p);
    plb_profile_release(q);
}

static void file_round_trip(void)
{
    profile *p = make_small();
    error err = {0};
    CHECK(plb_profile_write(p, "small.pencil", &err));
    profile *q = plb_profile_read("small.pencil", &err);
    CHECK(q && equal(p, q));
    plb_profile_release(q);
    CHECK(!plb_profile_write(p, "no/such/folder/x.pencil", &err) && err.kind == ERROR_FILE);
    CHECK(access("no", F_OK) != 0);
    plb_profile_release(p);
    unlink("small.pencil");
}

static void absent_file(void)
{
    error err = {0};
    CHECK(!plb_profile_read("no-such.pencil", &err) && err.kind == ERROR_FILE && strstr(err.text, "no-such.pencil"));
    err = (error){0};
    CHECK(!plb_profile_read(".", &err) && err.kind != ERROR_NONE);
}

/* The published check value of CRC-32: that of the digits 1 to 9. */
static void checksum_is_the_standard_one(void)
{
    CHECK(plb_crc32((const unsigned char *)"123456789", 9) == 0xcbf43926u);
}

/* ---- damage ---- */

static void every_truncation_is_noticed(void)
{
    bytes b = small_bytes();
    error err;
    bool all = true;
    for (size_t n = 0; n < b.n; n++)
        all = all && parse(&(bytes){b.v, n}, &err) == ERROR_SYNTAX;
    CHECK(all);
    CHECK(parse(&b, &err) == ERROR_NONE);
    plb_free(b.v);
}

/* The same with size and checksum made to fit: then the sections are at fault. */
static void every_sealed_truncation_is_noticed(void)
{
    bytes b = small_bytes();
    error err;
    bool all = true;
    for (size_t n = FORMAT_HEADER_SIZE + FORMAT_TRAILER_SIZE; n < b.n; n++) {
        bytes cut = {malloc(n), n};
        memcpy(cut.v, b.v, n);
        seal(&cut);
        all = all && parse(&cut, &err) == ERROR_SYNTAX;
        free(cut.v);
    }
    CHECK(all);
    plb_free(b.v);
}

static void every_flipped_bit_is_noticed(void)
{
    bytes b = small_bytes();
    error err;
    bool all = true;
    for (size_t i = 0; i < b.n; i++)
        for (int bit = 0; bit < 8; bit++) {
            b.v[i] ^= (unsigned char)(1 << bit);
            all = all && parse(&b, &err) != ERROR_NONE;
            b.v[i] ^= (unsigned char)(1 << bit);
        }
    CHECK(all);
    plb_free(b.v);
}

/* Flipped bits with the checksum made to fit: what passes must still be a profile that nobody trips over. */
static void what_passes_is_sound(void)
{
    bytes b = small_bytes();
    bool sound = true;
    int passed = 0;
    for (size_t i = FORMAT_HEADER_SIZE; i < b.n - 4; i++)
        for (int bit = 0; bit < 8; bit += 1 + (int)(i % 3)) {
            b.v[i] ^= (unsigned char)(1 << bit);
            seal(&b);
            profile *p = plb_profile_parse("x", b.v, b.n, NULL);
            if (p) {
                passed++;
                sound = sound && p->dpi >= FORMAT_MIN_DPI && p->width_half > 0 && p->width_tenth >= p->width_half && p->lines > 0 &&
                        p->min_mid >= 0 && p->min_mid <= p->max_mid && p->max_mid <= p->max_range && p->max_range < 255 &&
                        p->min_range <= p->max_mid && plb_histogram_total(p->mid, 255) > 0 && plb_profile_centre(p) >= 0 &&
                        plb_histogram_total(p->range, 256) <= FORMAT_MAX_COUNT && strlen(p->name) < PROFILE_NAME_SIZE;
            }
            plb_profile_release(p);
            b.v[i] ^= (unsigned char)(1 << bit);
        }
    CHECK(sound);
    CHECK(passed > 100);
    plb_free(b.v);
}

/* ---- sections that lie ---- */

typedef struct {
    const char *what, *tag;
    const void *content; /* NULL: the section is taken out */
    size_t n;
} lie;
#define LIE(what, tag, text) {what, tag, text, sizeof(text) - 1}

static void lying_sections(void)
{
    static const lie lies[] = {
        {"no name", "NAME", NULL, 0},
        {"no scan", "SCAN", NULL, 0},
        {"no centre histogram", "HMID", NULL, 0},
        {"no matrix", "COOC", NULL, 0},
        {"no provenance", "PROV", NULL, 0},
        LIE("empty name", "NAME", ""),
        LIE("name of 32 bytes", "NAME", "12345678901234567890123456789012"),
        LIE("line feed in the name", "NAME", "a\nb"),
        LIE("escape in the name", "NAME", "a\033[2J"),
        LIE("zero in the name", "NAME", "a\0b"),
        LIE("Latin-1 in the name", "NAME", "\344"),
        LIE("overlong UTF-8", "NAME", "\300\257"),
        LIE("surrogate in UTF-8", "NAME", "\355\240\200"),
        LIE("UTF-8 cut short", "NAME", "a\342\202"),
        LIE("control character of Unicode", "NAME", "a\302\233b"),
        LIE("escape in the provenance", "PROV", "a\033b"),
        LIE("resolution 0", "SCAN", "\0\0\0\0\xe8\3\0\0\xd0\7\0\0\1\0\0\0\1\0\0\0\0\0\0\0\377"),
        LIE("resolution 4 million", "SCAN", "\377\377\377\377\xe8\3\0\0\xd0\7\0\0\1\0\0\0\1\0\0\0\0\0\0\0\377"),
        LIE("full width below the other", "SCAN", "\xe0\223\4\0\xd0\7\0\0\xe8\3\0\0\1\0\0\0\1\0\0\0\0\0\0\0\377"),
        LIE("no lines", "SCAN", "\xe0\223\4\0\xe8\3\0\0\xd0\7\0\0\0\0\0\0\1\0\0\0\0\0\0\0\377"),
        LIE("2^64 pixels", "SCAN", "\xe0\223\4\0\xe8\3\0\0\xd0\7\0\0\1\0\0\0\377\377\377\377\377\377\377\377\377"),
        LIE("scan of 24 bytes", "SCAN", "\xe0\223\4\0\xe8\3\0\0\xd0\7\0\0\1\0\0\0\1\0\0\0\0\0\0\0"),
        LIE("bounds upside down", "BNDS", "\132\50\36\360"),
        LIE("white as a bound", "BNDS", "\50\132\36\377"),
        LIE("range ends before the centre", "BNDS", "\50\132\36\131"),
        LIE("three bounds", "BNDS", "\50\132\36"),
        LIE("five bounds", "BNDS", "\50\132\36\360\0"),
        LIE("section of 65535 bins", "SECT", "\377\377\372\0"),
        LIE("matrix without cells", "COOC", "\0\0\0\0"),
        LIE("4 billion cells", "COOC", "\377\377\377\377\1\1"),
        LIE("more cells than there are", "COOC", "\3\0\0\0\1\1\1\1"),
        LIE("fewer cells than there are", "COOC", "\1\0\0\0\1\1\1\1"),
        LIE("cell beyond the matrix", "COOC", "\1\0\0\0\201\200\4\1"),
        LIE("gap 0", "COOC", "\1\0\0\0\0\1"),
        LIE("count 0", "COOC", "\1\0\0\0\1\0"),
        LIE("count of 2^31", "COOC", "\1\0\0\0\1\200\200\200\200\10"),
        LIE("counts that sum to 2^31", "COOC", "\2\0\0\0\1\377\377\377\377\7\1\1"),
        LIE("number without an end", "COOC", "\1\0\0\0\1\200\200\200\200\200\200\200\0"),
    };
    bytes b = small_bytes();
    for (size_t i = 0; i < sizeof lies / sizeof *lies; i++) {
        error err;
        bytes bad = replace(&b, lies[i].tag, lies[i].content, lies[i].n);
        bool refused = parse(&bad, &err) == ERROR_SYNTAX && strstr(err.text, lies[i].tag);
        if (!refused)
            printf("# %s: %s\n", lies[i].what, err.text);
        CHECK(refused);
        free(bad.v);
    }
    plb_free(b.v);
}

static void lying_histograms(void)
{
    bytes b = small_bytes();
    unsigned char counts[1024] = {0};
    error err;
    bytes bad = replace(&b, "HMID", counts, sizeof counts);
    CHECK(parse(&bad, &err) == ERROR_SYNTAX); /* empty */
    free(bad.v);
    counts[1020] = 9;
    bad = replace(&b, "HMID", counts, sizeof counts);
    CHECK(parse(&bad, &err) == ERROR_SYNTAX); /* nothing but white */
    free(bad.v);
    counts[40] = 1;
    bad = replace(&b, "HMID", counts, sizeof counts);
    CHECK(parse(&bad, &err) == ERROR_NONE);
    free(bad.v);
    bad = replace(&b, "HRNG", counts, sizeof counts);
    CHECK(parse(&bad, &err) == ERROR_SYNTAX); /* white in the range */
    free(bad.v);
    memset(counts, 255, sizeof counts);
    bad = replace(&b, "HMID", counts, sizeof counts);
    CHECK(parse(&bad, &err) == ERROR_SYNTAX); /* 256 x 4 billion */
    free(bad.v);
    plb_free(b.v);
}

/* ---- growth ---- */

/* `n` bytes put in before the checksum. */
static bytes append(const bytes *b, const void *more, size_t n)
{
    bytes out = {malloc(b->n + n), b->n + n};
    memcpy(out.v, b->v, b->n - 4);
    memcpy(out.v + b->n - 4, more, n);
    seal(&out);
    return out;
}

static void unknown_sections_are_skipped(void)
{
    bytes b = small_bytes();
    error err;
    bytes more = append(&b, "LATR\3\0\0\0abc", 11);
    CHECK(parse(&more, &err) == ERROR_NONE);
    free(more.v);
    more = append(&b, "LATR\4\0\0\0abc", 11);
    CHECK(parse(&more, &err) == ERROR_SYNTAX);
    free(more.v);
    more = append(&b, "LATR\377\377\377\377abc", 11);
    CHECK(parse(&more, &err) == ERROR_SYNTAX);
    free(more.v);
    more = append(&b, "NAME\1\0\0\0a", 9);
    CHECK(parse(&more, &err) == ERROR_SYNTAX && strstr(err.text, "two NAME"));
    free(more.v);
    plb_free(b.v);
}

static void sections_without_end(void)
{
    bytes b = small_bytes();
    error err;
    for (int i = 0; i < 100; i++) {
        bytes more = append(&b, "LATR\0\0\0\0", 8);
        free(b.v);
        b = more;
    }
    CHECK(parse(&b, &err) == ERROR_LIMIT);
    free(b.v);
}

static void the_hand_is_kept_and_checked(void)
{
    static const struct {
        const char *section;
        size_t size;
        error_kind kind;
    } cases[] = {
        {"HAND\2\0\0\0\326\0", 10, ERROR_NONE},    {"HAND\2\0\0\0\20\47", 10, ERROR_NONE},  {"HAND\2\0\0\0\0\0", 10, ERROR_SYNTAX},
        {"HAND\2\0\0\0\21\47", 10, ERROR_SYNTAX}, {"HAND\1\0\0\0\1", 9, ERROR_SYNTAX},     {"HAND\3\0\0\0\1\0\0", 11, ERROR_SYNTAX},
    };
    bytes b = small_bytes();
    error err;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bytes with = append(&b, cases[i].section, cases[i].size);
        CHECK(parse(&with, &err) == cases[i].kind && (cases[i].kind == ERROR_NONE || strstr(err.text, "HAND")));
        free(with.v);
    }
    bytes with = append(&b, cases[0].section, cases[0].size);
    profile *without = plb_profile_parse("x", b.v, b.n, &err), *p = plb_profile_parse("x", with.v, with.n, &err);
    CHECK(without && without->hand == 0 && p && p->hand == 0.214);
    size_t n = 0;
    unsigned char *again = p ? plb_profile_serialise(p, &n, &err) : NULL;
    profile *q = again ? plb_profile_parse("x", again, n, &err) : NULL;
    CHECK(q && q->hand == 0.214);
    plb_profile_release(without);
    plb_profile_release(p);
    plb_profile_release(q);
    plb_free(again);
    plb_free(b.v);
    free(with.v);
}

static void later_versions(void)
{
    bytes b = small_bytes();
    error err;
    b.v[10] = 7; /* minor */
    seal(&b);
    CHECK(parse(&b, &err) == ERROR_NONE);
    b.v[8] = 2; /* major */
    seal(&b);
    CHECK(parse(&b, &err) == ERROR_UNSUPPORTED && strstr(err.text, "2.7"));
    plb_free(b.v);
}

/* ---- the eight pencils ---- */

static void the_eight_are_there(void)
{
    static const char *const grades[] = {"2H", "H", "F", "HB", "B", "3B", "6B", "8B"};
    int centre = 256;
    double width = 0;
    for (size_t i = 0; i < 8; i++) {
        error err = {0};
        CHECK(!strcmp(plb_profile_grade(i), grades[i]));
        profile *p = plb_profile_read(grades[i], &err);
        CHECK(p != NULL);
        if (!p)
            return;
        CHECK(!strcmp(p->name, grades[i]));
        CHECK(plb_profile_centre(p) < centre); /* from hard to soft: darker … */
        CHECK(p->width_half > width);          /* … and wider */
        CHECK(strstr(p->provenance, "CC BY 4.0") && strstr(p->provenance, "assigned, not known"));
        centre = plb_profile_centre(p);
        width = p->width_half;
        plb_profile_release(p);
    }
    CHECK(plb_profile_grade(8) == NULL && plb_profile_grade((size_t)-1) == NULL);
}

/* HB of JIS S 6006: density 0.25 to 0.45, in sRGB grey 198 to 161. */
static void hb_is_as_dark_as_the_standard_says(void)
{
    profile *p = plb_profile_read("hb", NULL);
    CHECK(p && !strcmp(p->name, "HB"));
    if (p)
        CHECK_RANGE(plb_profile_centre(p), 161, 198);
    plb_profile_release(p);
}

/* The figures of each pencil agree with each other. */
static void the_eight_are_consistent(void)
{
    for (size_t i = 0; plb_profile_grade(i); i++) {
        profile *p = plb_profile_read(plb_profile_grade(i), NULL);
        if (!p)
            continue;
        uint64_t pairs = 0;
        for (int c = 0; c < PROFILE_GREYS * PROFILE_GREYS; c++)
            pairs += p->ccm[c];
        CHECK(plb_histogram_total(p->mid, 256) == p->pixels);
        CHECK(p->min_mid == plb_histogram_percentile(p->mid, 255, 0.01) && p->max_mid == plb_histogram_percentile(p->mid, 255, 0.99));
        CHECK(p->min_range == plb_histogram_percentile(p->range, 255, 0.01) && p->max_range == plb_histogram_percentile(p->range, 255, 0.99));
        CHECK(pairs > 3 * p->pixels && pairs < 20 * p->pixels);
        CHECK_RANGE(p->section_mean[0] - plb_histogram_mean(p->mid, 256), -3, 3);
        CHECK_RANGE(p->section_mean[PROFILE_SECTION_BINS - 1], 254.5, 255);
        plb_profile_release(p);
    }
}

int main(void)
{
    RUN(round_trip);
    RUN(file_round_trip);
    RUN(absent_file);
    RUN(checksum_is_the_standard_one);
    RUN(every_truncation_is_noticed);
    RUN(every_sealed_truncation_is_noticed);
    RUN(every_flipped_bit_is_noticed);
    RUN(what_passes_is_sound);
    RUN(lying_sections);
    RUN(lying_histograms);
    RUN(unknown_sections_are_skipped);
    RUN(sections_without_end);
    RUN(the_hand_is_kept_and_checked);
    RUN(later_versions);
    RUN(the_eight_are_there);
    RUN(hb_is_as_dark_as_the_standard_says);
    RUN(the_eight_are_consistent);
    CHECK_EXIT;
}
