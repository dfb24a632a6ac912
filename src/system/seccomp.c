/* SPDX-License-Identifier: MIT
 *
 * See seccomp.h. A list of what is refused, and not of what is allowed, because the programs and their libraries are
 * not ours and change; the files they see are Landlock's business.
 */
#define _GNU_SOURCE /* CLONE_THREAD, O_TMPFILE */
#include "system/seccomp.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#if defined(__x86_64__) && !defined(__ILP32__)
#define ARCHITECTURE AUDIT_ARCH_X86_64
#define OTHER_ABI 0x40000000u /* x32 calls of the same kernel have this bit */
#elif defined(__aarch64__)
#define ARCHITECTURE AUDIT_ARCH_AARCH64
#endif

#ifdef ARCHITECTURE

/* Never: the network, other processes, other files than those opened by name, the machine itself. */
static const int refused[] = {
    __NR_socket, __NR_connect, __NR_bind, __NR_listen, __NR_accept, __NR_accept4, __NR_ptrace, __NR_process_vm_readv,
    __NR_process_vm_writev, __NR_rt_sigqueueinfo, __NR_rt_tgsigqueueinfo, __NR_tkill, __NR_execveat, __NR_mount, __NR_umount2,
    __NR_pivot_root, __NR_chroot, __NR_unshare, __NR_setns, __NR_open_by_handle_at, __NR_name_to_handle_at, __NR_bpf,
    __NR_perf_event_open, __NR_userfaultfd, __NR_keyctl, __NR_add_key, __NR_request_key, __NR_kexec_load, __NR_init_module,
    __NR_finit_module, __NR_delete_module, __NR_reboot, __NR_swapon, __NR_swapoff, __NR_acct, __NR_quotactl, __NR_syslog,
    __NR_settimeofday, __NR_clock_settime, __NR_adjtimex, __NR_clock_adjtime, __NR_sethostname, __NR_setdomainname,
    __NR_personality, __NR_mknodat, __NR_linkat, __NR_symlinkat, __NR_fchmod, __NR_fchmodat, __NR_fchown, __NR_fchownat,
    __NR_utimensat, __NR_setxattr, __NR_lsetxattr, __NR_fsetxattr, __NR_removexattr, __NR_lremovexattr, __NR_fremovexattr,
    __NR_renameat2, __NR_mkdirat, __NR_setrlimit, __NR_setpriority, __NR_setpgid, __NR_setsid, __NR_fallocate,
    __NR_shmget, __NR_msgget, __NR_semget, __NR_mq_open,
#ifdef __NR_renameat
    __NR_renameat,
#endif
#ifdef __NR_open /* the elder forms, which new architectures lack */
    __NR_mknod, __NR_link, __NR_symlink, __NR_chmod, __NR_chown, __NR_lchown, __NR_utime, __NR_utimes, __NR_futimesat,
    __NR_rename, __NR_mkdir, __NR_rmdir, __NR_fork, __NR_vfork,
#endif
#ifdef __NR_pidfd_open
    __NR_pidfd_open, __NR_pidfd_send_signal,
#endif
#ifdef __NR_pidfd_getfd
    __NR_pidfd_getfd,
#endif
#ifdef __NR_io_uring_setup
    __NR_io_uring_setup, __NR_io_uring_enter, __NR_io_uring_register,
#endif
#ifdef __NR_open_tree
    __NR_open_tree, __NR_move_mount, __NR_fsopen, __NR_fsmount,
#endif
};

/* Of those that write nothing anywhere. */
static const int refused_to_readers[] = {
    __NR_unlinkat, __NR_truncate,
#ifdef __NR_open
    __NR_unlink, __NR_creat,
#endif
};

/* The kernel says it does not know them: the C library then takes the elder call, which can be looked into. */
static const int unknown[] = {
#ifdef __NR_clone3
    __NR_clone3,
#endif
#ifdef __NR_openat2
    __NR_openat2,
#endif
    -1,
};

/* ---- the filter -------------------------------------------------------------------------------------------- */

enum { MOST = 512 };
typedef struct {
    struct sock_filter code[MOST];
    unsigned short n;
} filter;

#define REFUSE (SECCOMP_RET_ERRNO | EPERM)
#define LOW_HALF(i) ((uint32_t)(offsetof(struct seccomp_data, args) + 8 * (i))) /* little endian, as both architectures */

static void add(filter *f, uint16_t code, uint32_t k, uint8_t yes, uint8_t no)
{
    f->code[f->n++] = (struct sock_filter){code, yes, no, k};
}

static void load(filter *f, uint32_t offset) { add(f, BPF_LD | BPF_W | BPF_ABS, offset, 0, 0); }
static void finish(filter *f, uint32_t result) { add(f, BPF_RET | BPF_K, result, 0, 0); }

static void refuse_all(filter *f, const int *calls, size_t n, uint32_t result)
{
    for (size_t i = 0; i < n; i++) {
        if (calls[i] < 0)
            continue;
        add(f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)calls[i], 0, 1);
        finish(f, result);
    }
}

/* The call is allowed when argument `i` has one of the bits (with) or none of them (without). */
static void with_bits(filter *f, int call, unsigned i, uint32_t bits, bool with)
{
    add(f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)call, 0, 4);
    load(f, LOW_HALF(i));
    add(f, BPF_JMP | BPF_JSET | BPF_K, bits, with ? 1 : 0, with ? 0 : 1);
    finish(f, REFUSE);
    finish(f, SECCOMP_RET_ALLOW);
}

/* The call is allowed when argument `i` is this. */
static void with_value(filter *f, int call, unsigned i, uint64_t value)
{
    add(f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)call, 0, 6);
    load(f, LOW_HALF(i));
    add(f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)value, 0, 3);
    load(f, LOW_HALF(i) + 4);
    add(f, BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)(value >> 32), 0, 1);
    finish(f, SECCOMP_RET_ALLOW);
    finish(f, REFUSE);
}

static void make(filter *f, const char *program, bool writes)
{
    const uint32_t writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
    f->n = 0;
    load(f, offsetof(struct seccomp_data, arch));
    add(f, BPF_JMP | BPF_JEQ | BPF_K, ARCHITECTURE, 1, 0);
    finish(f, SECCOMP_RET_KILL);
    load(f, offsetof(struct seccomp_data, nr));
#ifdef OTHER_ABI
    add(f, BPF_JMP | BPF_JGE | BPF_K, OTHER_ABI, 0, 1);
    finish(f, REFUSE);
#endif
    refuse_all(f, refused, sizeof refused / sizeof *refused, REFUSE);
    refuse_all(f, unknown, sizeof unknown / sizeof *unknown, SECCOMP_RET_ERRNO | ENOSYS);
    if (!writes) {
        refuse_all(f, refused_to_readers, sizeof refused_to_readers / sizeof *refused_to_readers, REFUSE);
        with_bits(f, __NR_openat, 2, writing, false);
#ifdef __NR_open
        with_bits(f, __NR_open, 1, writing, false);
#endif
    }
    with_bits(f, __NR_clone, 0, CLONE_THREAD, true);
    with_value(f, __NR_prlimit64, 2, 0); /* asking for limits, not setting them */
    with_value(f, __NR_kill, 0, (uint64_t)getpid());
    with_value(f, __NR_tgkill, 0, (uint64_t)getpid());
    with_value(f, __NR_execve, 0, (uint64_t)(uintptr_t)program);
    finish(f, SECCOMP_RET_ALLOW);
}

bool plb_seccomp_is_there(void)
{
    /* asking for a filter at an impossible address: EFAULT where filters are known */
    return !SECCOMP_IS_OFF && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, NULL, 0, 0) != 0 && errno == EFAULT;
}

bool plb_seccomp_enter(const char *program, bool writes)
{
    filter f;
    make(&f, program, writes);
    struct sock_fprog all = {f.n, f.code};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all, 0, 0) == 0;
}

#else

bool plb_seccomp_is_there(void) { return false; }
bool plb_seccomp_enter(const char *program, bool writes)
{
    (void)program;
    (void)writes;
    return false;
}

#endif
