/* SPDX-License-Identifier: MIT
 *
 * A profile as text, and how two profiles differ. Numbers are printed without the locale.
 */
#include "profile/histogram.h"
#include "profile/profile.h"

#include "base/number/units.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#define ACE_LEVELS 32       /* grey levels of the co-occurrence error: enough counts in every cell */
#define SECTION_SHOWN 0.05  /* the section is listed out to this share of its depth */
#define LABEL_WIDTH 26

/* `value` with exactly `decimals` digits after the point, so that columns align; in any locale. Writes to `out`. */
static const char *digits(char out[48], double value, int decimals)
{
    static const int64_t powers[] = {1, 10, 100, 1000, 10000};
    int64_t power = powers[decimals], n = llround(fabs(value) * (double)power);
    const char *sign = value < 0 && n ? "-" : "";
    if (decimals == 0)
        snprintf(out, 48, "%s%" PRId64, sign, n);
    else
        snprintf(out, 48, "%s%" PRId64 ".%0*" PRId64, sign, n / power, decimals, n % power);
    return out;
}

static void label(FILE *to, const char *text)
{
    fprintf(to, "%-*s", LABEL_WIDTH, text);
}

static void line_number(FILE *to, const char *text, double value, int decimals, const char *unit)
{
    char number[48];
    label(to, text);
    fprintf(to, "%s %s\n", digits(number, value, decimals), unit);
}

static double mm(const profile *p, double px)
{
    return px / p->dpi * MM_PER_INCH;
}

static void line_width(FILE *to, const char *text, const profile *p, double px)
{
    char a[48], b[48];
    label(to, text);
    fprintf(to, "%s mm (%s px)\n", digits(a, mm(p, px), 3), digits(b, px, 2));
}

/* Prints percentiles of a histogram, without white. */
static void line_histogram(FILE *to, const char *text, const uint32_t counts[PROFILE_GREYS])
{
    static const double shares[] = {0.01, 0.10, 0.50, 0.90, 0.99};
    char sd[48];
    label(to, text);
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++)
        fprintf(to, "%3d ", plb_histogram_percentile(counts, PROFILE_GREYS - 1, shares[i]));
    fprintf(to, "%6s  %" PRIu64 "\n", digits(sd, plb_histogram_sd(counts, PROFILE_GREYS - 1), 1),
            plb_histogram_total(counts, PROFILE_GREYS - 1));
}

typedef struct {
    uint64_t cells, pairs;
    double correlation, step;
} ccm_figures;

static ccm_figures figures_of_ccm(const uint32_t *ccm)
{
    ccm_figures f = {0};
    double si = 0, sj = 0, sii = 0, sjj = 0, sij = 0, n = 0, step = 0;
    for (int i = 0; i < PROFILE_GREYS; i++)
        for (int j = 0; j < PROFILE_GREYS; j++) {
            double c = ccm[i * PROFILE_GREYS + j];
            f.cells += c > 0;
            n += c;
            si += c * i;
            sj += c * j;
            sii += c * i * i;
            sjj += c * j * j;
            sij += c * i * j;
            step += c * (i > j ? i - j : j - i);
        }
    if (n == 0)
        return f;
    double vi = sii / n - si / n * si / n, vj = sjj / n - sj / n * sj / n;
    f.pairs = (uint64_t)n;
    f.step = step / n;
    f.correlation = vi > 0 && vj > 0 ? (sij / n - si / n * sj / n) / sqrt(vi * vj) : 0;
    return f;
}

static void print_section(FILE *to, const profile *p)
{
    char d[48], mean[48], sd[48];
    double least = 255;
    for (int k = 0; k < PROFILE_SECTION_BINS; k++)
        least = fmin(least, p->section_mean[k]);
    fprintf(to, "\ncross-section: distance from the centreline, mean grey, standard deviation\n");
    for (int k = 0; k < PROFILE_SECTION_BINS; k += 2) {
        double grey = (p->section_mean[k] + p->section_mean[k + 1]) / 2;
        if (255 - grey < SECTION_SHOWN * (255 - least))
            break;
        fprintf(to, "  %6s mm  %6s  %5s\n", digits(d, mm(p, (k + 1) * PROFILE_SECTION_STEP), 3),
                digits(mean, grey, 1), digits(sd, (p->section_sd[k] + p->section_sd[k + 1]) / 2, 1));
    }
}

/* Gives the standard deviation of figure `i` of a line. */
static double line_sd(const grain_model *g, int i)
{
    double variance = 0;
    for (int k = 0; k < GRAIN_LINE; k++)
        variance += (double)g->line_factor[i][k] * g->line_factor[i][k];
    return sqrt(variance);
}

static void line_spread(FILE *to, const char *text, double mean, int decimals, const char *unit, double sd)
{
    char a[48], b[48];
    label(to, text);
    fprintf(to, "%s %s, standard deviation between lines %s\n", digits(a, mean, decimals), unit, digits(b, sd, 2));
}

static void print_grain(FILE *to, const grain_model *g)
{
    char high[48], low[48];
    label(to, "grain");
    fprintf(to, "%s\n", g->present ? "at 300 dpi; spreads of depth, width, roughness are of their logarithms" : "not measured");
    if (!g->present)
        return;
    line_spread(to, "  depth", exp((double)g->line_mean[0]), 1, "grey levels", line_sd(g, 0));
    line_spread(to, "  width of a line", exp((double)g->line_mean[1]), 2, "px at half depth", line_sd(g, 1));
    line_spread(to, "  roughness", exp((double)g->line_mean[2]), 3, "times the mean", line_sd(g, 2));
    line_spread(to, "  correlation along", g->line_mean[3], 3, "with the next pixel", line_sd(g, 3));
    line_spread(to, "  correlation across", g->line_mean[4], 3, "with the next pixel", line_sd(g, 4));
    label(to, "  smooth and broken");
    fprintf(to, "coefficient along %s or %s\n", digits(high, g->chain_high, 3), digits(low, g->chain_low, 3));
}

static void print_hand(FILE *to, const profile *p)
{
    if (p->hand > 0)
        line_number(to, "hand", p->hand, 3, "times as far from the chord as a free hand");
    else {
        label(to, "hand");
        fprintf(to, "a free one\n");
    }
}

bool plb_profile_print(const profile *p, FILE *to)
{
    ccm_figures f = figures_of_ccm(p->ccm);
    uint64_t bare = p->mid[PROFILE_GREYS - 1], centre = plb_histogram_total(p->mid, PROFILE_GREYS);
    label(to, "pencil");
    fprintf(to, "%s\n", p->name);
    label(to, "measured on");
    fprintf(to, "%d line%s, %" PRIu64 " px of line\n", p->lines, p->lines == 1 ? "" : "s", p->pixels);
    line_number(to, "resolution", p->dpi, fmod(p->dpi, 1) == 0 ? 0 : 3, "dpi");
    line_number(to, "paper", p->paper, 0, "of 255 in the scans; below it is 255");
    line_width(to, "width at half depth", p, p->width_half);
    line_width(to, "width at a tenth of depth", p, p->width_tenth);
    line_number(to, "centre", plb_profile_centre(p), 0, "grey, median");
    line_number(to, "bare paper at the centre", 100.0 * (double)bare / (double)centre, 1, "%");
    label(to, "bounds");
    fprintf(to, "centre %d to %d, whole line %d to %d\n", p->min_mid, p->max_mid, p->min_range, p->max_range);
    label(to, "co-occurrence");
    fprintf(to, "%" PRIu64 " pairs in %" PRIu64 " cells of 65536\n", f.pairs, f.cells);
    line_number(to, "  correlation", f.correlation, 3, "of a pixel and the next along the line");
    line_number(to, "  mean step", f.step, 1, "grey levels");
    print_grain(to, &p->grain);
    print_hand(to, p);
    fprintf(to, "\ngrey, white left out        1%% 10%% 50%% 90%% 99%%     sd  pixels\n");
    line_histogram(to, "  centre", p->mid);
    line_histogram(to, "  whole line", p->range);
    print_section(to, p);
    if (p->provenance[0])
        fprintf(to, "\n%s%s", p->provenance, p->provenance[strlen(p->provenance) - 1] == '\n' ? "" : "\n");
    return !ferror(to);
}

/* ---- two profiles ---- */

/* Gives the earth mover's distance of two histograms: how many levels the greys of one have to move, on average, to give
 * the other. In one dimension it is the area between the cumulative distributions. */
static double earth_movers(const uint32_t a[PROFILE_GREYS], const uint32_t b[PROFILE_GREYS], int greys)
{
    double na = (double)plb_histogram_total(a, greys), nb = (double)plb_histogram_total(b, greys), ca = 0, cb = 0, area = 0;
    for (int g = 0; g < greys; g++) {
        ca += a[g] / na;
        cb += b[g] / nb;
        area += fabs(ca - cb);
    }
    return area;
}

/* Gives the grey of a section at a distance in mm. */
static double section_at(const profile *p, double distance)
{
    double bin = distance / MM_PER_INCH * p->dpi / PROFILE_SECTION_STEP - 0.5;
    if (bin <= 0)
        return p->section_mean[0];
    if (bin >= PROFILE_SECTION_BINS - 1)
        return 255;
    int k = (int)bin;
    return p->section_mean[k] + (p->section_mean[k + 1] - p->section_mean[k]) * (bin - k);
}

/* Gives the root mean square difference of the sections out to the edge of the wider line. */
static double section_difference(const profile *a, const profile *b)
{
    double end = fmax(mm(a, a->width_tenth), mm(b, b->width_tenth)) / 2, sum = 0;
    const int steps = 100;
    for (int i = 0; i < steps; i++) {
        double d = section_at(a, end * (i + 0.5) / steps) - section_at(b, end * (i + 0.5) / steps);
        sum += d * d;
    }
    return sqrt(sum / steps);
}

static void reduce_ccm(const uint32_t *ccm, double out[ACE_LEVELS * ACE_LEVELS])
{
    const int step = PROFILE_GREYS / ACE_LEVELS;
    double total = 0;
    for (int i = 0; i < ACE_LEVELS * ACE_LEVELS; i++)
        out[i] = 0;
    for (int i = 0; i < PROFILE_GREYS; i++)
        for (int j = 0; j < PROFILE_GREYS; j++) {
            out[i / step * ACE_LEVELS + j / step] += ccm[i * PROFILE_GREYS + j];
            total += ccm[i * PROFILE_GREYS + j];
        }
    for (int i = 0; i < ACE_LEVELS * ACE_LEVELS; i++)
        out[i] /= total;
}

/* Gives the average co-occurrence error (Copeland et al. 2001, thesis equation 2.7) for the one displacement of a profile. */
static double co_occurrence_error(const profile *a, const profile *b)
{
    double pa[ACE_LEVELS * ACE_LEVELS], pb[ACE_LEVELS * ACE_LEVELS], sum = 0;
    reduce_ccm(a->ccm, pa);
    reduce_ccm(b->ccm, pb);
    for (int i = 0; i < ACE_LEVELS * ACE_LEVELS; i++)
        sum += fabs(pa[i] - pb[i]);
    return sum;
}

/* Prints one line: name, figure of `a`, figure of `b`, difference, meaning. */
static void pair(FILE *to, const char *text, double a, double b, int decimals, const char *meaning)
{
    char x[48], y[48], d[48];
    fprintf(to, "%-22s %8s %8s %8s  %s\n", text, digits(x, a, decimals), digits(y, b, decimals),
            digits(d, b - a, decimals), meaning);
}

static void single(FILE *to, const char *text, double value, int decimals, const char *meaning)
{
    char d[48];
    fprintf(to, "%-22s %8s %8s %8s  %s\n", text, "", "", digits(d, value, decimals), meaning);
}

bool plb_profile_print_difference(const profile *a, const profile *b, FILE *to)
{
    ccm_figures fa = figures_of_ccm(a->ccm), fb = figures_of_ccm(b->ccm);
    int ra = plb_histogram_percentile(a->range, PROFILE_GREYS, 0.5), rb = plb_histogram_percentile(b->range, PROFILE_GREYS, 0.5);
    fprintf(to, "%-22s %8s %8s %8s\n", "", a->name, b->name, "differ");
    pair(to, "centre", plb_profile_centre(a), plb_profile_centre(b), 0, "median grey; more is lighter");
    pair(to, "whole line", ra, rb, 0, "median grey, white left out");
    pair(to, "width", mm(a, a->width_half), mm(b, b->width_half), 3, "mm at half depth");
    pair(to, "full width", mm(a, a->width_tenth), mm(b, b->width_tenth), 3, "mm at a tenth of depth");
    pair(to, "spread of the centre", plb_histogram_sd(a->mid, PROFILE_GREYS - 1), plb_histogram_sd(b->mid, PROFILE_GREYS - 1), 1, "standard deviation, grey levels");
    pair(to, "step along the line", fa.step, fb.step, 1, "mean difference of neighbours, grey levels");
    pair(to, "hand", a->hand > 0 ? a->hand : 1, b->hand > 0 ? b->hand : 1, 3, "times as far from the chord as a free hand");
    single(to, "centre histograms", earth_movers(a->mid, b->mid, PROFILE_GREYS), 2, "earth mover's distance, grey levels");
    single(to, "line histograms", earth_movers(a->range, b->range, PROFILE_GREYS), 2, "earth mover's distance, grey levels");
    single(to, "cross-sections", section_difference(a, b), 2, "root mean square, grey levels");
    single(to, "co-occurrence (ACE)", co_occurrence_error(a, b), 4, "0: the same, 2: nothing in common");
    return !ferror(to);
}
