/* SPDX-License-Identifier: MIT
 *
 * A solid model as somebody would draw it: the whole of tap-model between the file's bytes and the list's text.
 */
#ifndef PLB_TAP_MODEL_MODEL_H
#define PLB_TAP_MODEL_MODEL_H

#include "list/text/list_write.h"
#include "tap/model/shade/shade.h"

typedef enum { MODEL_OBJ, MODEL_STL, MODEL_PLY, MODEL_OFF, MODEL_FORMATS } model_format;
typedef enum { HIDDEN_AUTO, HIDDEN_NONE, HIDDEN_DASHED, HIDDEN_FAINT } hidden_style;
typedef enum { SHEET_NONE, SHEET_FIRST_ANGLE, SHEET_THIRD_ANGLE } sheet_kind;

typedef struct {
    direction_of_view from;
    bool is_upright_by_format;
    up_axis up;          /* else */
    double crease;       /* degrees */
    hidden_style hidden;
    light light;
    sheet_kind sheet;
} model_settings;

model_settings plb_model_settings_default(void);

/* Draws the model, which is used up, to the list. False: nothing was written, and `err` says why. */
bool plb_model_draw(raw_model *m, const model_settings *s, list_put put, void *closure, error *err);

/* Reads data[0..size) and draws it. */
bool plb_model_read(const char *data, size_t size, model_format format, raw_model *m, error *err);

#endif
