/* SPDX-License-Identifier: MIT
 *
 * See completions.h.
 */
#include "tool/options/completions.h"

#include <stdio.h>
#include <string.h>

static bool takes_files(const option *o)
{
    return o->argument && (strstr(o->argument, "FILE") || strstr(o->argument, "FOLDER"));
}

/* ---- bash ---- */

static void print_bash(const char *program, const option *table, size_t n)
{
    printf("# bash completion of %s\n_%s()\n{\n    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]}\n"
           "    [ \"$cur\" = = ] && cur=\n    [ \"$prev\" = = ] && prev=${COMP_WORDS[COMP_CWORD-2]}\n    case $prev in\n", program, program);
    for (size_t i = 0; i < n; i++) {
        const option *o = &table[i];
        if (!o->name || !o->argument)
            continue;
        printf("    --%s", o->name);
        if (o->letter)
            printf(" | -%c", o->letter);
        printf(") COMPREPLY=($(compgen %s-W '%s' -- \"$cur\")); return ;;\n", takes_files(o) ? "-f " : "", o->words ? o->words : "");
    }
    printf("    esac\n    case $cur in\n    -*) COMPREPLY=($(compgen -W '");
    for (size_t i = 0; i < n; i++)
        if (table[i].name)
            printf("%s--%s", i > 1 ? " " : "", table[i].name);
    printf("' -- \"$cur\")) ;;\n    *) COMPREPLY=($(compgen -f -- \"$cur\")) ;;\n    esac\n}\ncomplete -o filenames -F _%s %s\n", program, program);
}

/* ---- zsh ---- */

/* Prints text that stands in single quotes, where brackets and colons would mean something. */
static void print_zsh_text(const char *text)
{
    for (; *text; text++)
        if (*text == '\'')
            fputs("'\\''", stdout);
        else if (strchr("[]:\\", *text))
            printf("\\%c", *text);
        else
            putchar(*text);
}

static void print_zsh_argument(const option *o)
{
    if (!o->argument)
        return;
    printf(":");
    print_zsh_text(o->argument);
    printf(":");
    if (o->words && takes_files(o))
        printf("{compadd %s; _files}", o->words);
    else if (o->words)
        printf("(%s)", o->words);
    else if (takes_files(o))
        printf("_files");
}

static void print_zsh(const char *program, const option *table, size_t n)
{
    printf("#compdef %s\n_arguments -s \\\n", program);
    for (size_t i = 0; i < n; i++) {
        const option *o = &table[i];
        if (!o->name)
            continue;
        if (o->letter)
            printf("  '(-%c --%s)'{-%c%s,--%s%s}'[", o->letter, o->name, o->letter, o->argument ? "+" : "", o->name, o->argument ? "=" : "");
        else
            printf("  '--%s%s[", o->name, o->argument ? "=" : "");
        print_zsh_text(o->help);
        printf("]");
        print_zsh_argument(o);
        printf("' \\\n");
    }
    printf("  '*:FILE:_files'\n");
}

/* ---- fish ---- */

static void print_fish_text(const char *text)
{
    putchar('\'');
    for (; *text; text++)
        printf(*text == '\'' || *text == '\\' ? "\\%c" : "%c", *text);
    putchar('\'');
}

static void print_fish(const char *program, const option *table, size_t n)
{
    printf("# fish completion of %s\n", program);
    for (size_t i = 0; i < n; i++) {
        const option *o = &table[i];
        if (!o->name)
            continue;
        printf("complete -c %s -l %s", program, o->name);
        if (o->letter)
            printf(" -s %c", o->letter);
        if (o->argument)
            printf(" %s", takes_files(o) ? "-r" : "-x");
        if (o->words)
            printf(" -a '%s'", o->words);
        printf(" -d ");
        print_fish_text(o->help);
        putchar('\n');
    }
}

bool completions_print(const char *shell, const char *program, const option *table, size_t n)
{
    static const struct {
        const char *shell;
        void (*print)(const char *program, const option *table, size_t n);
    } shells[] = {{"bash", print_bash}, {"zsh", print_zsh}, {"fish", print_fish}};
    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++)
        if (!strcmp(shell, shells[i].shell)) {
            shells[i].print(program, table, n);
            return true;
        }
    return false;
}
