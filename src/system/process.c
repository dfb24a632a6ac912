/* SPDX-License-Identifier: MIT
 *
 * This file runs a helper process: fork, limits, three pipes, one poll loop.
 */
#define _DEFAULT_SOURCE /* wait4, syscall */
#include "system/process.h"

#include "base/array.h"
#include "system/sandbox/sandbox.h"
#include "system/watch.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#define BUFFER_BYTES ((size_t)1 << 16)
#define ENVIRONMENT_MAX 64
#define TIMES_SILENT 3     /* the limit on processor time, while nothing is done */
#define PATIENCE_AT_END 1  /* s for a process that has closed its output */
#define CHILD_STACK_BYTES ((rlim_t)8 << 20)
#define TASKS_MORE 512     /* than the machine has now: the user's other programs start some meanwhile */

extern char **environ;

/* ---- the child -------------------------------------------------------------------------------------------- */

/* Everything the child needs, made before the fork: afterwards only async-signal-safe calls are allowed. */
typedef struct {
    int in, out, err;
    int last_descriptor;
    process_limits limits;
    double seconds; /* what is left of limits.seconds */
    rlim_t file_size, tasks;
    pid_t parent;
    cage cage;
    const char *program;
    const char *const *argv;
    char path[24], locale[12], hashing[24], folder[1100];
    char *environment[ENVIRONMENT_MAX + 1];
} child_plan;

/* The child gets the variables by which fonts are found, and nothing else of the user's environment. */
static bool is_passed_on(const char *variable)
{
    static const char *const kept[] = {"HOME=", "XDG_", "FONTCONFIG_", NULL};
    for (int i = 0; kept[i]; i++)
        if (!strncmp(variable, kept[i], strlen(kept[i])))
            return true;
    return false;
}

/* Lowers the limit on memory to the one of this process, which the child cannot exceed and which messages should name. */
static process_limits within_ours(process_limits l)
{
    struct rlimit ours;
    if (getrlimit(RLIMIT_AS, &ours) == 0 && ours.rlim_cur < l.memory)
        l.memory = (size_t)ours.rlim_cur;
    return l;
}

static void plan_environment(child_plan *plan)
{
    int n = 0;
    strcpy(plan->path, "PATH=/usr/bin:/bin");
    strcpy(plan->locale, "LC_ALL=C");
    plan->environment[n++] = plan->path;
    plan->environment[n++] = plan->locale;
    strcpy(plan->hashing, "PYTHONHASHSEED=0"); /* the same output every time, of Python too */
    plan->environment[n++] = plan->hashing;
    if (plan->limits.scratch && snprintf(plan->folder, sizeof plan->folder, "TMPDIR=%s", plan->limits.scratch) > 0)
        plan->environment[n++] = plan->folder;
    for (char **e = environ; e && *e && n < ENVIRONMENT_MAX; e++)
        if (is_passed_on(*e))
            plan->environment[n++] = *e;
    plan->environment[n] = NULL;
}

/* Returns the highest descriptor open now, and some more for those that other threads open meanwhile. */
static int highest_descriptor(void)
{
    int highest = 255;
    DIR *open_now = opendir("/proc/self/fd");
    if (!open_now)
        return 65535;
    for (struct dirent *e; (e = readdir(open_now));) {
        long fd = strtol(e->d_name, NULL, 10);
        if (fd > highest && fd < 1 << 20)
            highest = (int)fd;
    }
    closedir(open_now);
    return highest + 64;
}

static void limit(int what, rlim_t soft, rlim_t hard)
{
    struct rlimit ours, r = {soft, hard};
    if (getrlimit(what, &ours) == 0 && ours.rlim_max < hard) /* nobody can give more than there is */
        r = (struct rlimit){ours.rlim_max < soft ? ours.rlim_max : soft, ours.rlim_max};
    setrlimit(what, &r);
}

static _Noreturn void be_child(const child_plan *plan)
{
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGXFSZ, SIG_IGN); /* a font cache that cannot be written is no reason to die */
    rlim_t seconds = (rlim_t)ceil(plan->seconds);
    limit(RLIMIT_CPU, seconds, seconds + 1);
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_NOFILE, 256, 256);
    limit(RLIMIT_FSIZE, plan->file_size, plan->file_size);
    limit(RLIMIT_STACK, CHILD_STACK_BYTES, CHILD_STACK_BYTES);
    if (!plan->limits.loose)
        limit(RLIMIT_NPROC, plan->tasks, plan->tasks);
    if (!SECCOMP_IS_OFF) /* a sanitizer reserves terabytes */
        limit(RLIMIT_AS, plan->limits.memory, plan->limits.memory);
    /* our ends are above 2 (see open_ends), so none of these overwrites another */
    if (dup2(plan->in, 0) < 0 || dup2(plan->out, 1) < 0 || dup2(plan->err, 2) < 0)
        _exit(127);
    if (syscall(SYS_close_range, 3u, ~0u, 0u) != 0) /* a kernel before 5.9 */
        for (int fd = 3; fd <= plan->last_descriptor; fd++)
            close(fd);
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* nobody would read what it writes */
    if (getppid() != plan->parent)
        _exit(127);
    char *const *argv = (char *const *)plan->argv; /* execve takes no const and keeps it */
    if (plan->limits.loose)
        execve(plan->program, argv, plan->environment);
    else if (!plb_sandbox_enter(&plan->cage))
        _exit(126);
    else if (plan->cage.calls.n)
        plb_seccomp_execute(&plan->cage.calls, plan->program, argv, plan->environment);
    else
        execve(plan->program, argv, plan->environment);
    _exit(127);
}

/* ---- starting --------------------------------------------------------------------------------------------- */

static void close_end(int *fd)
{
    if (*fd >= 0)
        close(*fd);
    *fd = -1;
}

static void close_ends(int ends[6])
{
    for (int i = 0; i < 6; i++)
        close_end(&ends[i]);
}

/* Moves a descriptor above 2 and closes it on exec. */
static bool lift(int *fd)
{
    int up = fcntl(*fd, F_DUPFD_CLOEXEC, 3);
    if (up < 0)
        return false;
    close(*fd);
    *fd = up;
    return true;
}

/* ends[0], [2], [4] are ours: input, output, messages. The input goes through a socket, where writing to a dead
 * process need not raise SIGPIPE. */
static bool open_ends(int ends[6])
{
    for (int i = 0; i < 6; i++)
        ends[i] = -1;
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) || pipe(ends + 2) || pipe(ends + 4))
        return false;
    for (int i = 0; i < 6; i++)
        if (!lift(&ends[i]))
            return false;
    shutdown(ends[0], SHUT_RD);
    for (int i = 0; i < 6; i += 2)
        fcntl(ends[i], F_SETFL, O_NONBLOCK);
    return true;
}

/* A cap that holds for users, not for root (see watch.h, which counts threads too): the kernel counts a user's tasks in all. */
static rlim_t tasks_allowed(void)
{
    struct sysinfo now;
    return sysinfo(&now) == 0 ? (rlim_t)now.procs + TASKS_MORE : RLIM_INFINITY;
}

/* Fills the plan with all but what open_ends and the caller give. */
static void plan_child(child_plan *plan)
{
    const process_limits *l = &plan->limits;
    plan->seconds = fmax(l->seconds - (l->spent ? *l->spent : 0), 1);
    plan->file_size = !l->scratch ? 0 : l->memory < PROCESS_SCRATCH_BYTES ? l->memory : PROCESS_SCRATCH_BYTES;
    plan->tasks = tasks_allowed();
    plan->parent = getpid();
    plan->last_descriptor = highest_descriptor();
    plan_environment(plan);
    plb_sandbox_plan(&plan->cage, plan->program, l->scratch, !l->single, plan->environment);
}

static void start_watch(process *p, const child_plan *plan)
{
    p->watch = (process_watch){.pid = p->pid, .patience = TIMES_SILENT * p->limits.seconds, .scratch = p->limits.scratch,
                               .max_bytes = p->limits.memory, .file_size = (size_t)plan->file_size};
}

bool plb_process_start(process *p, const char *program, const char *const argv[], const char *input, size_t size,
                       const process_limits *limits, error *err)
{
    int ends[6];
    *p = (process){.pid = -1, .in = -1, .out = -1, .err = -1, .input = input, .input_left = size};
    p->limits = within_ours(limits && limits->seconds > 0 ? *limits : PROCESS_LIMITS);
    p->buffer = plb_new(BUFFER_BYTES, 1);
    if (!p->buffer)
        return plb_fail_memory(err);
    if (!open_ends(ends)) {
        plb_fail(err, ERROR_HELPER, "cannot start %s: %s", program, strerror(errno));
        close_ends(ends);
        plb_free(p->buffer);
        return false;
    }
    child_plan plan = {.in = ends[1], .out = ends[3], .err = ends[5], .limits = p->limits, .program = program, .argv = argv};
    plan_child(&plan);
    p->cage = plb_sandbox_name(&plan.cage);
    p->pid = fork();
    if (p->pid == 0)
        be_child(&plan);
    if (p->pid < 0) {
        plb_fail(err, ERROR_HELPER, "cannot start %s: %s", program, strerror(errno));
        close_ends(ends);
        plb_free(p->buffer);
        return false;
    }
    start_watch(p, &plan);
    p->in = ends[0];
    p->out = ends[2];
    p->err = ends[4];
    for (int i = 1; i < 6; i += 2)
        close_end(&ends[i]);
    return true;
}

/* ---- running ---------------------------------------------------------------------------------------------- */

static void feed(process *p)
{
    while (p->input_left) {
        size_t part = p->input_left < BUFFER_BYTES ? p->input_left : BUFFER_BYTES;
        ssize_t n = send(p->in, p->input, part, MSG_NOSIGNAL);
        if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR))
            return;
        if (n < 0)
            break; /* the process closed its input before the end, as a program may that has seen enough: no fault */
        p->input += n;
        p->input_left -= (size_t)n;
    }
    close_end(&p->in);
}

static void read_message(process *p)
{
    char part[1024];
    ssize_t n = read(p->err, part, sizeof part);
    if (n < 0 && (errno == EAGAIN || errno == EINTR))
        return;
    if (n <= 0) {
        close_end(&p->err);
        return;
    }
    size_t left = sizeof p->message - 1 - p->message_length, take = (size_t)n < left ? (size_t)n : left;
    memcpy(p->message + p->message_length, part, take);
    p->message_length += take;
    p->message[p->message_length] = '\0';
}

/* Reads some output. Returns 1 when bytes came, 0 when there are none yet, -1 at the end. */
static int read_output(process *p, size_t *size)
{
    ssize_t n = read(p->out, p->buffer, BUFFER_BYTES);
    if (n > 0) {
        *size = (size_t)n;
        return 1;
    }
    if (n < 0 && (errno == EAGAIN || errno == EINTR))
        return 0;
    close_end(&p->out);
    return -1;
}

/* Looks at the process; false when it must be ended. */
static bool may_go_on(process *p)
{
    error fault = {0};
    watch_result r = plb_watch_look(&p->watch, &fault);
    if (r == WATCH_OVERSTEPPED)
        p->fault = fault;
    if (r != WATCH_FINE)
        p->end = r == WATCH_OVERSTEPPED ? PROCESS_OVERSTEPPED : PROCESS_TIMED_OUT;
    if (r != WATCH_FINE || !p->limits.may_go_on || p->watch.looked - p->asked < WATCH_TICK)
        return r == WATCH_FINE;
    p->asked = p->watch.looked;
    if (p->limits.may_go_on(p->limits.closure))
        return true;
    p->end = PROCESS_STOPPED;
    return false;
}

/* Waits until something can be read or written; false when the process must be ended. */
static bool wait_for_ends(process *p, struct pollfd ends[3])
{
    ends[0] = (struct pollfd){.fd = p->in, .events = POLLOUT};
    ends[1] = (struct pollfd){.fd = p->out, .events = POLLIN};
    ends[2] = (struct pollfd){.fd = p->err, .events = POLLIN};
    for (;;) {
        int n = poll(ends, 3, (int)(1000 * plb_watch_tick(&p->watch)));
        if (!may_go_on(p) || (n < 0 && errno != EINTR))
            return false;
        if (n > 0)
            return true;
    }
}

bool plb_process_read(process *p, const char **data, size_t *size)
{
    plb_watch_resume(&p->watch);
    while (p->out >= 0) {
        struct pollfd ends[3];
        if (!wait_for_ends(p, ends)) {
            close_end(&p->out);
            return false;
        }
        if (ends[0].revents)
            feed(p);
        if (ends[2].revents)
            read_message(p);
        if (ends[1].revents && read_output(p, size) > 0) {
            *data = p->buffer;
            return true;
        }
    }
    return false;
}

/* ---- ending ----------------------------------------------------------------------------------------------- */

static double seconds(struct timeval t) { return (double)t.tv_sec + 1e-6 * (double)t.tv_usec; }

/* Reads the rest of the process's message and reaps it. A process that has closed its output should be gone soon; one that is not, or
 * oversteps now, is killed, and the result says so. */
static bool reap(process *p, int *status)
{
    struct rusage use = {0};
    bool is_forced = false;
    pid_t r;
    p->watch.patience = PATIENCE_AT_END;
    p->watch.waited = 0;
    plb_watch_resume(&p->watch);
    while ((r = wait4(p->pid, status, WNOHANG, &use)) == 0 || (r < 0 && errno == EINTR)) {
        struct pollfd one = {.fd = p->err, .events = POLLIN};
        if (poll(&one, 1, p->err < 0 ? 1 : (int)(1000 * plb_watch_tick(&p->watch))) > 0)
            read_message(p);
        if (!is_forced && p->end == PROCESS_RUNNING && !may_go_on(p)) {
            kill(p->pid, SIGKILL);
            is_forced = true;
        }
    }
    while (p->err >= 0 && poll(&(struct pollfd){.fd = p->err, .events = POLLIN}, 1, 0) > 0)
        read_message(p);
    if (r == p->pid && p->limits.spent)
        *p->limits.spent += seconds(use.ru_utime) + seconds(use.ru_stime);
    return r == p->pid;
}

void plb_process_finish(process *p)
{
    error fault = {0};
    int status = 0;
    if (p->out >= 0 || p->end != PROCESS_RUNNING)
        kill(p->pid, SIGKILL);
    bool is_whole = p->out < 0 && p->end == PROCESS_RUNNING;
    close_end(&p->in);
    close_end(&p->out);
    if (!reap(p, &status))
        status = 0;
    close_end(&p->err);
    plb_free(p->buffer);
    p->buffer = NULL;
    /* the process may have written between the last look and its end */
    if (p->end == PROCESS_RUNNING && p->limits.scratch && plb_watch_check(&p->watch, &fault) == WATCH_OVERSTEPPED) {
        p->end = PROCESS_OVERSTEPPED;
        p->fault = fault;
    }
    if (p->end != PROCESS_RUNNING)
        return;
    p->end = WIFSIGNALED(status) ? PROCESS_CRASHED : PROCESS_EXITED;
    p->code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    /* the soft limit sends SIGXCPU, the hard one SIGKILL, which nobody else sends to a process that ran to its end */
    if (p->end == PROCESS_CRASHED && (p->code == SIGXCPU || (is_whole && p->code == SIGKILL)))
        p->end = PROCESS_TIMED_OUT;
}

/* ---- finding the program ---------------------------------------------------------------------------------- */

static bool is_program(const char *path)
{
    return access(path, X_OK) == 0;
}

/* Puts the directory of the running program into `path`; false when it is unknown. */
static bool own_directory(char path[PROCESS_PATH_MAX])
{
    ssize_t n = readlink("/proc/self/exe", path, PROCESS_PATH_MAX - 1);
    if (n <= 0)
        return false;
    path[n] = '\0';
    char *slash = strrchr(path, '/');
    if (!slash)
        return false;
    *slash = '\0';
    return true;
}

static bool join(char path[PROCESS_PATH_MAX], const char *directory, const char *between, const char *name)
{
    int n = snprintf(path, PROCESS_PATH_MAX, "%s%s/%s", directory, between, name);
    return n > 0 && n < PROCESS_PATH_MAX && is_program(path);
}

bool plb_process_find_installed(const char *name, char path[PROCESS_PATH_MAX])
{
    const char *at = "/usr/local/bin:/usr/bin:/bin";
    for (char **e = environ; e && *e; e++)
        if (!strncmp(*e, "PATH=", 5))
            at = *e + 5;
    for (;; at++) {
        size_t n = strcspn(at, ":");
        int length = snprintf(path, PROCESS_PATH_MAX, "%.*s/%s", n < PROCESS_PATH_MAX ? (int)n : 0, at, name);
        if (n && at[0] == '/' && length < PROCESS_PATH_MAX && is_program(path))
            return true;
        at += n;
        if (!*at)
            return false;
    }
}

bool plb_process_find(const char *helper_dir, const char *name, char path[PROCESS_PATH_MAX], error *err)
{
    char own[PROCESS_PATH_MAX];
    if (helper_dir)
        return join(path, helper_dir, "", name) || plb_fail(err, ERROR_HELPER, "no program %s in %.200s", name, helper_dir);
    if (own_directory(own) && (join(path, own, "", name) || join(path, own, "/../libexec/plumbago", name)))
        return true;
    return join(path, PLB_LIBEXECDIR, "", name) ||
           plb_fail(err, ERROR_HELPER, "the helper program %s is missing: neither beside this program nor in %s", name, PLB_LIBEXECDIR);
}
