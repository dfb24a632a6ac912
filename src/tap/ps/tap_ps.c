/* SPDX-License-Identifier: MIT
 *
 * tap-ps: PostScript on descriptor 0 becomes a display list on descriptor 1.
 *
 *     tap-ps [--page N] [--alone] [--count] <drawing.ps >list
 *
 * --alone: there is no Ghostscript; what it would draw is left out and counted. --count: the list is empty, it only says
 * how many pages there are. Exit statuses are those of list/text/tap_status.h, and 125: no memory. TAP_HANDED_OVER: Ghostscript
 * should draw the page; nothing was written, the lines on standard error are for the caller: which sheet (0: all), whether
 * its end is missing, its area in points, where the program starts and how long it is, whether something unknown was met;
 * a reason, and what the user should hear.
 */
#include "base/number/number.h"
#include "list/text/list_write.h"
#include "list/text/tap_status.h"
#include "tap/common/tap_memory.h"
#include "tap/common/tap_stream.h"
#include "tap/ps/postscript.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void __attribute__((noreturn)) quit(int status, const char *text)
{
    fprintf(stderr, "%s\n", text);
    fflush(stderr);
    _exit(status);
}

static bool put(void *closure, const char *data, size_t n)
{
    (void)closure;
    return plb_tap_put(data, n);
}

static bool write_list(const display_list *list, const ps_answer *answer)
{
    static list_writer w;
    plb_list_writer_init(&w, put, NULL);
    plb_list_writer_page(&w, list->width > 0 ? list->width : 1, list->height > 0 ? list->height : 1);
    if (answer->pages)
        plb_list_writer_pages(&w, answer->pages);
    for (int kind = 0; kind < OMISSION_KINDS; kind++)
        if (list->omissions.n[kind])
            plb_list_writer_omission(&w, (omission_kind)kind, list->omissions.n[kind], NULL);
    for (int i = 0; answer->warnings[i]; i++)
        plb_list_writer_message(&w, MESSAGE_WARNING, answer->warnings[i]);
    for (size_t i = 0; i < list->clips.n; i++)
        plb_list_writer_clip(&w, &list->clips.v[i]);
    for (size_t i = 0; i < list->items.n; i++)
        plb_list_writer_item(&w, &list->items.v[i]);
    return plb_list_writer_end(&w);
}

static void __attribute__((noreturn)) hand_over(const ps_request *ask, const ps_answer *answer, const error *why)
{
    char number[4][48];
    const char *program;
    size_t length;
    plb_ps_find_program(ask->data, ask->size, &program, &length);
    fprintf(stderr, "%u %d %s %s %s %s %zu %zu %d\n%s\n", answer->sheet, answer->lacks_showpage, plb_format_number(number[0], answer->area.x0, 9),
            plb_format_number(number[1], answer->area.y0, 9), plb_format_number(number[2], answer->area.x1, 9),
            plb_format_number(number[3], answer->area.y1, 9), (size_t)(program - ask->data), length, why->kind == ERROR_UNSUPPORTED, why->text);
    for (int i = 0; answer->warnings[i]; i++)
        fprintf(stderr, "%s\n", answer->warnings[i]);
    fflush(stderr);
    _exit(TAP_HANDED_OVER);
}

static int status_of(error_kind kind)
{
    return kind == ERROR_SYNTAX ? TAP_MALFORMED : kind == ERROR_MEMORY ? TAP_EXIT_MEMORY : kind == ERROR_LIMIT ? TAP_LIMIT : TAP_REFUSED;
}

static ps_request read_command_line(int argc, char **argv)
{
    ps_request ask = {0};
    for (int i = 1; i < argc; i++) {
        bool has_number = !strcmp(argv[i], "--page") && i + 1 < argc;
        if (has_number)
            ask.page = (unsigned)strtoul(argv[++i], NULL, 10);
        else if (!strcmp(argv[i], "--alone"))
            ask.alone = true;
        else if (!strcmp(argv[i], "--count"))
            ask.only_count = true;
        else
            quit(TAP_USAGE, "usage: tap-ps [--page N] [--alone] [--count] <drawing.ps >list");
    }
    return ask;
}

int main(int argc, char **argv)
{
    static display_list list;
    static ps_answer answer;
    error why = {ERROR_NONE, ""};
    ps_request ask = read_command_line(argc, argv);
    ask.data = plb_tap_read_all(&ask.size);
    if (!ask.data)
        quit(TAP_LIMIT, "the file is too large");
    plb_list_init(&list);
    ps_outcome outcome = plb_ps_read(&ask, &list, &answer, &why);
    if (outcome == PS_HANDED_OVER)
        hand_over(&ask, &answer, &why);
    if (outcome == PS_FAILED)
        quit(status_of(why.kind), why.text);
    _exit(write_list(&list, &answer) ? TAP_DONE : TAP_WRITE); /* no time for tidying up */
}
