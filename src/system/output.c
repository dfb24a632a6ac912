/* SPDX-License-Identifier: MIT
 *
 * See output.h. O_TMPFILE is Linux's; elsewhere, and on file systems without it, a named temporary file serves.
 */
#define _GNU_SOURCE /* O_TMPFILE */
#include "system/output.h"

#include "base/array.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *plb_output_shown(const char *file)
{
    return strcmp(file, "-") ? file : "standard output";
}

static bool fail(error *err, const char *file, const char *what, int reason)
{
    return plb_fail(err, ERROR_FILE, "%s: %s: %s", file, what, strerror(reason));
}

static char *join(const char *a, const char *b)
{
    size_t n = strlen(a) + strlen(b) + 1;
    char *r = plb_new(n, 1);
    if (r)
        snprintf(r, n, "%s%s", a, b);
    return r;
}

/* Returns the folder that `name` lies in, as "FOLDER/" or "". The caller frees. */
static char *folder_of(const char *name)
{
    char *folder = join(name, "");
    char *slash = folder ? strrchr(folder, '/') : NULL;
    if (slash)
        slash[1] = '\0';
    else if (folder)
        folder[0] = '\0';
    return folder;
}

#define MAX_LINKS 40 /* followed one after the other; the kernel's own limit */

/* Follows links: returns the name that `file` stands for, also when nothing is there yet. NULL and errno on failure. The caller
 * frees. */
static char *follow(const char *file)
{
    char *name = join(file, "");
    for (int i = 0; name && i < MAX_LINKS; i++) {
        char target[PATH_MAX];
        ssize_t n = readlink(name, target, sizeof target - 1);
        if (n < 0)
            return name;
        target[n] = '\0';
        char *folder = target[0] == '/' ? join("", "") : folder_of(name), *next = folder ? join(folder, target) : NULL;
        plb_free(folder);
        plb_free(name);
        name = next;
    }
    errno = name ? ELOOP : ENOMEM;
    plb_free(name);
    return NULL;
}

/* Returns the folder's try-th temporary name of this process. The caller frees. */
static char *temporary_name(const char *folder, unsigned try)
{
    char suffix[48];
    snprintf(suffix, sizeof suffix, ".plumbago-%ld-%u", (long)getpid(), try);
    return join(folder, suffix);
}

/* More tries than that would mean a folder full of our own leftovers. */
#define MAX_TRIES 1000

static bool make_file(const char *name, int none)
{
    (void)none;
    int fd = open(name, O_CREAT | O_EXCL | O_WRONLY, 0666);
    return fd >= 0 && close(fd) == 0;
}
static void remove_file(const char *name) { unlink(name); }

/* Gives a nameless file a name. */
static bool link_file(const char *name, int fd)
{
    char self[64];
    snprintf(self, sizeof self, "/proc/self/fd/%d", fd);
    return linkat(AT_FDCWD, self, AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
}

/* Has a cleanup process make the temporary file, and opens the file for writing. */
static int open_kept(output *out)
{
    static const keeper_task task = {make_file, remove_file, -1};
    out->is_kept = plb_cleanup_process_start(&out->cleanup_process, &task, out->temporary);
    if (!out->is_kept)
        return -1;
    int fd = open(out->temporary, O_WRONLY | O_NOFOLLOW | O_CLOEXEC), reason = errno;
    if (fd < 0) {
        plb_cleanup_process_end(&out->cleanup_process, true);
        out->is_kept = false;
        errno = reason;
    }
    return fd;
}

static int open_named(output *out, const char *folder)
{
    for (unsigned try = 0; try < MAX_TRIES; try++) {
        out->temporary = temporary_name(folder, try);
        int fd = out->temporary ? open_kept(out) : -1;
        if (fd >= 0)
            return fd;
        plb_free(out->temporary);
        out->temporary = NULL;
        if (errno != EEXIST)
            break;
    }
    return -1;
}

static int open_nameless(const char *folder, int access_mode)
{
#ifdef O_TMPFILE
    if (access("/proc/self/fd", X_OK) != 0) /* without it the file could not be given a name */
        return -1;
    return open(*folder ? folder : ".", O_TMPFILE | access_mode | O_CLOEXEC, 0666);
#else
    (void)folder;
    (void)access_mode;
    return -1;
#endif
}

/* A file that takes another's place has its owner and mode, as far as this user may give them. What cannot be given to the
 * group is given to nobody: rights that others have the new group may have, too. */
static void take_access(int fd, const struct stat *before)
{
    mode_t mode = before->st_mode & 07777;
    if (fchown(fd, before->st_uid, before->st_gid) != 0) {
        mode &= 0777;
        if (fchown(fd, (uid_t)-1, before->st_gid) != 0)
            mode = (mode & 0707) | ((mode & 07) << 3 & mode);
    }
    if (fchmod(fd, mode) != 0)
        return; /* a file system that has no modes */
}

static bool open_beside(output *out, const struct stat *before, error *err)
{
    char *folder = folder_of(out->name);
    if (!folder)
        return plb_fail_memory(err);
    int fd = open_nameless(folder, O_WRONLY);
    if (fd < 0)
        fd = open_named(out, folder);
    if (fd >= 0 && before)
        take_access(fd, before);
    out->to = fd < 0 ? NULL : fdopen(fd, "wb");
    int reason = errno;
    plb_free(folder);
    if (out->to)
        return true;
    if (fd >= 0)
        close(fd);
    return fail(err, out->asked, "cannot be written", reason);
}

static bool open_direct(output *out, error *err)
{
    int fd = strcmp(out->asked, "-") ? open(out->asked, O_WRONLY | O_CLOEXEC) : dup(STDOUT_FILENO);
    bool is_readonly = fd >= 0 && (fcntl(fd, F_GETFL) & O_ACCMODE) == O_RDONLY; /* standard output was closed */
    out->to = fd < 0 || is_readonly ? NULL : fdopen(fd, "wb");
    if (is_readonly)
        errno = EBADF;
    if (out->to)
        return true;
    int reason = errno;
    if (fd >= 0)
        close(fd);
    return fail(err, plb_output_shown(out->asked), "cannot be written", reason);
}

bool plb_output_open(output *out, const char *file, error *err)
{
    struct stat st;
    memset(out, 0, sizeof *out);
    out->asked = file;
    bool there = strcmp(file, "-") && stat(file, &st) == 0;
    if (!strcmp(file, "-") || (there && !S_ISREG(st.st_mode) && !S_ISDIR(st.st_mode)))
        return open_direct(out, err);
    if (there && S_ISDIR(st.st_mode))
        return fail(err, file, "cannot be written", EISDIR);
    out->name = follow(file);
    if (!out->name)
        return errno == ENOMEM ? plb_fail_memory(err) : fail(err, file, "cannot be written", errno);
    if (open_beside(out, there ? &st : NULL, err))
        return true;
    plb_output_discard(out);
    return false;
}

/* Gives a nameless file its name. One that is in the way is replaced in one step, by a temporary name, which a cleanup_process
 * gives: a signal that nobody can catch may end us before the next step. */
static bool give_name(output *out)
{
    if (link_file(out->name, fileno(out->to)))
        return true;
    if (errno != EEXIST)
        return false;
    const keeper_task task = {link_file, remove_file, fileno(out->to)};
    char *folder = folder_of(out->name);
    for (unsigned try = 0; folder && try < MAX_TRIES && !out->is_kept; try++) {
        out->temporary = temporary_name(folder, try);
        out->is_kept = out->temporary && plb_cleanup_process_start(&out->cleanup_process, &task, out->temporary);
        if (out->is_kept)
            break;
        plb_free(out->temporary);
        out->temporary = NULL;
        if (errno != EEXIST)
            break;
    }
    int reason = errno;
    plb_free(folder);
    errno = reason;
    return out->is_kept;
}

/* Renames the temporary file to the name that was asked for. */
static bool rename_it(output *out)
{
    if (out->temporary && rename(out->temporary, out->name) != 0)
        return false;
    plb_free(out->temporary);
    out->temporary = NULL;
    return true;
}

static bool close_it(output *out)
{
    bool ok = fclose(out->to) == 0;
    out->to = NULL;
    return ok;
}

/* Between the temporary name and its end no signal ends us half-way: what can be held waits. */
static void hold_signals(sigset_t *before)
{
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, before);
}

bool plb_output_commit(output *out, error *err)
{
    sigset_t before;
    bool ok = fflush(out->to) == 0 && !ferror(out->to);
    hold_signals(&before);
    ok = ok && (!out->name || out->temporary || give_name(out)) && close_it(out) && rename_it(out);
    int reason = errno;
    if (!ok)
        fail(err, plb_output_shown(out->asked), "cannot be written", reason);
    plb_output_discard(out);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return ok;
}

void plb_output_discard(output *out)
{
    if (out->to)
        fclose(out->to);
    if (out->temporary)
        unlink(out->temporary);
    if (out->is_kept)
        plb_cleanup_process_end(&out->cleanup_process, false);
    plb_free(out->temporary);
    plb_free(out->name);
    memset(out, 0, sizeof *out);
}

FILE *plb_output_spool(const char *beside, error *err)
{
    char *folder = strcmp(beside, "-") ? folder_of(beside) : NULL;
    int fd = folder ? open_nameless(folder, O_RDWR) : -1;
    bool is_there = !folder || fd >= 0 || access(*folder ? folder : ".", W_OK | X_OK) == 0;
    plb_free(folder);
    if (!is_there)
        return fail(err, beside, "cannot be written", errno), NULL;
    FILE *spool = fd < 0 ? tmpfile() : fdopen(fd, "w+b");
    if (spool)
        return spool;
    int reason = errno;
    if (fd >= 0)
        close(fd);
    fail(err, plb_output_shown(beside), "cannot be written", reason);
    return NULL;
}
