/* SPDX-License-Identifier: MIT
 *
 * Prints the rows of src/api/pencil/tone_known.c: the scale of tones of each of the eight pencils, measured on large swatches.
 */
#include "api/pencil/tone.h"

#include <stdio.h>

int main(void)
{
    bool ok = true;
    for (size_t i = 0; ok && plb_pencil_name(i); i++) {
        plb_options *o = plb_options_new();
        error err = {ERROR_NONE, ""};
        tone_scale found = {{0}};
        ok = o && plb_options_set(o, "pencil", plb_pencil_name(i), NULL);
        plan_options plan = ok ? plb_api_plan_options(o) : (plan_options){0};
        ok = ok && plb_api_measure_tone(o, &plan, 50, 150, &found, &err);
        if (ok) {
            printf("    {{");
            for (int k = 0; k < TONE_STEPS; k++)
                printf("%s%.3f", k ? ", " : "", found.darkness[k]);
            printf("}}, /* %s */\n", plb_pencil_name(i));
        } else {
            fprintf(stderr, "tone_scale: %s\n", err.text);
        }
        plb_options_free(o);
    }
    return ok ? 0 : 1;
}
