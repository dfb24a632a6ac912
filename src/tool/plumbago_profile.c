/* SPDX-License-Identifier: MIT
 *
 * plumbago-profile: captures, shows and compares pencils. plumbago-profile(1) is the manual.
 */
#include "api/plumbago.h"
#include "tool/options/options.h"
#include "tool/options/streams.h"
#include "tool/options/surroundings.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "plumbago-profile"
#define MAX_PROVENANCE 65536

enum { EXIT_DONE = 0, EXIT_NOT_DONE = 1, EXIT_WRONG_COMMAND = 2 };

/* These bits say which commands an option belongs to. */
enum { FOR_CAPTURE = 1, FOR_SHOW = 2 };

typedef struct {
    plb_capture_options capture;
    const char *output, *plot, *grain;
    int used; /* FOR_… of the options given */
    bool verbose, version, help;
} settings;

/* ---- values ---- */

static bool parse_number(const char *text, const char **end, double *value)
{
    char *stop;
    *value = strtod(text, &stop); /* this program never leaves the C locale */
    *end = stop;
    return stop != text && *value == *value;
}

static bool parse_grey(const char *text, const char **end, int *grey)
{
    *grey = 0;
    for (*end = text; **end >= '0' && **end <= '9' && *grey <= 255; (*end)++)
        *grey = *grey * 10 + (**end - '0');
    return *end != text && *grey <= 255;
}

/* ---- what each option does ---- */

static bool set_output(void *p, const char *v)
{
    settings *s = p;
    s->used |= FOR_CAPTURE;
    s->output = v;
    return *v != '\0';
}
static bool set_name(void *p, const char *v)
{
    settings *s = p;
    s->used |= FOR_CAPTURE;
    s->capture.name = v;
    return *v != '\0' && strlen(v) < 32;
}
static bool set_dpi(void *p, const char *v)
{
    settings *s = p;
    const char *end;
    s->used |= FOR_CAPTURE;
    return parse_number(v, &end, &s->capture.dpi) && !*end && s->capture.dpi >= 10 && s->capture.dpi <= 10000;
}
static bool set_centre(void *p, const char *v)
{
    settings *s = p;
    const char *end;
    s->used |= FOR_CAPTURE;
    return parse_grey(v, &end, &s->capture.centre_min) && *end == '-' && parse_grey(end + 1, &end, &s->capture.centre_max) && !*end &&
           s->capture.centre_min <= s->capture.centre_max;
}
static bool set_width(void *p, const char *v)
{
    settings *s = p;
    const char *end;
    s->used |= FOR_CAPTURE;
    return parse_number(v, &end, &s->capture.width) && (!*end || !strcmp(end, "mm")) && s->capture.width > 0; /* how much, the library says */
}
static bool set_grain(void *p, const char *v)
{
    settings *s = p;
    s->used |= FOR_CAPTURE;
    s->grain = v;
    return *v != '\0';
}
static bool set_as_measured(void *p, const char *v)
{
    settings *s = p;
    (void)v;
    s->used |= FOR_CAPTURE;
    return s->capture.as_measured = true;
}
static bool set_free_hand(void *p, const char *v)
{
    settings *s = p;
    (void)v;
    s->used |= FOR_CAPTURE;
    return s->capture.free_hand = true;
}
static bool set_provenance(void *p, const char *v)
{
    settings *s = p;
    s->used |= FOR_CAPTURE;
    s->capture.provenance = v;
    return true;
}
static bool set_plot(void *p, const char *v)
{
    settings *s = p;
    s->used |= FOR_SHOW;
    s->plot = v;
    return *v != '\0';
}
static bool set_verbose(void *p, const char *v)
{
    (void)v;
    return ((settings *)p)->verbose = true;
}
static bool set_version(void *p, const char *v)
{
    (void)v;
    return ((settings *)p)->version = true;
}
static bool set_help(void *p, const char *v)
{
    (void)v;
    return ((settings *)p)->help = true;
}

static const option table[] = {
    {.help = "For capture"},
    {.letter = 'o', .name = "output", .argument = "FILE", .help = "write the profile to FILE", .set = set_output},
    {.name = "name", .argument = "NAME", .help = "name of the pencil, up to 31 bytes [pencil]", .set = set_name},
    {.name = "dpi", .argument = "DPI", .help = "resolution of the scans [as the PNG says, else 300]", .set = set_dpi},
    {.name = "centre", .argument = "MIN-MAX", .help = "only lines whose median grey at the centre is within [0-255]", .set = set_centre},
    {.name = "width", .argument = "MM", .help = "stretch the line to this width at half depth [as measured]", .set = set_width},
    {.name = "grain", .argument = "PENCIL", .help = "borrow some grain of PENCIL, where the lines show none", .set = set_grain},
    {.name = "as-measured", .help = "keep the grain without the correction by lines drawn with it", .set = set_as_measured},
    {.name = "free-hand", .help = "lines stray as a free hand does, not as those of the scans", .set = set_free_hand},
    {.name = "provenance", .argument = "TEXT|@FILE", .help = "text to keep in the profile: scans, hand, licence", .set = set_provenance},
    {.help = "For show"},
    {.name = "plot", .argument = "FILE", .help = "draw histograms, section and co-occurrence as a PNG too", .set = set_plot},
    {.help = "Diagnosis"},
    {.letter = 'v', .name = "verbose", .help = "say what was found in each scan", .set = set_verbose},
    {.letter = 'V', .name = "version", .help = "show the version", .set = set_version},
    {.letter = 'h', .name = "help", .help = "show this help", .set = set_help},
};
#define TABLE_ROWS (sizeof table / sizeof *table)

static void print_help(void)
{
    printf("usage: " PROGRAM " capture [options] SCAN.png... -o FILE.pencil\n"
           "       " PROGRAM " show [--plot FILE.png] PENCIL\n"
           "       " PROGRAM " compare PENCIL PENCIL\n"
           "\n"
           "Measures a pencil from scans of its lines, shows a profile, or tells how two\n"
           "differ.\n"
           "PENCIL is 2H H F HB B 3B 6B 8B or a .pencil file.\n");
    options_print(table, TABLE_ROWS);
    printf("\nExit status: 0 done, 1 it could not be done, 2 wrong command line.\n");
}

/* ---- talking ---- */

static void on_message(void *closure, int level, const char *text)
{
    const settings *s = closure;
    if (level == 0 || s->verbose)
        streams_say(PROGRAM, level == 0 ? "warning: " : "", text);
}

static int fail(const plb_error *e)
{
    streams_say(PROGRAM, "", e->text);
    return EXIT_NOT_DONE;
}

static int wrong(const char *what)
{
    fprintf(stderr, PROGRAM ": %s; try '" PROGRAM " --help'\n", what);
    return EXIT_WRONG_COMMAND;
}

/* ---- the commands ---- */

/* Reads the text of a provenance file, owned by the caller; NULL after one line on stderr. */
static char *read_text(const char *file)
{
    FILE *from = fopen(file, "rb");
    char *text = from ? calloc(MAX_PROVENANCE + 2, 1) : NULL;
    size_t n = text ? fread(text, 1, MAX_PROVENANCE + 1, from) : 0;
    bool good = text && !ferror(from) && n <= MAX_PROVENANCE && !memchr(text, '\0', n);
    if (!good) {
        char why[512];
        snprintf(why, sizeof why, "%.400s: %s", file, n > 0 ? "not a text of at most 65536 bytes" : strerror(errno));
        streams_say(PROGRAM, "", why);
    }
    if (from)
        fclose(from);
    if (good)
        return text;
    free(text);
    return NULL;
}

static int capture_to_file(const settings *s, char **scans, int n)
{
    plb_error e = {PLB_OK, ""};
    plb_capture_options options = s->capture;
    plb_profile *grain = s->grain ? plb_profile_load(s->grain, &e) : NULL;
    options.grain = grain;
    plb_profile *p = s->grain && !grain ? NULL : plb_profile_capture((const char *const *)scans, (size_t)n, &options, &e);
    bool good = p && plb_profile_save(p, s->output, &e);
    plb_profile_free(p);
    plb_profile_free(grain);
    return good ? EXIT_DONE : fail(&e);
}

static int capture(settings *s, char **scans, int n)
{
    if (!s->output)
        return wrong("capture needs -o FILE");
    const char *given = s->capture.provenance;
    if (!given || given[0] != '@')
        return capture_to_file(s, scans, n);
    char *text = read_text(given + 1);
    if (!text)
        return EXIT_NOT_DONE;
    s->capture.provenance = text;
    int status = capture_to_file(s, scans, n);
    free(text);
    return status;
}

static int show(settings *s, char **names, int n)
{
    (void)n;
    plb_error e = {PLB_OK, ""};
    plb_profile *p = plb_profile_load(names[0], &e);
    bool good = p && (!s->plot || plb_profile_plot(p, s->plot, &e)) && plb_profile_show(p, stdout, &e);
    plb_profile_free(p);
    return good ? EXIT_DONE : fail(&e);
}

static int compare(settings *s, char **names, int n)
{
    (void)s;
    (void)n;
    plb_error e = {PLB_OK, ""};
    plb_profile *a = plb_profile_load(names[0], &e), *b = a ? plb_profile_load(names[1], &e) : NULL;
    bool good = b && plb_profile_compare(a, b, stdout, &e);
    plb_profile_free(a);
    plb_profile_free(b);
    return good ? EXIT_DONE : fail(&e);
}

static const struct {
    const char *name;
    int least, most; /* operands after the name */
    int options;     /* FOR_… */
    int (*run)(settings *, char **, int);
    const char *wanted;
} commands[] = {
    {"capture", 1, 1 << 20, FOR_CAPTURE, capture, "capture needs at least one SCAN.png"},
    {"show", 1, 1, FOR_SHOW, show, "show needs one PENCIL"},
    {"compare", 2, 2, 0, compare, "compare needs two PENCILs"},
};

static int run_command(settings *s, char **operands, int n)
{
    if (n == 0)
        return wrong("which command: capture, show or compare?");
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        if (strcmp(operands[0], commands[i].name) != 0)
            continue;
        if (n - 1 < commands[i].least || n - 1 > commands[i].most)
            return wrong(commands[i].wanted);
        if (s->used & ~commands[i].options)
            return wrong(commands[i].options == FOR_SHOW ? "show takes only --plot" : commands[i].options ? "--plot is for show" : "compare takes neither --plot nor options for capture");
        return commands[i].run(s, operands + 1, n - 1);
    }
    return wrong("there is no such command: capture, show or compare");
}

int main(int argc, char **argv)
{
    if (!surroundings_prepare(PROGRAM))
        return EXIT_NOT_DONE;
    settings s = {.capture = plb_capture_options_default()};
    int operands, status = EXIT_DONE;
    const option_parser parser = {PROGRAM, table, TABLE_ROWS, NULL};
    if (!options_parse(&parser, argc, argv, &s, &operands))
        return EXIT_WRONG_COMMAND;
    s.capture.message = on_message;
    s.capture.closure = &s;
    if (s.help)
        print_help();
    else if (s.version)
        printf(PROGRAM " %s\n", plb_version());
    else
        status = run_command(&s, argv, operands);
    return status != EXIT_DONE || streams_flush(PROGRAM) ? status : EXIT_NOT_DONE;
}
