/* SPDX-License-Identifier: MIT
 *
 * See scratch.h. The keeper is forked from a process that may have threads, so it calls nothing that takes a lock.
 */
#define _GNU_SOURCE /* SYS_getdents64, pipe2 */
#include "input/scratch.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define TRIES 1000 /* to remove the folder, 10 ms apart: who writes in it is being killed */

extern char **environ;

/* ---- the keeper ------------------------------------------------------------------------------------------- */

/* The kernel's linux_dirent64. */
typedef struct {
    uint64_t inode;
    int64_t offset;
    unsigned short length;
    unsigned char type;
    char name[];
} entry;

static void unlink_all(int folder)
{
    _Alignas(entry) char all[4096];
    long n;
    lseek(folder, 0, SEEK_SET);
    while ((n = syscall(SYS_getdents64, folder, all, sizeof all)) > 0)
        for (long at = 0; at < n;) {
            const entry *e = (const entry *)(const void *)(all + at);
            unlinkat(folder, e->name, 0);
            at += e->length;
        }
}

static void remove_folder(const char *path)
{
    static const struct timespec a_moment = {0, 10 * 1000 * 1000};
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    for (int i = 0; i < TRIES && folder >= 0; i++) {
        unlink_all(folder);
        if (rmdir(path) == 0 || errno == ENOENT)
            break;
        nanosleep(&a_moment, NULL);
    }
}

static _Noreturn void keep(const char *folder, int wait_for)
{
    char byte;
    setsid(); /* out of reach of Ctrl-C */
    signal(SIGTERM, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    signal(SIGINT, SIG_IGN);
    dup2(wait_for, 0); /* nothing of ours may stay open: others wait for its end */
    if (syscall(SYS_close_range, 1u, ~0u, 0u) != 0)
        for (int fd = 1; fd < 65536; fd++)
            close(fd);
    while (read(0, &byte, 1) < 0 && errno == EINTR) {}
    remove_folder(folder);
    _exit(0);
}

/* ---- the owner -------------------------------------------------------------------------------------------- */

static const char *temporary_root(void)
{
    for (char **e = environ; e && *e; e++)
        if (!strncmp(*e, "TMPDIR=/", 8) && strlen(*e) < SCRATCH_PATH_MAX / 2)
            return *e + 7;
    return "/tmp";
}

static bool fail(error *err, const char *folder)
{
    return plb_fail(err, ERROR_HELPER, "cannot make a temporary folder in %.200s: %s", folder, strerror(errno));
}

bool plb_scratch_open(scratch *s, error *err)
{
    const char *root = temporary_root();
    int ends[2];
    snprintf(s->folder, sizeof s->folder, "%s/plumbago-XXXXXX", root);
    if (pipe2(ends, O_CLOEXEC) != 0)
        return fail(err, root);
    bool made = mkdtemp(s->folder) != NULL;
    s->keeper = made ? fork() : -1;
    if (s->keeper == 0) {
        close(ends[1]);
        keep(s->folder, ends[0]);
    }
    close(ends[0]);
    s->pipe = ends[1];
    if (s->keeper > 0)
        return true;
    fail(err, root);
    close(ends[1]);
    if (made)
        rmdir(s->folder);
    return false;
}

void plb_scratch_close(scratch *s)
{
    close(s->pipe);
    while (waitpid(s->keeper, NULL, 0) < 0 && errno == EINTR) {}
}
