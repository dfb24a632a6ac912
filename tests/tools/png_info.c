/* SPDX-License-Identifier: MIT
 *
 * png_info FILE: reads the whole PNG and prints a line for each fact: size, depth, colour, dpi, text KEY: VALUE.
 * Exit status 1 and a line on standard error when the file is not a whole, valid PNG.
 */
#include <png.h>
#include <stdio.h>
#include <stdlib.h>

static const char *colour_name(int type)
{
    static const char *const names[] = {"grey", "?", "rgb", "palette", "grey+alpha", "?", "rgb+alpha"};
    return type >= 0 && type < 7 ? names[type] : "?";
}

static void print_facts(png_structp png, png_infop info)
{
    printf("size %u %u\n", png_get_image_width(png, info), png_get_image_height(png, info));
    printf("depth %d\n", png_get_bit_depth(png, info));
    printf("colour %s\n", colour_name(png_get_color_type(png, info)));
    png_uint_32 x, y;
    int unit;
    if (png_get_pHYs(png, info, &x, &y, &unit) && unit == PNG_RESOLUTION_METER) {
        printf("phys %u %u\n", x, y);
        printf("dpi %.2f %.2f\n", x * 0.0254, y * 0.0254);
    }
}

static void print_texts(png_structp png, png_infop info)
{
    png_textp text;
    int n = png_get_text(png, info, &text, NULL);
    for (int i = 0; i < n; i++)
        printf("text %s: %s\n", text[i].key, text[i].text);
}

/* Reads every row, so that a cut or damaged file is noticed. */
static void read_rows(png_structp png, png_infop info)
{
    int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    png_bytep row = malloc(png_get_rowbytes(png, info));
    if (!row)
        exit(2);
    for (int pass = 0; pass < passes; pass++)
        for (png_uint_32 y = 0; y < png_get_image_height(png, info); y++)
            png_read_row(png, row, NULL);
    free(row);
}

int main(int argc, char **argv)
{
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    if (!file) {
        fprintf(stderr, "usage: png_info FILE (which must exist)\n");
        return 2;
    }
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info || setjmp(png_jmpbuf(png))) { /* libpng has printed what is wrong */
        fclose(file);
        return 1;
    }
    png_init_io(png, file);
    png_read_info(png, info);
    print_facts(png, info);
    read_rows(png, info);
    png_read_end(png, info);
    print_texts(png, info);
    png_destroy_read_struct(&png, &info, NULL);
    fclose(file);
    return 0;
}
