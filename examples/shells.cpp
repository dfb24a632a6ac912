/* SPDX-License-Identifier: MIT
 *
 * The library in C++: pointers that free what they hold, a progress function that may be any closure, and a file made in memory.
 * It draws nested spirals of circles, as on a shell. Writes shells.png.
 * Build: c++ shells.cpp $(pkg-config --cflags --libs plumbago) -o shells
 */
#include <plumbago.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

template <auto function> struct freed_by {
    template <typename T> void operator()(T *p) const { function(p); }
};
using canvas = std::unique_ptr<plb_canvas, freed_by<plb_canvas_free>>;
using drawing = std::unique_ptr<plb_drawing, freed_by<plb_drawing_free>>;
using options = std::unique_ptr<plb_options, freed_by<plb_options_free>>;
using bytes = std::unique_ptr<void, freed_by<plb_memory_free>>;

/* What failed, as an exception. */
template <typename T> T checked(T result, const plb_error &error)
{
    if (!result)
        throw std::runtime_error(error.text);
    return result;
}

static void draw_shell(plb_canvas *c, double x, double y, double size)
{
    double angle = 0;
    for (double radius = size; radius > 0.8; radius *= 0.9, angle += 0.55) {
        double out = size * 2.6 - radius * 1.6;
        plb_canvas_arc(c, x + 0.35 * out * std::cos(angle), y + 0.35 * out * std::sin(angle), radius, 0, 2 * 3.14159265358979);
        plb_canvas_close_path(c);
        plb_canvas_stroke(c);
    }
}

int main()
try {
    plb_error error;
    options o{plb_options_new()};
    checked(o && plb_options_set(o.get(), "dpi", "150", &error), error);
    double told = 0;
    plb_options_set_progress(o.get(), [](void *to, double done) { *static_cast<double *>(to) = done; return true; }, &told);

    canvas c{checked(plb_canvas_new(110, 70, &error), error)};
    draw_shell(c.get(), 36, 36, 15);
    draw_shell(c.get(), 82, 34, 11);
    drawing d{checked(plb_canvas_draw(c.get(), o.get(), &error), error)};

    std::size_t n;
    bytes png{checked(plb_drawing_write_memory(d.get(), "png", &n, o.get(), &error), error)};
    std::ofstream("shells.png", std::ios::binary).write(static_cast<const char *>(png.get()), static_cast<std::streamsize>(n));
    std::cout << plb_drawing_strokes(d.get()) << " strokes, " << told * 100 << " % done\n";
} catch (const std::exception &e) {
    std::cerr << "shells: " << e.what() << '\n';
    return 1;
}
