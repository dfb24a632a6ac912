/* SPDX-License-Identifier: MIT
 *
 * This file is the public interface to pencils: loading, figures, capture, reports.
 */
#include "api/api_internal.h"
#include "api/plumbago.h"
#include "api/pencil/sample.h"
#include "base/array.h"
#include "base/number/units.h"
#include "profile/profile.h"
#include "surface/picture/picture.h"
#include "surface/plot/profile_plot.h"

#include <errno.h>
#include <string.h>

const char *plb_pencil_name(size_t index)
{
    return plb_profile_grade(index);
}

/* Hands out a profile that was made (or, when NULL, the reason why not). */
static plb_profile *wrap(profile *p, error *failed, plb_error *to)
{
    plb_profile *out = p ? plb_new(1, sizeof *out) : NULL;
    pencil_rack *pencil_cache = out ? plb_api_rack_new() : NULL;
    if (pencil_cache) {
        *out = (plb_profile){p, pencil_cache, 1};
        plb_api_finish(failed, to);
        return out;
    }
    if (p)
        plb_fail_memory(failed);
    plb_free(out);
    plb_profile_release(p);
    plb_api_fail(to, failed);
    return NULL;
}

plb_profile *plb_profile_load(const char *pencil, plb_error *to)
{
    error failed = {0};
    return wrap(plb_profile_read(pencil, &failed), &failed, to);
}

plb_profile *plb_profile_from_memory(const void *data, size_t size, const char *name, plb_error *to)
{
    error failed = {0};
    return wrap(plb_profile_parse(name ? name : "memory", data, size, &failed), &failed, to);
}

void plb_profile_free(plb_profile *pencil)
{
    if (!pencil || atomic_fetch_sub(&pencil->references, 1) > 1)
        return;
    plb_api_rack_free(pencil->pencil_cache);
    plb_profile_release(pencil->p);
    plb_free(pencil);
}

plb_profile *plb_api_profile_share(const plb_profile *pencil)
{
    plb_profile *shared = (plb_profile *)(uintptr_t)pencil; /* the count is all that ever changes in a profile */
    atomic_fetch_add(&shared->references, 1);
    return shared;
}

const char *plb_profile_name(const plb_profile *pencil)
{
    return pencil->p->name;
}

int plb_profile_centre_grey(const plb_profile *pencil)
{
    return plb_profile_centre(pencil->p);
}

double plb_profile_width(const plb_profile *pencil)
{
    return pencil->p->width_half / pencil->p->dpi * MM_PER_INCH;
}

plb_capture_options plb_capture_options_default(void)
{
    capture_options inside = plb_capture_defaults();
    return (plb_capture_options){.centre_min = inside.centre_min, .centre_max = inside.centre_max};
}

plb_profile *plb_profile_capture(const char *const scans[], size_t n, const plb_capture_options *options, plb_error *to)
{
    error failed = {0};
    plb_capture_options given = options ? *options : plb_capture_options_default();
    api_adaptor adaptor = {given.message, given.closure};
    capture_options inside = plb_capture_defaults();
    if (given.name)
        inside.name = given.name;
    if (given.provenance)
        inside.provenance = given.provenance;
    inside.dpi = given.dpi;
    inside.centre_min = given.centre_min;
    inside.centre_max = given.centre_max;
    inside.width = given.width;
    inside.grain = given.grain ? &given.grain->p->grain : NULL;
    inside.free_hand = given.free_hand;
    inside.sample = given.as_measured ? NULL : plb_api_sample;
    inside.say = plb_api_messenger(&adaptor);
    return wrap(plb_capture(scans, n, &inside, &failed), &failed, to);
}

bool plb_profile_save(const plb_profile *pencil, const char *file, plb_error *to)
{
    error failed = {0};
    plb_profile_write(pencil->p, file, &failed);
    return plb_api_finish(&failed, to);
}

/* The reports go to a stream of the caller's. */
static bool written(bool good, plb_error *to)
{
    error failed = {0};
    if (!good)
        plb_fail(&failed, ERROR_FILE, "the report cannot be written: %s", strerror(errno));
    return plb_api_finish(&failed, to);
}

bool plb_profile_show(const plb_profile *pencil, FILE *stream, plb_error *to)
{
    return written(plb_profile_print(pencil->p, stream), to);
}

bool plb_profile_compare(const plb_profile *a, const plb_profile *b, FILE *stream, plb_error *to)
{
    return written(plb_profile_print_difference(a->p, b->p, stream), to);
}

bool plb_profile_plot(const plb_profile *pencil, const char *file, plb_error *to)
{
    error failed = {0};
    if (plb_picture_format_suits(plb_picture_format_named("png"), file, &failed))
        plb_profile_draw(pencil->p, file, &failed);
    return plb_api_finish(&failed, to);
}
