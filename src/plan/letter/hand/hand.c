/* SPDX-License-Identifier: MIT
 *
 * See hand.h. All is done in the frame of the line of text: x along the baseline, y up from it, mm. A form of the alphabet is mapped
 * into the box of a character's ink piece by piece: its baseline onto the text's, the height of its small letters onto theirs, its top and
 * bottom onto the ink's. Then the hand deviates: each letter is a little higher or lower, broader, leaning, off the baseline, and its
 * points are never quite where they were.
 */
#include "plan/letter/hand/hand.h"

#include "base/number/random.h"
#include "plan/letter/hand/alphabet.h"

#include <math.h>
#include <stdlib.h>

/* Letters differ in height by this part, either way, and in width by as much (letters of five writers: cv of height .14 to .16, with
 * their small and large letters; a half of it here, for labels must be read). */
#define HEIGHT_PART 0.12
#define WIDTH_PART 0.06
/* Letters with stems and tails are shorter by no more than this part: a b of short stem is an o. */
#define SHORTER_STEM 0.02
/* Lines of text lean to the right by so many degrees, each letter by as many more or less (chosen by eye). */
#define LEAN_DEGREES 2.5
#define LEAN_LINE 2.5
#define LEAN_LETTER 2.0
/* A letter stands off the baseline by this part of a small letter's height (sd .03 to .04 of real ones, so even up to .06). */
#define BASELINE_PART 0.06
/* A word rises by so many degrees (real rows 2 to 4), but its ends by no more than this part of a small letter's height, for labels must
 * stay in their places. */
#define RISE_DEGREES 1.2
#define RISE_PART 0.12
/* A point of a form strays by so many units of the alphabet. */
#define POINT_STRAY 2.0
/* Figures are lettered with care, for a wrong one is worse than a stiff one: they deviate by this part of that (chosen by eye). */
#define FIGURE_CARE 0.6
/* A letter is at most so much wider for its height than the alphabet has it: in a broader box it stands in the middle. */
#define MOST_WIDE 1.35
/* A form narrower than this, in units, keeps its width: an l is no bar across the box of its serifs. */
#define NARROW 22
/* A word ends at a gap of this part of the em. */
#define WORD_GAP 0.2
/* The smooth way between two points of a form is made of so many chords. */
#define CHORDS 5
#define MAX_FORM_POINTS 64

typedef struct {
    double x, y;
    bool corner, begins; /* begins: a stroke starts here */
} form_point;

typedef struct {
    form_point v[MAX_FORM_POINTS];
    int n;
    double x0, x1, y0, y1;
    bool is_small;  /* its body is as high as small letters */
    bool is_marked; /* above: something stands on it */
    double care;    /* the hand deviates by this part */
} letter;

typedef struct {
    const item *fill;
    matrix to_line, to_page; /* between page and frame */
    double inset;
    double small; /* height of small letters, mm; 0: not known */
    uint64_t key;
    double lean;  /* radians */
    track_list *out;
    box *ink;     /* of each character */
} hand;

/* ---- forms ---- */

static int read_number(const char **at)
{
    bool minus = **at == '-';
    int v = 0;
    *at += minus;
    for (; **at >= '0' && **at <= '9'; ++*at)
        v = v * 10 + (**at - '0');
    return minus ? -v : v;
}

/* Adds the points of a form, moved. */
static void add_form(letter *l, const char *at, double dx, double dy)
{
    bool begins = true;
    while (*at && l->n < MAX_FORM_POINTS) {
        form_point p = {.begins = begins};
        p.x = read_number(&at) + dx;
        at += *at == ',';
        p.y = read_number(&at) + dy;
        p.corner = *at == '*';
        at += p.corner;
        begins = *at == '|';
        while (*at == '|' || *at == ' ')
            at++;
        l->v[l->n++] = p;
    }
}

static void measure(letter *l)
{
    l->x0 = l->y0 = 1e9;
    l->x1 = l->y1 = -1e9;
    for (int i = 0; i < l->n; i++) {
        l->x0 = fmin(l->x0, l->v[i].x), l->x1 = fmax(l->x1, l->v[i].x);
        l->y0 = fmin(l->y0, l->v[i].y), l->y1 = fmax(l->y1, l->v[i].y);
    }
}

static bool add_any_form(letter *l, uint32_t code, uint64_t key)
{
    const letter_form *f = plb_alphabet_find(code);
    int n = 0;
    while (f && n < ALPHABET_FORMS && f->form[n])
        n++;
    if (n)
        add_form(l, f->form[random_bits(key, 0) % (uint64_t)n], 0, 0);
    return n > 0;
}

/* Fills in how the character is lettered; false: the alphabet does not have it. */
static bool find_letter(letter *l, const character *c, uint64_t key)
{
    const marked_letter *m = c->code[1] ? NULL : plb_alphabet_find_marked(c->code[0]);
    uint32_t code = m ? m->letter : c->code[0];
    l->n = 0;
    if (c->code[1] || !add_any_form(l, code, key))
        return false;
    measure(l);
    l->is_small = code >= 'a' && code <= 'z' ? l->y1 <= 101 : code == 0x131 || (code >= 0x3b1 && code <= 0x3c9);
    l->is_marked = m && !m->below;
    l->care = code >= '0' && code <= '9' ? FIGURE_CARE : 1;
    if (m)
        add_form(l, m->mark, (l->x0 + l->x1) / 2, m->below ? 0 : l->y1);
    double x0 = l->x0, x1 = l->x1;
    measure(l);
    if (m)
        l->x0 = fmin(x0, l->x0), l->x1 = fmax(x1, l->x1);
    return true;
}

/* ---- into the box ---- */

static double between(double y, double from0, double from1, double to0, double to1)
{
    return from1 - from0 < 1e-9 ? (to0 + to1) / 2 : to0 + (y - from0) / (from1 - from0) * (to1 - to0);
}

/* Gives the height of a form's point in the box b, whose y runs up from the baseline. */
static double map_y(const hand *h, const letter *l, box b, double y)
{
    double at[4], to[4];
    int n = 0;
    if (l->y0 < -5 && b.y0 < 0) {
        at[n] = l->y0, to[n++] = b.y0;
        at[n] = 0, to[n++] = 0;
    } else {
        at[n] = l->y0, to[n++] = b.y0;
    }
    double body = l->is_small ? ALPHABET_SMALL : ALPHABET_CAPITAL, high = l->is_small ? h->small - h->inset : b.y0 + (b.y1 - b.y0) * ALPHABET_CAPITAL / l->y1;
    bool has_top = (l->is_small ? l->y1 > ALPHABET_SMALL + 5 : l->is_marked) && high > to[n - 1] && high < b.y1;
    if (has_top)
        at[n] = body, to[n++] = high;
    at[n] = l->y1, to[n++] = b.y1;
    int k = 0;
    while (k + 2 < n && y > at[k + 1])
        k++;
    return between(y, at[k], at[k + 1], to[k], to[k + 1]);
}

static double stray(uint64_t key, uint64_t index)
{
    return 2 * random_unit(key, index) - 1;
}

/* Narrows the box to what the letter may fill: a stroke's half inside, not too wide for its height. */
static box room_in(const hand *h, const letter *l, box b)
{
    double middle = (b.x0 + b.x1) / 2, centre = (b.y0 + b.y1) / 2;
    double ix = fmin(h->inset, (b.x1 - b.x0) / 2), iy = fmin(h->inset, (b.y1 - b.y0) / 2);
    b = (box){b.x0 + ix, b.y0 + iy, b.x1 - ix, b.y1 - iy};
    double scale = l->y1 > l->y0 ? (b.y1 - b.y0) / (l->y1 - l->y0) : 0, wide = l->x1 - l->x0, most = scale * wide * MOST_WIDE;
    if (wide <= NARROW && scale > 0)
        most = scale * wide;
    if (l->y1 - l->y0 > 1 && b.x1 - b.x0 > most)
        b.x0 = middle - most / 2, b.x1 = middle + most / 2;
    if (l->y1 - l->y0 < 1)
        b.y0 = b.y1 = centre;
    return b;
}

/* Places a letter's points: x and y become mm in the line's frame. `rise`: by how much it stands higher than the baseline. */
static void place(const hand *h, letter *l, box ink, uint64_t key, double rise)
{
    box b = room_in(h, l, ink);
    double size = b.y1 - b.y0, middle = (b.x0 + b.x1) / 2, unit = size / fmax(l->y1 - l->y0, 30);
    bool has_stem = l->is_small && (l->y1 > ALPHABET_SMALL + 5 || l->y0 < -5);
    double high = 1 + fmax(HEIGHT_PART * l->care * stray(key, 1), has_stem ? -SHORTER_STEM : -1), wide = 1 + WIDTH_PART * l->care * stray(key, 2);
    double lean = tan(h->lean + LEAN_LETTER * PLB_PI / 180 * stray(key, 3));
    double off = rise + BASELINE_PART * (h->small > 0 ? h->small : size * 0.7) * stray(key, 4);
    double from = b.y0 < 0 ? 0 : b.y0; /* letters grow from the baseline; what floats from its own foot */
    for (int i = 0; i < l->n; i++) {
        form_point *p = &l->v[i];
        double x = between(p->x, l->x0, l->x1, b.x0, b.x1), y = map_y(h, l, b, p->y);
        x += POINT_STRAY * l->care * unit * stray(key, 10 + 2 * (uint64_t)i);
        y += POINT_STRAY * l->care * unit * stray(key, 11 + 2 * (uint64_t)i);
        y = from + (y - from) * high;
        p->x = middle + (x - middle) * wide + (y - (from + size / 2)) * lean;
        p->y = y + off;
    }
}

/* ---- strokes ---- */

/* Gives the place at share t of the smooth way from b to c, with neighbours a and d (Catmull and Rom 1974). */
static point smooth_at(point a, point b, point c, point d, double t)
{
    double t2 = t * t, t3 = t2 * t;
    double wa = -t3 + 2 * t2 - t, wb = 3 * t3 - 5 * t2 + 2, wc = -3 * t3 + 4 * t2 + t, wd = t3 - t2;
    return (point){(wa * a.x + wb * b.x + wc * c.x + wd * d.x) / 2, (wa * a.y + wb * b.y + wc * c.y + wd * d.y) / 2};
}

static point at(const form_point *v, int i) { return (point){v[i].x, v[i].y}; }

/* Adds one stroke of n points. */
static bool add_stroke(const hand *h, const form_point *v, int n)
{
    track t = {.style = {.pressure = 1, .kind = STROKE_LETTER}};
    bool ok = plb_track_begin(h->out, &t) && plb_track_push(h->out, plb_matrix_apply(h->to_page, at(v, 0)), false);
    for (int i = 0; ok && i + 1 < n; i++) {
        bool ends_a = i == 0 || v[i].corner, ends_b = i + 2 == n || v[i + 1].corner;
        point b = at(v, i), c = at(v, i + 1), a = ends_a ? b : at(v, i - 1), d = ends_b ? c : at(v, i + 2);
        int chords = ends_a && ends_b ? 1 : CHORDS;
        for (int k = 1; ok && k <= chords; k++)
            ok = plb_track_push(h->out, plb_matrix_apply(h->to_page, smooth_at(a, b, c, d, (double)k / chords)), k == chords && i + 2 < n && v[i + 1].corner);
    }
    return ok;
}

static bool add_strokes(const hand *h, const letter *l)
{
    bool ok = true;
    for (int i = 0, n; ok && i < l->n; i += n) {
        for (n = 1; i + n < l->n && !l->v[i + n].begins; n++)
            ;
        ok = n < 2 || add_stroke(h, l->v + i, n);
    }
    return ok;
}

/* ---- a line of text ---- */

static const unsigned char points_of[] = {[PATH_MOVE] = 1, [PATH_LINE] = 1, [PATH_CURVE] = 3, [PATH_CLOSE] = 0};

/* A place in the path. */
typedef struct {
    size_t op, point;
} cursor;

/* Goes on over so many subpaths, whose points are in `ink` in the line's frame. */
static void skip(const hand *h, cursor *c, size_t subpaths, box *ink)
{
    const path *p = &h->fill->path;
    size_t begun = 0;
    *ink = BOX_EMPTY;
    for (; c->op < p->ops.n; c->op++) {
        begun += p->ops.v[c->op] == PATH_MOVE;
        if (begun > subpaths)
            return;
        for (int k = points_of[p->ops.v[c->op]]; k > 0; k--)
            plb_box_add(ink, plb_matrix_apply(h->to_line, p->points.v[c->point++]));
    }
}

/* Appends the steps between two places to `rest`. */
static bool keep(const hand *h, cursor from, cursor to, path *rest)
{
    const path *p = &h->fill->path;
    bool ok = array_reserve(&rest->ops, to.op - from.op) && array_reserve(&rest->points, to.point - from.point);
    for (size_t i = from.op; ok && i < to.op; i++)
        rest->ops.v[rest->ops.n++] = p->ops.v[i];
    for (size_t i = from.point; ok && i < to.point; i++)
        rest->points.v[rest->points.n++] = p->points.v[i];
    return ok;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool is_of_small_height(uint32_t code)
{
    return code == 'a' || code == 'c' || code == 'e' || (code >= 'm' && code <= 's' && code != 'q' && code != 'p') || (code >= 'u' && code <= 'z' && code != 'y');
}

/* Finds the height of small letters: the middle one of those that have neither stems nor tails, else the usual one of fonts. */
static bool find_small(hand *h)
{
    const text_run *t = h->fill->text;
    double *all = plb_new(t->characters.n + 1, sizeof *all);
    size_t n = 0;
    for (size_t i = 0; all && i < t->characters.n; i++)
        if (is_of_small_height(t->characters.v[i].code[0]) && !t->characters.v[i].code[1])
            all[n++] = h->ink[i].y1;
    if (n)
        qsort(all, n, sizeof *all, compare);
    h->small = n ? all[n / 2] : 0.52 * t->em;
    plb_free(all);
    return all;
}

/* Gives how far a word's letter stands above the baseline, because the word rises about its middle. */
static double rise_in_word(const hand *h, size_t first, size_t end, size_t i, uint64_t key)
{
    double from = h->ink[first].x0, to = h->ink[end - 1].x1, half = (to - from) / 2;
    double most = RISE_PART * h->small, slope = tan(RISE_DEGREES * PLB_PI / 180) * (0.5 + random_unit(key, 5));
    slope = half * slope > most ? most / half : slope;
    return slope * ((h->ink[i].x0 + h->ink[i].x1) / 2 - (from + to) / 2);
}

static size_t end_of_word(const hand *h, size_t first)
{
    const text_run *t = h->fill->text;
    size_t end = first + 1;
    while (end < t->characters.n && h->ink[end].x0 - h->ink[end - 1].x1 < WORD_GAP * t->em && h->ink[end].x0 > h->ink[end - 1].x0)
        end++;
    return end;
}

static uint64_t key_at(const hand *h, point p)
{
    return random_key(random_fold(h->key, llround(p.x * 1000), llround(p.y * 1000)), 0, PURPOSE_LETTER);
}

static bool letter_words(hand *h, path *rest)
{
    const text_run *t = h->fill->text;
    cursor c = {0, 0};
    bool ok = true;
    for (size_t first = 0, end; ok && first < t->characters.n; first = end) {
        end = end_of_word(h, first);
        for (size_t i = first; ok && i < end; i++) {
            const character *ch = &t->characters.v[i];
            cursor from = c;
            letter l;
            box ink;
            skip(h, &c, ch->subpaths, &ink);
            uint64_t key = key_at(h, ch->at);
            if (!find_letter(&l, ch, key) || plb_box_is_empty(ink)) {
                ok = keep(h, from, c, rest);
                continue;
            }
            place(h, &l, ink, key, rise_in_word(h, first, end, i, key_at(h, t->characters.v[first].at)));
            ok = add_strokes(h, &l);
        }
    }
    cursor end = {h->fill->path.ops.n, h->fill->path.points.n};
    return ok && keep(h, c, end, rest);
}

bool plb_hand_letters(const item *fill, double inset, uint64_t seed, track_list *out, path *rest)
{
    const text_run *t = fill->text;
    double a = t->degrees * PLB_PI / 180, co = cos(a), si = sin(a);
    point origin = t->characters.v[0].at;
    hand h = {.fill = fill, .inset = inset, .out = out, .to_page = {co, si, si, -co, origin.x, origin.y}, .key = random_mix(seed)};
    h.ink = plb_new(t->characters.n, sizeof *h.ink);
    if (!h.ink || !plb_matrix_invert(h.to_page, &h.to_line)) {
        plb_free(h.ink);
        return h.ink;
    }
    cursor c = {0, 0};
    for (size_t i = 0; i < t->characters.n; i++)
        skip(&h, &c, t->characters.v[i].subpaths, &h.ink[i]);
    h.lean = (LEAN_DEGREES + LEAN_LINE * stray(key_at(&h, origin), 6)) * PLB_PI / 180;
    bool ok = find_small(&h) && letter_words(&h, rest);
    plb_free(h.ink);
    return ok;
}
