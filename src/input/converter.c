/* SPDX-License-Identifier: MIT
 *
 * See converter.h.
 */
#include "input/converter.h"

#include <string.h>

/* tap-svg exits with the first status when it has no memory (tap_memory.h), every program with the second when its libraries cannot be
 * loaded. */
enum { OUT_OF_MEMORY = 125, CANNOT_START = 127 };

static bool ran_out_of_memory(const process *p)
{
    static const char *const words[] = {
        "memory allocation of", "failed to allocate", "ut of memory", "VMerror", /* Rust, libraries, Ghostscript */
        "failed to map segment", "annot allocate", "cannot map",                 /* the loader */
        "Error creating thread",                                                 /* GLib: no room for its stack */
        NULL,
    };
    if (p->end == PROCESS_EXITED && p->code != OUT_OF_MEMORY && p->code != CANNOT_START)
        return false;
    for (int i = 0; words[i]; i++)
        if (strstr(p->message, words[i]))
            return true;
    return false;
}

bool plb_converter_ended_by_itself(const input_source *in, const char *who, const process *p, error *err)
{
    if (p->end == PROCESS_STOPPED)
        return plb_fail(err, ERROR_CANCELLED, "%s: stopped", in->name);
    if (p->end == PROCESS_OVERSTEPPED)
        return plb_fail(err, p->fault.kind, "%s: %s %s", in->name, who, p->fault.text);
    if (p->end == PROCESS_TIMED_OUT)
        return plb_fail(err, ERROR_LIMIT, "%s: %s needs more than %g seconds for this drawing", in->name, who, p->limits.seconds);
    if (ran_out_of_memory(p))
        return plb_fail(err, ERROR_LIMIT, "%s: %s needs more than %zu MB for this drawing", in->name, who, p->limits.memory >> 20);
    if (p->end == PROCESS_CRASHED)
        return plb_fail(err, ERROR_HELPER, "%s: %s dies on this drawing (signal %d)", in->name, who, p->code);
    return true;
}

const char *plb_converter_message(process *p)
{
    char *text = p->message;
    text[strcspn(text, "\n")] = '\0';
    size_t n = strlen(text);
    while (n && text[n - 1] == ' ')
        text[--n] = '\0';
    for (; *text; text++)
        if (*text < ' ' || *text > '~')
            *text = '?';
    return p->message;
}

bool plb_converter_start(const input_source *in, const char *who, const char *program, const char *const argv[], process *p, error *err)
{
    if (!plb_process_start(p, program, argv, in->data, in->size, &in->limits, err))
        return false;
    plb_log(&in->say, MESSAGE_DETAIL, "%s: %s reads it, caged by %s (%g s, %zu MiB)", in->name, who, p->cage, p->limits.seconds, p->limits.memory >> 20);
    return true;
}

bool plb_converter_run(const input_source *in, const char *who, const char *program, const char *const argv[], process *p,
                    converter_bytes *out, error *err)
{
    error why = {0};
    input_source alone = *in;
    alone.limits.single = true;
    if (!plb_converter_start(&alone, who, program, argv, p, &why))
        return plb_fail(err, why.kind, "%s: %s", in->name, why.text);
    const char *data;
    size_t n;
    while (why.kind == ERROR_NONE && plb_process_read(p, &data, &n)) {
        if (out->n + n > INPUT_MAX_BYTES)
            plb_fail(&why, ERROR_LIMIT, "%s writes more than %zu MB for this drawing", who, INPUT_MAX_BYTES >> 20);
        else if (!array_reserve(out, n))
            plb_fail_memory(&why);
        else
            memcpy(out->v + out->n, data, n), out->n += n;
    }
    plb_process_finish(p);
    if (why.kind)
        return plb_fail(err, why.kind, "%s: %s", in->name, why.text);
    return plb_converter_ended_by_itself(in, who, p, err);
}
