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
    PLB_ERROR_HELPER,      /* a helper program is missing or died */
    PLB_ERROR_CANCELLED    /* the caller's progress function said stop */
} plb_status;

/* Why a call failed: one line without a newline, "FILE:LINE: what is wrong" where a file is to blame. A call that succeeds
 * leaves PLB_OK and an empty text. */
typedef struct {
    plb_status status;
    char text[512];
} plb_error;

/* Called for warnings (level 0) and details (level 1) while a call runs; `text` is one line, valid during the call. */
typedef void (*plb_message_function)(void *closure, int level, const char *text);

/* The thread that made the call tells now and then how much is done: 0 to 0.2 while a drawing is read and planned, from
 * there to 1 while it is drawn and written; while another program reads, 50 times a second. False stops the call (and that
 * program), which then fails with PLB_ERROR_CANCELLED. */
typedef bool (*plb_progress_function)(void *closure, double done);

/* A program is compiled with this version. The numbers grow with the version: #if PLB_VERSION_NUMBER >= 200. */
#define PLB_VERSION_MAJOR 0
#define PLB_VERSION_MINOR 2
#define PLB_VERSION_PATCH 0
#define PLB_VERSION_NUMBER (PLB_VERSION_MAJOR * 10000 + PLB_VERSION_MINOR * 100 + PLB_VERSION_PATCH)
/* Gives the version of the library that the program runs with: "0.2.0". */
PLB_API const char *plb_version(void);

/* Reads a length: a number or a fraction, then mm, cm, in, pt or px (1/96 inch, also meant without a unit), as
 * "210mm" or "5/300in". `mm` gets millimetres. False when the text is no length. The same in every locale. */
PLB_API bool plb_parse_length(const char *text, double *mm);

/* ---- pencils --------------------------------------------------------------------------------------------- */

/* A pencil holds the statistics of its line, captured once from scans. Immutable. */
typedef struct plb_profile plb_profile;

/* Gives the names of the eight pencils that come with the library, from hard to soft: 2H H F HB B 3B 6B 8B; NULL past the last one. */
PLB_API const char *plb_pencil_name(size_t index);

/* Loads one of the eight pencils by name, any case, or else the file of that name (pencil(5)). The caller frees
 * the result. NULL and `error` (may be NULL) on failure. */
PLB_API plb_profile *plb_profile_load(const char *pencil, plb_error *error);
/* Loads a pencil from the bytes of such a file; `name` is for messages, NULL: "memory". */
PLB_API plb_profile *plb_profile_from_memory(const void *data, size_t size, const char *name, plb_error *error);
PLB_API void plb_profile_free(plb_profile *profile);
/* Gives the pencil's name, borrowed; the text lives as long as the profile. */
PLB_API const char *plb_profile_name(const plb_profile *profile);
/* Gives the median grey along the centre of the line, 0 black to 255 paper. */
PLB_API int plb_profile_centre_grey(const plb_profile *profile);
/* Gives the width of the line at half its depth, mm. */
PLB_API double plb_profile_width(const plb_profile *profile);

typedef struct {
    const char *name;           /* of the new pencil; NULL: "pencil" */
    const char *provenance;     /* text to keep in it: scans, hand, licence; NULL: none */
    double dpi;                 /* of the scans; 0: what the PNG says, else 300 */
    int centre_min, centre_max; /* use only lines whose median grey at the centre lies in [min, max]; 0 and 255: all */
    double width;               /* stretch the cross-section to this width at half depth, mm; 0: as measured */
    bool free_hand;             /* lines drawn with it stray as a free hand does, not as those of the scans */
    bool as_measured;           /* the grain as measured in the scans, not corrected by how lines drawn with it differ from them */
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

/* ---- settings -------------------------------------------------------------------------------------------- */

/* Options say how a drawing is made. plb_options_new() gives the defaults; plumbago(1) and plb_setting_at() say what a
 * setting is called, takes and does. Calls read the options that they get and change none. */
typedef struct plb_options plb_options;

/* Makes options with the defaults. The caller frees the result; NULL: out of memory. */
PLB_API plb_options *plb_options_new(void);
PLB_API plb_options *plb_options_copy(const plb_options *from);
PLB_API void plb_options_free(plb_options *options);

/* Sets one by its name and a text, as the command line does: ("arm", "jerk"), ("width", "84mm"), ("colour", "on"). False when
 * there is no such setting or it does not take the value; then it stays as it was, and `error` says what it takes. */
PLB_API bool plb_options_set(plb_options *options, const char *name, const char *value, plb_error *error);
/* Sets a setting whose value is a number, in the setting's unit: mm for lengths. */
PLB_API bool plb_options_set_number(plb_options *options, const char *name, double value, plb_error *error);
/* Tells whether the settings go together (scale and width do not); the calls that get the options check this, too. */
PLB_API bool plb_options_check(const plb_options *options, plb_error *error);
/* Writes the value into `text`, of `size` bytes, in the form that plb_options_set reads. False when there is no such
 * setting or `size` is too small. */
PLB_API bool plb_options_get(const plb_options *options, const char *name, char *text, size_t size);

/* Sets the pencil, which is no text. The options share the pencil instead of copying it: the caller may free his at once. */
PLB_API void plb_options_set_profile(plb_options *options, const plb_profile *profile);
PLB_API void plb_options_set_seed(plb_options *options, uint64_t seed);
/* Sets the functions that hear messages and progress. Either may be NULL: silence. Both get `closure`. */
PLB_API void plb_options_set_message(plb_options *options, plb_message_function message, void *closure);
PLB_API void plb_options_set_progress(plb_options *options, plb_progress_function progress, void *closure);

typedef enum {
    PLB_SETTING_NUMBER,
    PLB_SETTING_LENGTH, /* "84mm"; the number is mm */
    PLB_SETTING_RATIO,  /* "0.5", "50%", "1/2" or "1:2" */
    PLB_SETTING_WHOLE,
    PLB_SETTING_SEED,   /* whole, of 64 bits */
    PLB_SETTING_CHOICE,
    PLB_SETTING_FLAG,   /* "on" or "off" */
    PLB_SETTING_TEXT,
    PLB_SETTING_PENCIL, /* a grade or a file */
    PLB_SETTING_PAGE,   /* a choice, perhaps with -portrait or -landscape */
    PLB_SETTING_PIXELS, /* "1200" or "800x600" */
    PLB_SETTING_ANGLES  /* degrees: a word, "30,20", or a word and an angle, "perspective=40" */
} plb_setting_kind;

/* These flags say in which calls a setting counts. A drawing's strokes are planned when it is loaded: what counts then
 * must be the same when it is drawn, or the call fails and names the setting, unless the setting changes no stroke
 * (COUNTS_FREELY). */
enum { PLB_COUNTS_LOADING = 1, PLB_COUNTS_DRAWING = 2, PLB_COUNTS_FREELY = 4 };

/* A plb_setting describes a row of the library's table of settings, for command lines, dialogues, bindings. */
typedef struct {
    const char *name;
    char letter;          /* of a short option, or 0 */
    const char *group;    /* the heading under which it is listed */
    plb_setting_kind kind;
    const char *argument; /* what a usage line calls the value; NULL: a choice, which has words, or a flag, which has none */
    double min, max;      /* of numbers, in `unit` */
    const char *unit;
    const char *usual;    /* the default, as plb_options_set takes it; "auto": it goes by the drawing, or the like */
    const char *help;     /* one line */
    unsigned calls;       /* PLB_COUNTS_… */
} plb_setting;
/* Gives the settings in the order of their groups; NULL past the last. */
PLB_API const plb_setting *plb_setting_at(size_t index);
/* Gives the words that a choice takes, a page's names and those for angles; NULL past the last. */
PLB_API const char *plb_setting_word(const plb_setting *setting, size_t index);
/* Gives the number of letters of `word`, of n bytes, that must be changed, left out, added or swapped with their neighbour to
 * make `name`; PLB_NAME_FAR where so many must that nobody meant it. Command lines propose the nearest name by this. */
PLB_API size_t plb_name_distance(const char *name, const char *word, size_t n);
#define PLB_NAME_FAR ((size_t)-1)

/* ---- drawing --------------------------------------------------------------------------------------------- */

/* A drawing holds what a file shows, planned as pencil strokes. */
typedef struct plb_drawing plb_drawing;

/* In all calls `drawing` and `file` must not be NULL; `error` may be, and `options`: where a drawing is loaded that stands for
 * the defaults, where it is drawn for the options it was loaded with. */

/* Reads SVG (.svg, .svgz), PDF, PostScript (.ps, .eps) or DXF, recognised by content, from `file` ("-": standard input), at
 * the size that `options` ask for. The caller frees the result. NULL and `error` on failure. */
PLB_API plb_drawing *plb_drawing_load(const char *file, const plb_options *options, plb_error *error);
PLB_API void plb_drawing_free(plb_drawing *drawing);
/* Gives the size of the page, mm. */
PLB_API double plb_drawing_width(const plb_drawing *drawing);
PLB_API double plb_drawing_height(const plb_drawing *drawing);
/* Gives the number of pencil strokes. */
PLB_API size_t plb_drawing_strokes(const plb_drawing *drawing);

/* A file in memory, for those who want several of its pages. Immutable. */
typedef struct plb_file plb_file;
/* Reads all bytes of `file` ("-": standard input). The caller frees the result. NULL and `error` on failure. */
PLB_API plb_file *plb_file_load(const char *file, plb_error *error);
/* Makes such a file of bytes in memory, which are copied; `name` is for messages, NULL: "memory". */
PLB_API plb_file *plb_file_from_memory(const void *data, size_t size, const char *name, plb_error *error);
PLB_API void plb_file_free(plb_file *file);
/* Gives the number of pages; 0 and `error` on failure. */
PLB_API unsigned plb_file_pages(const plb_file *file, const plb_options *options, plb_error *error);
/* Loads the drawing on the page that the setting `page` names. The caller frees the result. NULL and `error` on failure. */
PLB_API plb_drawing *plb_file_draw(const plb_file *file, const plb_options *options, plb_error *error);

/* ---- drawings of a program's own -------------------------------------------------------------------------- */

/* A canvas: a page on which a program draws paths in mm, x to the right, y down; they become pencil strokes as those of a file do.
 * A call that fails is remembered, and plb_canvas_draw says why. */
typedef struct plb_canvas plb_canvas;
/* Makes an empty page of so many mm. The caller frees the result. NULL and `error` on failure. */
PLB_API plb_canvas *plb_canvas_new(double width, double height, plb_error *error);
PLB_API void plb_canvas_free(plb_canvas *canvas);

/* These calls add to the current path. An arc is about (x, y), from one angle to another, in radians, growing clockwise
 * as seen on paper; a line leads to the arc's beginning. */
PLB_API void plb_canvas_move_to(plb_canvas *canvas, double x, double y);
PLB_API void plb_canvas_line_to(plb_canvas *canvas, double x, double y);
PLB_API void plb_canvas_curve_to(plb_canvas *canvas, double x1, double y1, double x2, double y2, double x3, double y3);
PLB_API void plb_canvas_arc(plb_canvas *canvas, double x, double y, double radius, double from, double to);
PLB_API void plb_canvas_close_path(plb_canvas *canvas);

typedef enum { PLB_CAP_BUTT, PLB_CAP_ROUND, PLB_CAP_SQUARE } plb_cap;
/* These calls set the paint, 0 to 1 each, default opaque black; the width of lines, default 0.35 mm; their ends,
 * default butt; the lengths of dashes and gaps in turn, mm (n = 0, the default: solid); the rule of fills and clips,
 * default nonzero. */
PLB_API void plb_canvas_set_colour(plb_canvas *canvas, double red, double green, double blue, double alpha);
PLB_API void plb_canvas_set_width(plb_canvas *canvas, double mm);
PLB_API void plb_canvas_set_cap(plb_canvas *canvas, plb_cap cap);
PLB_API void plb_canvas_set_dash(plb_canvas *canvas, const double *mm, size_t n, double offset);
PLB_API void plb_canvas_set_even_odd(plb_canvas *canvas, bool even_odd);

/* These calls stroke the path, fill it, or narrow the clip to it; the path is empty afterwards. */
PLB_API void plb_canvas_stroke(plb_canvas *canvas);
PLB_API void plb_canvas_fill(plb_canvas *canvas);
PLB_API void plb_canvas_clip(plb_canvas *canvas);
PLB_API void plb_canvas_reset_clip(plb_canvas *canvas);

/* Makes a drawing of what is on the canvas, which is empty afterwards. The caller frees the result. NULL and `error` on failure. */
PLB_API plb_drawing *plb_canvas_draw(plb_canvas *canvas, const plb_options *options, plb_error *error);

/* ---- strokes ---------------------------------------------------------------------------------------------- */

typedef struct {
    double x, y; /* mm */
} plb_point;
typedef enum { PLB_STROKE_LINE, PLB_STROKE_HATCH, PLB_STROKE_LETTER, PLB_STROKE_GUIDE } plb_stroke_kind;
/* A stroke is one movement of the pencil. */
typedef struct {
    plb_stroke_kind kind;
    double pressure;         /* times the usual */
    uint32_t colour;         /* 0xRRGGBB; 0: graphite */
    double width;            /* of the pencil's line at half its depth, mm */
    bool closed;
    size_t n;
    const plb_point *points; /* the line that is meant; borrowed from the drawing */
} plb_stroke;
/* Gives stroke number `index` in the order in which they are drawn; false past the last one. */
PLB_API bool plb_drawing_stroke(const plb_drawing *drawing, size_t index, plb_stroke *stroke);
/* Gives the path that the hand makes of the stroke: `n` points, to be joined by straight lines, which the caller frees
 * with plb_memory_free. NULL and `error` on failure. */
PLB_API plb_point *plb_drawing_trace(const plb_drawing *drawing, size_t index, size_t *n, const plb_options *options, plb_error *error);

/* ---- pictures --------------------------------------------------------------------------------------------- */

/* A plb_format describes a row of the library's table of picture formats. */
typedef struct {
    const char *name;     /* "JPEG" */
    const char *suffixes; /* of files, without the dot, with blanks between them: "jpg jpeg" */
    bool has_pages;       /* a file may hold several pages */
    bool has_paths;       /* it holds the hand's paths instead of pixels */
    bool is_built;        /* this library writes it: some need a library of their own when it is built */
} plb_format;
/* Gives the formats, the usual one first. False past the last one. */
PLB_API bool plb_format_at(size_t index, plb_format *format);
/* Gives the format that a file's suffix asks for, in upper or lower case; PNG where the name has none, or is "-". False
 * and `error` where no format has such a suffix. */
PLB_API bool plb_format_of(const char *file, plb_format *format, plb_error *error);

/* Writes the drawing to `file` (complete or not at all; "-": standard output) in the format of its suffix. */
PLB_API bool plb_drawing_write(const plb_drawing *drawing, const char *file, const plb_options *options, plb_error *error);
/* Writes the drawing as PNG; the name may have no suffix, but not that of another format. */
PLB_API bool plb_drawing_write_png(const plb_drawing *drawing, const char *file, const plb_options *options, plb_error *error);
/* Writes the drawing as PDF: one page of the drawing's true size. */
PLB_API bool plb_drawing_write_pdf(const plb_drawing *drawing, const char *file, const plb_options *options, plb_error *error);

/* Writes a film in which the drawing draws itself, as APNG, as GIF (grey, on paper) where the name ends in .gif, or as a picture for each frame where the name has a place for a number, %d or %04d. The settings fps,
 * duration, pause, loop, boil and hold count; the last frame has the pixels of the picture, with boil above 1 the first. */
PLB_API bool plb_drawing_write_film(const plb_drawing *drawing, const char *file, const plb_options *options, plb_error *error);

/* Takes the next `n` bytes of a file. False ends the work; errno may say why. */
typedef bool (*plb_write_function)(void *closure, const void *data, size_t n);
/* Hands the bytes of the file, in the format of that name or suffix ("svg"), to a function, in order. */
PLB_API bool plb_drawing_write_to(const plb_drawing *drawing, const char *format, plb_write_function put, void *closure,
                                  const plb_options *options, plb_error *error);
/* Gives the file in memory: `size` bytes that the caller frees with plb_memory_free. NULL and `error` on failure. */
PLB_API void *plb_drawing_write_memory(const plb_drawing *drawing, const char *format, size_t *size, const plb_options *options, plb_error *error);
PLB_API void plb_memory_free(void *bytes);

/* A document is a file of several pages that is being written. */
typedef struct plb_document plb_document;
/* Begins a file in the format of its suffix, which must be one with pages. The caller closes or frees the result. NULL and
 * `error` on failure. */
PLB_API plb_document *plb_document_new(const char *file, plb_error *error);
/* Writes the drawing as the next page. After a failure no further page can follow. */
PLB_API bool plb_document_add(plb_document *document, const plb_drawing *drawing, const plb_options *options, plb_error *error);
/* Ends the file, which then appears, and frees the document. False and `error` on failure; there is no file then. */
PLB_API bool plb_document_close(plb_document *document, plb_error *error);
/* Frees the document without making a file. */
PLB_API void plb_document_free(plb_document *document);

/* Draws on a new cairo image surface of the drawing's size at the setting `dpi`: CAIRO_FORMAT_ARGB32, graphite on white
 * or on nothing. The caller destroys it. NULL and `error` on failure. */
PLB_API cairo_surface_t *plb_drawing_render(const plb_drawing *drawing, const plb_options *options, plb_error *error);

/* Shows what the stages made as text (PLB_DUMP_LIST: the display list as read; PLB_DUMP_STROKES: the planned strokes)
 * or as a picture in the manner of the papers' Figure 3.2 (PLB_DUMP_CONTROLS: a PNG of the paths with control points in
 * red). The call writes `file`, complete or not at all; "-": standard output. */
typedef enum { PLB_DUMP_LIST, PLB_DUMP_STROKES, PLB_DUMP_CONTROLS } plb_dump;
PLB_API bool plb_drawing_dump(const plb_drawing *drawing, plb_dump what, const char *file, const plb_options *options, plb_error *error);

typedef enum { PLB_PIXELS_GREY, PLB_PIXELS_GREY_ALPHA, PLB_PIXELS_RGB, PLB_PIXELS_RGBA } plb_pixel_format;
/* The caller's pixels lie in rows of bytes, with alpha not multiplied in. */
typedef struct {
    void *data;
    size_t stride;     /* bytes from a row to the next */
    plb_pixel_format format;
    int x, y;          /* the page's pixel that comes first; the page may end within */
    int width, height;
} plb_pixels;
/* Gives the number of the page's pixels at the setting `dpi`. */
PLB_API bool plb_drawing_size(const plb_drawing *drawing, int *width, int *height, const plb_options *options, plb_error *error);
/* Draws a part of the page into the caller's pixels. What lies beside the page stays as it is. */
PLB_API bool plb_drawing_render_pixels(const plb_drawing *drawing, const plb_pixels *to, const plb_options *options, plb_error *error);

/* Draws one pencil line from (x0, y0) to (x1, y1) onto a cairo image surface (ARGB32, RGB24 or A8; not finished), in
 * pixels of the surface, which is taken to have the setting `dpi`. It darkens what is there, as graphite does. `line_id` tells
 * lines with the same ends apart. */
PLB_API bool plb_draw_line(cairo_surface_t *surface, double x0, double y0, double x1, double y1, uint64_t line_id,
                           const plb_options *options, plb_error *error);
/* Draws `n` lines, each given as x0, y0, x1, y1; the first has the identity `line_id`, the next the number after it. */
PLB_API bool plb_draw_lines(cairo_surface_t *surface, const double (*ends)[4], size_t n, uint64_t line_id, const plb_options *options, plb_error *error);

#ifdef __cplusplus
}
#endif

#endif
