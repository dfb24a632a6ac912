/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a command line; NUL or newline ends a word.
 */
#define main plumbago_main
#include "tool/plumbago.c"
#undef main

#include "fuzz.h"

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
    settings s = {.o = plb_options_default(), .pencil = "HB", .dump = -1};
    int operands = 0;
    if (options_parse(PROGRAM, table, TABLE_ROWS, argc, argv, &s, &operands)) {
        fuzz_require(operands >= 0 && operands < argc);
        /* whatever the words, the library finds the options sound or says why not */
        fuzz_require(s.o.dpi >= 10 && s.o.dpi <= 4800 && s.o.scale >= 0 && s.o.width >= 0 && s.o.height >= 0);
    }
    free(text);
    return 0;
}
