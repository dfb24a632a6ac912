/* SPDX-License-Identifier: MIT
 *
 * Recognises solid models of structured formats.
 */
#ifndef PLB_INPUT_FORMAT_SCENE_H
#define PLB_INPUT_FORMAT_SCENE_H

#include <stdbool.h>
#include <stddef.h>

bool plb_is_scene(const char *data, size_t size);

#endif
