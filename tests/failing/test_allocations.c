/* SPDX-License-Identifier: MIT
 *
 * The n-th allocation fails, for every n (`whole`), or for some, until none does any more: each time there is an error that says so, or the
 * same result as ever, no crash, and (this build has the address sanitizer) no leak. With BUILD=failing only.
 *
 *     test_allocations FOLDER-OF-HELPERS FOLDER-OF-DRAWINGS [whole]
 */
#include "check.h"

#include "api/plumbago.h"
#include "base/array.h"
#include "input/input.h"
#include "plan/plan.h"
#include "profile/profile.h"
#include "tap/ps/postscript.h"

#include <sanitizer/common_interface_defs.h>
#include <stdatomic.h>
#include <unistd.h>

#define MOST 200000 /* allocations of one case; more mean that it never ends */

static atomic_long until_failure; /* allocations that succeed before one fails; negative: all do */
static bool and_all_later;
static bool whole; /* each allocation fails once, not some of them */
static const char *helpers, *drawings;
static long failures, current; /* the n of the allocation that fails; SHOW=n prints where */

bool plb_test_may_allocate(void);
bool plb_test_may_allocate(void)
{
    long left = atomic_fetch_sub(&until_failure, 1);
    if (left == 0 && getenv("SHOW") && atol(getenv("SHOW")) == current)
        __sanitizer_print_stack_trace();
    return left > 0 || (left < 0 && !(and_all_later && left > -MOST));
}


typedef enum { CAME_OFF, OUT_OF_MEMORY, OTHER_ERROR } outcome;

static outcome outcome_of(bool good, const error *err)
{
    return good ? CAME_OFF : err->kind == ERROR_MEMORY ? OUT_OF_MEMORY : OTHER_ERROR;
}

#define FIRST_ALLOCATIONS 40 /* fail one after the other, also where only some of those that follow are tried */

/* Runs `once` with the n-th allocation failing, n = 1, 2, ... and later every step-th, until `once` comes off without having
 * met one that fails. */
static void fail_each(outcome (*once)(const void *), const void *what, long step, long *tried)
{
    for (long n = 0; n < MOST; n += n < FIRST_ALLOCATIONS ? 1 : step) {
        atomic_store(&until_failure, n);
        current = n + 1;
        outcome result = once(what);
        bool met = atomic_load(&until_failure) < 0;
        atomic_store(&until_failure, -2L * MOST);
        CHECK(result != OTHER_ERROR);
        if (!met) {
            CHECK(result == CAME_OFF);
            *tried = n;
            return;
        }
        failures++;
        if (check_failed) {
            printf("  allocation %ld\n", n + 1);
            return;
        }
    }
    CHECK(!"it never comes off");
}

/* Lets one allocation fail, and then: all that follow fail too, as when memory is gone. `every` is the step of a whole run; a
 * short one takes `stride` as many, a prime that differs by the case, so that different places fail in each. */
static void fail_each_way(outcome (*once)(const void *), const void *what, long every, long stride)
{
    long tried = 0, step = whole ? every : every * stride;
    atomic_store(&until_failure, -2L * MOST);
    CHECK(once(what) == CAME_OFF);
    for (int way = 0; way < 2 && !check_failed; way++) {
        and_all_later = way;
        fail_each(once, what, step, &tried);
        CHECK(tried > 0 || check_failed);
    }
    and_all_later = false;
}

/* ---- the cases ---- */

static outcome draw(const void *what)
{
    char file[4096];
    snprintf(file, sizeof file, "%s/%s", drawings, (const char *)what);
    plb_options *o = plb_options_new();
    if (!o)
        return OUT_OF_MEMORY;
    plb_error failed = {PLB_OK, ""};
    /* hatching draws samples first: many allocations */
    bool set = plb_options_set(o, "helper-dir", helpers, &failed) && plb_options_set(o, "dpi", "72", &failed) &&
               plb_options_set(o, "threads", "1", &failed) && plb_options_set(o, "fill", strstr(file, "hatch") ? "hatch" : "outline", &failed);
    plb_drawing *d = set ? plb_drawing_load(file, o, &failed) : NULL;
    bool good = d && plb_drawing_write_png(d, "out.png", o, &failed);
    plb_drawing_free(d);
    plb_options_free(o);
    if (!good)
        CHECK(access("out.png", F_OK) != 0);
    unlink("out.png");
    return good ? CAME_OFF : failed.status == PLB_ERROR_MEMORY ? OUT_OF_MEMORY : (printf("  %s\n", failed.text), OTHER_ERROR);
}
static void svg(void) { fail_each_way(draw, "small.svg", 1, 13); }
static void postscript(void) { fail_each_way(draw, "small.ps", 1, 17); }
static void list_text(void) { fail_each_way(draw, "small.list", 1, 11); }
static void hatching(void) { fail_each_way(draw, "hatch.list", 101, 7); }

static outcome interpret(const void *what)
{
    static char program[4096];
    char file[4096];
    snprintf(file, sizeof file, "%s/%s", drawings, (const char *)what);
    FILE *from = fopen(file, "rb");
    size_t n = from ? fread(program, 1, sizeof program, from) : 0;
    if (from)
        fclose(from);
    error err = {ERROR_NONE, ""};
    display_list list;
    ps_answer answer;
    ps_request ask = {.data = program, .size = n};
    plb_list_init(&list);
    bool good = plb_ps_read(&ask, &list, &answer, &err) == PS_DRAWN && list.items.n == 3;
    plb_list_free(&list);
    return outcome_of(good, &err);
}
static void interpreter(void) { fail_each_way(interpret, "small.ps", 1, 17); }
static void dxf(void) { fail_each_way(draw, "small.dxf", 1, 19); }

static outcome read_profile(const void *what)
{
    error err = {ERROR_NONE, ""};
    profile *p = plb_profile_read(what, &err);
    size_t n = 0;
    unsigned char *bytes = p ? plb_profile_serialise(p, &n, &err) : NULL;
    bool good = bytes != NULL;
    plb_free(bytes);
    plb_profile_release(p);
    return outcome_of(good, &err);
}
static void profile_file(void) { fail_each_way(read_profile, "6B", 1, 5); }

static outcome capture(const void *what)
{
    char file[4096];
    snprintf(file, sizeof file, "%s/%s", drawings, (const char *)what);
    const char *files[] = {file};
    capture_options how = plb_capture_defaults();
    error err = {ERROR_NONE, ""};
    profile *p = plb_capture(files, 1, &how, &err);
    plb_profile_release(p);
    if (!p && err.kind != ERROR_MEMORY)
        printf("  %s\n", err.text);
    return outcome_of(p != NULL, &err);
}
static void scan(void) { fail_each_way(capture, "scan.png", 1, 11); }

int main(int argc, char **argv)
{
    if (argc < 3)
        return 2;
    helpers = argv[1];
    drawings = argv[2];
    whole = argc > 3;
    RUN(svg);
    RUN(postscript);
    RUN(list_text);
    RUN(interpreter);
    RUN(hatching);
    RUN(dxf);
    RUN(profile_file);
    RUN(scan);
    fprintf(stderr, "%ld allocations failed\n", failures);
    CHECK_EXIT;
}
