/* SPDX-License-Identifier: MIT
 *
 * The standard normal distribution.
 */
#ifndef PLB_BASE_NUMBER_NORMAL_H
#define PLB_BASE_NUMBER_NORMAL_H

/* The share below x. */
double plb_normal_share(double x);
/* The value below which the share p in (0, 1) lies; 0 and 1 give -8 and 8. Good to 1e-9. */
double plb_normal_quantile(double p);

#endif
