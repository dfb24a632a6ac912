/* SPDX-License-Identifier: MIT
 *
 * Running helper processes: input and output at once, every kind of end, and nothing left behind.
 */
#define _GNU_SOURCE /* RTLD_NEXT */
#include "check.h"

#include "system/process.h"
#include "system/scratch.h"
#include "system/sandbox/seccomp.h"

#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <sys/msg.h>
#include <sys/prctl.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

static const char shell[] = "sh", option[] = "-c";

/* The shells of these tests start other programs, which no reader may. */
static const process_limits loose = {.seconds = 10, .memory = (size_t)1 << 30, .loose = true};

/* Runs `script` in a shell and adds up its output; false when it did not start. */
static bool run(process *p, char *script, const char *input, size_t size, size_t *bytes)
{
    const char *argv[] = {shell, option, script, NULL};
    error err = {0};
    *bytes = 0;
    if (!plb_process_start(p, "/bin/sh", argv, input, size, &loose, &err))
        return false;
    const char *data;
    size_t n;
    while (plb_process_read(p, &data, &n))
        *bytes += n;
    plb_process_finish(p);
    return true;
}

static bool no_child_left(void)
{
    return waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD;
}

static void output_and_exit_status(void)
{
    process p;
    size_t bytes;
    char script[] = "echo hello; echo sorry >&2; exit 3";
    CHECK(run(&p, script, "", 0, &bytes));
    CHECK(bytes == 6 && p.end == PROCESS_EXITED && p.code == 3 && !strcmp(p.message, "sorry\n"));
    CHECK(no_child_left());
}

/* More than any pipe holds goes in while as much comes out: neither side may wait for the other for ever. */
static void much_in_and_out(void)
{
    size_t size = (size_t)8 << 20, bytes;
    char *input = malloc(size), script[] = "cat";
    memset(input, 'x', size);
    process p;
    CHECK(run(&p, script, input, size, &bytes));
    CHECK(bytes == size && p.end == PROCESS_EXITED && p.code == 0);
    free(input);
}

static void input_nobody_reads(void)
{
    size_t size = (size_t)1 << 20, bytes;
    char *input = calloc(size, 1), script[] = "exec <&-; echo x";
    process p;
    CHECK(run(&p, script, input, size, &bytes)); /* and no SIGPIPE */
    CHECK(bytes == 2 && p.end == PROCESS_EXITED);
    free(input);
}

static void long_messages_are_cut(void)
{
    process p;
    size_t bytes;
    char script[] = "i=0; while [ $i -lt 5000 ]; do echo 0123456789 >&2; i=$((i+1)); done";
    CHECK(run(&p, script, "", 0, &bytes));
    CHECK(p.end == PROCESS_EXITED && p.code == 0 && strlen(p.message) == sizeof p.message - 1);
}

static void crashes_are_told(void)
{
    process p;
    size_t bytes;
    char script[] = "kill -ABRT $$";
    CHECK(run(&p, script, "", 0, &bytes));
    CHECK(p.end == PROCESS_CRASHED && p.code == SIGABRT);
}

static void stopped_early_is_killed(void)
{
    char script[] = "while :; do echo y; done";
    const char *argv[] = {shell, option, script, NULL};
    process p;
    error err = {0};
    const char *data;
    size_t n;
    CHECK(plb_process_start(&p, "/bin/sh", argv, "", 0, &loose, &err));
    CHECK(plb_process_read(&p, &data, &n) && n > 0);
    plb_process_finish(&p);
    CHECK(p.end != PROCESS_RUNNING);
    CHECK(no_child_left());
}

static void output_closed_but_alive_is_killed(void)
{
    process p;
    size_t bytes;
    char script[] = "exec >&- 2>&-; exec sleep 100";
    CHECK(run(&p, script, "", 0, &bytes));
    CHECK(bytes == 0 && p.end != PROCESS_EXITED);
    CHECK(no_child_left());
}

/* It sees its three descriptors, a small environment and no way to write files. */
static void little_is_passed_on(void)
{
    process p;
    size_t bytes;
    int spare = dup(1), low = dup(1);
    setenv("PLB_TEST_SECRET", "1", 1);
    char script[] = "[ -z \"$PLB_TEST_SECRET\" ] && [ \"$LC_ALL\" = C ] || exit 1;"
                    "for n in 3 4 5 6 7 8 9 10 11 12; do [ -e /proc/$$/fd/$n ] && exit 2; done; exit 0";
    CHECK(run(&p, script, "", 0, &bytes));
    CHECK(p.end == PROCESS_EXITED && p.code == 0);
    close(spare);
    close(low);
}

/* ---- the cage: the program tests/tools/burglar tries what it can ------------------------------------------- */

/* Landlock's version as the library sees it; -1: the kernel's own. Its other calls come through. */
static int pretended_version = -1;

long syscall(long number, ...)
{
    enum { CREATE_RULESET = 444 };
    static long (*real)(long, ...);
    long a[6];
    va_list rest;
    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "syscall");
    va_start(rest, number);
    for (int i = 0; i < 6; i++)
        a[i] = va_arg(rest, long);
    va_end(rest);
    if (number == CREATE_RULESET && !a[0] && pretended_version >= 0)
        return pretended_version ? pretended_version : -1;
    return real(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}

static char deeds[1024];
static char burglar[1024];

static bool collect_deeds(process *p, const char *const argv[], const process_limits *limits)
{
    const char *data, *build = getenv("BUILD_DIR");
    size_t n, used = 0;
    error err = {0};
    snprintf(burglar, sizeof burglar, "%s/tests/tools/burglar", build ? build : "build/release");
    bool ok = plb_process_start(p, burglar, argv, "", 0, limits, &err);
    while (ok && plb_process_read(p, &data, &n))
        for (size_t i = 0; i < n && used < sizeof deeds - 1; i++)
            deeds[used++] = data[i];
    deeds[used] = '\0';
    if (ok)
        plb_process_finish(p);
    return ok;
}

/* A bait is there to take: a file, a socket, and memory, a queue and semaphores of System V. */
typedef struct {
    char folder[40];
    int listening, shm, queue, semaphores;
} house;

static bool build_house(house *h)
{
    strcpy(h->folder, "/tmp/plumbago-bait-XXXXXX");
    struct sockaddr_un at = {.sun_family = AF_UNIX};
    if (!mkdtemp(h->folder))
        return false;
    snprintf(at.sun_path, sizeof at.sun_path, "%s/bait", h->folder);
    FILE *f = fopen(at.sun_path, "w");
    if (!f || fputs("bait", f) < 0 || fclose(f) != 0)
        return false;
    snprintf(at.sun_path, sizeof at.sun_path, "%s/socket", h->folder);
    h->listening = socket(AF_UNIX, SOCK_DGRAM, 0);
    h->shm = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
    h->queue = msgget(IPC_PRIVATE, IPC_CREAT | 0600);
    h->semaphores = semget(IPC_PRIVATE, 1, IPC_CREAT | 0600);
    return bind(h->listening, (struct sockaddr *)&at, sizeof at) == 0;
}

static bool clear_house(const house *h)
{
    char clean[128];
    close(h->listening);
    shmctl(h->shm, IPC_RMID, NULL);
    msgctl(h->queue, IPC_RMID, NULL);
    semctl(h->semaphores, 0, IPC_RMID);
    snprintf(clean, sizeof clean, "rm -rf %s", h->folder);
    return system(clean) == 0;
}

static bool burgle(process *p, const process_limits *limits)
{
    house h;
    char numbers[5][24];
    if (!build_house(&h))
        return false;
    snprintf(numbers[0], sizeof numbers[0], "%ld", (long)getpid());
    snprintf(numbers[1], sizeof numbers[1], "%d", h.shm);
    snprintf(numbers[2], sizeof numbers[2], "%d", h.queue);
    snprintf(numbers[3], sizeof numbers[3], "%d", h.semaphores);
    snprintf(numbers[4], sizeof numbers[4], "%zx", (size_t)burglar);
    const char *argv[] = {burglar, h.folder, numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], NULL};
    bool ok = collect_deeds(p, argv, limits);
    return clear_house(&h) && ok && p->end == PROCESS_EXITED && p->code == 0;
}

static void the_burglar_burgles(void)
{
    static const char *const words[] = {"read", "list", "passwd", "environ", "write", "truncate", "neither", "chmod", "mkdir", "symlink",
                                        "link", "rename", "unlink", "inotify", "send", "shmat", "queue", "semaphore", "setown", "async",
                                        "deathsig", "limits", "fork", "execute", "again"};
    process p;
    process_limits open_door = loose;
    CHECK(burgle(&p, &open_door));
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) /* else the next test says nothing; creating meets a limit */
        if (!strstr(deeds, words[i]))
            printf("FAIL the_burglar_burgles: he cannot %s even without a cage\n", words[i]);
}

/* Deletes a word that may stand among the deeds. */
static void forgive(const char *word)
{
    size_t n = strlen(word);
    for (char *at = deeds; (at = strstr(at, word));)
        if ((at == deeds || at[-1] == ' ') && at[n] == ' ')
            memmove(at, at + n + 1, strlen(at + n + 1) + 1);
        else
            at += n;
}

/* Tries one burglary, with Landlock in this version (-1: the kernel's), by a reader that may or may not write somewhere. */
static void burgle_caged(int version, const char *scratch_folder)
{
    static const char *const without_landlock[] = {"read", "list", "passwd", "environ"},
                      *const and_scratch[] = {"write", "create", "nameless"};
    process p;
    process_limits limits = PROCESS_LIMITS;
    limits.scratch = scratch_folder;
    pretended_version = version;
    CHECK(burgle(&p, &limits));
    pretended_version = -1;
    CHECK(version != 0 || strncmp(p.cage, "Landlock", 8) != 0);
    if (!strstr(p.cage, "seccomp and limits")) {
        printf("skip the_cage_holds for system calls: no seccomp in this kernel or build\n");
        if (!strncmp(p.cage, "Landlock", 8))
            CHECK(!strstr(deeds, "read") && !strstr(deeds, "write") && !strstr(deeds, "unlink") && !strstr(deeds, "mkdir"));
        return;
    }
    if (strncmp(p.cage, "Landlock", 8) != 0) { /* which is told */
        CHECK(strstr(p.cage, "no Landlock here: it could read") != NULL);
        for (size_t i = 0; i < sizeof without_landlock / sizeof *without_landlock; i++)
            forgive(without_landlock[i]);
        for (size_t i = 0; scratch_folder && i < sizeof and_scratch / sizeof *and_scratch; i++)
            forgive(and_scratch[i]);
    }
    if (deeds[0])
        printf("FAIL the_cage_holds: user %ld, Landlock %d%s: he could: %s\n", (long)getuid(), version, scratch_folder ? ", scratch" : "", deeds);
}

static void the_cage_holds(void)
{
    static const int versions[] = {-1, 0, 1, 2, 5};
    scratch s;
    error err = {0};
    for (size_t i = 0; i < sizeof versions / sizeof *versions; i++) {
        burgle_caged(versions[i], NULL);
        CHECK(plb_scratch_open(&s, &err));
        burgle_caged(versions[i], s.folder);
        plb_scratch_close(&s);
    }
}

/* The same by a user who has nothing, where the tests are root's. */
static void the_cage_holds_for_nobody(void)
{
    enum { NOBODY = 65534 };
    if (getuid() != 0)
        SKIP("the tests are not run by root");
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        if (setgid(NOBODY) != 0 || setuid(NOBODY) != 0)
            _exit(1);
        prctl(PR_SET_DUMPABLE, 0); /* as the program does; root's readers lose their privilege instead */
        if (access(burglar, X_OK) == 0)
            the_cage_holds();
        else
            printf("skip the_cage_holds_for_nobody: he may not enter the build's folder\n");
        fflush(stdout);
        _exit(0);
    }
    int status = 1;
    CHECK(waitpid(child, &status, 0) == child && status == 0);
}

static void threads_are_capped(void)
{
    const char *argv[] = {"burglar", "threads", "2000", NULL}, *few[] = {"burglar", "threads", "8", NULL};
    process p;
    process_limits single = PROCESS_LIMITS;
    CHECK(collect_deeds(&p, argv, NULL));
    CHECK(p.end == PROCESS_OVERSTEPPED && strstr(p.fault.text, "threads"));
    CHECK(collect_deeds(&p, few, NULL));
    CHECK(p.end == PROCESS_EXITED && !strncmp(deeds, "0 threads", 9));
    single.single = true;
    CHECK(collect_deeds(&p, few, &single));
    if (strstr(p.cage, "seccomp and limits"))
        CHECK(p.end == PROCESS_EXITED && !strncmp(deeds, "8 threads less", 14));
}

/* Temporary files: a sum, whatever their number; and none that is out of sight. */
static void scratch_has_a_total(void)
{
    scratch s;
    process p;
    error err = {0};
    process_limits limits = PROCESS_LIMITS;
    const char *data, *argv[] = {"sh", "-c", "i=0; while [ $i -lt 4000 ]; do i=$((i+1)); echo 0123456789 >>$TMPDIR/$i; done", NULL};
    size_t n;
    CHECK(plb_scratch_open(&s, &err));
    limits.scratch = s.folder;
    limits.memory = (size_t)64 << 20;
    CHECK(plb_process_start(&p, "/bin/sh", argv, "", 0, &limits, &err));
    while (plb_process_read(&p, &data, &n)) {}
    plb_process_finish(&p);
    CHECK(p.end == PROCESS_OVERSTEPPED && p.fault.kind == ERROR_LIMIT && strstr(p.fault.text, "temporary files"));
    plb_scratch_close(&s);
    CHECK(no_child_left());
}

/* A program gets a folder to write in, where one is given, and still no other. */
static void scratch_is_the_only_place(void)
{
    scratch s;
    process p;
    error err = {0};
    CHECK(plb_scratch_open(&s, &err));
    process_limits limits = PROCESS_LIMITS;
    limits.scratch = s.folder;
    char inside[SCRATCH_PATH_MAX + 8];
    snprintf(inside, sizeof inside, "%s/x", s.folder);
    const char *argv[] = {"sh", "-c", "echo 1 >$TMPDIR/x && read a <$TMPDIR/x && echo in $a; echo 1 2>&1 >/tmp/plumbago-outside; [ -e /tmp/plumbago-outside ] || echo good", NULL};
    const char *data;
    size_t n, used = 0;
    CHECK(plb_process_start(&p, "/bin/sh", argv, "", 0, &limits, &err));
    while (plb_process_read(&p, &data, &n))
        for (size_t i = 0; i < n && used < sizeof deeds - 1; i++)
            deeds[used++] = data[i];
    deeds[used] = '\0';
    plb_process_finish(&p);
    CHECK(strstr(deeds, "in 1"));
    CHECK(access(inside, F_OK) == 0);
    if (strstr(p.cage, "Landlock"))
        CHECK(strstr(deeds, "good"));
    plb_scratch_close(&s);
    CHECK(access(s.folder, F_OK) != 0);
    CHECK(no_child_left());
    remove("/tmp/plumbago-outside");
}

/* A script's interpreter is started with it, and then nothing else: neither the program it names nor itself. */
static void scripts_start_nothing(void)
{
    static const char text[] = "#!/bin/sh\necho in\nexec /usr/bin/env echo out\n";
    char script[] = "/tmp/plumbago-script-XXXXXX";
    int fd = mkstemp(script);
    CHECK(write(fd, text, sizeof text - 1) == (ssize_t)sizeof text - 1 && fchmod(fd, 0700) == 0 && close(fd) == 0);
    for (int caged = 0; caged < 2; caged++) {
        const char *argv[] = {"script", NULL}, *data;
        process p;
        size_t n, bytes = 0;
        error err = {0};
        CHECK(plb_process_start(&p, script, argv, "", 0, caged ? NULL : &loose, &err));
        while (plb_process_read(&p, &data, &n))
            bytes += n;
        plb_process_finish(&p);
        bool is_held = caged && (strstr(p.cage, "Landlock") || strstr(p.cage, "seccomp"));
        CHECK(p.end == PROCESS_EXITED && (p.code != 0) == is_held);
        CHECK(bytes == (is_held ? strlen("in\n") : strlen("in\nout\n")));
    }
    CHECK(unlink(script) == 0);
}

/* Neither silence nor a trickle keeps us: the clock counts, too. */
static void the_clock_counts(void)
{
    process p;
    const char *data;
    size_t n;
    error err = {0};
    process_limits short_ones = loose;
    short_ones.seconds = 0.1;
    const char *silent[] = {"sleep", "100", NULL};
    CHECK(plb_process_start(&p, "/bin/sleep", silent, "", 0, &short_ones, &err));
    while (plb_process_read(&p, &data, &n)) {}
    plb_process_finish(&p);
    CHECK(p.end == PROCESS_TIMED_OUT);
    const char *trickle[] = {shell, option, "while :; do echo x; sleep 1; done", NULL};
    CHECK(plb_process_start(&p, "/bin/sh", trickle, "", 0, &short_ones, &err));
    while (plb_process_read(&p, &data, &n)) {}
    plb_process_finish(&p);
    CHECK(p.end == PROCESS_TIMED_OUT);
    CHECK(no_child_left());
}

static void time_is_shared(void)
{
    process p;
    const char script[] = "while :; do :; done";
    double spent = 6.5;
    process_limits shared = loose;
    shared.seconds = 7;
    shared.spent = &spent;
    const char *argv[] = {shell, option, script, NULL}, *data;
    error err = {0};
    size_t n;
    CHECK(plb_process_start(&p, "/bin/sh", argv, "", 0, &shared, &err));
    while (plb_process_read(&p, &data, &n)) {}
    plb_process_finish(&p);
    CHECK(p.end == PROCESS_TIMED_OUT);
    CHECK_RANGE(spent, 7.0, 9.5); /* about a second is left for it, whatever was spent: the kernel counts roughly */
}

static void memory_is_limited(void)
{
    process p;
    const char script[] = "exec dd if=/dev/zero of=/dev/null bs=200M count=1"; /* one buffer of that size */
    process_limits small = loose;
    small.memory = (size_t)64 << 20;
    const char *argv[] = {shell, option, script, NULL}, *data;
    error err = {0};
    size_t n;
    if (SECCOMP_IS_OFF)
        SKIP("no such limit in a build with this sanitizer");
    CHECK(plb_process_start(&p, "/bin/sh", argv, "", 0, &small, &err));
    while (plb_process_read(&p, &data, &n)) {}
    plb_process_finish(&p);
    CHECK(p.end != PROCESS_EXITED || p.code != 0);
}

static void missing_programs(void)
{
    char path[PROCESS_PATH_MAX];
    error err = {0};
    CHECK(!plb_process_find("/nonexistent", "tap-svg", path, &err));
    CHECK(err.kind == ERROR_HELPER && strstr(err.text, "/nonexistent"));
    CHECK(plb_process_find("/bin", "sh", path, NULL) && !strcmp(path, "/bin/sh"));
    const char *argv[] = {shell, NULL};
    process p;
    error none = {0};
    const char *data;
    size_t n;
    CHECK(plb_process_start(&p, "/nonexistent/program", argv, "", 0, NULL, &none));
    CHECK(!plb_process_read(&p, &data, &n));
    plb_process_finish(&p);
    CHECK(p.end == PROCESS_EXITED && p.code == 127);
}

int main(void)
{
    RUN(output_and_exit_status);
    RUN(much_in_and_out);
    RUN(input_nobody_reads);
    RUN(long_messages_are_cut);
    RUN(crashes_are_told);
    RUN(stopped_early_is_killed);
    RUN(output_closed_but_alive_is_killed);
    RUN(little_is_passed_on);
    RUN(the_burglar_burgles);
    RUN(the_cage_holds);
    RUN(the_cage_holds_for_nobody);
    RUN(threads_are_capped);
    RUN(scratch_has_a_total);
    RUN(scratch_is_the_only_place);
    RUN(scripts_start_nothing);
    RUN(the_clock_counts);
    RUN(time_is_shared);
    RUN(memory_is_limited);
    RUN(missing_programs);
    CHECK_EXIT;
}
