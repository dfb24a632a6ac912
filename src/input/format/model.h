/* SPDX-License-Identifier: MIT
 *
 * Recognises solid models of simple formats, and runs the taps for models.
 */
#ifndef PLB_INPUT_FORMAT_MODEL_H
#define PLB_INPUT_FORMAT_MODEL_H

#include "input/input.h"

bool plb_is_model(const char *data, size_t size);

/* Runs the tap on a model of a format that it knows, with the look that in->look says. */
bool plb_model_run_tap(const input_source *in, const char *program, const char *format, display_list *list, error *err);

#endif
