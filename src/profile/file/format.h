/* SPDX-License-Identifier: MIT
 *
 * The reader and the writer of profile files share these; pencil(5) is the description of the format.
 */
#ifndef PLB_PROFILE_FILE_FORMAT_H
#define PLB_PROFILE_FILE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* As PNG's: a byte above 127, the name, and line ends that a transfer as text would change. */
#define FORMAT_MAGIC "\211PNCL\r\n\032"
#define FORMAT_MAGIC_SIZE 8
#define FORMAT_MAJOR 1
#define FORMAT_MINOR 2 /* 1: with the grain; 2: and the hand */
#define FORMAT_HEADER_SIZE 16  /* magic, major, minor, size of the file */
#define FORMAT_TRAILER_SIZE 4  /* CRC-32 of everything before it */
#define FORMAT_SECTION_HEAD 8  /* tag, length */

/* Bounds, chosen generously: the files of the eight pencils have 20 to 70 kB. */
#define FORMAT_MAX_SIZE (4u << 20)
#define FORMAT_MAX_SECTIONS 64
#define FORMAT_MAX_TEXT 65536u
#define FORMAT_MAX_COUNT 0x7fffffffu /* of all counts of a histogram or matrix together */
#define FORMAT_MAX_LINES 1000000u
#define FORMAT_MAX_PIXELS ((uint64_t)1 << 40)
#define FORMAT_MIN_DPI 10.0
#define FORMAT_MAX_DPI 10000.0
#define FORMAT_MAX_WIDTH 1000.0 /* px */
#define FORMAT_MAX_HAND 10.0 /* times a free hand */

/* Fixed point: lengths and resolutions in thousandths, greys in 256ths. */
#define FORMAT_MILLI 1000.0
#define FORMAT_GREY 256.0

/* CRC-32 as in zlib and PNG (ISO 3309: polynomial 0xedb88320, reflected, both ends inverted). */
uint32_t plb_crc32(const unsigned char *data, size_t size);
/* Tells whether the text is valid UTF-8 without control characters (line feed and tab pass when `lines`) and without a zero byte. */
bool plb_text_is_clean(const char *text, size_t size, bool lines);

#endif
