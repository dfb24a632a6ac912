/* SPDX-License-Identifier: MIT
 *
 * PostScript files of this folder, NAME.ps, give the display lists written beside them, NAME.list.
 * With ACCEPT set in the environment the lists are written again: look at the difference before keeping it.
 */
#include "check.h"
#include "tap/ps/postscript.h"
#include "list/text/list_write.h"

#define MOST ((size_t)1 << 20)

static size_t load(const char *name, char *out)
{
    FILE *f = fopen(name, "rb");
    size_t n = f ? fread(out, 1, MOST, f) : 0;
    if (f)
        fclose(f);
    return n;
}

static bool print(const display_list *list, const char *name)
{
    FILE *f = fopen(name, "wb");
    bool good = f && plb_list_print(list, f);
    return f && fclose(f) == 0 && good;
}

/* Reads NAME.ps and prints its list into the file `to`. */
static bool convert(const char *from, const char *to)
{
    static char program[MOST];
    display_list list;
    error err = {0};
    ps_request ask = {.data = program, .size = load(from, program), .alone = true};
    ps_answer answer;
    plb_list_init(&list);
    bool good = plb_ps_read(&ask, &list, &answer, &err) == PS_DRAWN && print(&list, to);
    if (!good)
        printf("# %s\n", err.text);
    plb_list_free(&list);
    return good;
}

static bool comes_as_expected(const char *name)
{
    static char expected[MOST], got[MOST];
    const char *root = getenv("ROOT");
    char from[600], wanted[600];
    snprintf(from, sizeof from, "%s/tests/stage/%s.ps", root ? root : ".", name);
    snprintf(wanted, sizeof wanted, "%s/tests/stage/%s.list", root ? root : ".", name);
    if (getenv("ACCEPT"))
        return convert(from, wanted);
    if (!convert(from, "got.list"))
        return false;
    size_t n = load(wanted, expected), m = load("got.list", got);
    remove("got.list");
    return n > 0 && n == m && !memcmp(expected, got, n);
}

static void shapes(void) { CHECK(comes_as_expected("shapes")); }
static void procedures(void) { CHECK(comes_as_expected("procedures")); }
static void clips(void) { CHECK(comes_as_expected("clips")); }
static void hatching(void) { CHECK(comes_as_expected("hatching")); }
static void letters(void) { CHECK(comes_as_expected("letters")); }

int main(void)
{
    RUN(shapes);
    RUN(procedures);
    RUN(clips);
    RUN(hatching);
    RUN(letters);
    CHECK_EXIT;
}
