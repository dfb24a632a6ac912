/* SPDX-License-Identifier: MIT
 *
 * Files in memory and the pages in them.
 */
#include "api/pipeline.h"

#include "base/array.h"

#include <string.h>

struct plb_file {
    char *name; /* as messages show it */
    char *data;
    size_t size;
};

static bool load(plb_file *f, const char *name, error *err)
{
    const char *shown = strcmp(name, "-") ? name : "standard input";
    f->name = plb_new(strlen(shown) + 1, 1);
    if (!f->name)
        return plb_fail_memory(err);
    strcpy(f->name, shown);
    return plb_input_load(name, &f->data, &f->size, err);
}

static plb_file *load_file(const char *name, error *err)
{
    plb_file *f = plb_new(1, sizeof *f);
    if (!f)
        plb_fail_memory(err);
    if (f && load(f, name, err))
        return f;
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

void plb_file_free(plb_file *f)
{
    if (!f)
        return;
    plb_free(f->name);
    plb_free(f->data);
    plb_free(f);
}

/* `spent`: 0, lives as long as the source. */
static input_source source_of(const plb_file *f, const plb_options *o, const api_adaptor *adaptor, double *spent)
{
    return (input_source){.name = f->name, .data = f->data, .size = f->size, .helper_dir = o->helper_dir,
                          .say = plb_api_messenger(adaptor), .page = (unsigned)o->page,
                          .limits = {.seconds = o->limit_time, .spent = spent, .memory = (size_t)o->limit_memory << 20}};
}

/* The caller's options or, in `own`, new ones; NULL and `err` when they do not go together. */
static const plb_options *checked(const plb_options *given, plb_options **own, error *err)
{
    *own = given ? NULL : plb_options_new();
    const plb_options *o = given ? given : *own;
    if (!o)
        plb_fail_memory(err);
    return o && plb_api_check(o, err) ? o : NULL;
}

unsigned plb_file_pages(const plb_file *f, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    unsigned pages = 0;
    double spent = 0;
    plb_options *own;
    const plb_options *o = checked(given, &own, &err);
    if (o) {
        api_adaptor adaptor = {o->message, o->message_closure};
        input_source in = source_of(f, o, &adaptor, &spent);
        pages = plb_input_count_pages(&in, &pages, &err) ? pages : 0;
    }
    plb_options_free(own);
    plb_api_finish(&err, failed);
    return pages;
}

plb_drawing *plb_file_draw(const plb_file *f, const plb_options *given, plb_error *failed)
{
    error err = {ERROR_NONE, ""};
    double spent = 0;
    plb_drawing *d = NULL;
    plb_options *own;
    const plb_options *o = checked(given, &own, &err);
    if (o) {
        api_adaptor adaptor = {o->message, o->message_closure};
        input_source in = source_of(f, o, &adaptor, &spent);
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
