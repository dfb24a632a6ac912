/* SPDX-License-Identifier: MIT
 *
 * A filter for the system calls of foreign programs that only read, compute and write to their pipe.
 */
#ifndef PLB_SYSTEM_SECCOMP_H
#define PLB_SYSTEM_SECCOMP_H

#include <stdbool.h>

/* A sanitizer needs calls of its own (and terabytes of addresses): programs built with one run without the filter. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SECCOMP_IS_OFF 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SECCOMP_IS_OFF 1
#endif
#endif
#ifndef SECCOMP_IS_OFF
#define SECCOMP_IS_OFF 0
#endif

bool plb_seccomp_is_there(void);
/* Sets the filter; `program` is the only pointer that execve takes from now on; `writes`: files may be
 * made, opened for writing and removed (where Landlock lets them). */
bool plb_seccomp_enter(const char *program, bool writes);

#endif
