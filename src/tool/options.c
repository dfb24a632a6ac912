/* SPDX-License-Identifier: MIT
 *
 * See options.h.
 */
#include "tool/options.h"

#include "tool/streams.h"

#include <stdio.h>
#include <string.h>

static bool complain(const char *program, const char *what, const char *which, size_t length)
{
    fprintf(stderr, "%s: %s ", program, what);
    streams_put(stderr, which, length);
    fprintf(stderr, "; try '%s --help'\n", program);
    return false;
}

static const option *find_name(const option *table, size_t n, const char *name, size_t length)
{
    for (size_t i = 0; i < n; i++)
        if (table[i].name && strlen(table[i].name) == length && !strncmp(table[i].name, name, length))
            return &table[i];
    return NULL;
}

static const option *find_letter(const option *table, size_t n, char letter)
{
    for (size_t i = 0; i < n; i++)
        if (table[i].name && table[i].letter == letter)
            return &table[i];
    return NULL;
}

static bool store(const option_parser *by, const option *o, void *settings, const char *value)
{
    const char *program = by->program;
    char why[OPTION_WHY_SIZE] = "";
    if (o->set ? o->set(settings, value) : by->store(settings, o, value, why))
        return true;
    if (!*why)
        snprintf(why, sizeof why, "%s takes %s; not '%.80s'", o->name, o->argument, value ? value : "");
    fprintf(stderr, "%s: --", program);
    streams_put(stderr, why, strlen(why));
    fprintf(stderr, "; try '%s --help'\n", program);
    return false;
}

/* "--name", "--name=value" or "--name" "value"; moves *i over a value of its own. */
static bool parse_long(const option_parser *by, int argc, char **argv, int *i, void *settings)
{
    const char *name = argv[*i] + 2, *equals = strchr(name, '=');
    size_t length = equals ? (size_t)(equals - name) : strlen(name);
    const option *o = find_name(by->table, by->n, name, length);
    if (!o)
        return complain(by->program, "there is no option", argv[*i], length + 2);
    if (!o->argument)
        return equals ? complain(by->program, "no value belongs to", argv[*i], length + 2) : store(by, o, settings, NULL);
    if (equals)
        return store(by, o, settings, equals + 1);
    if (*i + 1 >= argc)
        return complain(by->program, "a value is missing after", argv[*i], length + 2);
    return store(by, o, settings, argv[++*i]);
}

/* "-qv", "-ofile" or "-o" "file". */
static bool parse_letters(const option_parser *by, int argc, char **argv, int *i, void *settings)
{
    for (const char *p = argv[*i] + 1; *p; p++) {
        const option *o = find_letter(by->table, by->n, *p);
        char shown[3] = {'-', *p, '\0'};
        if (!o)
            return complain(by->program, "there is no option", shown, 2);
        if (!o->argument) {
            if (!store(by, o, settings, NULL))
                return false;
            continue;
        }
        if (p[1])
            return store(by, o, settings, p + 1);
        if (*i + 1 >= argc)
            return complain(by->program, "a value is missing after", shown, 2);
        return store(by, o, settings, argv[++*i]);
    }
    return true;
}

bool options_parse(const option_parser *by, int argc, char **argv, void *settings, int *operands)
{
    bool ended = false;
    *operands = 0;
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i];
        bool is_option = !ended && word[0] == '-' && word[1] != '\0';
        if (is_option && !strcmp(word, "--"))
            ended = true;
        else if (!is_option)
            argv[(*operands)++] = argv[i];
        else if (word[1] == '-' ? !parse_long(by, argc, argv, &i, settings) : !parse_letters(by, argc, argv, &i, settings))
            return false;
    }
    return true;
}

/* Where the explanations begin; options that reach beyond have theirs on the next line. */
#define HELP_COLUMN 30

void options_print(const option *table, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const option *o = &table[i];
        if (!o->name) {
            printf("\n%s:\n", o->help);
            continue;
        }
        char left[64];
        int at = o->letter ? snprintf(left, sizeof left, "  -%c, --%s", o->letter, o->name) : snprintf(left, sizeof left, "      --%s", o->name);
        if (o->argument && at > 0 && at < (int)sizeof left)
            snprintf(left + at, sizeof left - (size_t)at, " %s", o->argument);
        if (strlen(left) > HELP_COLUMN)
            printf("%s\n%*s", left, HELP_COLUMN, "");
        else
            printf("%-*s", HELP_COLUMN, left);
        printf(" %s\n", o->help);
    }
}
