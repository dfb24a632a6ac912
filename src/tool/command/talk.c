/* SPDX-License-Identifier: MIT
 *
 * See talk.h. Progress uses no escape codes: a line is taken away by blanks.
 */
#include "tool/command/talk.h"

#include "tool/options/streams.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The program shows progress from this second on. */
#define PATIENCE 2

bool talk_can_show_progress(void)
{
    const char *terminal = getenv("TERM");
    return isatty(STDERR_FILENO) && terminal && strcmp(terminal, "dumb") != 0;
}

static void clear_progress(talk *t)
{
    if (t->shown > 0)
        fprintf(stderr, "\r%*s\r", t->shown, "");
    t->shown = 0;
}

void talk_line(talk *t, const char *kind, const char *text)
{
    clear_progress(t);
    streams_say(PROGRAM, kind, text);
}

void talk_message(void *closure, int level, const char *text)
{
    talk *t = closure;
    if (level == 0 ? !t->command->quiet : t->command->verbose > 0)
        talk_line(t, level == 0 ? "warning: " : "", text);
}

void talk_note(talk *t)
{
    if (*t->command->note && !t->command->quiet)
        talk_line(t, "note: ", t->command->note);
}

/* Shows each percent at most once. */
bool talk_progress(void *closure, double done)
{
    talk *t = closure;
    double passed = difftime(time(NULL), t->started);
    int percent = (int)(done * 100);
    if (done >= 1 || passed < PATIENCE) {
        clear_progress(t);
        return true;
    }
    if (t->shown > 0 && percent == t->percent)
        return true;
    clear_progress(t);
    t->percent = percent;
    const char *slash = t->drawing ? strrchr(t->drawing, '/') : NULL, *name = slash ? slash + 1 : t->drawing ? t->drawing : "";
    t->shown = fprintf(stderr, PROGRAM ": ");
    streams_put(stderr, name, strlen(name) < 40 ? strlen(name) : 40);
    t->shown += (int)strlen(name) + fprintf(stderr, "%s%3d %%", *name ? ": " : "", percent);
    if (done > 0.01)
        t->shown += fprintf(stderr, ", %.0f s left", passed * (1 - done) / done);
    return true;
}

int talk_fail(talk *t, const plb_error *e)
{
    talk_line(t, "", e->text);
    return EXIT_NOT_DRAWN;
}

int talk_wrong(talk *t, const char *what)
{
    char line[640];
    snprintf(line, sizeof line, "%s; try '" PROGRAM " --help'", what);
    talk_line(t, "", line);
    return EXIT_WRONG_COMMAND;
}

int talk_no_memory(void)
{
    streams_say(PROGRAM, "", "out of memory");
    return EXIT_NOT_DRAWN;
}
