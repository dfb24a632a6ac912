/* SPDX-License-Identifier: MIT
 *
 * Errors and messages. A function that can fail takes an `error *` last and returns false (or NULL)
 * after filling it; the first error sticks. The text is one line for a person, whose control characters are shown as '?';
 * where a file is to blame it starts with "FILE:LINE: " or "FILE: ".
 */
#ifndef PLB_BASE_ERROR_H
#define PLB_BASE_ERROR_H

#include <stdarg.h>
#include <stdbool.h>

typedef enum {
    ERROR_NONE,
    ERROR_FILE,        /* a file cannot be opened, read or written */
    ERROR_SYNTAX,      /* the input is not what its format says */
    ERROR_UNSUPPORTED, /* valid input that needs something this program does not do */
    ERROR_LIMIT,       /* a bound on time, memory, size or depth was reached */
    ERROR_MEMORY,      /* an allocation failed */
    ERROR_ARGUMENT,    /* the caller asked for something impossible */
    ERROR_HELPER,      /* a helper program is missing or died */
    ERROR_CANCELLED    /* the caller said stop */
} error_kind;

typedef struct {
    error_kind kind;
    char text[512];
} error;

/* Fills `err` unless it already holds an error (or is NULL); always returns false. */
bool plb_fail(error *err, error_kind kind, const char *format, ...) __attribute__((format(printf, 3, 4)));
bool plb_fail_v(error *err, error_kind kind, const char *format, va_list args) __attribute__((format(printf, 3, 0)));
/* Does the same for a failed allocation. */
bool plb_fail_memory(error *err);
void plb_error_clear(error *err);

/* A log_sink receives warnings and remarks, in one call for each line of text. Where `say` is NULL, nobody hears them. */
typedef enum { MESSAGE_WARNING, MESSAGE_DETAIL } message_level;
typedef struct {
    void (*say)(void *closure, message_level level, const char *text);
    void *closure;
} log_sink;
void plb_log(const log_sink *to, message_level level, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
