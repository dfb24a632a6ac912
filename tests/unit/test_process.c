/* SPDX-License-Identifier: MIT
 *
 * Running helper processes: input and output at once, every kind of end, and nothing left behind.
 */
#include "check.h"

#include "system/process.h"
#include "system/scratch.h"
#include "system/seccomp.h"

#include <errno.h>
#include <signal.h>
#include <sys/stat.h>
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

static char deeds[1024];

static bool burgle(process *p, const process_limits *limits)
{
    char folder[] = "/tmp/plumbago-bait-XXXXXX", bait[64], program[1024], pid[16];
    const char *build = getenv("BUILD_DIR"), *argv[] = {"burglar", folder, pid, NULL}, *data;
    size_t n, used = 0;
    error err = {0};
    if (!mkdtemp(folder))
        return false;
    snprintf(bait, sizeof bait, "%s/bait", folder);
    FILE *f = fopen(bait, "w");
    if (!f)
        return false;
    fputs("bait", f);
    fclose(f);
    snprintf(pid, sizeof pid, "%ld", (long)getppid());
    snprintf(program, sizeof program, "%s/tests/tools/burglar", build ? build : "build/release");
    bool ok = plb_process_start(p, program, argv, "", 0, limits, &err);
    while (ok && plb_process_read(p, &data, &n))
        for (size_t i = 0; i < n && used < sizeof deeds - 1; i++)
            deeds[used++] = data[i];
    deeds[used] = '\0';
    if (ok)
        plb_process_finish(p);
    char clean[128];
    snprintf(clean, sizeof clean, "rm -rf %s", folder);
    return system(clean) == 0 && ok && p->end == PROCESS_EXITED && p->code == 0;
}

static void the_burglar_burgles(void)
{
    static const char *const words[] = {"read", "list", "passwd", "environ", "write", "truncate", "chmod", "mkdir", "symlink",
                                        "link", "rename", "unlink", "fork", "execute", "limits"};
    process p;
    process_limits open_door = loose;
    CHECK(burgle(&p, &open_door));
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) /* else the next test says nothing; creating meets a limit */
        if (!strstr(deeds, words[i]))
            printf("FAIL the_burglar_burgles: he cannot %s even without a cage\n", words[i]);
}

static void the_cage_holds(void)
{
    process p;
    CHECK(burgle(&p, NULL));
    if (strstr(p.cage, "Landlock") && strstr(p.cage, "seccomp")) {
        if (deeds[0])
            printf("FAIL the_cage_holds: he could: %s\n", deeds);
    } else if (strstr(p.cage, "Landlock")) {
        CHECK(!strstr(deeds, "read") && !strstr(deeds, "write") && !strstr(deeds, "unlink") && !strstr(deeds, "mkdir"));
        printf("skip the_cage_holds for system calls: no seccomp in this kernel or build\n");
    } else {
        printf("skip the_cage_holds for files: no Landlock in this kernel\n");
    }
}

/* A folder to write in, where there is one, and still no other. */
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
    const char *trickle[] = {shell, option, "while :; do echo x; sleep .1; done", NULL};
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
    RUN(scratch_is_the_only_place);
    RUN(scripts_start_nothing);
    RUN(the_clock_counts);
    RUN(time_is_shared);
    RUN(memory_is_limited);
    RUN(missing_programs);
    CHECK_EXIT;
}
