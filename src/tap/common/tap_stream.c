/* SPDX-License-Identifier: MIT */
#include "tap/common/tap_stream.h"

#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#define PART_BYTES ((size_t)1 << 18)

char *plb_tap_read_all(size_t *size)
{
    char *all = NULL;
    size_t capacity = 0;
    for (*size = 0;;) {
        if (capacity - *size < PART_BYTES) {
            capacity = capacity ? capacity * 2 : 2 * PART_BYTES;
            char *more = *size > TAP_MAX_BYTES ? NULL : realloc(all, capacity);
            if (!more)
                return free(all), NULL;
            all = more;
        }
        ssize_t n = read(STDIN_FILENO, all + *size, PART_BYTES);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return all;
        *size += (size_t)n;
    }
}

bool plb_tap_put(const char *data, size_t size)
{
    for (size_t done = 0; done < size;) {
        ssize_t n = write(STDOUT_FILENO, data + done, size - done);
        if (n < 0 && errno != EINTR)
            return false;
        done += n < 0 ? 0 : (size_t)n;
    }
    return true;
}
