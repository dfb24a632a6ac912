/* SPDX-License-Identifier: MIT
 *
 * plumbago: draws a vector drawing with a pencil. plumbago(1) is the manual.
 */
#include "api/plumbago.h"
#include "tool/naming.h"
#include "tool/options.h"
#include "tool/pages.h"
#include "tool/streams.h"
#include "tool/surroundings.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define PROGRAM "plumbago"

#define MAX_OPTIONS 64 /* with headings */

enum { EXIT_DRAWN = 0, EXIT_NOT_DRAWN = 1, EXIT_WRONG_COMMAND = 2 };

typedef struct {
    plb_options *o;
    const char *output, *pencil;
    plb_document *document; /* all pages in one file; NULL: a file each */
    const char *pages; /* as --page says: "2", "2-4", "1,5-" or "all"; NULL: the first */
    int dump; /* a plb_dump, or -1 */
    bool random_seed, quiet, list_pencils, version, help;
    int verbose;
    bool progress_shown;
    int percent; /* of progress, as shown last */
    time_t started;
} settings;

/* ---- what is no setting of the library, or more than one ---- */

static bool set_output(void *p, const char *v) { return ((settings *)p)->output = v, *v != '\0'; }
static bool set_pencil(void *p, const char *v) { return ((settings *)p)->pencil = v, *v != '\0'; }
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
static bool set_list_pencils(void *p, const char *v) { return (void)v, ((settings *)p)->list_pencils = true; }
static bool set_quiet(void *p, const char *v)
{
    settings *s = p; /* of -q and -v the last one holds */
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

/* The program's own options: each is listed after the setting or option that it names, and one with the name of a setting stands
 * in its place. */
static const struct {
    const char *after, *group;
    option o;
} own[] = {
    {NULL, "Input", {0, "page", "N|N-M|all", "which pages of a PDF or PostScript file, also a list [1]", set_page}},
    {"dpi", "Output", {'o', "output", "FILE", ".png .pdf .svg .jpg .webp .tif; %s: drawing, %d: page [FILE.png]", set_output}},
    {NULL, "Pencil", {'p', "pencil", "GRADE|FILE", "2H H F HB B 3B 6B 8B or a .pencil file [HB]", set_pencil}},
    {"pencil", "Pencil", {0, "list-pencils", NULL, "show the pencils that are built in", set_list_pencils}},
    {NULL, "Diagnosis", {0, "dump", "list|strokes|controls", "show what a stage made instead of drawing", set_dump}},
    {NULL, "Diagnosis", {'q', "quiet", NULL, "no warnings, no progress", set_quiet}},
    {NULL, "Diagnosis", {'v', "verbose", NULL, "say what is done", set_verbose}},
    {NULL, "Diagnosis", {0, "version", NULL, "show the version", set_version}},
    {NULL, "Diagnosis", {0, "help", NULL, "show this help", set_help}},
};
#define OWN_ROWS (sizeof own / sizeof *own)

/* A setting of the library. Its errors begin with its name. */
static bool store_setting(void *p, const option *o, const char *v, char why[OPTION_WHY_SIZE])
{
    settings *s = p;
    plb_error e = {PLB_OK, ""};
    if (!strcmp(o->name, "seed") && !strcmp(v, "random"))
        return s->random_seed = true;
    s->random_seed = s->random_seed && strcmp(o->name, "seed") != 0;
    if (plb_options_set(s->o, o->name, v ? v : "on", &e))
        return true;
    snprintf(why, OPTION_WHY_SIZE, "%s", e.text);
    return false;
}

/* Headings, settings and own options in the order of --help. */
static size_t make_table(option *to)
{
    option *next = to;
    const plb_setting *s;
    const char *group = "";
    for (size_t i = 0; (s = plb_setting_at(i)); i++) {
        if (strcmp(group, s->group) != 0)
            *next++ = (option){.help = group = s->group};
        const option *instead = NULL;
        for (size_t k = 0; k < OWN_ROWS; k++)
            if (!strcmp(own[k].o.name, s->name))
                instead = &own[k].o;
        *next++ = instead ? *instead : (option){s->letter, s->name, s->argument, s->help, NULL};
        for (size_t k = 0; k < OWN_ROWS; k++)
            if (own[k].after && !strcmp(own[k].after, s->name))
                *next++ = own[k].o;
    }
    *next++ = (option){.help = "Diagnosis"};
    for (size_t k = 0; k < OWN_ROWS; k++)
        if (!strcmp(own[k].group, "Diagnosis"))
            *next++ = own[k].o;
    return (size_t)(next - to);
}

static void print_help(const option *table, size_t n)
{
    printf("usage: " PROGRAM " [options] [FILE...]\n"
           "\n"
           "Draws FILE, a vector drawing (SVG, PDF, PostScript, EPS or DXF), as a person with a pencil would.\n"
           "\n"
           "  " PROGRAM " plan.svg                          plan.png appears beside it\n"
           "  " PROGRAM " -p 6B plan.ps -o - | display      in a pipe, with a soft pencil\n");
    options_print(table, n);
    printf("\nExit status: 0 drawn, 1 the drawing could not be made, 2 wrong command line.\n");
}

/* ---- talking ---- */

static void clear_progress(settings *s)
{
    if (s->progress_shown)
        fputs("\r\033[K", stderr);
    s->progress_shown = false;
}

static void print_line(const char *kind, const char *text) { streams_say(PROGRAM, kind, text); }

static void on_message(void *closure, int level, const char *text)
{
    settings *s = closure;
    if (level == 0 ? s->quiet : s->verbose == 0)
        return;
    clear_progress(s);
    print_line(level == 0 ? "warning: " : "", text);
}

/* On a terminal, from the second second on, at most once for each percent. */
static bool on_progress(void *closure, double done)
{
    settings *s = closure;
    double passed = difftime(time(NULL), s->started);
    if (done >= 1 || passed < 2) {
        clear_progress(s);
        return true;
    }
    if (s->progress_shown && (int)(done * 100) == s->percent)
        return true;
    s->percent = (int)(done * 100);
    fprintf(stderr, "\r" PROGRAM ": %3d %%", s->percent);
    if (done > 0.01)
        fprintf(stderr, ", %.0f s left\033[K", passed * (1 - done) / done);
    s->progress_shown = true;
    return true;
}

static int fail(settings *s, const plb_error *e)
{
    clear_progress(s);
    print_line("", e->text);
    return EXIT_NOT_DRAWN;
}

static int wrong(const char *what)
{
    char line[640];
    snprintf(line, sizeof line, "%s; try '" PROGRAM " --help'", what);
    print_line("", line);
    return EXIT_WRONG_COMMAND;
}

static int no_memory(void)
{
    print_line("", "out of memory");
    return EXIT_NOT_DRAWN;
}

/* ---- work ---- */

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

/* The suffix says what is written; a name that promises another format than we write is refused. */
static const char *refuse_format(const settings *s, char *text, size_t room)
{
    plb_error e = {PLB_OK, ""};
    plb_format format;
    if (!s->output || is_text(s) || plb_format_of(s->output, &format, &e))
        return NULL;
    snprintf(text, room, "%s", e.text);
    return text;
}

static bool write_result(const settings *s, const plb_drawing *d, const char *to, plb_error *e)
{
    if (s->dump >= 0)
        return plb_drawing_dump(d, (plb_dump)s->dump, to, s->o, e);
    return s->document ? plb_document_add(s->document, d, s->o, e) : plb_drawing_write(d, to, s->o, e);
}

static bool look_at(const char *name, int stream, struct stat *st)
{
    return (strcmp(name, "-") ? stat(name, st) : fstat(stream, st)) == 0 && S_ISREG(st->st_mode);
}

/* By whatever names; also when the shell has opened one of them. */
static bool is_same_file(const char *to, const char *from)
{
    struct stat x, y;
    return look_at(to, STDOUT_FILENO, &x) && look_at(from, STDIN_FILENO, &y) && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

/* What the work of one call needs. */
typedef struct {
    const char *input;
    const char *to; /* where the result goes, perhaps with a %d in it */
    plb_file *file;
    bool several;   /* pages may be drawn */
} job;

/* The page's number and then the drawing's name in their places: a name that looks like a place is none. */
static char *result_name(const settings *s, const job *j, unsigned page)
{
    char *numbered = s->output || j->several ? pages_name(j->to, page ? page : 1) : strdup(j->to);
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
    print_line("", text);
}

static int draw(settings *s, const job *j, unsigned page)
{
    plb_error e = {PLB_OK, ""};
    char *to = result_name(s, j, page);
    if (!to)
        return no_memory();
    if (is_same_file(to, j->input)) {
        free(to);
        return wrong("the result would replace the drawing: name another file with -o");
    }
    if (page)
        plb_options_set_number(s->o, "page", page, NULL);
    plb_drawing *d = plb_file_draw(j->file, s->o, &e);
    bool ok = d && write_result(s, d, to, &e);
    if (ok && s->verbose)
        tell_drawn(s, d, to);
    plb_drawing_free(d);
    free(to);
    return ok ? EXIT_DRAWN : fail(s, &e);
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

/* The pages that are asked for, one after the other. */
static int draw_pages(settings *s, const job *j)
{
    plb_error e = {PLB_OK, ""};
    const char *list = s->pages;
    if (!list)
        return draw(s, j, 0);
    unsigned count = j->several ? plb_file_pages(j->file, s->o, &e) : 1;
    if (!count)
        return fail(s, &e);
    if (j->several && count > 1 && !pages_has_number(j->to) && !is_text(s) && !s->document)
        return wrong("several pages need a %d in the name of the output: -o page-%d.png");
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
    int status = j->file ? draw_pages(s, j) : fail(s, &e);
    plb_file_free(j->file);
    return status;
}

/* Where the result goes when -o is absent: text dumps and what came by standard input to standard output. */
static int run(settings *s, const char *input)
{
    job j = {.input = input, .several = s->pages && !pages_is_one(s->pages)};
    bool is_named = s->output || is_text(s) || !strcmp(input, "-");
    char *made = is_named ? NULL : pages_name_output(input, j.several);
    if (!is_named && !made)
        return no_memory();
    j.to = s->output ? s->output : made ? made : "-";
    if (!strcmp(j.to, "-") && !is_text(s) && isatty(STDOUT_FILENO)) {
        free(made);
        return wrong("a picture does not belong on a terminal: name a file with -o");
    }
    s->started = time(NULL);
    int status = work(s, &j);
    free(made);
    return status;
}

/* A result's name without what does not tell it from others. */
static char *name_to_compare(const settings *s, const char *input)
{
    char *name = s->output ? naming_of(s->output, input) : pages_name_output(input, false);
    while (name && !strncmp(name, "./", 2))
        memmove(name, name + 2, strlen(name + 2) + 1);
    return name;
}

/* Whether two of the drawings would be given the same name; it is put into `text`, as far as there is room. */
static bool names_collide(const settings *s, char *const inputs[], size_t n, char *text, size_t room)
{
    char **names = calloc(n, sizeof *names);
    size_t made = 0;
    while (names && made < n && (names[made] = name_to_compare(s, inputs[made])))
        made++;
    const char *twice = names ? naming_repeated(names, made) : NULL;
    if (twice)
        snprintf(text, room, "two of the drawings have the same name for their picture, %s", twice);
    while (made > 0)
        free(names[--made]);
    free(names);
    return twice != NULL;
}

/* Whether several pages go into one file: its format holds them, and its name has no place for what would tell files apart. */
static bool wants_document(const settings *s, int inputs)
{
    plb_format format;
    bool several = inputs > 1 || (s->pages && !pages_is_one(s->pages));
    return several && s->dump < 0 && s->output && !naming_has_place(s->output) && !pages_has_number(s->output) &&
           plb_format_of(s->output, &format, NULL) && format.has_pages;
}

/* The result has a format that we write, and of several drawings each needs a name of its own. */
static const char *refuse_names(const settings *s, char *const inputs[], int n, char *text, size_t room)
{
    const char *format = refuse_format(s, text, room);
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
    return names_collide(s, inputs, (size_t)n, text, room) ? text : NULL;
}

/* One that fails does not keep the others from being drawn. */
static int run_each(settings *s, char *const inputs[], int n)
{
    int worst = EXIT_DRAWN;
    for (int i = 0; i < n; i++) {
        int status = run(s, inputs[i]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* All pages in one file, which appears only when each of them is drawn. */
static int run_document(settings *s, char *const inputs[], int n)
{
    plb_error e = {PLB_OK, ""};
    s->document = plb_document_new(s->output, &e);
    int status = s->document ? EXIT_DRAWN : fail(s, &e);
    for (int i = 0; status == EXIT_DRAWN && i < n; i++)
        status = run(s, inputs[i]);
    if (status != EXIT_DRAWN)
        plb_document_free(s->document);
    else if (!plb_document_close(s->document, &e))
        status = fail(s, &e);
    s->document = NULL;
    return status;
}

/* All drawings with one pencil. */
static int run_all(settings *s, char *const inputs[], int n)
{
    plb_error e = {PLB_OK, ""};
    char text[512];
    const char *refused = refuse_names(s, inputs, n, text, sizeof text);
    if (refused)
        return wrong(refused);
    if (s->random_seed) {
        uint64_t seed = random_seed();
        plb_options_set_seed(s->o, seed);
        fprintf(stderr, PROGRAM ": seed %llu\n", (unsigned long long)seed);
    }
    plb_options_set_message(s->o, on_message, s);
    plb_options_set_progress(s->o, !s->quiet && isatty(STDERR_FILENO) ? on_progress : NULL, s);
    if (s->pencil && !plb_options_set(s->o, "pencil", s->pencil, &e))
        return fail(s, &e);
    return wants_document(s, n) ? run_document(s, inputs, n) : run_each(s, inputs, n);
}

/* What the command line asks for. */
static int obey(settings *s, const option *table, size_t n, char *const inputs[], int operands)
{
    char width[32], height[32], scale[32];
    int status = EXIT_DRAWN;
    plb_options_get(s->o, "width", width, sizeof width);
    plb_options_get(s->o, "height", height, sizeof height);
    plb_options_get(s->o, "scale", scale, sizeof scale);
    if (s->help)
        print_help(table, n);
    else if (s->version)
        printf(PROGRAM " %s\n", plb_version());
    else if (s->list_pencils)
        status = list_pencils();
    else if (strcmp(scale, "auto") && (strcmp(width, "auto") || strcmp(height, "auto")))
        return wrong("--scale goes neither with --width nor with --height");
    else
        return run_all(s, operands ? inputs : (char *[]){"-"}, operands ? operands : 1);
    return streams_flush(PROGRAM) ? status : EXIT_NOT_DRAWN;
}

int main(int argc, char **argv)
{
    if (!surroundings_prepare(PROGRAM))
        return EXIT_NOT_DRAWN;
    settings s = {.o = plb_options_new(), .dump = -1};
    if (!s.o)
        return no_memory();
    option table[MAX_OPTIONS];
    int operands;
    const option_parser parser = {PROGRAM, table, make_table(table), store_setting};
    int status = options_parse(&parser, argc, argv, &s, &operands) ? obey(&s, table, parser.n, argv, operands) : EXIT_WRONG_COMMAND;
    plb_options_free(s.o);
    return status;
}
