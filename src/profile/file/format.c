/* SPDX-License-Identifier: MIT
 *
 * Checksum and text check of profile files.
 */
#include "profile/file/format.h"

#include <zlib.h>

uint32_t plb_crc32(const unsigned char *data, size_t size)
{
    return (uint32_t)crc32_z(0, data, size);
}

/* Gives the length of the UTF-8 sequence at `s` and its code point; 0 when malformed (RFC 3629: no overlong forms, no
 * surrogates, nothing above U+10FFFF). */
static size_t decode(const unsigned char *s, size_t size, uint32_t *code)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    size_t n = s[0] < 0x80 ? 1 : s[0] < 0xc0 ? 0 : s[0] < 0xe0 ? 2 : s[0] < 0xf0 ? 3 : s[0] < 0xf8 ? 4 : 0;
    if (n == 0 || n > size)
        return 0;
    *code = n == 1 ? s[0] : s[0] & (0x7fu >> n);
    for (size_t i = 1; i < n; i++) {
        if ((s[i] & 0xc0) != 0x80)
            return 0;
        *code = *code << 6 | (s[i] & 0x3fu);
    }
    bool surrogate = *code >= 0xd800 && *code < 0xe000;
    return *code < least[n] || *code > 0x10ffff || surrogate ? 0 : n;
}

bool plb_text_is_clean(const char *text, size_t size, bool lines)
{
    const unsigned char *s = (const unsigned char *)text;
    for (size_t i = 0, n; i < size; i += n) {
        uint32_t code;
        n = decode(s + i, size - i, &code);
        bool control = n && (code < 0x20 || (code >= 0x7f && code < 0xa0));
        if (n == 0 || (control && !(lines && (code == '\n' || code == '\t'))))
            return false;
    }
    return true;
}
