/* SPDX-License-Identifier: MIT */
#include "tap/svg/rewrite/rewrite.h"

#include "tap/common/tap_page.h"
#include "tap/svg/rewrite/steps.h"

#include <libxml/parser.h>
#include <string.h>

/* Tells whether an attribute among `tag`[0..size) holds more than one number: " x=" and the like, with blanks or commas inside. */
static bool has_list(const char *tag, size_t size)
{
    static const char *const names[] = {" x=", " y=", " dx=", " dy="};
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++) {
        const char *at = g_strstr_len(tag, (gssize)size, names[i]);
        const char *open = at ? at + strlen(names[i]) : NULL, *end = tag + size;
        const char *close = open && open < end ? memchr(open + 1, *open, (size_t)(end - open - 1)) : NULL;
        for (const char *c = open; close && c < close; c++)
            if (*c == ' ' || *c == ',')
                return true;
    }
    return false;
}

/* Tells whether a tag that starts with `start` has what `test` asks for. */
static bool any_tag(const char *text, size_t size, const char *start, bool (*test)(const char *tag, size_t size))
{
    const char *end = text + size;
    for (const char *at = text; (at = g_strstr_len(at, end - at, start));) {
        const char *close = memchr(at, '>', (size_t)(end - at));
        if (!close)
            return false;
        if (test(at, (size_t)(close - at)))
            return true;
        at = close;
    }
    return false;
}

static bool has_clip(const char *tag, size_t size) { return g_strstr_len(tag, (gssize)size, "clip-path") != NULL; }

bool plb_rewrite_is_due(const char *text, size_t size)
{
    static const char *const words[] = {"var(", "oklch(", "oklab(", "lch(", "lab(", "hwb(", "color(", "color-mix(", "light-dark(", "path(",
                                        "textPath", "textLength", "rotate=", "pathLength", "non-scaling-stroke", "transform-origin",
                                        "transform-box", "foreignObject", "<switch", "<image", "data:image/svg", "<mask", "<pattern", "<filter", "filter:", "xml-stylesheet"};
    if (!size) /* there may be no text at all, only NULL */
        return false;
    for (size_t i = 0; i < G_N_ELEMENTS(words); i++)
        if (g_strstr_len(text, (gssize)size, words[i]))
            return true;
    return any_tag(text, size, "<clipPath", has_clip) || any_tag(text, size, "<text", has_list) || any_tag(text, size, "<tspan", has_list);
}

/* Gives the name that <?xml-stylesheet href="..."?> has, unless the sheet lies in the document. */
static char *find_style_sheet(const xmlDoc *doc)
{
    for (const xmlNode *n = doc->children; n; n = n->next) {
        if (n->type != XML_PI_NODE || strcmp((const char *)n->name, "xml-stylesheet") != 0 || !n->content)
            continue;
        const char *href = strstr((const char *)n->content, "href="), *open = href ? href + 5 : NULL;
        const char *close = open && *open ? strchr(open + 1, *open) : NULL;
        if (close && open[1] != '#')
            return g_strndup(open + 1, (gsize)(close - open - 1));
    }
    return NULL;
}

/* The table of contents. Values come first, since the others ask for them; what brings new elements comes before what looks
 * at all of them. */
static void run_steps(rewriting *r)
{
    plb_rewrite_images(r);
    plb_rewrite_values(r);
    plb_rewrite_labels(r);
    plb_rewrite_transforms(r);
    plb_rewrite_strokes(r);
    plb_rewrite_text(r);
    plb_rewrite_filters(r);
    plb_rewrite_masks(r);
    plb_rewrite_patterns(r);
}

GByteArray *plb_rewrite(const char *text, size_t size, rewrite_report *report)
{
    int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_NOENT | (size > TAP_LIBXML_TEXT ? XML_PARSE_HUGE : 0);
    xmlDoc *doc = xmlReadMemory(text, (int)size, NULL, NULL, options);
    if (!doc || !xmlDocGetRootElement(doc)) {
        xmlFreeDoc(doc);
        return NULL;
    }
    rewriting r = {.doc = doc, .sheet = plb_css_new(doc), .ids = plb_node_ids(doc), .report = report};
    report->style_sheet = find_style_sheet(doc);
    run_steps(&r);
    xmlChar *out = NULL;
    int length = 0;
    if (r.changed)
        xmlDocDumpMemoryEnc(doc, &out, &length, "UTF-8");
    GByteArray *made = out ? g_byte_array_append(g_byte_array_new(), out, (guint)length) : NULL;
    xmlFree(out);
    plb_css_free(r.sheet);
    g_hash_table_destroy(r.ids);
    xmlFreeDoc(doc);
    return made;
}
