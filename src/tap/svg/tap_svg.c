/* SPDX-License-Identifier: MIT
 *
 * tap-svg: SVG or SVGZ on descriptor 0 becomes a display list (plumbago-list(5)) on descriptor 1. librsvg draws the
 * document on cairo's script surface, which writes down what is drawn, and cairoscript.h reads that while it is written. No
 * file is named, so none is opened. (Plain drawings do not come here: see tap_plain.c.)
 *
 *     tap-svg [--recover] [--no-text]
 *
 * --recover sends the document through libxml2's recovery parser first; --no-text leaves all text out. What else is left
 * out is counted (tap_omissions.h): images are pixels, masks and filters would turn lines into pixels.
 *
 * The page is turned while it is recorded, for two faults of cairo 1.16's script surface: it refuses filled outlines
 * of horizontal and vertical lines that are not boxes ("input path data not valid"), and aborts on boxes left of
 * -9999. No outline is rectilinear once turned by an odd angle. The turn is a style of the root element and not
 * cairo's own matrix, because librsvg takes the latter away again inside groups with opacity.
 */
#include "list/text/tap_status.h"
#include "tap/svg/losses/tap_omissions.h"
#include "tap/common/tap_page.h"
#include "tap/common/tap_stream.h"
#include "tap/svg/cairoscript.h"
#include "tap/svg/losses/missing_glyphs.h"
#include "tap/svg/rewrite/rewrite.h"
#include "tap/svg/typeset/typeset.h"

#include <cairo-script.h>
#include <fontconfig/fontconfig.h>
#include <libxml/parser.h>
#include <libxml/tree.h>
#include <librsvg/rsvg.h>

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PX_EMPTY 100.0                /* page of a drawing without size that draws nothing; chosen by eye */

static void __attribute__((noreturn, format(printf, 2, 3))) quit(int status, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    char text[400];
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    for (char *p = text; *p; p++) /* it may quote the document */
        *p = *p == '\n' || *p == '\r' ? ' ' : *p < ' ' || *p > '~' ? '?' : *p;
    fprintf(stderr, "%s\n", text);
    _exit(status);
}

/* libxml2's "... on line LINE column 7 of data: TEXT": the line goes to the front, where it belongs. */
static void __attribute__((noreturn)) quit_malformed(const char *message)
{
    static const char where[] = " on line ", what[] = " of data: ";
    const char *line = strstr(message, where), *text = line ? strstr(line, what) : NULL;
    if (!text)
        quit(TAP_MALFORMED, "%s", message);
    quit(TAP_MALFORMED, "%ld: not well-formed XML: %s", strtol(line + strlen(where), NULL, 10), text + strlen(what));
}

/* ---- output ------------------------------------------------------------------------------------------------ */

/* Writes bytes of the list to standard output. */
static bool put(void *closure, const char *data, size_t n)
{
    (void)closure;
    if (!plb_tap_put(data, n))
        _exit(TAP_WRITE);
    return true;
}

static void __attribute__((noreturn)) quit_for(const error *err)
{
    bool limit = err->kind == ERROR_LIMIT || err->kind == ERROR_MEMORY;
    quit(limit ? TAP_LIMIT : TAP_REFUSED, "%s%s", limit ? "" : "cannot read what cairo wrote: ", err->text);
}

/* A script_pipe gathers what cairo writes, number by number, and hands it to the reader in larger pieces. */
typedef struct {
    cairoscript *script;
    size_t n;
    char bytes[1 << 16];
} script_pipe;

static void empty(script_pipe *p)
{
    error err = {0};
    if (!plb_cairoscript_feed(p->script, p->bytes, p->n, &err))
        quit_for(&err);
    p->n = 0;
}

static cairo_status_t feed(void *closure, const unsigned char *data, unsigned n)
{
    script_pipe *p = closure;
    for (size_t part; n; n -= (unsigned)part, data += part) {
        if (p->n == sizeof p->bytes)
            empty(p);
        part = sizeof p->bytes - p->n < n ? sizeof p->bytes - p->n : n;
        memcpy(p->bytes + p->n, data, part);
        p->n += part;
    }
    return CAIRO_STATUS_SUCCESS;
}

static cairo_status_t discard(void *closure, const unsigned char *data, unsigned n)
{
    (void)closure;
    (void)data;
    (void)n;
    return CAIRO_STATUS_SUCCESS;
}

/* ---- input ------------------------------------------------------------------------------------------------ */

static GByteArray *read_stream(GInputStream *from)
{
    GByteArray *all = g_byte_array_new();
    unsigned char part[1 << 16];
    GError *fault = NULL;
    gssize n;
    while ((n = g_input_stream_read(from, part, sizeof part, NULL, &fault)) > 0) {
        if (all->len + (size_t)n > TAP_MAX_BYTES)
            quit(TAP_LIMIT, "the document is larger than %zu MB", TAP_MAX_BYTES >> 20);
        g_byte_array_append(all, part, (guint)n);
    }
    if (n < 0 && !all->len)
        quit(TAP_MALFORMED, "cannot unpack: %s", fault->message);
    return all; /* what came before the fault of a damaged file may still draw */
}

static GByteArray *read_document(void)
{
    size_t size;
    char *text = plb_tap_read_all(&size);
    if (!text || size > TAP_MAX_BYTES)
        quit(TAP_LIMIT, "the document is larger than %zu MB", TAP_MAX_BYTES >> 20);
    GByteArray *all = g_byte_array_new_take((guint8 *)text, size);
    if (all->len < 2 || all->data[0] != 0x1f || all->data[1] != 0x8b)
        return all;
    GInputStream *packed = g_memory_input_stream_new_from_data(all->data, (gssize)all->len, NULL);
    GConverter *unzip = G_CONVERTER(g_zlib_decompressor_new(G_ZLIB_COMPRESSOR_FORMAT_GZIP));
    return read_stream(g_converter_input_stream_new(packed, unzip));
}

/* Gives the place of the first `what` in text[from..size), or size. */
static size_t find(const GByteArray *text, size_t from, size_t to, const char *what)
{
    size_t n = strlen(what);
    while (from + n <= to) {
        const unsigned char *hit = memchr(text->data + from, what[0], to - from - n + 1);
        if (!hit)
            break;
        from = (size_t)(hit - text->data);
        if (!memcmp(hit, what, n))
            return from;
        from++;
    }
    return to;
}

static unsigned long count(const GByteArray *text, const char *const what[])
{
    unsigned long n = 0;
    for (; *what; what++)
        for (size_t at = 0; (at = find(text, at, text->len, *what)) < text->len; at++)
            n++;
    return n;
}

/* ---- recovery --------------------------------------------------------------------------------------------- */

static void silence(void *context, const char *format, ...)
{
    (void)context;
    (void)format;
}

/* Gives the next node in document order, not into entities. */
static xmlNode *following(xmlNode *n)
{
    if (n->type == XML_ELEMENT_NODE && n->children)
        return n->children;
    while (n && !n->next)
        n = n->parent;
    return n ? n->next : NULL;
}

/* Takes the references to entities out of the document's text: the cause of many a refusal. */
static void drop_references(xmlDoc *doc)
{
    for (xmlNode *n = xmlDocGetRootElement(doc), *next; n; n = next) {
        next = following(n);
        if (n->type == XML_ENTITY_REF_NODE) {
            xmlUnlinkNode(n);
            xmlFreeNode(n);
        }
    }
}

/* Gives the document in the form that libxml2's recovery parser understands: cut off where it must be, tags closed, no
 * entity expanded, nothing loaded. Bytes that are not the UTF-8 they claim to be are read as Latin-1. */
static GByteArray *recover(GByteArray *text)
{
    for (size_t i = 0; i < text->len; i++)
        if (text->data[i] < ' ' && text->data[i] != '\n' && text->data[i] != '\r' && text->data[i] != '\t')
            text->data[i] = ' ';
    bool utf8 = g_utf8_validate((const char *)text->data, (gssize)text->len, NULL);
    xmlSetGenericErrorFunc(NULL, silence);
    xmlDoc *doc = xmlReadMemory((const char *)text->data, (int)text->len, NULL, utf8 ? NULL : "ISO-8859-1",
                                XML_PARSE_RECOVER | XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
    if (!doc || !xmlDocGetRootElement(doc))
        quit(TAP_MALFORMED, "nothing to recover");
    drop_references(doc);
    xmlChar *mended = NULL;
    int size = 0;
    xmlDocDumpMemoryEnc(doc, &mended, &size, "UTF-8");
    if (!mended)
        quit(TAP_LIMIT, "out of memory");
    xmlFreeDoc(doc);
    GByteArray *result = g_byte_array_new();
    g_byte_array_append(result, mended, (guint)size);
    xmlFree(mended);
    return result;
}

/* ---- the document ----------------------------------------------------------------------------------------- */

static RsvgHandle *load(const GByteArray *text)
{
    GInputStream *stream = g_memory_input_stream_new_from_data(text->data, (gssize)text->len, NULL);
    RsvgHandleFlags flags = text->len > TAP_LIBXML_TEXT ? RSVG_HANDLE_FLAG_UNLIMITED : RSVG_HANDLE_FLAGS_NONE;
    GError *fault = NULL;
    RsvgHandle *svg = rsvg_handle_new_from_stream_sync(stream, NULL, flags, NULL, &fault);
    if (!svg)
        quit_malformed(fault->message);
    rsvg_handle_set_dpi(svg, 96);
    return svg;
}

/* Tells whether the document may turn its root element itself, by an attribute or a style rule, which win over ours. */
static bool root_is_transformed(const GByteArray *text)
{
    size_t at = find(text, 0, text->len, "svg");
    while (at < text->len && at > 0 && text->data[at - 1] != '<' && text->data[at - 1] != ':')
        at = find(text, at + 1, text->len, "svg");
    size_t end = find(text, at, text->len, ">");
    if (find(text, at, end, "transform") < end)
        return true;
    for (at = 0; (at = find(text, at, text->len, "<style")) < text->len; at = end) {
        end = find(text, at, text->len, "</style");
        if (find(text, at, end, "transform") < end &&
            (find(text, at, end, "svg") < end || find(text, at, end, ":root") < end))
            return true;
    }
    return false;
}

static double px_of_length(RsvgLength length)
{
    static const double px[] = {
        [RSVG_UNIT_PX] = 1,          [RSVG_UNIT_EM] = 16,         [RSVG_UNIT_EX] = 8,          [RSVG_UNIT_IN] = 96,
        [RSVG_UNIT_CM] = 96 / 2.54,  [RSVG_UNIT_MM] = 96 / 25.4,  [RSVG_UNIT_PT] = 96.0 / 72,  [RSVG_UNIT_PC] = 16,
    };
    return length.length * px[length.unit];
}

static tap_extent extent_of(RsvgLength length)
{
    bool is_share = length.unit == RSVG_UNIT_PERCENT;
    return (tap_extent){is_share ? length.length : px_of_length(length), is_share};
}

static bool size_by_attributes(RsvgHandle *svg, tap_page *p)
{
    RsvgLength w, h;
    RsvgRectangle view;
    gboolean has_w, has_h, has_box; /* librsvg always has width and height: 100 % where nothing is said */
    rsvg_handle_get_intrinsic_dimensions(svg, &has_w, &w, &has_h, &h, &has_box, &view);
    double size[2] = {view.width, view.height};
    return plb_tap_page_size(p, extent_of(w), extent_of(h), has_box ? size : NULL);
}

static void size_by_extents(RsvgHandle *svg, tap_page *p)
{
    RsvgRectangle viewport = {0, 0, PX_EMPTY, PX_EMPTY}, ink;
    p->by_extents = true;
    p->width = p->height = PX_EMPTY;
    if (!rsvg_handle_get_geometry_for_layer(svg, NULL, &viewport, &ink, NULL, NULL) || !(ink.width + ink.height > 0))
        return;
    p->x = ink.x;
    p->y = ink.y;
    p->width = ink.width > 0 ? ink.width : 1;
    p->height = ink.height > 0 ? ink.height : 1;
}

static tap_page find_page(RsvgHandle *svg)
{
    tap_page p = plb_tap_page();
    if (!size_by_attributes(svg, &p))
        size_by_extents(svg, &p);
    if (!plb_tap_page_is_there(&p))
        quit(TAP_REFUSED, "the drawing has no width or no height");
    if (!plb_tap_page_is_fit(&p))
        quit(TAP_REFUSED, "the drawing is larger than 100 m");
    return p;
}

/* ---- drawing ---------------------------------------------------------------------------------------------- */

/* Makes the style sheet: the turn (unless cairo does it), and what would only make pixels switched off: the drawing
 * behind masks and filters stays. Pattern tiles are drawn upright, out of the turn's reach, where strokes do no harm;
 * nobody reads them, but an empty tile would take the fill with it. */
static void set_style(RsvgHandle *svg, const tap_page *p, const tap_placing *l, double magnify, bool by_style, bool no_text)
{
    char style[700] = "", turn[200] = "";
    if (by_style)
        snprintf(turn, sizeof turn, ":root{transform:translate(%.9gpx,0px) rotate(%.9gdeg) scale(%.12g) translate(%.9gpx,%.9gpx)}",
                 l->turn.x0, TAP_TURN_DEGREES, magnify, -p->x, -p->y);
    snprintf(style, sizeof style, "%s*{filter:none!important;mask:none!important}image{display:none!important}"
             "pattern *{fill:none!important;stroke:#000!important;clip-path:none!important}%s", turn, no_text ? "text,tspan{display:none!important}" : "");
    GError *fault = NULL;
    if (!rsvg_handle_set_stylesheet(svg, (const guint8 *)style, strlen(style), &fault))
        quit(TAP_REFUSED, "%s", fault->message);
}

/* Draws into `sink`. False: cairo or librsvg refused; `why` says so. */
static bool draw(RsvgHandle *svg, const tap_page *p, bool by_style, bool no_text, cairo_write_func_t sink, void *closure, char why[200])
{
    tap_placing l = plb_tap_place(p);
    /* The viewport holds the turned page: librsvg makes the surfaces of groups as large as it. */
    double fit = by_style ? l.fit : 1;
    RsvgRectangle viewport = {0, 0, p->width * l.scale * fit, p->height * l.scale * fit};
    if (p->by_extents) /* nothing scales the drawing to a viewport: it has no viewBox */
        viewport = (RsvgRectangle){0, 0, PX_EMPTY, PX_EMPTY};
    set_style(svg, p, &l, p->by_extents ? l.scale : 1 / fit, by_style, no_text);
    cairo_device_t *script = cairo_script_create_for_stream(sink, closure);
    cairo_surface_t *surface = cairo_script_surface_create(script, CAIRO_CONTENT_COLOR_ALPHA, l.width, l.height);
    cairo_t *cr = cairo_create(surface);
    if (!by_style) {
        double k = p->by_extents ? l.scale : 1;
        cairo_matrix_t turn = {l.turn.xx, l.turn.yx, l.turn.xy, l.turn.yy, l.turn.x0, l.turn.y0};
        cairo_set_matrix(cr, &turn);
        cairo_scale(cr, k, k);
        cairo_translate(cr, -p->x, -p->y);
    }
    GError *fault = NULL;
    bool done = rsvg_handle_render_document(svg, cr, &viewport, &fault);
    cairo_status_t status = cairo_status(cr);
    snprintf(why, 200, "librsvg stopped: %s", fault ? fault->message : cairo_status_to_string(status));
    g_clear_error(&fault);
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    cairo_device_finish(script);
    cairo_device_destroy(script);
    return done && !status;
}

/* Tells whether clip paths or gradients may be in box units, which gradients are unless they say otherwise. */
static bool has_box_units(const GByteArray *text)
{
    static const char *const clips[] = {"clipPathUnits=\"objectB", "clipPathUnits='objectB", NULL};
    static const char *const gradients[] = {"linearGradient ", "radialGradient ", NULL};
    static const char *const others[] = {"gradientUnits=\"userS", "gradientUnits='userS", NULL};
    return count(text, clips) || count(text, gradients) > count(text, others);
}

/* Decides who turns the page. The style does it best, but not where the document's root has a transform of its own,
 * which wins; and librsvg takes the boxes of box units upright after the turn, so there cairo has to do it, if its
 * faults allow, which is tried first. */
static bool turn_by_style(RsvgHandle *svg, const GByteArray *text, const tap_page *p, bool no_text)
{
    char why[200];
    if (root_is_transformed(text))
        return false;
    return !has_box_units(text) || !draw(svg, p, false, no_text, discard, NULL, why);
}

/* Tells whether there is text that no font is at hand for: it would come out as boxes. */
static bool lacks_fonts(const GByteArray *text)
{
    static const char *const words[] = {"<text", ":text", NULL};
    if (!count(text, words))
        return false;
    const FcFontSet *fonts = FcConfigGetFonts(NULL, FcSetSystem);
    return !fonts || fonts->nfont == 0;
}

/* Gives the document in words that librsvg knows; the same text where nothing needs it. */
static GByteArray *rewritten(GByteArray *text, rewrite_report *report)
{
    if (!plb_rewrite_is_due((const char *)text->data, text->len))
        return text;
    GByteArray *made = plb_rewrite((const char *)text->data, text->len, report);
    return made ? made : text;
}

/* Counts what could not be rewritten, which is left out or drawn otherwise than it should be. */
static void add_report(list_writer *out, const rewrite_report *report, omissions *lost)
{
    lost->n[OMISSION_TEXT] += report->text;
    if (!report->style_sheet)
        return;
    char *message = g_strdup_printf("the style sheet %.80s is a file of its own and is not read: colours and widths may be wrong", report->style_sheet);
    plb_list_writer_message(out, MESSAGE_WARNING, message);
    g_free(message);
}

/* Draws the document and writes all of the list. */
static void write_list(RsvgHandle *svg, const GByteArray *text, const tap_page *p, bool no_text, const rewrite_report *report)
{
    static list_writer out;
    static script_pipe from_cairo;
    char why[200];
    error err = {0};
    plb_list_writer_init(&out, put, NULL);
    tap_sheet sheet = plb_tap_sheet(p);
    plb_list_writer_page(&out, sheet.width, sheet.height);
    if (!no_text && lacks_fonts(text)) {
        plb_list_writer_message(&out, MESSAGE_WARNING, "there is no font here: its text is left out (Debian: fonts-dejavu-core)");
        no_text = true;
    }
    char *boxes = no_text ? NULL : plb_tap_missing_glyphs((const char *)text->data, text->len);
    if (boxes)
        plb_list_writer_message(&out, MESSAGE_WARNING, boxes);
    g_free(boxes);
    bool by_style = turn_by_style(svg, text, p, no_text);
    plb_list_writer_matrix(&out, sheet.to_page);
    from_cairo.script = plb_cairoscript_new(&out, sheet.width, sheet.height, sheet.to_page);
    if (!from_cairo.script)
        quit(TAP_LIMIT, "out of memory");
    plb_cairoscript_listen(from_cairo.script, plb_typeset_recognise, NULL);
    plb_typeset_forget(); /* what was drawn to try */
    if (!draw(svg, p, by_style, no_text, feed, &from_cairo, why))
        quit(TAP_REFUSED, "%s", why);
    empty(&from_cairo);
    omissions lost = plb_tap_count_omissions((const char *)text->data, text->len);
    if (!plb_cairoscript_end(from_cairo.script, &lost, &err))
        quit_for(&err);
    add_report(&out, report, &lost);
    for (int k = 0; k < OMISSION_KINDS; k++)
        if (lost.n[k])
            plb_list_writer_omission(&out, (omission_kind)k, lost.n[k], NULL);
    plb_list_writer_end(&out);
}

int main(int argc, char **argv)
{
    bool mend = false, no_text = false;
    for (int i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--recover"))
            mend = true;
        else if (!strcmp(argv[i], "--no-text"))
            no_text = true;
        else
            quit(TAP_USAGE, "usage: tap-svg [--recover] [--no-text] <drawing.svg >list");
    }
    GByteArray *text = read_document();
    if (mend)
        text = recover(text);
    rewrite_report report = {0};
    text = rewritten(text, &report);
    RsvgHandle *svg = load(text);
    tap_page p = find_page(svg);
    write_list(svg, text, &p, no_text, &report);
    _exit(TAP_DONE); /* no time for tidying up */
}
