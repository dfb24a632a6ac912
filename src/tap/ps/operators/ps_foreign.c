/* SPDX-License-Identifier: MIT
 *
 * Leaves operators to Ghostscript, which serves them better than a second interpreter could: filters, whose data only a
 * decoder sees the end of, and resources, which come from outside the file (PLRM, sections 3.9 and 3.13). The first of
 * them ends the reading before anything is written. Where nobody can take over they are errors.
 */
#include "tap/ps/ps.h"

static bool op_leave_to_ghostscript(ps *p)
{
    if (p->ask->alone)
        return plb_ps_explain(p, PS_UNDEFINED, "the PostScript operator '%s' is not known to this program", p->op->name);
    plb_ps_note_left(p);
    p->handed_over = !p->page_shown;
    return p->finished = true;
}

const ps_operator plb_ps_foreign_operators[] = {
    {"filter", "", op_leave_to_ghostscript},
    {"findresource", "", op_leave_to_ghostscript},
    {"defineresource", "", op_leave_to_ghostscript},
    {"undefineresource", "", op_leave_to_ghostscript},
    {"resourcestatus", "", op_leave_to_ghostscript},
    {"resourceforall", "", op_leave_to_ghostscript},
    {"composefont", "", op_leave_to_ghostscript},
    {NULL, NULL, NULL},
};
