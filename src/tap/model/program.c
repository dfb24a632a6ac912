/* SPDX-License-Identifier: MIT
 *
 * See program.h. Exit statuses are those of list/text/tap_status.h, and 125: no memory.
 */
#include "tap/model/program.h"

#include "base/number/number.h"
#include "list/text/tap_status.h"
#include "tap/common/tap_memory.h"
#include "tap/common/tap_stream.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void __attribute__((noreturn)) quit(int status, const char *text)
{
    fprintf(stderr, "%s\n", text);
    fflush(stderr);
    _exit(status);
}

static bool put(void *closure, const char *data, size_t n)
{
    (void)closure;
    return plb_tap_put(data, n);
}

static int status_of(error_kind kind)
{
    return kind == ERROR_SYNTAX ? TAP_MALFORMED : kind == ERROR_MEMORY ? TAP_EXIT_MEMORY : kind == ERROR_LIMIT ? TAP_LIMIT : TAP_REFUSED;
}

/* ---- the command line ---- */

static void __attribute__((noreturn)) refuse_usage(void)
{
    quit(TAP_USAGE, "usage: tap-model FORMAT [--view=AZ,EL] [--perspective=DEGREES] [--up=x|y|z] [--crease=DEGREES] [--hidden=none|dashed|faint] "
                    "[--light=AZ,EL|none] [--sheet=first-angle|third-angle] <model >list");
}

/* Reads so many numbers with commas between, and nothing after them. */
static void read_numbers(const char *text, double *v, int n)
{
    const char *end = text + strlen(text);
    for (int i = 0; i < n; i++)
        if (!plb_parse_number(text, end, &v[i], &text) || !isfinite(v[i]) || *text++ != (i + 1 < n ? ',' : '\0'))
            refuse_usage();
}

/* Gives the index of the word among n. */
static int read_word(const char *text, const char *const words[], int n)
{
    for (int i = 0; i < n; i++)
        if (!strcmp(text, words[i]))
            return i;
    refuse_usage();
}

/* Gives what follows "NAME=". */
static const char *value_of(const char *argument, const char *name)
{
    size_t n = strlen(name);
    return !strncmp(argument, name, n) && argument[n] == '=' ? argument + n + 1 : NULL;
}

static void read_option(const char *argument, model_settings *s)
{
    static const char *const axes[] = {"x", "y", "z"}, *const styles[] = {"auto", "none", "dashed", "faint"}, *const sheets[] = {"none", "first-angle", "third-angle"};
    const char *value;
    double v[2];
    if ((value = value_of(argument, "--view"))) {
        read_numbers(value, v, 2);
        s->from.azimuth = v[0];
        s->from.elevation = v[1];
    } else if ((value = value_of(argument, "--perspective"))) {
        read_numbers(value, &s->from.perspective, 1);
    } else if ((value = value_of(argument, "--up"))) {
        s->up = (up_axis)read_word(value, axes, 3);
        s->is_upright_by_format = false;
    } else if ((value = value_of(argument, "--crease"))) {
        read_numbers(value, &s->crease, 1);
    } else if ((value = value_of(argument, "--hidden"))) {
        s->hidden = (hidden_style)read_word(value, styles, 4);
    } else if ((value = value_of(argument, "--light"))) {
        s->light.is_on = strcmp(value, "none") != 0;
        if (s->light.is_on) {
            read_numbers(value, v, 2);
            s->light = (light){true, v[0], v[1]};
        }
    } else if ((value = value_of(argument, "--sheet"))) {
        s->sheet = (sheet_kind)read_word(value, sheets, 3);
    } else {
        refuse_usage();
    }
}

void plb_model_program(int argc, char **argv, const char *const formats[], int n, model_reader read_model)
{
    error why = {ERROR_NONE, ""};
    model_settings s = plb_model_settings_default();
    raw_model m = {0};
    size_t size;
    if (argc < 2)
        refuse_usage();
    int format = read_word(argv[1], formats, n);
    for (int i = 2; i < argc; i++)
        read_option(argv[i], &s);
    char *data = plb_tap_read_all(&size);
    if (!data)
        quit(TAP_LIMIT, "the file is too large");
    if (!read_model(data, size, format, &m, &why))
        quit(status_of(why.kind), why.text);
    free(data);
    if (!plb_model_draw(&m, &s, put, NULL, &why))
        quit(status_of(why.kind), why.text);
    _exit(TAP_DONE); /* no time for tidying up */
}
