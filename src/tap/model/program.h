/* SPDX-License-Identifier: MIT
 *
 * The programs that read solid models differ in how they read; all else is here.
 */
#ifndef PLB_TAP_MODEL_PROGRAM_H
#define PLB_TAP_MODEL_PROGRAM_H

#include "tap/model/model.h"

/* Reads data[0..size), which is of the format with this index, with the contract of raw_model.h. */
typedef bool (*model_reader)(const char *data, size_t size, int format, raw_model *m, error *err);

/* Reads the command line, the first word of which is one of n formats; reads the model on descriptor 0 and writes the list to descriptor 1. Ends
 * the process. */
void __attribute__((noreturn)) plb_model_program(int argc, char **argv, const char *const formats[], int n, model_reader read_model);

#endif
