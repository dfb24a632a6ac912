/* SPDX-License-Identifier: MIT
 *
 * See film_format.h: what the kinds of files share.
 */
#include "film/format/film_format.h"

#include <errno.h>
#include <string.h>

const char *plb_film_number(const char *name, size_t *length, int *digits)
{
    for (const char *p = name; (p = strchr(p, '%')); p++) {
        bool is_padded = p[1] == '0' && p[2] >= '1' && p[2] <= '9' && p[3] == 'd';
        if (!is_padded && p[1] != 'd')
            continue;
        *length = is_padded ? 4 : 2;
        *digits = is_padded ? p[2] - '0' : 1;
        return p;
    }
    return NULL;
}

size_t plb_film_row(const film_page *page)
{
    return (size_t)page->width * (size_t)page->channels;
}

bool plb_film_fail(const film_writer *w, error *err)
{
    return plb_fail(err, ERROR_FILE, "%s: cannot be written%s%s", plb_output_shown(w->name), errno ? ": " : "", errno ? strerror(errno) : "");
}

bool plb_film_put(film_writer *w, const void *data, size_t n, error *err)
{
    return fwrite(data, 1, n, w->to) == n || plb_film_fail(w, err);
}

bool plb_film_open_output(film_writer *w, bool is_patched, error *err)
{
    if (!plb_output_open(&w->out, w->name, err))
        return false;
    w->is_spooled = is_patched && !w->out.name;
    w->to = w->is_spooled ? plb_output_spool(w->name, err) : w->out.to;
    return w->to != NULL;
}

bool plb_film_copy(FILE *spool, long from, size_t n, FILE *to)
{
    char bytes[1 << 14];
    if (fseek(spool, from, SEEK_SET) != 0)
        return false;
    while (n > 0) {
        size_t some = n < sizeof bytes ? n : sizeof bytes;
        if (fread(bytes, 1, some, spool) != some || fwrite(bytes, 1, some, to) != some)
            return false;
        n -= some;
    }
    return true;
}
