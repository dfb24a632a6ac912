/* SPDX-License-Identifier: MIT
 *
 * This header stands in for zlib's: the core needs one checksum of it.
 */
#ifndef PLB_WEB_STAND_IN_ZLIB_H
#define PLB_WEB_STAND_IN_ZLIB_H

#include <stddef.h>

/* Returns the CRC-32 of `size` bytes that follow others whose checksum is `crc` (0: none) [PNG, annex D]. */
unsigned long crc32_z(unsigned long crc, const unsigned char *data, size_t size);

#endif
