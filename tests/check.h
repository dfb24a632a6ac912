/* SPDX-License-Identifier: MIT
 *
 * The least a C test needs. A test program calls RUN(function) for each of its test functions; each prints one line,
 * "ok NAME", "FAIL NAME: file:line: condition" or "skip NAME: why", which tests/run counts.
 */
#ifndef PLB_TESTS_CHECK_H
#define PLB_TESTS_CHECK_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool check_failed, check_any_failed;
static const char *check_skipped;

#define CHECK(condition) \
    do { \
        if (!(condition)) { \
            if (!check_failed) \
                printf("FAIL %s: %s:%d: %s\n", __func__, __FILE__, __LINE__, #condition); \
            check_failed = check_any_failed = true; \
        } \
    } while (0)

/* The same, with the figures: CHECK_RANGE(mean, 1.9, 2.1). */
#define CHECK_RANGE(value, low, high) \
    do { \
        double check_value = (value); \
        if (!(check_value >= (low) && check_value <= (high))) { \
            if (!check_failed) \
                printf("FAIL %s: %s:%d: %s is %g, not in [%g, %g]\n", __func__, __FILE__, __LINE__, #value, check_value, (double)(low), (double)(high)); \
            check_failed = check_any_failed = true; \
        } \
    } while (0)

#define SKIP(why) \
    do { \
        check_skipped = (why); \
        return; \
    } while (0)

#define RUN(function) \
    do { \
        check_failed = false; \
        check_skipped = NULL; \
        function(); \
        if (check_skipped) \
            printf("skip %s: %s\n", #function, check_skipped); \
        else if (!check_failed) \
            printf("ok %s\n", #function); \
        fflush(stdout); \
    } while (0)

#define CHECK_EXIT return check_any_failed ? 1 : 0

#endif
