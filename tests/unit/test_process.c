/* SPDX-License-Identifier: MIT
 *
 * Running helper processes: input and output at once, every kind of end, and nothing left behind.
 */
#include "check.h"

#include "input/process.h"

#include <errno.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

static const char shell[] = "sh", option[] = "-c";

/* Runs `script` in a shell and adds up its output; false when it did not start. */
static bool run(process *p, char *script, const char *input, size_t size, size_t *bytes)
{
    const char *argv[] = {shell, option, script, NULL};
    error err = {0};
    *bytes = 0;
    if (!plb_process_start(p, "/bin/sh", argv, input, size, NULL, &err))
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
    CHECK(plb_process_start(&p, "/bin/sh", argv, "", 0, NULL, &err));
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
    RUN(missing_programs);
    CHECK_EXIT;
}
