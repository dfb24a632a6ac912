/* SPDX-License-Identifier: MIT
 *
 * The harnesses share this header. Each file fuzz_NAME.c defines LLVMFuzzerTestOneInput: linked with libFuzzer it is a fuzzer,
 * linked with replay.c it draws the kept inputs of corpus-NAME once, with any compiler.
 */
#ifndef PLB_TESTS_FUZZ_H
#define PLB_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Stops the program where something does not hold that must hold for every input. */
#define fuzz_require(truth) ((truth) ? (void)0 : abort())

#endif
