/* SPDX-License-Identifier: MIT
 *
 * tap-model: a solid model of a simple format on descriptor 0 becomes a display list on descriptor 1.
 *
 *     tap-model obj|stl|ply|off [--view=AZ,EL] ... <model >list
 */
#include "tap/model/program.h"

static bool read_model(const char *data, size_t size, int format, raw_model *m, error *err)
{
    return plb_model_read(data, size, (model_format)format, m, err);
}

int main(int argc, char **argv)
{
    static const char *const formats[MODEL_FORMATS] = {[MODEL_OBJ] = "obj", [MODEL_STL] = "stl", [MODEL_PLY] = "ply", [MODEL_OFF] = "off"};
    plb_model_program(argc, argv, formats, MODEL_FORMATS, read_model);
}
