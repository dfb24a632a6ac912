/* SPDX-License-Identifier: MIT
 *
 * In tap-svg an allocation that fails is the end, with a status of its own. What librsvg stands on takes it in as many ways as
 * it has libraries: some die by a signal, as they do of faults in the drawing; some go on without fonts, and the drawing
 * comes out another.
 *
 * With glibc, whose allocator has inner names; a sanitizer has an allocator of its own.
 */
#include "tap/common/tap_memory.h"

#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#if defined __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define ALLOCATOR_IS_FOREIGN 1
#endif
#endif
#if defined __GLIBC__ && !defined __SANITIZE_ADDRESS__ && !defined __SANITIZE_THREAD__ && !defined ALLOCATOR_IS_FOREIGN

#pragma GCC visibility push(default)
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

static void *checked(void *block)
{
    static const char line[] = "out of memory\n";
    if (block)
        return block;
    ssize_t said = write(STDERR_FILENO, line, sizeof line - 1);
    (void)said; /* the status says it too */
    _exit(TAP_EXIT_MEMORY);
}

void *malloc(size_t size)
{
    return checked(__libc_malloc(size));
}

void *calloc(size_t n, size_t size)
{
    return checked(__libc_calloc(n, size));
}

void *realloc(void *old, size_t size)
{
    void *block = __libc_realloc(old, size);
    return size ? checked(block) : block; /* of no bytes: freed */
}

int posix_memalign(void **block, size_t alignment, size_t size)
{
    if (!alignment || alignment % sizeof(void *) || (alignment & (alignment - 1)))
        return EINVAL;
    *block = checked(__libc_memalign(alignment, size));
    return 0;
}
#pragma GCC visibility pop

#endif
