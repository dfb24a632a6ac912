/* SPDX-License-Identifier: MIT
 *
 * See cleanup_process.h. The cleanup_process waits for a byte, which dismisses it, or for the end of the line.
 */
#define _GNU_SOURCE /* SYS_close_range, SOCK_CLOEXEC */
#include "system/cleanup_process.h"

#include <errno.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

/* Waits for a byte from the line; false when the line is broken. */
static bool receive(int line, void *data, size_t size)
{
    ssize_t n;
    while ((n = read(line, data, size)) < 0 && errno == EINTR) {}
    return n == (ssize_t)size;
}

static _Noreturn void keep(const keeper_task *task, const char *path, int line)
{
    char byte;
    setsid(); /* Ctrl-C does not reach another session */
    signal(SIGTERM, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    signal(SIGINT, SIG_IGN);
    signal(SIGPIPE, SIG_IGN);
    int reason = task->make(path, task->descriptor) ? 0 : errno;
    dup2(line, 0); /* all other files are closed: readers of our pipes wait for their end */
    if (syscall(SYS_close_range, 1u, ~0u, 0u) != 0)
        for (int fd = 1; fd < 65536; fd++)
            close(fd);
    bool is_heard = write(0, &reason, sizeof reason) == sizeof reason;
    if (reason == 0 && (!is_heard || !receive(0, &byte, 1)))
        task->remove(path);
    _exit(0);
}

bool plb_cleanup_process_start(cleanup_process *k, const keeper_task *task, const char *path)
{
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return false;
    k->line = ends[1];
    k->pid = fork();
    if (k->pid == 0)
        keep(task, path, ends[0]);
    int reason = errno;
    close(ends[0]);
    if (k->pid > 0 && !receive(k->line, &reason, sizeof reason))
        reason = ECHILD;
    if (k->pid > 0 && reason == 0)
        return true;
    if (k->pid > 0)
        plb_cleanup_process_end(k, true);
    else
        close(k->line);
    errno = reason;
    return false;
}

void plb_cleanup_process_end(cleanup_process *k, bool must_remove)
{
    if (!must_remove)
        send(k->line, "", 1, MSG_NOSIGNAL);
    close(k->line);
    while (waitpid(k->pid, NULL, 0) < 0 && errno == EINTR) {}
}
