/* SPDX-License-Identifier: MIT
 *
 * The eight pencils that are part of the library, and loading by name: their files are linked in as one object
 * (the Makefile's pencils.o), whose symbols are named after them.
 */
#include "profile/file/format.h"
#include "profile/profile.h"

#include "base/array.h"

#include <errno.h>
#include <string.h>

#define PENCIL(id) extern const unsigned char _binary_##id##_pencil_start[], _binary_##id##_pencil_end[];
PENCIL(2H) PENCIL(H) PENCIL(F) PENCIL(HB) PENCIL(B) PENCIL(3B) PENCIL(6B) PENCIL(8B)
#undef PENCIL

/* From hard to soft: F lies between H and HB (JIS S 6006). */
static const struct {
    const char *grade;
    const unsigned char *start, *end;
} pencils[] = {
#define PENCIL(id) {#id, _binary_##id##_pencil_start, _binary_##id##_pencil_end},
    PENCIL(2H) PENCIL(H) PENCIL(F) PENCIL(HB) PENCIL(B) PENCIL(3B) PENCIL(6B) PENCIL(8B)
#undef PENCIL
};
#define PENCILS (sizeof pencils / sizeof *pencils)

const char *plb_profile_grade(size_t index)
{
    return index < PENCILS ? pencils[index].grade : NULL;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool same_name(const char *a, const char *b)
{
    while (*a && lower(*a) == lower(*b))
        a++, b++;
    return *a == *b;
}

static profile *load_file(const char *file, error *err)
{
    FILE *from = fopen(file, "rb");
    if (!from) {
        plb_fail(err, ERROR_FILE, "%s: neither one of the eight pencils (2H H F HB B 3B 6B 8B) nor a file that can be read: %s", file, strerror(errno));
        return NULL;
    }
    unsigned char *data = plb_new(FORMAT_MAX_SIZE + 1, 1);
    size_t size = data ? fread(data, 1, FORMAT_MAX_SIZE + 1, from) : 0;
    profile *p = NULL;
    if (!data)
        plb_fail_memory(err);
    else if (ferror(from))
        plb_fail(err, ERROR_FILE, "%s: cannot be read: %s", file, strerror(errno));
    else if (size > FORMAT_MAX_SIZE)
        plb_fail(err, ERROR_LIMIT, "%s: too large for a pencil profile", file);
    else
        p = plb_profile_parse(file, data, size, err);
    plb_free(data);
    fclose(from);
    return p;
}

profile *plb_profile_read(const char *grade_or_file, error *err)
{
    size_t i = 0;
    while (i < PENCILS && !same_name(grade_or_file, pencils[i].grade))
        i++;
    if (i == PENCILS)
        return load_file(grade_or_file, err);
    profile *p = plb_profile_parse(pencils[i].grade, pencils[i].start, (size_t)(pencils[i].end - pencils[i].start), err);
    if (p)
        p->grade = (int)i + 1;
    return p;
}
