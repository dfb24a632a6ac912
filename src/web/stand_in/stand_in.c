/* SPDX-License-Identifier: MIT
 *
 * This file stands in for what a browser has not: threads, programs that read foreign formats, and a checksum of zlib.
 */
#include "input/input.h"
#include "system/thread_team.h"

#include <stdint.h>
#include <zlib.h>

int plb_thread_team_processors(void)
{
    return 1;
}

bool plb_thread_team_run(int members, size_t n, team_work work, void *closure)
{
    (void)members;
    for (size_t i = 0; i < n; i++)
        if (!work(closure, 0, i))
            return false;
    return true;
}

unsigned long crc32_z(unsigned long crc, const unsigned char *data, size_t size)
{
    /* The register holds the complement; each bit divides it by the polynomial, lowest bit first. */
    uint32_t left = ~(uint32_t)crc;
    for (size_t i = 0; i < size; i++) {
        left ^= data[i];
        for (int bit = 0; bit < 8; bit++)
            left = left >> 1 ^ (0xedb88320u & (0u - (left & 1)));
    }
    return (uint32_t)~left;
}

/* Reads the one language that needs no program. */
bool plb_input_read(const input_source *in, display_list *list, error *err)
{
    return plb_read_list(in, list, err);
}
