/* SPDX-License-Identifier: MIT
 *
 * Tries what a foreign program could do to its user, if it were taken over by a drawing:
 *
 *     burglar FOLDER PID SHM QUEUE SEMAPHORES POINTER
 *
 * FOLDER holds the file `bait` and the datagram socket `socket`; PID is somebody else; SHM, QUEUE and SEMAPHORES are objects of
 * System V, or -1; POINTER is the address that our execve got. Prints a word for each deed that succeeded. `burglar threads N`
 * starts N threads and waits.
 */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

/* Numbers of calls that are younger than some headers; the same on every architecture. */
enum { PIDFD_OPEN = 434, IO_URING_SETUP = 425, FSPICK = 433, FCHMODAT2 = 452, SETXATTRAT = 463, FILE_SETATTR = 469 };

typedef struct {
    char bait[512], folder[512], socket[100], made[512], moved[512], self[512];
    pid_t other;
    int shm, queue, semaphores;
    char *pointer;
} target;

static const char *path_in(char *path, size_t size, const char *folder, const char *name)
{
    snprintf(path, size, "%s/%s", folder, name);
    return path;
}

/* ---- files --------------------------------------------------------------------------------------------------- */

static int opens(const char *path, int flags)
{
    int fd = open(path, flags, 0600);
    if (fd >= 0)
        close(fd);
    return fd >= 0;
}

static int reads(const target *t) { return opens(t->bait, O_RDONLY); }
static int lists(const target *t) { return opens(t->folder, O_RDONLY | O_DIRECTORY); }
static int reads_passwd(const target *t) { return (void)t, opens("/etc/passwd", O_RDONLY); }
static int reads_environ(const target *t) { return (void)t, opens("/proc/self/environ", O_RDONLY); }
static int reads_memory(const target *t)
{
    char path[64];
    snprintf(path, sizeof path, "/proc/%ld/mem", (long)t->other);
    return opens(path, O_RDONLY) || opens(path, O_RDWR);
}
static int writes(const target *t) { return opens(t->bait, O_WRONLY); }
static int creates(const target *t) { return opens(t->made, O_WRONLY | O_CREAT); }
static int makes_nameless(const target *t) { return (void)t, opens("/tmp", O_WRONLY | O_TMPFILE); }
static int truncates(const target *t) { return truncate(t->bait, 1) == 0; }
static int truncates_open(const target *t) { return opens(t->bait, O_RDONLY | O_TRUNC); }
static int opens_for_neither(const target *t) { return opens(t->bait, O_ACCMODE); }
static int changes_mode(const target *t) { return chmod(t->bait, 0600) == 0; }
static int changes_mode_anew(const target *t) { return syscall(FCHMODAT2, AT_FDCWD, t->bait, 0600, 0) == 0; }
static int makes_folder(const target *t)
{
    char path[600];
    return mkdir(path_in(path, sizeof path, t->folder, "folder"), 0700) == 0;
}
static int makes_symlink(const target *t)
{
    char path[600];
    return symlink(t->bait, path_in(path, sizeof path, t->folder, "soft")) == 0;
}
static int makes_link(const target *t)
{
    char path[600];
    return link(t->bait, path_in(path, sizeof path, t->folder, "hard")) == 0;
}
static int sets_attribute(const target *t)
{
    struct {
        unsigned long long value;
        unsigned size, flags;
    } what = {(unsigned long long)(size_t) "1", 1, 0};
    return syscall(SETXATTRAT, AT_FDCWD, t->bait, 0, "user.burglar", &what, sizeof what) == 0;
}
static int sets_flags(const target *t)
{
    struct {
        unsigned long long flags;
        unsigned extent_size, extents, project, cow;
    } what = {0x80, 0, 0, 0, 0}; /* FS_XFLAG_NODUMP */
    return syscall(FILE_SETATTR, AT_FDCWD, t->bait, &what, sizeof what, 0) == 0;
}
static int renames(const target *t) { return rename(t->bait, t->moved) == 0; }
static int unlinks(const target *t) { return unlink(t->moved) == 0 || unlink(t->bait) == 0; }
static int watches(const target *t)
{
    int fd = inotify_init1(0);
    return fd >= 0 && inotify_add_watch(fd, t->folder, IN_ALL_EVENTS) >= 0;
}

/* ---- the network and other programs ------------------------------------------------------------------------- */

static int connects(const target *t)
{
    (void)t;
    int s = socket(AF_INET, SOCK_STREAM, 0);
    if (s >= 0) /* refused or not: it could have been tried */
        close(s);
    return s >= 0;
}

/* Words, and a descriptor with them, to whoever listens there. */
static int sends(const target *t)
{
    int pair[2];
    struct sockaddr_un to = {.sun_family = AF_UNIX};
    snprintf(to.sun_path, sizeof to.sun_path, "%.90s", t->socket);
    if (socketpair(AF_UNIX, SOCK_DGRAM, 0, pair) != 0)
        return 0;
    union {
        char bytes[CMSG_SPACE(sizeof(int))];
        struct cmsghdr head;
    } with = {.head = {CMSG_LEN(sizeof(int)), SOL_SOCKET, SCM_RIGHTS}};
    struct iovec words = {"x", 1};
    struct msghdr m = {&to, sizeof to, &words, 1, with.bytes, sizeof with.bytes, 0};
    return sendto(pair[0], "x", 1, 0, (struct sockaddr *)&to, sizeof to) == 1 || sendmsg(pair[0], &m, 0) == 1;
}

static int attaches_memory(const target *t) { return t->shm >= 0 && shmat(t->shm, NULL, 0) != (void *)-1; }
static int makes_memory(const target *t) { return (void)t, shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600) >= 0; }
static int removes_queue(const target *t)
{
    struct {
        long type;
        char text[1];
    } m = {1, "x"};
    return t->queue >= 0 && (msgsnd(t->queue, &m, 1, IPC_NOWAIT) == 0 || msgctl(t->queue, IPC_RMID, NULL) == 0);
}
static int removes_semaphores(const target *t) { return t->semaphores >= 0 && semctl(t->semaphores, 0, IPC_RMID) == 0; }

/* ---- other processes: each gets what it has ----------------------------------------------------------------- */

static int schedules(const target *t)
{
    struct sched_param p;
    return sched_getparam(t->other, &p) == 0 && sched_setscheduler(t->other, sched_getscheduler(t->other), &p) == 0;
}
static int pins(const target *t)
{
    cpu_set_t set;
    return sched_getaffinity(t->other, sizeof set, &set) == 0 && sched_setaffinity(t->other, sizeof set, &set) == 0;
}
static int slows(const target *t)
{
    long now = syscall(SYS_ioprio_get, 1, t->other);
    return now >= 0 && syscall(SYS_ioprio_set, 1, t->other, now) == 0;
}
static int signals(const target *t) { return kill(t->other, 0) == 0 || syscall(SYS_tgkill, t->other, t->other, 0) == 0; }
static int signals_by_descriptor(const target *t)
{
    int ends[2];
    return pipe(ends) == 0 && fcntl(ends[0], F_SETOWN, t->other) == 0 && fcntl(ends[0], F_GETOWN) == t->other;
}
static int asks_for_signals(const target *t)
{
    (void)t;
    int ends[2];
    return pipe(ends) == 0 && fcntl(ends[0], F_SETFL, O_ASYNC) == 0;
}
static int opens_process(const target *t) { return syscall(PIDFD_OPEN, t->other, 0) >= 0; }
static int traces(const target *t)
{
    if (ptrace(PTRACE_SEIZE, t->other, 0, 0) != 0)
        return 0;
    ptrace(PTRACE_DETACH, t->other, 0, 0);
    return 1;
}
static int outlives(const target *t) { return (void)t, prctl(PR_SET_PDEATHSIG, 0) == 0; }
static int raises_limits(const target *t)
{
    struct rlimit r;
    (void)t;
    getrlimit(RLIMIT_CPU, &r);
    return setrlimit(RLIMIT_CPU, &r) == 0;
}

/* ---- the machine, mostly for root --------------------------------------------------------------------------- */

static int watches_all(const target *t) { return (void)t, syscall(SYS_fanotify_init, 0, 0) >= 0; }
static int picks_file_system(const target *t) { return (void)t, syscall(FSPICK, AT_FDCWD, "/", 0) >= 0; }
static int unshares(const target *t) { return (void)t, unshare(CLONE_NEWUSER) == 0; }
static int asks_ring(const target *t)
{
    char parameters[256] = {0};
    return (void)t, syscall(IO_URING_SETUP, 1, parameters) >= 0;
}
/* One of a number that no kernel has yet is not known (ENOSYS) or not allowed (EPERM); others would mean that it was looked at. */
static int calls_unknown(const target *t) { return (void)t, syscall(5000) >= 0 || (errno != ENOSYS && errno != EPERM); }
#ifdef __x86_64__
static int calls_x32(const target *t) { return (void)t, syscall(0x40000000 | SYS_getpid) > 0; }
#else
static int calls_x32(const target *t) { return (void)t, 0; }
#endif

/* ---- programs ------------------------------------------------------------------------------------------------ */

static int forks(const target *t)
{
    (void)t;
    pid_t child = fork();
    if (child == 0)
        _exit(0);
    return child > 0 && waitpid(child, NULL, 0) == child;
}

static int executes(const target *t)
{
    (void)t;
    pid_t child = vfork();
    if (child == 0) {
        execl("/bin/true", "true", (char *)NULL);
        _exit(9);
    }
    int status = 1;
    return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

/* The last deed: another program in place of this one, which says "again"; first by a name where our own execve had it. */
static int executes_again(const target *t)
{
    size_t page = 4096;
    char *start = (char *)((size_t)t->pointer & ~(page - 1)), *again[] = {"burglar", "again", NULL};
    fflush(stdout);
    if (start && mmap(start, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) == start) {
        snprintf(t->pointer, 512, "%s", t->self);
        execve(t->pointer, again, environ);
    }
    execve(t->self, again, environ);
    syscall(SYS_execveat, AT_FDCWD, t->self, again, environ, 0);
    return 0;
}

/* ---- all ----------------------------------------------------------------------------------------------------- */

static const struct {
    const char *word;
    int (*done)(const target *);
} deeds[] = {
    {"read", reads}, {"list", lists}, {"passwd", reads_passwd}, {"environ", reads_environ}, {"memory", reads_memory},
    {"write", writes}, {"create", creates}, {"nameless", makes_nameless}, {"truncate", truncates}, {"open-truncate", truncates_open},
    {"neither", opens_for_neither}, {"chmod", changes_mode}, {"fchmodat2", changes_mode_anew}, {"mkdir", makes_folder},
    {"symlink", makes_symlink}, {"link", makes_link}, {"setxattrat", sets_attribute}, {"file_setattr", sets_flags},
    {"rename", renames}, {"unlink", unlinks}, {"inotify", watches}, {"connect", connects}, {"send", sends},
    {"shmat", attaches_memory}, {"shmget", makes_memory}, {"queue", removes_queue}, {"semaphore", removes_semaphores},
    {"scheduler", schedules}, {"affinity", pins}, {"ioprio", slows}, {"signal", signals}, {"setown", signals_by_descriptor},
    {"async", asks_for_signals}, {"pidfd", opens_process}, {"trace", traces}, {"deathsig", outlives}, {"limits", raises_limits},
    {"fanotify", watches_all}, {"fspick", picks_file_system}, {"unshare", unshares}, {"ring", asks_ring}, {"unknown", calls_unknown},
    {"x32", calls_x32}, {"fork", forks}, {"execute", executes}, {"executed", executes_again},
};

static void *sleeper(void *nothing)
{
    sleep(5);
    return nothing;
}

static int start_threads(long n)
{
    pthread_attr_t small;
    pthread_t thread;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 16384);
    while (n > 0 && pthread_create(&thread, &small, sleeper, NULL) == 0)
        n--;
    printf("%ld threads less than asked for\n", n);
    fflush(stdout);
    sleep(5);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "again"))
        return puts("again") < 0;
    if (argc == 3 && !strcmp(argv[1], "threads"))
        return start_threads(atol(argv[2]));
    if (argc != 7)
        return 2;
    target t = {.other = (pid_t)atoi(argv[2]), .shm = atoi(argv[3]), .queue = atoi(argv[4]), .semaphores = atoi(argv[5]),
                .pointer = (char *)strtoul(argv[6], NULL, 16)};
    snprintf(t.folder, sizeof t.folder, "%s", argv[1]);
    path_in(t.bait, sizeof t.bait, argv[1], "bait");
    path_in(t.socket, sizeof t.socket, argv[1], "socket");
    path_in(t.made, sizeof t.made, argv[1], "made");
    path_in(t.moved, sizeof t.moved, argv[1], "moved");
    snprintf(t.self, sizeof t.self, "%s", argv[0]);
    for (size_t i = 0; i < sizeof deeds / sizeof *deeds; i++)
        if (deeds[i].done(&t))
            printf("%s ", deeds[i].word);
    fflush(stdout);
    return 0;
}
