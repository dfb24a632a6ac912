/* SPDX-License-Identifier: MIT
 *
 * See landlock.h. Between fork and execve only system calls are made. The constants of Landlock are the kernel's
 * (linux/landlock.h), written out because the headers of a distribution are older than its kernel may be.
 */
#define _GNU_SOURCE /* O_PATH, syscall */
#include "system/sandbox/landlock.h"

#include "system/sandbox/seccomp.h"

#include <fcntl.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { CREATE_RULESET = 444, ADD_RULE, RESTRICT_SELF }; /* the same numbers on every architecture */

#define EXECUTE (1u << 0)
#define WRITE_FILE (1u << 1)
#define READ_FILE (1u << 2)
#define READ_DIR (1u << 3)
#define MAKE_FILE (1u << 8)
#define TRUNCATE (1u << 14)
#define OF_FILES (EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | 1u << 15)
#define READING (READ_FILE | READ_DIR)
#define SCRATCHING (READING | WRITE_FILE | MAKE_FILE | TRUNCATE)

/* Versions 1 to 3 know of files (version 2 added moving, 3 truncating), 4 of TCP, 5 of devices, 6 of signals. */
typedef struct {
    uint64_t files, net, scoped;
} ruleset;

typedef struct {
    uint64_t allowed;
    int32_t parent;
} __attribute__((packed)) rule;

static uint64_t files_handled(int version)
{
    int bits = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
    return ((uint64_t)1 << bits) - 1;
}

static size_t ruleset_size(int version)
{
    return version >= 6 ? sizeof(ruleset) : version >= 4 ? offsetof(ruleset, scoped) : offsetof(ruleset, net);
}

/* Allows `what` below `path`. A path that is not there needs no rule. */
static bool allow(int rules, int version, const char *path, uint64_t what)
{
    struct stat about;
    int fd = open(path, O_PATH | O_CLOEXEC);
    if (fd < 0)
        return true;
    bool is_folder = fstat(fd, &about) == 0 && S_ISDIR(about.st_mode);
    rule r = {what & files_handled(version) & (is_folder ? ~(uint64_t)0 : OF_FILES), fd};
    bool ok = syscall(ADD_RULE, rules, 1, &r, 0) == 0;
    close(fd);
    return ok;
}

/* Reads the interpreter of a script from its first line; false when `program` is none. The kernel starts the interpreter itself,
 * so the script is all that is ever given to execve; what needs more (env, a wrapper) does not start. */
static bool find_interpreter(const char *program, char path[LANDLOCK_PATH_MAX])
{
    int fd = open(program, O_RDONLY | O_CLOEXEC);
    ssize_t n = fd >= 0 ? read(fd, path, LANDLOCK_PATH_MAX - 1) : 0;
    if (fd >= 0)
        close(fd);
    path[n > 0 ? n : 0] = '\0';
    if (path[0] != '#' || path[1] != '!')
        return false;
    size_t start = 2 + strspn(path + 2, " \t"), length = strcspn(path + start, " \t\r\n");
    memmove(path, path + start, length);
    path[length] = '\0';
    return length > 0;
}

/* Libraries, fonts, what programs bring along; and the loaders, which the kernel executes. */
static const char *const readable[] = {
    "/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/libx32", "/lib", "/lib64", "/usr/local/lib", "/usr/share", "/usr/local/share",
    "/etc/ld.so.cache", "/etc/ld.so.preload", "/etc/fonts", "/etc/ghostscript", "/etc/papersize", "/etc/paperspecs",
    "/etc/localtime", "/var/cache/fontconfig", "/var/lib/ghostscript", "/dev/urandom", "/dev/random", NULL,
};
static const char *const loaders[] = {
    "/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1", "/lib/ld-linux.so.2", "/lib/ld-linux-armhf.so.3",
    "/lib64/ld64.so.2", "/lib/ld64.so.1", "/lib/ld-linux-riscv64-lp64d.so.1", "/lib/ld-musl-x86_64.so.1",
    "/lib/ld-musl-aarch64.so.1", "/nix/store", "/gnu/store", NULL,
};

static bool allow_all(int rules, int version, const char *const *paths, uint64_t what)
{
    while (*paths)
        if (!allow(rules, version, *paths++, what))
            return false;
    return true;
}

static bool allow_files(const landlock_rules *c, int rules)
{
    int v = c->version;
    char interpreter[LANDLOCK_PATH_MAX];
    bool ok = allow_all(rules, v, readable, READING) && allow_all(rules, v, loaders, READING | EXECUTE) &&
              allow(rules, v, c->program, READ_FILE | EXECUTE) && allow(rules, v, "/dev/null", READ_FILE | WRITE_FILE);
    if (find_interpreter(c->program, interpreter))
        ok = ok && allow(rules, v, interpreter, READ_FILE | EXECUTE);
    if (SECCOMP_IS_OFF) /* a sanitizer reads its own memory's map */
        ok = ok && allow(rules, v, "/proc", READING);
    for (int i = 0; i < LANDLOCK_FONT_PATHS; i++)
        ok = ok && (!c->fonts[i][0] || allow(rules, v, c->fonts[i], READING));
    return ok && (!c->scratch || allow(rules, v, c->scratch, SCRATCHING));
}

bool plb_landlock_enter(const landlock_rules *c)
{
    ruleset all = {files_handled(c->version), 3, 3};
    long rules = syscall(CREATE_RULESET, &all, ruleset_size(c->version), 0);
    if (rules < 0)
        return false;
    bool ok = allow_files(c, (int)rules) && syscall(RESTRICT_SELF, rules, 0) == 0;
    close((int)rules);
    return ok;
}

/* ---- before the fork ---------------------------------------------------------------------------------------- */

/* Where fonts of the user's own lie: a variable, or the home folder, and what is below it. */
static const struct {
    const char *variable, *below;
} fonts_of_user[LANDLOCK_FONT_PATHS] = {
    {"HOME=", "/.fonts"}, {"HOME=", "/.fonts.conf"}, {"HOME=", "/.fonts.conf.d"}, {"HOME=", "/.local/share/fonts"},
    {"HOME=", "/.config/fontconfig"}, {"HOME=", "/.cache/fontconfig"}, {"XDG_DATA_HOME=", "/fonts"},
    {"XDG_CONFIG_HOME=", "/fontconfig"}, {"XDG_CACHE_HOME=", "/fontconfig"}, {"FONTCONFIG_FILE=", ""}, {"FONTCONFIG_PATH=", ""},
    {"FONTCONFIG_SYSROOT=", ""},
};

static void find_fonts(landlock_rules *c, char *const environment[])
{
    for (int i = 0; i < LANDLOCK_FONT_PATHS; i++) {
        size_t n = strlen(fonts_of_user[i].variable);
        c->fonts[i][0] = '\0';
        for (char *const *e = environment; e && *e; e++)
            if (!strncmp(*e, fonts_of_user[i].variable, n) && (*e)[n] == '/' && (*e)[n + 1] &&
                snprintf(c->fonts[i], LANDLOCK_PATH_MAX, "%s%s", *e + n, fonts_of_user[i].below) >= LANDLOCK_PATH_MAX)
                c->fonts[i][0] = '\0';
    }
}

void plb_landlock_plan(landlock_rules *c, const char *program, const char *scratch, char *const environment[])
{
    long version = syscall(CREATE_RULESET, NULL, (size_t)0, 1u);
    c->version = version > 0 ? (int)version : 0;
    c->program = program;
    c->scratch = scratch;
    find_fonts(c, environment);
}
