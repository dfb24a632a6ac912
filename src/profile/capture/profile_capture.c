/* SPDX-License-Identifier: MIT
 *
 * A pencil measured from scans (001 section 3.2, thesis section 4.1): the one line of each scan is found and
 * straightened, then histograms, co-occurrence matrix and cross-section are pooled over all lines.
 *
 * Differences from the papers: the bounds are 1st and 99th percentiles, so that a grain of dust sets none; the line
 * lies along x instead of y, so that the neighbour of the matrix is the next pixel in x, and on a line at an angle the
 * next pixel along the straightened line; the cross-section is measured too.
 */
#include "profile/file/format.h"
#include "profile/grain/grain.h"
#include "profile/histogram.h"
#include "profile/capture/line_find.h"
#include "profile/capture/line_section.h"
#include "profile/capture/line_straighten.h"
#include "profile/profile.h"

#include "base/array.h"
#include "base/geometry/interpolate.h"
#include "base/sort.h"
#include "base/number/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PAPER_SHARE 0.90      /* paper is the 90th percentile of a scan */
#define MIN_PAPER 100         /* darker is no white paper */
#define MIN_COLUMNS 100       /* of usable line, in 1/300 inch */
#define LOW 0.01              /* the percentiles that are the bounds */
#define HIGH 0.99
#define DPI_TOLERANCE 0.01    /* scans of one profile have one resolution */
#define MIN_WIDTH 0.05      /* mm: half a pixel of 1/300 inch, finer than which no line is drawn … */
#define MAX_WIDTH 2.0        /* … to that of the broadest lead; both chosen by eye */
#define MIN_STRAYS 16       /* fewer modes of lines do not tell the hand: two or three long lines; chosen by eye */
#define MIN_LINE_SHARE 0.4   /* of the marks, below which there are many; chosen by eye: scans of one line have 0.5 to 1.1 */
#define WIDTH_STEPS 12        /* of fitting the section to the width wanted */

typedef struct {
    const capture_options *options;
    double dpi; /* of all scans; 0: not known yet */
    ARRAY(line_strip) strips;
    ARRAY(line_strip) reduced; /* of scans finer than the grain's resolution: the same lines at that */
} capture;

capture_options plb_capture_defaults(void)
{
    return (capture_options){.name = "pencil", .provenance = "", .centre_max = PROFILE_GREYS - 1};
}

/* ---- one scan ---- */

static int paper_of(const scan *s)
{
    uint32_t counts[PROFILE_GREYS] = {0};
    for (size_t i = 0; i < (size_t)s->width * (size_t)s->height; i++)
        counts[s->grey[i]]++;
    return plb_histogram_percentile(counts, PROFILE_GREYS, PAPER_SHARE);
}

/* Settles the resolution with the first scan; the others must agree. */
static bool settle_dpi(capture *c, const char *file, const scan *s, error *err)
{
    double dpi = c->options->dpi > 0 ? c->options->dpi : s->dpi > 0 ? s->dpi : PAPER_PX_PER_INCH;
    if (!(dpi >= FORMAT_MIN_DPI && dpi <= FORMAT_MAX_DPI))
        return plb_fail(err, ERROR_ARGUMENT, "%s: a resolution of %g dpi is not between %g and %g", file, dpi, FORMAT_MIN_DPI, FORMAT_MAX_DPI);
    if (c->dpi == 0)
        c->dpi = floor(dpi * FORMAT_MILLI + 0.5) / FORMAT_MILLI;
    if (fabs(dpi - c->dpi) > DPI_TOLERANCE * c->dpi)
        return plb_fail(err, ERROR_ARGUMENT, "%s: scanned at %g dpi, the scans before at %g", file, dpi, c->dpi);
    return true;
}

/* Finds the line of the scan along x or, when the darker one runs the other way, of its transpose. */
static bool make_strip(const scan *s, double unit, int paper, line_strip *strip, error *err)
{
    scan turned;
    line_track along = {0}, across = {0};
    *strip = (line_strip){0};
    if (!plb_scan_png_transpose(s, &turned, err))
        return false;
    bool good = plb_line_find(s, unit, paper, &along, err) && plb_line_find(&turned, unit, paper, &across, err);
    bool upright = across.score > along.score;
    if (good && (along.n || across.n))
        good = plb_line_strip_make(upright ? &turned : s, upright ? &across : &along, unit, paper, strip, err);
    plb_line_track_free(&along);
    plb_line_track_free(&across);
    plb_scan_png_free(&turned);
    return good;
}

/* Says what was found in the scan; true when the line is to be used. */
static bool judge(const capture *c, const char *file, const line_strip *s)
{
    const capture_options *o = c->options;
    if (s->columns < MIN_COLUMNS * c->dpi / PAPER_PX_PER_INCH || s->width_half <= 0 || s->width_tenth <= 0) {
        plb_log(&o->say, MESSAGE_DETAIL, "%s: left out: no long line with clear paper beside it", file);
        return false;
    }
    bool fits = s->centre >= o->centre_min && s->centre <= o->centre_max;
    plb_log(&o->say, MESSAGE_DETAIL, "%s: %s: centre %d, width %.3f mm (%.2f px, %.2f px at a tenth), %d px of line, paper %d", file,
            fits ? "used" : "left out", s->centre, s->width_half / c->dpi * MM_PER_INCH, s->width_half, s->width_tenth, s->columns, s->paper);
    return fits;
}

/* Warns of a scan with many marks: one line of several is measured, and others beside or across it spoil its section. What is
 * darker than half the line's depth should be about the line's own area. */
static void warn_of_marks(const capture *c, const char *file, const scan *s, const line_strip *line)
{
    size_t dark = 0, pixels = (size_t)s->width * (size_t)s->height;
    int half = (line->paper + line->centre) / 2;
    for (size_t i = 0; i < pixels; i++)
        dark += s->grey[i] < half;
    double share = line->n * line->width_half / (double)(dark ? dark : 1);
    if (share < MIN_LINE_SHARE)
        plb_log(&c->options->say, MESSAGE_WARNING, "%s: the scan shows many marks, of which the one line measured is %.0f %%: crop it to one line", file, 100 * share);
}

/* The grain is that of PAPER_PX_PER_INCH: a finer scan is averaged down to it, from a coarser one it cannot be had. */
static bool has_grain_resolution(const capture *c)
{
    return fabs(c->dpi - PAPER_PX_PER_INCH) <= DPI_TOLERANCE * PAPER_PX_PER_INCH;
}

static bool add_reduced(capture *c, const scan *s, int paper, error *err)
{
    scan small;
    line_strip strip;
    if (has_grain_resolution(c) || c->dpi < PAPER_PX_PER_INCH)
        return true;
    if (!plb_scan_reduce(s, c->dpi / PAPER_PX_PER_INCH, &small, err))
        return false;
    bool made = make_strip(&small, 1, paper, &strip, err), kept = made && array_push(&c->reduced, strip);
    plb_scan_png_free(&small);
    if (made && !kept) {
        plb_line_strip_free(&strip);
        plb_fail_memory(err);
    }
    return kept;
}

static bool add_strip(capture *c, const char *file, const scan *s, error *err)
{
    line_strip strip;
    int paper = paper_of(s);
    if (paper < MIN_PAPER) {
        plb_log(&c->options->say, MESSAGE_DETAIL, "%s: left out: too dark for paper", file);
        return true;
    }
    if (!make_strip(s, c->dpi / PAPER_PX_PER_INCH, paper, &strip, err))
        return false;
    bool use = judge(c, file, &strip);
    if (use)
        warn_of_marks(c, file, s, &strip);
    if (use && array_push(&c->strips, strip))
        return add_reduced(c, s, paper, err);
    plb_line_strip_free(&strip);
    return use ? plb_fail_memory(err) : true;
}

static bool add_scan(capture *c, const char *file, error *err)
{
    scan s;
    if (!plb_scan_png_read(&s, file, err))
        return false;
    bool good = settle_dpi(c, file, &s, err) && add_strip(c, file, &s, err);
    plb_scan_png_free(&s);
    return good;
}

/* ---- pooling ---- */

/* Counts both histograms and the matrix over the pixels nearer the centreline than half the line's full width. */
static void count_greys(const line_strip *s, profile *p)
{
    for (int k = 0; k < s->n; k++) {
        if (!s->usable[k])
            continue;
        p->pixels++;
        p->mid[strip_grey(s, k, 0)]++;
        bool pair = k + 1 < s->n && s->usable[k + 1];
        for (int o = -s->reach; o <= s->reach; o++) {
            if (strip_distance(s, k, o) > s->width_tenth / 2)
                continue;
            uint8_t grey = strip_grey(s, k, o);
            if (grey < 255)
                p->range[grey]++;
            if (pair)
                p->ccm[grey * PROFILE_GREYS + strip_grey(s, k + 1, o)]++;
        }
    }
}

/* Computes the section of all lines, each stretched to the same width at half depth, so that lines of several widths do not
 * blur its flanks. Stretching the pooled section once more makes it `width` px wide exactly. */
static void pool_section(const capture *c, double width, profile *p)
{
    double fit = 1;
    for (int step = 0; step < WIDTH_STEPS; step++) {
        section_sums sums = {0};
        for (size_t i = 0; i < c->strips.n; i++)
            plb_section_add(&sums, &c->strips.v[i], fit * width / c->strips.v[i].width_half);
        plb_section_figures(&sums, p->section_mean, p->section_sd);
        p->width_half = plb_section_width(p->section_mean, 0.5);
        p->width_tenth = plb_section_width(p->section_mean, 0.1);
        if (p->width_half > 0)
            fit *= width / p->width_half;
    }
}

/* Gives the width wanted, or else that of the lines, each weighted with its length. */
static double pooled_width(const capture *c, double wanted_mm)
{
    double sum = 0, columns = 0;
    for (size_t i = 0; i < c->strips.n; i++) {
        sum += c->strips.v[i].width_half * c->strips.v[i].columns;
        columns += c->strips.v[i].columns;
    }
    return wanted_mm > 0 ? wanted_mm / MM_PER_INCH * c->dpi : sum / columns;
}

static int pooled_paper(const capture *c)
{
    double sum = 0, columns = 0;
    for (size_t i = 0; i < c->strips.n; i++) {
        sum += (double)c->strips.v[i].paper * c->strips.v[i].columns;
        columns += c->strips.v[i].columns;
    }
    return (int)floor(sum / columns + 0.5);
}

static double fixed(double value, double unit)
{
    return floor(value * unit + 0.5) / unit;
}

/* Computes the median over the modes of all lines: a single line that slips does not tell. */
static bool pool_hand(const capture *c, profile *p, error *err)
{
    ARRAY(double) all = {0};
    bool good = true;
    for (size_t i = 0; i < c->strips.n; i++)
        for (int k = 0; k < c->strips.v[i].strays && good; k++)
            good = array_push(&all, c->strips.v[i].stray[k]);
    if (good && all.n >= MIN_STRAYS) {
        qsort(all.v, all.n, sizeof *all.v, plb_compare_doubles);
        p->hand = clamp(fixed(all.v[all.n / 2], FORMAT_MILLI), 1 / FORMAT_MILLI, FORMAT_MAX_HAND);
    }
    array_free(&all);
    return good || plb_fail_memory(err);
}

/* Rounds to the steps of the file format: what is captured is what will be loaded. */
static void quantise(profile *p)
{
    p->width_half = fixed(p->width_half, FORMAT_MILLI);
    p->width_tenth = fixed(p->width_tenth, FORMAT_MILLI);
    for (int k = 0; k < PROFILE_SECTION_BINS; k++) {
        p->section_mean[k] = fixed(p->section_mean[k], FORMAT_GREY);
        p->section_sd[k] = fixed(p->section_sd[k], FORMAT_GREY);
    }
}

static void set_bounds(profile *p)
{
    p->min_mid = plb_histogram_percentile(p->mid, PROFILE_GREYS - 1, LOW);
    p->max_mid = plb_histogram_percentile(p->mid, PROFILE_GREYS - 1, HIGH);
    p->min_range = plb_histogram_percentile(p->range, PROFILE_GREYS - 1, LOW);
    p->max_range = plb_histogram_percentile(p->range, PROFILE_GREYS - 1, HIGH);
    /* The middle is part of the line; percentiles of a short line may say otherwise. */
    p->max_range = p->max_range > p->max_mid ? p->max_range : p->max_mid;
    p->min_range = p->min_range < p->max_mid ? p->min_range : p->max_mid;
}

static bool pool(const capture *c, profile *p, error *err)
{
    for (size_t i = 0; i < c->strips.n; i++)
        count_greys(&c->strips.v[i], p);
    /* Every column has at most SCAN_MAX_SIDE pixels of line; the matrix counts the most. */
    uint64_t pairs = 0;
    for (size_t i = 0; i < PROFILE_GREYS * PROFILE_GREYS; i++)
        pairs += p->ccm[i];
    if (pairs > FORMAT_MAX_COUNT)
        return plb_fail(err, ERROR_LIMIT, "too many scans for one profile");
    set_bounds(p);
    pool_section(c, pooled_width(c, c->options->width), p);
    p->lines = (int)c->strips.n;
    p->dpi = c->dpi;
    p->paper = pooled_paper(c);
    quantise(p);
    if (pairs == 0 || p->min_mid < 0 || p->min_range < 0 || p->width_half <= 0 || p->width_tenth < p->width_half)
        return plb_fail(err, ERROR_ARGUMENT, "the lines are too faint or too wide to be measured");
    return true;
}

/* ---- the whole ---- */

static bool check_options(const capture_options *o, error *err)
{
    size_t name = strlen(o->name), text = strlen(o->provenance);
    if (name == 0 || name >= PROFILE_NAME_SIZE || !plb_text_is_clean(o->name, name, false))
        return plb_fail(err, ERROR_ARGUMENT, "a pencil's name is 1 to %d bytes of UTF-8 without control characters", PROFILE_NAME_SIZE - 1);
    if (text > FORMAT_MAX_TEXT || !plb_text_is_clean(o->provenance, text, true))
        return plb_fail(err, ERROR_ARGUMENT, "a provenance is at most %u bytes of UTF-8 without control characters", FORMAT_MAX_TEXT);
    if (o->centre_min < 0 || o->centre_max > 255 || o->centre_min > o->centre_max)
        return plb_fail(err, ERROR_ARGUMENT, "the range of the centre, %d to %d, is not within 0 to 255", o->centre_min, o->centre_max);
    if (o->width != 0 && !(o->width >= MIN_WIDTH && o->width <= MAX_WIDTH))
        return plb_fail(err, ERROR_ARGUMENT, "a width of %g mm is not between %g and %g", o->width, MIN_WIDTH, MAX_WIDTH);
    return true;
}

static bool capture_grain(const capture *c, profile *p, error *err)
{
    bool as_scanned = has_grain_resolution(c);
    const capture_options *o = c->options;
    bool good = plb_grain_capture(as_scanned ? c->strips.v : c->reduced.v, as_scanned ? c->strips.n : c->reduced.n, &p->grain, err);
    if (good && p->grain.present && o->sample)
        good = plb_grain_refine(p, o->sample, o->closure, err);
    if (good && p->grain.present && o->width > 0)
        p->grain.line_mean[1] = (float)log(o->width / MM_PER_INCH * PAPER_PX_PER_INCH);
    if (good && o->grain)
        plb_grain_borrow(&p->grain, o->grain);
    return good;
}

static profile *make_profile(const capture *c, error *err)
{
    const capture_options *o = c->options;
    profile *p = plb_new(1, sizeof *p);
    if (p) {
        p->ccm = plb_new(PROFILE_GREYS * PROFILE_GREYS, sizeof *p->ccm);
        p->provenance = plb_new(strlen(o->provenance) + 1, 1);
    }
    bool there = p && p->ccm && p->provenance;
    if (!there)
        plb_fail_memory(err);
    if (!there || !pool(c, p, err) || !(o->free_hand || pool_hand(c, p, err)) || !capture_grain(c, p, err)) {
        plb_profile_release(p);
        return NULL;
    }
    memcpy(p->name, o->name, strlen(o->name));
    memcpy(p->provenance, o->provenance, strlen(o->provenance));
    return p;
}

profile *plb_capture(const char *const files[], size_t n, const capture_options *options, error *err)
{
    capture c = {.options = options};
    profile *p = NULL;
    bool good = check_options(options, err);
    for (size_t i = 0; i < n && good; i++)
        good = add_scan(&c, files[i], err);
    if (good && c.strips.n == 0)
        good = plb_fail(err, ERROR_ARGUMENT, "no usable line in %zu scan%s", n, n == 1 ? "" : "s");
    if (good)
        p = make_profile(&c, err);
    for (size_t i = 0; i < c.strips.n; i++)
        plb_line_strip_free(&c.strips.v[i]);
    for (size_t i = 0; i < c.reduced.n; i++)
        plb_line_strip_free(&c.reduced.v[i]);
    array_free(&c.strips);
    array_free(&c.reduced);
    return p;
}
