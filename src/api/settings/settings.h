/* SPDX-License-Identifier: MIT
 *
 * The settings of a drawing: one table (settings_table.c) says of each its name, kind, range, default, help and the calls in
 * which it counts. The command line, --help, the manual's test, the shells' completions, the checks of the library and the
 * text in a PNG all read these rows. Here is what only the library sees: where the values lie.
 */
#ifndef PLB_API_SETTINGS_SETTINGS_H
#define PLB_API_SETTINGS_SETTINGS_H

#include "api/plumbago.h"
#include "base/error.h"

/* `arm` has this value while the model decides. */
#define ARM_AUTO (-1)

/* The pencil's point is sharpened while one draws, or stays as it was when its lines were captured. */
typedef enum { POINT_SHARP, POINT_BLUNT } pencil_point;

/* Darks that the pencil cannot make are shaded with a softer one, with the same, or with a grade that is named. */
typedef enum { SHADE_AUTO, SHADE_SAME, SHADE_GRADES } pencil_shade;

/* A page_choice is a page by its name: its sides upright, mm, and how the page lies. */
typedef enum { PAGE_AS_DRAWN, PAGE_PORTRAIT, PAGE_LANDSCAPE } page_turn;
typedef struct {
    double width, height; /* 0: no name is given */
    page_turn turn;
} page_choice;

/* The size of the picture, pixels; height 0: the height follows from the width; both 0: the resolution decides. */
typedef struct {
    int width, height;
} picture_pixels;

/* Angles, degrees, by a word or by numbers. */
#define ANGLES_GIVEN (-2)
#define ANGLES_AUTO (-1)
typedef struct {
    int word;      /* the value of the row's word, ANGLES_GIVEN or ANGLES_AUTO */
    double a, b;
} angle_choice;

/* The options hold all values, each in a field that a row of the table names. Lengths are mm. */
struct plb_options {
    plb_profile *profile; /* a reference of its own; never NULL */
    uint64_t seed;
    /* Choices: values of the enumeration that is named. */
    int paper;            /* paper_kind */
    int model;            /* a row of the models (models.h) */
    int arm;              /* a row of the arms (arm.h), or ARM_AUTO */
    int handed;           /* handedness */
    int fill;             /* fill_style */
    int text;             /* text_style */
    int lettering;        /* lettering_style */
    int ruler;            /* ruler_use */
    int background;       /* page_background */
    int point;            /* pencil_point */
    int shade;            /* pencil_shade, or from SHADE_GRADES on a grade */
    int up, hidden, sheet; /* of solid models: model_up, model_hidden, model_sheet (input.h) */
    angle_choice view, projection, light; /* azimuth and elevation; a: how much is in view, 0: parallel; word MODEL_DARK: no light */
    double crease;        /* degrees */
    double pressure;
    double squiggle;      /* negative: the arm's own */
    double dpi;
    double width, height, scale; /* 0: the drawing's own */
    double margin;
    double reduction;     /* 0: as what is small on the page needs */
    page_choice page_size;
    picture_pixels pixels;
    double overshoot, restate;
    bool construction, colour;
    int threads;          /* 0: as many as there are processors */
    int compress;
    int fps, boil, hold;  /* of films */
    int loop;             /* 0: for ever; negative: as the film is */
    double duration, pause; /* s */
    int page;             /* from 1; 0: the first */
    double limit_time, limit_memory, limit_length; /* s, MiB, m */
    char *helper_dir;     /* owned; NULL: beside the program, then the installed place */
    plb_message_function message;
    void *message_closure;
    plb_progress_function progress;
    void *progress_closure;
};

/* A word that a setting takes has a meaning: a value of an enumeration; of a page, its sides, mm; of angles, these, degrees. */
typedef struct {
    const char *name;
    int value;
    double width, height;
} setting_word;

/* A setting is a row of the table. */
typedef struct {
    plb_setting shown;
    size_t offset;     /* of its field in plb_options, whose type goes by the kind */
    const setting_word *words;           /* of a choice; the last has no name */
    const char *(*word)(size_t index);   /* of a choice among the rows of a table of the library's, whose index is the value */
    double automatic;  /* what the field holds for the word "auto", where that is the default */
} setting;

/* Gives the row of that name; NULL: there is none. */
const setting *plb_setting_find(const char *name);
/* Gives the row at `index`; NULL past the last. */
const setting *plb_setting_row(size_t index);

/* Gives the word at `index`; its name is NULL past the last. */
setting_word plb_setting_word_at(const setting *s, size_t index);

/* Reads `value` by the row's kind and stores the result; false, and `err` says what the setting takes, when the value is refused. */
bool plb_setting_store(const setting *s, plb_options *o, const char *value, error *err);
/* Writes the value as text that plb_setting_store reads. False when `size` is too small. */
bool plb_setting_print(const setting *s, const plb_options *o, char *text, size_t size);
/* Tells whether both options hold the same value. */
bool plb_setting_is_equal(const setting *s, const plb_options *a, const plb_options *b);

/* Tells whether the setting holds its default. */
bool plb_setting_is_usual(const setting *s, const plb_options *o);

/* Tells whether the settings go together. */
bool plb_api_check(const plb_options *o, error *err);
/* Tells whether `o`, given to a call that draws, goes with the options that the drawing was loaded with: what counts
 * for loading must not differ. `name` is the drawing's. */
bool plb_api_check_same(const plb_options *o, const plb_options *loaded, const char *name, error *err);

#endif
