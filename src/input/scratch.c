/* SPDX-License-Identifier: MIT
 *
 * See scratch.h. What the keeper calls takes no lock.
 */
#define _GNU_SOURCE /* SYS_getdents64 */
#include "input/scratch.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

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
    snprintf(s->folder, sizeof s->folder, "%s/plumbago-XXXXXX", root);
    bool made = mkdtemp(s->folder) != NULL;
    if (made && plb_keeper_start(&s->keeper, remove_folder, s->folder))
        return true;
    fail(err, root);
    if (made)
        rmdir(s->folder);
    return false;
}

void plb_scratch_close(scratch *s)
{
    plb_keeper_end(&s->keeper, true);
}
