/* SPDX-License-Identifier: MIT
 *
 * The known scales of tones are those that are measured.
 */
#include "check.h"

#include "api/pencil/tone.h"

static void known_scales_hold(void)
{
    for (size_t i = 0; plb_pencil_name(i); i++) {
        plb_options *o = plb_options_new();
        CHECK(o && plb_options_set(o, "pencil", plb_pencil_name(i), NULL));
        plan_options plan = plb_api_plan_options(o);
        const tone_scale *known = plb_api_tone_known(o);
        tone_scale measured;
        CHECK(known && plb_api_measure_tone(o, &plan, 24, 100, &measured, NULL));
        for (int k = 0; k < TONE_STEPS; k++) {
            CHECK_RANGE(measured.darkness[k] - known->darkness[k], -0.035, 0.035);
            CHECK(k == 0 || known->darkness[k] > known->darkness[k - 1]);
        }
        plb_options_free(o);
    }
}

static void softer_pencils_go_darker(void)
{
    double before = 0;
    for (size_t i = 0; plb_pencil_name(i); i++) {
        plb_options *o = plb_options_new();
        CHECK(o && plb_options_set(o, "pencil", plb_pencil_name(i), NULL));
        double darkest = plb_api_tone_known(o)->darkness[TONE_STEPS - 1];
        CHECK(darkest > before);
        before = darkest;
        plb_options_free(o);
    }
    CHECK(before > 0.86); /* 8B */
}

static void other_settings_are_measured(void)
{
    plb_options *o = plb_options_new();
    CHECK(plb_api_tone_known(o));
    CHECK(plb_options_set(o, "pressure", "0.5", NULL) && !plb_api_tone_known(o));
    plan_options plan = plb_api_plan_options(o);
    CHECK(plb_api_find_tone(o, &plan, NULL));
    double pale = plan.tone.darkness[TONE_STEPS - 1];
    CHECK(plb_options_set(o, "pressure", "1", NULL) && plb_api_find_tone(o, &plan, NULL));
    CHECK(pale < plan.tone.darkness[TONE_STEPS - 1] - 0.05);
    plb_options_free(o);
}

int main(void)
{
    RUN(known_scales_hold);
    RUN(softer_pencils_go_darker);
    RUN(other_settings_are_measured);
    CHECK_EXIT;
}
