/* SPDX-License-Identifier: MIT
 *
 * A converter is a foreign program that turns one format into another: bytes go in, bytes come out, with a reason on failure.
 */
#ifndef PLB_INPUT_CONVERTER_H
#define PLB_INPUT_CONVERTER_H

#include "base/array.h"
#include "input/input.h"
#include "system/process.h"

typedef ARRAY(char) converter_bytes;

/* Runs argv[0..] of the program at `path` on in->data and collects what it writes, at most INPUT_MAX_BYTES. True when
 * it could be started and its output collected; how it ended stands in p->end, p->code, p->message (the process is
 * finished, not to be finished again). False and `err` ("NAME: what") when it could not, or ran out of time or memory,
 * or died; `who` names it there. The program may start no threads. The caller frees the bytes in every case. */
bool plb_converter_run(const input_source *in, const char *who, const char *program, const char *const argv[], process *p,
                    converter_bytes *out, error *err);

/* Starts a process for a reader; -v says which. */
bool plb_converter_start(const input_source *in, const char *who, const char *program, const char *const argv[], process *p, error *err);

/* Fills `err` when the process ran out of time or memory, or crashed; else true. */
bool plb_converter_ended_by_itself(const input_source *in, const char *who, const process *p, error *err);

/* Returns the first line of a program's message, without bytes that are not printable; a string in p->message. */
const char *plb_converter_message(process *p);

#endif
