/* SPDX-License-Identifier: MIT
 *
 * libplumbago: vector line drawings drawn with a pencil. plumbago(3) is the manual.
 *
 * Lengths are millimetres on paper unless a name says otherwise. The library has no global state, prints nothing and
 * never exits; it may be called from several threads at once, each with its own objects (a plb_profile may be
 * shared: it never changes). The same input, options and seed give the same result, byte for byte.
 */
#ifndef PLUMBAGO_H
#define PLUMBAGO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cairo.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PLB_API __attribute__((visibility("default")))

/* ---- errors ---------------------------------------------------------------------------------------------- */

typedef enum {
    PLB_OK,
    PLB_ERROR_FILE,        /* a file cannot be opened, read or written */
    PLB_ERROR_SYNTAX,      /* the input is not what its format says */
    PLB_ERROR_UNSUPPORTED, /* valid input that needs something the library does not do */
    PLB_ERROR_LIMIT,       /* a bound on time, memory, size or depth was reached */
    PLB_ERROR_MEMORY,      /* an allocation failed */
    PLB_ERROR_ARGUMENT,    /* the call asks for something impossible */
    PLB_ERROR_HELPER       /* a helper program is missing or died */
} plb_status;

/* Why a call failed: one line without a newline, "FILE:LINE: what is wrong" where a file is to blame. A call that succeeds
 * leaves PLB_OK and an empty text. */
typedef struct {
    plb_status status;
    char text[512];
} plb_error;

/* Called for warnings (level 0) and details (level 1) while a call runs; `text` is one line, valid during the call. */
typedef void (*plb_message_function)(void *closure, int level, const char *text);

/* "0.2.0" */
PLB_API const char *plb_version(void);

/* Reads a length: a number or a fraction, then mm, cm, in, pt or px (1/96 inch, also meant without a unit), as
 * "210mm" or "5/300in". `mm` gets millimetres. False when the text is no length. The same in every locale. */
PLB_API bool plb_parse_length(const char *text, double *mm);

/* ---- pencils --------------------------------------------------------------------------------------------- */

/* A pencil: the statistics of its line, captured once from scans. Immutable. */
typedef struct plb_profile plb_profile;

/* The names of the eight pencils that come with the library, from hard to soft: 2H H F HB B 3B 6B 8B; NULL past the
 * last one. */
PLB_API const char *plb_pencil_name(size_t index);

/* Loads one of the eight pencils by name, any case, or else the file of that name (pencil(5)). The caller frees
 * the result. NULL and `error` (may be NULL) on failure. */
PLB_API plb_profile *plb_profile_load(const char *pencil, plb_error *error);
PLB_API void plb_profile_free(plb_profile *profile);
/* Borrowed; lives as long as the profile. */
PLB_API const char *plb_profile_name(const plb_profile *profile);
/* Median grey along the centre of the line, 0 black to 255 paper. */
PLB_API int plb_profile_centre_grey(const plb_profile *profile);
/* Width of the line at half its depth, mm. */
PLB_API double plb_profile_width(const plb_profile *profile);

typedef struct {
    const char *name;           /* of the new pencil; NULL: "pencil" */
    const char *provenance;     /* text to keep in it: scans, hand, licence; NULL: none */
    double dpi;                 /* of the scans; 0: what the PNG says, else 300 */
    int centre_min, centre_max; /* use only lines whose median grey at the centre lies in [min, max]; 0 and 255: all */
    double width;               /* stretch the cross-section to this width at half depth, mm; 0: as measured */
    bool free_hand;             /* lines drawn with it stray as a free hand does, not as those of the scans */
    bool as_measured;           /* the grain as the scans have it, not corrected by how lines drawn with it differ from them */
    const plb_profile *grain;   /* borrow in part the grain of this pencil, borrowed; NULL: as measured */
    plb_message_function message; /* told about each scan; may be NULL */
    void *closure;
} plb_capture_options;
PLB_API plb_capture_options plb_capture_options_default(void);

/* Measures a pencil from `n` PNG scans, each with one line (found and straightened by the call). The caller frees the
 * result. NULL and `error` when a scan cannot be read or none holds a usable line. */
PLB_API plb_profile *plb_profile_capture(const char *const scans[], size_t n, const plb_capture_options *options, plb_error *error);
/* Writes `file`, complete or not at all. */
PLB_API bool plb_profile_save(const plb_profile *profile, const char *file, plb_error *error);
/* Writes the numbers as text to `to`. False when writing fails. */
PLB_API bool plb_profile_show(const plb_profile *profile, FILE *stream, plb_error *error);
/* Writes how two profiles differ as text to `to`. */
PLB_API bool plb_profile_compare(const plb_profile *a, const plb_profile *b, FILE *stream, plb_error *error);
/* Writes histograms, cross-section and co-occurrence matrix as a picture (PNG), complete or not at all. */
PLB_API bool plb_profile_plot(const plb_profile *profile, const char *file, plb_error *error);

/* ---- drawing --------------------------------------------------------------------------------------------- */

typedef enum {
    PLB_MODEL_HLA,     /* the papers' algorithm, with their constants */
    PLB_MODEL_GRAPHITE /* hand and grain as measured on real lines; needs a profile with a grain */
} plb_model;

typedef enum {
    PLB_ARM_DEFAULT,    /* the model's own: hand for graphite, jerk for hla */
    PLB_ARM_HAND,   /* a free hand as measured */
    PLB_ARM_JERK,   /* minimum jerk with random deviation: Al-Meraj et al. 2008 */
    PLB_ARM_SPRING, /* the force model of the authors' earlier manuscript */
    PLB_ARM_LOGNORMAL, /* Plamondon's kinematic theory: delta-lognormal speed, arcs */
    PLB_ARM_TORQUE  /* least change of torque of a two-link arm: Uno, Kawato, Suzuki 1989 */
} plb_arm;

typedef enum {
    PLB_FILL_HATCH,   /* a filled shape is hatched to its tone and outlined; thin and small ones are solid */
    PLB_FILL_OUTLINE, /* a filled shape is drawn as its outline */
    PLB_FILL_NONE     /* not at all */
} plb_fill;

typedef enum {
    PLB_TEXT_HAND,    /* lettering, and other shapes as thin, is drawn stroke by stroke, as a hand writes */
    PLB_TEXT_OUTLINE, /* as its outlines */
    PLB_TEXT_NONE     /* not at all */
} plb_text;

/* Which hand draws: it has its own way with lines of each direction (plumbago(7)). */
typedef enum { PLB_HAND_RIGHT, PLB_HAND_LEFT, PLB_HAND_NONE } plb_handed;
/* How rough the paper is: what hollows the graphite model's strokes skip over. */
typedef enum { PLB_PAPER_MEDIUM, PLB_PAPER_SMOOTH, PLB_PAPER_ROUGH, PLB_PAPER_NONE } plb_paper;

typedef enum { PLB_BACKGROUND_WHITE, PLB_BACKGROUND_NONE } plb_background;

/* Always start from plb_options_default(): fields will be added. */
typedef struct {
    const plb_profile *profile; /* the pencil; NULL: HB */
    plb_paper paper;            /* what graphite is drawn on; default medium */
    double pressure;            /* times the usual, 0.2 to 3; default 1 */
    uint64_t seed;              /* default 1 */
    plb_model model;            /* default graphite */
    plb_arm arm;                /* how the arm moves; default: the model's own */
    plb_handed handed;          /* default right; none: every direction alike. Model graphite, arm hand */
    double squiggle;            /* deviation of the path, mm; 0: ruler-straight; negative, the default: the arm's own.
                                   jerk, spring: the largest; hand: as measured at 5/300 in, else in proportion */
    double dpi;                 /* pixels per inch of pictures; default 300, 10 to 4800 */
    double width, height;       /* size of the page, mm; 0: the drawing's own (one given: the other follows) */
    double scale;               /* factor on the drawing's own size; default 0: 1, or what fits A3 (DXF); not with width or height */
    double overshoot;           /* lines run past corners by up to so much, mm; default 0 */
    double restate;             /* share of the long lines that are drawn twice, 0 to 1; default 0 */
    bool construction;          /* faint lines beyond long lines, axes of circles; default false */
    plb_fill fill;              /* what becomes of filled shapes; default hatch */
    plb_text text;              /* what becomes of lettering; default hand */
    plb_background background;  /* default white */
    bool colour;                /* each stroke with a pencil of its own colour; default false: all graphite */
    int threads;                /* at most so many, up to 64; 0, the default: as many as there are processors */
    int compress;               /* how small files are made: 0, not, to 9; default 1 */
    unsigned page;              /* which page of a file with several, from 1; 0, the default: the first, and a warning when
                                   there are others */
    double limit_time;          /* processor time of the programs that read foreign formats, all for one drawing, s; default 8, 1 to 1e6 */
    double limit_memory;        /* memory of each, MiB; default 1024, 64 to 1e6 */
    const char *helper_dir;     /* where the programs that read foreign formats (tap-svg and its like) lie; NULL: beside the program, else the installed place */
    plb_message_function message; /* NULL: silence */
    void (*progress)(void *closure, double done); /* told 0 to 1 now and then; may be NULL */
    void *closure;              /* for message and progress */
} plb_options;
PLB_API plb_options plb_options_default(void);

/* A drawing: what a file holds, planned as pencil strokes. */
typedef struct plb_drawing plb_drawing;

/* In all calls `drawing`, `file` and `options` must not be NULL; `error` may be. */

/* Reads SVG (.svg, .svgz), PDF, PostScript (.ps, .eps) or DXF, recognised by content, from `file` ("-": standard input), at
 * the size that `options` ask for. The caller frees the result. NULL and `error` on failure. */
PLB_API plb_drawing *plb_drawing_load(const char *file, const plb_options *options, plb_error *error);
PLB_API void plb_drawing_free(plb_drawing *drawing);
/* Size of the page, mm. */
PLB_API double plb_drawing_width(const plb_drawing *drawing);
PLB_API double plb_drawing_height(const plb_drawing *drawing);
/* How many pencil strokes it has. */
PLB_API size_t plb_drawing_strokes(const plb_drawing *drawing);

/* A file in memory, for those who want several of its pages. Immutable. */
typedef struct plb_file plb_file;
/* Reads all bytes of `file` ("-": standard input). The caller frees the result. NULL and `error` on failure. */
PLB_API plb_file *plb_file_load(const char *file, plb_error *error);
PLB_API void plb_file_free(plb_file *file);
/* How many pages it has; 0 and `error` on failure. */
PLB_API unsigned plb_file_pages(const plb_file *file, const plb_options *options, plb_error *error);
/* The drawing on options->page. The caller frees the result. NULL and `error` on failure. */
PLB_API plb_drawing *plb_file_draw(const plb_file *file, const plb_options *options, plb_error *error);

/* Writes the drawing as PNG to `file` (complete or not at all; "-": standard output). */
PLB_API bool plb_drawing_write_png(const plb_drawing *drawing, const char *file, const plb_options *options, plb_error *error);
/* The same as PDF: one page of the drawing's true size. */
PLB_API bool plb_drawing_write_pdf(const plb_drawing *drawing, const char *file, const plb_options *options, plb_error *error);
/* The drawing on a new cairo image surface of its size at options->dpi: CAIRO_FORMAT_ARGB32, graphite on white or on
 * nothing. The caller destroys it. NULL and `error` on failure. */
PLB_API cairo_surface_t *plb_drawing_render(const plb_drawing *drawing, const plb_options *options, plb_error *error);

/* What the stages made, as text (PLB_DUMP_LIST: the display list as read; PLB_DUMP_STROKES: the planned strokes) or
 * as a picture in the manner of the papers' Figure 3.2 (PLB_DUMP_CONTROLS: a PNG of the paths with control points
 * in red). Written to `file`, complete or not at all; "-": standard output. */
typedef enum { PLB_DUMP_LIST, PLB_DUMP_STROKES, PLB_DUMP_CONTROLS } plb_dump;
PLB_API bool plb_drawing_dump(const plb_drawing *drawing, plb_dump what, const char *file, const plb_options *options, plb_error *error);

/* Draws one pencil line from (x0, y0) to (x1, y1) onto a cairo image surface (ARGB32, RGB24 or A8; not finished), in
 * pixels of the surface, which is taken to have options->dpi. It darkens what is there, as graphite does. `number` tells
 * lines with the same ends apart. */
PLB_API bool plb_draw_line(cairo_surface_t *surface, double x0, double y0, double x1, double y1, uint64_t number,
                           const plb_options *options, plb_error *error);

#ifdef __cplusplus
}
#endif

#endif
