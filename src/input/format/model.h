/* SPDX-License-Identifier: MIT
 *
 * Recognises solid models.
 */
#ifndef PLB_INPUT_FORMAT_MODEL_H
#define PLB_INPUT_FORMAT_MODEL_H

#include <stdbool.h>
#include <stddef.h>

bool plb_is_model(const char *data, size_t size);

#endif
