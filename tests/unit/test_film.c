/* SPDX-License-Identifier: MIT
 *
 * Films: which rectangles are stored, that they put together give the frames again, how long each is shown, and that nothing is left of a film that
 * is broken off. The reader here knows as much of PNG as these films need.
 */
#include "check.h"

#include "film/film.h"

#include <dirent.h>
#include <unistd.h>
#include <zlib.h>

enum { W = 90, H = 60, FRAMES = 7, CHANNELS_MAX = 4 };

/* A square that moves; frame 3 is like frame 2. */
static void draw_frame(uint8_t *to, int channels, int k)
{
    int at = (k == 3 ? 2 : k) * 9;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            for (int c = 0; c < channels; c++)
                to[(y * W + x) * channels + c] = x >= at && x < at + 10 && y >= 20 && y < 31 ? (uint8_t)(x * 7 + y * 13 + c * 40) : 255;
}

static film_page page_of(int channels)
{
    return (film_page){.width = W, .height = H, .channels = channels, .rate = 25, .dpi = 100, .level = 1, .members = 1};
}

static bool write_film(const char *name, const film_page *page)
{
    static uint8_t pixels[W * H * CHANNELS_MAX];
    error err = {ERROR_NONE, ""};
    film_writer *w = plb_film_writer_open(name, page, NULL, &err);
    bool ok = w != NULL;
    for (int k = 0; ok && k < FRAMES; k++) {
        draw_frame(pixels, page->channels, k);
        ok = plb_film_writer_add(w, pixels, (size_t)(W * page->channels), k == 5 ? 3 : 1, &err);
    }
    ok = ok ? plb_film_writer_close(w, &err) : (plb_film_writer_abort(w), false);
    if (!ok)
        printf("  %s\n", err.text);
    return ok;
}

/* ---- the reader ---- */

typedef struct {
    uint8_t *bytes;
    size_t n;
} file;

static file read_file(const char *name)
{
    file f = {calloc(1 << 20, 1), 0};
    FILE *from = fopen(name, "rb");
    if (from) {
        f.n = fread(f.bytes, 1, 1 << 20, from);
        fclose(from);
    }
    return f;
}

static uint32_t number(const uint8_t *at, int bytes)
{
    uint32_t v = 0;
    while (bytes-- > 0)
        v = v << 8 | *at++;
    return v;
}

typedef struct {
    int width, height, channels, frames, shown, loops, stored; /* stored: pixels of all rectangles */
    int rectangle[4], rate;
    int duration[FRAMES + 1];
    uint32_t sequence;
    uint8_t data[1 << 20], screen[W * H * CHANNELS_MAX * FRAMES];
    size_t n;
    bool is_wrong;
} reader;

/* Unpacks the frame at hand, whose rows are not filtered, onto the screen. */
static void unpack(reader *r)
{
    int x0 = r->rectangle[2], y0 = r->rectangle[3], w = r->rectangle[0] ? r->rectangle[0] : r->width, h = r->rectangle[1] ? r->rectangle[1] : r->height;
    uLongf row = (uLongf)(w * r->channels + 1), size = row * (uLongf)h;
    uint8_t *raw = malloc(size + 1);
    r->is_wrong = r->is_wrong || x0 + w > r->width || y0 + h > r->height || uncompress(raw, &size, r->data, r->n) != Z_OK || size != row * (uLongf)h;
    for (int y = 0; !r->is_wrong && y < h; y++)
        memcpy(r->screen + ((y0 + y) * r->width + x0) * r->channels, raw + (size_t)y * row + 1, row - 1);
    r->stored += w * h;
    r->n = 0;
    free(raw);
}

static void take_control(reader *r, const uint8_t *at)
{
    r->is_wrong = r->is_wrong || number(at, 4) != r->sequence++ || at[24] || at[25];
    for (int k = 0; k < 4; k++)
        r->rectangle[k] = (int)number(at + 4 + 4 * k, 4);
    r->duration[r->shown++ % FRAMES] = (int)number(at + 20, 2);
    r->rate = (int)number(at + 22, 2);
}

static void take_chunk(reader *r, const char *type, const uint8_t *at, size_t n)
{
    static const int channels[] = {1, 0, 3, 0, 2, 0, 4};
    bool is_data = !memcmp(type, "IDAT", 4), is_more = !memcmp(type, "fdAT", 4);
    if (!is_data && !is_more && r->n)
        unpack(r);
    if (!memcmp(type, "IHDR", 4)) {
        r->width = (int)number(at, 4);
        r->height = (int)number(at + 4, 4);
        r->channels = channels[at[9]];
    } else if (!memcmp(type, "acTL", 4)) {
        r->frames = (int)number(at, 4);
        r->loops = (int)number(at + 4, 4);
    } else if (!memcmp(type, "fcTL", 4)) {
        take_control(r, at);
    } else if (is_data || is_more) {
        r->is_wrong = r->is_wrong || (is_more && number(at, 4) != r->sequence++);
        memcpy(r->data + r->n, at + (is_more ? 4 : 0), n - (is_more ? 4 : 0));
        r->n += n - (is_more ? 4 : 0);
    }
}

/* Reads until the frame number `until`, from 1, is on the screen. */
static reader *read_film(const char *name, int until)
{
    file f = read_file(name);
    reader *r = calloc(1, sizeof *r);
    r->is_wrong = f.n < 8 || memcmp(f.bytes, "\x89PNG\r\n\x1a\n", 8) != 0;
    for (size_t at = 8; at + 12 <= f.n;) {
        size_t n = number(f.bytes + at, 4);
        const uint8_t *type = f.bytes + at + 4;
        r->is_wrong = r->is_wrong || at + 12 + n > f.n || number(type + 4 + n, 4) != crc32(0, type, (uInt)n + 4);
        if (r->is_wrong || (!memcmp(type, "fcTL", 4) && r->shown == until && r->n == 0))
            break;
        take_chunk(r, (const char *)type, type + 4, n);
        if (r->shown == until && r->n && !memcmp(type, "fcTL", 4) == 0 && (at + 12 + n >= f.n || memcmp(f.bytes + at + 12 + n + 4, type, 4) != 0))
            unpack(r);
        at += 12 + n;
    }
    free(f.bytes);
    return r;
}

/* ---- tests ---- */

static void frames_come_back(void)
{
    static uint8_t meant[W * H * CHANNELS_MAX];
    for (int channels = 1; channels <= CHANNELS_MAX; channels++) {
        film_page page = page_of(channels);
        CHECK(write_film("film.png", &page));
        for (int k = 1; k < FRAMES; k++) { /* of the seven frames two are alike: six are stored */
            reader *r = read_film("film.png", k);
            draw_frame(meant, channels, k <= 3 ? k - 1 : k);
            CHECK(!r->is_wrong && r->frames == FRAMES - 1 && r->shown == k && r->channels == channels);
            CHECK(!memcmp(r->screen, meant, (size_t)(W * H * channels)));
            free(r);
        }
    }
}

static void only_what_changed_is_stored(void)
{
    film_page page = page_of(1);
    page.loops = 3;
    CHECK(write_film("film.png", &page));
    reader *r = read_film("film.png", FRAMES);
    CHECK(r->loops == 3 && r->rate == 25);
    CHECK(r->duration[0] == 1 && r->duration[2] == 2 && r->duration[4] == 3);
    CHECK(r->stored == W * H + 4 * 19 * 11 + 28 * 11);
    free(r);
}

static void threads_do_not_matter(void)
{
    film_page page = page_of(3);
    CHECK(write_film("one.png", &page));
    page.members = 3;
    CHECK(write_film("three.png", &page));
    file a = read_file("one.png"), b = read_file("three.png");
    CHECK(a.n == b.n && a.n > 0 && !memcmp(a.bytes, b.bytes, a.n));
    free(a.bytes);
    free(b.bytes);
}

/* Numbered pictures are as many as the film has frames, repeated ones too. */
static void numbered_pictures(void)
{
    static uint8_t meant[W * H];
    film_page page = page_of(1);
    CHECK(write_film("n-%03d.png", &page));
    reader *r = read_film("n-009.png", 1);
    draw_frame(meant, 1, 6);
    CHECK(!r->is_wrong && r->frames == 0 && !memcmp(r->screen, meant, sizeof meant));
    CHECK(access("n-001.png", F_OK) == 0 && access("n-010.png", F_OK) != 0);
    free(r);
}

static void sheet_of_cells(void)
{
    static uint8_t meant[W * H];
    film_page page = page_of(1);
    page.columns = 3;
    CHECK(write_film("sheet.png", &page));
    reader *r = read_film("sheet.png", 1);
    CHECK(!r->is_wrong && r->width == 3 * W && r->height == 3 * H);
    for (int k = 0; k < FRAMES; k++) {
        draw_frame(meant, 1, k);
        for (int y = 0; y < H; y++)
            CHECK(!memcmp(r->screen + (k / 3 * H + y) * 3 * W + k % 3 * W, meant + y * W, W));
    }
    free(r);
    file f = read_file("sheet.json");
    CHECK(strstr((char *)f.bytes, "{\"frame\": {\"x\": 180, \"y\": 60, \"w\": 90, \"h\": 60}, \"duration\": 120}"));
    CHECK(strstr((char *)f.bytes, "\"image\": \"sheet.png\""));
    free(f.bytes);
    page.rows = 2; /* six cells for seven frames */
    CHECK(!write_film("small.png", &page) && access("small.png", F_OK) != 0 && access("small.json", F_OK) != 0);
}

static int files_here(void)
{
    DIR *here = opendir(".");
    int n = 0;
    while (here && readdir(here))
        n++;
    closedir(here);
    return n;
}

static void nothing_is_left(void)
{
    static const char *const names[] = {"gone.png", "gone-%d.png", "sheet-gone.png"};
    static uint8_t pixels[W * H];
    int before = files_here();
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        error err = {ERROR_NONE, ""};
        film_page page = page_of(1);
        page.columns = i == 2 ? 4 : 0;
        film_writer *w = plb_film_writer_open(names[i], &page, NULL, &err);
        CHECK(w && plb_film_writer_add(w, pixels, W, 1, &err));
        plb_film_writer_abort(w);
        w = plb_film_writer_open(names[i], &page, NULL, &err);
        CHECK(w && !plb_film_writer_close(w, &err)); /* no frame */
    }
    CHECK(files_here() == before);
}

static void bad_names(void)
{
    static const char *const names[] = {"film.jpeg", "n-%d.gif", "nowhere/film.png", "nowhere/n-%d.png"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        error err = {ERROR_NONE, ""};
        film_page page = page_of(1);
        CHECK(!plb_film_writer_open(names[i], &page, NULL, &err) && strstr(err.text, "n"));
    }
}

int main(void)
{
    RUN(frames_come_back);
    RUN(only_what_changed_is_stored);
    RUN(threads_do_not_matter);
    RUN(numbered_pictures);
    RUN(sheet_of_cells);
    RUN(nothing_is_left);
    RUN(bad_names);
    CHECK_EXIT;
}
