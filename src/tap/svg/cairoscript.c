/* SPDX-License-Identifier: MIT
 *
 * CairoScript: the tap's head line, then token by token through the tables of operators. There is no recursion and
 * no loop in the language, only a stack.
 */
#include "tap/svg/cairoscript.h"

#include "base/number/number.h"
#include "tap/svg/cairoscript_state.h"

#include <math.h>
#include <string.h>

/* ---- brackets ----------------------------------------------------------------------------------------------- */

static bool push_opaque(script_state *s) { return plb_script_push(s, (script_value){.kind = VALUE_OPAQUE}); }

/* The first value above the topmost mark. */
static bool find_mark(script_state *s, size_t *first)
{
    size_t i = s->stack.n;
    while (i && s->stack.v[i - 1].kind != VALUE_MARK)
        i--;
    *first = i;
    return i > 0 || plb_fail(s->err, ERROR_SYNTAX, "a bracket closes that never opened");
}

/* ]: the numbers since the mark; an array of anything else is of no use to us. */
static bool close_array(script_state *s)
{
    size_t first;
    if (!find_mark(s, &first))
        return false;
    size_t n = s->stack.n - first, start = s->numbers.n;
    if (start + n > SCRIPT_MAX_STACK)
        return plb_fail(s->err, ERROR_LIMIT, "more than %u numbers in arrays", SCRIPT_MAX_STACK);
    if (!array_reserve(&s->numbers, n))
        return plb_fail_memory(s->err);
    bool numbers = true;
    for (size_t i = first; i < s->stack.n; i++)
        numbers = numbers && s->stack.v[i].kind == VALUE_NUMBER;
    for (size_t i = 0; numbers && i < n; i++)
        s->numbers.v[s->numbers.n++] = s->stack.v[first + i].number;
    if (numbers)
        s->stack.n = first;
    while (s->stack.n >= first)
        plb_script_pop(s);
    if (!numbers)
        return push_opaque(s);
    s->arrays++;
    return plb_script_push(s, (script_value){.kind = VALUE_ARRAY, .array = {(uint32_t)start, (uint32_t)n}});
}

/* >>: nothing in a dictionary is of use to us. */
static bool close_dictionary(script_state *s)
{
    size_t first;
    if (!find_mark(s, &first))
        return false;
    while (s->stack.n >= first)
        plb_script_pop(s);
    return push_opaque(s);
}

/* ---- names and constants ------------------------------------------------------------------------------------ */

/* "s12" is 12; others have a code below zero. */
static int name_code(const char *text, size_t length)
{
    if (length == 6 && !memcmp(text, "target", 6))
        return NAME_TARGET;
    if (length == 6 && !memcmp(text, "source", 6))
        return NAME_SOURCE;
    if (length < 2 || length > 9 || text[0] != 's')
        return NAME_OTHER;
    int id = 0;
    for (size_t i = 1; i < length; i++) {
        if (text[i] < '0' || text[i] > '9')
            return NAME_OTHER;
        id = id * 10 + (text[i] - '0');
    }
    return id;
}

/* The constants that mean something to us. The operators that add no ink: those that only erase or keep what is there. */
static const struct {
    const char *name;
    int code;
} constants[] = {
    {"CLEAR", CONST_NO_INK},          {"COLOR_BURN", CONST_BLEND},      {"COLOR_DODGE", CONST_BLEND},
    {"DARKEN", CONST_BLEND},          {"DIFFERENCE", CONST_BLEND},      {"EXCLUSION", CONST_BLEND},
    {"HARD_LIGHT", CONST_BLEND},      {"HSL_COLOR", CONST_BLEND},       {"HSL_HUE", CONST_BLEND},
    {"HSL_LUMINOSITY", CONST_BLEND},  {"HSL_SATURATION", CONST_BLEND},  {"LIGHTEN", CONST_BLEND},
    {"MULTIPLY", CONST_BLEND},        {"OVERLAY", CONST_BLEND},         {"SCREEN", CONST_BLEND},
    {"SOFT_LIGHT", CONST_BLEND},
    {"DEST", CONST_NO_INK},           {"DEST_IN", CONST_NO_INK},
    {"DEST_OUT", CONST_NO_INK},       {"EVEN_ODD", CONST_EVEN_ODD},     {"EXTEND_NONE", CONST_EXTEND_NONE},
    {"EXTEND_PAD", CONST_EXTEND_PAD}, {"EXTEND_REFLECT", CONST_EXTEND_REFLECT}, {"LINE_CAP_BUTT", CONST_BUTT},
    {"LINE_CAP_ROUND", CONST_ROUND},  {"LINE_CAP_SQUARE", CONST_SQUARE},
};

static int constant_code(const char *text, size_t length)
{
    for (size_t i = 0; i < sizeof constants / sizeof *constants; i++)
        if (strlen(constants[i].name) == length && !memcmp(constants[i].name, text, length))
            return constants[i].code;
    return CONST_OTHER;
}

/* ---- tokens ------------------------------------------------------------------------------------------------- */

static int compare_name(const char *name, const token *t)
{
    int order = strncmp(name, t->text, t->length);
    return order ? order : name[t->length] != '\0';
}

/* Binary search in one of the sorted tables. */
static script_operation find_in(const script_operator *table, size_t n, const token *t)
{
    size_t low = 0, high = n;
    while (low < high) {
        size_t middle = (low + high) / 2;
        int order = compare_name(table[middle].name, t);
        if (order == 0)
            return table[middle].run;
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}

static script_operation find_operator(const token *t)
{
    script_operation run = find_in(plb_script_draw_operators, plb_script_draw_count, t);
    return run ? run : find_in(plb_script_object_operators, plb_script_object_count, t);
}

static bool run_name(script_state *s, const token *t)
{
    script_operation run = find_operator(t);
    if (run)
        return run(s);
    int id = name_code(t->text, t->length);
    script_binding *b = id >= 0 ? plb_script_lookup(s, id) : NULL;
    if (b) {
        b->object->references++;
        return plb_script_push_object(s, b->object);
    }
    int shown = t->length > 40 ? 40 : (int)t->length;
    return plb_fail(s->err, ERROR_SYNTAX, "unknown operator %.*s", shown, t->text);
}

/* { ... }: only glyph procedures of bitmap fonts are written like this. */
static bool skip_procedure(script_state *s)
{
    token t;
    for (size_t depth = 1; depth;) {
        if (!plb_scan_next(&s->scan, &t, s->err))
            return false;
        if (t.kind == TOKEN_END)
            return plb_fail(s->err, ERROR_SYNTAX, "a procedure never ends");
        depth += (t.kind == TOKEN_PROC_OPEN) - (size_t)(t.kind == TOKEN_PROC_CLOSE);
    }
    return push_opaque(s);
}

static bool run_token(script_state *s, const token *t)
{
    switch (t->kind) {
    case TOKEN_NUMBER: return plb_script_push(s, (script_value){.kind = VALUE_NUMBER, .number = t->number});
    case TOKEN_NAME: return run_name(s, t);
    case TOKEN_LITERAL: return plb_script_push(s, (script_value){.kind = VALUE_NAME, .code = name_code(t->text, t->length)});
    case TOKEN_IMMEDIATE: return plb_script_push(s, (script_value){.kind = VALUE_CONSTANT, .code = constant_code(t->text, t->length)});
    case TOKEN_ARRAY_OPEN:
    case TOKEN_DICT_OPEN: return plb_script_push(s, (script_value){.kind = VALUE_MARK});
    case TOKEN_ARRAY_CLOSE: return close_array(s);
    case TOKEN_DICT_CLOSE: return close_dictionary(s);
    case TOKEN_PROC_OPEN: return skip_procedure(s);
    case TOKEN_STRING:
    case TOKEN_DATA: return push_opaque(s);
    default: return plb_fail(s->err, ERROR_SYNTAX, "a } without its {");
    }
}

/* ---- the head line ------------------------------------------------------------------------------------------ */

#define HEAD_MAX 400
#define HEAD_WORD "%%Plumbago-tap 1"
enum { HEAD_PLACE = 8, HEAD_NUMBERS = 12 }; /* a page and a matrix; then counts, of which the last may be missing */

/* The first line into `line`; the scanner is set to what follows. */
static bool read_head_line(script_state *s, cairoscript_source *from, char line[HEAD_MAX], size_t *length)
{
    const char *data = NULL;
    size_t size = 0;
    *length = 0;
    while (from->refill(from->closure, &data, &size)) {
        for (size_t i = 0; i < size; i++) {
            if (data[i] == '\n') {
                plb_scan_init(&s->scan, data + i + 1, size - i - 1);
                return true;
            }
            if (*length == HEAD_MAX)
                return plb_fail(s->err, ERROR_SYNTAX, "its first line is too long");
            line[(*length)++] = data[i];
        }
    }
    return plb_fail(s->err, ERROR_SYNTAX, "it is empty");
}

static bool read_head(script_state *s, cairoscript_source *from)
{
    char line[HEAD_MAX];
    size_t length;
    double v[HEAD_NUMBERS] = {0};
    if (!read_head_line(s, from, line, &length))
        return false;
    const char *at = line + strlen(HEAD_WORD), *end = line + length;
    bool ok = length > strlen(HEAD_WORD) && !memcmp(line, HEAD_WORD, strlen(HEAD_WORD));
    for (int i = 0; ok && i < HEAD_NUMBERS; i++)
        ok = (at == end && i == HEAD_NUMBERS - 1) || (at < end && *at == ' ' && plb_parse_number(at + 1, end, &v[i], &at) && isfinite(v[i]));
    if (!ok || !(v[0] > 0) || !(v[1] > 0))
        return plb_fail(s->err, ERROR_SYNTAX, "its first line is not \"" HEAD_WORD "\" and %d numbers", HEAD_NUMBERS - 1);
    s->page->width = v[0];
    s->page->height = v[1];
    memcpy(&s->to_page, v + 2, sizeof s->to_page);
    static const omission_kind kinds[HEAD_NUMBERS - HEAD_PLACE] = {OMISSION_IMAGE, OMISSION_MASK, OMISSION_FILTER, OMISSION_FOREIGN};
    for (int i = HEAD_PLACE; i < HEAD_NUMBERS; i++)
        s->page->omissions.n[kinds[i - HEAD_PLACE]] += (unsigned long)fmin(fmax(v[i], 0), 1e9);
    return true;
}

bool plb_read_cairoscript(cairoscript_source *from, display_list *list, error *err)
{
    error inner = {0};
    script_state s = {.page = list, .err = &inner};
    token t;
    bool ok = read_head(&s, from);
    from->complete = false;
    if (ok) {
        s.scan.refill = from->refill;
        s.scan.closure = from->closure;
    }
    while (ok) {
        ok = plb_scan_next(&s.scan, &t, &inner);
        if (!ok || t.kind == TOKEN_END)
            break;
        ok = run_token(&s, &t);
    }
    int line = s.scan.line + 1;
    plb_script_free(&s);
    from->complete = ok;
    if (ok)
        return true;
    if (inner.kind == ERROR_LIMIT || inner.kind == ERROR_MEMORY)
        return plb_fail(err, inner.kind, "%s", inner.text);
    return plb_fail(err, inner.kind, "line %d: %s", line, inner.text);
}
