/* SPDX-License-Identifier: MIT
 *
 * DXF: the helper program tap-dxf (Python, the library ezdxf) turns the file into an SVG text in memory, which is
 * then read like any other SVG. It also chooses the scale on paper, which becomes the list's.
 */
#include "input/converter.h"
#include "input/tap.h"

#include "base/number/number.h"

#include <string.h>

/* Says why the process did not succeed. */
static bool explain_end(const input_source *in, process *p, error *err)
{
    if (p->code == 126 || p->code == 127)
        return plb_fail(err, ERROR_HELPER, "%s: reading DXF needs python3, which does not start", in->name);
    return plb_tap_explain_status(in, "tap-dxf", p, err);
}

/* Passes on the lines "warning: ..." and "detail: ...". */
static void pass_on(const input_source *in, char *text)
{
    static const char warning[] = "warning: ", detail[] = "detail: ";
    for (char *line = text, *next; *line; line = next) {
        size_t n = strcspn(line, "\n");
        next = line + n + (line[n] != '\0');
        line[n] = '\0';
        if (!strncmp(line, warning, strlen(warning)))
            plb_log(&in->say, MESSAGE_WARNING, "%s: %s", in->name, line + strlen(warning));
        else if (!strncmp(line, detail, strlen(detail)))
            plb_log(&in->say, MESSAGE_DETAIL, "%s: %s", in->name, line + strlen(detail));
    }
}

static bool run_tap(const input_source *in, converter_bytes *svg, error *err)
{
    char program[PROCESS_PATH_MAX], name[] = "tap-dxf";
    const char *argv[] = {name, NULL};
    process p;
    error late = {ERROR_NONE, ""};
    if (!plb_process_find(in->helper_dir, name, program, &late))
        return plb_fail(err, late.kind, "%s: %s", in->name, late.text);
    if (!plb_converter_run(in, "ezdxf", program, argv, &p, svg, err))
        return false;
    if (p.code != TAP_DONE)
        return explain_end(in, &p, err);
    pass_on(in, p.message);
    return true;
}

/* The first line, "%%Plumbago-tap-dxf 1 SCALE"; `rest` gets what follows it. */
static bool read_head(const converter_bytes *all, double *scale, size_t *rest)
{
    static const char sign[] = "%%Plumbago-tap-dxf 1 ";
    size_t n = strlen(sign);
    const char *newline = all->n ? memchr(all->v, '\n', all->n) : NULL;
    if (!newline || (size_t)(newline - all->v) <= n || memcmp(all->v, sign, n))
        return false;
    *rest = (size_t)(newline - all->v) + 1;
    return plb_parse_number(all->v + n, newline, scale, NULL) && *scale > 0 && *scale < 1e15;
}

bool plb_read_dxf(const input_source *in, display_list *list, error *err)
{
    converter_bytes svg = {0};
    size_t rest = 0;
    double scale = 1;
    bool good = run_tap(in, &svg, err);
    if (good && !read_head(&svg, &scale, &rest))
        good = plb_fail(err, ERROR_HELPER, "%s: cannot read what tap-dxf wrote", in->name);
    if (good) {
        input_source as_svg = *in;
        as_svg.data = svg.v + rest;
        as_svg.size = svg.n - rest;
        good = plb_read_svg(&as_svg, list, err);
        list->paper_scale = scale;
    }
    array_free(&svg);
    return good;
}
