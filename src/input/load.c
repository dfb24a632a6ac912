/* SPDX-License-Identifier: MIT
 *
 * This file reads a whole file, or standard input, into memory.
 */
#include "input/input.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define READ_BYTES ((size_t)1 << 16)

typedef ARRAY(char) bytes;

static bool read_all(int fd, const char *name, bytes *all, error *err)
{
    for (;;) {
        if (!array_reserve(all, READ_BYTES))
            return plb_fail_memory(err);
        ssize_t n = read(fd, all->v + all->n, all->capacity - all->n);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return plb_fail(err, ERROR_FILE, "%s: %s", name, strerror(errno));
        if (n == 0)
            return true;
        all->n += (size_t)n;
        if (all->n > INPUT_MAX_BYTES)
            return plb_fail(err, ERROR_LIMIT, "%s: larger than %zu MB", name, INPUT_MAX_BYTES >> 20);
    }
}

/* Opens the file; directories and files over the limit are refused before a byte is read. */
static int open_input(const char *file, error *err)
{
    struct stat about;
    int fd = open(file, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (fd < 0) {
        plb_fail(err, ERROR_FILE, "%s: %s", file, strerror(errno));
        return -1;
    }
    bool known = fstat(fd, &about) == 0;
    if (known && !S_ISDIR(about.st_mode) && !(S_ISREG(about.st_mode) && about.st_size > (off_t)INPUT_MAX_BYTES))
        return fd;
    if (known && S_ISDIR(about.st_mode))
        plb_fail(err, ERROR_FILE, "%s: this is a folder; name the drawings in it (%s/*.svg)", file, file);
    else if (known)
        plb_fail(err, ERROR_LIMIT, "%s: larger than %zu MB", file, INPUT_MAX_BYTES >> 20);
    else
        plb_fail(err, ERROR_FILE, "%s: %s", file, strerror(errno));
    close(fd);
    return -1;
}

bool plb_input_load(const char *file, char **data, size_t *size, error *err)
{
    bool is_stdin = !strcmp(file, "-");
    int fd = is_stdin ? STDIN_FILENO : open_input(file, err);
    if (fd < 0)
        return false;
    bytes all = {0};
    bool ok = read_all(fd, is_stdin ? "standard input" : file, &all, err);
    if (!is_stdin)
        close(fd);
    if (!ok) {
        array_free(&all);
        return false;
    }
    *data = all.v;
    *size = all.n;
    return true;
}
