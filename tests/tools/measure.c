/* SPDX-License-Identifier: MIT
 *
 * measure [--together] COMMAND [ARGUMENT...]: runs it, output thrown away, and prints what it cost with all its children:
 *
 *     cpu SECONDS wall SECONDS peak KIB status N
 *
 * cpu: user and system time of the whole process tree; peak: the largest resident set of any single process in it, or,
 * with --together, of all that are alive at a time, looked at every few milliseconds. Children that the command does
 * not wait for are not counted.
 */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static double seconds(struct timeval t)
{
    return (double)t.tv_sec + (double)t.tv_usec * 1e-6;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static void run(char **command)
{
    int null = open("/dev/null", O_WRONLY);
    if (null >= 0)
        dup2(null, STDOUT_FILENO);
    execvp(command[0], command);
    fprintf(stderr, "measure: %s: %s\n", command[0], strerror(errno));
    _exit(127);
}

/* ---- the processes that are alive ---------------------------------------------------------------------------- */

#define PROCESSES_MAX 512 /* of the machine: beyond it some are overlooked */
#define LOOK_NS 4000000L  /* between two looks */

typedef struct {
    long pid, parent, kib;
} alive;

/* Fills `all` with the processes of this machine; returns how many. */
static int look(alive *all)
{
    DIR *proc = opendir("/proc");
    int n = 0;
    long page_kib = sysconf(_SC_PAGESIZE) / 1024;
    for (struct dirent *e; proc && n < PROCESSES_MAX && (e = readdir(proc));) {
        char name[300];
        snprintf(name, sizeof name, "/proc/%s/stat", e->d_name);
        FILE *f = e->d_name[0] >= '1' && e->d_name[0] <= '9' ? fopen(name, "r") : NULL;
        long pages;
        /* pid (name) state parent, and the resident pages in field 24; a name may hold anything but has 15 bytes at most */
        if (f && fscanf(f, "%ld (%*15[^)]) %*c %ld", &all[n].pid, &all[n].parent) == 2 &&
            fscanf(f, "%*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %ld", &pages) == 1)
            all[n++].kib = pages * page_kib;
        if (f)
            fclose(f);
    }
    if (proc)
        closedir(proc);
    return n;
}

/* Resident memory of `root` and all that descends from it. */
static long together(long root)
{
    static alive all[PROCESSES_MAX];
    int n = look(all);
    long family[PROCESSES_MAX] = {root}, sum = 0;
    for (int k = 0, m = 1; k < m; k++)
        for (int i = 0; i < n; i++) {
            sum += all[i].pid == family[k] ? all[i].kib : 0;
            if (all[i].parent == family[k] && m < PROCESSES_MAX)
                family[m++] = all[i].pid;
        }
    return sum;
}

/* Waits for the child; returns the most memory that it and its children had together. */
static long watch(pid_t child, int *state)
{
    long peak = 0;
    while (waitpid(child, state, WNOHANG) == 0) {
        long now = together(child);
        peak = now > peak ? now : peak;
        nanosleep(&(struct timespec){0, LOOK_NS}, NULL);
    }
    return peak;
}

int main(int argc, char **argv)
{
    int is_together = argc > 1 && !strcmp(argv[1], "--together");
    argv += is_together;
    if (argc - is_together < 2) {
        fprintf(stderr, "usage: measure [--together] COMMAND [ARGUMENT...]\n");
        return 2;
    }
    double start = now();
    pid_t child = fork();
    if (child == 0)
        run(argv + 1);
    int state = 0;
    long peak = child > 0 && is_together ? watch(child, &state) : 0;
    if (child < 0 || (!is_together && waitpid(child, &state, 0) < 0)) {
        perror("measure");
        return 2;
    }
    double wall = now() - start;
    struct rusage use;
    getrusage(RUSAGE_CHILDREN, &use);
    int status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    printf("cpu %.6f wall %.6f peak %ld status %d\n", seconds(use.ru_utime) + seconds(use.ru_stime), wall,
           peak > use.ru_maxrss ? peak : use.ru_maxrss, status);
    return status != 0;
}
