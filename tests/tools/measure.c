/* SPDX-License-Identifier: MIT
 *
 * measure COMMAND [ARGUMENT...]: runs it, output thrown away, and prints what it cost with all its children:
 *
 *     cpu SECONDS wall SECONDS peak KIB status N
 *
 * cpu: user and system time of the whole process tree; peak: the largest resident set of any single process in it.
 * Children that the command does not wait for are not counted.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static double seconds(struct timeval t)
{
    return (double)t.tv_sec + (double)t.tv_usec * 1e-6;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static void run(char **command)
{
    int null = open("/dev/null", O_WRONLY);
    if (null >= 0)
        dup2(null, STDOUT_FILENO);
    execvp(command[0], command);
    fprintf(stderr, "measure: %s: %s\n", command[0], strerror(errno));
    _exit(127);
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        fprintf(stderr, "usage: measure COMMAND [ARGUMENT...]\n");
        return 2;
    }
    double start = now();
    pid_t child = fork();
    if (child == 0)
        run(argv + 1);
    int state = 0;
    if (child < 0 || waitpid(child, &state, 0) < 0) {
        perror("measure");
        return 2;
    }
    double wall = now() - start;
    struct rusage use;
    getrusage(RUSAGE_CHILDREN, &use);
    int status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    printf("cpu %.6f wall %.6f peak %ld status %d\n", seconds(use.ru_utime) + seconds(use.ru_stime), wall, use.ru_maxrss, status);
    return status != 0;
}
