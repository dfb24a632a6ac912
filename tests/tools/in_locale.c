/* SPDX-License-Identifier: MIT
 *
 * in_locale HELPERS DRAWING THREADS OUT.png OUT.pdf OUT.txt: a program that lives in the user's locale, as the programs of
 * this project never do, has the library draw. Prints the locale's decimal point.
 */
#include "api/plumbago.h"

#include <locale.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    if (argc != 7) {
        fprintf(stderr, "usage: in_locale HELPERS DRAWING THREADS OUT.png OUT.pdf OUT.txt\n");
        return 2;
    }
    if (!setlocale(LC_ALL, "")) {
        fprintf(stderr, "in_locale: there is no such locale\n");
        return 2;
    }
    plb_error error;
    plb_options *options = plb_options_new();
    bool set = options && plb_options_set(options, "helper-dir", argv[1], &error) && plb_options_set(options, "threads", argv[3], &error);
    plb_drawing *drawing = set ? plb_drawing_load(argv[2], options, &error) : NULL;
    bool good = drawing && plb_drawing_write_png(drawing, argv[4], options, &error) &&
                plb_drawing_write_pdf(drawing, argv[5], options, &error) &&
                plb_drawing_dump(drawing, PLB_DUMP_STROKES, argv[6], options, &error);
    if (!good)
        fprintf(stderr, "in_locale: %s\n", error.text);
    plb_drawing_free(drawing);
    plb_options_free(options);
    printf("%s\n", localeconv()->decimal_point);
    return !good;
}
