/* SPDX-License-Identifier: MIT */
#include "tap/svg/losses/missing_glyphs.h"

#include "tap/common/tap_page.h"
#include "tap/svg/rewrite/document/node.h"

#include <fontconfig/fontconfig.h>
#include <glib.h>
#include <libxml/parser.h>
#include <stdbool.h>
#include <string.h>

/* The sentence names so many characters. */
#define MAX_NAMED 4u

/* Tells whether the character is drawn at all, and may be missing: every font has ASCII. */
static bool is_drawn(gunichar c)
{
    GUnicodeType type = g_unichar_type(c);
    return c > 0x7f && type != G_UNICODE_CONTROL && type != G_UNICODE_FORMAT && type != G_UNICODE_NON_SPACING_MARK && !g_unichar_isspace(c) &&
           type != G_UNICODE_ENCLOSING_MARK;
}

/* Adds the characters of all text elements to a set. */
static void collect(xmlDoc *doc, FcCharSet *used)
{
    xmlNode *top = xmlDocGetRootElement(doc);
    for (xmlNode *n = top; n; n = plb_node_next(n, top)) {
        char *content = plb_node_is(n, "text") ? (char *)xmlNodeGetContent(n) : NULL;
        for (const char *at = content; at && *at; at = g_utf8_next_char(at))
            if (is_drawn(g_utf8_get_char(at)))
                FcCharSetAddChar(used, g_utf8_get_char(at));
        xmlFree(content);
    }
}

/* Gives the characters that no font has; the caller destroys the set. */
static FcCharSet *without_font(FcCharSet *used)
{
    const FcFontSet *fonts = FcConfigGetFonts(NULL, FcSetSystem);
    FcCharSet *left = FcCharSetCopy(used);
    for (int i = 0; fonts && i < fonts->nfont && FcCharSetCount(left); i++) {
        FcCharSet *has;
        if (FcPatternGetCharSet(fonts->fonts[i], FC_CHARSET, 0, &has) != FcResultMatch)
            continue;
        FcCharSet *rest = FcCharSetSubtract(left, has);
        FcCharSetDestroy(left);
        left = rest;
    }
    return left;
}

static char *sentence(const FcCharSet *missing)
{
    unsigned n = FcCharSetCount(missing), named = 0;
    FcChar32 map[FC_CHARSET_MAP_SIZE], next;
    GString *out = g_string_new(NULL);
    g_string_append_printf(out, n == 1 ? "no font here has a character of the text, which is drawn as a box:" : "no font here has %u characters of the text, which are drawn as boxes:", n);
    for (FcChar32 page = FcCharSetFirstPage(missing, map, &next); page != FC_CHARSET_DONE && named < MAX_NAMED; page = FcCharSetNextPage(missing, map, &next))
        for (unsigned k = 0; k < FC_CHARSET_MAP_SIZE * 32 && named < MAX_NAMED; k++)
            if (map[k / 32] >> k % 32 & 1)
                g_string_append_printf(out, "%s U+%04X", named++ ? "," : "", (unsigned)page + k);
    if (n > named)
        g_string_append(out, " …");
    return g_string_free(out, FALSE);
}

char *plb_tap_missing_glyphs(const char *text, size_t size)
{
    bool has_text = g_strstr_len(text, (gssize)size, "<text") || g_strstr_len(text, (gssize)size, ":text"), is_plain = true;
    for (size_t i = 0; i < size && is_plain; i++)
        is_plain = (unsigned char)text[i] < 0x80;
    if (!has_text || (is_plain && !g_strstr_len(text, (gssize)size, "&#")))
        return NULL;
    int options = XML_PARSE_RECOVER | XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | (size > TAP_LIBXML_TEXT ? XML_PARSE_HUGE : 0);
    xmlDoc *doc = xmlReadMemory(text, (int)size, NULL, NULL, options);
    FcCharSet *used = FcCharSetCreate();
    if (doc)
        collect(doc, used);
    FcCharSet *missing = without_font(used);
    char *said = FcCharSetCount(missing) ? sentence(missing) : NULL;
    FcCharSetDestroy(missing);
    FcCharSetDestroy(used);
    xmlFreeDoc(doc);
    return said;
}
