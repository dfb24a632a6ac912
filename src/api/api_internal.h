/* SPDX-License-Identifier: MIT
 *
 * The files of the interface share the insides of the opaque types, and the way from the library's own errors and
 * messages to the caller's.
 */
#ifndef PLB_API_API_INTERNAL_H
#define PLB_API_API_INTERNAL_H

#include "api/plumbago.h"
#include "api/settings/settings.h"
#include "base/error.h"
#include "list/display_list.h"
#include "list/stroke_list.h"
#include "profile/profile.h"

#include <stdatomic.h>

typedef struct pencil_rack pencil_rack; /* see pencils.h */

struct plb_profile {
    profile *p;
    pencil_rack *pencil_cache; /* what has been made from it */
    atomic_size_t references;  /* the caller's, and one for each of the options that hold it */
};

/* Gives the same pencil once more, to be released by plb_profile_free. */
plb_profile *plb_api_profile_share(const plb_profile *pencil);

/* Gives an empty drawing; NULL when out of memory. */
pencil_rack *plb_api_rack_new(void);
void plb_api_rack_free(pencil_rack *r);

struct plb_drawing {
    char *name;           /* of its file, for messages */
    plb_options *options; /* it was loaded with; owned */
    plb_profile *soft;    /* the pencil of its soft strokes; owned; NULL: there are none */
    display_list list;    /* on the page */
    double reduction;     /* the sheet that the hand works on is so many times larger than the page: 1 to REDUCTION_MAX */
    stroke_list strokes;  /* on the sheet, mm there */
    point *page_points;   /* owned: the strokes' points on the page, mm; NULL where the page is the sheet */
};

/* Copies `from` to the caller's error (may be NULL). Returns false, for `return plb_api_fail(...)`. */
bool plb_api_fail(plb_error *to, const error *from);

/* Ends a call: true when `from` holds no error, and the caller's error is cleared; else as plb_api_fail. */
bool plb_api_finish(const error *from, plb_error *to);

/* Reading ends at the first share of the progress that callers are told, planning at the second (chosen by eye). */
#define PROGRESS_READ 0.1
#define PROGRESS_PLANNED 0.2
/* Tells the caller how much is done; false and `err` when the caller says stop. */
bool plb_api_report(const plb_options *o, double done, error *err);

/* Makes a log_sink of the caller's message function: `adaptor` must outlive the sink that plb_api_messenger returns. */
typedef struct {
    plb_message_function message;
    void *closure;
} api_adaptor;
log_sink plb_api_messenger(const api_adaptor *adaptor);

#endif
