/* SPDX-License-Identifier: MIT
 *
 * Runs a harness once over each file that is named. A crash ends it after the file's name on standard error.
 */
#include "fuzz.h"

#include <stdio.h>

#define MAX_BYTES ((size_t)4 << 20)

static int replay(const char *file)
{
    FILE *from = fopen(file, "rb");
    uint8_t *all = malloc(MAX_BYTES);
    if (!from || !all) {
        perror(file);
        if (from)
            fclose(from);
        free(all);
        return 1;
    }
    size_t n = fread(all, 1, MAX_BYTES, from);
    fclose(from);
    uint8_t *data = malloc(n ? n : 1); /* as long as the input: a byte too far is seen */
    if (!data) {
        perror(file);
        free(all);
        return 1;
    }
    for (size_t i = 0; i < n; i++)
        data[i] = all[i];
    free(all);
    fprintf(stderr, "\r%s\n", file);
    LLVMFuzzerTestOneInput(data, n);
    free(data);
    return 0;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        if (replay(argv[i]))
            return 1;
    return argc > 1 ? 0 : 2;
}
