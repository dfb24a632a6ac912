/* SPDX-License-Identifier: MIT
 *
 * A cleanup process removes a temporary file or folder however this process ends, by a signal that nobody can catch, too.
 */
#ifndef PLB_SYSTEM_CLEANUP_PROCESS_H
#define PLB_SYSTEM_CLEANUP_PROCESS_H

#include <stdbool.h>
#include <sys/types.h>

typedef struct {
    int line; /* to the cleanup_process; it breaks when this process ends */
    pid_t pid;
} cleanup_process;

/* A file or a folder of some name. Both functions are called in a process that is forked from one that may have threads,
 * so they may call nothing that takes a lock. */
typedef struct {
    bool (*make)(const char *path, int descriptor); /* false and errno when it cannot be made */
    void (*remove)(const char *path);
    int descriptor; /* an open one, for `make`; others do not mind */
} keeper_task;

/* Starts a cleanup process, which makes the thing and removes it when this process has gone, so that the thing never exists without
 * its cleanup process. False and errno when the thing cannot be made; then there is no cleanup process. `path` may change
 * afterwards. */
bool plb_cleanup_process_start(cleanup_process *k, const keeper_task *task, const char *path);
/* Ends the cleanup process and waits for that; with `must_remove` it removes the thing before. */
void plb_cleanup_process_end(cleanup_process *k, bool must_remove);

#endif
