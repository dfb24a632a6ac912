/* SPDX-License-Identifier: MIT
 *
 * See keeper.h. The keeper waits for a byte, which dismisses it, or for the end of the line.
 */
#define _GNU_SOURCE /* SYS_close_range, SOCK_CLOEXEC */
#include "base/keeper.h"

#include <errno.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

static _Noreturn void keep(void (*clean)(const char *path), const char *path, int line)
{
    char byte;
    ssize_t n;
    setsid(); /* out of reach of Ctrl-C */
    signal(SIGTERM, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    signal(SIGINT, SIG_IGN);
    dup2(line, 0); /* nothing of ours may stay open: others wait for its end */
    if (syscall(SYS_close_range, 1u, ~0u, 0u) != 0)
        for (int fd = 1; fd < 65536; fd++)
            close(fd);
    while ((n = read(0, &byte, 1)) < 0 && errno == EINTR) {}
    if (n <= 0)
        clean(path);
    _exit(0);
}

bool plb_keeper_start(keeper *k, void (*clean)(const char *path), const char *path)
{
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return false;
    k->pid = fork();
    if (k->pid == 0) {
        close(ends[1]);
        keep(clean, path, ends[0]);
    }
    int reason = errno;
    close(ends[0]);
    k->line = ends[1];
    if (k->pid < 0)
        close(ends[1]);
    errno = reason;
    return k->pid > 0;
}

void plb_keeper_end(keeper *k, bool must_clean)
{
    if (!must_clean)
        send(k->line, "", 1, MSG_NOSIGNAL);
    close(k->line);
    while (waitpid(k->pid, NULL, 0) < 0 && errno == EINTR) {}
}
