/* SPDX-License-Identifier: MIT
 *
 * A team is some threads that share out numbered pieces of work. The caller is one of its members.
 */
#ifndef PLB_SYSTEM_THREAD_TEAM_H
#define PLB_SYSTEM_THREAD_TEAM_H

#include <stdbool.h>
#include <stddef.h>

/* A team has so many members at the most; enough for any machine that draws (chosen by eye). */
#define THREAD_TEAM_MAX 64

/* Does piece `item`; `member` counts from 0, the caller, and says whose scratch room to use. False stops the team. */
typedef bool (*team_work)(void *closure, int member, size_t item);

/* Returns the number of processors that this process may run on, at least 1. */
int plb_thread_team_processors(void);

/* Does items 0 .. n - 1, begun in this order, with up to `members` threads (fewer where the system gives no more).
 * False when a piece failed: no further ones were begun then, but all before it were. Returns when all have ended. */
bool plb_thread_team_run(int members, size_t n, team_work work, void *closure);

#endif
