/* SPDX-License-Identifier: MIT
 *
 * See watch.h.
 */
#define _GNU_SOURCE /* clock_getcpuclockid of other processes is POSIX; dirfd, fstatat */
#include "system/watch.h"

#include <dirent.h>
#include <fcntl.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <time.h>
#include <unistd.h>

/* A program that gets this share of one processor, or more, is at work however long it takes. Chosen by eye: a machine that
 * gives less is as good as stopped. */
#define SHARE_MIN 0.01
#define FILES_MAX 1000 /* that it may have made; Ghostscript needs about ten */

/* ---- time --------------------------------------------------------------------------------------------------- */

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Returns the processor time of the process until now, s; 0 when it has ended. */
static double processor_time(pid_t pid)
{
    clockid_t clock;
    struct timespec t;
    if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &t) != 0)
        return 0;
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void plb_watch_resume(process_watch *w) { w->looked = now(); }

/* ---- files and threads -------------------------------------------------------------------------------------- */

/* Adds up what the folder's files occupy; false when there are too many, or one has reached its limit. None can be hidden: the
 * program may neither remove nor rename any. */
static bool fits(process_watch *w)
{
    DIR *folder = opendir(w->scratch);
    uint64_t total = 0;
    unsigned files = 0;
    bool is_at_limit = false;
    for (struct dirent *e; folder && (e = readdir(folder));) {
        struct stat s;
        if (fstatat(dirfd(folder), e->d_name, &s, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(s.st_mode))
            continue;
        total += (uint64_t)s.st_blocks * 512;
        files++;
        is_at_limit = is_at_limit || (uint64_t)s.st_size >= w->file_size;
    }
    if (folder)
        closedir(folder);
    w->is_filling = total > w->max_bytes / 2;
    return total <= w->max_bytes && files <= FILES_MAX && !is_at_limit;
}

static bool has_room(const char *folder)
{
    struct statvfs s;
    return statvfs(folder, &s) != 0 || s.f_blocks == 0 || s.f_bfree > 0;
}

/* Returns the number of threads, field 20 of /proc/PID/stat; 0 when unknown. The name, field 2, may hold anything but ends with the last ')'. */
static unsigned long threads_of(pid_t pid)
{
    char path[32], text[1024];
    snprintf(path, sizeof path, "/proc/%ld/stat", (long)pid);
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    ssize_t n = fd >= 0 ? read(fd, text, sizeof text - 1) : 0;
    if (fd >= 0)
        close(fd);
    text[n > 0 ? n : 0] = '\0';
    char *at = strrchr(text, ')');
    for (int field = 2; at && field < 20; field++)
        at = strchr(at + 1, ' ');
    return at ? strtoul(at, NULL, 10) : 0;
}

double plb_watch_tick(const process_watch *w) { return w->is_filling ? WATCH_TICK_SHORT : WATCH_TICK; }

watch_result plb_watch_check(process_watch *w, error *err)
{
    w->checked = now();
    if (w->scratch && !fits(w))
        plb_fail(err, ERROR_LIMIT, "writes more temporary files than it may (%zu MB)", w->max_bytes >> 20);
    else if (w->scratch && !has_room(w->scratch))
        plb_fail(err, ERROR_FILE, "finds no room for its temporary files");
    else if (threads_of(w->pid) > WATCH_THREADS_MAX)
        plb_fail(err, ERROR_LIMIT, "starts more than %d threads", WATCH_THREADS_MAX);
    else
        return WATCH_FINE;
    return WATCH_OVERSTEPPED;
}

watch_result plb_watch_look(process_watch *w, error *err)
{
    /* a step that is longer than the time we asked to sleep is one in which we did not run */
    double before = w->looked;
    plb_watch_resume(w);
    w->waited += fmin(w->looked - before, 2 * WATCH_TICK);
    if (w->waited > w->patience && w->waited > w->patience + processor_time(w->pid) / SHARE_MIN)
        return WATCH_STALLED;
    return w->looked - w->checked >= plb_watch_tick(w) ? plb_watch_check(w, err) : WATCH_FINE;
}
