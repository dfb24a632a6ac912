/* SPDX-License-Identifier: MIT
 *
 * To be preloaded: the FAIL_AT-th allocation of the process fails, that of any library counted, and with FAIL_ALL every later
 * one too. Leaves an empty file FAIL_MARK when it came to that. (glibc: what it replaces is called by its inner names.)
 */
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *old, size_t size);

static atomic_long left = -1; /* allocations until one fails; negative: none does */
static bool all;
static const char *mark;

__attribute__((constructor)) static void begin(void)
{
    const char *at = getenv("FAIL_AT");
    mark = getenv("FAIL_MARK");
    all = getenv("FAIL_ALL") != NULL;
    atomic_store(&left, at ? atol(at) : -1);
}

static bool fails(void)
{
    long before = atomic_load(&left);
    while (before > 0 && !atomic_compare_exchange_weak(&left, &before, before - 1)) {}
    if (before != 1 && !(before == 0 && all))
        return false;
    int fd = before == 1 && mark ? open(mark, O_CREAT | O_WRONLY, 0600) : -1;
    if (fd >= 0)
        close(fd);
    errno = ENOMEM;
    return true;
}

void *malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t n, size_t size) { return fails() ? NULL : __libc_calloc(n, size); }
void *realloc(void *old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }
