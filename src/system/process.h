/* SPDX-License-Identifier: MIT
 *
 * This header runs foreign code in a process of its own: bytes go in on descriptor 0 and come out of descriptor 1 while it runs,
 * time and memory are limited, a cage (sandbox.h) holds it, and it ends in every case.
 */
#ifndef PLB_SYSTEM_PROCESS_H
#define PLB_SYSTEM_PROCESS_H

#include "base/error.h"
#include "system/watch.h"

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/* A process may use so much. */
typedef struct {
    double seconds; /* of processor time. By the clock it may take as long as it gets a hundredth of a processor or more, and
                       three times `seconds` beyond that; time in which we are stopped does not count */
    double *spent;  /* processor time that other processes for the same drawing have taken out of `seconds`; this one's is
                       added. Each gets a second, whatever is left. NULL: it has all for itself */
    size_t memory;  /* bytes of address space */
    const char *scratch; /* a folder in which it may make and write files, of `memory` bytes together, and
                            PROCESS_SCRATCH_BYTES each; NULL: it writes nowhere */
    bool single;         /* it has one thread and may start none */
    bool loose;          /* no cage, only limits; for our tests' own programs */
    bool (*may_go_on)(void *closure); /* is asked every WATCH_TICK while we wait for the process; false ends it. NULL: nobody is */
    void *closure;                    /* asked */
} process_limits;
#define PROCESS_SCRATCH_BYTES ((size_t)256 << 20)
#define PROCESS_LIMITS ((process_limits){.seconds = 8, .memory = (size_t)1 << 30})

typedef enum {
    PROCESS_RUNNING,
    PROCESS_EXITED,   /* by itself; `code` is its exit status */
    PROCESS_CRASHED,  /* by signal `code` */
    PROCESS_TIMED_OUT, /* used its processor time up, or did nothing for too long */
    PROCESS_OVERSTEPPED, /* ended by us; `fault` says what it did */
    PROCESS_STOPPED      /* may_go_on said no */
} process_end;

typedef struct {
    pid_t pid;
    int in, out, err; /* our ends; -1: closed */
    const char *input; /* not yet taken */
    size_t input_left;
    char *buffer;      /* of what plb_process_read gives */
    process_end end;
    int code;
    char message[1024]; /* the first bytes that it wrote to its standard error; a string */
    size_t message_length;
    process_limits limits;
    process_watch watch;
    double asked;      /* by the clock: when may_go_on was called last */
    error fault;
    const char *cage; /* what holds it: plb_sandbox_name */
} process;

/* Starts `program` with arguments argv[0..], NULL-terminated, and `size` bytes of input, which must live until the
 * end; `limits` may be NULL. False and `err` when the program cannot be started; then there is nothing to finish. */
bool plb_process_start(process *p, const char *program, const char *const argv[], const char *input, size_t size,
                       const process_limits *limits, error *err);
/* Waits for more of the program's output. False at the end of the output. The bytes live until the next call. */
bool plb_process_read(process *p, const char **data, size_t *size);
/* Ends the program (by force, if its output was not read to the end), reaps it and fills `end` and `code`. */
void plb_process_finish(process *p);

/* Puts the path of helper program `name` into `path`: in `helper_dir` if given, else beside the running program, else in
 * libexec/plumbago near it, else in the place it was installed to. False and ERROR_HELPER when there is none. */
#define PROCESS_PATH_MAX 4096
bool plb_process_find(const char *helper_dir, const char *name, char path[PROCESS_PATH_MAX], error *err);
/* Finds a program of the system by the user's PATH; false when there is none. */
bool plb_process_find_installed(const char *name, char path[PROCESS_PATH_MAX]);

#endif
