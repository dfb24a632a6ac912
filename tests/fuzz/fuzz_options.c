/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a command line; NUL or newline ends a word.
 */
#include "tool/command/command_line.h"

#include "fuzz.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    enum { WORDS = 64 };
    char *text = malloc(size + 1), *argv[WORDS + 1];
    fuzz_require(text != NULL);
    for (size_t i = 0; i < size; i++)
        text[i] = (char)(data[i] == '\n' ? '\0' : data[i]);
    text[size] = '\0';
    int argc = 0;
    char name[] = PROGRAM;
    argv[argc++] = name;
    for (char *at = text; at < text + size && argc < WORDS; at += strlen(at) + 1)
        argv[argc++] = at;
    argv[argc] = NULL;
    settings s = {.o = plb_options_new(), .dump = -1};
    command_table table;
    int operands = 0;
    command_table_init(&table);
    fuzz_require(s.o && table.n <= MAX_OPTIONS);
    if (command_line_parse(&s, &table, argc, argv, &operands))
        fuzz_require(operands >= 0 && operands < argc);
    /* whatever the words, each setting holds a value that it would take again */
    const plb_setting *row;
    char value[4096];
    for (size_t i = 0; (row = plb_setting_at(i)); i++)
        if (row->kind != PLB_SETTING_PENCIL && plb_options_get(s.o, row->name, value, sizeof value))
            fuzz_require(plb_options_set(s.o, row->name, value, NULL));
    plb_options_free(s.o);
    free(text);
    return 0;
}
