/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/steps.h"

xmlNode *plb_rewrite_wrap(rewriting *r, xmlNode *n, bool whole)
{
    static const char *const moved[] = {"transform", "opacity", "mask", "filter", "clip-path"};
    xmlNode *group = plb_node_wrap(n);
    r->changed = true;
    for (size_t i = 0; i < (whole ? G_N_ELEMENTS(moved) : 1); i++) {
        char *value = plb_css_value(r->sheet, n, moved[i]);
        if (value && i == 0)
            plb_node_set(group, moved[i], value);
        else if (value)
            plb_css_set(group, moved[i], value);
        if (value) {
            plb_css_set(n, moved[i], NULL);
            if (i > 0)
                plb_css_set(n, moved[i], i == 1 ? "1" : "none"); /* a rule may say it as well */
        }
        g_free(value);
    }
    return group;
}
