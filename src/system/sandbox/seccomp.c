/* SPDX-License-Identifier: MIT
 *
 * See seccomp.h. The list is the sum of what glibc and musl, GLib, librsvg, fontconfig, Python, poppler and Ghostscript call.
 */
#define _GNU_SOURCE /* CLONE_THREAD, pipe2 */
#include "system/sandbox/seccomp.h"

#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <stddef.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/random.h>
#include <sys/syscall.h>
#include <unistd.h>

/* ---- the list ----------------------------------------------------------------------------------------------- */

/* Allowed whatever the arguments. Paths are Landlock's business; signals and descriptors stay within the process. */
static const int allowed[] = {
    /* reading, and writing to what is open */
    SCMP_SYS(read), SCMP_SYS(pread64), SCMP_SYS(readv), SCMP_SYS(write), SCMP_SYS(pwrite64), SCMP_SYS(writev), SCMP_SYS(lseek),
    SCMP_SYS(close), SCMP_SYS(close_range), SCMP_SYS(dup), SCMP_SYS(dup2), SCMP_SYS(dup3), SCMP_SYS(pipe), SCMP_SYS(pipe2),
    SCMP_SYS(eventfd2), SCMP_SYS(poll), SCMP_SYS(ppoll), SCMP_SYS(select), SCMP_SYS(pselect6), SCMP_SYS(fadvise64),
    /* what files are there, and how large */
    SCMP_SYS(stat), SCMP_SYS(lstat), SCMP_SYS(fstat), SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(statfs), SCMP_SYS(fstatfs),
    SCMP_SYS(access), SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd),
    SCMP_SYS(getdents), SCMP_SYS(getdents64),
    /* memory */
    SCMP_SYS(brk), SCMP_SYS(mmap), SCMP_SYS(mprotect), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise),
    /* its own signals, threads and end */
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack), SCMP_SYS(restart_syscall),
    SCMP_SYS(futex), SCMP_SYS(set_robust_list), SCMP_SYS(set_tid_address), SCMP_SYS(rseq), SCMP_SYS(membarrier),
    SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity), SCMP_SYS(arch_prctl), SCMP_SYS(exit), SCMP_SYS(exit_group),
    SCMP_SYS(kill), SCMP_SYS(tgkill), /* to itself alone: see enter_own_signals */
    /* time, chance, and who it is */
    SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(times), SCMP_SYS(nanosleep),
    SCMP_SYS(clock_nanosleep), SCMP_SYS(getrandom), SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(getppid), SCMP_SYS(getuid),
    SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(getrlimit), SCMP_SYS(getrusage), SCMP_SYS(getcpu),
    SCMP_SYS(sysinfo), SCMP_SYS(uname),
};

/* Allowed when these bits of one argument have this value. */
typedef struct {
    int call;
    unsigned argument;
    uint64_t mask, value;
} condition;

#define INT 0xffffffffu /* the kernel looks at no more of an int */
#define ACCESS_AND(flags) ((uint64_t)(O_ACCMODE | (flags)))
/* The flags of a thread as the C libraries start one; musl adds a bit that does nothing. */
#define THREAD_FLAGS (CLONE_VM | CLONE_FS | CLONE_FILES | CLONE_SIGHAND | CLONE_THREAD | CLONE_SYSVSEM | CLONE_SETTLS | \
                      CLONE_PARENT_SETTID | CLONE_CHILD_CLEARTID)
#ifndef CLONE_DETACHED
#define CLONE_DETACHED 0x00400000
#endif
#define NAME_OF_MEMORY 0x53564d41 /* PR_SET_VMA, younger than some headers */

static const condition conditions[] = {
    {SCMP_SYS(fcntl), 1, INT, F_DUPFD}, {SCMP_SYS(fcntl), 1, INT, F_DUPFD_CLOEXEC}, {SCMP_SYS(fcntl), 1, INT, F_GETFD},
    {SCMP_SYS(fcntl), 1, INT, F_SETFD}, {SCMP_SYS(fcntl), 1, INT, F_GETFL},
    {SCMP_SYS(ioctl), 1, INT, TCGETS}, {SCMP_SYS(ioctl), 1, INT, TIOCGWINSZ}, {SCMP_SYS(ioctl), 1, INT, FIONREAD},
    {SCMP_SYS(ioctl), 1, INT, FIOCLEX},
    {SCMP_SYS(prctl), 0, INT, PR_SET_NAME}, {SCMP_SYS(prctl), 0, INT, NAME_OF_MEMORY},
    {SCMP_SYS(prlimit64), 2, UINT64_MAX, 0}, /* asking for limits, not setting them */
};

static const condition of_readers[] = {
    {SCMP_SYS(open), 1, ACCESS_AND(O_CREAT | O_TRUNC), O_RDONLY}, {SCMP_SYS(openat), 2, ACCESS_AND(O_CREAT | O_TRUNC), O_RDONLY},
};

/* A file that is opened for reading is not truncated: old versions of Landlock would not see that. */
static const condition of_writers[] = {
    {SCMP_SYS(open), 1, ACCESS_AND(O_TRUNC), O_RDONLY}, {SCMP_SYS(openat), 2, ACCESS_AND(O_TRUNC), O_RDONLY},
    {SCMP_SYS(open), 1, O_ACCMODE, O_WRONLY}, {SCMP_SYS(openat), 2, O_ACCMODE, O_WRONLY},
    {SCMP_SYS(open), 1, O_ACCMODE, O_RDWR}, {SCMP_SYS(openat), 2, O_ACCMODE, O_RDWR},
    {SCMP_SYS(ftruncate), 0, 0, 0}, {SCMP_SYS(fsync), 0, 0, 0}, {SCMP_SYS(fdatasync), 0, 0, 0},
};

static const condition of_threads[] = {
    {SCMP_SYS(clone), 0, ~(uint64_t)CLONE_DETACHED, THREAD_FLAGS},
};

/* ---- the filter --------------------------------------------------------------------------------------------- */

static bool allow(scmp_filter_ctx list, const condition *c, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const struct scmp_arg_cmp is = {.arg = c[i].argument, .op = SCMP_CMP_MASKED_EQ, .datum_a = c[i].mask, .datum_b = c[i].value};
        if (seccomp_rule_add_array(list, SCMP_ACT_ALLOW, c[i].call, 1, &is) != 0)
            return false;
    }
    return true;
}
#define ALLOW(list, conditions) allow(list, conditions, sizeof(conditions) / sizeof *(conditions))

static bool allow_all(scmp_filter_ctx list, seccomp_rights rights, const uint64_t key[SECCOMP_KEY_PARTS])
{
    for (size_t i = 0; i < sizeof allowed / sizeof *allowed; i++)
        if (seccomp_rule_add(list, SCMP_ACT_ALLOW, allowed[i], 0) != 0)
            return false;
    const struct scmp_arg_cmp opened[SECCOMP_KEY_PARTS] = {{.arg = 3, .op = SCMP_CMP_EQ, .datum_a = key[0]},
                                                           {.arg = 4, .op = SCMP_CMP_EQ, .datum_a = key[1]},
                                                           {.arg = 5, .op = SCMP_CMP_EQ, .datum_a = key[2]}};
    return ALLOW(list, conditions) && (rights.writes ? ALLOW(list, of_writers) : ALLOW(list, of_readers)) &&
           (!rights.threads || ALLOW(list, of_threads)) &&
           seccomp_rule_add_array(list, SCMP_ACT_ALLOW, SCMP_SYS(execve), SECCOMP_KEY_PARTS, opened) == 0;
}

/* The kernel's form of the list. libseccomp 2.5 gives it to a descriptor only: a pipe, which holds all of it and to which no
 * limit on the size of files applies. */
static bool compile(scmp_filter_ctx list, seccomp_filter *f)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
        return false;
    ssize_t size = seccomp_export_bpf(list, ends[1]) == 0 ? read(ends[0], f->code, sizeof f->code) : 0;
    close(ends[0]);
    close(ends[1]);
    bool is_whole = size > 0 && (size_t)size < sizeof f->code && (size_t)size % sizeof *f->code == 0;
    f->n = is_whole ? (unsigned short)((size_t)size / sizeof *f->code) : 0;
    return is_whole;
}

static bool is_there(void)
{
    /* asking for a filter at an impossible address: EFAULT where filters are known */
    return !SECCOMP_IS_OFF && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, NULL, 0, 0) != 0 && errno == EFAULT;
}

bool plb_seccomp_plan(seccomp_filter *f, seccomp_rights rights)
{
    f->n = 0;
    if (!is_there() || getrandom(f->key, sizeof f->key, 0) != (ssize_t)sizeof f->key)
        return false;
    /* A call that is not on the list does not exist, so that the C library takes the elder one that it replaces (clone3). */
    scmp_filter_ctx list = seccomp_init(SCMP_ACT_ERRNO(ENOSYS));
    bool ok = list && seccomp_attr_set(list, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_ERRNO(ENOSYS)) == 0 && allow_all(list, rights, f->key) &&
              compile(list, f);
    if (list)
        seccomp_release(list);
    return ok;
}

/* ---- in the child ------------------------------------------------------------------------------------------- */

static bool set_filter(unsigned short n, const struct sock_filter *code)
{
    struct sock_fprog all = {n, (struct sock_filter *)code}; /* the kernel only reads it */
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all, 0, 0) == 0;
}

/* Signals go to the process itself alone (abort), whose number is known only now. */
static bool enter_own_signals(void)
{
    const uint32_t call = offsetof(struct seccomp_data, nr), pid = offsetof(struct seccomp_data, args), pid_high = pid + 4;
    const struct sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, call),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_kill, 1, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_tgkill, 0, 4),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, pid), /* little endian, as the architectures that have seccomp and we know */
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)getpid(), 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, pid_high),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
    };
    return set_filter(sizeof code / sizeof *code, code);
}

bool plb_seccomp_enter(const seccomp_filter *f) { return enter_own_signals() && set_filter(f->n, f->code); }

void plb_seccomp_execute(const seccomp_filter *f, const char *program, char *const argv[], char *const environment[])
{
    syscall(SYS_execve, program, argv, environment, f->key[0], f->key[1], f->key[2]);
}
