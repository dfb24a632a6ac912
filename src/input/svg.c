/* SPDX-License-Identifier: MIT
 *
 * SVG and SVGZ: a helper program draws, the display list that it writes is read while it runs. tap-plain is asked first where the drawing looks
 * plain: it is fast, knows little, and writes nothing where it knows not all. tap-svg draws all the others by librsvg.
 * Where that refuses or dies there are second tries: malformed XML through a recovery parser, and without text (librsvg
 * 2.54 aborts on some font sizes).
 */
#include "input/input.h"

#include "input/converter.h"
#include "list/list_read.h"

#include <stdlib.h>
#include <string.h>

typedef enum { DONE, MALFORMED, CRASHED, FAILED } outcome;
enum { TAP_DONE, TAP_USAGE, TAP_MALFORMED, TAP_REFUSED, TAP_WRITE, TAP_LIMIT }; /* see tap_svg.c */

typedef struct {
    bool recover, no_text;
} manner;

static bool refill(void *closure, const char **data, size_t *size)
{
    return plb_process_read(closure, data, size);
}

/* The tap's message, one line; libxml2's line number is moved to the front, where it belongs. */
static bool fail_with_message(const input_source *in, error_kind kind, char *message, error *err)
{
    static const char where[] = " on line ", what[] = " of data: ";
    message[strcspn(message, "\n")] = '\0';
    size_t n = strlen(message);
    while (n && message[n - 1] == ' ')
        message[--n] = '\0';
    const char *line = strstr(message, where), *text = line ? strstr(line, what) : NULL;
    if (!text)
        return plb_fail(err, kind, "%s: %s", in->name, *message ? message : "tap-svg gave up without a word");
    text += strlen(what);
    return plb_fail(err, kind, "%s:%ld: not well-formed XML: %s", in->name, strtol(line + strlen(where), NULL, 10), text);
}

/* Says why the process did not succeed. */
static outcome explain_end(const input_source *in, process *p, error *err)
{
    error why = {0};
    if (!plb_converter_ended_by_itself(in, "librsvg", p, &why)) {
        plb_fail(err, why.kind, "%s", why.text);
        return why.kind == ERROR_HELPER ? CRASHED : FAILED;
    }
    static const error_kind kinds[] = {[TAP_MALFORMED] = ERROR_SYNTAX, [TAP_REFUSED] = ERROR_UNSUPPORTED, [TAP_LIMIT] = ERROR_LIMIT};
    error_kind kind = p->code <= TAP_LIMIT ? kinds[p->code] : ERROR_NONE;
    if (kind)
        fail_with_message(in, kind, p->message, err);
    else
        plb_fail(err, ERROR_HELPER, "%s: the helper tap-svg failed (status %d): %.200s", in->name, p->code, p->message);
    return p->code == TAP_MALFORMED ? MALFORMED : FAILED;
}

static outcome run_tap(const input_source *in, const char *program, manner how, display_list *list, error *err)
{
    const char *argv[4] = {"tap-svg"};
    int n = 1;
    if (how.recover)
        argv[n++] = "--recover";
    if (how.no_text)
        argv[n++] = "--no-text";
    argv[n] = NULL;
    process p;
    error reading = {0};
    if (!plb_converter_start(in, "librsvg", program, argv, &p, &reading)) {
        plb_fail(err, reading.kind, "%s: %s", in->name, reading.text);
        return FAILED;
    }
    list_source from = {.refill = refill, .closure = &p, .name = in->name, .say = in->say};
    plb_list_read(&from, list, &reading);
    bool stopped_early = !from.complete && p.out >= 0;
    plb_process_finish(&p);
    if (!stopped_early && (p.end != PROCESS_EXITED || p.code != TAP_DONE))
        return explain_end(in, &p, err);
    if (!from.complete) {
        bool plain = reading.kind == ERROR_LIMIT || reading.kind == ERROR_MEMORY;
        if (plain)
            plb_fail(err, reading.kind, "%s: %s", in->name, reading.text);
        else
            plb_fail(err, reading.kind, "%s: cannot read what tap-svg wrote, line %lu: %s", in->name, from.line, reading.text);
        return FAILED;
    }
    return DONE;
}

static void warn(const input_source *in, manner how, const error *first)
{
    if (how.recover)
        plb_log(&in->say, MESSAGE_WARNING, "%s; drawn as far as it can be read", first->text);
    if (how.no_text)
        plb_log(&in->say, MESSAGE_WARNING, "%s: its text is left out: librsvg cannot set it", in->name);
}

/* ---- plain drawings ----------------------------------------------------------------------------------------- */

#define LOOK_BYTES ((size_t)1 << 16)

static bool holds(const char *data, size_t size, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = data; size >= n && (at = memchr(at, word[0], size - n + 1 - (size_t)(at - data))); at++)
        if (!memcmp(at, word, n))
            return true;
        else if (at + n == data + size)
            break;
    return false;
}

/* False: tap-plain would refuse it, as far as one can see at its start. */
static bool looks_plain(const input_source *in)
{
    static const char *const others[] = {"<text", "<use", "<style", "<image", "<clipPath", "<symbol", "url(", "\x1f\x8b", NULL};
    size_t size = in->size < LOOK_BYTES ? in->size : LOOK_BYTES;
    const char *const *word = others;
    while (*word && !holds(in->data, size, *word))
        word++;
    return !*word;
}

/* Where its time was not enough, librsvg's would not be, nor where we could not hold what it wrote. */
static bool is_hopeless(const input_source *in, const process *p, const error *reading, error *err)
{
    if (p->end == PROCESS_TIMED_OUT)
        return !plb_converter_ended_by_itself(in, "tap-plain", p, err);
    return (reading->kind == ERROR_LIMIT || reading->kind == ERROR_MEMORY) && !plb_fail(err, reading->kind, "%s: %s", in->name, reading->text);
}

/* MALFORMED: it is not plain, `list` is as it was, and tap-svg is to be asked. */
static outcome read_plain(const input_source *in, display_list *list, error *err)
{
    static const char *const argv[] = {"tap-plain", NULL};
    char program[PROCESS_PATH_MAX];
    process p;
    error why = {0};
    if (!looks_plain(in) || !plb_process_find(in->helper_dir, argv[0], program, &why) || !plb_converter_start(in, argv[0], program, argv, &p, &why))
        return MALFORMED;
    list_source from = {.refill = refill, .closure = &p, .name = in->name, .say = in->say};
    plb_list_read(&from, list, &why);
    plb_process_finish(&p);
    if (from.complete && p.end == PROCESS_EXITED && p.code == 0)
        return DONE;
    plb_list_free(list);
    plb_list_init(list);
    if (is_hopeless(in, &p, &why, err))
        return FAILED;
    plb_log(&in->say, MESSAGE_DETAIL, "%s: %s", in->name, p.end == PROCESS_EXITED && p.code ? plb_converter_message(&p) : why.text);
    return MALFORMED;
}

bool plb_read_svg(const input_source *in, display_list *list, error *err)
{
    char program[PROCESS_PATH_MAX];
    error first = {0};
    outcome plain = read_plain(in, list, err);
    if (plain != MALFORMED)
        return plain == DONE;
    if (!plb_process_find(in->helper_dir, "tap-svg", program, &first))
        return plb_fail(err, first.kind, "%s: %s", in->name, first.text);
    manner how = {false, false};
    for (;;) {
        outcome result = run_tap(in, program, how, list, &first);
        if (result == DONE) {
            warn(in, how, &first);
            return true;
        }
        plb_list_free(list);
        plb_list_init(list);
        if (result == MALFORMED && !how.recover)
            how.recover = true;
        else if (result == CRASHED && !how.no_text)
            how.no_text = true;
        else
            return plb_fail(err, first.kind, "%s", first.text);
    }
}
