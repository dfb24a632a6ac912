/* SPDX-License-Identifier: MIT
 *
 * tap-plain: plain SVG (plain_svg.h) on descriptor 0 becomes a display list on descriptor 1, the same that tap-svg
 * would make of it. Exit status 0: that is done. 3: it is not plain, a line on standard error says what is not, and nothing was
 * written: tap-svg is to be asked. It links no more than libxml2, so that it starts soon.
 */
#include "list/text/tap_status.h"
#include "tap/common/tap_stream.h"
#include "tap/plain/plain_svg.h"

#include <stdio.h>
#include <unistd.h>

static void __attribute__((noreturn)) quit(int status, const char *what, const char *which)
{
    fprintf(stderr, "%s", what);
    for (; *which; which++) /* it may quote the document */
        putc(*which < ' ' || *which > '~' ? '?' : *which, stderr);
    putc('\n', stderr);
    fflush(stderr);
    _exit(status);
}

int main(int argc, char **argv)
{
    static plain_list list;
    char why[PLAIN_WHY];
    size_t size;
    (void)argv;
    if (argc > 1)
        quit(TAP_USAGE, "usage: ", "tap-plain <drawing.svg >list");
    char *text = plb_tap_read_all(&size);
    if (!text)
        quit(TAP_REFUSED, "not plain: ", "it is too large");
    if (!plb_plain_svg(text, size, &list, why))
        quit(TAP_REFUSED, "not plain: ", why);
    _exit(plb_tap_put(list.text.v, list.text.n) ? TAP_DONE : TAP_WRITE); /* no time for tidying up */
}
