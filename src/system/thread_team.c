/* SPDX-License-Identifier: MIT
 *
 * See thread_team.h. Threads live for one call: starting one costs some 20 µs, a piece of work is longer.
 */
#include "system/thread_team.h"

#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

#define THREAD_STACK_BYTES ((size_t)2 << 20) /* whatever the limit on the first thread's stack is */

typedef struct {
    team_work work;
    void *closure;
    size_t n;
    atomic_size_t next;
    atomic_bool failed;
} team_job;

typedef struct {
    team_job *job;
    int number;
    pthread_t thread;
} member;

int plb_thread_team_processors(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > THREAD_TEAM_MAX ? THREAD_TEAM_MAX : (int)n;
}

static void *toil(void *closure)
{
    member *m = closure;
    team_job *j = m->job;
    while (!atomic_load(&j->failed)) {
        size_t item = atomic_fetch_add(&j->next, 1);
        if (item >= j->n)
            break;
        if (!j->work(j->closure, m->number, item))
            atomic_store(&j->failed, true);
    }
    return NULL;
}

/* Starts the member's thread; false when that fails. */
static bool start(member *m)
{
    pthread_attr_t with;
    if (pthread_attr_init(&with) != 0)
        return false;
    bool ok = pthread_attr_setstacksize(&with, THREAD_STACK_BYTES) == 0 && pthread_create(&m->thread, &with, toil, m) == 0;
    pthread_attr_destroy(&with);
    return ok;
}

bool plb_thread_team_run(int members, size_t n, team_work work, void *closure)
{
    team_job j = {.work = work, .closure = closure, .n = n};
    member team[THREAD_TEAM_MAX];
    int started = 1;
    members = members > THREAD_TEAM_MAX ? THREAD_TEAM_MAX : members;
    team[0] = (member){.job = &j};
    while (started < members && (size_t)started < n) {
        team[started] = (member){.job = &j, .number = started};
        if (!start(&team[started]))
            break;
        started++;
    }
    toil(&team[0]);
    for (int k = 1; k < started; k++)
        pthread_join(team[k].thread, NULL);
    return !atomic_load(&j.failed);
}
