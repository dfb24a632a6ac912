/* SPDX-License-Identifier: MIT
 *
 * picture_compare A B.png: compares a JPEG, WebP or TIFF (its first page) with a PNG as grey on white, pixel by pixel. Prints "size W H
 * dpi D pages N mean M max X", where the last two are the differences. Exit status 2: A is no such picture, or not of B's size; 3: this
 * build has no library for it.
 */
#include "tools/png_image.h"

#include <math.h>

typedef struct {
    int width, height, pages;
    double dpi;
    uint8_t *rgba;
} picture;

static picture blank(int width, int height)
{
    picture p = {width, height, 1, 0, malloc((size_t)width * (size_t)height * 4)};
    return p.rgba ? p : (exit(2), p);
}

#ifdef PLB_WITH_JPEG
#include <jpeglib.h>
static picture read_jpeg(const char *file)
{
    FILE *from = fopen(file, "rb");
    struct jpeg_decompress_struct c;
    struct jpeg_error_mgr errors;
    c.err = jpeg_std_error(&errors); /* which says why and exits */
    jpeg_create_decompress(&c);
    jpeg_stdio_src(&c, from);
    jpeg_read_header(&c, TRUE);
    c.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&c);
    picture p = blank((int)c.output_width, (int)c.output_height);
    p.dpi = c.density_unit == 1 ? c.X_density : 0;
    while (c.output_scanline < c.output_height) {
        uint8_t *row = p.rgba + (size_t)c.output_scanline * (size_t)p.width * 4;
        jpeg_read_scanlines(&c, &row, 1);
    }
    jpeg_finish_decompress(&c);
    jpeg_destroy_decompress(&c);
    fclose(from);
    return p;
}
#else
static picture read_jpeg(const char *file) { return (void)file, exit(3), (picture){0}; }
#endif

#ifdef PLB_WITH_WEBP
#include <webp/decode.h>
#include <webp/mux.h>
static picture read_webp(const char *file)
{
    static uint8_t bytes[32 << 20];
    FILE *from = fopen(file, "rb");
    size_t n = fread(bytes, 1, sizeof bytes, from);
    fclose(from);
    picture p = {.pages = 1};
    p.rgba = WebPDecodeRGBA(bytes, n, &p.width, &p.height);
    if (!p.rgba)
        exit(2);
    WebPData all = {bytes, n}, exif = {0};
    WebPMux *mux = WebPMuxCreate(&all, 0);
    if (mux && WebPMuxGetChunk(mux, "EXIF", &exif) == WEBP_MUX_OK && exif.size > 80) { /* x resolution: the first rational */
        const uint8_t *r = exif.bytes + 62;
        p.dpi = (r[0] | r[1] << 8 | r[2] << 16) / (double)(r[4] | r[5] << 8);
    }
    WebPMuxDelete(mux);
    return p;
}
#else
static picture read_webp(const char *file) { return (void)file, exit(3), (picture){0}; }
#endif

#ifdef PLB_TIFF_LIBRARY
#include <tiffio.h>
static picture read_tiff(const char *file)
{
    TIFF *t = TIFFOpen(file, "r");
    uint32_t w = 0, h = 0;
    float dpi = 0;
    if (!t || !TIFFGetField(t, TIFFTAG_IMAGEWIDTH, &w) || !TIFFGetField(t, TIFFTAG_IMAGELENGTH, &h))
        exit(2);
    TIFFGetField(t, TIFFTAG_XRESOLUTION, &dpi);
    picture p = blank((int)w, (int)h);
    p.dpi = (double)dpi;
    if (!TIFFReadRGBAImageOriented(t, w, h, (uint32_t *)(void *)p.rgba, ORIENTATION_TOPLEFT, 1))
        exit(2);
    for (size_t i = 0; i < (size_t)w * h; i++) { /* libtiff gives premultiplied colours */
        uint8_t *v = p.rgba + 4 * i;
        for (int k = 0; k < 3; k++)
            v[k] = (uint8_t)(v[3] ? (v[k] * 255 + v[3] / 2) / v[3] : 255);
    }
    p.pages = (int)TIFFNumberOfDirectories(t);
    TIFFClose(t);
    return p;
}
#else
static picture read_tiff(const char *file) { return (void)file, exit(3), (picture){0}; }
#endif

int main(int argc, char **argv)
{
    const char *dot = argc == 3 ? strrchr(argv[1], '.') : NULL;
    if (!dot) {
        fprintf(stderr, "usage: picture_compare A B.png\n");
        return 2;
    }
    picture a = !strcmp(dot, ".webp") ? read_webp(argv[1]) : dot[1] == 't' ? read_tiff(argv[1]) : read_jpeg(argv[1]);
    grey_image b = read_grey(argv[2]);
    if (a.width != b.width || a.height != b.height)
        return 2;
    double sum = 0;
    int max = 0;
    size_t n = (size_t)a.width * (size_t)a.height;
    for (size_t i = 0; i < n; i++) {
        int by = abs(grey_of(a.rgba + 4 * i) - b.grey[i]);
        sum += by;
        max = by > max ? by : max;
    }
    printf("size %d %d dpi %.0f pages %d mean %.2f max %d\n", a.width, a.height, a.dpi, a.pages, sum / (double)n, max);
    free(a.rgba);
    free(b.grey);
    return 0;
}
