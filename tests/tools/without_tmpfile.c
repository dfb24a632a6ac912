/* SPDX-License-Identifier: MIT
 *
 * without_tmpfile COMMAND [ARGUMENT...]: runs it as on a file system that has no files without names: the kernel refuses
 * O_TMPFILE to it. Exit status 125 when this kernel cannot be told to.
 */
#define _GNU_SOURCE /* __O_TMPFILE */
#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#define FLAGS_AT ((unsigned)(offsetof(struct seccomp_data, args) + 2 * sizeof(unsigned long long))) /* openat's; their low half */

int main(int argc, char **argv)
{
    struct sock_filter filter[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, (unsigned)offsetof(struct seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, FLAGS_AT),
        BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, (unsigned)__O_TMPFILE, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EOPNOTSUPP),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    struct sock_fprog program = {sizeof filter / sizeof *filter, filter};
    if (argc < 2 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        return 125;
    if (open(".", O_TMPFILE | O_WRONLY, 0600) >= 0 || errno != EOPNOTSUPP)
        return 125;
    execv(argv[1], argv + 1);
    return 127;
}
