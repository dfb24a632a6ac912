/* SPDX-License-Identifier: MIT
 *
 * See formats.h: what the formats share.
 */
#include "surface/picture/formats.h"

#include "base/array.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Bytes of the rows that are compressed together: large enough that their own code tables and their flush do not matter. */
#define PIECE_BYTES (256 * 1024)

page_background plb_picture_background(const picture_format *f, const picture_page *sheet)
{
    return f->see_through || sheet->background == PAGE_PAPER ? sheet->background : PAGE_WHITE;
}

/* Each row has a byte before it that says how it is filtered, where that matters. */
static size_t row_bytes(const picture_format *f, const picture_page *sheet)
{
    return (size_t)sheet->width * (size_t)plb_page_channels(plb_picture_background(f, sheet), sheet->colour) + 1;
}

int plb_picture_rows(const picture_format *f, const picture_page *sheet)
{
    size_t n = PIECE_BYTES / row_bytes(f, sheet);
    return n < 1 ? 1 : (int)n;
}

bool plb_picture_put(picture *p, const void *data, size_t n)
{
    p->written += n;
    return p->to.put(p->to.closure, data, n);
}

bool plb_picture_print(picture *p, const char *format, ...)
{
    char text[1024];
    va_list args;
    va_start(args, format);
    int n = vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return n >= 0 && n < (int)sizeof text && plb_picture_put(p, text, (size_t)n);
}

bool plb_picture_fail(const picture *p, error *err)
{
    if (errno == ENOMEM)
        return plb_fail_memory(err);
    return plb_fail(err, ERROR_FILE, "%s: cannot be written%s%s", p->name, errno ? ": " : "", errno ? strerror(errno) : "");
}

void plb_picture_row(const picture *p, int y, uint8_t *out)
{
    plb_page_row(p->band, plb_picture_background(p->format, p->page), y, out);
}

char *plb_picture_lines(const picture_page *sheet)
{
    size_t room = 1;
    for (const char *const *t = sheet->text; t && t[0]; t += 2)
        room += strlen(t[0]) + strlen(t[1]) + 3;
    char *lines = plb_new(room, 1), *to = lines;
    for (const char *const *t = sheet->text; to && t && t[0]; t += 2)
        to += snprintf(to, room - (size_t)(to - lines), "%s: %s\n", t[0], t[1]);
    return lines;
}

/* Chosen by eye: grain is noise, which low qualities turn into blocks. */
int plb_picture_quality(int level)
{
    static const int quality[] = {100, 92, 90, 88, 85, 82, 78, 74, 70, 65};
    return quality[level < 0 ? 0 : level > 9 ? 9 : level];
}

