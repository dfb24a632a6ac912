/* SPDX-License-Identifier: MIT
 *
 * SVG and SVGZ. tap-plain is asked first where the drawing looks plain: it is fast, knows little, and writes nothing where it
 * knows not all. tap-svg draws all the others by librsvg. Where that refuses or dies there are second tries: malformed XML
 * through a recovery parser, and without text (librsvg 2.54 aborts on some font sizes).
 */
#include "input/tap.h"

#include <string.h>

/* ---- plain drawings ----------------------------------------------------------------------------------------- */

#define PLAIN_LOOK_BYTES ((size_t)1 << 16)

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
    size_t size = in->size < PLAIN_LOOK_BYTES ? in->size : PLAIN_LOOK_BYTES;
    const char *const *word = others;
    while (*word && !holds(in->data, size, *word))
        word++;
    return !*word;
}

/* Where the time of tap-plain was not enough, librsvg's would not be, nor where we could not hold what it wrote. Who said stop
 * waits for neither. */
static bool is_hopeless(const tap *t, const error *why)
{
    if (t->process.end == PROCESS_TIMED_OUT || t->process.end == PROCESS_STOPPED)
        return true;
    bool refused = t->process.end == PROCESS_EXITED && t->process.code != TAP_DONE;
    return !refused && (why->kind == ERROR_LIMIT || why->kind == ERROR_MEMORY);
}

typedef enum { DRAWN, NOT_PLAIN, FAILED } outcome;

static outcome read_plain(const input_source *in, display_list *list, error *err)
{
    tap plain = {.who = "tap-plain", .argv = {"tap-plain"}};
    error why = {ERROR_NONE, ""};
    if (!looks_plain(in))
        return NOT_PLAIN;
    if (plb_tap_read(in, &plain, list, &why))
        return DRAWN;
    if (is_hopeless(&plain, &why)) {
        plb_fail(err, why.kind, "%s", why.text);
        return FAILED;
    }
    plb_log(&in->say, MESSAGE_DETAIL, "%s", why.text);
    return NOT_PLAIN;
}

/* ---- all others --------------------------------------------------------------------------------------------- */

typedef struct {
    bool recover, no_text;
} manner;

static void warn(const input_source *in, manner how, const error *first)
{
    if (how.recover)
        plb_log(&in->say, MESSAGE_WARNING, "%s; drawn as far as it can be read", first->text);
    if (how.no_text)
        plb_log(&in->say, MESSAGE_WARNING, "%s: its text is left out: librsvg cannot set it", in->name);
}

/* The first reason is the one that counts, whatever comes of the second tries. */
static bool read_all(const input_source *in, display_list *list, error *err)
{
    error first = {ERROR_NONE, ""};
    for (manner how = {false, false};;) {
        tap librsvg = {.who = "librsvg", .argv = {"tap-svg"}};
        int n = 1;
        if (how.recover)
            librsvg.argv[n++] = "--recover";
        if (how.no_text)
            librsvg.argv[n++] = "--no-text";
        if (plb_tap_read(in, &librsvg, list, &first)) {
            warn(in, how, &first);
            return true;
        }
        if (plb_tap_ended_with(&librsvg, TAP_MALFORMED) && !how.recover)
            how.recover = true;
        else if (librsvg.crashed && !how.no_text)
            how.no_text = true;
        else
            return plb_fail(err, first.kind, "%s", first.text);
    }
}

bool plb_read_svg(const input_source *in, display_list *list, error *err)
{
    outcome plain = read_plain(in, list, err);
    return plain == NOT_PLAIN ? read_all(in, list, err) : plain == DRAWN;
}
