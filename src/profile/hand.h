/* SPDX-License-Identifier: MIT
 *
 * The free hand, as measured on 104 freehand lines of six hands, 16 to 250 mm long (scans of hdBPMN, CC BY 4.0): how far it deviates
 * from the chord of a line, in sine modes over the length. Each has the same share of the length for short and long lines.
 * A pencil's own lines are measured against the free hand.
 */
#ifndef PLB_PROFILE_HAND_H
#define PLB_PROFILE_HAND_H

#define HAND_MODES 8
/* Median amplitude of each mode, % of the length. */
extern const double plb_hand_median_percent[HAND_MODES];
/* Shorter waves than this the hand does not make, mm: what looks rough there is grain. */
#define HAND_SMOOTH_BELOW_MM 4.0

/* Gives the amplitudes of the modes of a line, times the free hand's medians, into `ratios`; returns their count: modes of shorter waves
 * are left out. `line`: the distance of the centreline across, px, in each of n columns; `mm`: a pixel in mm. */
int plb_hand_compare(const double line[], int n, double mm, double ratios[HAND_MODES]);

#endif
