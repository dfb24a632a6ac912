/* SPDX-License-Identifier: MIT
 *
 * Reads CairoScript token by token through the tables of operators. There is no recursion and no loop in the language,
 * only a stack.
 */
#include "tap/svg/cairoscript.h"

#include "tap/svg/cairoscript_state.h"

#include <string.h>

/* ---- brackets ----------------------------------------------------------------------------------------------- */

static bool push_opaque(script_state *s) { return plb_script_push(s, (script_value){.kind = VALUE_OPAQUE}); }

/* Gives the index of the first value above the topmost mark. */
static bool find_mark(script_state *s, size_t *first)
{
    size_t i = s->stack.n;
    while (i && s->stack.v[i - 1].kind != VALUE_MARK)
        i--;
    *first = i;
    return i > 0 || plb_fail(s->err, ERROR_SYNTAX, "a bracket closes that never opened");
}

/* Does ]: keeps the numbers since the mark; an array of anything else is of no use here. */
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

/* Does >>: drops the dictionary, of which nothing is of use here. */
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

/* Gives the code of a name: "s12" is 12; others have a code below zero. */
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

/* These constants mean something to the reader. The operators that add no ink are those that only erase or keep what is there. */
static const struct {
    const char *name;
    int code;
} constants[] = {
    {"CLEAR", CONST_NO_INK},          {"COLOR_BURN", CONST_BLEND},      {"COLOR_DODGE", CONST_BLEND},
    {"DARKEN", CONST_MULTIPLY},          {"DIFFERENCE", CONST_BLEND},      {"EXCLUSION", CONST_BLEND},
    {"HARD_LIGHT", CONST_BLEND},      {"HSL_COLOR", CONST_BLEND},       {"HSL_HUE", CONST_BLEND},
    {"HSL_LUMINOSITY", CONST_BLEND},  {"HSL_SATURATION", CONST_BLEND},  {"LIGHTEN", CONST_BLEND},
    {"MULTIPLY", CONST_MULTIPLY},        {"OVERLAY", CONST_BLEND},         {"SCREEN", CONST_BLEND},
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

/* Finds a name in one of the sorted tables by binary search. */
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

/* Passes over { ... }: only glyph procedures of bitmap fonts are written so. */
static bool pass_over(script_state *s, const token *t)
{
    s->procedures += t->kind == TOKEN_PROC_OPEN;
    s->procedures -= t->kind == TOKEN_PROC_CLOSE;
    return s->procedures || push_opaque(s);
}

static bool run_token(script_state *s, const token *t)
{
    if (s->procedures || t->kind == TOKEN_PROC_OPEN)
        return pass_over(s, t);
    switch (t->kind) {
    case TOKEN_NUMBER: return plb_script_push(s, (script_value){.kind = VALUE_NUMBER, .number = t->number});
    case TOKEN_NAME: return run_name(s, t);
    case TOKEN_LITERAL: return plb_script_push(s, (script_value){.kind = VALUE_NAME, .code = name_code(t->text, t->length)});
    case TOKEN_IMMEDIATE: return plb_script_push(s, (script_value){.kind = VALUE_CONSTANT, .code = constant_code(t->text, t->length)});
    case TOKEN_ARRAY_OPEN:
    case TOKEN_DICT_OPEN: return plb_script_push(s, (script_value){.kind = VALUE_MARK});
    case TOKEN_ARRAY_CLOSE: return close_array(s);
    case TOKEN_DICT_CLOSE: return close_dictionary(s);
    case TOKEN_STRING:
    case TOKEN_DATA: return push_opaque(s);
    default: return plb_fail(s->err, ERROR_SYNTAX, "a } without its {");
    }
}

/* ---- pieces of text ----------------------------------------------------------------------------------------- */

#define SCRIPT_PART_BYTES ((size_t)1 << 16)

/* Answers the scanner, which wants more than there is. */
static bool note_end(void *closure, const char **data, size_t *size)
{
    (void)data, (void)size;
    *(bool *)closure = true;
    return false;
}

/* Runs the tokens of s->text. A token that reaches the end may go on in the next part: unless this is the last, the
 * token is left, to be scanned again. */
static bool run_part(script_state *s, bool is_last, error *err)
{
    scanner *in = &s->scan;
    token t;
    bool at_end = false;
    in->at = s->text.v;
    in->end = s->text.v + s->text.n;
    in->closure = &at_end;
    for (;;) {
        const char *start = in->at;
        int line = in->next_line;
        in->refill = note_end;
        bool ok = plb_scan_next(in, &t, err);
        if (at_end && !is_last) {
            in->at = start;
            in->next_line = line;
            return true;
        }
        if (!ok || (t.kind != TOKEN_END && !run_token(s, &t)))
            return false;
        if (t.kind == TOKEN_END)
            return !s->procedures || plb_fail(err, ERROR_SYNTAX, "a procedure never ends");
    }
}

/* Tells where in the text an error is, unless the text is not to blame. */
static bool run(script_state *s, bool is_last, error *err)
{
    error inner = {0};
    s->err = &inner;
    bool ok = run_part(s, is_last, &inner);
    s->err = NULL;
    if (ok)
        return true;
    if (inner.kind == ERROR_LIMIT || inner.kind == ERROR_MEMORY)
        return plb_fail(err, inner.kind, "%s", inner.text);
    return plb_fail(err, inner.kind, "line %d: %s", s->scan.line, inner.text);
}

cairoscript *plb_cairoscript_new(list_writer *out, double width, double height, matrix to_page)
{
    script_state *s = plb_new(1, sizeof *s);
    if (!s)
        return NULL;
    plb_list_init(&s->page);
    s->page.width = width;
    s->page.height = height;
    s->to_page = to_page;
    s->out = out;
    s->written = to_page;
    s->part = SCRIPT_PART_BYTES;
    plb_scan_init(&s->scan, "", 0);
    return s;
}

void plb_cairoscript_listen(cairoscript *s, text_run *(*say)(void *closure, const path *p), void *closure)
{
    s->say = say;
    s->say_closure = closure;
}

bool plb_cairoscript_feed(cairoscript *s, const char *data, size_t n, error *err)
{
    if (!array_reserve(&s->text, n))
        return plb_fail_memory(err);
    memcpy(s->text.v + s->text.n, data, n);
    s->text.n += n;
    if (s->text.n < s->part)
        return true;
    if (!run(s, false, err))
        return false;
    size_t left = (size_t)(s->scan.end - s->scan.at);
    memmove(s->text.v, s->scan.at, left);
    s->text.n = left;
    /* A long token is tried again when there is twice as much of it: time stays in proportion. */
    s->part = 2 * left > SCRIPT_PART_BYTES ? 2 * left : SCRIPT_PART_BYTES;
    return true;
}

bool plb_cairoscript_end(cairoscript *s, omissions *lost, error *err)
{
    bool ok = run(s, true, err);
    s->text.n = 0;
    for (int k = 0; k < OMISSION_KINDS; k++)
        lost->n[k] += s->page.omissions.n[k];
    return ok;
}

void plb_cairoscript_free(cairoscript *s)
{
    plb_script_free(s);
    plb_list_free(&s->page);
    plb_free(s);
}
