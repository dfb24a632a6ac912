/* SPDX-License-Identifier: MIT
 *
 * Ends a tap that has no memory left (tap_memory.c).
 */
#ifndef PLB_TAP_COMMON_TAP_MEMORY_H
#define PLB_TAP_COMMON_TAP_MEMORY_H

enum { TAP_EXIT_MEMORY = 125 }; /* exit status; the line on standard error is "out of memory" */

#endif
