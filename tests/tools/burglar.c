/* SPDX-License-Identifier: MIT
 *
 * Tries what a foreign program could do to its user, if it were taken over by a drawing: burglar FOLDER PID. FOLDER
 * holds the file `bait`; PID is somebody else. Prints a word for each deed that succeeded.
 */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

static void tell(const char *deed, int done)
{
    if (done)
        printf("%s ", deed);
}

static int opens(const char *path, int flags)
{
    int fd = open(path, flags, 0600);
    if (fd >= 0)
        close(fd);
    return fd >= 0;
}

static int connects(void)
{
    struct sockaddr_in to = {.sin_family = AF_INET, .sin_port = htons(9), .sin_addr = {htonl(INADDR_LOOPBACK)}};
    int s = socket(AF_INET, SOCK_STREAM, 0);
    if (s < 0)
        return 0;
    connect(s, (struct sockaddr *)&to, sizeof to); /* refused or not: it could have been tried */
    close(s);
    return 1;
}

static int forks(void)
{
    pid_t child = fork();
    if (child == 0)
        _exit(0);
    return child > 0 && waitpid(child, NULL, 0) == child;
}

static int executes(void)
{
    pid_t child = vfork();
    if (child == 0) {
        execl("/bin/true", "true", (char *)NULL);
        _exit(9);
    }
    int status = 1;
    return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

static int traces(pid_t other)
{
    if (ptrace(PTRACE_SEIZE, other, 0, 0) != 0)
        return 0;
    ptrace(PTRACE_DETACH, other, 0, 0);
    return 1;
}

static int raises_limits(void)
{
    struct rlimit r;
    getrlimit(RLIMIT_CPU, &r);
    return setrlimit(RLIMIT_CPU, &r) == 0;
}

int main(int argc, char **argv)
{
    if (argc != 3 || chdir(argv[1]) != 0)
        return 2;
    pid_t other = (pid_t)atoi(argv[2]);
    tell("read", opens("bait", O_RDONLY));
    tell("list", opens(".", O_RDONLY | O_DIRECTORY));
    tell("passwd", opens("/etc/passwd", O_RDONLY));
    tell("environ", opens("/proc/self/environ", O_RDONLY));
    tell("write", opens("bait", O_WRONLY));
    tell("create", opens("new", O_WRONLY | O_CREAT));
    tell("tmp", opens("/tmp", O_WRONLY | O_TMPFILE));
    tell("truncate", truncate("bait", 1) == 0);
    tell("chmod", chmod("bait", 0600) == 0);
    tell("mkdir", mkdir("folder", 0700) == 0);
    tell("symlink", symlink("bait", "soft") == 0);
    tell("link", link("bait", "hard") == 0);
    tell("rename", rename("bait", "moved") == 0);
    tell("unlink", unlink("moved") == 0 || unlink("bait") == 0);
    tell("connect", connects());
    tell("fork", forks());
    tell("execute", executes());
    tell("signal", kill(other, 0) == 0);
    tell("limits", raises_limits());
    tell("trace", traces(other));
    fflush(stdout);
    return 0;
}
