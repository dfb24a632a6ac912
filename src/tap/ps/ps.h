/* SPDX-License-Identifier: MIT
 *
 * The PostScript interpreter, seen by its operators: objects, stacks, memory, errors. Private to this
 * folder. "PLRM" below is the PostScript Language Reference, 3rd edition.
 *
 * An operator is a function and a line in a table: its name and a signature, one letter for each operand it needs,
 * the topmost last. The interpreter checks the signature before the call, so an operator starts with good operands:
 *     n number   i integer   b boolean   x anything   s string   a array   p procedure   m array of 6
 *     d dictionary   k name or string   f file
 * It takes them with ps_args and leaves its result with ps_give. To fail it returns ps_raise(…), which the file may
 * catch with `stopped`, or ps_fail(…), which ends the reading; in both cases the operands must still be in place.
 *
 * Nothing here recurses on what the file nests: what is under way lies on the execution stack as frames.
 */
#ifndef PLB_TAP_PS_PS_H
#define PLB_TAP_PS_PS_H

#include "base/array.h"
#include "base/error.h"
#include "base/geometry/geom.h"
#include "base/geometry/path.h"
#include "list/display_list.h"
#include "tap/common/scan.h"
#include "tap/ps/postscript.h"

#include <stdint.h>

/* ---- limits (chosen so that the worst file stays below 10 s and 1 GiB) ------------------------------------ */

#ifndef PS_MAX_STEPS /* the fuzzer's build, which wants many short runs, asks for less of each (tests/fuzz/short_runs.h) */
#define PS_MAX_STEPS 50000000u           /* objects executed, and work of bulk operators */
#define PS_MAX_STEPS_AFTER 1000000u      /* … after the page is complete */
#define PS_MAX_MEMORY ((size_t)256 << 20)     /* for objects */
#define PS_MAX_LIST_BYTES ((size_t)448 << 20) /* of the display list */
#define PS_MAX_OPERANDS 65536u
#define PS_MAX_FRAMES 8192u
#define PS_MAX_DICTS 256u
#define PS_MAX_STATES 4096u              /* gsave and save */
#define PS_MAX_ARRAY (1u << 20)          /* elements of an array or entries a dictionary starts with */
#define PS_MAX_STRING (16u << 20)        /* bytes of a string */
#define PS_MAX_PATH_POINTS ((size_t)8 << 20)  /* in all current paths together */
#endif
#define PS_MAX_PAGE_POINTS 20000.0       /* 7 m */

/* Device space is 7200 dpi, y up: fine, because programs round line widths and positions to whole device units. */
#define PS_UNITS_PER_POINT 100.0

/* ---- objects ---------------------------------------------------------------------------------------------- */

typedef enum {
    PS_NULL, PS_MARK, PS_BRACE /* an open `{`, never seen by programs */, PS_INTEGER, PS_REAL, PS_BOOLEAN, PS_NAME,
    PS_STRING, PS_ARRAY, PS_DICT, PS_OPERATOR, PS_FILE, PS_SAVE, PS_FONT_ID, PS_GSTATE
} ps_type;

typedef struct ps ps;
typedef struct ps_dict ps_dict;
typedef struct ps_file ps_file;
typedef struct ps_frame ps_frame;
typedef struct ps_object ps_object;

typedef struct {
    const char *text; /* NUL-terminated */
    uint32_t length, hash;
} ps_name;

typedef struct {
    const char *name, *signature;
    bool (*run)(ps *p);
} ps_operator;

struct ps_object {
    uint8_t type;
    bool executable;
    uint16_t stamp; /* of a dictionary's keys: the save since which the old value is kept */
    uint32_t n;     /* length of a string or array; of names and operators the line of the token */
    union {
        int32_t integer;
        double real;
        bool boolean;
        const ps_name *name;
        char *string;
        ps_object *array;
        ps_dict *dict;
        const ps_operator *op;
        ps_file *file;
        uint32_t save; /* its number; of a PS_GSTATE its place among the kept states */
    } as;
};

static inline ps_object ps_null(void) { return (ps_object){.type = PS_NULL}; }
static inline ps_object ps_mark(void) { return (ps_object){.type = PS_MARK}; }
static inline ps_object ps_integer(int32_t v) { return (ps_object){.type = PS_INTEGER, .as.integer = v}; }
static inline ps_object ps_real(double v) { return (ps_object){.type = PS_REAL, .as.real = v}; }
static inline ps_object ps_boolean(bool v) { return (ps_object){.type = PS_BOOLEAN, .as.boolean = v}; }
static inline ps_object ps_of_dict(ps_dict *d) { return (ps_object){.type = PS_DICT, .as.dict = d}; }
static inline ps_object ps_of_file(ps_file *f) { return (ps_object){.type = PS_FILE, .as.file = f}; }
static inline bool ps_is_number(ps_object o) { return o.type == PS_INTEGER || o.type == PS_REAL; }
static inline bool ps_is_proc(ps_object o) { return o.type == PS_ARRAY && o.executable; }
/* Gives the value of a number; 0 of anything else. */
static inline double ps_value(ps_object o) { return o.type == PS_INTEGER ? o.as.integer : o.type == PS_REAL ? o.as.real : 0; }
/* Makes an integer where the value fits into one, else a real. */
static inline ps_object ps_whole(double v) { return v >= INT32_MIN && v <= INT32_MAX ? ps_integer((int32_t)v) : ps_real(v); }

/* A dictionary holds its entries in the order they came in (a key of type PS_NULL: removed); above a handful an index finds them. */
typedef struct {
    ps_object key, value;
} ps_entry;

struct ps_dict {
    ps_entry *entries;
    uint32_t *index; /* 1 + the entry's number, 0: free; NULL while the dictionary is small */
    uint32_t used;   /* entries written, the removed ones too */
    uint32_t live;   /* entries there */
    uint32_t capacity, index_size;
    uint32_t stated; /* the size it was made with */
    uint16_t born;   /* the save during which it was made */
};

/* A stream holds bytes in memory: the input file, or a string that is executed or scanned. */
struct ps_file {
    const char *at, *end;
    int line;       /* of the byte at `at`; 0: lines are not counted */
    bool is_string; /* not what `currentfile` means */
};

/* ---- errors ----------------------------------------------------------------------------------------------- */

typedef enum {
    PS_NO_FAULT, PS_CONFIGURATIONERROR, PS_DICTFULL, PS_DICTSTACKOVERFLOW, PS_DICTSTACKUNDERFLOW, PS_EXECSTACKOVERFLOW,
    PS_INTERRUPT, PS_INVALIDACCESS, PS_INVALIDEXIT, PS_INVALIDFILEACCESS, PS_INVALIDFONT, PS_INVALIDRESTORE, PS_IOERROR,
    PS_LIMITCHECK, PS_NOCURRENTPOINT, PS_RANGECHECK, PS_STACKOVERFLOW, PS_STACKUNDERFLOW, PS_SYNTAXERROR, PS_TIMEOUT,
    PS_TYPECHECK, PS_UNDEFINED, PS_UNDEFINEDFILENAME, PS_UNDEFINEDRESOURCE, PS_UNDEFINEDRESULT, PS_UNMATCHEDMARK,
    PS_UNREGISTERED, PS_VMERROR, PS_FAULT_COUNT
} ps_fault;

extern const char *const plb_ps_fault_names[PS_FAULT_COUNT];

/* All return false. ps_fail puts "LINE: " before the text. */
bool plb_ps_raise(ps *p, ps_fault fault);
/* Raises a fault with a text of its own for the user. */
bool plb_ps_explain(ps *p, ps_fault fault, const char *format, ...) __attribute__((format(printf, 3, 4)));
bool plb_ps_undefined(ps *p, ps_object key);
/* Refuses an operator that would reach outside the input. */
bool plb_ps_refuse(ps *p);
bool plb_ps_fail(ps *p, error_kind kind, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* Counts bulk work against the steps; false when they are used up. */
bool plb_ps_charge(ps *p, size_t work);

/* ---- the graphics state ----------------------------------------------------------------------------------- */

/* A path in device space, shared by saved graphics states until one of them changes it. */
typedef struct {
    path path;
    unsigned references;
} ps_path;

typedef struct {
    matrix ctm; /* user space to device space */
    ps_path *path;
    point start, current; /* of the last subpath; device space */
    bool has_current;
    bool is_outline;      /* after strokepath: to fill the path is to stroke it */
    int clip;             /* in the display list */
    struct ps_kept_clip *kept_clips; /* by clipsave */
    bool nothing_visible; /* clipped by an empty path */
    bool no_output;       /* nulldevice, stringwidth */
    paint paint;
    ps_object pattern; /* the one to fill with, or null */
    ps_object colour_space, colour[4]; /* colour: what `currentcolor` gives */
    unsigned components;
    double line_width, miter_limit, flatness, dash_offset;
    int cap, join;
    ps_object dash; /* an array of our own */
    ps_object font;
    bool stroke_adjust, overprint;
    uint32_t save; /* not 0: pushed by `save`, with this number */
} ps_state;

/* ---- frames of the execution stack ------------------------------------------------------------------------ */

typedef enum {
    FRAME_PLAIN,
    FRAME_LOOP,    /* `exit` ends it */
    FRAME_STOPPED, /* `stop` ends it */
    FRAME_SOURCE   /* a file or string being scanned */
} ps_frame_kind;

/* `step` is called while the frame is on top: it does a little, pushes other frames or pops this one. */
struct ps_frame {
    bool (*step)(ps *p, ps_frame *f);
    void (*drop)(ps *p, ps_frame *f); /* called when the frame goes, however it goes; may be NULL */
    ps_frame_kind kind;
    uint32_t index;
    ps_object body, subject, extra;
    double now, by, limit;
    void *data; /* what the step function needs; in the arena or borrowed */
};

/* ---- the interpreter -------------------------------------------------------------------------------------- */

typedef struct ps_block ps_block;

/* A journal entry is a value to put back at `restore`. */
typedef struct {
    ps_dict *dict;
    ps_entry old;
    bool was_there;
    uint32_t save;
} ps_change;

struct ps {
    const ps_request *ask;
    display_list *list;
    error err;
    size_t steps, max_steps, memory, path_points, list_bytes;
    /* memory */
    ps_block *blocks;
    ARRAY(const ps_name *) names; /* hash table, NULL: free */
    size_t name_count;
    /* stacks; fixed room, so that pointers into them stay good */
    ps_object *operands;
    uint32_t operand_count;
    ps_frame *frames;
    uint32_t frame_count;
    ps_dict **dicts;
    uint32_t dict_count;
    ps_state *states; /* the last is the current one */
    uint32_t state_count;
    ARRAY(ps_state) kept_states; /* those of `gstate` */
    /* what is being executed */
    scanner scan;
    const ps_operator *op;
    int line;
    ps_fault fault, last_fault;
    int fault_line;
    ps_object culprit;   /* the object that raised the fault */
    char detail[160];    /* more about it, or empty */
    bool finished;       /* quit, or all is known that was asked for */
    bool page_shown;     /* the page that is wanted is complete: the program runs on only to see whether another follows */
    bool another_page;   /* one does */
    bool area_is_known, pages_are_known; /* from the comments, whatever the program will still draw */
    const ps_operator *left; /* the first operator on this page that is Ghostscript's; NULL: none */
    int left_line;
    bool handed_over;       /* Ghostscript has it from here */
    unsigned page, page_wanted; /* shown so far, and the one to stop at; blank ones do not count */
    unsigned sheets;            /* shown so far, blank or not */
    /* dictionaries of the system */
    ps_dict *systemdict, *userdict, *globaldict, *statusdict, *errordict, *error_info, *fonts, *built_in_fonts;
    ps_object standard_encoding, latin1_encoding;
    ps_file *main_file;
    const char *program; /* all of it: main_file->at moves on */
    bool refused;        /* something was refused on purpose */
    /* saves */
    ARRAY(ps_change) changes;
    uint32_t save_now, save_last; /* the innermost save, and the last number given; 0: none */
    /* the page */
    double page_width, page_height; /* points */
    bool page_size_said;            /* by the program, not by default */
    point page_origin;              /* lower left corner of what is seen, points: the BoundingBox's */
    double seen_width, seen_height;
    /* odds and ends */
    int32_t random;
    bool packing, global;
    struct ps_show *showing; /* the innermost string whose Type 3 glyphs are being drawn */
};

static inline ps_state *ps_gs(ps *p) { return &p->states[p->state_count - 1]; }

/* Gives the lowest of the topmost `n` operands; the signature has made sure they are there. */
static inline ps_object *ps_args(ps *p, unsigned n) { return p->operands + (p->operand_count - n); }
static inline void ps_drop(ps *p, unsigned n) { p->operand_count -= n; }

/* ps_operands.c */
bool plb_ps_push(ps *p, ps_object o);
/* Replaces the topmost `drop` operands by `result`. */
bool plb_ps_give(ps *p, unsigned drop, ps_object result);
/* Finds the topmost mark and gives the number of operands above it; false: unmatchedmark raised. */
bool plb_ps_count_to_mark(ps *p, uint32_t *count);
/* Checks the topmost operands against a signature (see above); raises stackunderflow or typecheck. */
bool plb_ps_check(ps *p, const char *signature);
/* Pushes a frame, zeroed but for `step`; NULL: execstackoverflow raised. */
ps_frame *plb_ps_push_frame(ps *p, bool (*step)(ps *, ps_frame *));
void plb_ps_pop_frame(ps *p);
/* Calls `then` once when what is pushed after it has ended. */
ps_frame *plb_ps_push_then(ps *p, bool (*then)(ps *p, ps_frame *f));

/* ps_vm.c: memory that lives as long as the interpreter. NULL: a fault or failure is set. */
void *plb_ps_new(ps *p, size_t n, size_t size);
void plb_ps_free_memory(ps *p);
bool plb_ps_new_array(ps *p, uint32_t n, ps_object *out);              /* of nulls */
bool plb_ps_new_string(ps *p, const char *text, size_t n, ps_object *out); /* text NULL: zeros */
const ps_name *plb_ps_intern(ps *p, const char *text, size_t n);
/* Gives a literal name; its `as.name` is NULL when out of memory. */
ps_object plb_ps_name(ps *p, const char *text);
/* Gives the text of a name or string, for reading. */
const char *plb_ps_text(ps_object o, size_t *n);
bool plb_ps_text_is(ps_object o, const char *text);

/* ps_dict_table.c */
ps_dict *plb_ps_new_dict(ps *p, uint32_t size);
/* Finds an entry; NULL: there is none. The pointer is good until the dictionary changes. */
ps_object *plb_ps_get(ps *p, const ps_dict *d, ps_object key);
ps_object *plb_ps_get_text(ps *p, const ps_dict *d, const char *key);
bool plb_ps_put(ps *p, ps_dict *d, ps_object key, ps_object value);
bool plb_ps_put_text(ps *p, ps_dict *d, const char *key, ps_object value);
void plb_ps_remove(ps *p, ps_dict *d, ps_object key);
/* Undoes the changes made since save number `save` began. */
bool plb_ps_roll_back(ps *p, uint32_t save);
/* Searches the dictionary stack; NULL: no dictionary has the key. `where` (may be NULL) gets the dictionary. */
ps_object *plb_ps_lookup(ps *p, ps_object key, ps_dict **where);
bool plb_ps_equal(ps_object a, ps_object b);

/* Adds the operators of a table, which ends with a NULL name. */
bool plb_ps_add_operators(ps *p, ps_dict *d, const ps_operator *table);

/* ps_tokens.c: reads one whole object (procedures too); TOKEN_END as `*ended`. */
bool plb_ps_read_object(ps *p, ps_file *f, ps_object *out, bool *ended);
ps_file *plb_ps_file_of_string(ps *p, ps_object string);

/* ps_execute.c: executes an object as if its name had been called: procedures are entered, literals pushed. */
bool plb_ps_execute(ps *p, ps_object o);
bool plb_ps_push_source(ps *p, ps_file *f);
ps_file *plb_ps_current_file(ps *p);

/* ps_run.c */
bool plb_ps_run(ps *p);
/* `stop`: to the nearest `stopped`. */
bool plb_ps_stop(ps *p);
bool plb_ps_make_errordict(ps *p);

/* ps_state.c */
bool plb_ps_save_state(ps *p);
void plb_ps_restore_state(ps *p);
void plb_ps_restore_to(ps *p, uint32_t count);
bool plb_ps_init_state(ps *p);
void plb_ps_reset_graphics(ps *p);

/* ps_gstate.c */
void plb_ps_free_kept_states(ps *p);

/* ps_matrix.c */
bool plb_ps_get_matrix(ps *p, ps_object o, matrix *m);
void plb_ps_put_matrix(ps_object array, matrix m);
/* Refuses a matrix that is not finite. */
bool plb_ps_set_ctm(ps *p, matrix m);
bool plb_ps_inverse_ctm(ps *p, matrix *m);
double plb_ps_sin(double degrees);
double plb_ps_cos(double degrees);

/* ps_path.c: points are in user space. */
bool plb_ps_move(ps *p, point to);
bool plb_ps_line(ps *p, point to);
/* Adds a closed rectangle as a subpath of its own. */
bool plb_ps_rectangle(ps *p, point corner, double width, double height);
bool plb_ps_new_path(ps *p);
void plb_ps_release_path(ps *p, ps_path *shared);
/* Makes `with` (device space, moved in, emptied) the current path. */
bool plb_ps_replace_path(ps *p, path *with);
/* Gives the current point in user space; false: nocurrentpoint raised. */
bool plb_ps_current_point(ps *p, point *at);

/* ps_paint.c, ps_clip.c: these use up the current path. */
bool plb_ps_paint_path(ps *p, item_kind kind, bool even_odd);
bool plb_ps_clip_to_path(ps *p, bool even_odd);
/* Gives the bounds of the clip in device space; those of the page where there is no clip. */
box plb_ps_clip_bounds(ps *p);
/* ps_pattern.c: begins to fill the current path with the tiles of the pattern; `done` false: it cannot be so filled. */
bool plb_ps_fill_with_tiles(ps *p, bool even_odd, bool *done);

/* ps_text.c */
bool plb_ps_make_fonts(ps *p);
bool plb_ps_define_font(ps *p, ps_object key, ps_object font);
bool plb_ps_find_font(ps *p, ps_object key, ps_object *font);
/* These calls note what a Type 3 glyph that is being drawn does: says its width, paints with an image. */
void plb_ps_note_glyph_width(ps *p, point width);
void plb_ps_note_glyph_image(ps *p);

/* ps_system.c: dictionaries, operators and fonts. */
bool plb_ps_make_system(ps *p);

/* ps_page.c */
bool plb_ps_page_has_something(const ps *p);
/* Counts what the display list grows by; false: limit reached. */
bool plb_ps_count_list(ps *p, const path *shape);
/* Counts a mark. False: the page is complete already, the reading ends with this second one. */
bool plb_ps_may_mark(ps *p);
/* Counts an item that would leave a mark and is left out. */
void plb_ps_omit(ps *p, omission_kind kind);
/* Leaves the operator under way to Ghostscript. */
void plb_ps_note_left(ps *p);
/* Leaves the operator to Ghostscript where it would leave a mark: true when the reading ends here, for Ghostscript to take over. */
bool plb_ps_leave_to_ghostscript(ps *p, omission_kind kind);
bool plb_ps_set_page_size(ps *p, double width, double height);

/* ps_colour.c: gives the number of components of a colour space. */
unsigned plb_ps_components(ps *p, ps_object space);

/* The operator tables, each ended by a NULL name. */
extern const ps_operator plb_ps_stack_operators[], plb_ps_arithmetic_operators[], plb_ps_relation_operators[],
    plb_ps_control_operators[], plb_ps_array_operators[], plb_ps_dict_operators[], plb_ps_string_operators[],
    plb_ps_type_operators[], plb_ps_file_operators[], plb_ps_matrix_operators[],
    plb_ps_state_operators[], plb_ps_gstate_operators[], plb_ps_colour_operators[], plb_ps_path_operators[], plb_ps_whole_path_operators[],
    plb_ps_paint_operators[], plb_ps_clip_operators[], plb_ps_pattern_operators[], plb_ps_font_operators[], plb_ps_text_operators[], plb_ps_image_operators[],
    plb_ps_page_operators[], plb_ps_foreign_operators[], plb_ps_system_operators[];

#endif
