/* SPDX-License-Identifier: MIT
 *
 * Reads and writes the values of settings as text, by their kinds; the same in every locale.
 */
#include "api/settings/settings.h"

#include "api/api_internal.h"
#include "base/array.h"
#include "base/number/number.h"
#include "base/number/units.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#define AUTOMATIC "auto"
/* An error shows so many bytes of a refused value. */
#define SHOWN 80

static void *field_of(const setting *s, plb_options *o)
{
    return (char *)o + s->offset;
}

static const void *value_of(const setting *s, const plb_options *o)
{
    return (const char *)o + s->offset;
}

static bool has_automatic(const setting *s)
{
    return !strcmp(s->shown.usual, AUTOMATIC);
}

/* ---- numbers ---- */

/* Reads the whole text as one finite decimal number. */
static bool read_number(const char *text, double *value)
{
    const char *next;
    return plb_parse_number(text, text + strlen(text), value, &next) && !*next && isfinite(*value);
}

/* Reads a ratio: "0.5", "50%", "1/2" or "1:2". */
static bool read_ratio(const char *text, double *value)
{
    const char *end = text + strlen(text), *next;
    double divisor = 1;
    if (!plb_parse_number(text, end, value, &next))
        return false;
    if (!strcmp(next, "%"))
        divisor = 100;
    else if (*next && !((*next == ':' || *next == '/') && read_number(next + 1, &divisor) && divisor > 0))
        return false;
    *value /= divisor;
    return isfinite(*value);
}

static bool read_whole(const char *text, uint64_t *value)
{
    uint64_t v = 0;
    for (const char *p = text; *p; p++) {
        if (*p < '0' || *p > '9' || v > (UINT64_MAX - (uint64_t)(*p - '0')) / 10)
            return false;
        v = v * 10 + (uint64_t)(*p - '0');
    }
    *value = v;
    return *text != '\0';
}

static bool is_in_range(const plb_setting *s, double value)
{
    return value >= s->min && value <= s->max;
}

static bool store_double(const setting *s, void *field, const char *text)
{
    double value;
    bool ok = s->shown.kind == PLB_SETTING_NUMBER ? read_number(text, &value) : s->shown.kind == PLB_SETTING_RATIO ? read_ratio(text, &value) : plb_read_length(text, &value);
    if (ok && is_in_range(&s->shown, value))
        return *(double *)field = value, true;
    return false;
}

static bool store_whole(const setting *s, void *field, const char *text)
{
    uint64_t value;
    if (read_whole(text, &value) && is_in_range(&s->shown, (double)value))
        return *(int *)field = (int)value, true;
    return false;
}

static bool store_seed(const setting *s, void *field, const char *text)
{
    (void)s;
    return read_whole(text, field);
}

/* ---- words ---- */

static bool store_choice(const setting *s, void *field, const char *text)
{
    setting_word word;
    for (size_t i = 0; (word = plb_setting_word_at(s, i)).name; i++)
        if (!strcmp(text, word.name))
            return *(int *)field = word.value, true;
    return false;
}

static const char *const turns[] = {[PAGE_AS_DRAWN] = "", [PAGE_PORTRAIT] = "-portrait", [PAGE_LANDSCAPE] = "-landscape"};

/* Reads the name of a page, in upper or lower case, perhaps with -portrait or -landscape. */
static bool store_page(const setting *s, void *field, const char *text)
{
    setting_word word;
    for (size_t i = 0; (word = plb_setting_word_at(s, i)).name; i++) {
        size_t n = strlen(word.name);
        for (int k = 0; k < 3 && !strncasecmp(text, word.name, n); k++)
            if (!strcasecmp(text + n, turns[k]))
                return *(page_choice *)field = (page_choice){word.width, word.height, (page_turn)k}, true;
    }
    return false;
}

/* Reads a size in pixels: "1200" or "800x600". */
static bool store_pixels(const setting *s, void *field, const char *text)
{
    char width[16];
    size_t n = strcspn(text, "x");
    uint64_t w = 0, h = 0;
    if (n >= sizeof width)
        return false;
    memcpy(width, text, n);
    width[n] = '\0';
    if (!read_whole(width, &w) || !is_in_range(&s->shown, (double)w) || (text[n] && !(read_whole(text + n + 1, &h) && is_in_range(&s->shown, (double)h))))
        return false;
    *(picture_pixels *)field = (picture_pixels){(int)w, (int)h};
    return true;
}

/* Reads the two angles of "30,20". */
static bool read_angles(const char *text, angle_choice *v)
{
    const char *next;
    return plb_parse_number(text, text + strlen(text), &v->a, &next) && *next == ',' && read_number(next + 1, &v->b) && isfinite(v->a);
}

/* Reads a word of the row, perhaps with an angle of its own, or two angles where the row's argument says so. */
static bool store_angles(const setting *s, void *field, const char *text)
{
    setting_word word;
    angle_choice v = {ANGLES_GIVEN, 0, 0};
    for (size_t i = 0; (word = plb_setting_word_at(s, i)).name; i++) {
        size_t n = strlen(word.name);
        if (!strcmp(text, word.name))
            return *(angle_choice *)field = (angle_choice){word.value, word.width, word.height}, true;
        if (!strncmp(text, word.name, n) && text[n] == '=' && word.width > 0 && strchr(s->shown.argument, '='))
            return read_number(text + n + 1, &v.a) && is_in_range(&s->shown, v.a) && (*(angle_choice *)field = (angle_choice){word.value, v.a, 0}, true);
    }
    if (!strchr(s->shown.argument, ',') || !read_angles(text, &v) || !is_in_range(&s->shown, v.a) || !(fabs(v.b) <= 90))
        return false;
    *(angle_choice *)field = v;
    return true;
}

static bool store_flag(const setting *s, void *field, const char *text)
{
    (void)s;
    bool on = !strcmp(text, "on");
    if (on || !strcmp(text, "off"))
        return *(bool *)field = on, true;
    return false;
}

/* ---- what is owned ---- */

static bool store_text(const setting *s, plb_options *o, const char *text, error *err)
{
    char **field = field_of(s, o), *copy = NULL;
    if (*text && !(copy = plb_new(strlen(text) + 1, 1)))
        return plb_fail_memory(err);
    if (copy)
        strcpy(copy, text);
    plb_free(*field);
    *field = copy;
    return true;
}

static bool store_pencil(plb_options *o, const char *text, error *err)
{
    plb_error failed = {PLB_OK, ""};
    plb_profile *loaded = plb_profile_load(text, &failed);
    if (!loaded)
        return plb_fail(err, (error_kind)failed.status, "%s", failed.text);
    plb_profile_free(o->profile);
    o->profile = loaded;
    return true;
}

/* ---- refusals ---- */

/* Lists the words of a choice: "right, left or none". */
static void list_words(const setting *s, char *text, size_t size)
{
    setting_word word;
    size_t at = 0;
    for (size_t i = 0; (word = plb_setting_word_at(s, i)).name && at < size; i++) {
        bool last = !plb_setting_word_at(s, i + 1).name;
        int written = snprintf(text + at, size - at, "%s%s", i == 0 ? "" : last ? " or " : ", ", word.name);
        at += written > 0 ? (size_t)written : size;
    }
}

static bool refuse(const setting *s, const char *value, error *err)
{
    const plb_setting *row = &s->shown;
    char takes[200], least[48], most[48];
    const char *also = has_automatic(s) ? ", or auto" : "";
    plb_format_number(least, row->min, 6);
    plb_format_number(most, row->max, 6);
    switch (row->kind) {
    case PLB_SETTING_CHOICE: list_words(s, takes, sizeof takes); break;
    case PLB_SETTING_PAGE: list_words(s, takes, sizeof takes); also = ", perhaps with -portrait or -landscape, or auto"; break;
    case PLB_SETTING_PIXELS: snprintf(takes, sizeof takes, "%s to %s, as 1200 or 800x600", least, most); break;
    case PLB_SETTING_ANGLES:
        list_words(s, takes, sizeof takes);
        also = strchr(row->argument, ',') ? ", or degrees, as -30,20, or auto" : ", perhaps with its degrees, as perspective=40";
        break;
    case PLB_SETTING_FLAG: snprintf(takes, sizeof takes, "on or off"); break;
    case PLB_SETTING_SEED: snprintf(takes, sizeof takes, "a whole number"); break;
    case PLB_SETTING_LENGTH: snprintf(takes, sizeof takes, "%s to %s mm, written as 84mm, 8.4cm, 3.3in, 240pt or 320px", least, most); break;
    case PLB_SETTING_RATIO: snprintf(takes, sizeof takes, "%s to %s, written as 0.5, 50%%, 1/2 or 1:2", least, most); break;
    case PLB_SETTING_WHOLE: snprintf(takes, sizeof takes, "a whole number, %s to %s", least, most); break;
    default: snprintf(takes, sizeof takes, "a number, %s to %s %s", least, most, row->unit); break;
    }
    return plb_fail(err, ERROR_ARGUMENT, "%s takes %s%s; not '%.*s'", row->name, takes, also, SHOWN, value);
}

static void store_automatic(const setting *s, void *field)
{
    if (s->shown.kind == PLB_SETTING_PAGE)
        *(page_choice *)field = (page_choice){0};
    else if (s->shown.kind == PLB_SETTING_PIXELS)
        *(picture_pixels *)field = (picture_pixels){0};
    else if (s->shown.kind == PLB_SETTING_ANGLES)
        *(angle_choice *)field = (angle_choice){ANGLES_AUTO, 0, 0};
    else if (s->shown.kind == PLB_SETTING_WHOLE || s->shown.kind == PLB_SETTING_CHOICE)
        *(int *)field = (int)s->automatic;
    else
        *(double *)field = s->automatic;
}

bool plb_setting_store(const setting *s, plb_options *o, const char *value, error *err)
{
    void *field = field_of(s, o);
    bool ok = false;
    if (has_automatic(s) && !strcmp(value, AUTOMATIC)) {
        store_automatic(s, field);
        return true;
    }
    switch (s->shown.kind) {
    case PLB_SETTING_NUMBER:
    case PLB_SETTING_LENGTH:
    case PLB_SETTING_RATIO: ok = store_double(s, field, value); break;
    case PLB_SETTING_WHOLE: ok = store_whole(s, field, value); break;
    case PLB_SETTING_SEED: ok = store_seed(s, field, value); break;
    case PLB_SETTING_CHOICE: ok = store_choice(s, field, value); break;
    case PLB_SETTING_PAGE: ok = store_page(s, field, value); break;
    case PLB_SETTING_PIXELS: ok = store_pixels(s, field, value); break;
    case PLB_SETTING_ANGLES: ok = store_angles(s, field, value); break;
    case PLB_SETTING_FLAG: ok = store_flag(s, field, value); break;
    case PLB_SETTING_TEXT: return store_text(s, o, value, err);
    case PLB_SETTING_PENCIL: return store_pencil(o, value, err);
    }
    return ok || refuse(s, value, err);
}

/* ---- back to text ---- */

static bool is_automatic(const setting *s, const void *field)
{
    if (!has_automatic(s))
        return false;
    if (s->shown.kind == PLB_SETTING_PAGE)
        return ((const page_choice *)field)->width <= 0;
    if (s->shown.kind == PLB_SETTING_PIXELS)
        return ((const picture_pixels *)field)->width <= 0;
    if (s->shown.kind == PLB_SETTING_ANGLES)
        return ((const angle_choice *)field)->word == ANGLES_AUTO;
    bool whole = s->shown.kind == PLB_SETTING_WHOLE || s->shown.kind == PLB_SETTING_CHOICE;
    return whole ? *(const int *)field == (int)s->automatic : *(const double *)field == s->automatic;
}

static const char *word_of(const setting *s, int value)
{
    size_t i = 0;
    while (plb_setting_word_at(s, i).name && plb_setting_word_at(s, i).value != value)
        i++;
    return plb_setting_word_at(s, i).name;
}

static void print_page(const setting *s, const page_choice *p, char *text, size_t size)
{
    size_t i = 0;
    while (plb_setting_word_at(s, i).name && plb_setting_word_at(s, i).height != p->height)
        i++;
    snprintf(text, size, "%s%s", plb_setting_word_at(s, i).name, turns[p->turn]);
}

static void print_pixels(const picture_pixels *p, char *text, size_t size)
{
    if (p->height > 0)
        snprintf(text, size, "%dx%d", p->width, p->height);
    else
        snprintf(text, size, "%d", p->width);
}

static void print_angles(const setting *s, const angle_choice *v, char *text, size_t size)
{
    char a[48], b[48];
    size_t i = 0;
    while (v->word >= 0 && plb_setting_word_at(s, i).value != v->word)
        i++;
    setting_word word = plb_setting_word_at(s, i);
    plb_format_number(a, v->a, 9);
    if (v->word < 0)
        snprintf(text, size, "%s,%s", a, plb_format_number(b, v->b, 9));
    else if (v->a == word.width)
        snprintf(text, size, "%s", word.name);
    else
        snprintf(text, size, "%s=%s", word.name, a);
}

bool plb_setting_print(const setting *s, const plb_options *o, char *text, size_t size)
{
    const void *field = value_of(s, o);
    char number[48], made[128] = "";
    const char *shown = made;
    if (is_automatic(s, field))
        shown = AUTOMATIC;
    else
        switch (s->shown.kind) {
        case PLB_SETTING_NUMBER:
        case PLB_SETTING_RATIO: snprintf(made, sizeof made, "%s", plb_format_number(number, *(const double *)field, 9)); break;
        case PLB_SETTING_LENGTH: snprintf(made, sizeof made, "%smm", plb_format_number(number, *(const double *)field, 9)); break;
        case PLB_SETTING_WHOLE: snprintf(made, sizeof made, "%d", *(const int *)field); break;
        case PLB_SETTING_SEED: snprintf(made, sizeof made, "%llu", (unsigned long long)*(const uint64_t *)field); break;
        case PLB_SETTING_CHOICE: shown = word_of(s, *(const int *)field); break;
        case PLB_SETTING_PAGE: print_page(s, field, made, sizeof made); break;
        case PLB_SETTING_PIXELS: print_pixels(field, made, sizeof made); break;
        case PLB_SETTING_ANGLES: print_angles(s, field, made, sizeof made); break;
        case PLB_SETTING_FLAG: shown = *(const bool *)field ? "on" : "off"; break;
        case PLB_SETTING_TEXT: shown = *(char *const *)field ? *(char *const *)field : ""; break;
        case PLB_SETTING_PENCIL: shown = plb_profile_name(o->profile); break;
        }
    bool fits = strlen(shown) < size;
    if (fits)
        strcpy(text, shown);
    return fits;
}

/* Tells whether both are the same pencil, perhaps loaded twice. */
static bool is_same_pencil(const profile *a, const profile *b)
{
    return a == b || (!strcmp(a->name, b->name) && a->width_half == b->width_half && a->hand == b->hand &&
                      !memcmp(a->ccm, b->ccm, (size_t)PROFILE_GREYS * PROFILE_GREYS * sizeof *a->ccm) && !memcmp(&a->grain, &b->grain, sizeof a->grain));
}

bool plb_setting_is_equal(const setting *s, const plb_options *a, const plb_options *b)
{
    const void *x = value_of(s, a), *y = value_of(s, b);
    switch (s->shown.kind) {
    case PLB_SETTING_NUMBER:
    case PLB_SETTING_LENGTH:
    case PLB_SETTING_RATIO: return *(const double *)x == *(const double *)y;
    case PLB_SETTING_WHOLE:
    case PLB_SETTING_CHOICE: return *(const int *)x == *(const int *)y;
    case PLB_SETTING_SEED: return *(const uint64_t *)x == *(const uint64_t *)y;
    case PLB_SETTING_PAGE: {
        const page_choice *p = x, *q = y;
        return p->width == q->width && p->height == q->height && p->turn == q->turn;
    }
    case PLB_SETTING_PIXELS: { /* of which the shape alone counts for the strokes */
        const picture_pixels *p = x, *q = y;
        return p->height == q->height && (p->width == q->width || p->height == 0);
    }
    case PLB_SETTING_ANGLES: {
        const angle_choice *p = x, *q = y;
        return p->word == q->word && p->a == q->a && p->b == q->b;
    }
    case PLB_SETTING_FLAG: return *(const bool *)x == *(const bool *)y;
    case PLB_SETTING_TEXT: {
        const char *p = *(char *const *)x, *q = *(char *const *)y;
        return !strcmp(p ? p : "", q ? q : "");
    }
    case PLB_SETTING_PENCIL: return is_same_pencil(a->profile->p, b->profile->p);
    }
    return false;
}

bool plb_setting_is_usual(const setting *s, const plb_options *o)
{
    char value[64];
    return plb_setting_print(s, o, value, sizeof value) && !strcmp(value, s->shown.usual);
}
