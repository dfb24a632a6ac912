/* SPDX-License-Identifier: MIT
 *
 * JPEG by libjpeg: grey, or red, green and blue at full resolution, row by row. It has no transparency. The texts are
 * comments, one each.
 */
#include "surface/picture/formats.h"

#ifdef PLB_WITH_JPEG

#include "base/array.h"

#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include <jpeglib.h>

#define BUFFER_BYTES 65536

typedef struct {
    struct jpeg_compress_struct c;
    struct jpeg_error_mgr errors;
    struct jpeg_destination_mgr to;
    jmp_buf failed;
    char why[JMSG_LENGTH_MAX]; /* libjpeg's words; empty: the sink failed */
    picture *p;
    uint8_t *row;
    uint8_t buffer[BUFFER_BYTES];
} jpeg_file;

static void on_error(j_common_ptr c)
{
    jpeg_file *f = c->client_data;
    c->err->format_message(c, f->why);
    longjmp(f->failed, 1);
}

/* Warnings go nowhere: there are none in writing. */
static void on_message(j_common_ptr c) { (void)c; }

static void put(jpeg_file *f, size_t n)
{
    if (!plb_picture_put(f->p, f->buffer, n))
        longjmp(f->failed, 1);
    f->to.next_output_byte = f->buffer;
    f->to.free_in_buffer = BUFFER_BYTES;
}

static void begin_buffer(j_compress_ptr c) { put(c->client_data, 0); }

static boolean empty_buffer(j_compress_ptr c)
{
    put(c->client_data, BUFFER_BYTES);
    return TRUE;
}

static void end_buffer(j_compress_ptr c)
{
    jpeg_file *f = c->client_data;
    put(f, BUFFER_BYTES - f->to.free_in_buffer);
}

static bool fail(const jpeg_file *f, error *err)
{
    if (f->why[0])
        return plb_fail(err, ERROR_FILE, "%s: cannot be written: %s", f->p->name, f->why);
    return plb_picture_fail(f->p, err);
}

static void put_texts(jpeg_file *f)
{
    for (const char *const *t = f->p->page->text; t && t[0]; t += 2) {
        char line[512];
        int n = snprintf(line, sizeof line, "%s: %s", t[0], t[1]);
        jpeg_write_marker(&f->c, JPEG_COM, (const JOCTET *)line, n < (int)sizeof line ? (unsigned)n : (unsigned)sizeof line - 1);
    }
}

static void begin_rows(jpeg_file *f)
{
    const picture_page *sheet = f->p->page;
    f->c.image_width = (JDIMENSION)sheet->width;
    f->c.image_height = (JDIMENSION)sheet->height;
    f->c.input_components = f->p->channels;
    f->c.in_color_space = f->p->channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&f->c);
    jpeg_set_quality(&f->c, plb_picture_quality(sheet->level), TRUE);
    for (int k = 0; k < f->c.num_components; k++) /* a line is too thin for colour at half the resolution */
        f->c.comp_info[k].h_samp_factor = f->c.comp_info[k].v_samp_factor = 1;
    f->c.density_unit = 1; /* per inch */
    f->c.X_density = f->c.Y_density = (UINT16)floor(sheet->dpi + 0.5);
    jpeg_start_compress(&f->c, TRUE);
    put_texts(f);
}

static bool begin_page(picture *p, error *err)
{
    jpeg_file *f = p->own = plb_new(1, sizeof *f);
    if (!f || !(f->row = plb_new((size_t)p->page->width, (size_t)p->channels)))
        return plb_fail_memory(err);
    f->p = p;
    f->c.err = jpeg_std_error(&f->errors);
    f->errors.error_exit = on_error;
    f->errors.output_message = on_message;
    f->c.client_data = f;
    if (setjmp(f->failed))
        return fail(f, err);
    jpeg_create_compress(&f->c);
    f->c.client_data = f;
    f->to = (struct jpeg_destination_mgr){.init_destination = begin_buffer, .empty_output_buffer = empty_buffer, .term_destination = end_buffer};
    f->c.dest = &f->to;
    begin_rows(f);
    return true;
}

static bool add(picture *p, error *err)
{
    jpeg_file *f = p->own;
    if (setjmp(f->failed))
        return fail(f, err);
    while ((int)f->c.next_scanline < p->band->top + p->band->rows) {
        plb_picture_row(p, (int)f->c.next_scanline, f->row);
        jpeg_write_scanlines(&f->c, &f->row, 1);
    }
    return true;
}

static bool end_page(picture *p, error *err)
{
    jpeg_file *f = p->own;
    if (setjmp(f->failed))
        return fail(f, err);
    jpeg_finish_compress(&f->c);
    return true;
}

static void drop(picture *p)
{
    jpeg_file *f = p->own;
    if (!f)
        return;
    if (f->c.mem)
        jpeg_destroy_compress(&f->c);
    plb_free(f->row);
    plb_free(f);
}

#define JPEG_FUNCTIONS .built = true, .begin_page = begin_page, .add = add, .end_page = end_page, .drop = drop
#else
#define JPEG_FUNCTIONS .built = false
#endif

const picture_format plb_jpeg_format = {.name = "JPEG", .suffixes = "jpg jpeg", .package = "libjpeg-dev", .max_side = 65500, JPEG_FUNCTIONS};
