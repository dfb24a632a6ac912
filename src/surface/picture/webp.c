/* SPDX-License-Identifier: MIT
 *
 * WebP by libwebp: lossless where nothing is to be compressed, else with loss. The library wants the whole picture at once, so
 * the page is in memory, 4 bytes a pixel. The resolution and the texts lie in an Exif chunk, which is a small TIFF file.
 */
#include "surface/picture/formats.h"

#ifdef PLB_WITH_WEBP

#include "base/array.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include <webp/encode.h>
#include <webp/mux.h>

typedef struct {
    WebPConfig config;
    WebPPicture whole;
    uint8_t *row;
} webp_file;

/* ---- the Exif chunk ---- */

enum { TIFF_ASCII = 2, TIFF_SHORT, TIFF_LONG, TIFF_RATIONAL };
enum { TAG_DESCRIPTION = 0x10e, TAG_X_RESOLUTION = 0x11a, TAG_Y_RESOLUTION = 0x11b, TAG_RESOLUTION_UNIT = 0x128 };
#define EXIF_ENTRIES 4
/* Head, count of entries, entries, no further directory; then two rationals; then the texts. */
#define EXIF_RATIONALS (8 + 2 + EXIF_ENTRIES * 12 + 4)
#define EXIF_TEXTS (EXIF_RATIONALS + 16)

static uint8_t *put_number(uint8_t *to, uint32_t v, int bytes)
{
    for (int k = 0; k < bytes; k++)
        to[k] = (uint8_t)(v >> 8 * k);
    return to + bytes;
}

static uint8_t *put_entry(uint8_t *to, uint32_t tag, uint32_t type, uint32_t count, uint32_t value)
{
    to = put_number(put_number(to, tag, 2), type, 2);
    return put_number(put_number(to, count, 4), value, 4);
}

static uint8_t *exif_of(const picture_page *sheet, size_t *size)
{
    char *lines = plb_picture_lines(sheet);
    size_t text = lines ? strlen(lines) + 1 : 0;
    uint8_t *exif = lines ? plb_new(EXIF_TEXTS + text, 1) : NULL, *to = exif;
    if (exif) {
        memcpy(to, "II*\0\10\0\0\0", 8);
        to = put_number(to + 8, EXIF_ENTRIES, 2);
        to = put_entry(to, TAG_DESCRIPTION, TIFF_ASCII, (uint32_t)text, EXIF_TEXTS);
        to = put_entry(to, TAG_X_RESOLUTION, TIFF_RATIONAL, 1, EXIF_RATIONALS);
        to = put_entry(to, TAG_Y_RESOLUTION, TIFF_RATIONAL, 1, EXIF_RATIONALS + 8);
        to = put_entry(to, TAG_RESOLUTION_UNIT, TIFF_SHORT, 1, 2); /* inch */
        to = put_number(to, 0, 4);
        for (int k = 0; k < 2; k++)
            to = put_number(put_number(to, (uint32_t)floor(sheet->dpi * 100 + 0.5), 4), 100, 4);
        memcpy(to, lines, text);
        *size = EXIF_TEXTS + text;
    }
    plb_free(lines);
    return exif;
}

/* ---- the picture ---- */

static bool begin_page(picture *p, error *err)
{
    webp_file *f = p->own = plb_new(1, sizeof *f);
    int level = p->page->level;
    if (!f || !WebPConfigPreset(&f->config, WEBP_PRESET_DRAWING, (float)plb_picture_quality(level)) || !WebPPictureInit(&f->whole))
        return plb_fail_memory(err);
    f->config.method = 1 + level / 2; /* of 6: how long it searches */
    if (level == 0) {
        f->config.lossless = 1;
        f->config.quality = 0; /* of lossless pictures: effort */
        f->config.method = 0;
    }
    f->whole.use_argb = 1;
    f->whole.width = p->page->width;
    f->whole.height = p->page->height;
    f->row = plb_new((size_t)p->page->width, (size_t)p->channels);
    return (f->row && WebPPictureAlloc(&f->whole)) || plb_fail_memory(err);
}

static bool add(picture *p, error *err)
{
    webp_file *f = p->own;
    (void)err;
    for (int y = p->band->top; y < p->band->top + p->band->rows; y++) {
        uint32_t *to = f->whole.argb + (size_t)y * (size_t)f->whole.argb_stride;
        plb_picture_row(p, y, f->row);
        for (int x = 0; x < p->page->width; x++) {
            const uint8_t *v = f->row + (size_t)x * (size_t)p->channels;
            uint32_t alpha = p->channels % 2 ? 255 : v[p->channels - 1];
            to[x] = p->channels < PIGMENT_PLANES ? alpha << 24 | v[0] * 0x10101u : alpha << 24 | (uint32_t)v[0] << 16 | (uint32_t)v[1] << 8 | v[2];
        }
    }
    return true;
}

/* Puts picture and Exif chunk together. */
static bool assemble(const picture_page *sheet, const WebPMemoryWriter *encoded, WebPData *file)
{
    WebPData image = {encoded->mem, encoded->size}, exif = {0};
    uint8_t *chunk = exif_of(sheet, &exif.size);
    exif.bytes = chunk;
    WebPMux *mux = chunk ? WebPMuxNew() : NULL;
    bool ok = mux && WebPMuxSetImage(mux, &image, 0) == WEBP_MUX_OK && WebPMuxSetChunk(mux, "EXIF", &exif, 0) == WEBP_MUX_OK &&
              WebPMuxAssemble(mux, file) == WEBP_MUX_OK;
    WebPMuxDelete(mux);
    plb_free(chunk);
    return ok;
}

static bool end_page(picture *p, error *err)
{
    webp_file *f = p->own;
    WebPMemoryWriter encoded;
    WebPData file = {0};
    WebPMemoryWriterInit(&encoded);
    f->whole.writer = WebPMemoryWrite;
    f->whole.custom_ptr = &encoded;
    bool ok = WebPEncode(&f->config, &f->whole) && assemble(p->page, &encoded, &file);
    if (!ok)
        plb_fail_memory(err); /* nothing else can fail: the options are sound, the size is within bounds */
    ok = ok && (plb_picture_put(p, file.bytes, file.size) || plb_picture_fail(p, err));
    WebPDataClear(&file);
    WebPMemoryWriterClear(&encoded);
    return ok;
}

static void drop(picture *p)
{
    webp_file *f = p->own;
    if (!f)
        return;
    WebPPictureFree(&f->whole);
    plb_free(f->row);
    plb_free(f);
}

#define WEBP_FUNCTIONS .built = true, .begin_page = begin_page, .add = add, .end_page = end_page, .drop = drop
#else
#define WEBP_FUNCTIONS .built = false
#endif

const picture_format plb_webp_format = {.name = "WebP", .suffixes = "webp", .package = "libwebp-dev", .see_through = true, .max_side = 16383, WEBP_FUNCTIONS};
