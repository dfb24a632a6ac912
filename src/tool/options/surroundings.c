/* SPDX-License-Identifier: MIT
 *
 * See surroundings.h.
 */
#define _DEFAULT_SOURCE
#include "tool/options/surroundings.h"

#include "tool/options/streams.h"

#include <signal.h>
#include <stdio.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#define STACK_BYTES ((rlim_t)8 << 20)       /* as systems give by default */
#define STACK_BYTES_MIN ((rlim_t)256 << 10) /* twice of what the largest drawings took */

/* A sanitizer's own process looks for leaks in our memory, so the memory stays open to it. */
#if defined(__SANITIZE_ADDRESS__)
#define IS_LOOKED_INTO 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define IS_LOOKED_INTO 1
#endif
#endif
#ifndef IS_LOOKED_INTO
#define IS_LOOKED_INTO 0
#endif

/* The kernel lets the stack grow to the limit of the moment. */
static bool enlarge_stack(const char *program)
{
    struct rlimit stack;
    if (getrlimit(RLIMIT_STACK, &stack) != 0)
        return true;
    if (stack.rlim_cur < STACK_BYTES) {
        stack.rlim_cur = stack.rlim_max < STACK_BYTES ? stack.rlim_max : STACK_BYTES;
        setrlimit(RLIMIT_STACK, &stack);
    }
    if (stack.rlim_cur >= STACK_BYTES_MIN)
        return true;
    char text[128];
    snprintf(text, sizeof text, "the stack may have %zu KB only (ulimit -s): %zu are needed", (size_t)stack.rlim_cur >> 10, (size_t)STACK_BYTES_MIN >> 10);
    streams_say(program, "", text);
    return false;
}

bool surroundings_prepare(const char *program)
{
    if (!streams_keep())
        return false;
    signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is an error like others */
    signal(SIGCHLD, SIG_DFL); /* whoever started us may ignore it: we want to know how the helpers ended */
    if (!IS_LOOKED_INTO)
        prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    return enlarge_stack(program);
}
