#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the models of this folder: house.obj, bracket.obj, chair.obj, knot.obj.

    ./models.py [FOLDER]
"""
import math
import os
import sys


class Model:
    """Places and faces; y points upwards, the front looks along z, as most OBJ files have it."""

    def __init__(self):
        self.places, self.lines, self.numbers = [], [], {}

    def place(self, p):
        key = tuple(round(x, 3) + 0.0 for x in p)
        if key not in self.numbers:
            self.numbers[key] = len(self.places) + 1
            self.places.append(key)
        return self.numbers[key]

    def face(self, *corners):
        self.lines.append("f " + " ".join(str(self.place(p)) for p in corners))

    def material(self, name):
        self.lines.append("usemtl " + name)

    def box(self, x0, y0, z0, x1, y1, z1):
        p = [[[(x, y, z) for z in (z0, z1)] for y in (y0, y1)] for x in (x0, x1)]
        self.face(p[0][0][1], p[1][0][1], p[1][1][1], p[0][1][1])
        self.face(p[1][0][0], p[0][0][0], p[0][1][0], p[1][1][0])
        self.face(p[0][0][0], p[0][0][1], p[0][1][1], p[0][1][0])
        self.face(p[1][0][1], p[1][0][0], p[1][1][0], p[1][1][1])
        self.face(p[0][1][1], p[1][1][1], p[1][1][0], p[0][1][0])
        self.face(p[0][0][0], p[1][0][0], p[1][0][1], p[0][0][1])

    def prism(self, outline, move):
        """The outline, counter-clockwise when seen against `move`, is the far end; the near one lies at outline + move."""
        near = [tuple(a + b for a, b in zip(p, move)) for p in outline]
        n = len(outline)
        self.face(*near)
        self.face(*reversed(outline))
        for i in range(n):
            k = (i + 1) % n
            self.face(outline[i], outline[k], near[k], near[i])

    def write(self, file, what):
        with open(file, "w") as out:
            out.write(f"# {what}; made by models.py\n")
            for p in self.places:
                out.write("v %g %g %g\n" % p)
            for line in self.lines:
                out.write(line + "\n")


def wall(m, at, openings, width, height, deep):
    """A wall with openings (x, y, width, height), each a frame and a pane `deep` behind it. `at` maps (along, up, inwards) to space. Strips
    between the openings make the wall: each face is a rectangle."""
    xs = sorted({0, width} | {o[0] for o in openings} | {o[0] + o[2] for o in openings})
    ys = sorted({0, height} | {o[1] for o in openings} | {o[1] + o[3] for o in openings})
    for x0, x1 in zip(xs, xs[1:]):
        for y0, y1 in zip(ys, ys[1:]):
            if not any(o[0] <= x0 and x1 <= o[0] + o[2] and o[1] <= y0 and y1 <= o[1] + o[3] for o in openings):
                m.face(at(x0, y0, 0), at(x1, y0, 0), at(x1, y1, 0), at(x0, y1, 0))
    for x, y, w, h, panes in openings:
        u, v = x + w, y + h
        rim = [(x, y), (u, y), (u, v), (x, v)]
        for i in range(4):
            a, b = rim[i], rim[(i + 1) % 4]
            m.face(at(*a, 0), at(*a, deep), at(*b, deep), at(*b, 0))
        bar = 0.06
        columns, rows = panes
        for i in range(columns):
            for k in range(rows):
                px0, px1 = x + w * i / columns, x + w * (i + 1) / columns
                py0, py1 = y + h * k / rows, y + h * (k + 1) / rows
                inner = [(px0 + bar, py0 + bar), (px1 - bar, py0 + bar), (px1 - bar, py1 - bar), (px0 + bar, py1 - bar)]
                outer = [(px0, py0), (px1, py0), (px1, py1), (px0, py1)]
                for j in range(4):
                    a, b, c, d = outer[j], outer[(j + 1) % 4], inner[(j + 1) % 4], inner[j]
                    m.face(at(*a, deep), at(*b, deep), at(*c, deep), at(*d, deep))
                    m.face(at(*d, deep), at(*c, deep), at(*c, deep + 0.05), at(*d, deep + 0.05))
                m.face(*[at(*p, deep + 0.05) for p in inner])


def house():
    m = Model()
    w, d, h, ridge = 9.0, 7.0, 3.0, 5.6
    window, tall = (1.2, 1.3, (2, 2)), (1.0, 2.1, (1, 1))

    def opening(x, y, kind):
        return (x, y, kind[0], kind[1], kind[2])

    wall(m, lambda x, y, z: (x, y, d - z), [opening(1.0, 0.9, window), opening(4.0, 0.0, tall), opening(6.4, 0.9, window)], w, h, 0.15)
    wall(m, lambda x, y, z: (w - x, y, z), [opening(1.0, 0.9, window), opening(6.4, 0.9, window)], w, h, 0.15)
    wall(m, lambda x, y, z: (w - z, y, d - x), [opening(1.2, 0.9, window), opening(4.6, 0.9, window)], d, h, 0.15)
    wall(m, lambda x, y, z: (z, y, x), [opening(2.9, 0.9, window)], d, h, 0.15)
    for x in (0, w):
        gable = [(x, h, d), (x, h, 0), (x, ridge, d / 2)]
        m.face(*(gable if x else reversed(gable)))
    # The roof is two slabs that stand over on all sides.
    over, thick = 0.6, 0.18
    slope = (ridge - h) / (d / 2)
    for side in (1, -1):
        def at(along, out, up):
            z = d / 2 + side * out
            return (along, ridge - slope * out + up, z)
        eave = d / 2 + over
        outline = [at(-over, 0, 0), at(-over, eave, 0), at(-over, eave, thick), at(-over, 0, thick)]
        if side < 0:
            outline.reverse()
        m.prism(outline, (w + 2 * over, 0, 0))
    m.box(6.6, 4.2, 1.6, 7.3, 6.4, 2.3)
    m.box(6.5, 6.4, 1.5, 7.4, 6.55, 2.4)
    m.box(3.6, -0.2, d, 5.4, 0, d + 1.2)
    m.box(3.3, -0.4, d, 5.7, -0.2, d + 1.6)
    m.box(-0.1, -0.4, -0.1, w + 0.1, 0, d)
    return m, "a house"


def ring(centre, radius, n, axis, turned=False):
    points = []
    for i in range(n):
        a = 2 * math.pi * i / n * (-1 if turned else 1)
        c, s = radius * math.cos(a), radius * math.sin(a)
        x, y, z = centre
        points.append({"x": (x, y + c, z + s), "y": (x + s, y, z + c), "z": (x + c, y + s, z)}[axis])
    return points


def with_hole(outline, hole):
    """One face with a hole: a line leads from the outline to the hole and back."""
    best = min((math.dist(p, q), i, k) for i, p in enumerate(outline) for k, q in enumerate(hole))
    _, i, k = best
    return outline[:i + 1] + hole[k:] + hole[:k + 1] + outline[i:]


def tube(m, a, b):
    """The wall of a hole between two rings, seen from inside."""
    for i in range(len(a)):
        k = (i + 1) % len(a)
        m.face(a[i], b[i], b[k], a[k])


def bracket():
    m = Model()
    n, t = 48, 8.0
    # The foot lies on the ground, with two holes in a rounded plate; the back stands on it, with a bore.
    plate = [(0, 0, 0), (80, 0, 0), (80, 0, 30)]
    for i in range(n // 4 + 1):
        a = math.pi / 2 * i / (n // 4)
        plate.append((68 + 12 * math.cos(a), 0, 30 + 12 + 12 * math.sin(a) - 12))
    for i in range(n // 4 + 1):
        a = math.pi / 2 * (1 + i / (n // 4))
        plate.append((12 + 12 * math.cos(a), 0, 30 + 12 + 12 * math.sin(a) - 12))
    outline = []
    for p in plate:
        if not outline or math.dist(p, outline[-1]) > 1e-6:
            outline.append(p)
    if math.dist(outline[0], outline[-1]) < 1e-6:
        outline.pop()
    top = [(x, t, z) for x, y, z in outline]
    holes = [(20, 26), (60, 26)]
    face_top, face_low = list(reversed(top)), list(outline)
    for x, z in holes:
        face_top = with_hole(face_top, ring((x, t, z), 5.5, n, "y", True))
        face_low = with_hole(face_low, ring((x, 0, z), 5.5, n, "y"))
        tube(m, ring((x, t, z), 5.5, n, "y", True), ring((x, 0, z), 5.5, n, "y", True))
    m.face(*face_top)
    m.face(*face_low)
    for i in range(len(outline)):
        k = (i + 1) % len(outline)
        m.face(outline[k], outline[i], top[i], top[k])
    # The back: an arch with a bore.
    back = [(12, t, 0), (68, t, 0), (68, 45, 0)]
    for i in range(1, n // 2):
        a = math.pi * i / (n // 2)
        back.append((40 + 28 * math.cos(a), 45 + 28 * math.sin(a), 0))
    back.append((12, 45, 0))
    front = [(x, y, 10) for x, y, z in back]
    m.face(*with_hole(front, ring((40, 45, 10), 20, n, "z", True)))
    m.face(*with_hole(list(reversed(back)), ring((40, 45, 0), 15, n, "z")))
    tube(m, ring((40, 45, 16), 15, n, "z", True), ring((40, 45, 0), 15, n, "z", True))
    for i in range(len(back)):
        k = (i + 1) % len(back)
        if not (back[i][1] == t and back[k][1] == t):
            m.face(back[i], back[k], front[k], front[i])
    # Ribs beside the bore, and a boss around it.
    for x in (14, 60):
        m.prism([(x, t, 10), (x, t, 36), (x, 34, 10)], (6, 0, 0))
    outer, far = ring((40, 45, 10), 20, n, "z"), ring((40, 45, 16), 20, n, "z")
    m.face(*with_hole(far, ring((40, 45, 16), 15, n, "z", True)))
    for i in range(n):
        k = (i + 1) % n
        m.face(outer[i], outer[k], far[k], far[i])
    return m, "a bracket with holes, mm"


def chair():
    m = Model()
    m.box(0, 430, 0, 440, 460, 430)
    for x in (10, 390):
        m.box(x, 0, 380, x + 40, 430, 420)
        m.box(x, 0, 10, x + 40, 920, 50)
    m.box(50, 840, 18, 390, 910, 42)
    m.box(50, 740, 18, 390, 780, 42)
    for i in range(4):
        m.box(80 + 80 * i, 460, 22, 120 + 80 * i, 740, 38)
    m.box(22, 180, 50, 38, 210, 380)
    m.box(402, 180, 50, 418, 210, 380)
    m.box(38, 187, 207, 402, 203, 223)
    m.box(50, 370, 22, 390, 430, 40)
    m.box(50, 370, 390, 390, 430, 408)
    m.box(22, 370, 50, 40, 430, 380)
    m.box(400, 370, 50, 418, 430, 380)
    return m, "a chair, mm"


def knot():
    m = Model()
    p, q, along, around = 2, 3, 120, 16

    def centre(t):
        r = 2 + math.cos(q * t)
        return (r * math.cos(p * t), r * math.sin(p * t), math.sin(q * t))

    def minus(a, b):
        return tuple(x - y for x, y in zip(a, b))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def unit(a):
        length = math.sqrt(sum(x * x for x in a))
        return tuple(x / length for x in a)

    rings = []
    for i in range(along):
        t = 2 * math.pi * i / along
        c, way = centre(t), unit(minus(centre(t + 1e-3), centre(t - 1e-3)))
        side = unit(cross(way, unit(c)))
        other = cross(side, way)
        rings.append([tuple(c[k] + 0.45 * (math.cos(a) * side[k] + math.sin(a) * other[k]) for k in range(3))
                      for a in (2 * math.pi * j / around for j in range(around))])
    for i in range(along):
        for j in range(around):
            a, b = rings[i], rings[(i + 1) % along]
            k = (j + 1) % around
            m.face(a[j], b[j], b[k], a[k])
    return m, "a torus knot"


if __name__ == "__main__":
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for make in (house, bracket, chair, knot):
        model, said = make()
        model.write(os.path.join(folder, make.__name__ + ".obj"), said)
