/* SPDX-License-Identifier: MIT
 *
 * See command_line.h.
 */
#include "tool/command/command_line.h"

#include "tool/command/pages.h"

#include <stdio.h>
#include <string.h>

/* ---- what is no setting of the library, or more than one ---- */

static bool set_output(void *p, const char *v) { return ((settings *)p)->output = v, *v != '\0'; }
static bool set_pencil(void *p, const char *v) { return ((settings *)p)->pencil = v, *v != '\0'; }
static bool set_no_clobber(void *p, const char *v) { return (void)v, ((settings *)p)->no_clobber = true; }
static bool set_film(void *p, const char *v) { return (void)v, ((settings *)p)->film = true; }
static bool set_page(void *p, const char *v)
{
    const char *list = v;
    page_range range;
    ((settings *)p)->pages = v;
    while (pages_next(&list, &range)) {}
    return *v && !*list;
}
static bool set_dump(void *p, const char *v)
{
    static const char *const names[] = {"list", "strokes", "controls"};
    for (int i = 0; i < 3; i++)
        if (!strcmp(v, names[i]))
            return ((settings *)p)->dump = i, true;
    return false;
}
static bool set_completions(void *p, const char *v)
{
    ((settings *)p)->completions = v;
    return !strcmp(v, "bash") || !strcmp(v, "zsh") || !strcmp(v, "fish");
}
static bool set_list_pencils(void *p, const char *v) { return (void)v, ((settings *)p)->list_pencils = true; }
static bool set_quiet(void *p, const char *v)
{
    settings *s = p; /* the last of -q and -v decides */
    (void)v;
    s->verbose = 0;
    return s->quiet = true;
}
static bool set_verbose(void *p, const char *v)
{
    settings *s = p;
    (void)v;
    s->quiet = false;
    return s->verbose++, true;
}
static bool set_version(void *p, const char *v) { return (void)v, ((settings *)p)->version = true; }
static bool set_help(void *p, const char *v) { return (void)v, ((settings *)p)->help = true; }

/* The program's own options: each is listed after the setting that it names, or before those of the output (""), and an
 * option with the name of a setting stands in its place. The rest makes a group of its own. */
static const struct {
    const char *after;
    option o;
} own[] = {
    {NULL, {.name = "page", .argument = "N|N-M|all", .words = "all", .help = "which pages of a PDF or PostScript file, also a list [1]", .set = set_page}},
    {"", {.letter = 'o', .name = "output", .argument = "FILE", .help = ".png .pdf .svg .jpg .webp .tif, a folder, or '-': standard output; %s: drawing, %d: page [FILE.png]", .set = set_output}},
    {"", {.name = "no-clobber", .help = "leave pictures that are there as they are", .set = set_no_clobber}},
    {"", {.name = "film", .help = "an animated PNG in which the drawing draws itself [FILE.film.png]", .set = set_film}},
    {NULL, {.letter = 's', .name = "seed", .argument = "SEED", .words = "random", .help = "a whole number, or 'random': another hand for the same drawing [1]"}},
    {"pencil", {.name = "list-pencils", .help = "show the pencils that are built in", .set = set_list_pencils}},
    {NULL, {.name = "dump", .argument = "list|strokes|controls", .words = "list strokes controls", .help = "show what a stage made instead of drawing", .set = set_dump}},
    {NULL, {.letter = 'q', .name = "quiet", .help = "no warnings, no progress", .set = set_quiet}},
    {NULL, {.letter = 'v', .name = "verbose", .help = "say what is done", .set = set_verbose}},
    {NULL, {.name = "completions", .argument = "bash|zsh|fish", .words = "bash zsh fish", .help = "print what makes a shell complete these options", .set = set_completions}},
    {NULL, {.letter = 'V', .name = "version", .help = "show the version", .set = set_version}},
    {NULL, {.letter = 'h', .name = "help", .help = "show this help", .set = set_help}},
};
#define OWN_ROWS (sizeof own / sizeof *own)
#define FIRST_OF_OUTPUT "dpi"

/* ---- the table ---- */

/* Copies text for as long as the table lives, which has space for what its rows need. */
static const char *keep(command_table *t, const char *text)
{
    size_t n = strlen(text) + 1;
    if (n > sizeof t->text - t->used)
        return "";
    char *kept = t->text + t->used;
    memcpy(kept, text, n);
    t->used += n;
    return kept;
}

static const char *pencil_word(const plb_setting *s, size_t i)
{
    return (void)s, plb_pencil_name(i);
}

/* Lists the words of a setting, "white none" or "white|none". NULL where there are no words. */
static const char *words_of(command_table *t, const plb_setting *s, const char *between)
{
    const char *(*word)(const plb_setting *, size_t) = s->kind == PLB_SETTING_PENCIL ? pencil_word : plb_setting_word;
    char text[256] = "";
    for (size_t i = 0; word(s, i) && strlen(text) + strlen(word(s, i)) + 2 < sizeof text; i++) {
        strcat(text, i ? between : "");
        strcat(text, word(s, i));
    }
    return *text ? keep(t, text) : NULL;
}

/* Makes the help of a setting with its range and its default. */
static const char *help_of(command_table *t, const plb_setting *s)
{
    char range[96] = "", usual[64] = "";
    if (*s->unit && (s->kind == PLB_SETTING_NUMBER || s->kind == PLB_SETTING_WHOLE))
        snprintf(range, sizeof range, ", %.10g to %.10g %s", s->min, s->max, s->unit);
    if (*s->usual && s->kind != PLB_SETTING_FLAG && !strstr(s->help, "auto:"))
        snprintf(usual, sizeof usual, " [%s]", s->usual);
    char text[256];
    snprintf(text, sizeof text, "%s%s%s", s->help, range, usual);
    return keep(t, text);
}

static option option_of(command_table *t, const plb_setting *s)
{
    option o = {.letter = s->letter, .name = s->name, .argument = s->argument, .words = words_of(t, s, " ")};
    if (s->kind == PLB_SETTING_CHOICE)
        o.argument = words_of(t, s, "|");
    if (s->kind == PLB_SETTING_PENCIL)
        o.set = set_pencil; /* which is loaded when all options are known */
    if (!strcmp(s->name, "colour"))
        o.alias = "color";
    for (size_t k = 0; k < OWN_ROWS; k++)
        if (!strcmp(own[k].o.name, s->name))
            return own[k].o;
    o.help = help_of(t, s);
    return o;
}

static void add_own(command_table *t, const char *after)
{
    for (size_t k = 0; k < OWN_ROWS; k++)
        if (own[k].after && !strcmp(own[k].after, after))
            t->rows[t->n++] = own[k].o;
}

static bool is_setting(const char *name)
{
    const plb_setting *s;
    for (size_t i = 0; (s = plb_setting_at(i)); i++)
        if (!strcmp(s->name, name))
            return true;
    return false;
}

void command_table_init(command_table *t)
{
    const plb_setting *s;
    const char *group = "";
    t->n = t->used = 0;
    for (size_t i = 0; (s = plb_setting_at(i)); i++) {
        if (strcmp(group, s->group) != 0)
            t->rows[t->n++] = (option){.help = group = s->group};
        if (!strcmp(s->name, FIRST_OF_OUTPUT))
            add_own(t, "");
        t->rows[t->n++] = option_of(t, s);
        add_own(t, s->name);
    }
    t->rows[t->n++] = (option){.help = "Diagnosis"};
    for (size_t k = 0; k < OWN_ROWS; k++)
        if (!own[k].after && !is_setting(own[k].o.name))
            t->rows[t->n++] = own[k].o;
}

/* ---- values ---- */

/* Tells once that a length has no unit: a user who means millimetres sees which unit counts. */
static void note_bare_length(settings *s, const char *name, const char *value)
{
    const plb_setting *row = NULL;
    for (size_t i = 0; (row = plb_setting_at(i)) && strcmp(row->name, name) != 0;)
        i++;
    double mm;
    char last = *value ? value[strlen(value) - 1] : 'x';
    bool bare = row && row->kind == PLB_SETTING_LENGTH && ((last >= '0' && last <= '9') || last == '.');
    if (bare && !*s->note && plb_parse_length(value, &mm) && mm != 0)
        snprintf(s->note, sizeof s->note, "--%s %.32s is %.32s px, %.4g mm; write %.32smm for millimetres", name, value, value, mm, value);
}

/* Stores a setting of the library, whose errors begin with its name. */
static bool store_setting(void *p, const option *o, const char *value, char why[OPTION_WHY_SIZE])
{
    settings *s = p;
    plb_error e = {PLB_OK, ""};
    bool is_seed = !strcmp(o->name, "seed");
    if (is_seed && !strcmp(value, "random"))
        return s->random_seed = true;
    s->random_seed = s->random_seed && !is_seed;
    if (!plb_options_set(s->o, o->name, value ? value : "on", &e)) {
        snprintf(why, OPTION_WHY_SIZE, "%s%s", e.text, is_seed ? " (or random)" : "");
        return false;
    }
    if (value)
        note_bare_length(s, o->name, value);
    return true;
}

bool command_line_parse(settings *s, const command_table *t, int argc, char **argv, int *operands)
{
    const option_parser parser = {PROGRAM, t->rows, t->n, store_setting};
    return options_parse(&parser, argc, argv, s, operands);
}
