/* SPDX-License-Identifier: MIT
 *
 * The scanner: every kind of token, the same tokens whatever the chunks the bytes come in, line numbers, errors.
 */
#include "base/number/number.h"
#include "check.h"
#include "tap/common/scan.h"

/* All tokens of a text as one line of text: "n:1.5 x:add l:name s:(abc) [ ] { } << >>". */
static char shown[4096];

static void show(const char *format, const char *text, size_t length)
{
    size_t n = strlen(shown);
    snprintf(shown + n, sizeof shown - n, format, (int)length, text ? text : "");
}

static void show_token(const token *t)
{
    static const char *const brackets[] = {
        [TOKEN_DATA] = "data", [TOKEN_ARRAY_OPEN] = "[", [TOKEN_ARRAY_CLOSE] = "]", [TOKEN_PROC_OPEN] = "{",
        [TOKEN_PROC_CLOSE] = "}", [TOKEN_DICT_OPEN] = "<<", [TOKEN_DICT_CLOSE] = ">>",
    };
    char number[48];
    if (shown[0])
        strcat(shown, " ");
    switch (t->kind) {
    case TOKEN_NUMBER:
        plb_format_number(number, t->number, 6);
        show(t->integer ? "i:%.*s" : "r:%.*s", number, strlen(number));
        break;
    case TOKEN_NAME: show("x:%.*s", t->text, t->length); break;
    case TOKEN_LITERAL: show("l:%.*s", t->text, t->length); break;
    case TOKEN_IMMEDIATE: show("m:%.*s", t->text, t->length); break;
    case TOKEN_STRING: show("s:(%.*s)", t->text, t->length); break;
    default: show("%.*s", brackets[t->kind], strlen(brackets[t->kind]));
    }
}

/* Hands out `rest` in pieces of `step` bytes, each in a fresh block, so that a stale pointer is seen by a sanitiser. */
typedef struct {
    const char *rest;
    size_t left, step;
    char *block;
} pieces;

static bool next_piece(void *closure, const char **data, size_t *size)
{
    pieces *p = closure;
    free(p->block);
    p->block = NULL;
    if (!p->left)
        return false;
    size_t n = p->left < p->step ? p->left : p->step;
    p->block = malloc(n);
    memcpy(p->block, p->rest, n);
    p->rest += n;
    p->left -= n;
    *data = p->block;
    *size = n;
    return true;
}

/* The tokens of `text` in pieces of `step` bytes (0: all at once); NULL after an error, whose text is in `fault`. */
static error fault;
static int last_line;

static const char *scan_sized(const char *text, size_t size, size_t step)
{
    scanner s;
    pieces p = {text, size, step, NULL};
    token t;
    bool good;
    shown[0] = '\0';
    plb_error_clear(&fault);
    plb_scan_init(&s, text, step ? 0 : size);
    if (step) {
        s.refill = next_piece;
        s.closure = &p;
    }
    while ((good = plb_scan_next(&s, &t, &fault)) && t.kind != TOKEN_END)
        show_token(&t);
    last_line = s.line;
    plb_scan_free(&s);
    free(p.block);
    return good ? shown : NULL;
}

static bool scans_to(const char *text, const char *expected)
{
    for (size_t step = 0; step < 9; step++) {
        const char *got = scan_sized(text, strlen(text), step);
        if (!got || strcmp(got, expected)) {
            printf("# step %zu: got %s, expected %s\n", step, got ? got : fault.text, expected);
            return false;
        }
    }
    return true;
}

static bool fails_with(const char *text, const char *words, int line)
{
    for (size_t step = 0; step < 5; step++)
        if (scan_sized(text, strlen(text), step) || !strstr(fault.text, words) || last_line != line) {
            printf("# step %zu: %s, line %d\n", step, fault.text, last_line);
            return false;
        }
    return true;
}

static void numbers_are_read(void)
{
    CHECK(scans_to("1 -2 +3 007", "i:1 i:-2 i:3 i:7"));
    CHECK(scans_to("1.5 -.5 +.25 5. 1e3 -2.5E-2", "r:1.5 r:-0.5 r:0.25 r:5 r:1000 r:-0.025"));
    CHECK(scans_to("16#FF 8#17 2#101 36#z 16#FFFFFFFF", "i:255 i:15 i:5 i:35 i:-1"));
}

static void words_that_are_no_numbers_are_names(void)
{
    CHECK(scans_to("- + . -- 1e 1.2.3 3! 1-2 37#1 16#G 2#", "x:- x:+ x:. x:-- x:1e x:1.2.3 x:3! x:1-2 x:37#1 x:16#G x:2#"));
}

static void the_fast_path_agrees_with_the_base(void)
{
    static const char *const texts[] = {"0.1", "-0", "123456.789012", "99999999999999999", "0.00000000000000001", "3.14159265358979"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        char text[64];
        double expected = 0;
        CHECK(plb_parse_number(texts[i], texts[i] + strlen(texts[i]), &expected, NULL));
        snprintf(text, sizeof text, "%s ", texts[i]);
        scanner s;
        token t;
        plb_scan_init(&s, text, strlen(text));
        CHECK(plb_scan_next(&s, &t, NULL) && t.kind == TOKEN_NUMBER);
        CHECK(memcmp(&t.number, &expected, sizeof expected) == 0);
        plb_scan_free(&s);
    }
}

static void names_are_read(void)
{
    CHECK(scans_to("add /def //now / /a/b", "x:add l:def m:now l: l:a l:b"));
    CHECK(scans_to("a[b]c{d}<</e>>", "x:a [ x:b ] x:c { x:d } << l:e >>"));
    CHECK(scans_to("stroke+ $error @x", "x:stroke+ x:$error x:@x"));
}

static void strings_are_decoded(void)
{
    CHECK(scans_to("(abc) (a(b)c) ()", "s:(abc) s:(a(b)c) s:()"));
    CHECK(scans_to("(a\\)b\\\\c\\(d)", "s:(a)b\\c(d)"));
    CHECK(scans_to("(\\101\\60x\\1012\\q)", "s:(A0xA2q)"));
    CHECK(scans_to("(a\\\nb\\\r\nc)", "s:(abc)"));
    CHECK(scans_to("(a\rb\r\nc\\n)", "s:(a\nb\nc\n)"));
    CHECK(scans_to("<48 65 6c\n6C 6F> <4> <>", "s:(Hello) s:(@) s:()"));
    CHECK(scans_to("<~87cURD]i,\"Ebo80~> <~87cURD]i,\"Ebo7~> <~~>", "s:(Hello World!) s:(Hello World) s:()"));
    CHECK(scans_to("<|xyz ( ~ not yet~>next", "data x:next"));
}

static void blanks_and_comments_are_skipped(void)
{
    CHECK(scans_to("a%comment ( \nb%x\rc\f\td%end", "x:a x:b x:c x:d"));
    CHECK(scan_sized("a\0b\4c", 5, 0) && !strcmp(shown, "x:a x:b x:c"));
    CHECK(scans_to("", "") && scans_to(" % only", ""));
}

static void lines_are_counted(void)
{
    static const char *const texts[] = {"a\nb\nc", "a\rb\rc", "a\r\nb\r\nc", "a%x\n\nc", "(\n)\nc", "(\\\r\n)\r\nc", "<0\n0>\nc"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        for (size_t step = 0; step < 5; step++) {
            CHECK(scan_sized(texts[i], strlen(texts[i]), step));
            CHECK_RANGE(last_line, 3, 3);
        }
}

static void one_blank_belongs_to_the_word_before(void)
{
    static const char text[] = "image\r\n data";
    scanner s;
    token t;
    plb_scan_init(&s, text, strlen(text));
    CHECK(plb_scan_next(&s, &t, NULL) && t.kind == TOKEN_NAME);
    CHECK(s.at == text + 7);
    plb_scan_free(&s);
}

static void faults_are_named(void)
{
    CHECK(fails_with("a\n(b\nc", "never ends", 2));
    CHECK(fails_with("\n\n<12", "never ends", 3));
    CHECK(fails_with("<12x>", "no digit", 1));
    CHECK(fails_with("<~ab", "never ends", 1));
    CHECK(fails_with("<~a~>", "single digit", 1));
    CHECK(fails_with("<~uuuuu~>", "too large", 1));
    CHECK(fails_with("<~ab~x", "does not end", 1));
    CHECK(fails_with("a )", "without", 1));
    CHECK(fails_with("a > b", "without", 1));
    CHECK(fails_with("<|abc", "never end", 1));
}

static void a_long_name_is_refused(void)
{
    size_t n = SCAN_MAX_TOKEN + 3;
    char *text = malloc(n);
    memset(text, 'x', n);
    CHECK(!scan_sized(text, n, 0) && fault.kind == ERROR_LIMIT);
    CHECK(!scan_sized(text, n, 4096) && fault.kind == ERROR_LIMIT);
    text[0] = '(';
    text[n - 1] = ')';
    CHECK(!scan_sized(text, n, 4096) && fault.kind == ERROR_LIMIT);
    free(text);
}

int main(void)
{
    RUN(numbers_are_read);
    RUN(words_that_are_no_numbers_are_names);
    RUN(the_fast_path_agrees_with_the_base);
    RUN(names_are_read);
    RUN(strings_are_decoded);
    RUN(blanks_and_comments_are_skipped);
    RUN(lines_are_counted);
    RUN(one_blank_belongs_to_the_word_before);
    RUN(faults_are_named);
    RUN(a_long_name_is_refused);
    CHECK_EXIT;
}
