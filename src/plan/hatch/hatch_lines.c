/* SPDX-License-Identifier: MIT
 *
 * One layer of hatching. Lines are set one after the other, as a hand sets them: each at about the same distance from
 * the one before, some closer, some farther, with a slow drift; begun and ended a little before or beyond the edge.
 *
 * The wrist makes short strokes, so a broad shape is filled in rows, one beside the other, and in a row patch by patch: a
 * patch is some ten strokes that lean together; then the hand moves on, and the next ones lean another way.
 *
 *     u ->   | row 0 ////// | row 1 ////// |
 *      v     |       \\\\\\ |       ////// |    rows meet at uneven borders, patches in one row are of different lengths
 */
#include "plan/hatch/hatch_lines.h"

#include "base/number/random.h"

#include <math.h>

/* A line strays from its place by the first, one standard deviation; the distance of lines drifts by the second over DRIFT_LINES lines: both as
 * shares of the distance of two lines (chosen by eye). */
#define SPACING_UNEVEN 0.09
#define SPACING_DRIFT 0.06
#define DRIFT_LINES 11
/* Strokes are so many spacings long, within bounds, mm. Strokes of real hatching are about five spacings long (measured on published
 * drawings); longer ones cost less time, and are seen as well in dark tones. A shape up to FREE_ROWS strokes long is one row (chosen by eye). */
#define STROKE_SPACINGS 20.0
#define STROKE_SHORTEST 10.0
#define STROKE_LONGEST 26.0
#define FREE_ROWS 1.8
/* A patch is so many lines, at least and at most. Patches lean by the first, radians, and their lines by the second, one standard
 * deviation, in long rows less; never by more than the third. (Real hatching: 8 to 15 strokes; directions of all strokes stray by 10 to 27 degrees,
 * outlines included.) */
#define PATCH_FEWEST 8
#define PATCH_MOST 15
#define PATCH_LEAN 0.075
#define LINE_LEAN 0.025
#define LEAN_LENGTH 20.0
#define LEAN_MOST 0.28
/* The border between rows wavers by this part of a row's length, and lines end beside it by the other, one standard deviation; they lap by
 * the last, mm (chosen by eye). */
#define BORDER_WAVER 0.25
#define BORDER_KNOTS 0.5 /* rows from one of the waver to the next */
#define BORDER_STRAY 0.07
#define BORDER_LAP 0.65
/* More rows are not worth their time: shapes of very many edges get fewer (chosen by measurement). */
#define MAX_ROWS 4000
#define MAX_ROW_EDGES 2e6
/* Ends stray about the edge by this, mm, one standard deviation, mostly inside; never by more than END_MAX, nor by more than
 * a part of a short line. */
#define LINE_END_STRAY 0.13
#define END_INSIDE 0.03
#define END_MAX 0.4
#define END_PART 0.18
/* One sweep of the forearm with the elbow at rest, mm: strokes are this long, at most and at least, and the next begins
 * where the last has not quite ended. */
#define SWEEP_LONGEST 55.0
#define SWEEP_SHORTEST 26.0
#define SWEEP_LAP 0.6
/* No line is shorter, mm. */
#define SHORTEST 0.3
/* Pressure strays by this from line to line, one standard deviation (strokes of real hatching differ in depth by .28 to .35). */
#define PRESSURE_STRAY 0.28
/* The most lines of a layer: beyond, they are set farther apart. */
#define MAX_LINES 20000

typedef struct {
    const hatch_layer *l;
    const marks *m;
    frame f;
    box page; /* in the frame */
    uint64_t key;
    uint64_t line; /* the number of the line at work */
    double length; /* of a row, along u */
    int row, rows;
    double first;  /* u where row 0 begins */
} hatching;

/* Each line has these random numbers; the name says what a number is for. */
enum { AT_PLACE, AT_TILT, AT_PRESSURE, AT_SWEEP, AT_RANK, AT_PATCH, AT_BORDER, AT_SPAN, PER_LINE = 4096 };
/* Lines of one row have numbers below this. */
#define ROW_LINES ((uint64_t)1 << 20)

/* Gives a number that is near enough normal, of standard deviation 1, within ±3.46. */
static double stray(uint64_t key, uint64_t index)
{
    double sum = 0;
    for (uint64_t k = 0; k < 4; k++)
        sum += random_unit(key, index * 4 + k);
    return (sum - 2) * sqrt(3);
}

static double within(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

static uint64_t number(const hatching *h, uint64_t what)
{
    return h->line * PER_LINE + (what < PER_LINE ? what : PER_LINE - 1);
}

/* Tells how far an end strays outward: inside on average. */
static double stray_of_end(const hatching *h, double length, uint64_t index)
{
    double most = fmin(END_MAX, END_PART * length);
    return within(stray(h->key, number(h, index)) * fmin(LINE_END_STRAY, most) - END_INSIDE, -most, most);
}

static point place(const hatching *h, const sections *k, double v, double tilt, double u)
{
    return frame_from(h->f, (point){u, plb_sections_v(k, v, tilt, u)});
}

/* Gives the share in [0, 1) of van der Corput's sequence at a line's number: evenly spread over any run of neighbours. */
static double evenly(uint64_t line)
{
    double share = 0, part = 0.5;
    for (uint64_t n = line; n && part > 1e-3; n >>= 1, part /= 2)
        share += n & 1 ? part : 0;
    return share;
}

/* Gives how much harder than the others the line at work is pressed. Neighbours differ, and few of them have the mean together: a hand evens out
 * the tone that it sees. */
static double press(const hatching *h, uint64_t index)
{
    double place = evenly(h->line + index) + random_unit(h->key, 2);
    return 1 + PRESSURE_STRAY * sqrt(12) * (place - floor(place) - 0.5);
}

static bool send_pressed(const hatching *h, const sections *k, double v, double tilt, span s, uint64_t index, double pressure)
{
    point a = place(h, k, v, tilt, s.from), b = place(h, k, v, tilt, s.to);
    return plb_mark_line(h->m, a, b, pressure * press(h, index));
}

static bool send(const hatching *h, const sections *k, double v, double tilt, double from, double to, uint64_t index)
{
    return send_pressed(h, k, v, tilt, (span){from, to}, index, h->l->pressure);
}

/* Cuts what is longer than a sweep into sweeps of uneven length, the first often short, so that no seam runs across. */
static bool send_sweeps(const hatching *h, const sections *k, double v, double tilt, span s, uint64_t index)
{
    uint64_t sweep = number(h, AT_SWEEP);
    double at = s.from;
    bool ok = true, first = true;
    while (ok && s.to - at > SWEEP_LONGEST) {
        double length = SWEEP_SHORTEST + (SWEEP_LONGEST - SWEEP_SHORTEST) * random_unit(h->key ^ sweep, index++);
        if (first)
            length *= 0.3 + 0.7 * random_unit(h->key ^ sweep, index++);
        ok = send(h, k, v, tilt, at, at + length + SWEEP_LAP / 2, index++);
        at += length - SWEEP_LAP / 2;
        first = false;
    }
    return ok && send(h, k, v, tilt, at, s.to, index);
}

/* ---- gradients ---- */

/* A line of a gradient is looked at this often, mm, and is a new stroke when the pressure has changed by a part. */
#define LOOK_MM 1.2
#define NEW_PRESSURE 0.13
#define SHORTEST_PART 2.5
#define MAX_TONE_LOOKS 4000
/* … in fields of cells so many times to the breadth of a cell, whose strokes overlap by so much where they change, mm. */
#define LOOKS_PER_CELL 3.0
#define CELL_LAP 0.1

/* Gives the rank of a line, evenly spread in [0, 1) over any run of neighbours (van der Corput's sequence), a little uneven: where
 * the tone asks for a share of the lines, those of a lower rank are drawn. */
static double rank_of(const hatching *h)
{
    return within(evenly(h->line) + 0.03 + 0.06 * stray(h->key, number(h, AT_RANK)), 0, 0.999);
}

/* Gives the pressure that the tone asks of this line at a place; 0 where it is not drawn. */
static double pressure_at(const hatching *h, point at, double rank)
{
    double darkness = plb_darkness_at(h->l->tone, at);
    if (darkness < MIN_DARKNESS)
        return 0;
    technique q = plb_technique_for(darkness, h->l->tone->is_soft, h->l->tone->options);
    double spacing = q.spacing[h->l->layer];
    return spacing > 0 && h->l->dense / spacing > rank ? q.pressure[h->l->layer] : 0;
}

/* Sends a part with its mean pressure. */
static bool send_part(const hatching *h, const sections *k, double v, double tilt, span s, uint64_t index, double sum, int looks)
{
    return looks == 0 || s.to - s.from < SHORTEST || send_pressed(h, k, v, tilt, s, index, sum / looks);
}

/* Follows the tone along the line. */
static bool send_varied(const hatching *h, const sections *k, double v, double tilt, span s, uint64_t index)
{
    double finest = h->l->finest, look = finest > 0 ? fmin(LOOK_MM, finest / LOOKS_PER_CELL) : LOOK_MM;
    double part = finest > 0 ? fmin(SHORTEST_PART, finest / 2) : SHORTEST_PART, lap = finest > 0 ? CELL_LAP : SWEEP_LAP;
    double rank = rank_of(h), looks = fmin(ceil((s.to - s.from) / look), MAX_TONE_LOOKS), step = (s.to - s.from) / looks;
    double from = s.from, sum = 0, first = 0;
    int n = 0;
    bool ok = true;
    for (int i = 0; ok && i < (int)looks; i++) {
        double u = s.from + i * step, p = pressure_at(h, place(h, k, v, tilt, u + step / 2), rank);
        bool changed = n && fabs(p - first) > NEW_PRESSURE * first && u - from > part;
        if (n && (!(p > 0) || changed || u - from > SWEEP_LONGEST)) {
            ok = send_part(h, k, v, tilt, (span){from, u + (p > 0 ? lap / 2 : 0)}, index++, sum, n);
            n = 0;
        }
        if (p > 0 && n++ == 0) {
            from = fmax(u - (i > 0 ? lap / 2 : 0), s.from);
            first = p;
            sum = 0;
        }
        sum += p;
    }
    return ok && send_part(h, k, v, tilt, (span){from, s.to}, index, sum, n);
}

/* Gives u of the border before row number `row` at v: a wavering line, the same for both rows that meet there. */
static double border_at(const hatching *h, int row, double v)
{
    if (row <= 0 || row >= h->rows)
        return row <= 0 ? -1e9 : 1e9;
    double at = v / (BORDER_KNOTS * h->length), knot = floor(at), w = at - knot;
    uint64_t key = random_fold(h->key, row, (int64_t)knot);
    double a = random_unit(key, 0), b = random_unit(random_fold(h->key, row, (int64_t)knot + 1), 0);
    w = w * w * (3 - 2 * w);
    return h->first + h->length * (row + BORDER_WAVER * 2 * (a + (b - a) * w - 0.5));
}

/* Gives the part of the line at v that belongs to the row at work. */
static span row_at(const hatching *h, double v)
{
    double stray_from = BORDER_STRAY * h->length * stray(h->key, number(h, AT_BORDER)), stray_to = BORDER_STRAY * h->length * stray(~h->key, number(h, AT_BORDER));
    return (span){border_at(h, h->row, v) - BORDER_LAP / 2 + stray_from, border_at(h, h->row + 1, v) + BORDER_LAP / 2 + stray_to};
}

static bool send_line(const hatching *h, const sections *k, double v, double tilt)
{
    bool ok = true;
    uint64_t index = AT_SPAN;
    span row = row_at(h, v);
    row = (span){fmax(row.from, h->page.x0), fmin(row.to, h->page.x1)};
    for (size_t i = 0; ok && i < k->spans.n; i++) {
        span all = k->spans.v[i], s = {fmax(all.from, row.from), fmin(all.to, row.to)};
        double length = s.to - s.from;
        if (length < SHORTEST)
            continue;
        s.from -= all.from >= row.from ? stray_of_end(h, length, index++) : 0;
        s.to += all.to <= row.to ? stray_of_end(h, length, index++) : 0;
        ok = h->l->tone ? send_varied(h, k, v, tilt, s, index) : send_sweeps(h, k, v, tilt, s, index);
        index += 8;
    }
    return ok;
}

/* Gives the slow drift of distances: a smooth function of the line's number, between -1 and 1. */
static double drift(uint64_t key, uint64_t line)
{
    uint64_t knot = line / DRIFT_LINES;
    double t = (double)(line % DRIFT_LINES) / DRIFT_LINES, w = t * t * (3 - 2 * t);
    double a = random_unit(~key, knot), b = random_unit(~key, knot + 1);
    return 2 * (a + (b - a) * w) - 1;
}

/* Draws the row at work, patch after patch. In a row that is longer than a stroke lines lean less. */
static bool send_row(hatching *h, sections *k, double from, double to)
{
    double spacing = fmax(h->l->spacing, (to - from) / MAX_LINES), gentle = fmin(1, LEAN_LENGTH / h->length), lean = 0;
    uint64_t first = (uint64_t)h->row * ROW_LINES;
    double place = from + spacing * random_unit(h->key, first);
    bool ok = true;
    int left = 0; /* lines of the patch */
    for (h->line = first + 1; ok && place < to; h->line++, left--) {
        if (left <= 0) {
            lean = PATCH_LEAN * stray(h->key, number(h, AT_PATCH));
            left = PATCH_FEWEST + (int)((PATCH_MOST + 1 - PATCH_FEWEST) * random_unit(~h->key, number(h, AT_PATCH)));
        }
        double v = place + spacing * SPACING_UNEVEN * stray(h->key, number(h, AT_PLACE));
        double turn = gentle * (lean + LINE_LEAN * stray(h->key, number(h, AT_TILT)));
        double tilt = tan(within(turn, -LEAN_MOST, LEAN_MOST));
        ok = plb_sections_at(k, v, tilt, h->m->err) && send_line(h, k, v, tilt);
        place += spacing * (1 + SPACING_DRIFT * drift(h->key, h->line));
    }
    return ok;
}

/* Finds the rows: of about the length of a stroke, side by side along the lines. */
static void find_rows(hatching *h, const sections *k)
{
    double from = fmax(k->bounds.x0, h->page.x0), extent = fmax(fmin(k->bounds.x1, h->page.x1) - from, SHORTEST);
    double wanted = within(STROKE_SPACINGS * h->l->spacing, STROKE_SHORTEST, STROKE_LONGEST);
    double most = within(MAX_ROW_EDGES / (double)(k->edges.n + 1), 1, MAX_ROWS);
    h->rows = extent < FREE_ROWS * wanted ? 1 : (int)fmin(floor(extent / wanted + 0.5), most);
    h->length = extent / h->rows;
    /* Rows of several layers do not begin at the same places. */
    h->first = from - (h->rows > 1 ? h->length * 0.5 * random_unit(~h->key, 1) : 0);
    if (h->rows > 1)
        h->rows++;
}

bool plb_hatch_lines(const shape *s, const hatch_layer *l, box page, const marks *m)
{
    frame f = plb_frame(l->angle);
    uint64_t identity = random_mix(s->identity + (uint64_t)l->layer);
    hatching h = {.l = l, .m = m, .f = f, .page = plb_frame_box(f, page), .key = random_key(m->options->seed, identity, PURPOSE_HATCH)};
    sections k;
    bool ok = plb_sections_init(&k, &s->edges, s->even_odd, f, tan(LEAN_MOST), m->err);
    find_rows(&h, &k);
    for (; ok && h.row < h.rows; h.row++) {
        plb_sections_restart(&k, h.rows > 1 ? h.first + h.length * (h.row + 0.5) : (k.bounds.x0 + k.bounds.x1) / 2);
        ok = send_row(&h, &k, fmax(k.bounds.y0, h.page.y0), fmin(k.bounds.y1, h.page.y1));
    }
    plb_sections_free(&k);
    return ok;
}

bool plb_mark_line(const marks *m, point a, point b, double pressure)
{
    track_point ends[2] = {{a, false}, {b, false}};
    track t = {.v = ends, .n = 2, .style = m->style};
    t.style.pressure = (float)pressure;
    return plb_point_distance(a, b) < SAME_POINT_MM || plb_track_copy(m->out, &t) || plb_fail_memory(m->err);
}
