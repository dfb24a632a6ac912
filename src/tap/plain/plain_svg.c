/* SPDX-License-Identifier: MIT
 *
 * Reads plain SVG element by element, in the order in which libxml2's SAX parser finds them: no tree is made. Inherited
 * properties lie on a stack as deep as the elements.
 */
#include "tap/plain/plain_svg.h"

#include <libxml/parser.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MAX_LEVELS 200
#define MAX_ELEMENTS 1000000ul /* librsvg refuses more */
#define SVG_NAMESPACE "http://www.w3.org/2000/svg"

/* These attributes say where something lies. */
enum { AT_D, AT_POINTS, AT_X, AT_Y, AT_WIDTH, AT_HEIGHT, AT_X1, AT_Y1, AT_X2, AT_Y2, AT_CX, AT_CY, AT_R, AT_RX, AT_RY, AT_VIEWBOX, AT_FIT, PLACES };
static const char *const place_names[PLACES] = {"d",  "points", "x",  "y",  "width", "height", "x1", "y1",
                                                "x2", "y2",     "cx", "cy", "r",     "rx",     "ry", "viewBox", "preserveAspectRatio"};
#define BIT(n) (1u << (n))

typedef struct {
    plain_text place[PLACES];
    plain_text transform, style;
} attributes;

typedef struct {
    matrix matrix; /* user units to the surface's */
    plain_style style;
    bool is_shape; /* nothing in it is drawn */
} level;

typedef struct {
    xmlParserCtxt *parser;
    char *why;           /* not plain; empty: so far it is */
    level levels[MAX_LEVELS];
    int depth;           /* levels in use; the outermost element has the first */
    unsigned skipped;    /* depth within an element that draws nothing */
    unsigned long elements;
    bool has_page;
    plain_list *list;
} reader;

static bool refuse(reader *r, const char *what, plain_text which)
{
    if (!*r->why) {
        int n = (int)(which.end - which.at);
        snprintf(r->why, PLAIN_WHY, "%s %.*s", what, n > 60 ? 60 : n, which.at ? which.at : "");
        xmlStopParser(r->parser);
    }
    return false;
}

static plain_text words(const char *text) { return (plain_text){text, text + strlen(text)}; }

/* ---- the outermost element: page and viewBox ----------------------------------------------------------------- */

static bool read_box(plain_text t, double view[4])
{
    t = plb_plain_trim(t);
    for (int i = 0; i < 4; i++) {
        if (i)
            plb_plain_comma(&t);
        if (!plb_plain_css_number(&t, &view[i]))
            return false;
    }
    return t.at == t.end && view[2] > PLAIN_NEAR && view[3] > PLAIN_NEAR;
}

static bool read_extent(plain_text t, tap_extent *e)
{
    *e = (tap_extent){1, true};
    if (!t.at || plb_plain_is(t, "100%"))
        return true;
    e->is_share = false;
    return plb_plain_length(t, &e->value) && e->value > PLAIN_NEAR && e->value <= TAP_PX_MAX;
}

/* Rounds a number like the style sheet of tap_svg.c: printed with so many digits, and read by librsvg in single precision. */
static double as_printed(const char *format, double v)
{
    char text[40];
    double read = 0;
    snprintf(text, sizeof text, format, v);
    plain_text t = words(text);
    plb_plain_css_number(&t, &read);
    return read;
}

/* Gives the turn of the style sheet in tap_svg.c. */
static matrix turn_matrix(const tap_placing *l)
{
    double angle = plb_plain_radians(as_printed("%.9g", TAP_TURN_DEGREES)), k = as_printed("%.12g", 1 / l->fit);
    matrix shift = {1, 0, 0, 1, as_printed("%.9g", l->turn.x0), 0}, scale = {k, 0, 0, k, 0, 0};
    matrix rotation = {cos(angle), sin(angle), -sin(angle), cos(angle), 0, 0};
    return plb_matrix_multiply(scale, plb_matrix_multiply(rotation, shift));
}

/* A fit says how the viewBox lies in the viewport: shares of the space left and above; stretched; cut off. */
typedef struct {
    double x, y;
    bool is_stretched, is_sliced;
} fit;

/* Reads Min, Mid or Max: how much of the free space lies before. */
static bool read_share(const char *word, double *share)
{
    static const char *const words[] = {"Min", "Mid", "Max"};
    int i = 0;
    while (i < 3 && memcmp(word, words[i], 3) != 0)
        i++;
    *share = i / 2.0;
    return i < 3;
}

/* Reads none or xM..YM.., then meet, slice or nothing. */
static bool read_fit(plain_text t, fit *f)
{
    *f = (fit){.x = 0.5, .y = 0.5};
    if (!t.at)
        return true;
    t = plb_plain_trim(t);
    plain_text align = {t.at, t.at};
    while (align.end < t.end && *align.end != ' ')
        align.end++;
    plain_text rest = plb_plain_trim((plain_text){align.end, t.end});
    f->is_sliced = plb_plain_is(rest, "slice");
    f->is_stretched = plb_plain_is(align, "none");
    if (!f->is_sliced && rest.at != rest.end && !plb_plain_is(rest, "meet"))
        return false;
    bool is_aligned = align.end - align.at == 8 && align.at[0] == 'x' && align.at[4] == 'Y';
    return f->is_stretched || (is_aligned && read_share(align.at + 1, &f->x) && read_share(align.at + 5, &f->y));
}

/* Gives the start of the viewBox, calculated like librsvg to the last digit. */
static double start_of(double share, double whole, double part)
{
    return share == 0 ? 0 : share == 1 ? whole - part : (whole - part) / 2;
}

/* Maps the viewBox into the viewport (SVG 1.1, section 7.8), then turns it. */
static matrix root_matrix(const tap_page *p, const double view[4], const fit *f)
{
    tap_placing l = plb_tap_place(p);
    double w = p->width * l.scale * l.fit, h = p->height * l.scale * l.fit, x_factor = w / view[2], y_factor = h / view[3];
    double factor = f->is_sliced ? fmax(x_factor, y_factor) : fmin(x_factor, y_factor);
    double inner_w = f->is_stretched ? w : view[2] * factor, inner_h = f->is_stretched ? h : view[3] * factor;
    double x = start_of(f->x, w, inner_w), y = start_of(f->y, h, inner_h);
    matrix place = {1, 0, 0, 1, x, y}, corner = {1, 0, 0, 1, -view[0], -view[1]};
    matrix scale = {((x + inner_w) - x) / view[2], 0, 0, ((y + inner_h) - y) / view[3], 0, 0};
    return plb_matrix_multiply(plb_matrix_multiply(corner, plb_matrix_multiply(scale, place)), turn_matrix(&l));
}

static bool is_zero(plain_text t)
{
    double v;
    return !t.at || (plb_plain_length(t, &v) && v == 0);
}

static bool open_page(reader *r, const attributes *a, level *l)
{
    tap_page p = plb_tap_page();
    tap_extent w, h;
    double view[4] = {0, 0, 0, 0};
    fit f;
    bool has_box = a->place[AT_VIEWBOX].at != NULL;
    if (!read_fit(a->place[AT_FIT], &f))
        return refuse(r, "preserveAspectRatio", a->place[AT_FIT]);
    if (has_box && !read_box(a->place[AT_VIEWBOX], view))
        return refuse(r, "viewBox", a->place[AT_VIEWBOX]);
    if (!read_extent(a->place[AT_WIDTH], &w) || !read_extent(a->place[AT_HEIGHT], &h))
        return refuse(r, "size of the page", a->place[AT_WIDTH]);
    if (!plb_tap_page_size(&p, w, h, has_box ? view + 2 : NULL) || !plb_tap_page_is_there(&p) || !plb_tap_page_is_fit(&p))
        return refuse(r, "size of the page", a->place[AT_WIDTH]);
    if (a->transform.at || !is_zero(a->place[AT_X]) || !is_zero(a->place[AT_Y]))
        return refuse(r, "place of the page", a->transform);
    double whole[4] = {0, 0, p.width, p.height};
    l->matrix = root_matrix(&p, has_box ? view : whole, &f);
    plb_plain_list_begin(r->list, &p);
    r->has_page = true;
    return true;
}

/* ---- shapes ------------------------------------------------------------------------------------------------- */

/* Reads a length that may be missing, and is 0 then. */
static bool read_lengths(const attributes *a, const int *places, size_t n, double *v)
{
    for (size_t i = 0; i < n; i++) {
        v[i] = 0;
        if (a->place[places[i]].at && !plb_plain_length(a->place[places[i]], &v[i]))
            return false;
    }
    return true;
}

static bool draw_path(plain_path *p, const attributes *a, bool square) { return plb_plain_data(p, a->place[AT_D], square); }
static bool draw_polyline(plain_path *p, const attributes *a, bool square) { return plb_plain_points(p, a->place[AT_POINTS], false, square); }
static bool draw_polygon(plain_path *p, const attributes *a, bool square) { return plb_plain_points(p, a->place[AT_POINTS], true, square); }

static bool draw_line(plain_path *p, const attributes *a, bool square)
{
    static const int places[] = {AT_X1, AT_Y1, AT_X2, AT_Y2};
    double v[4];
    if (!read_lengths(a, places, 4, v))
        return false;
    plb_plain_move(p, v[0], v[1]);
    plb_plain_line(p, v[2], v[3]);
    return !square || fabs(v[2] - v[0]) > PLAIN_NEAR || fabs(v[3] - v[1]) > PLAIN_NEAR;
}

static bool draw_rectangle(plain_path *p, const attributes *a, bool square)
{
    static const int places[] = {AT_X, AT_Y, AT_WIDTH, AT_HEIGHT, AT_RX, AT_RY};
    double v[6];
    if (!read_lengths(a, places, 6, v) || v[2] < 0 || v[3] < 0 || v[4] < 0 || v[5] < 0)
        return false;
    if (!a->place[AT_RX].at)
        v[4] = v[5];
    if (!a->place[AT_RY].at)
        v[5] = v[4];
    if (v[2] > 0 && v[3] > 0)
        plb_plain_rectangle(p, v, v[4], v[5]);
    return !square || v[2] - 2 * fmin(v[4], v[2] / 2) > PLAIN_NEAR;
}

static bool draw_round(plain_path *p, const attributes *a, bool square, int horizontal, int vertical)
{
    int places[] = {AT_CX, AT_CY, horizontal, vertical};
    double v[4];
    if (!a->place[horizontal].at || !a->place[vertical].at || !read_lengths(a, places, 4, v) || v[2] < 0 || v[3] < 0)
        return false;
    if (v[2] > 0 && v[3] > 0)
        plb_plain_ellipse(p, v);
    return !square || (v[2] > PLAIN_NEAR && v[3] > PLAIN_NEAR);
}

static bool draw_circle(plain_path *p, const attributes *a, bool square) { return draw_round(p, a, square, AT_R, AT_R); }
static bool draw_ellipse(plain_path *p, const attributes *a, bool square) { return draw_round(p, a, square, AT_RX, AT_RY); }

typedef struct {
    const char *name;
    unsigned places;                                              /* BIT(AT_...) that it may have */
    bool (*draw)(plain_path *p, const attributes *a, bool square); /* NULL: a group */
} element;

static const element elements[] = {
    {"path", BIT(AT_D), draw_path},
    {"g", 0, NULL},
    {"a", 0, NULL},
    {"line", BIT(AT_X1) | BIT(AT_Y1) | BIT(AT_X2) | BIT(AT_Y2), draw_line},
    {"polyline", BIT(AT_POINTS), draw_polyline},
    {"polygon", BIT(AT_POINTS), draw_polygon},
    {"rect", BIT(AT_X) | BIT(AT_Y) | BIT(AT_WIDTH) | BIT(AT_HEIGHT) | BIT(AT_RX) | BIT(AT_RY), draw_rectangle},
    {"circle", BIT(AT_CX) | BIT(AT_CY) | BIT(AT_R), draw_circle},
    {"ellipse", BIT(AT_CX) | BIT(AT_CY) | BIT(AT_RX) | BIT(AT_RY), draw_ellipse},
};
static const element root = {"svg", BIT(AT_X) | BIT(AT_Y) | BIT(AT_WIDTH) | BIT(AT_HEIGHT) | BIT(AT_VIEWBOX) | BIT(AT_FIT), NULL};

static const element *find_element(const reader *r, const char *name)
{
    if (!r->depth)
        return strcmp(name, root.name) ? NULL : &root;
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++)
        if (!strcmp(name, elements[i].name))
            return &elements[i];
    return NULL;
}

/* ---- attributes --------------------------------------------------------------------------------------------- */

/* Tells whether the name of a language has only letters, digits and hyphens, which librsvg can read. */
static bool is_language(plain_text t)
{
    const char *at = t.at;
    while (at < t.end && ((unsigned char)((*at | 32) - 'a') < 26 || (at > t.at + 1 && (*at == '-' || (unsigned char)(*at - '0') < 10))))
        at++;
    return at == t.end && at > t.at + 1 && at[-1] != '-';
}

/* Tells whether an attribute of another namespace is ignored, as librsvg ignores all but xml:space and xml:lang. */
static bool is_foreign(const char *uri, plain_text name, plain_text value)
{
    if (!strcmp(uri, (const char *)XML_XML_NAMESPACE))
        return plb_plain_is(name, "space") ? plb_plain_is(value, "preserve") || plb_plain_is(value, "default")
                                           : !plb_plain_is(name, "lang") || is_language(value);
    return strcmp(uri, SVG_NAMESPACE) != 0;
}

static bool read_attribute(reader *r, const element *e, attributes *a, plain_style *style, plain_text name, plain_text value)
{
    for (unsigned i = 0; i < PLACES; i++)
        if (plb_plain_is(name, place_names[i])) {
            if (e->places & BIT(i))
                a->place[i] = value;
            return true;
        }
    if (plb_plain_is(name, "transform"))
        a->transform = value;
    else if (plb_plain_is(name, "style"))
        a->style = value;
    else if (!plb_plain_property(style, name, value))
        return refuse(r, "attribute", name);
    return true;
}

/* Reads all attributes of an element; the style attribute has precedence over the others. `raw` has SAX's five pointers for each. */
static bool read_attributes(reader *r, const element *e, attributes *a, plain_style *style, const xmlChar **raw, int n)
{
    for (int i = 0; i < n; i++, raw += 5) {
        const char *uri = (const char *)raw[2];
        plain_text name = words((const char *)raw[0]), value = {(const char *)raw[3], (const char *)raw[4]};
        if (uri && !is_foreign(uri, name, value))
            return refuse(r, "attribute with a prefix", name);
        if (!uri && !read_attribute(r, e, a, style, name, value))
            return false;
    }
    return !a->style.at || plb_plain_declarations(style, a->style) || refuse(r, "style", a->style);
}

/* ---- elements ----------------------------------------------------------------------------------------------- */

static bool draw_shape(reader *r, const element *e, const attributes *a, const level *l)
{
    plain_path *p = &r->list->path;
    plb_plain_begin(p, &l->matrix);
    if (!e->draw(p, a, l->style.pen.cap == PLAIN_SQUARE))
        return refuse(r, "numbers of a", words(e->name));
    return plb_plain_draw(r->list, &l->style) || refuse(r, "beyond limits: a", words(e->name));
}

static bool place_element(reader *r, const element *e, const attributes *a, level *l)
{
    matrix own;
    if (e == &root)
        return open_page(r, a, l);
    if (!a->transform.at)
        return true;
    if (!plb_plain_transform(a->transform, &own))
        return refuse(r, "transform", a->transform);
    l->matrix = plb_matrix_multiply(own, l->matrix);
    return true;
}

static bool open_element(reader *r, const element *e, const xmlChar **raw, int n)
{
    attributes a = {.style = {NULL, NULL}};
    if (r->depth == MAX_LEVELS || ++r->elements > MAX_ELEMENTS)
        return refuse(r, "too deep or too many:", words(e->name));
    level *l = &r->levels[r->depth];
    if (r->depth)
        *l = r->levels[r->depth - 1];
    else
        l->style = plb_plain_style();
    if (!read_attributes(r, e, &a, &l->style, raw, n))
        return false;
    if (l->style.is_gone && e != &root) {
        r->skipped = 1;
        return true;
    }
    if (l->style.is_gone || !place_element(r, e, &a, l))
        return refuse(r, "display of", words(e->name));
    r->depth++;
    l->is_shape = e->draw != NULL;
    return !e->draw || draw_shape(r, e, &a, l);
}

/* Tells whether an element that is not drawn may still say how the rest is drawn, or how the tap places it. */
static bool has_effect(const char *name)
{
    static const char *const names[] = {"style", "include", "linearGradient", "radialGradient", "clipPath", NULL};
    return plb_plain_is_any(words(name), names);
}

/* Tells whether an element draws nothing, with all that is in it: descriptions, definitions (nothing refers to them),
 * other namespaces; librsvg does draw elements of none. */
static bool draws_nothing(const char *name, const char *uri)
{
    static const char *const names[] = {"title", "desc", "metadata", "defs", NULL};
    return uri && (strcmp(uri, SVG_NAMESPACE) != 0 || plb_plain_is_any(words(name), names));
}

static reader *reader_of(void *context) { return ((xmlParserCtxt *)context)->_private; }

static void on_start(void *context, const xmlChar *name, const xmlChar *prefix, const xmlChar *uri, int n_namespaces,
                     const xmlChar **namespaces, int n, int n_defaulted, const xmlChar **raw)
{
    (void)prefix, (void)n_namespaces, (void)namespaces;
    reader *r = reader_of(context);
    const char *local = (const char *)name, *space = (const char *)uri;
    if (*r->why)
        return;
    if (n_defaulted || has_effect(local)) {
        refuse(r, "element", words(local));
    } else if (r->skipped || (r->depth && draws_nothing(local, space))) {
        r->skipped++;
    } else {
        const element *e = space && !strcmp(space, SVG_NAMESPACE) ? find_element(r, local) : NULL;
        if (!e || (r->depth && r->levels[r->depth - 1].is_shape))
            refuse(r, "element", words(local));
        else
            open_element(r, e, raw, n);
    }
}

static void on_end(void *context, const xmlChar *name, const xmlChar *prefix, const xmlChar *uri)
{
    (void)name, (void)prefix, (void)uri;
    reader *r = reader_of(context);
    if (*r->why)
        return;
    if (r->skipped)
        r->skipped--;
    else
        r->depth--;
}

/* ---- what else may stand in a document ------------------------------------------------------------------------ */

static void on_instruction(void *context, const xmlChar *target, const xmlChar *data)
{
    (void)data;
    refuse(reader_of(context), "processing instruction", words((const char *)target));
}

static void on_reference(void *context, const xmlChar *name) { refuse(reader_of(context), "entity", words((const char *)name)); }

static void on_entity(void *context, const xmlChar *name, int type, const xmlChar *public, const xmlChar *system, xmlChar *content)
{
    (void)type, (void)public, (void)system, (void)content;
    refuse(reader_of(context), "entity", words((const char *)name));
}

static void on_attribute_declaration(void *context, const xmlChar *of, const xmlChar *name, int type, int def, const xmlChar *value, xmlEnumeration *tree)
{
    (void)name, (void)type, (void)def, (void)value;
    xmlFreeEnumeration(tree);
    refuse(reader_of(context), "declaration of", words((const char *)of));
}

/* Ends the reading at errors and at warnings, too: librsvg stops at some. */
static void on_error(void *context, xmlError *fault)
{
    (void)fault;
    refuse(reader_of(context), "malformed XML", (plain_text){NULL, NULL});
}

static const xmlSAXHandler handlers = {
    .initialized = XML_SAX2_MAGIC,
    .startElementNs = on_start,
    .endElementNs = on_end,
    .processingInstruction = on_instruction,
    .reference = on_reference,
    .entityDecl = on_entity,
    .attributeDecl = on_attribute_declaration,
    .serror = on_error,
};

/* Parses the document; r->why says what is wrong with it. */
static void parse(reader *r, const char *text, size_t size)
{
    *r->parser->sax = handlers;
    r->parser->_private = r;
    int options = XML_PARSE_NONET | (size > TAP_LIBXML_TEXT ? XML_PARSE_HUGE : 0);
    xmlFreeDoc(xmlCtxtReadMemory(r->parser, text, (int)size, NULL, NULL, options));
    if (!r->parser->wellFormed || r->parser->hasPErefs || !r->has_page)
        refuse(r, "malformed XML", (plain_text){NULL, NULL});
    if (!*r->why && !plb_plain_list_end(r->list))
        refuse(r, "a list too long", (plain_text){NULL, NULL});
}

bool plb_plain_svg(const char *text, size_t size, plain_list *list, char why[PLAIN_WHY])
{
    reader r = {.parser = xmlNewParserCtxt(), .list = list, .why = why};
    strcpy(why, r.parser ? "" : "out of memory");
    if (r.parser) {
        parse(&r, text, size);
        xmlFreeParserCtxt(r.parser);
    }
    if (*why && r.has_page)
        plb_plain_list_free(list);
    return !*why;
}
