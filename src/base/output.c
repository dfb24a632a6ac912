/* SPDX-License-Identifier: MIT
 *
 * See output.h. O_TMPFILE is Linux's; elsewhere, and on file systems without it, a named temporary file serves.
 */
#define _GNU_SOURCE /* O_TMPFILE */
#include "base/output.h"

#include "base/array.h"

#include <errno.h>
#include <fcntl.h>
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

/* The folder that `name` lies in, as "FOLDER/" or "". The caller frees. */
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

/* The folder's try-th temporary name of this process. The caller frees. */
static char *temporary_name(const char *folder, unsigned try)
{
    char suffix[48];
    snprintf(suffix, sizeof suffix, ".plumbago-%ld-%u", (long)getpid(), try);
    return join(folder, suffix);
}

/* More tries than that would be a folder full of our own leftovers. */
#define MOST_TRIES 1000

static void forget(const char *name) { unlink(name); }

/* While a temporary name is there and no keeper knows of it, no signal may end us. */
static void hold_signals(sigset_t *before)
{
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, before);
}
static void release_signals(const sigset_t *before)
{
    int reason = errno;
    pthread_sigmask(SIG_SETMASK, before, NULL);
    errno = reason;
}

static int open_kept(output *out)
{
    sigset_t before;
    hold_signals(&before);
    int fd = open(out->temporary, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    out->is_kept = fd >= 0 && plb_keeper_start(&out->keeper, forget, out->temporary);
    release_signals(&before);
    return fd;
}

static int open_named(output *out, const char *folder)
{
    for (unsigned try = 0; try < MOST_TRIES; try++) {
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

static int open_nameless(const char *folder)
{
#ifdef O_TMPFILE
    if (access("/proc/self/fd", X_OK) != 0) /* without it the file could not be given a name */
        return -1;
    return open(*folder ? folder : ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
#else
    (void)folder;
    return -1;
#endif
}

static bool open_beside(output *out, error *err)
{
    char *folder = folder_of(out->name);
    if (!folder)
        return plb_fail_memory(err);
    int fd = open_nameless(folder);
    if (fd < 0)
        fd = open_named(out, folder);
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
    out->to = fd < 0 ? NULL : fdopen(fd, "wb");
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
    out->name = there ? realpath(file, NULL) : join(file, ""); /* through a link: onto what it names */
    if (!out->name)
        return plb_fail_memory(err);
    if (open_beside(out, err))
        return true;
    plb_output_discard(out);
    return false;
}

/* Gives a nameless file its name; one that is in the way is replaced in one step. */
static bool give_name(output *out)
{
    char self[64];
    snprintf(self, sizeof self, "/proc/self/fd/%d", fileno(out->to));
    if (linkat(AT_FDCWD, self, AT_FDCWD, out->name, AT_SYMLINK_FOLLOW) == 0)
        return true;
    if (errno != EEXIST)
        return false;
    char *folder = folder_of(out->name);
    for (unsigned try = 0; folder && try < MOST_TRIES; try++) {
        out->temporary = temporary_name(folder, try);
        if (out->temporary && linkat(AT_FDCWD, self, AT_FDCWD, out->temporary, AT_SYMLINK_FOLLOW) == 0)
            break;
        plb_free(out->temporary);
        out->temporary = NULL;
    }
    plb_free(folder);
    return out->temporary != NULL;
}

/* The name that it has meanwhile becomes the one that was asked for. */
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
    release_signals(&before);
    return ok;
}

void plb_output_discard(output *out)
{
    if (out->to)
        fclose(out->to);
    if (out->temporary)
        unlink(out->temporary);
    if (out->is_kept)
        plb_keeper_end(&out->keeper, false);
    plb_free(out->temporary);
    plb_free(out->name);
    memset(out, 0, sizeof *out);
}
