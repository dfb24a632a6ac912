/* SPDX-License-Identifier: MIT
 *
 * Prints the rows of a table of options for --help.
 */
#include "tool/options/options.h"

#include <stdio.h>
#include <string.h>

/* The explanations begin in this column; a longer option has its explanation on the next line. */
#define HELP_COLUMN 30
#define HELP_WIDTH 80

/* Prints the option and its argument; gives the number of columns they take. */
static int print_left(const option *o)
{
    int n = o->letter ? printf("  -%c, --%s", o->letter, o->name) : printf("      --%s", o->name);
    return n + (o->argument ? printf(" %s", o->argument) : 0);
}

/* Prints words in lines from HELP_COLUMN on, the first after `at` columns. */
static void print_right(const char *text, int at)
{
    while (*text) {
        int n = (int)strcspn(text, " "), blanks = (int)strspn(text + n, " ");
        if (at < HELP_COLUMN)
            at += printf("%*s", HELP_COLUMN - at, "");
        if (at + 1 + n > HELP_WIDTH)
            at = printf("\n%*s", HELP_COLUMN, "") - 1;
        at += printf(" %.*s", n, text);
        text += n + blanks;
    }
    putchar('\n');
}

void options_print(const option *table, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if (!table[i].name) {
            printf("\n%s:\n", table[i].help);
            continue;
        }
        int at = print_left(&table[i]);
        if (at > HELP_COLUMN) {
            putchar('\n');
            at = 0;
        }
        print_right(table[i].help, at);
    }
}
