/* SPDX-License-Identifier: MIT
 *
 * The table of settings: see settings.h. To add one: a field in plb_options, a row here, its paragraph in plumbago(1).
 */
#include "api/settings/settings.h"

#include "film/film.h"
#include "input/input.h"
#include "plan/plan.h"
#include "plan/reduction/reduction.h"
#include "stroke/stroke.h"
#include "surface/page.h"

#include <string.h>

#define FIELD(f) .offset = offsetof(plb_options, f)
#define WORDS(...) .words = (const setting_word[]){__VA_ARGS__, {NULL, 0, 0, 0}}
#define WORD(name, value) {name, value, 0, 0}

enum { LOAD = PLB_COUNTS_LOADING, DRAW = PLB_COUNTS_DRAWING, FREE = PLB_COUNTS_FREELY };

static const char *arm_name(size_t i)
{
    const arm_model *arm = plb_arm_at(i);
    return arm ? arm->name : NULL;
}

static const char *model_name(size_t i)
{
    const line_model *model = plb_model_at(i);
    return model ? model->name : NULL;
}

static const char *shade_name(size_t i)
{
    static const char *const first[] = {[SHADE_AUTO] = "auto", [SHADE_SAME] = "same"};
    return i < SHADE_GRADES ? first[i] : plb_profile_grade(i - SHADE_GRADES);
}

/* The rows stand in the order of --help, whose headings are the groups. Ranges of lengths are mm. */
static const setting table[] = {
    {{"page", 0, "Input", PLB_SETTING_WHOLE, "N", 1, 1e6, "", "auto", "which page of a file with several; auto: the first", LOAD},
     FIELD(page)},
    {{"limit-time", 0, "Input", PLB_SETTING_NUMBER, "SECONDS", 1, 1e6, "seconds", "8", "processor time of the programs that read a drawing for us", LOAD | FREE},
     FIELD(limit_time)},
    {{"limit-memory", 0, "Input", PLB_SETTING_NUMBER, "MIB", 64, 1e6, "MiB", "1024", "memory of each program that reads for us", LOAD | FREE},
     FIELD(limit_memory)},
    {{"limit-length", 0, "Input", PLB_SETTING_NUMBER, "METRES", 1, 1e9, "m", "10000", "all pencil lines of one drawing together", LOAD | FREE},
     FIELD(limit_length)},
    {{"helper-dir", 0, "Input", PLB_SETTING_TEXT, "FOLDER", 0, 0, "", "", "where these programs lie [beside this one, or installed]", LOAD | FREE},
     FIELD(helper_dir)},

    {{"dpi", 'd', "Output", PLB_SETTING_NUMBER, "DPI", 10, 4800, "pixels per inch", "300", "resolution", DRAW},
     FIELD(dpi)},
    {{"pixels", 0, "Output", PLB_SETTING_PIXELS, "W|WxH", 1, 1e6, "pixels", "auto", "size of the picture, in place of a resolution; auto: by --dpi", LOAD | DRAW},
     FIELD(pixels)},
    {{"background", 0, "Output", PLB_SETTING_CHOICE, NULL, 0, 0, "", "white", "white, a sheet of toned paper, or nothing behind the graphite", DRAW},
     FIELD(background), WORDS(WORD("white", PAGE_WHITE), WORD("paper", PAGE_PAPER), WORD("none", PAGE_TRANSPARENT))},
    {{"compress", 0, "Output", PLB_SETTING_WHOLE, "N", 0, 9, "", "1", "0: large at once, 9: small and slow", DRAW},
     FIELD(compress)},

    {{"fps", 0, "Films", PLB_SETTING_WHOLE, "N", 1, FILM_RATE_MAX, "frames in a second", "25", "how smooth a film is", DRAW},
     FIELD(fps)},
    {{"duration", 0, "Films", PLB_SETTING_NUMBER, "SECONDS", 0.1, 3600, "seconds", "10", "how long it draws", DRAW},
     FIELD(duration)},
    {{"pause", 0, "Films", PLB_SETTING_NUMBER, "SECONDS", 0, 600, "seconds", "2", "how long the finished sheet is shown", DRAW},
     FIELD(pause)},
    {{"loop", 0, "Films", PLB_SETTING_WHOLE, "N", 0, 65535, "times", "auto", "how often it is shown; 0: for ever; auto: once, what boils for ever", DRAW},
     FIELD(loop), .automatic = -1},
    {{"boil", 0, "Films", PLB_SETTING_WHOLE, "N", 1, 100, "tracings", "1", "a loop of so many tracings in place of a drawing that draws itself", DRAW},
     FIELD(boil)},
    {{"hold", 0, "Films", PLB_SETTING_WHOLE, "N", 1, 1000, "frames", "2", "how long each tracing is shown", DRAW},
     FIELD(hold)},

    {{"width", 0, "Size on paper", PLB_SETTING_LENGTH, "LEN", 0.01, 1e5, "mm", "auto", "width of the page; auto: the drawing's own", LOAD},
     FIELD(width)},
    {{"height", 0, "Size on paper", PLB_SETTING_LENGTH, "LEN", 0.01, 1e5, "mm", "auto", "height of the page; auto: the drawing's own", LOAD},
     FIELD(height)},
    {{"scale", 0, "Size on paper", PLB_SETTING_RATIO, "F", 1e-6, 1e4, "times", "auto", "times its own size: 0.5 50% 1/2 1:2; auto: 1, or fits A3 (DXF)", LOAD},
     FIELD(scale)},
    {{"page-size", 0, "Size on paper", PLB_SETTING_PAGE, "NAME", 0, 0, "", "auto", "a sheet: A0 to A6, letter, legal, tabloid, lying as the drawing does; A4-portrait, A4-landscape: as they say; auto: the drawing's own", LOAD},
     FIELD(page_size),
     WORDS({"A0", 0, 841, 1189}, {"A1", 0, 594, 841}, {"A2", 0, 420, 594}, {"A3", 0, 297, 420}, {"A4", 0, 210, 297}, {"A5", 0, 148, 210}, {"A6", 0, 105, 148}, {"letter", 0, 215.9, 279.4}, {"legal", 0, 215.9, 355.6}, {"tabloid", 0, 279.4, 431.8})},
    {{"margin", 0, "Size on paper", PLB_SETTING_LENGTH, "LEN", 0, 1000, "mm", "0mm", "blank paper around the drawing", LOAD},
     FIELD(margin)},
    {{"reduction", 0, "Size on paper", PLB_SETTING_NUMBER, "F", 1, REDUCTION_MAX, "times", "auto", "the hand works on a sheet so many times larger than the page, which is reduced; auto: as what is small there needs", LOAD},
     FIELD(reduction)},

    {{"pencil", 'p', "Pencil", PLB_SETTING_PENCIL, "GRADE|FILE", 0, 0, "", "HB", "2H H F HB B 3B 6B 8B or a .pencil file", LOAD | DRAW},
     FIELD(profile)},
    {{"point", 0, "Pencil", PLB_SETTING_CHOICE, NULL, 0, 0, "", "sharp", "sharpened now and then (about 0.3 mm), or as the grade was captured", LOAD | DRAW},
     FIELD(point), WORDS(WORD("sharp", POINT_SHARP), WORD("blunt", POINT_BLUNT))},
    {{"shade", 0, "Pencil", PLB_SETTING_CHOICE, NULL, 0, 0, "", "auto", "pencil for what is too dark for this one; auto: as soft as needed", LOAD},
     FIELD(shade), .word = shade_name},
    {{"pressure", 0, "Pencil", PLB_SETTING_NUMBER, "F", 0.2, 3, "times the usual", "1", "paler and grainier, or darker", LOAD | DRAW},
     FIELD(pressure)},
    {{"paper", 0, "Pencil", PLB_SETTING_CHOICE, NULL, 0, 0, "", "medium", "the tooth of the paper, which all strokes share", LOAD | DRAW},
     FIELD(paper), WORDS(WORD("smooth", PAPER_SMOOTH), WORD("medium", PAPER_MEDIUM), WORD("rough", PAPER_ROUGH), WORD("none", PAPER_NONE))},

    {{"seed", 's', "Hand", PLB_SETTING_SEED, "SEED", 0, 0, "", "1", "a whole number: another hand for the same drawing", LOAD | DRAW},
     FIELD(seed)},
    {{"squiggle", 0, "Hand", PLB_SETTING_LENGTH, "LEN", 0, 1000, "mm", "auto", "how far lines stray; 0: ruler-straight; auto: as measured (5/300in)", LOAD | DRAW},
     FIELD(squiggle), .automatic = -1},
    {{"model", 0, "Hand", PLB_SETTING_CHOICE, NULL, 0, 0, "", "graphite", "how lines are made: graphite as measured, or the papers' algorithm", LOAD | DRAW},
     FIELD(model), .word = model_name},
    {{"arm", 0, "Hand", PLB_SETTING_CHOICE, NULL, 0, 0, "", "auto", "how the arm moves; auto: hand, with --model hla jerk", LOAD | DRAW},
     FIELD(arm), .word = arm_name, .automatic = ARM_AUTO},
    {{"hand", 0, "Hand", PLB_SETTING_CHOICE, NULL, 0, 0, "", "right", "which hand draws; none: all directions alike", LOAD | DRAW},
     FIELD(handed), WORDS(WORD("right", HANDED_RIGHT), WORD("left", HANDED_LEFT), WORD("none", HANDED_NONE))},
    {{"ruler", 0, "Hand", PLB_SETTING_CHOICE, NULL, 0, 0, "", "auto", "which straight lines are ruled; auto: long level and upright ones", LOAD},
     FIELD(ruler), WORDS(WORD("none", RULER_NONE), WORD("all", RULER_ALL)), .automatic = RULER_AUTO},
    {{"overshoot", 0, "Hand", PLB_SETTING_LENGTH, "LEN", 0, 100, "mm", "0mm", "lines run past corners by up to LEN", LOAD},
     FIELD(overshoot)},
    {{"restate", 0, "Hand", PLB_SETTING_NUMBER, "F", 0, 1, "", "0", "share of the long lines that are drawn twice, 0 to 1", LOAD},
     FIELD(restate)},
    {{"construction", 0, "Hand", PLB_SETTING_FLAG, NULL, 0, 0, "", "off", "faint construction lines beyond long lines, axes of circles", LOAD},
     FIELD(construction)},

    {{"fill", 0, "What is drawn", PLB_SETTING_CHOICE, NULL, 0, 0, "", "hatch", "what becomes of filled shapes", LOAD},
     FIELD(fill), WORDS(WORD("hatch", FILL_HATCH), WORD("outline", FILL_OUTLINE), WORD("none", FILL_NONE))},
    {{"text", 0, "What is drawn", PLB_SETTING_CHOICE, NULL, 0, 0, "", "hand", "what becomes of lettering", LOAD},
     FIELD(text), WORDS(WORD("hand", TEXT_HAND), WORD("outline", TEXT_OUTLINE), WORD("none", TEXT_NONE))},
    {{"lettering", 0, "What is drawn", PLB_SETTING_CHOICE, NULL, 0, 0, "", "font", "letters in the font's shapes, or known ones in a hand's alphabet", LOAD},
     FIELD(lettering), WORDS(WORD("font", LETTERING_FONT), WORD("hand", LETTERING_HAND))},
    {{"colour", 0, "What is drawn", PLB_SETTING_FLAG, NULL, 0, 0, "", "off", "each line with a pencil of its own colour, not all graphite (also --color)", LOAD | DRAW},
     FIELD(colour)},

    {{"view", 0, "Solid models", PLB_SETTING_ANGLES, "AZ,EL", -360, 360, "degrees", "auto", "seen from front, back, left, right, top, bottom, iso, or an angle to the right and above; auto: 35,22", LOAD},
     FIELD(view),
     WORDS({"front", 0, 0, 0}, {"back", 1, 180, 0}, {"left", 2, -90, 0}, {"right", 3, 90, 0}, {"top", 4, 0, 90}, {"bottom", 5, 0, -90}, {"iso", 6, 45, 35.264389682754654})},
    {{"projection", 0, "Solid models", PLB_SETTING_ANGLES, "parallel|perspective[=DEGREES]", 1, 140, "degrees", "parallel", "as engineers draw, or as one sees [perspective: 40]", LOAD},
     FIELD(projection), WORDS({"parallel", 0, 0, 0}, {"perspective", 1, 40, 0})},
    {{"up", 0, "Solid models", PLB_SETTING_CHOICE, NULL, 0, 0, "", "auto", "which axis of the file points upwards; auto: y, of STL z", LOAD},
     FIELD(up), WORDS(WORD("x", MODEL_UP_X), WORD("y", MODEL_UP_Y), WORD("z", MODEL_UP_Z)), .automatic = MODEL_UP_AUTO},
    {{"crease", 0, "Solid models", PLB_SETTING_NUMBER, "DEGREES", 1, 180, "degrees", "30", "sharper turns of a surface are lines", LOAD},
     FIELD(crease)},
    {{"hidden", 0, "Solid models", PLB_SETTING_CHOICE, NULL, 0, 0, "", "auto", "what becomes of hidden lines; auto: none, or dashed on a sheet", LOAD},
     FIELD(hidden), WORDS(WORD("none", MODEL_HIDDEN_NONE), WORD("dashed", MODEL_HIDDEN_DASHED), WORD("faint", MODEL_HIDDEN_FAINT)), .automatic = MODEL_HIDDEN_AUTO},
    {{"light", 0, "Solid models", PLB_SETTING_ANGLES, "AZ,EL|none", -360, 360, "degrees", "auto", "where it comes from, to the right of the eye and above; none: lines alone; auto: -40,45", LOAD},
     FIELD(light), WORDS({"none", MODEL_DARK, 0, 0})},
    {{"sheet", 0, "Solid models", PLB_SETTING_CHOICE, NULL, 0, 0, "", "none", "four views on a sheet, as ISO 128 places them", LOAD},
     FIELD(sheet), WORDS(WORD("none", MODEL_SHEET_NONE), WORD("first-angle", MODEL_SHEET_FIRST_ANGLE), WORD("third-angle", MODEL_SHEET_THIRD_ANGLE))},

    {{"threads", 0, "Work", PLB_SETTING_WHOLE, "N", 1, 64, "threads", "auto", "at most so many work; auto: as many as processors", LOAD | DRAW | FREE},
     FIELD(threads)},
};
#define ROWS (sizeof table / sizeof *table)

const setting *plb_setting_row(size_t index)
{
    return index < ROWS ? &table[index] : NULL;
}

const plb_setting *plb_setting_at(size_t index)
{
    return index < ROWS ? &table[index].shown : NULL;
}

const setting *plb_setting_find(const char *name)
{
    for (size_t i = 0; i < ROWS; i++)
        if (!strcmp(table[i].shown.name, name))
            return &table[i];
    return NULL;
}

setting_word plb_setting_word_at(const setting *s, size_t index)
{
    if (s->word)
        return (setting_word){.name = s->word(index), .value = (int)index};
    return s->words ? s->words[index] : (setting_word){0};
}

const char *plb_setting_word(const plb_setting *shown, size_t index)
{
    for (size_t i = 0; i < ROWS; i++)
        if (&table[i].shown == shown)
            return plb_setting_word_at(&table[i], index).name;
    return NULL;
}
