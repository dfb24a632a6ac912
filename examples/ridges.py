#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library in Python, through ctypes: rows of hills, each of which hides what lies behind it.

    python3 ridges.py [libplumbago.so]

Writes ridges.png and ridges.svg, and says how dark the page is: from pixels in memory, as an array where numpy is there.
"""
import ctypes
import math
import sys

try:
    import numpy
except ImportError:
    numpy = None

DOUBLE, SIZE, POINTER, TEXT = ctypes.c_double, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_char_p


class Error(ctypes.Structure):
    _fields_ = [("status", ctypes.c_int), ("text", ctypes.c_char * 512)]


class Pixels(ctypes.Structure):
    _fields_ = [("data", POINTER), ("stride", SIZE), ("format", ctypes.c_int), ("x", ctypes.c_int), ("y", ctypes.c_int),
                ("width", ctypes.c_int), ("height", ctypes.c_int)]


GREY = 0
library = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else "libplumbago.so.0")


def function(name, result, *arguments):
    """A function of the library; one that can fail, which all with an error as last argument can, raises what it says."""
    f = getattr(library, name)
    f.restype, f.argtypes = result, arguments
    if not arguments or arguments[-1] is not ctypes.POINTER(Error):
        return f

    def checked(*given):
        error = Error()
        value = f(*given, ctypes.byref(error))
        if not value:
            raise RuntimeError(error.text.decode())
        return value
    return checked


ERROR = ctypes.POINTER(Error)
options_new = function("plb_options_new", POINTER)
options_set = function("plb_options_set", ctypes.c_bool, POINTER, TEXT, TEXT, ERROR)
options_free = function("plb_options_free", None, POINTER)
canvas_new = function("plb_canvas_new", POINTER, DOUBLE, DOUBLE, ERROR)
canvas_free = function("plb_canvas_free", None, POINTER)
move_to = function("plb_canvas_move_to", None, POINTER, DOUBLE, DOUBLE)
line_to = function("plb_canvas_line_to", None, POINTER, DOUBLE, DOUBLE)
set_colour = function("plb_canvas_set_colour", None, POINTER, DOUBLE, DOUBLE, DOUBLE, DOUBLE)
stroke = function("plb_canvas_stroke", None, POINTER)
fill = function("plb_canvas_fill", None, POINTER)
draw = function("plb_canvas_draw", POINTER, POINTER, POINTER, ERROR)
drawing_free = function("plb_drawing_free", None, POINTER)
write = function("plb_drawing_write", ctypes.c_bool, POINTER, TEXT, POINTER, ERROR)
size = function("plb_drawing_size", ctypes.c_bool, POINTER, ctypes.POINTER(ctypes.c_int), ctypes.POINTER(ctypes.c_int), POINTER, ERROR)
render = function("plb_drawing_render_pixels", ctypes.c_bool, POINTER, ctypes.POINTER(Pixels), POINTER, ERROR)


def height(x, row):
    """Of the hills of a row, at x from -1 to 1, mm."""
    away = math.exp(-6 * x * x)
    return away * (4 + 9 * abs(math.sin(5 * x + 1.7 * row)) * math.cos(2.3 * x - 0.9 * row) ** 2)


def draw_ridges(canvas):
    xs = [i / 60 - 1 for i in range(121)]
    for row in range(14):
        bottom = 30 + 5.5 * row
        points = [(55 + 45 * x, bottom - height(x, row)) for x in xs]
        set_colour(canvas, 1, 1, 1, 1)  # paper in front of what lies behind
        move_to(canvas, 10, bottom + 4)
        for x, y in points:
            line_to(canvas, x, y)
        line_to(canvas, 100, bottom + 4)
        fill(canvas)
        set_colour(canvas, 0, 0, 0, 1)
        move_to(canvas, *points[0])
        for x, y in points[1:]:
            line_to(canvas, x, y)
        stroke(canvas)


def darkness(drawing, options):
    """The mean of the page, 0 paper to 1 black."""
    w, h = ctypes.c_int(), ctypes.c_int()
    size(drawing, ctypes.byref(w), ctypes.byref(h), options)
    if numpy is not None:
        page = numpy.empty((h.value, w.value), numpy.uint8)
        render(drawing, ctypes.byref(Pixels(page.ctypes.data, page.strides[0], GREY, 0, 0, w.value, h.value)), options)
        return 1 - page.mean() / 255
    page = (ctypes.c_uint8 * (w.value * h.value))()
    render(drawing, ctypes.byref(Pixels(ctypes.addressof(page), w.value, GREY, 0, 0, w.value, h.value)), options)
    return 1 - sum(page) / len(page) / 255


def main():
    options = options_new()
    options_set(options, b"pencil", b"B")
    options_set(options, b"dpi", b"150")
    canvas = canvas_new(110, 115)
    draw_ridges(canvas)
    drawing = draw(canvas, options)
    write(drawing, b"ridges.png", options)
    write(drawing, b"ridges.svg", options)
    print(f"darkness {darkness(drawing, options):.4f}")
    drawing_free(drawing)
    canvas_free(canvas)
    options_free(options)


main()
