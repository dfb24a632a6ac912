/* SPDX-License-Identifier: MIT
 *
 * A list of the system calls that foreign programs may make: those that read, compute and write to their pipe. The kernel
 * does not know any others for them. libseccomp writes the filter before the fork, since it allocates; the child only loads it.
 */
#ifndef PLB_SYSTEM_SANDBOX_SECCOMP_H
#define PLB_SYSTEM_SANDBOX_SECCOMP_H

#include <linux/filter.h>
#include <stdbool.h>
#include <stdint.h>

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

/* A program may be allowed these things beyond reading and computing. */
typedef struct {
    bool writes;  /* files may be made and opened for writing (where Landlock lets them); none may be removed */
    bool threads; /* it may start threads */
} seccomp_rights;

#define SECCOMP_STEPS_MAX 1024
#define SECCOMP_KEY_PARTS 3

typedef struct {
    unsigned short n; /* 0: no filter */
    struct sock_filter code[SECCOMP_STEPS_MAX];
    uint64_t key[SECCOMP_KEY_PARTS]; /* opens execve, see plb_seccomp_execute */
} seccomp_filter;

/* Writes the filter. False when this kernel or build has none, or there is no memory for one; then f->n is 0. */
bool plb_seccomp_plan(seccomp_filter *f, seccomp_rights rights);
/* Loads it, for good, into the calling process, a child before its execve. */
bool plb_seccomp_enter(const seccomp_filter *f);
/* execve under the filter, which lets it pass with the key alone. The key is random and stands in registers that execve
 * does not read and the kernel clears: the new program does not have it, so there is no second execve. Returns on failure. */
void plb_seccomp_execute(const seccomp_filter *f, const char *program, char *const argv[], char *const environment[]);

#endif
