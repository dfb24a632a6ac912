/* SPDX-License-Identifier: MIT
 *
 * This file keeps the pencils of the browser's core. They are not linked in, because a page needs one or two: the script
 * hands over their files, and asks for the name of one that was missed.
 */
#include "profile/profile.h"
#include "web/pencils.h"

#include "base/array.h"

#include <string.h>

/* From hard to soft, as in the library. */
static const char *const grades[] = {"2H", "H", "F", "HB", "B", "3B", "6B", "8B"};
#define GRADES (sizeof grades / sizeof *grades)

/* A WebAssembly instance is one process with one thread: this is its state. */
static struct {
    const unsigned char *data;
    size_t size;
} files[GRADES];
static const char *missing;

const char *plb_profile_grade(size_t index)
{
    return index < GRADES ? grades[index] : NULL;
}

static char upper(char c)
{
    return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c;
}

static size_t find_grade(const char *name)
{
    size_t i = 0;
    for (; i < GRADES; i++) {
        size_t k = 0;
        while (name[k] && upper(name[k]) == grades[i][k])
            k++;
        if (!name[k] && !grades[i][k])
            break;
    }
    return i;
}

bool plb_web_keep_pencil(const char *grade, const unsigned char *data, size_t size)
{
    size_t i = find_grade(grade);
    if (i == GRADES)
        return false;
    files[i].data = data;
    files[i].size = size;
    return true;
}

const char *plb_web_missing_pencil(void)
{
    const char *asked = missing;
    missing = NULL;
    return asked;
}

profile *plb_profile_read(const char *grade_or_file, error *err)
{
    size_t i = find_grade(grade_or_file);
    missing = NULL;
    if (i == GRADES) {
        plb_fail(err, ERROR_FILE, "%s: not one of the eight pencils (2H H F HB B 3B 6B 8B)", grade_or_file);
        return NULL;
    }
    if (!files[i].data) {
        missing = grades[i];
        plb_fail(err, ERROR_FILE, "%s: this pencil's file was not handed over", grade_or_file);
        return NULL;
    }
    profile *p = plb_profile_parse(grades[i], files[i].data, files[i].size, err);
    if (p)
        p->grade = (int)i + 1;
    return p;
}
