/* SPDX-License-Identifier: MIT */
#include "base/error.h"

#include <stdio.h>

/* Replaces control characters: a file's name may hold any, and the text stays one line. */
static void keep_to_one_line(char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 127)
            *text = '?';
}

bool plb_fail_v(error *err, error_kind kind, const char *format, va_list args)
{
    if (!err || err->kind != ERROR_NONE)
        return false;
    err->kind = kind;
    vsnprintf(err->text, sizeof err->text, format, args);
    keep_to_one_line(err->text);
    return false;
}

bool plb_fail(error *err, error_kind kind, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    plb_fail_v(err, kind, format, args);
    va_end(args);
    return false;
}

bool plb_fail_memory(error *err)
{
    return plb_fail(err, ERROR_MEMORY, "out of memory");
}

void plb_error_clear(error *err)
{
    err->kind = ERROR_NONE;
    err->text[0] = '\0';
}

void plb_log(const log_sink *to, message_level level, const char *format, ...)
{
    if (!to || !to->say)
        return;
    char text[512];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    keep_to_one_line(text);
    to->say(to->closure, level, text);
}
