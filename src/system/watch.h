/* SPDX-License-Identifier: MIT
 *
 * A watch looks at a foreign program while it runs: is it at work, and does it keep to what no limit of the kernel holds?
 */
#ifndef PLB_SYSTEM_WATCH_H
#define PLB_SYSTEM_WATCH_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#define WATCH_TICK 0.02       /* s between two looks. Chosen by eye: short beside a person's patience, long beside what a look costs */
#define WATCH_TICK_SHORT 0.001 /* s between two looks once half of the allowed bytes are written: memory takes 3 MB meanwhile */
#define WATCH_THREADS_MAX 32

typedef struct {
    pid_t pid;
    double patience;     /* s that we wait for a program that does nothing */
    const char *scratch; /* the folder in which it may write; NULL: none */
    size_t max_bytes;    /* bytes of all files there together */
    size_t file_size;    /* bytes of one file: RLIMIT_FSIZE */
    double waited;       /* s of waiting until now, in which we were awake */
    double looked;       /* by the clock: the last look */
    double checked;      /* by the clock: the last look at files and threads */
    bool is_filling;     /* its files hold more than half of max_bytes */
} process_watch;

typedef enum { WATCH_FINE, WATCH_STALLED, WATCH_OVERSTEPPED } watch_result;

/* Begins to wait: the time since the last look was ours. */
void plb_watch_resume(process_watch *w);
/* Counts the time since the last look as waiting, and looks. Time in which this process was stopped or starved does not count,
 * and for each second of its processor time the program may take a hundred by the clock. WATCH_OVERSTEPPED: `err` says what it
 * did ("writes more than ..."). */
watch_result plb_watch_look(process_watch *w, error *err);
/* Returns the time until the next look is due, s: shorter when the files come near their limit. */
double plb_watch_tick(const process_watch *w);
/* Looks at the files and threads alone, at any time. */
watch_result plb_watch_check(process_watch *w, error *err);

#endif
