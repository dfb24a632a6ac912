/* SPDX-License-Identifier: MIT
 *
 * See options.h.
 */
#include "tool/options/options.h"

#include "api/plumbago.h"
#include "tool/options/streams.h"

#include <stdio.h>
#include <string.h>

static bool complain(const char *program, const char *what, const char *which, size_t length)
{
    fprintf(stderr, "%s: %s ", program, what);
    streams_put(stderr, which, length);
    fprintf(stderr, "; try '%s --help'\n", program);
    return false;
}

static bool is_called(const char *name, const char *text, size_t length)
{
    return name && strlen(name) == length && !strncmp(name, text, length);
}

static const option *find_name(const option *table, size_t n, const char *name, size_t length)
{
    for (size_t i = 0; i < n; i++)
        if (is_called(table[i].name, name, length) || is_called(table[i].alias, name, length))
            return &table[i];
    return NULL;
}

/* Finds the option nearest to a mistyped one: --width for "--widht". */
static bool complain_of_name(const option_parser *by, const char *word, size_t length)
{
    const char *nearest = NULL;
    size_t least = PLB_NAME_FAR;
    for (size_t i = 0; i < by->n; i++) {
        size_t away = by->table[i].name ? plb_name_distance(by->table[i].name, word, length) : PLB_NAME_FAR;
        if (away < least) {
            least = away;
            nearest = by->table[i].name;
        }
    }
    if (!nearest)
        return false;
    fprintf(stderr, "%s: there is no option --", by->program);
    streams_put(stderr, word, length);
    fprintf(stderr, "; did you mean --%s? Try '%s --help'\n", nearest, by->program);
    return true;
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

/* Reads "--name", "--name=value" or "--name" "value"; moves *i over a value of its own. */
static bool parse_long(const option_parser *by, int argc, char **argv, int *i, void *settings)
{
    const char *name = argv[*i] + 2, *equals = strchr(name, '=');
    size_t length = equals ? (size_t)(equals - name) : strlen(name);
    const option *o = find_name(by->table, by->n, name, length);
    if (!o)
        return !complain_of_name(by, name, length) && complain(by->program, "there is no option", argv[*i], length + 2);
    if (!o->argument)
        return equals ? complain(by->program, "no value belongs to", argv[*i], length + 2) : store(by, o, settings, NULL);
    if (equals)
        return store(by, o, settings, equals + 1);
    if (*i + 1 >= argc)
        return complain(by->program, "a value is missing after", argv[*i], length + 2);
    return store(by, o, settings, argv[++*i]);
}

/* Reads "-qv", "-ofile" or "-o" "file". */
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
