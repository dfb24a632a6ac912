/* SPDX-License-Identifier: MIT
 *
 * This table lists the numbers of the grain in the order of the file, and the bounds within which drawing with them is safe. pencil(5)
 * has the same table.
 */
#include "profile/grain/grain.h"

#include "profile/grain/grain_math.h"

#include <math.h>
#include <stddef.h>

const float plb_grain_levels[GRAIN_LEVELS] = {0,     0.005f, 0.01f, 0.02f, 0.03f, 0.045f, 0.06f, 0.08f, 0.1f, 0.13f, 0.16f, 0.2f, 0.25f,
                                              0.3f,  0.4f,   0.5f,  0.6f,  0.7f,  0.8f,   0.9f,  1.0f,  1.1f, 1.2f,  1.3f,  1.4f};

/* The bounds are generous beside what scans give, and tight enough that no drawn value leaves the range of a float. */
#define AT(member) offsetof(grain_model, member)
const grain_field plb_grain_fields[GRAIN_FIELDS] = {
    {AT(reference_width), 1, 0.5f, 100},
    {AT(section), GRAIN_SECTION, 0, 8},
    {AT(mode), GRAIN_MODES * GRAIN_MODE_PLACES, -1, 1},
    {AT(mode_between), GRAIN_MODES, 0, 100},
    {AT(mode_within), GRAIN_MODES, 0, 100},
    {AT(mode_length), GRAIN_MODES, 1, 1000},
    {AT(darkness), GRAIN_LEVELS * GRAIN_SCORES, 0, 8},
    {AT(place_scale), GRAIN_PLACES, 0.1f, 10},
    {AT(place_along), GRAIN_PLACES, -1, 1},
    {AT(place_across), GRAIN_PLACES, -1, 1},
    {AT(chain_high), 1, -0.95f, 0.95f},
    {AT(chain_low), 1, -0.95f, 0.95f},
    {AT(chain_share), 1, 0, 1},
    {AT(chain_correlation), 1, -1, 1},
    {AT(filter), GRAIN_CLASSES * GRAIN_TAPS * GRAIN_TAPS, -1, 1},
    {AT(volatility), 1, 0, 2},
    {AT(volatility_across), 1, 0.01f, 0.99f},
    {AT(line_mean), 2, -4, 6},
    {AT(line_mean[2]), 1, -3, 2},
    {AT(line_mean[3]), 2, -1, 1},
    {AT(line_mean[5]), GRAIN_LINE - 5, -50, 50},
    {AT(line_factor), GRAIN_LINE * GRAIN_LINE, -10, 10},
};

static const float *values(const grain_model *g, size_t field)
{
    return (const float *)(const void *)((const char *)g + plb_grain_fields[field].offset);
}

/* Both states of the chain follow each other with probabilities between 0 and 1. */
static bool chain_is_sound(const grain_model *g)
{
    double p = g->chain_share, rho = g->chain_correlation;
    double stay = p + rho * (1 - p), change = p * (1 - rho);
    return stay >= -1e-6 && stay <= 1 + 1e-6 && change >= -1e-6 && change <= 1 + 1e-6;
}

static bool filters_are_sound(const grain_model *g)
{
    for (int c = 0; c < GRAIN_CLASSES; c++) {
        double energy = 0;
        for (int i = 0; i < GRAIN_TAPS * GRAIN_TAPS; i++)
            energy += g->filter[c][i / GRAIN_TAPS][i % GRAIN_TAPS] * g->filter[c][i / GRAIN_TAPS][i % GRAIN_TAPS];
        if (!(fabs(energy - 1) < 0.01))
            return false;
    }
    return true;
}

bool plb_grain_is_sound(const grain_model *g)
{
    for (size_t f = 0; f < GRAIN_FIELDS; f++) {
        const float *v = values(g, f);
        for (size_t i = 0; i < plb_grain_fields[f].count; i++)
            if (!(v[i] >= plb_grain_fields[f].low && v[i] <= plb_grain_fields[f].high)) /* NaN fails too */
                return false;
    }
    return chain_is_sound(g) && filters_are_sound(g);
}

void plb_grain_clamp(grain_model *g)
{
    for (size_t f = 0; f < GRAIN_FIELDS; f++) {
        const grain_field *field = &plb_grain_fields[f];
        float *v = (float *)(void *)((char *)g + field->offset);
        for (size_t i = 0; i < field->count; i++)
            v[i] = (float)clamp(v[i], field->low, field->high);
    }
}
