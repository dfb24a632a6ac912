/* SPDX-License-Identifier: MIT
 *
 * See list_read.h. A table names the statements; each has a function that takes its line word by word.
 */
#include "list/text/list_read.h"

#include "base/number/number.h"
#include "list/text/list_scan.h"
#include "list/text/list_words.h"

#include <math.h>
#include <string.h>

#define TEXT_MAX 400
#define MAX_OMISSIONS 1000000000u /* of a kind; more are not counted */
#define FARTHEST_CLIP_MM 1e15 /* so that no later mapping makes a clip's point infinite */
#define CODE_DIGITS 6 /* of a character, hexadecimal */
#define LARGEST_CODE 0x10ffff
#define COUNT_DIGITS 9 /* of numbers of clips, of things left out */

typedef struct {
    list_scan scan;
    list_source *from;
    display_list *list;
    error *err;
    bool has_page, has_scale, has_end;
    bool is_mapped; /* by `to_page` */
    matrix to_page;
    unsigned messages;
    path path;           /* room for the one that is read */
    ARRAY(double) dash;  /* for its dashes */
    text_run text;       /* and for what it says; no characters: nothing */
} reader;

/* ---- words ---------------------------------------------------------------------------------------------------- */

static bool next(reader *r) { return plb_list_next_word(&r->scan); }
static bool is(const reader *r, const char *word) { return plb_list_is_word(&r->scan, word); }

/* Fails with "EXPECTED is missing" or "'WORD' stands where EXPECTED should". */
static bool fail_expecting(reader *r, const char *expected)
{
    if (!r->scan.length)
        return plb_fail(r->err, ERROR_SYNTAX, "the line ends where %s should stand", expected);
    int shown = r->scan.length > 40 ? 40 : (int)r->scan.length;
    return plb_fail(r->err, ERROR_SYNTAX, "'%.*s' stands where %s should", shown, r->scan.word, expected);
}

/* Reads the present word as a number from `low` to `high` and goes on to the next one. */
static bool take_number(reader *r, double low, double high, const char *what, double *v)
{
    const char *start = r->scan.word, *end = start + r->scan.length, *after;
    if (!r->scan.length || !plb_parse_number(start, end, v, &after) || after != end)
        return fail_expecting(r, what);
    if (!(*v >= low && *v <= high))
        return plb_fail(r->err, ERROR_SYNTAX, "%s out of range: %.*s", what, (int)(end - start > 40 ? 40 : end - start), start);
    return next(r);
}

#define LARGEST 1.7976931348623157e308 /* so that only an infinite number is out of range */

static bool take_any(reader *r, const char *what, double *v) { return take_number(r, -LARGEST, LARGEST, what, v); }

static bool take_share(reader *r, const char *what, double *v) { return take_number(r, 0, 1, what, v); }

/* Reads the present word as a whole number of at most nine digits. */
static bool is_count(const reader *r, unsigned long *n)
{
    *n = 0;
    if (!r->scan.length || r->scan.length > COUNT_DIGITS)
        return false;
    for (size_t i = 0; i < r->scan.length; i++) {
        unsigned digit = (unsigned)(r->scan.word[i] - '0');
        if (digit > 9)
            return false;
        *n = *n * 10 + digit;
    }
    return true;
}

static bool take_count(reader *r, const char *what, unsigned long *n)
{
    return is_count(r, n) ? next(r) : fail_expecting(r, what);
}

static bool take_point(reader *r, const char *what, point *p) { return take_any(r, what, &p->x) && take_any(r, what, &p->y); }

/* Reads one of n words, whose number `index` gets. */
static bool take_word(reader *r, const char *const words[], int n, const char *what, int *index)
{
    for (int i = 0; i < n; i++)
        if (is(r, words[i])) {
            *index = i;
            return next(r);
        }
    return fail_expecting(r, what);
}
#define take_one(r, words, what, index) take_word((r), (words), (int)(sizeof(words) / sizeof *(words)), (what), (index))

static bool expect_end_of_line(reader *r)
{
    return !r->scan.length || fail_expecting(r, "the end of the line");
}

static bool take_matrix(reader *r, matrix *m)
{
    double *const all[] = {&m->xx, &m->yx, &m->xy, &m->yy, &m->x0, &m->y0};
    for (int i = 0; i < 6; i++)
        if (!take_any(r, "a number of the matrix", all[i]))
            return false;
    return true;
}

/* ---- the page and what is said about it ----------------------------------------------------------------------- */

static bool read_page(reader *r)
{
    if (r->has_page)
        return plb_fail(r->err, ERROR_SYNTAX, "a second page");
    r->has_page = true;
    display_list *l = r->list;
    if (!take_any(r, "the width", &l->width) || !take_any(r, "the height", &l->height))
        return false;
    return (l->width > 0 && l->height > 0) || plb_fail(r->err, ERROR_SYNTAX, "a page without a size");
}

static bool read_pages(reader *r)
{
    if (r->from->pages)
        return plb_fail(r->err, ERROR_SYNTAX, "the count of pages twice");
    return take_count(r, "the count of pages", &r->from->pages) &&
           (r->from->pages || plb_fail(r->err, ERROR_SYNTAX, "a document without pages"));
}

static bool read_scale(reader *r)
{
    if (r->has_scale)
        return plb_fail(r->err, ERROR_SYNTAX, "a second scale");
    r->has_scale = true;
    return take_number(r, 1e-15, 1e15, "the scale", &r->list->paper_scale);
}

static bool read_matrix(reader *r)
{
    r->is_mapped = true;
    return take_matrix(r, &r->to_page);
}

static bool read_omission(reader *r)
{
    omission_kind kind;
    unsigned long n;
    char advice[OMISSION_ADVICE_MAX];
    if (!r->scan.length || !plb_omission_find(r->scan.word, r->scan.length, &kind))
        return fail_expecting(r, "a kind of omission");
    if (!next(r))
        return false;
    /* The advice is a text, not words, so the scanner must not look past the count. */
    if (!is_count(r, &n))
        return fail_expecting(r, "how many were left out");
    omissions *all = &r->list->omissions;
    all->n[kind] += all->n[kind] < MAX_OMISSIONS ? n : 0;
    if (!plb_list_take_text(&r->scan, advice, sizeof advice))
        return false;
    if (*advice)
        plb_omissions_advise(all, advice);
    return true;
}

static bool read_message(reader *r, message_level level)
{
    char text[TEXT_MAX];
    if (r->messages++ == LIST_MAX_MESSAGES)
        return plb_fail(r->err, ERROR_LIMIT, "more than %u messages", LIST_MAX_MESSAGES);
    if (!plb_list_take_text(&r->scan, text, sizeof text))
        return false;
    plb_log(&r->from->say, level, "%s: %s", r->from->name, text);
    return true;
}

static bool read_warning(reader *r) { return read_message(r, MESSAGE_WARNING); }
static bool read_detail(reader *r) { return read_message(r, MESSAGE_DETAIL); }

/* ---- gradients -------------------------------------------------------------------------------------------------- */

static bool take_end(reader *r, const gradient *g, point *at, double *radius)
{
    return take_point(r, "an end of the gradient", at) && (!g->radial || take_number(r, 0, LARGEST, "a radius", radius));
}

static bool take_stops(reader *r, gradient *g)
{
    double last = 0, offset, colour[4];
    while (r->scan.length) {
        bool good = take_share(r, "an offset", &offset);
        for (int i = 0; good && i < 4; i++)
            good = take_share(r, "a component of a colour", &colour[i]);
        if (!good)
            return false;
        if (offset < last)
            return plb_fail(r->err, ERROR_SYNTAX, "an offset below the one before");
        last = offset;
        plb_gradient_add_stop(g, (gradient_stop){offset, (float)colour[0], (float)colour[1], (float)colour[2], (float)colour[3]});
    }
    return true;
}

static bool read_gradient(reader *r)
{
    gradient g = {0};
    int shape = 0, extend = 0;
    if (!take_one(r, plb_list_shapes, "linear or radial", &shape) || !take_one(r, plb_list_extends, "how the gradient goes on", &extend))
        return false;
    g.radial = shape == 1;
    g.extend = (gradient_extend)extend;
    if (!take_share(r, "the opacity", &g.opacity) || !take_matrix(r, &g.to_space) || !take_end(r, &g, &g.from, &g.from_radius) ||
        !take_end(r, &g, &g.to, &g.to_radius) || !take_stops(r, &g))
        return false;
    matrix from_page;
    if (r->is_mapped && !plb_matrix_invert(r->to_page, &from_page))
        return plb_fail(r->err, ERROR_SYNTAX, "a gradient under a matrix that has no inverse");
    if (r->is_mapped)
        g.to_space = plb_matrix_multiply(from_page, g.to_space);
    if (!isfinite(g.to_space.xx + g.to_space.yx + g.to_space.xy + g.to_space.yy + g.to_space.x0 + g.to_space.y0))
        return plb_fail(r->err, ERROR_SYNTAX, "a gradient whose matrix is not finite");
    return plb_list_append_gradient(r->list, &g, r->err);
}

/* ---- paths -------------------------------------------------------------------------------------------------------- */

static bool take_points(reader *r, path_op op, int n)
{
    point p[3];
    for (int i = 0; i < n; i++)
        if (!take_point(r, "a coordinate", &p[i]))
            return false;
    path *to = &r->path;
    if (to->points.n + (size_t)n > LIST_MAX_POINTS - r->list->points)
        return plb_fail(r->err, ERROR_LIMIT, "the drawing has more than %u points", LIST_MAX_POINTS);
    if (!array_reserve(&to->ops, 1) || !array_reserve(&to->points, (size_t)n))
        return plb_fail_memory(r->err);
    to->ops.v[to->ops.n++] = (uint8_t)op;
    memcpy(to->points.v + to->points.n, p, (size_t)n * sizeof *p);
    to->points.n += (size_t)n;
    return true;
}

/* Reads the rest of the line into r->path, in the coordinates written there. Without two closings in a row it has no more steps than twice its
 * points. */
static bool take_path(reader *r)
{
    static const char letters[] = "MLCZ";
    static const int points[] = {1, 1, 3, 0};
    plb_path_clear(&r->path);
    while (r->scan.length) {
        const char *letter = r->scan.length == 1 ? memchr(letters, *r->scan.word, 4) : NULL;
        if (!letter)
            return fail_expecting(r, "a step of the path (M, L, C or Z)");
        path_op op = (path_op)(letter - letters), last = r->path.ops.n ? r->path.ops.v[r->path.ops.n - 1] : PATH_CLOSE;
        if (!r->path.ops.n && op != PATH_MOVE)
            return plb_fail(r->err, ERROR_SYNTAX, "a path that does not begin with M");
        if (op == PATH_CLOSE && last == PATH_CLOSE)
            return plb_fail(r->err, ERROR_SYNTAX, "a path that is closed twice");
        if (!next(r) || !take_points(r, op, points[op]))
            return false;
    }
    return true;
}

/* Copies the path into one that is just large enough, in mm on the page. */
static bool move_path(reader *r, path *to)
{
    size_t ops = r->path.ops.n, points = r->path.points.n;
    if (!array_make(&to->ops, ops) || !array_make(&to->points, points))
        return plb_fail_memory(r->err);
    if (ops)
        memcpy(to->ops.v, r->path.ops.v, ops);
    if (points)
        memcpy(to->points.v, r->path.points.v, points * sizeof *to->points.v);
    to->ops.n = ops;
    to->points.n = points;
    if (r->is_mapped)
        plb_path_transform(to, r->to_page);
    return true;
}

/* Reads - or the number of an earlier clip. */
static bool take_clip(reader *r, int *index)
{
    unsigned long n;
    *index = NO_CLIP;
    if (is(r, "-"))
        return next(r);
    if (!take_count(r, "- or the number of a clip", &n))
        return false;
    *index = (int)n;
    return n < r->list->clips.n || plb_fail(r->err, ERROR_SYNTAX, "there is no clip %lu before", n);
}

/* Items beyond all paper are dropped; a clip cannot be, for it would hide less. */
static bool is_near(reader *r, const path *p)
{
    for (size_t i = 0; i < p->points.n; i++)
        if (!(fabs(p->points.v[i].x) <= FARTHEST_CLIP_MM && fabs(p->points.v[i].y) <= FARTHEST_CLIP_MM))
            return plb_fail(r->err, ERROR_SYNTAX, "a clip farther than %g mm from the page", FARTHEST_CLIP_MM);
    return true;
}

static bool read_clip(reader *r)
{
    clip c = {0};
    int rule = 0, index;
    if (!take_clip(r, &c.parent) || !take_one(r, plb_list_rules, "nonzero or evenodd", &rule) || !take_path(r))
        return false;
    c.even_odd = rule == 1;
    if (move_path(r, &c.path) && is_near(r, &c.path) && plb_list_add_clip(r->list, &c, &index, r->err))
        return true;
    plb_path_free(&c.path);
    return false;
}

/* ---- items -------------------------------------------------------------------------------------------------------- */

/* Reads gradient@INDEX, cutting the word at its @. */
static bool take_gradient_number(reader *r, item *it)
{
    size_t n = strlen(plb_list_paints[PAINT_GRADIENT]) + 1;
    r->scan.word += n;
    r->scan.length -= n;
    unsigned long index;
    if (!take_count(r, "the number of a gradient", &index))
        return false;
    it->paint.kind = PAINT_GRADIENT;
    it->gradient = (unsigned)index + 1;
    return index < r->list->gradients.n || plb_fail(r->err, ERROR_SYNTAX, "there is no gradient %lu before", index);
}

static bool take_paint(reader *r, item *it)
{
    static const char numbered[] = "gradient@";
    int kind = 0;
    if (r->scan.length >= strlen(numbered) && !memcmp(r->scan.word, numbered, strlen(numbered))) {
        if (!take_gradient_number(r, it))
            return false;
    } else if (take_one(r, plb_list_paints, "a paint", &kind)) {
        it->paint.kind = (paint_kind)kind;
    } else {
        return false;
    }
    double *const all[] = {&it->paint.red, &it->paint.green, &it->paint.blue, &it->paint.alpha};
    for (int i = 0; i < 4; i++)
        if (!take_share(r, "a component of a colour", all[i]))
            return false;
    return true;
}

/* Reads ON OFF … @ OFFSET. */
static bool take_dashes(reader *r, item *it)
{
    r->dash.n = 0;
    while (r->scan.length && !is(r, "@")) {
        double v;
        if (!take_number(r, 0, LARGEST, "a dash, or @", &v))
            return false;
        if (r->dash.n >= LIST_MAX_DASHES - r->list->dashes)
            return plb_fail(r->err, ERROR_LIMIT, "the drawing has more than %u dashes", LIST_MAX_DASHES);
        if (!array_push(&r->dash, v))
            return plb_fail_memory(r->err);
    }
    if (!is(r, "@"))
        return fail_expecting(r, "@ and the offset of the dashes");
    if (r->dash.n % 2 || !r->dash.n)
        return plb_fail(r->err, ERROR_SYNTAX, "dashes that are no pairs");
    if (!array_make(&it->dash, r->dash.n))
        return plb_fail_memory(r->err);
    memcpy(it->dash.v, r->dash.v, r->dash.n * sizeof *r->dash.v);
    it->dash.n = r->dash.n;
    return next(r) && take_any(r, "the offset of the dashes", &it->dash_offset);
}

static bool take_pen(reader *r, item *it)
{
    int cap = 0;
    if (!is(r, "width"))
        return fail_expecting(r, "width");
    if (!next(r) || !take_number(r, 0, LARGEST, "the width", &it->width) || !take_one(r, plb_list_caps, "butt, round or square", &cap))
        return false;
    it->cap = (line_cap)cap;
    return !is(r, "dash") || (next(r) && take_dashes(r, it));
}

/* Reads the hexadecimal digits of one code; false: there is none, or no character has it. */
static bool take_code(const char **at, const char *end, uint32_t *code)
{
    const char *start = *at;
    for (*code = 0; *at < end && **at != '+'; ++*at) {
        int digit = **at >= '0' && **at <= '9' ? **at - '0' : **at >= 'a' && **at <= 'f' ? **at - 'a' + 10 : **at >= 'A' && **at <= 'F' ? **at - 'A' + 10 : -1;
        if (digit < 0 || *at - start >= CODE_DIGITS)
            return false;
        *code = *code << 4 | (uint32_t)digit;
    }
    return *code > 0 && *code <= LARGEST_CODE;
}

/* Reads U+66+69, how many subpaths that has and where it stands, in the coordinates written there. */
static bool take_character(reader *r, size_t *subpaths)
{
    static const char what[] = "a character (U+ and its code)";
    const char *at = r->scan.word + strlen(LIST_CHARACTER), *end = r->scan.word + r->scan.length;
    character c = {{0}, 0, {0, 0}};
    unsigned long n;
    for (int i = 0; at <= end; i++, at++)
        if (i == CHARACTER_MAX_CODES || !take_code(&at, end, &c.code[i]))
            return fail_expecting(r, what);
    if (!next(r) || !take_count(r, "how many subpaths the character has", &n) || !take_point(r, "the character's place", &c.at))
        return false;
    *subpaths += n;
    c.subpaths = (uint32_t)n;
    if (!n)
        return plb_fail(r->err, ERROR_SYNTAX, "a character without a subpath");
    if (r->text.characters.n >= LIST_MAX_CHARACTERS - r->list->characters)
        return plb_fail(r->err, ERROR_LIMIT, "the drawing has more than %u characters", LIST_MAX_CHARACTERS);
    return array_push(&r->text.characters, c) || plb_fail_memory(r->err);
}

/* Reads the direction of a fill's hatching, where the text has one. */
static bool take_direction(reader *r, item *it)
{
    it->is_directed = is(r, LIST_HATCH);
    if (!it->is_directed)
        return true;
    if (!next(r) || !take_number(r, -360, 360, "the direction of hatching", &it->direction))
        return false;
    if (r->is_mapped)
        it->direction = plb_matrix_turn(r->to_page, it->direction);
    return true;
}

static bool is_character(const reader *r)
{
    size_t n = strlen(LIST_CHARACTER);
    return r->scan.length > n && !memcmp(r->scan.word, LIST_CHARACTER, n);
}

/* Reads what a fill says, EM DEGREES CHARACTER …, and gives how many subpaths of its path that takes. */
static bool take_text(reader *r, size_t *subpaths)
{
    *subpaths = r->text.characters.n = 0;
    if (!is(r, LIST_TEXT))
        return true;
    if (!next(r) || !take_number(r, 1e-9, LARGEST, "the size of the text", &r->text.em) || !take_number(r, -360, 360, "the direction of the text", &r->text.degrees))
        return false;
    while (is_character(r))
        if (!take_character(r, subpaths))
            return false;
    return r->text.characters.n || fail_expecting(r, "a character");
}

/* Gives the item a copy of what it says, in mm on the page. Where the matrix turns the letters over, nothing is known of them. */
static bool move_text(reader *r, size_t subpaths, item *it)
{
    size_t moves = 0;
    if (!r->text.characters.n)
        return true;
    for (size_t i = 0; i < r->path.ops.n; i++)
        moves += r->path.ops.v[i] == PATH_MOVE;
    if (subpaths > moves)
        return plb_fail(r->err, ERROR_SYNTAX, "the characters have %zu subpaths, the path has %zu", subpaths, moves);
    it->text = plb_text_run_copy(&r->text, 1);
    if (!it->text)
        return plb_fail_memory(r->err);
    if (r->is_mapped && !plb_text_run_map(it->text, r->to_page, false)) {
        plb_text_run_free(it->text);
        it->text = NULL;
    }
    return true;
}

static bool read_item(reader *r, item_kind kind)
{
    item it = {.kind = kind};
    int rule = 0;
    size_t subpaths = 0;
    bool good = take_clip(r, &it.clip) && take_paint(r, &it);
    r->text.characters.n = 0;
    if (good && kind == ITEM_FILL)
        good = take_one(r, plb_list_rules, "nonzero or evenodd", &rule) && take_direction(r, &it) && take_text(r, &subpaths);
    else if (good)
        good = take_pen(r, &it);
    it.even_odd = rule == 1;
    if (good && take_path(r) && move_path(r, &it.path) && move_text(r, subpaths, &it) && plb_list_add(r->list, &it, r->err))
        return true;
    plb_item_free(&it);
    return false;
}

static bool read_fill(reader *r) { return read_item(r, ITEM_FILL); }
static bool read_stroke(reader *r) { return read_item(r, ITEM_STROKE); }

static bool read_end(reader *r)
{
    r->has_end = true;
    return r->has_page || plb_fail(r->err, ERROR_SYNTAX, "a drawing without a page");
}

/* ---- the text ------------------------------------------------------------------------------------------------------- */

/* `draws`: only after the page. `is_text`: what follows are no words. */
static const struct {
    const char *name;
    bool (*read)(reader *r);
    bool draws, is_text;
} statements[] = {
    {"stroke", read_stroke, true, false},   {"fill", read_fill, true, false},      {"clip", read_clip, true, false},
    {"gradient", read_gradient, true, false}, {"matrix", read_matrix, false, false}, {"page", read_page, false, false},
    {"pages", read_pages, false, false},    {"scale", read_scale, false, false},   {"omit", read_omission, false, false},
    {"warning", read_warning, false, true}, {"detail", read_detail, false, true},  {"end", read_end, false, false},
};

static bool read_statement(reader *r)
{
    if (r->has_end)
        return plb_fail(r->err, ERROR_SYNTAX, "something follows the end");
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (is(r, statements[i].name)) {
            if (statements[i].draws && !r->has_page)
                return plb_fail(r->err, ERROR_SYNTAX, "%s before the page", statements[i].name);
            return (statements[i].is_text || next(r)) && statements[i].read(r) && expect_end_of_line(r);
        }
    return fail_expecting(r, "a statement");
}

static bool read_version(reader *r)
{
    if (!next(r))
        return false;
    if (!is(r, LIST_FIRST_WORD))
        return plb_fail(r->err, ERROR_SYNTAX, "its first line is not \"" LIST_FIRST_WORD " " LIST_VERSION "\"");
    if (!next(r))
        return false;
    if (!is(r, LIST_VERSION))
        return r->scan.length ? plb_fail(r->err, ERROR_UNSUPPORTED, "version %.*s of the list; this program reads version " LIST_VERSION,
                                         (int)(r->scan.length > 20 ? 20 : r->scan.length), r->scan.word)
                              : fail_expecting(r, "the version");
    return next(r) && expect_end_of_line(r);
}

bool plb_list_read(list_source *from, display_list *list, error *err)
{
    error why = {ERROR_NONE, ""};
    reader r = {.from = from, .list = list, .err = &why};
    r.scan.refill = from->refill;
    r.scan.closure = from->closure;
    r.scan.err = &why;
    r.scan.line = 1;
    from->pages = 0;
    bool good = read_version(&r);
    while (good && (good = plb_list_next_line(&r.scan)) && r.scan.length)
        good = read_statement(&r);
    if (good && !r.has_end)
        good = plb_fail(&why, ERROR_SYNTAX, "the text stops before its end");
    plb_path_free(&r.path);
    array_free(&r.dash);
    array_free(&r.text.characters);
    from->line = r.scan.line;
    from->complete = good;
    return good || plb_fail(err, why.kind, "%s", why.text);
}
