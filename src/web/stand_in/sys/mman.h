/* SPDX-License-Identifier: MIT
 *
 * This header stands in for that of memory maps: there are no large pages to ask for.
 */
#ifndef PLB_WEB_STAND_IN_SYS_MMAN_H
#define PLB_WEB_STAND_IN_SYS_MMAN_H

#include <stddef.h>

#endif
