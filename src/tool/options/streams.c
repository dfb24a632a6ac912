/* SPDX-License-Identifier: MIT
 *
 * See streams.h.
 */
#include "tool/options/streams.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

bool streams_keep(void)
{
    for (int fd = 0; fd <= 2; fd++)
        if (fcntl(fd, F_GETFD) < 0 && errno == EBADF && open("/dev/null", fd == 0 ? O_WRONLY : O_RDONLY) < 0)
            return false;
    return true;
}

void streams_put(FILE *to, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++)
        fputc((unsigned char)text[i] < ' ' || text[i] == 127 ? '?' : text[i], to);
}

void streams_say(const char *program, const char *kind, const char *text)
{
    fprintf(stderr, "%s: %s", program, kind);
    streams_put(stderr, text, strlen(text));
    fputc('\n', stderr);
}

bool streams_flush(const char *program)
{
    errno = 0;
    if (fflush(stdout) == 0 && !ferror(stdout))
        return true;
    char text[256];
    snprintf(text, sizeof text, "standard output: cannot be written%s%s", errno ? ": " : "", errno ? strerror(errno) : "");
    streams_say(program, "", text);
    return false;
}
