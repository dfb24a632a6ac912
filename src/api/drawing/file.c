/* SPDX-License-Identifier: MIT
 *
 * Reads files into memory, tells how many pages they have and loads one of them.
 */
#include "api/pipeline.h"

#include "base/array.h"

#include <string.h>

struct plb_file {
    char *name; /* as messages show it */
    char *data;
    size_t size;
};

/* Copies the source without its bytes. */
static plb_file *new_file(const char *name, error *err)
{
    plb_file *f = plb_new(1, sizeof *f);
    if (f)
        f->name = plb_new(strlen(name) + 1, 1);
    if (f && f->name)
        return strcpy(f->name, name), f;
    plb_fail_memory(err);
    plb_file_free(f);
    return NULL;
}

static plb_file *load_file(const char *name, error *err)
{
    plb_file *f = new_file(strcmp(name, "-") ? name : "standard input", err);
    if (f && plb_input_load(name, &f->data, &f->size, err))
        return f;
    plb_file_free(f);
    return NULL;
}

static plb_file *copy_bytes(const void *data, size_t size, const char *name, error *err)
{
    plb_file *f = new_file(name, err);
    if (f && size <= INPUT_MAX_BYTES && (f->data = plb_new(size + 1, 1))) {
        memcpy(f->data, data, size);
        f->size = size;
        return f;
    }
    if (f && size > INPUT_MAX_BYTES)
        plb_fail(err, ERROR_LIMIT, "%s: more than %zu MiB", name, INPUT_MAX_BYTES >> 20);
    plb_fail_memory(err);
    plb_file_free(f);
    return NULL;
}

plb_file *plb_file_load(const char *name, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_file *f = load_file(name, &err);
    plb_api_finish(&err, failed);
    return f;
}

plb_file *plb_file_from_memory(const void *data, size_t size, const char *name, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_file *f = copy_bytes(data, size, name ? name : "memory", &err);
    plb_api_finish(&err, failed);
    return f;
}

void plb_file_free(plb_file *f)
{
    if (!f)
        return;
    plb_free(f->name);
    plb_free(f->data);
    plb_free(f);
}

static model_look look_of(const plb_options *o)
{
    return (model_look){.has_view = o->view.word != ANGLES_AUTO, .view = {o->view.a, o->view.b}, .perspective = o->projection.a,
                        .has_light = o->light.word != ANGLES_AUTO, .is_dark = o->light.word == MODEL_DARK, .light = {o->light.a, o->light.b},
                        .crease = o->crease, .up = (model_up)o->up, .hidden = (model_hidden)o->hidden, .sheet = (model_sheet)o->sheet};
}

/* A reading lives as long as its source. */
typedef struct {
    const plb_options *o;
    api_adaptor adaptor;
    double spent;        /* processor time of the programs that read */
    unsigned long asked; /* how often the caller was */
} reading;

/* Half of PROGRESS_READ: after how many ticks that is told. Nobody knows how long a program will read; two seconds is much. */
#define TICKS_OF_HALF 100.0

/* Tells the caller, while a program reads, that it does; false: the caller says stop. */
static bool may_go_on(void *closure)
{
    reading *r = closure;
    double asked = (double)++r->asked;
    error stopped = {ERROR_NONE, ""};
    return plb_api_report(r->o, PROGRESS_READ * asked / (asked + TICKS_OF_HALF), &stopped);
}

/* Makes the input source of the page that the options name; `r` lives as long as the source. */
static input_source source_of(const plb_file *f, const plb_options *o, reading *r)
{
    *r = (reading){.o = o, .adaptor = {o->message, o->message_closure}};
    return (input_source){.name = f->name, .data = f->data, .size = f->size, .helper_dir = o->helper_dir,
                          .say = plb_api_messenger(&r->adaptor), .page = (unsigned)o->page, .look = look_of(o),
                          .limits = {.seconds = o->limit_time, .spent = &r->spent, .memory = (size_t)o->limit_memory << 20,
                                     .may_go_on = may_go_on, .closure = r}};
}

unsigned plb_file_pages(const plb_file *f, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    unsigned pages = 0;
    reading r;
    plb_options *own;
    const plb_options *o = plb_api_options_checked(given, &own, &err);
    if (o) {
        input_source in = source_of(f, o, &r);
        pages = plb_input_count_pages(&in, &pages, &err) ? pages : 0;
    }
    plb_options_free(own);
    plb_api_finish(&err, failed);
    return pages;
}

plb_drawing *plb_file_draw(const plb_file *f, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    reading r;
    plb_drawing *d = NULL;
    plb_options *own;
    const plb_options *o = plb_api_options_checked(given, &own, &err);
    if (o) {
        input_source in = source_of(f, o, &r);
        d = plb_api_draw(&in, o, &err);
    }
    plb_options_free(own);
    plb_api_finish(&err, failed);
    return d;
}

plb_drawing *plb_drawing_load(const char *file, const plb_options *o, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    plb_file *f = !o || plb_api_check(o, &err) ? load_file(file, &err) : NULL;
    plb_api_finish(&err, failed);
    plb_drawing *d = f ? plb_file_draw(f, o, failed) : NULL;
    plb_file_free(f);
    return d;
}
