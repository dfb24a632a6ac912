/* SPDX-License-Identifier: MIT
 *
 * plumbago: draws a vector drawing with a pencil. plumbago(1) is the manual.
 */
#include "api/plumbago.h"
#include "tool/command/command_line.h"
#include "tool/command/naming.h"
#include "tool/command/pages.h"
#include "tool/command/talk.h"
#include "tool/options/completions.h"
#include "tool/options/streams.h"
#include "tool/options/surroundings.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- what prints and ends ---- */

static void print_help(const command_table *t)
{
    printf("usage: " PROGRAM " [options] [FILE...]\n"
           "\n"
           "Draws FILE, a vector drawing (SVG, PDF, PostScript, EPS or DXF), as a person\n"
           "with a pencil would.\n"
           "\n"
           "  " PROGRAM " plan.svg                          plan.png appears beside it\n"
           "  " PROGRAM " -p 6B plan.ps -o - | display      in a pipe, with a soft pencil\n"
           "\n"
           "LEN is a number or fraction with mm cm in pt px: 84mm, 5/300in.\n");
    options_print(t->rows, t->n);
    printf("\nExit status: 0 drawn, 1 the drawing could not be made, 2 wrong command line.\n");
}

static int list_pencils(void)
{
    printf("%-6s %12s %10s\n", "pencil", "centre grey", "width mm");
    for (size_t i = 0; plb_pencil_name(i); i++) {
        plb_profile *p = plb_profile_load(plb_pencil_name(i), NULL);
        if (p)
            printf("%-6s %12d %10.2f\n", plb_pencil_name(i), plb_profile_centre_grey(p), plb_profile_width(p));
        plb_profile_free(p);
    }
    return EXIT_DRAWN;
}

/* ---- work ---- */

static uint64_t random_seed(void)
{
    uint64_t seed = (uint64_t)time(NULL) * 1000003u + (uint64_t)getpid();
    FILE *f = fopen("/dev/urandom", "rb");
    if (f) {
        if (fread(&seed, sizeof seed, 1, f) != 1)
            seed ^= 0x5bd1e995u;
        fclose(f);
    }
    return seed % 1000000000u; /* short enough to type again */
}

static bool is_text(const settings *s) { return s->dump == PLB_DUMP_LIST || s->dump == PLB_DUMP_STROKES; }

/* Refuses a name whose suffix promises a format that the library does not write. */
static const char *refuse_format(const settings *s, char *text, size_t size)
{
    plb_error e = {PLB_OK, ""};
    plb_format format;
    if (!s->output || is_text(s) || s->film || plb_format_of(s->output, &format, &e))
        return NULL;
    snprintf(text, size, "%s", e.text);
    return text;
}

static bool write_result(const settings *s, const plb_drawing *d, const char *to, plb_error *e)
{
    if (s->dump >= 0)
        return plb_drawing_dump(d, (plb_dump)s->dump, to, s->o, e);
    if (s->film)
        return plb_drawing_write_film(d, to, s->o, e);
    return s->document ? plb_document_add(s->document, d, s->o, e) : plb_drawing_write(d, to, s->o, e);
}

static bool look_at(const char *name, int stream, struct stat *st)
{
    return (strcmp(name, "-") ? stat(name, st) : fstat(stream, st)) == 0 && S_ISREG(st->st_mode);
}

/* Tells whether both names mean one file, also when the shell has opened one of them. */
static bool is_same_file(const char *to, const char *from)
{
    struct stat x, y;
    return look_at(to, STDOUT_FILENO, &x) && look_at(from, STDIN_FILENO, &y) && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

/* A job holds the files that one drawing needs. */
typedef struct {
    const char *input;
    const char *to; /* where the result goes, perhaps with a %d in it */
    plb_file *file;
    bool several;   /* pages may be drawn */
} job;

/* Puts the page's number and then the drawing's name into their places: a name that looks like a place is none. */
static char *result_name(const settings *s, const job *j, unsigned page)
{
    char *numbered = !s->film && (s->output || j->several) ? pages_name(j->to, page ? page : 1) : strdup(j->to);
    char *name = numbered && s->output ? naming_of(numbered, j->input) : numbered;
    if (name != numbered)
        free(numbered);
    return name;
}

static void tell_drawn(const settings *s, const plb_drawing *d, const char *to)
{
    char text[1024], pencil[64] = "", seed[32] = "";
    plb_options_get(s->o, "pencil", pencil, sizeof pencil);
    plb_options_get(s->o, "seed", seed, sizeof seed);
    snprintf(text, sizeof text, "%zu strokes on %.1f x %.1f mm with %s, seed %s: %s", plb_drawing_strokes(d), plb_drawing_width(d),
             plb_drawing_height(d), pencil, seed, to);
    talk_line(s->talk, "", text);
}

static void leave_alone(const settings *s, const char *to)
{
    char text[1024];
    snprintf(text, sizeof text, "%.900s is there already and stays", to);
    talk_message(s->talk, 0, text);
}

/* A page that is smaller both ways, mm, is hard to draw on. */
#define SMALL_PAGE_MM 20

/* Tells who did not ask for a size how to get one: icons and figures for screens come out as small as they are. */
static void hint_at_size(const settings *s, const plb_drawing *d, const char *input)
{
    static const char *const sizes[] = {"width", "height", "scale", "page-size"};
    double w = plb_drawing_width(d), h = plb_drawing_height(d);
    char value[32], text[1024];
    bool is_asked = w >= SMALL_PAGE_MM || h >= SMALL_PAGE_MM;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        is_asked = is_asked || (plb_options_get(s->o, sizes[i], value, sizeof value) && strcmp(value, "auto") != 0);
    if (is_asked)
        return;
    snprintf(text, sizeof text, "%.900s: the page is %.3g by %.3g mm, small for a pencil; --width 100mm draws it larger", input, w, h);
    talk_message(s->talk, 0, text);
}

/* Names the result after the drawing: a picture stays beside its film. */
static char *made_name(const settings *s, const char *input, bool several)
{
    static const char old[] = ".png", suffix[] = ".film.png";
    char *name = pages_name_output(input, several && !s->film), *longer = name && s->film ? realloc(name, strlen(name) + sizeof suffix) : name;
    if (longer && s->film)
        strcpy(longer + strlen(longer) - strlen(old), suffix);
    return longer;
}

static int draw(settings *s, const job *j, unsigned page)
{
    plb_error e = {PLB_OK, ""};
    char *to = result_name(s, j, page);
    if (!to)
        return talk_no_memory();
    if (is_same_file(to, j->input)) {
        free(to);
        return talk_wrong(s->talk, "the result would replace the drawing: name another file with -o");
    }
    if (s->no_clobber && strcmp(to, "-") && access(to, F_OK) == 0) {
        leave_alone(s, to);
        free(to);
        return EXIT_DRAWN;
    }
    if (page)
        plb_options_set_number(s->o, "page", page, NULL);
    plb_drawing *d = plb_file_draw(j->file, s->o, &e);
    if (d)
        hint_at_size(s, d, j->input);
    bool ok = d && write_result(s, d, to, &e);
    if (ok && s->verbose)
        tell_drawn(s, d, to);
    plb_drawing_free(d);
    free(to);
    return ok ? EXIT_DRAWN : talk_fail(s->talk, &e);
}

static int draw_range(settings *s, const job *j, page_range range, unsigned count)
{
    int status = EXIT_DRAWN;
    if (range.last == PAGES_TO_THE_END)
        range.last = count > range.first ? count : range.first; /* a first page that is not there is an error */
    for (unsigned page = range.first; status == EXIT_DRAWN && page <= range.last; page++)
        status = draw(s, j, page);
    return status;
}

/* Draws the pages that are asked for, one after the other. */
static int draw_pages(settings *s, const job *j)
{
    plb_error e = {PLB_OK, ""};
    const char *list = s->pages;
    if (s->film && j->several)
        return talk_wrong(s->talk, "a film shows one page: --page N");
    if (!list)
        return draw(s, j, 0);
    unsigned count = j->several ? plb_file_pages(j->file, s->o, &e) : 1;
    if (!count)
        return talk_fail(s->talk, &e);
    if (j->several && count > 1 && !pages_has_number(j->to) && !is_text(s) && !s->document)
        return talk_wrong(s->talk, "several pages need a %d in the name of the output: -o page-%d.png");
    int status = EXIT_DRAWN;
    page_range range;
    while (status == EXIT_DRAWN && pages_next(&list, &range))
        status = draw_range(s, j, range, count);
    return status;
}

static int work(settings *s, job *j)
{
    plb_error e = {PLB_OK, ""};
    j->file = plb_file_load(j->input, &e);
    int status = j->file ? draw_pages(s, j) : talk_fail(s->talk, &e);
    plb_file_free(j->file);
    return status;
}

/* Tells where the result goes when -o is absent: text dumps and drawings from standard input go to standard output. */
static int run(settings *s, const char *input)
{
    job j = {.input = input, .several = s->pages && !pages_is_one(s->pages)};
    bool is_named = s->output || is_text(s) || !strcmp(input, "-");
    char *made = is_named ? NULL : made_name(s, input, j.several);
    if (!is_named && !made)
        return talk_no_memory();
    j.to = s->output ? s->output : made ? made : "-";
    if (!strcmp(j.to, "-") && !is_text(s) && isatty(STDOUT_FILENO)) {
        free(made);
        return talk_wrong(s->talk, "a picture does not belong on a terminal: name a file with -o");
    }
    s->talk->started = time(NULL);
    int status = work(s, &j);
    free(made);
    return status;
}

/* Gives the part of a result's name that tells it from others. */
static char *name_to_compare(const settings *s, const char *input)
{
    char *name = s->output ? naming_of(s->output, input) : made_name(s, input, false);
    while (name && !strncmp(name, "./", 2))
        memmove(name, name + 2, strlen(name + 2) + 1);
    return name;
}

/* Tells whether two of the drawings would be given the same name, which goes into `text` as far as `size` allows. */
static bool names_collide(const settings *s, char *const inputs[], size_t n, char *text, size_t size)
{
    char **names = calloc(n, sizeof *names);
    size_t made = 0;
    while (names && made < n && (names[made] = name_to_compare(s, inputs[made])))
        made++;
    const char *twice = names ? naming_repeated(names, made) : NULL;
    if (twice)
        snprintf(text, size, "two of the drawings have the same name for their picture, %s", twice);
    while (made > 0)
        free(names[--made]);
    free(names);
    return twice != NULL;
}

/* Tells whether several pages go into one file: its format holds them, and its name has no place for what would tell files apart. */
static bool wants_document(const settings *s, int inputs)
{
    plb_format format;
    bool several = inputs > 1 || (s->pages && !pages_is_one(s->pages));
    return several && s->dump < 0 && !s->film && s->output && !naming_has_place(s->output) && !pages_has_number(s->output) &&
           plb_format_of(s->output, &format, NULL) && format.has_pages;
}

/* Refuses results in a format that the library does not write, and several drawings with one name. */
static const char *refuse_names(const settings *s, char *const inputs[], int n, char *text, size_t size)
{
    const char *format = refuse_format(s, text, size);
    if (format)
        return format;
    bool on_one_stream = is_text(s) && (!s->output || !strcmp(s->output, "-"));
    if (n < 2 || on_one_stream || wants_document(s, n))
        return NULL;
    if (s->output && !naming_has_place(s->output))
        return "more than one FILE: their pictures need a %s in the name of the output: -o 'out/%s.png'";
    for (int i = 0; i < n; i++)
        if (!strcmp(inputs[i], "-") && !s->output)
            return "standard input among several drawings needs -o with a %s";
    return names_collide(s, inputs, (size_t)n, text, size) ? text : NULL;
}

/* Draws all files; one that fails does not keep the others from being drawn. */
static int run_each(settings *s, char *const inputs[], int n)
{
    int worst = EXIT_DRAWN;
    for (int i = 0; i < n; i++) {
        s->talk->drawing = n > 1 ? inputs[i] : NULL;
        int status = run(s, inputs[i]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* Draws all pages into one file, which appears only when each of them is drawn. */
static int run_document(settings *s, char *const inputs[], int n)
{
    plb_error e = {PLB_OK, ""};
    s->document = plb_document_new(s->output, &e);
    int status = s->document ? EXIT_DRAWN : talk_fail(s->talk, &e);
    for (int i = 0; status == EXIT_DRAWN && i < n; i++)
        status = run(s, inputs[i]);
    if (status != EXIT_DRAWN)
        plb_document_free(s->document);
    else if (!plb_document_close(s->document, &e))
        status = talk_fail(s->talk, &e);
    s->document = NULL;
    return status;
}

/* Draws all drawings with one pencil. */
static int run_all(settings *s, char *const inputs[], int n)
{
    plb_error e = {PLB_OK, ""};
    char text[512];
    const char *refused = refuse_names(s, inputs, n, text, sizeof text);
    if (refused)
        return talk_wrong(s->talk, refused);
    if (s->random_seed) {
        uint64_t seed = random_seed();
        plb_options_set_seed(s->o, seed);
        fprintf(stderr, PROGRAM ": seed %llu\n", (unsigned long long)seed);
    }
    talk_note(s->talk);
    plb_options_set_message(s->o, talk_message, s->talk);
    plb_options_set_progress(s->o, !s->quiet && talk_can_show_progress() ? talk_progress : NULL, s->talk);
    if (s->pencil && !plb_options_set(s->o, "pencil", s->pencil, &e))
        return talk_fail(s->talk, &e);
    return wants_document(s, n) ? run_document(s, inputs, n) : run_each(s, inputs, n);
}

/* Names the pictures when -o is a folder. */
static int run_into(settings *s, char *const inputs[], int n)
{
    const char *suffix = is_text(s) ? ".txt" : ".png";
    char *made = s->output ? naming_in_folder(s->output, suffix, s->pages && !pages_is_one(s->pages)) : NULL;
    if (made)
        s->output = made;
    int status = run_all(s, inputs, n);
    free(made);
    return status;
}

/* Does what the command line asks for. */
static int obey(settings *s, const command_table *table, char *const inputs[], int operands)
{
    plb_error e = {PLB_OK, ""};
    int status = EXIT_DRAWN;
    if (s->help)
        print_help(table);
    else if (s->version)
        printf(PROGRAM " %s\n", plb_version());
    else if (s->completions)
        completions_print(s->completions, PROGRAM, table->rows, table->n);
    else if (s->list_pencils)
        status = list_pencils();
    else if (!plb_options_check(s->o, &e))
        return talk_wrong(s->talk, e.text);
    else if (operands == 0 && isatty(STDIN_FILENO))
        return talk_wrong(s->talk, "which drawing? usage: " PROGRAM " [options] FILE...");
    else
        return run_into(s, operands ? inputs : (char *[]){"-"}, operands ? operands : 1);
    return streams_flush(PROGRAM) ? status : EXIT_NOT_DRAWN;
}

int main(int argc, char **argv)
{
    if (!surroundings_prepare(PROGRAM))
        return EXIT_NOT_DRAWN;
    settings s = {.o = plb_options_new(), .dump = -1};
    talk t = {.command = &s};
    s.talk = &t;
    if (!s.o)
        return talk_no_memory();
    command_table table;
    command_table_init(&table);
    int operands;
    int status = command_line_parse(&s, &table, argc, argv, &operands) ? obey(&s, &table, argv, operands) : EXIT_WRONG_COMMAND;
    plb_options_free(s.o);
    return status;
}
