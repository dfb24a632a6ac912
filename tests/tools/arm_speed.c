/* SPDX-License-Identifier: MIT
 *
 * arm_speed jerk|lognormal|torque|spring: the speed of an arm over the time of one movement as an SVG drawing, two axes and
 * a curve for each of three lines, to be drawn by plumbago itself.
 */
#include "stroke/stroke.h"

#include <stdio.h>
#include <string.h>

#define WIDTH 60.0
#define HEIGHT 34.0
#define FASTEST 4.8 /* mean speeds: the top of the picture */
enum { STEPS = 60 };

static void print_curve(const arm_model *arm, const stroke_options *o, uint64_t identity)
{
    printf("<path d=\"");
    for (int i = 0; i <= STEPS; i++) {
        double t0 = (i - 0.5) / STEPS, t1 = (i + 0.5) / STEPS;
        t0 = t0 < 0 ? 0 : t0;
        t1 = t1 > 1 ? 1 : t1;
        double v = i == 0 || i == STEPS ? 0 : (plb_arm_progress(arm, identity, o, t1) - plb_arm_progress(arm, identity, o, t0)) / (t1 - t0);
        printf("%c%.3f %.3f", i ? 'L' : 'M', 5 + (WIDTH - 8) * i / STEPS, HEIGHT - 4 - (HEIGHT - 8) * v / FASTEST);
    }
    printf("\"/>\n");
}

int main(int argc, char **argv)
{
    stroke_options o = {.seed = 1};
    const arm_model *arm = &plb_arm_jerk;
    for (size_t i = 0; argc == 2 && (arm = plb_arm_at(i)) && strcmp(arm->name, argv[1]) != 0;)
        i++;
    if (!arm)
        return 2;
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%gmm\" height=\"%gmm\" viewBox=\"0 0 %g %g\" fill=\"none\" stroke=\"#000\" "
           "stroke-width=\".3\">\n<path d=\"M5 3V%gH%g\"/>\n",
           WIDTH, HEIGHT, WIDTH, HEIGHT, HEIGHT - 4, WIDTH - 2);
    for (uint64_t identity = 1; identity <= (arm == &plb_arm_lognormal ? 3 : 1); identity++)
        print_curve(arm, &o, identity);
    printf("</svg>\n");
    return 0;
}
