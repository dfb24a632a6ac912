/* SPDX-License-Identifier: MIT
 *
 * See scratch.h. What the cleanup_process calls takes no lock.
 */
#define _GNU_SOURCE /* SYS_getdents64 */
#include "system/scratch.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define NAMES 100  /* so many may be taken before we give up */
#define TRIES 1000 /* to remove the folder, 10 ms apart: who writes in it is being killed */

extern char **environ;

/* ---- removing it ------------------------------------------------------------------------------------------- */

/* The kernel's linux_dirent64. */
typedef struct {
    uint64_t inode;
    int64_t offset;
    unsigned short length;
    unsigned char type;
    char name[];
} directory_entry;

static void unlink_all(int folder)
{
    _Alignas(directory_entry) char all[4096];
    long n;
    lseek(folder, 0, SEEK_SET);
    while ((n = syscall(SYS_getdents64, folder, all, sizeof all)) > 0)
        for (long at = 0; at < n;) {
            const directory_entry *e = (const directory_entry *)(const void *)(all + at);
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
    return plb_fail(err, ERROR_FILE, "cannot make a temporary folder in %.200s: %s", folder, strerror(errno));
}

static bool make_folder(const char *path, int none) { return (void)none, mkdir(path, 0700) == 0; }

/* Makes a name that nobody has or guesses. */
static void choose_name(char name[SCRATCH_PATH_MAX], const char *root, unsigned try)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789__";
    unsigned char random[10] = {(unsigned char)try};
    if (getrandom(random, sizeof random, GRND_NONBLOCK) != (ssize_t)sizeof random)
        memcpy(random + 1, &(pid_t){getpid()}, sizeof(pid_t));
    char text[sizeof random + 1] = "";
    for (size_t i = 0; i < sizeof random; i++)
        text[i] = letters[random[i] % 64];
    snprintf(name, SCRATCH_PATH_MAX, "%s/plumbago-%s", root, text);
}

bool plb_scratch_open(scratch *s, error *err)
{
    static const keeper_task task = {make_folder, remove_folder, -1};
    const char *root = temporary_root();
    for (unsigned try = 0; try < NAMES; try++) {
        choose_name(s->folder, root, try);
        if (plb_cleanup_process_start(&s->cleanup_process, &task, s->folder))
            return true;
        if (errno != EEXIST)
            break;
    }
    return fail(err, root);
}

void plb_scratch_close(scratch *s)
{
    plb_cleanup_process_end(&s->cleanup_process, true);
}
