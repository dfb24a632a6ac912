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

enum { EXIT_DRAWN = 0, EXIT_NOT_DRAWN = 1, EXIT_WRONG_COMMAND = 2 };

typedef struct {
    plb_options o;
    const char *output, *pencil;
    const char *pages; /* as --page says: "2", "2-4", "1,5-" or "all"; NULL: the first */
    int dump; /* a plb_dump, or -1 */
    bool random_seed, quiet, list_pencils, version, help;
    int verbose;
    bool progress_shown;
    int percent; /* of progress, as shown last */
    time_t started;
} settings;

/* ---- values ---- */

static bool parse_number(const char *text, double *value)
{
    char *end;
    if (text[strspn(text, "0123456789.eE+-")] != '\0') /* no hexadecimal, no infinity */
        return false;
    *value = strtod(text, &end); /* this program never leaves the C locale */
    return end != text && *end == '\0';
}

static bool parse_seed(const char *text, uint64_t *seed)
{
    uint64_t v = 0;
    for (const char *p = text; *p; p++) {
        if (*p < '0' || *p > '9' || v > (UINT64_MAX - (uint64_t)(*p - '0')) / 10)
            return false;
        v = v * 10 + (uint64_t)(*p - '0');
    }
    *seed = v;
    return *text != '\0';
}

static bool choose(const char *text, const char *const names[], int n, int *chosen)
{
    for (int i = 0; i < n; i++)
        if (!strcmp(text, names[i])) {
            *chosen = i;
            return true;
        }
    return false;
}

/* ---- what each option does ---- */

static bool set_output(void *p, const char *v) { return ((settings *)p)->output = v, *v != '\0'; }
static bool set_pencil(void *p, const char *v) { return ((settings *)p)->pencil = v, *v != '\0'; }
static bool set_dpi(void *p, const char *v)
{
    double *dpi = &((settings *)p)->o.dpi;
    return parse_number(v, dpi) && *dpi >= 10 && *dpi <= 4800;
}
static bool set_width(void *p, const char *v)
{
    double *mm = &((settings *)p)->o.width;
    return plb_parse_length(v, mm) && *mm > 0 && *mm <= 1e5;
}
static bool set_height(void *p, const char *v)
{
    double *mm = &((settings *)p)->o.height;
    return plb_parse_length(v, mm) && *mm > 0 && *mm <= 1e5;
}
static bool set_scale(void *p, const char *v)
{
    double *f = &((settings *)p)->o.scale, to = 1;
    char from[32];
    size_t n = strcspn(v, ":");
    if (n >= sizeof from || (v[n] && !(parse_number(v + n + 1, &to) && to > 0)))
        return false;
    memcpy(from, v, n);
    from[n] = '\0';
    return parse_number(from, f) && (*f /= to) > 0 && *f <= 1e4;
}
static bool set_seed(void *p, const char *v)
{
    settings *s = p;
    s->random_seed = !strcmp(v, "random");
    return s->random_seed || parse_seed(v, &s->o.seed);
}
static bool set_squiggle(void *p, const char *v)
{
    double *mm = &((settings *)p)->o.squiggle;
    return plb_parse_length(v, mm) && *mm >= 0 && *mm <= 1000;
}
static bool set_model(void *p, const char *v)
{
    int i;
    return choose(v, (const char *const[]){"hla", "graphite"}, 2, &i) ? (((settings *)p)->o.model = (plb_model)i, true) : false;
}
static bool set_arm(void *p, const char *v)
{
    int i;
    return choose(v, (const char *const[]){"", "hand", "jerk", "spring", "lognormal", "torque"}, 6, &i) && i > 0 ? (((settings *)p)->o.arm = (plb_arm)i, true) : false;
}
static bool set_fill(void *p, const char *v)
{
    int i;
    return choose(v, (const char *const[]){"hatch", "outline", "none"}, 3, &i) ? (((settings *)p)->o.fill = (plb_fill)i, true) : false;
}
static bool set_text(void *p, const char *v)
{
    int i;
    return choose(v, (const char *const[]){"hand", "outline", "none"}, 3, &i) ? (((settings *)p)->o.text = (plb_text)i, true) : false;
}
static bool set_hand(void *p, const char *v)
{
    int i;
    return choose(v, (const char *const[]){"right", "left", "none"}, 3, &i) ? (((settings *)p)->o.handed = (plb_handed)i, true) : false;
}
static bool set_pressure(void *p, const char *v)
{
    double *f = &((settings *)p)->o.pressure;
    return parse_number(v, f) && *f >= 0.2 && *f <= 3;
}
static bool set_paper(void *p, const char *v)
{
    int i;
    return choose(v, (const char *const[]){"medium", "smooth", "rough", "none"}, 4, &i) ? (((settings *)p)->o.paper = (plb_paper)i, true) : false;
}
static bool set_overshoot(void *p, const char *v)
{
    double *mm = &((settings *)p)->o.overshoot;
    return plb_parse_length(v, mm) && *mm >= 0 && *mm <= 100;
}
static bool set_restate(void *p, const char *v)
{
    double *share = &((settings *)p)->o.restate;
    return parse_number(v, share) && *share >= 0 && *share <= 1;
}
static bool set_construction(void *p, const char *v) { return (void)v, ((settings *)p)->o.construction = true; }
static bool set_background(void *p, const char *v)
{
    int i;
    return choose(v, (const char *const[]){"white", "none"}, 2, &i) ? (((settings *)p)->o.background = (plb_background)i, true) : false;
}
static bool parse_int(const char *text, int most, int *value)
{
    uint64_t v;
    bool ok = parse_seed(text, &v) && v <= (uint64_t)most;
    *value = ok ? (int)v : *value;
    return ok;
}
static bool set_colour(void *p, const char *v) { return (void)v, ((settings *)p)->o.colour = true; }
static bool set_threads(void *p, const char *v) { return parse_int(v, 64, &((settings *)p)->o.threads) && *v != '0'; }
static bool set_compress(void *p, const char *v) { return parse_int(v, 9, &((settings *)p)->o.compress); }
static bool set_page(void *p, const char *v)
{
    const char *list = v;
    page_range range;
    ((settings *)p)->pages = v;
    while (pages_next(&list, &range)) {}
    return *v && !*list;
}
static bool set_limit_time(void *p, const char *v)
{
    double *s = &((settings *)p)->o.limit_time;
    return parse_number(v, s) && *s >= 1 && *s <= 1e6;
}
static bool set_limit_memory(void *p, const char *v)
{
    double *mib = &((settings *)p)->o.limit_memory;
    return parse_number(v, mib) && *mib >= 64 && *mib <= 1e6;
}
static bool set_dump(void *p, const char *v)
{
    return choose(v, (const char *const[]){"list", "strokes", "controls"}, 3, &((settings *)p)->dump);
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

static const option table[] = {
    {0, NULL, NULL, "Input", NULL},
    {0, "page", "N|N-M|all", "which pages of a PDF or PostScript file, also a list [1]", set_page},
    {0, "limit-time", "SECONDS", "processor time of the programs that read a drawing for us [8]", set_limit_time},
    {0, "limit-memory", "MIB", "memory of each program that reads for us [1024]", set_limit_memory},
    {0, NULL, NULL, "Output", NULL},
    {'o', "output", "FILE", "PNG or .pdf, '-': standard output; %s: drawing, %d: page [FILE.png]", set_output},
    {'d', "dpi", "DPI", "resolution, 10 to 4800 pixels per inch [300]", set_dpi},
    {0, "background", "white|none", "paper, or nothing behind the graphite [white]", set_background},
    {0, "compress", "0..9", "0: large at once, 9: small and slow [1]", set_compress},
    {0, NULL, NULL, "Size on paper (LEN: a number or fraction with mm cm in pt px)", NULL},
    {0, "width", "LEN", "width of the page [the drawing's own]", set_width},
    {0, "height", "LEN", "height of the page [the drawing's own]", set_height},
    {0, "scale", "F", "times its own size, as 0.5 or 1:2 [1; DXF: fits A3]", set_scale},
    {0, NULL, NULL, "Pencil", NULL},
    {'p', "pencil", "GRADE|FILE", "2H H F HB B 3B 6B 8B or a .pencil file [HB]", set_pencil},
    {0, "list-pencils", NULL, "show the pencils that are built in", set_list_pencils},
    {0, "pressure", "F", "0.2 to 3 times the usual: paler and grainier, or darker [1]", set_pressure},
    {0, "paper", "smooth|medium|rough|none", "the tooth of the paper, which all strokes share [medium]", set_paper},
    {0, NULL, NULL, "Hand", NULL},
    {'s', "seed", "SEED", "a number, or 'random': another hand for the same drawing [1]", set_seed},
    {0, "squiggle", "LEN", "how far lines stray; 0: ruler-straight [5/300in: as measured]", set_squiggle},
    {0, "model", "graphite|hla", "how lines are made: as measured, or the papers' algorithm [graphite]", set_model},
    {0, "arm", "hand|jerk|spring|lognormal|torque", "how the arm moves [hand; with --model hla: jerk]", set_arm},
    {0, "hand", "right|left|none", "which hand draws; none: all directions alike [right]", set_hand},
    {0, "overshoot", "LEN", "lines run past corners by up to LEN [0]", set_overshoot},
    {0, "restate", "F", "share of the long lines that are drawn twice, 0 to 1 [0]", set_restate},
    {0, "construction", NULL, "faint construction lines beyond long lines, axes of circles", set_construction},
    {0, NULL, NULL, "What is drawn", NULL},
    {0, "fill", "hatch|outline|none", "what becomes of filled shapes [hatch]", set_fill},
    {0, "text", "hand|outline|none", "what becomes of lettering [hand]", set_text},
    {0, "colour", NULL, "each line with a pencil of its own colour [all graphite]", set_colour},
    {0, NULL, NULL, "Work", NULL},
    {0, "threads", "N", "at most N threads, 1 to 64 [as many as processors]", set_threads},
    {0, NULL, NULL, "Diagnosis", NULL},
    {0, "dump", "list|strokes|controls", "show what a stage made instead of drawing", set_dump},
    {'q', "quiet", NULL, "no warnings, no progress", set_quiet},
    {'v', "verbose", NULL, "say what is done", set_verbose},
    {0, "version", NULL, "show the version", set_version},
    {0, "help", NULL, "show this help", set_help},
};
#define TABLE_ROWS (sizeof table / sizeof *table)

static void print_help(void)
{
    printf("usage: " PROGRAM " [options] [FILE...]\n"
           "\n"
           "Draws FILE, a vector drawing (SVG, PDF, PostScript, EPS or DXF), as a person with a pencil would.\n"
           "\n"
           "  " PROGRAM " plan.svg                          plan.png appears beside it\n"
           "  " PROGRAM " -p 6B plan.ps -o - | display      in a pipe, with a soft pencil\n");
    options_print(table, TABLE_ROWS);
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
static void on_progress(void *closure, double done)
{
    settings *s = closure;
    double passed = difftime(time(NULL), s->started);
    if (done >= 1 || passed < 2) {
        clear_progress(s);
        return;
    }
    if (s->progress_shown && (int)(done * 100) == s->percent)
        return;
    s->percent = (int)(done * 100);
    fprintf(stderr, "\r" PROGRAM ": %3d %%", s->percent);
    if (done > 0.01)
        fprintf(stderr, ", %.0f s left\033[K", passed * (1 - done) / done);
    s->progress_shown = true;
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

static bool ends_with(const char *name, const char *suffix)
{
    size_t n = strlen(name), m = strlen(suffix);
    return n > m && !strcasecmp(name + n - m, suffix);
}

/* A name that promises another format than we write. */
static const char *refuse_format(const settings *s)
{
    static const char *const foreign[] = {".jpg", ".jpeg", ".gif", ".bmp", ".webp", ".tif", ".tiff", ".svg", ".svgz", ".eps", ".ps", ".dxf"};
    for (size_t i = 0; s->output && s->dump < 0 && i < sizeof foreign / sizeof *foreign; i++)
        if (ends_with(s->output, foreign[i]))
            return "the result is PNG or PDF: end the name given to -o in .png or .pdf";
    return NULL;
}

/* The suffix says what is written. */
static bool write_result(const settings *s, const plb_drawing *d, const char *to, plb_error *e)
{
    if (s->dump >= 0)
        return plb_drawing_dump(d, (plb_dump)s->dump, to, &s->o, e);
    return (ends_with(to, ".pdf") ? plb_drawing_write_pdf : plb_drawing_write_png)(d, to, &s->o, e);
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

static bool is_text(const settings *s) { return s->dump == PLB_DUMP_LIST || s->dump == PLB_DUMP_STROKES; }

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
    char text[1024];
    snprintf(text, sizeof text, "%zu strokes on %.1f x %.1f mm with %s, seed %llu: %s", plb_drawing_strokes(d), plb_drawing_width(d),
             plb_drawing_height(d), plb_profile_name(s->o.profile), (unsigned long long)s->o.seed, to);
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
    s->o.page = page;
    plb_drawing *d = plb_file_draw(j->file, &s->o, &e);
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
    unsigned count = j->several ? plb_file_pages(j->file, &s->o, &e) : 1;
    if (!count)
        return fail(s, &e);
    if (j->several && count > 1 && !pages_has_number(j->to) && !is_text(s))
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

/* The result has a format that we write, and of several drawings each needs a name of its own. */
static const char *refuse_names(const settings *s, char *const inputs[], int n, char *text, size_t room)
{
    const char *format = refuse_format(s);
    if (format)
        return format;
    bool on_one_stream = is_text(s) && (!s->output || !strcmp(s->output, "-"));
    if (n < 2 || on_one_stream)
        return NULL;
    if (s->output && !naming_has_place(s->output))
        return "more than one FILE: their pictures need a %s in the name of the output: -o 'out/%s.png'";
    for (int i = 0; i < n; i++)
        if (!strcmp(inputs[i], "-") && !s->output)
            return "standard input among several drawings needs -o with a %s";
    return names_collide(s, inputs, (size_t)n, text, room) ? text : NULL;
}

/* All drawings with one pencil; one that fails does not keep the others from being drawn. */
static int run_all(settings *s, char *const inputs[], int n)
{
    plb_error e = {PLB_OK, ""};
    char text[512];
    const char *refused = refuse_names(s, inputs, n, text, sizeof text);
    if (refused)
        return wrong(refused);
    if (s->random_seed) {
        s->o.seed = random_seed();
        fprintf(stderr, PROGRAM ": seed %llu\n", (unsigned long long)s->o.seed);
    }
    s->o.message = on_message;
    s->o.progress = !s->quiet && isatty(STDERR_FILENO) ? on_progress : NULL;
    s->o.closure = s;
    plb_profile *pencil = plb_profile_load(s->pencil, &e);
    s->o.profile = pencil;
    int worst = pencil ? EXIT_DRAWN : fail(s, &e);
    for (int i = 0; pencil && i < n; i++) {
        int status = run(s, inputs[i]);
        worst = status > worst ? status : worst;
    }
    plb_profile_free(pencil);
    return worst;
}

int main(int argc, char **argv)
{
    if (!surroundings_prepare(PROGRAM))
        return EXIT_NOT_DRAWN;
    settings s = {.o = plb_options_default(), .pencil = "HB", .dump = -1};
    int operands;
    if (!options_parse(PROGRAM, table, TABLE_ROWS, argc, argv, &s, &operands))
        return EXIT_WRONG_COMMAND;
    int status = EXIT_DRAWN;
    if (s.help)
        print_help();
    else if (s.version)
        printf(PROGRAM " %s\n", plb_version());
    else if (s.list_pencils)
        status = list_pencils();
    else if (s.o.scale > 0 && (s.o.width > 0 || s.o.height > 0))
        return wrong("--scale goes neither with --width nor with --height");
    else
        return run_all(&s, operands ? argv : (char *[]){"-"}, operands ? operands : 1);
    return streams_flush(PROGRAM) ? status : EXIT_NOT_DRAWN;
}
