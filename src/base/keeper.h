/* SPDX-License-Identifier: MIT
 *
 * A process that cleans up behind this one, however it ends: by a signal that nobody can catch, too.
 */
#ifndef PLB_BASE_KEEPER_H
#define PLB_BASE_KEEPER_H

#include <stdbool.h>
#include <sys/types.h>

typedef struct {
    int line; /* to the keeper; it breaks when this process ends */
    pid_t pid;
} keeper;

/* Starts a keeper, which calls clean(path) when this process has gone. It is forked from a process that may have
 * threads, so `clean` may call nothing that takes a lock. False and errno when it cannot be started. */
bool plb_keeper_start(keeper *k, void (*clean)(const char *path), const char *path);
/* Ends it and waits for that; with `must_clean` it cleans up before. */
void plb_keeper_end(keeper *k, bool must_clean);

#endif
