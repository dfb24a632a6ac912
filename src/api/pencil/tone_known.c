/* SPDX-License-Identifier: MIT
 *
 * The scales of tones of the eight pencils as they are used mostly, measured once, as tone.c does for all others, on swatches of 50 mm at
 * 150 dpi: a drawing then need not wait for it. Where this table no longer holds, tests/unit/test_tone_scale.c says so; make
 * tones prints a new one.
 */
#include "api/pencil/tone.h"

#include "surface/page.h"

static const tone_scale known[] = {
    {{.041, .061, .087, .124, .192, .304, .419, .514, .578}}, /* 2H */
    {{.044, .065, .093, .130, .205, .322, .439, .536, .599}}, /* H */
    {{.049, .073, .104, .146, .227, .354, .477, .573, .631}}, /* F */
    {{.053, .079, .112, .158, .243, .378, .504, .601, .654}}, /* HB */
    {{.057, .084, .121, .167, .260, .407, .541, .639, .693}}, /* B */
    {{.068, .099, .143, .198, .306, .475, .629, .735, .790}}, /* 3B */
    {{.079, .115, .166, .231, .355, .540, .697, .795, .834}}, /* 6B */
    {{.088, .130, .181, .254, .387, .596, .756, .849, .879}}, /* 8B */
};

const tone_scale *plb_api_tone_of_grade(size_t index)
{
    return index < sizeof known / sizeof *known ? &known[index] : NULL;
}

const tone_scale *plb_api_tone_known(const plb_options *o)
{
    int grade = o->profile->p->grade;
    bool is_usual = plb_model_at((size_t)o->model) == &plb_model_graphite && o->paper == PAPER_MEDIUM && o->pressure == 1 && o->squiggle < 0;
    return is_usual && grade > 0 ? plb_api_tone_of_grade((size_t)grade - 1) : NULL;
}
