/* SPDX-License-Identifier: MIT
 *
 * See foreign.h: a table of the signs at the start of files.
 */
#include "input/format/foreign.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <zlib.h>

/* An XML document tells its kind within so many bytes. */
#define LOOK_BYTES ((size_t)4096)
#define NO_LINES "it has no lines to draw; trace it first (Debian: potrace, or Inkscape)"
#define METAFILE "Inkscape saves it as SVG"
#define DIAGRAM "export it as SVG there (with the font embedded, or as PDF)"
#define PLOT "hp2xx -m eps turns it into EPS (Debian: hp2xx)"

/* The bytes `sign` stand at `offset`. */
static const struct {
    const char *sign;
    size_t length, offset;
    foreign_format is;
} signs[] = {
    {"\x89PNG\r\n", 6, 0, {"a raster picture (PNG)", NO_LINES}},
    {"\xff\xd8\xff", 3, 0, {"a raster picture (JPEG)", NO_LINES}},
    {"GIF8", 4, 0, {"a raster picture (GIF)", NO_LINES}},
    {"WEBP", 4, 8, {"a raster picture (WebP)", NO_LINES}},
    {"II*\0", 4, 0, {"a raster picture (TIFF)", NO_LINES}},
    {"MM\0*", 4, 0, {"a raster picture (TIFF)", NO_LINES}},
    {"ftypavif", 8, 4, {"a raster picture (AVIF)", NO_LINES}},
    {"ftyphei", 7, 4, {"a raster picture (HEIF)", NO_LINES}},
    {"AC10", 4, 0, {"an AutoCAD drawing (DWG)", "save it as DXF there, or with the ODA File Converter or LibreDWG's dwg2dxf"}},
    {"IN;", 3, 0, {"a plot (HPGL)", PLOT}},
    {"\x1b%-1B", 5, 0, {"a plot (HPGL)", PLOT}},
    {"\x1b%0B", 4, 0, {"a plot (HPGL)", PLOT}},
    {"\x1b%1B", 4, 0, {"a plot (HPGL)", PLOT}},
    {"\x1f\x9d", 2, 0, {"packed (compress)", "unpack it first (uncompress -c FILE | plumbago -)"}},
    {"BZh", 3, 0, {"packed (bzip2)", "unpack it first (bunzip2 -c FILE | plumbago -)"}},
    {"\xfd" "7zXZ", 5, 0, {"packed (xz)", "unpack it first (xz -dc FILE | plumbago -)"}},
    {"\x28\xb5\x2f\xfd", 4, 0, {"packed (zstd)", "unpack it first (zstd -dc FILE | plumbago -)"}},
    {"PK\3\4", 4, 0, {"an archive (zip) or a document in one", "unpack it first, or save the drawing in it as SVG or PDF"}},
    {"\xd7\xcd\xc6\x9a", 4, 0, {"a Windows metafile (WMF)", METAFILE}},
    {" EMF", 4, 40, {"a Windows metafile (EMF)", METAFILE}},
};

/* XML documents by the name of their first element. */
static const struct {
    const char *name;
    foreign_format is;
} roots[] = {
    {"mxfile", {"a draw.io file", DIAGRAM}},
    {"mxGraphModel", {"a draw.io file", DIAGRAM}},
    {"html", {"a web page (HTML)", "print it to PDF, or save the drawing in it as SVG"}},
};

/* Gives the part of an XML document from its first element's name on; NULL: there is none. */
static const char *find_root(const char *data, const char *end)
{
    while (data < end && (data = memchr(data, '<', (size_t)(end - data)))) {
        bool is_comment = end - data > 4 && !memcmp(data, "<!--", 4);
        if (end - data < 2 || (data[1] != '?' && data[1] != '!'))
            return data + 1;
        /* Declarations end at the first '>', comments at "-->". */
        for (data += 2; data < end && (*data != '>' || (is_comment && memcmp(data - 2, "--", 2) != 0)); data++)
            ;
    }
    return NULL;
}

static const foreign_format *find_by_root(const char *data, size_t size)
{
    size_t blank = 0;
    while (blank < size && memchr("\xef\xbb\xbf \t\r\n", data[blank], 7))
        blank++;
    const char *end = data + size, *name = blank < size && data[blank] == '<' ? find_root(data + blank, end) : NULL;
    for (size_t i = 0; name && i < sizeof roots / sizeof *roots; i++) {
        size_t n = strlen(roots[i].name);
        if ((size_t)(end - name) > n && !memcmp(name, roots[i].name, n) && memchr(" \t\r\n>/", name[n], 6))
            return &roots[i].is;
    }
    return NULL;
}

const foreign_format *plb_foreign_find(const char *data, size_t size)
{
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (size >= signs[i].offset + signs[i].length && !memcmp(data + signs[i].offset, signs[i].sign, signs[i].length))
            return &signs[i].is;
    return find_by_root(data, size < LOOK_BYTES ? size : LOOK_BYTES);
}

size_t plb_gzip_look_inside(const char *data, size_t size, char *start, size_t room)
{
    enum { GZIP = 16 + MAX_WBITS };
    z_stream z = {.next_in = (z_const Bytef *)(uintptr_t)data, .avail_in = (uInt)size, .next_out = (Bytef *)start, .avail_out = (uInt)room};
    if (inflateInit2(&z, GZIP) != Z_OK)
        return 0;
    (void)inflate(&z, Z_SYNC_FLUSH); /* whatever comes of it: only the start matters */
    inflateEnd(&z);
    return room - z.avail_out;
}
