/* SPDX-License-Identifier: MIT
 *
 * The grain: captured from strips made here, whose statistics are known beforehand; and its section of the file.
 */
#include "check.h"

#include "base/array.h"
#include "base/number/random.h"
#include "profile/file/format.h"
#include "profile/capture/line_straighten.h"
#include "profile/grain/grain.h"
#include "base/number/normal.h"
#include "profile/grain/grain_math.h"

/* ---- strips made here ---- */

#define REACH 17
#define ROWS (2 * REACH + 1)

/* Roughly normal: the sum of four uniform numbers. */
static double normal(uint64_t stream, uint64_t i)
{
    double sum = -2;
    for (uint64_t k = 0; k < 4; k++)
        sum += random_unit(random_mix(stream), 4 * i + k);
    return sum * sqrt(3);
}

typedef struct {
    int n;
    double depth, width, grain; /* greys, px, relative */
    double high, low;           /* correlation along in turns of 1 column */
    double across;              /* share of the grain that the next row has too */
    double flank;               /* correlation along beyond half the width, more than that within */
    uint64_t stream;
} wanted;

static line_strip make_strip(wanted w)
{
    line_strip s = {.n = w.n, .reach = REACH, .columns = w.n};
    s.dark = plb_new((size_t)w.n, ROWS * sizeof *s.dark);
    s.offset = plb_new((size_t)w.n, sizeof *s.offset);
    s.cosine = plb_new((size_t)w.n, sizeof *s.cosine);
    s.usable = plb_new((size_t)w.n, sizeof *s.usable);
    double z[ROWS] = {0};
    for (int k = 0; k < w.n; k++) {
        s.offset[k] = 0.45 * sin(k / 40.0);
        s.cosine[k] = 1;
        s.usable[k] = true;
        double a = k % 2 ? w.high : w.low, share = sqrt(w.across), rest = sqrt(1 - w.across);
        for (int o = 0; o < ROWS; o++) {
            uint64_t i = (uint64_t)k * (ROWS + 1) + (uint64_t)o;
            double e = share * normal(w.stream, i) + rest * normal(w.stream, i + 1);
            double own = a + (abs(o - REACH) > w.width / 2 ? w.flank : 0);
            z[o] = own * z[o] + sqrt(1 - own * own) * e;
            double shape = 1 / (1 + exp((fabs(o - REACH - s.offset[k]) - w.width / 2) / 0.4));
            s.dark[k * ROWS + o] = (float)clamp(w.depth * shape * (1 + w.grain * z[o]), 0, 255);
            if (abs(o - REACH) > 8 || s.dark[k * ROWS + o] < 5)
                s.dark[k * ROWS + o] = 0;
        }
    }
    return s;
}

static grain_model capture(const wanted lines[], size_t n)
{
    line_strip strips[8] = {0};
    grain_model g;
    error err = {0};
    for (size_t i = 0; i < n; i++)
        strips[i] = make_strip(lines[i]);
    CHECK(plb_grain_capture(strips, n, &g, &err));
    for (size_t i = 0; i < n; i++)
        plb_line_strip_free(&strips[i]);
    return g;
}

/* ---- mathematics ---- */

static void eigenvectors(void)
{
    double a[9] = {4, 1, 0.5, 1, 3, -1, 0.5, -1, 2}, v[9], m[9];
    memcpy(m, a, sizeof a);
    plb_eigen(m, v, 3);
    for (int i = 0; i < 3; i++)
        for (int r = 0; r < 3; r++) {
            double x = 0;
            for (int k = 0; k < 3; k++)
                x += a[r * 3 + k] * v[k * 3 + i];
            CHECK_RANGE(x - m[i * 4] * v[r * 3 + i], -1e-10, 1e-10);
        }
    CHECK_RANGE(m[0] + m[4] + m[8], 9 - 1e-10, 9 + 1e-10);
}

/* A matrix of rank two: the factor gives it back. */
static void factor_of_low_rank(void)
{
    const double u[4] = {1, 2, 0, -1}, v[4] = {0.5, 1, 0, 3};
    double a[16], l[16];
    for (int i = 0; i < 16; i++)
        a[i] = u[i / 4] * u[i % 4] + v[i / 4] * v[i % 4];
    plb_semi_cholesky(a, l, 4);
    for (int i = 0; i < 16; i++) {
        double x = 0;
        for (int k = 0; k < 4; k++)
            x += l[i / 4 * 4 + k] * l[i % 4 * 4 + k];
        CHECK_RANGE(x - a[i], -1e-9, 1e-9);
        CHECK(i % 4 <= i / 4 || l[i] == 0);
    }
}

static void linear_equations(void)
{
    double a[4] = {4, 1, 1, 3}, b[2] = {1, 2}, singular[4] = {1, 1, 1, 1}, c[2] = {1, 1};
    CHECK(plb_solve(a, b, 2));
    CHECK_RANGE(b[0], 1 / 11.0 - 1e-12, 1 / 11.0 + 1e-12);
    CHECK_RANGE(b[1], 7 / 11.0 - 1e-12, 7 / 11.0 + 1e-12);
    CHECK(!plb_solve(singular, c, 2));
}

/* The normal distribution function has its published values. */
static void normal_distribution(void)
{
    CHECK_RANGE(plb_normal_share(0), 0.5, 0.5);
    CHECK_RANGE(plb_normal_share(1.959963984540054), 0.975 - 1e-12, 0.975 + 1e-12);
    CHECK_RANGE(plb_normal_share(-3), 0.0013498980316301 - 1e-12, 0.0013498980316301 + 1e-12);
}

/* ---- the chain and the filter ---- */

/* With one coefficient the chain is an autoregression: innovations correlated at lags e and -e give a^|d - e| + a^(d + e). */
static void response_of_a_constant_chain(void)
{
    grain_model g = {.chain_high = 0.4f, .chain_low = 0.4f, .chain_share = 0.42f};
    double response[GRAIN_LAGS][GRAIN_LAGS];
    plb_grain_chain_response(&g, response);
    for (int d = 0; d < GRAIN_LAGS; d++)
        for (int e = 0; e < GRAIN_LAGS; e++) {
            double want = pow(0.4, abs(d - e)) + (e ? pow(0.4, d + e) : 0);
            CHECK_RANGE(response[d][e] - want, -1e-3, 1e-3);
        }
}

/* Covariance of what the filter makes of white noise, so far apart. */
static double filtered(const float h[GRAIN_TAPS][GRAIN_TAPS], int a, int c)
{
    double sum = 0;
    for (int i = 0; i + a < GRAIN_TAPS; i++)
        for (int j = 0; j + c < GRAIN_TAPS; j++)
            sum += (double)h[i][j] * h[i + a][j + c];
    return sum;
}

/* Chain and filter together make the correlations that were asked for. */
static void chain_and_filter_make_the_correlation(void)
{
    grain_moments m = {.correlation = {{1, 0.3, 0.09}, {0.4, 0.12, 0.036}, {0.16, 0.05, 0.015}, {0.064, 0.02, 0.006}, {0.026, 0.01, 0}}};
    grain_model g = {0};
    plb_grain_chain(&m, &g);
    CHECK(g.chain_high == g.chain_low); /* nothing steps in common */
    plb_grain_filter(&m, &g);
    double response[GRAIN_LAGS][GRAIN_LAGS];
    plb_grain_chain_response(&g, response);
    for (int class = 0; class < GRAIN_CLASSES; class++) {
        double along = 0, across = 0;
        for (int e = 0; e < GRAIN_LAGS; e++) {
            along += response[1][e] * filtered((const float(*)[GRAIN_TAPS])g.filter[class], e, 0);
            across += response[0][e] * filtered((const float(*)[GRAIN_TAPS])g.filter[class], e, 1);
        }
        CHECK_RANGE(along, 0.34, 0.46);
        CHECK_RANGE(across - class * 0.1, class > 5 ? -0.08 : -0.05, 0.05); /* five taps do not reach farther */
    }
}

/* ---- captured lines ---- */

static void figures_of_a_known_line(void)
{
    wanted w = {.n = 6000, .depth = 90, .width = 6, .grain = 0.2, .high = 0.5, .low = 0.5, .stream = 1};
    grain_model g = capture(&w, 1);
    CHECK(g.present && plb_grain_is_sound(&g));
    CHECK_RANGE(exp((double)g.line_mean[0]), 86, 91);
    CHECK_RANGE(g.reference_width, 5.8, 6.2);
    CHECK_RANGE(exp((double)g.line_mean[1]) / g.reference_width, 0.999, 1.001);
    CHECK_RANGE(g.line_mean[2], -0.1, 0.1); /* the scores are normal */
    CHECK_RANGE(g.line_mean[3], 0.44, 0.52); /* 0.5, less what the slow modes take (about 0.07), times the gain of 1.1 */
    CHECK_RANGE(g.line_mean[4], -0.05, 0.05);
    CHECK_RANGE(g.chain_high - g.chain_low, 0, 0.35);
    CHECK_RANGE(g.volatility, 0, 0.15);
    CHECK_RANGE(g.section[2], 0.97, 1.05);
    CHECK_RANGE(g.section[28], 0, 0.02);
    /* The middle quantile of an expected darkness is that darkness, the outer ones a grain away. */
    CHECK_RANGE(g.darkness[20][16], 0.97, 1.03);
    CHECK_RANGE((g.darkness[20][16 + 5] - g.darkness[20][16 - 5]) / (2 * 5 * 6.0 / 32), 0.15, 0.23);
    for (int i = 0; i < GRAIN_LINE * GRAIN_LINE; i++)
        CHECK(g.line_factor[i / GRAIN_LINE][i % GRAIN_LINE] == 0); /* one line tells nothing of others */
}

static void smooth_and_broken_columns(void)
{
    wanted w = {.n = 8000, .depth = 90, .width = 7, .grain = 0.2, .high = 0.85, .low = 0, .stream = 2};
    grain_model g = capture(&w, 1);
    CHECK(g.present);
    CHECK_RANGE(g.chain_high, 0.65, 0.93);
    CHECK_RANGE(g.chain_low, -0.1, 0.35);
    CHECK_RANGE(g.chain_correlation, -0.73, -0.3); /* they alternate */
}

/* Makes rows that share half their innovations with the next one. */
static void rows_that_go_together(void)
{
    wanted w = {.n = 6000, .depth = 90, .width = 7, .grain = 0.2, .high = 0.3, .low = 0.3, .across = 0.5, .stream = 3};
    grain_model g = capture(&w, 1);
    CHECK(g.present);
    CHECK_RANGE(g.line_mean[4], 0.42, 0.6);
}

static void lines_that_differ(void)
{
    wanted w[2] = {{.n = 1000, .depth = 80, .width = 6, .grain = 0.1, .high = 0.3, .low = 0.3, .stream = 4},
                   {.n = 1000, .depth = 80 * exp(0.2), .width = 6, .grain = 0.1, .high = 0.3, .low = 0.3, .stream = 5}};
    grain_model g = capture(w, 2);
    CHECK(g.present);
    CHECK_RANGE(exp((double)g.line_mean[0]), 85, 90);
    CHECK_RANGE(g.line_factor[0][0], 0.19, 0.21); /* 0.2 / sqrt 2, and two lines tell so little that it is widened by as much again */
    CHECK_RANGE(fabs((double)g.line_factor[1][0]), 0, 0.02);
}

/* Eight lines: their variance, times (1 + 1/8) and that of Student's t of seven degrees, 7 / 5. */
static void the_spread_that_few_lines_tell(void)
{
    wanted w[8];
    for (int i = 0; i < 8; i++)
        w[i] = (wanted){.n = 1000, .depth = 80 * exp(i % 2 ? 0.1 : -0.1), .width = 6, .grain = 0.1, .high = 0.3, .low = 0.3, .stream = 40 + (unsigned)i};
    grain_model g = capture(w, 8);
    CHECK(g.present);
    CHECK_RANGE(g.line_factor[0][0], 0.94 * 0.1 * sqrt(8.0 / 7 * 1.125 * 1.4), 1.06 * 0.1 * sqrt(8.0 / 7 * 1.125 * 1.4));
}

/* Flanks that run on more smoothly than the core, and the other way round; half of their pixels show nothing. */
static void places_that_differ(void)
{
    for (int turn = 0; turn < 2; turn++) {
        wanted w = {.n = 8000, .depth = 90, .width = 8, .grain = 0.6, .high = 0.4, .low = 0.4, .stream = 30, .flank = turn ? 0.3 : -0.3};
        grain_model g = capture(&w, 1);
        CHECK(g.present);
        CHECK_RANGE(g.place_along[2] * w.flank, -0.02, 0.02);
        CHECK_RANGE(g.place_along[10] / w.flank, 0.6, 1.3); /* 5.25 px out: expected darkness .04 */
        for (int k = 0; k < 10; k++)
            CHECK_RANGE(g.place_across[k], -0.1, 0.1);
    }
}

/* ---- the correction ---- */

typedef struct {
    double width, depth; /* of the lines drawn, as shares of the profile's */
    int calls;
} sampling;

/* Makes lines without grain that are wider or paler than the profile's. */
static bool sample(void *closure, const profile *p, int lines, int width, int height, uint8_t *grey, error *err)
{
    sampling *how = closure;
    (void)err;
    how->calls++;
    double half = exp((double)p->grain.line_mean[1]) * how->width / 2, depth = exp((double)p->grain.line_mean[0]) * how->depth;
    for (int i = 0; i < lines; i++)
        for (int y = 0; y < height; y++)
            for (int x = 40; x < width - 40; x++) {
                double off = fabs(y - height / 2 - (double)i / lines), dark = depth / (1 + exp((off - half) / 0.4));
                grey[((size_t)i * (size_t)height + (size_t)y) * (size_t)width + (size_t)x] = (uint8_t)(255 - dark + 0.5);
            }
    return true;
}

/* Where drawn lines come out too wide or too pale, the profile makes up for four fifths of that. */
static void corrected_by_what_is_drawn(void)
{
    wanted w = {.n = 3000, .depth = 90, .width = 6, .grain = 0.2, .high = 0.5, .low = 0.5, .stream = 31};
    profile *p[2];
    sampling how[2] = {{1, 1, 0}, {1.1, 0.9, 0}};
    for (int i = 0; i < 2; i++) {
        p[i] = plb_profile_read("HB", NULL);
        p[i]->grain = capture(&w, 1);
        CHECK(plb_grain_refine(p[i], sample, &how[i], NULL));
        CHECK(how[i].calls == 1 && plb_grain_is_sound(&p[i]->grain));
        for (int k = 0; k < GRAIN_LEVELS * (GRAIN_SCORES - 1); k++) {
            const float *row = p[i]->grain.darkness[k / (GRAIN_SCORES - 1)] + k % (GRAIN_SCORES - 1);
            CHECK(row[1] >= row[0]);
        }
    }
    CHECK_RANGE((double)(p[1]->grain.line_mean[1] - p[0]->grain.line_mean[1]) / log(1.1), -0.9, -0.75);
    CHECK_RANGE((double)(p[1]->grain.line_mean[0] - p[0]->grain.line_mean[0]) / log(0.9), -0.85, -0.75);
    plb_profile_release(p[0]);
    plb_profile_release(p[1]);
}

/* Little line, and lines without any grain: finite numbers, or none. */
static void little_to_go_by(void)
{
    wanted w = {.n = 299, .depth = 90, .width = 6, .grain = 0.2, .high = 0.5, .low = 0.5, .stream = 7};
    grain_model g = capture(&w, 1);
    CHECK(!g.present);
    CHECK(!capture(NULL, 0).present);
    static const wanted odd[] = {
        {.n = 300, .depth = 90, .width = 6, .grain = 0.2, .high = 0.5, .low = 0.5, .stream = 8},
        {.n = 300, .depth = 90, .width = 6},                 /* no grain at all */
        {.n = 300, .depth = 250, .width = 15, .grain = 1},   /* as wide as can be seen */
        {.n = 300, .depth = 12, .width = 1.5, .grain = 0.5}, /* hardly there */
        {.n = 300, .depth = 90, .width = 2, .grain = 3},     /* specks */
        {.n = 300, .depth = 90, .width = 6, .grain = 0.3, .high = 0.999, .low = 0.999}, /* level rows */
    };
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        g = capture(&odd[i], 1);
        CHECK(g.present && plb_grain_is_sound(&g));
    }
    g = capture(odd, 6);
    CHECK(g.present && plb_grain_is_sound(&g));
}

/* ---- the section of the file ---- */

typedef struct {
    unsigned char *v;
    size_t n;
} bytes;

static void seal(bytes *b)
{
    uint32_t crc = plb_crc32(b->v, b->n - 4);
    for (int i = 0; i < 4; i++)
        b->v[b->n - 4 + (size_t)i] = (unsigned char)(crc >> 8 * i);
}

/* HB without its matrix and text, so that the file is short, and where its GRAI starts: at its tag. */
static bytes pencil(size_t *grain_at)
{
    profile *p = plb_profile_read("HB", NULL);
    bytes b = {0};
    memset(p->ccm, 0, PROFILE_GREYS * PROFILE_GREYS * sizeof *p->ccm);
    p->ccm[0] = 1;
    p->provenance[0] = '\0';
    b.v = plb_profile_serialise(p, &b.n, NULL);
    for (*grain_at = 0; *grain_at + 4 < b.n && memcmp(b.v + *grain_at, "GRAI", 4) != 0; ++*grain_at)
        ;
    plb_profile_release(p);
    return b;
}

#define GRAIN_SIZE 6642
#define FIRST_FLOAT (8 + GRAIN_MODES)

/* Whether the file is a profile; when it is, its grain has to be sound. */
static bool loads(const bytes *b)
{
    error err = {0};
    profile *p = plb_profile_parse("x", b->v, b->n, &err);
    CHECK(p ? p->grain.present && plb_grain_is_sound(&p->grain) : strstr(err.text, "GRAI") != NULL);
    plb_profile_release(p);
    return p != NULL;
}

static void the_eight_have_it(void)
{
    for (size_t i = 0; plb_profile_grade(i); i++) {
        profile *p = plb_profile_read(plb_profile_grade(i), NULL), *q = NULL;
        CHECK(p && p->grain.present && plb_grain_is_sound(&p->grain));
        size_t n = 0;
        unsigned char *data = p ? plb_profile_serialise(p, &n, NULL) : NULL;
        CHECK(data && (q = plb_profile_parse("x", data, n, NULL)));
        if (p && q) {
            for (size_t f = 0; f < GRAIN_FIELDS; f++) {
                const grain_field *field = &plb_grain_fields[f];
                CHECK(!memcmp((char *)&p->grain + field->offset, (char *)&q->grain + field->offset, field->count * sizeof(float)));
            }
            CHECK(!memcmp(p->grain.mode_is_odd, q->grain.mode_is_odd, sizeof p->grain.mode_is_odd));
            CHECK_RANGE(exp((double)p->grain.line_mean[1]) / p->width_half, 0.99, 1.01); /* all are at 300 dpi */
        }
        plb_free(data);
        plb_profile_release(p);
        plb_profile_release(q);
    }
}

/* A profile of version 1.0 has none. */
static void a_profile_without_it(void)
{
    profile *p = plb_profile_read("HB", NULL);
    size_t n;
    p->grain.present = false;
    unsigned char *data = plb_profile_serialise(p, &n, NULL);
    profile *q = plb_profile_parse("x", data, n, NULL);
    CHECK(q && !q->grain.present && q->grain.section[0] == 0);
    plb_free(data);
    plb_profile_release(p);
    plb_profile_release(q);
}

/* Where the grain has a size that an earlier version wrote, the message says what to do. */
static void grain_of_another_version(void)
{
    size_t at;
    bytes b = pencil(&at);
    error err = {0};
    CHECK(b.v[at + 4] == (GRAIN_SIZE & 255) && b.v[at + 5] == GRAIN_SIZE >> 8);
    b.v[at + 4] = (unsigned char)(b.v[at + 4] - 4); /* one number fewer; nobody gets to what follows */
    seal(&b);
    CHECK(!plb_profile_parse("x", b.v, b.n, &err) && err.kind == ERROR_UNSUPPORTED && strstr(err.text, "capture it again"));
    plb_free(b.v);
}

static void flipped_bits(void)
{
    size_t at;
    bytes b = pencil(&at);
    int refused = 0, passed = 0;
    CHECK(loads(&b));
    for (size_t i = at + 8; i < at + 8 + GRAIN_SIZE; i++)
        for (int bit = (int)(i % 4); bit < 8; bit += 4) {
            b.v[i] ^= (unsigned char)(1 << bit);
            seal(&b);
            loads(&b) ? passed++ : refused++;
            b.v[i] ^= (unsigned char)(1 << bit);
        }
    CHECK_RANGE(passed, 1000, 1e9);
    CHECK_RANGE(refused, 1000, 1e9);
    plb_free(b.v);
}

/* Every number on its own: not a number, infinite, beyond its bounds. */
static void numbers_out_of_bounds(void)
{
    size_t at, place;
    bytes b = pencil(&at);
    place = at + FIRST_FLOAT;
    for (size_t f = 0; f < GRAIN_FIELDS; f++)
        for (size_t i = 0; i < plb_grain_fields[f].count; i++, place += 4) {
            const float bad[] = {NAN, INFINITY, -INFINITY, plb_grain_fields[f].high * 1.001f + 0.001f, plb_grain_fields[f].low - 0.001f};
            float good;
            memcpy(&good, b.v + place, 4);
            for (size_t k = i % 5; k < 5; k += i < 8 ? 1 : 5) {
                memcpy(b.v + place, &bad[k], 4); /* little-endian machines only, as are the tests' */
                seal(&b);
                CHECK(!loads(&b));
            }
            memcpy(b.v + place, &good, 4);
        }
    CHECK(place == at + 8 + GRAIN_SIZE);
    b.v[at + 8] = 2; /* neither odd nor even */
    seal(&b);
    CHECK(!loads(&b));
    plb_free(b.v);
}

/* Numbers within their bounds that do not fit together are refused. */
static void numbers_that_do_not_fit(void)
{
    profile *p = plb_profile_read("HB", NULL);
    grain_model g = p->grain;
    g.chain_correlation = -1; /* a share of 0.42 cannot alternate with 0.58 */
    CHECK(!plb_grain_is_sound(&g));
    g = p->grain;
    memset(g.filter[2], 0, sizeof g.filter[2]);
    CHECK(!plb_grain_is_sound(&g));
    plb_profile_release(p);
}

/* A section that claims to be shorter or longer than it is, is refused. */
static void wrong_lengths(void)
{
    size_t at;
    bytes b = pencil(&at);
    for (size_t cut = 1; cut <= GRAIN_SIZE; cut += cut < 8 ? 1 : 97) {
        bytes s = {malloc(b.n - cut), b.n - cut};
        size_t keep = at + 8 + GRAIN_SIZE - cut;
        memcpy(s.v, b.v, keep);
        memcpy(s.v + keep, b.v + at + 8 + GRAIN_SIZE, s.n - keep);
        for (int i = 0; i < 4; i++) {
            s.v[12 + i] = (unsigned char)(s.n >> 8 * i);
            s.v[at + 4 + (size_t)i] = (unsigned char)((GRAIN_SIZE - cut) >> 8 * i);
        }
        seal(&s);
        CHECK(!loads(&s));
        free(s.v);
    }
    plb_free(b.v);
}

int main(void)
{
    RUN(eigenvectors);
    RUN(factor_of_low_rank);
    RUN(linear_equations);
    RUN(normal_distribution);
    RUN(response_of_a_constant_chain);
    RUN(chain_and_filter_make_the_correlation);
    RUN(figures_of_a_known_line);
    RUN(smooth_and_broken_columns);
    RUN(rows_that_go_together);
    RUN(lines_that_differ);
    RUN(the_spread_that_few_lines_tell);
    RUN(places_that_differ);
    RUN(corrected_by_what_is_drawn);
    RUN(little_to_go_by);
    RUN(the_eight_have_it);
    RUN(a_profile_without_it);
    RUN(grain_of_another_version);
    RUN(flipped_bits);
    RUN(numbers_out_of_bounds);
    RUN(numbers_that_do_not_fit);
    RUN(wrong_lengths);
    CHECK_EXIT;
}
