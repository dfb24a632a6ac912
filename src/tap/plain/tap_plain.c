/* SPDX-License-Identifier: MIT
 *
 * tap-plain: plain SVG (plain_svg.h) on descriptor 0 becomes a display list on descriptor 1, the same that tap-svg
 * would make of it. Exit status 0: that is done. 3: it is not plain, a line on standard error says what is not, and nothing was
 * written: tap-svg is to be asked. It links no more than libxml2, so that it starts soon.
 */
#include "list/text/tap_status.h"
#include "tap/plain/plain_svg.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define PART_BYTES ((size_t)1 << 18)

static void __attribute__((noreturn)) quit(int status, const char *what, const char *which)
{
    fprintf(stderr, "%s", what);
    for (; *which; which++) /* it may quote the document */
        putc(*which < ' ' || *which > '~' ? '?' : *which, stderr);
    putc('\n', stderr);
    fflush(stderr);
    _exit(status);
}

/* Reads the whole document. */
static char *read_document(size_t *size)
{
    char *all = NULL;
    size_t capacity = 0;
    for (*size = 0;;) {
        if (capacity - *size < PART_BYTES) {
            capacity = capacity ? capacity * 2 : 2 * PART_BYTES;
            char *more = *size > TAP_MAX_BYTES ? NULL : realloc(all, capacity);
            if (!more)
                quit(TAP_REFUSED, "not plain: ", "it is too large");
            all = more;
        }
        ssize_t n = read(STDIN_FILENO, all + *size, PART_BYTES);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return all;
        *size += (size_t)n;
    }
}

static void put(const char *text, size_t size)
{
    for (size_t done = 0; done < size;) {
        ssize_t n = write(STDOUT_FILENO, text + done, size - done);
        if (n < 0 && errno != EINTR)
            _exit(TAP_WRITE); /* the reader went away: nobody is left to tell */
        done += n < 0 ? 0 : (size_t)n;
    }
}

int main(int argc, char **argv)
{
    static plain_list list;
    char why[PLAIN_WHY];
    size_t size;
    (void)argv;
    if (argc > 1)
        quit(TAP_USAGE, "usage: ", "tap-plain <drawing.svg >list");
    char *text = read_document(&size);
    if (!plb_plain_svg(text, size, &list, why))
        quit(TAP_REFUSED, "not plain: ", why);
    put(list.text.v, list.text.n);
    _exit(TAP_DONE); /* no time for tidying up */
}
