#!/usr/bin/python3 -ISB
# SPDX-License-Identifier: MIT
"""tap-dxf: DXF on descriptor 0 becomes SVG on descriptor 1, sized in millimetres on paper.

The library ezdxf reads the file and takes it apart (blocks, layers, colours, line types, dimensions, hatches, text);
what is here chooses the paper scale and writes down what ezdxf draws. No file is named, so none is opened.

The first line of the output is for the caller, the document follows:

    %%Plumbago-tap-dxf 1 SCALE

SCALE is millimetres on paper per millimetre in the drawing. Messages are lines on standard error, "warning: ..." or
"detail: ..." (exit status 0), or the one reason for failing (exit status 2 to 6, see EXIT_ below); where a line of the
file is to blame the reason starts with its number and a colon.

Nothing depends on who the user is and what else is installed: Python starts isolated (-I: no PYTHON variables, no user's
packages) and without site (-S: no .pth files of other packages), the home folder is one that is not there, and matplotlib,
which ezdxf would take for text when it is there, is hidden. Most of the time of a small drawing goes into loading ezdxf, so the
parts that no drawing needs are left out: the parser of queries (pyparsing) and the package of addons.
"""
import importlib.machinery
import io
import logging
import math
import os
import re
import sys
import types

EXIT_DONE, EXIT_USAGE, EXIT_MALFORMED, EXIT_REFUSED, EXIT_WRITE, EXIT_LIMIT, EXIT_MISSING = range(7)


def quit_with(status, message):
    sys.stderr.write(" ".join(message.split())[:400] + "\n")
    sys.stderr.flush()
    os._exit(status)


class EntityNames:
    """The queries that the library makes itself: names of entities with blanks between."""

    @staticmethod
    def parseString(text, parseAll=True):
        return types.SimpleNamespace(EntityQuery=text.split(), AttribQuery="", AttribQueryOptions="")


def prepare_import():
    """Says where packages of the system are, and takes the place of the modules that are not to be loaded."""
    for variable in [name for name in os.environ if name.startswith(("XDG_", "EZDXF_"))]:
        del os.environ[variable]
    os.environ.update(HOME="/nonexistent", OPENBLAS_NUM_THREADS="1")  # newer versions of ezdxf load numpy, which starts threads
    version = f"python{sys.version_info[0]}.{sys.version_info[1]}"
    sys.path += [f"{lib}/{python}/{kind}-packages" for lib in ("/usr/local/lib", "/usr/lib", "/usr/lib64")
                 for python in (version, "python3") for kind in ("dist", "site")]
    sys.modules["matplotlib"] = None  # to import it fails as if it were not there
    found = importlib.machinery.PathFinder.find_spec("ezdxf")
    if found and found.submodule_search_locations:
        sys.modules["ezdxf.queryparser"] = types.ModuleType("ezdxf.queryparser")
        sys.modules["ezdxf.queryparser"].EntityQueryParser = EntityNames
        sys.modules["ezdxf.addons"] = types.ModuleType("ezdxf.addons")
        sys.modules["ezdxf.addons"].__path__ = [folder + "/addons" for folder in found.submodule_search_locations]
    return found is not None


def quit_without_library(is_there, e):
    if isinstance(e, MemoryError) or "map segment" in str(e):
        quit_with(EXIT_LIMIT, "the drawing needs too much memory")
    if not is_there:
        quit_with(EXIT_MISSING, "reading DXF needs the package python3-ezdxf")
    quit_with(EXIT_MISSING, f"python3-ezdxf cannot be used: {type(e).__name__}: {e}")


library_is_there = False
try:
    library_is_there = prepare_import()
    import ezdxf
    from ezdxf import const, recover
    from ezdxf.addons.drawing import Frontend, RenderContext
    from ezdxf.addons.drawing.backend import BackendInterface
    from ezdxf.addons.drawing.config import Configuration, LinePolicy
    from ezdxf.addons.drawing.properties import Filling, LayoutProperties
    from ezdxf.audit import AuditError
    from ezdxf.entities import DXFTagStorage, Insert, factory, ltype
    from ezdxf.lldxf.types import DXFTag, is_valid_handle
    from ezdxf.math import Vec2
    from ezdxf.path import Command, make_path
    from ezdxf.render import hatching
    from ezdxf.tools import fonts
    from ezdxf.tools.fonts import AbstractFont, FontMeasurements
except Exception as e:  # whatever it is, the user hears of it
    quit_without_library(library_is_there, e)

# The preferred scales of ISO 5455, and the ones beyond its ends made in the same way.
SCALES = sorted((a * 10.0**b for a in (1, 2, 5) for b in range(-12, 3)), reverse=True)
PAPER = (420.0, 297.0)  # mm: A3 (ISO 216), either way up
MARGIN = 5.0            # mm around the drawing; chosen by eye
SMALL = 150.0           # mm: what is smaller at 1:1 is enlarged until it is not; chosen by eye
MM_FAR = 1e12           # mm: what lies beyond is a mistake, not a drawing

DOT = 0.25              # mm: radius of a point; chosen by eye
WEIGHT_MIN = 0.13       # mm: of a line; the finest pen of ISO 128-2
PATTERN_MIN = 0.8       # mm: shorter dash patterns look like a solid line; chosen by eye
HATCH_MIN = 0.4         # mm: pattern lines that are closer become a tone; chosen by eye
HATCH_LINES = 20000     # so many lines of one hatch at most; beyond it becomes a tone
FRAME = 16              # flag of a vertex that is a control point of a spline
COPIES = 100000         # of one INSERT at most; beyond it is left out: they would take longer than there is. Chosen by eye
BRIGHT = 0.45           # luma: brighter colours are meant for a dark screen and darkened for paper; chosen by eye

# $INSUNITS: mm and name of the units that somebody draws in.
UNITS = {1: (25.4, "inches"), 2: (304.8, "feet"), 3: (1609344.0, "miles"), 4: (1.0, "mm"), 5: (10.0, "cm"), 6: (1000.0, "m"),
         7: (1e6, "km"), 9: (0.0254, "mils"), 10: (914.4, "yards"), 13: (1e-3, "um"), 14: (100.0, "dm"), 21: (304.8006096, "feet")}

# DejaVu Sans: advances of the characters 32 to 126, and heights of its capitals, small letters and descenders, in
# thousandths of the em. Letters are set a tenth narrower, nearer to the fonts that CAD drawings are made with.
ADVANCES = (
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636, 636, 636,
    636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863,
    748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635,
    615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636,
    337, 636, 838)
CAPITAL, SMALL_LETTER, DESCENDER = 0.729, 0.547, 0.236
NARROWED = 0.9


def advance(character):
    code = ord(character)
    if 32 <= code < 127:
        return ADVANCES[code - 32]
    return 1000 if code >= 0x1100 else 620


def line_width(text, capital_height):
    return sum(map(advance, text)) / 1000 * NARROWED / CAPITAL * capital_height


def measurements(capital_height):
    em = capital_height / CAPITAL
    return FontMeasurements(0, capital_height, SMALL_LETTER * em, DESCENDER * em)


class Letters(AbstractFont):
    """What the library asks when it sets paragraphs; with any font, for all text is set in one."""

    def __init__(self, name, cap_height=1.0, width_factor=1.0):
        super().__init__(measurements(cap_height))
        self.factor = width_factor

    def text_width(self, text):
        return line_width(text, self.measurements.cap_height) * self.factor

    def space_width(self):
        return self.text_width(" ")


def bright_to_dark(color):
    """(#rrggbb for a line on white paper, opacity) of ezdxf's #rrggbb or #rrggbbaa."""
    red, green, blue = (int(color[i : i + 2], 16) for i in (1, 3, 5))
    alpha = int(color[7:9], 16) / 255 if len(color) == 9 else 1.0
    if min(red, green, blue) == 255:
        return "#000000", alpha
    luma = (0.299 * red + 0.587 * green + 0.114 * blue) / 255
    is_colour = max(red, green, blue) - min(red, green, blue) > 40
    if is_colour and luma > BRIGHT:
        red, green, blue = (int(c * BRIGHT / luma) for c in (red, green, blue))
    return f"#{red:02x}{green:02x}{blue:02x}", alpha


def is_sane(*numbers):
    return all(math.isfinite(n) and abs(n) < MM_FAR for n in numbers)


# An item so many times farther off than the others reach has strayed there; chosen by eye.
STRAY = 100.0


class Extents:
    def __init__(self):
        self.x0 = self.y0 = math.inf
        self.x1 = self.y1 = -math.inf

    def add(self, x, y):
        self.x0, self.x1 = min(self.x0, x), max(self.x1, x)
        self.y0, self.y1 = min(self.y0, y), max(self.y1, y)

    def add_curve(self, a, b, c, d):
        for i in range(1, 9):
            t = i / 8
            s = 1 - t
            w = (s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t)
            self.add(*(w[0] * a[k] + w[1] * b[k] + w[2] * c[k] + w[3] * d[k] for k in (0, 1)))

    @property
    def is_empty(self):
        return self.x1 < self.x0


class Recorder(BackendInterface):
    """Keeps what is drawn, in drawing units, until the extents and so the scale are known."""

    def __init__(self):
        self.items = []  # (function of the writer, arguments)
        self.reaches = []  # the extents of each item; empty where it has none of its own
        self.extents = Extents()  # of the item that is being recorded, then of all
        self.insane = 0
        self.lettered = 0  # lines whose line type has letters or shapes, which are left out
        self.lettered_types = ()
        self.width = None  # of the line, drawing units, when a polyline has its own

    def keep(self, how, *what):
        self.items.append((how, what))
        self.reaches.append(self.extents)
        self.extents = Extents()

    def take(self, before):
        """The items from number `before` on, taken back; their extents go to the item that comes."""
        items, reaches = self.items[before:], self.reaches[before:]
        del self.items[before:], self.reaches[before:]
        for r in reaches:
            if not r.is_empty:
                self.extents.add(r.x0, r.y0)
                self.extents.add(r.x1, r.y1)
        return items

    def settle(self):
        """Joins the extents of the items. A few that lie far from all others, as strayed points do, are left out: they would
        shrink the drawing to a dot. Their number is the result."""
        places = [(r, ((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2)) for r in self.reaches if not r.is_empty]
        if not places:
            return 0
        middle = [sorted(at[k] for _, at in places)[len(places) // 2] for k in (0, 1)]
        far = sorted(math.dist(at, middle) for _, at in places)
        usual = max(far[(len(far) - 1) * 9 // 10], max(max(r.x1 - r.x0, r.y1 - r.y0) for r, at in places if math.dist(at, middle) <= far[len(far) // 2]))
        strayed = {id(r) for r, at in places if usual > 0 and math.dist(at, middle) > STRAY * usual}
        if len(strayed) > max(1, len(places) // 50):
            strayed = set()
        kept = [(item, r) for item, r in zip(self.items, self.reaches) if id(r) not in strayed]
        self.items = [item for item, _ in kept]
        for _, r in kept:
            if not r.is_empty:
                self.extents.add(r.x0, r.y0)
                self.extents.add(r.x1, r.y1)
        return len(strayed)

    def trace(self, path, close=False):
        """[(letter, x, y, ...)] of an ezdxf path; its extents are added. None when a point is out of this world."""
        at = (path.start.x, path.start.y)
        steps = [("M", *at)]
        for command in path.commands():
            end = (command.end.x, command.end.y)
            if command.type == Command.LINE_TO:
                steps.append(("L", *end))
            elif command.type == Command.MOVE_TO:
                steps.append(("M", *end))
            elif command.type == Command.CURVE3_TO:
                steps.append(("Q", command.ctrl.x, command.ctrl.y, *end))
            else:
                steps.append(("C", command.ctrl1.x, command.ctrl1.y, command.ctrl2.x, command.ctrl2.y, *end))
            at = end
        if not all(is_sane(*step[1:]) for step in steps):
            self.insane += 1
            return None
        self.add_extents(steps)
        if close or (len(steps) > 2 and not path.has_sub_paths and path.is_closed):
            steps.append(("Z",))
        return steps

    def add_extents(self, steps):
        at = steps[0][1:]
        for step in steps:
            if step[0] == "C":
                self.extents.add_curve(at, step[1:3], step[3:5], step[5:7])
            elif step[0] == "Q":
                self.extents.add_curve(at, step[1:3], step[1:3], step[3:5])
            self.extents.add(*step[-2:])
            at = step[-2:]

    def trace_points(self, points):
        steps = [("M" if i == 0 else "L", p.x, p.y) for i, p in enumerate(points)]
        if not steps or not all(is_sane(*step[1:]) for step in steps):
            self.insane += bool(steps)
            return None
        self.add_extents(steps)
        return steps

    # ---- what the frontend calls ----

    def draw_point(self, pos, properties):
        if self.trace_points([pos]):
            self.keep("dot", pos.x, pos.y, properties.color)

    def draw_line(self, start, end, properties):
        if start.isclose(end):
            self.draw_point(start, properties)
        else:
            self.stroke(self.trace_points([start, end]), properties)

    def draw_path(self, path, properties):
        if len(path):
            self.stroke(self.trace(path), properties)

    def draw_solid_lines(self, lines, properties):
        steps = []
        for start, end in lines:
            steps += self.trace_points([start, end]) or []
        self.stroke(steps, properties)

    def stroke(self, steps, properties):
        self.lettered += bool(steps) and properties.linetype_name.upper() in self.lettered_types
        if steps:
            dashes = [d * properties.linetype_scale for d in properties.linetype_pattern]
            self.keep("stroke", steps, properties.color, properties.lineweight, self.width, dashes)

    def draw_ray(self, start, direction, both_ways, properties):
        if is_sane(*start.xyz, *direction.xyz):
            self.keep("ray", start.x, start.y, direction.x, direction.y, both_ways, properties.color, properties.lineweight)

    def fill(self, outlines, color, spacing=0.0, ends=None):
        steps = [step for outline in outlines for step in self.trace(outline, close=True) or []]
        if steps:
            self.keep("fill", steps, color, spacing, ends)

    def draw_filled_paths(self, paths, holes, properties):
        filling, ends = properties.filling, None
        if filling and filling.type == Filling.GRADIENT and filling.gradient_color1 and filling.gradient_color2:
            ends = (filling.gradient_color1, filling.gradient_color2, filling.angle, filling.name.upper())
        self.fill([*paths, *holes], properties.color, 0.0, ends)

    def draw_filled_polygon(self, points, properties):
        steps = self.trace_points(list(points))
        if steps:
            self.keep("fill", steps + [("Z",)], properties.color, 0.0)

    def draw_text(self, text, transform, properties, cap_height):
        text = "".join(c if c.isprintable() else " " for c in text)
        m = transform.get_components() if hasattr(transform, "get_components") else tuple(transform)
        axes = (m[0], m[1], m[4], m[5], m[12], m[13])
        if not text.strip() or not is_sane(*axes, cap_height) or cap_height <= 0:
            return
        width = line_width(text, cap_height)
        for x, y in ((0, 0), (width, 0), (0, cap_height), (width, cap_height)):
            self.extents.add(m[0] * x + m[4] * y + m[12], m[1] * x + m[5] * y + m[13])
        self.keep("text", text, axes, cap_height, properties.color)

    def get_font_measurements(self, cap_height, font=None):
        return measurements(cap_height)

    def get_text_line_width(self, text, cap_height, font=None):
        return line_width(text, cap_height)

    def configure(self, config): ...
    def enter_entity(self, entity, properties): ...
    def exit_entity(self, entity): ...
    def set_background(self, color): ...
    def clear(self): ...
    def finalize(self): ...

    def set_clipping_path(self, path=None, scale=1.0):
        return False


def dashes_of(linetype):
    """The dashes and gaps of a line type with letters or shapes, which the library takes for a solid one."""
    tags = linetype.pattern_tags.tags
    elements = [tag.value for tag in tags if tag.code == 49]
    length = next((tag.value for tag in tags if tag.code == 40), 0.0)
    return ltype.compile_line_pattern(length or None, elements) if len(elements) > 1 else ()


class Paper(RenderContext):
    """White paper, no plot style files, and a block on a frozen layer is not there."""

    def set_current_layout(self, layout, ctb=""):
        self.current_layout_properties = LayoutProperties(layout.name, "#ffffff", units=layout.units)
        self.plot_styles = self._load_plot_style_table("")
        lettered = {t.dxf.name.upper(): dashes_of(t) for t in layout.doc.linetypes if t.pattern_tags.is_complex_type()}
        self.line_pattern.update(lettered)
        self.lettered_types = set(lettered)
        self.layers = self._setup_layers(layout.doc)
        self.frozen = {layer.dxf.name.lower() for layer in layout.doc.layers if layer.is_frozen()}

    def resolve_visible(self, entity, *, resolved_layer=None):
        if isinstance(entity, Insert) and self.resolve_layer(entity).lower() in self.frozen:
            return False
        return super().resolve_visible(entity, resolved_layer=resolved_layer)


class Draughtsman(Frontend):
    """ezdxf's frontend; what it cannot draw is counted, and one faulty entity does not end the drawing."""

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)
        self.left_out = {}  # type: number
        self.hidden = 0
        self.open_blocks = []

    def leave_out(self, kind):
        self.left_out[kind] = self.left_out.get(kind, 0) + 1

    def skip_entity(self, entity, msg):
        if msg == "invisible":
            self.hidden += 1
        else:
            self.leave_out(entity.dxftype())

    def draw_entities(self, entities, *, filter_func=None):
        for entity in entities:
            try:
                super().draw_entities([entity])
            except (MemoryError, KeyboardInterrupt):
                raise
            except Exception:  # a fault of this entity, whatever it is
                self.leave_out("faulty " + entity.dxftype())

    def draw_composite_entity(self, entity, properties):
        block = entity.dxf.name.lower() if isinstance(entity, Insert) else None
        if block is not None and (block in self.open_blocks or not entity.block()):
            self.leave_out("INSERT of itself" if block in self.open_blocks else "INSERT of nothing")
            return
        if block is not None and entity.mcount > COPIES:
            self.leave_out(f"INSERT of {entity.mcount} copies")
            return
        self.open_blocks.append(block)
        saved = list(self.ctx._saved_states), self.ctx.current_block_reference_properties
        try:
            super().draw_composite_entity(entity, properties)
        finally:
            self.open_blocks.pop()
            self.ctx._saved_states, self.ctx.current_block_reference_properties = saved

    def draw_line_entity(self, entity, properties):
        if entity.dxftype() == "LINE":
            super().draw_line_entity(entity, properties)
        else:
            self.out.draw_ray(entity.dxf.start, entity.dxf.unit_vector, entity.dxftype() == "XLINE", properties)

    def draw_polyline_entity(self, entity, properties):
        if entity.dxftype() == "POLYLINE":  # the frame of a spline is for those who bend it (DXF Reference, VERTEX, code 70)
            entity.vertices[:] = [v for v in entity.vertices if not v.dxf.get("flags", 0) & FRAME] or entity.vertices
        self.out.width = same_width(entity)
        if self.out.width is None:
            super().draw_polyline_entity(entity, properties)
        else:
            self._designer.draw_path(make_path(entity), properties)
            self.out.width = None

    def draw_hatch_entity(self, entity, properties, *, loops=None):
        """Some files mark no outline as an outer one: then all count."""
        before, insane = len(self.out.items), self.out.insane
        super().draw_hatch_entity(entity, properties, loops=loops)
        if len(self.out.items) == before and self.out.insane == insane and entity.dxf.get("hatch_style", 0) != 0:
            entity.dxf.hatch_style = 0
            super().draw_hatch_entity(entity, properties, loops=loops)
        if len(self.out.items) == before and self.out.insane == insane:
            self.leave_out("HATCH without area")

    def draw_hatch_pattern(self, polygon, paths, properties):
        """Lines of the pattern; a tone where they would be too close, for paper or for patience."""
        if polygon.pattern is None or not polygon.pattern.lines:
            return
        before = len(self.out.items)
        baselines = list(hatching.pattern_baselines(polygon))
        spacing = min(abs(b.normal_distance) for b in baselines)
        size = hatch_size(paths)
        if size / spacing * len(baselines) <= HATCH_LINES:
            super().draw_hatch_pattern(polygon, paths, properties)
        lines = self.out.take(before)
        ocs = polygon.ocs()
        outlines = [path.transform(ocs.matrix) for path in paths] if ocs.transform else paths
        self.out.fill(outlines, properties.color, spacing)
        tone = self.out.take(before)
        if tone:
            self.out.keep("hatch", lines, tone, spacing)

    def draw_viewport_entity(self, entity, properties):
        self.leave_out("VIEWPORT")

    def draw_ole2frame_entity(self, entity, properties):
        self.leave_out("OLE2FRAME")


def hatch_size(paths):
    """Diagonal of the bounds, in drawing units."""
    all_points = [v for path in paths for v in path.control_vertices()]
    if not all_points:
        return 0.0
    xs, ys = [v.x for v in all_points], [v.y for v in all_points]
    return math.hypot(max(xs) - min(xs), max(ys) - min(ys))


def same_width(entity):
    """The width of a polyline that has one and the same everywhere; None: no width, several, or an impossible one."""
    if entity.dxftype() == "LWPOLYLINE":
        constant = entity.dxf.get("const_width", 0)
        widths = {constant} if constant else {w for p in entity.lwpoints for w in p[2:4]}
    elif entity.is_2d_polyline:
        start, end = entity.dxf.get("default_start_width", 0), entity.dxf.get("default_end_width", 0)
        widths = {w for v in entity.vertices for w in (v.dxf.get("start_width", start), v.dxf.get("end_width", end))}
    else:
        return None
    return widths.pop() if len(widths) == 1 and widths != {0} and is_sane(*widths) else None


class Writer:
    """The recorded items as SVG; `f` is mm on paper per drawing unit."""

    def __init__(self, extents, f):
        self.f, self.x0, self.y1 = f, extents.x0, extents.y1
        self.extents = extents
        self.gradients = 0
        self.width = (extents.x1 - extents.x0) * f + 2 * MARGIN
        self.height = (extents.y1 - extents.y0) * f + 2 * MARGIN
        self.out = []

    def xy(self, x, y):
        return f"{(x - self.x0) * self.f + MARGIN:.4f} {(self.y1 - y) * self.f + MARGIN:.4f}"

    def d(self, steps):
        return "".join(s[0] + " ".join(self.xy(*s[i : i + 2]) for i in range(1, len(s), 2)) for s in steps)

    def dash(self, pattern):
        pattern = [d * self.f for d in pattern[: len(pattern) // 2 * 2]]
        if not pattern or not is_sane(*pattern) or sum(pattern) < PATTERN_MIN or min(pattern) < 0:
            return ""
        return ' stroke-dasharray="' + " ".join(f"{max(d, 0.05):.4f}" for d in pattern) + '"'

    def stroke(self, steps, color, weight, width, dashes):
        ink, alpha = bright_to_dark(color)
        w = max(weight if width is None else width * self.f, WEIGHT_MIN)
        opacity = f' stroke-opacity="{alpha:.3f}"' if alpha < 1 else ""
        self.out.append(f'<path d="{self.d(steps)}" stroke="{ink}" stroke-width="{w:.4f}"{opacity}{self.dash(dashes)}/>')

    def gradient(self, steps, ends):
        """Between two colours, along a direction or from the middle (DXF Reference, HATCH, codes 450 to 470); a reference to it."""
        first, second, angle, name = ends
        places = [(float(a), float(b)) for s in steps for i in range(1, len(s), 2) for a, b in [self.xy(*s[i : i + 2]).split()]]
        (x0, x1), (y0, y1) = ((min(v), max(v)) for v in zip(*places))
        x, y, turn = (x0 + x1) / 2, (y0 + y1) / 2, -math.radians(angle)
        reach = (abs(math.cos(turn)) * (x1 - x0) + abs(math.sin(turn)) * (y1 - y0)) / 2
        self.gradients += 1
        if name.endswith(("SPHERICAL", "HEMISPHERICAL", "CURVED")):
            head, tail = f'<radialGradient cx="{x:.4f}" cy="{y:.4f}" r="{math.hypot(x1 - x0, y1 - y0) / 2:.4f}"', "radialGradient"
        else:
            dx, dy = reach * math.cos(turn), reach * math.sin(turn)
            head, tail = f'<linearGradient x1="{x - dx:.4f}" y1="{y - dy:.4f}" x2="{x + dx:.4f}" y2="{y + dy:.4f}"', "linearGradient"
        stops = [(0, first), (1, second)] if not name.endswith("CYLINDER") else [(0, second), (0.5, first), (1, second)]
        self.out.append(f'{head} id="g{self.gradients}" gradientUnits="userSpaceOnUse">'
                        + "".join(f'<stop offset="{at}" stop-color="{c[:7]}"/>' for at, c in stops) + f"</{tail}>")
        return f"url(#g{self.gradients})"

    def fill(self, steps, color, spacing, ends=None):
        ink, alpha = (color[:7], int(color[7:9], 16) / 255 if len(color) == 9 else 1.0)
        if ends:
            ink = self.gradient(steps, ends)
        if spacing:
            alpha *= min(1.0, DOT / max(spacing * self.f, DOT))
        opacity = f' fill-opacity="{alpha:.3f}"' if alpha < 1 else ""
        self.out.append(f'<path d="{self.d(steps)}" fill="{ink}" fill-rule="evenodd" stroke="none"{opacity}/>')

    def hatch(self, lines, tone, spacing):
        is_close = spacing * self.f < HATCH_MIN or not lines
        for how, what in tone if is_close else lines:
            getattr(self, how)(*what)

    def dot(self, x, y, color):
        cx, cy = self.xy(x, y).split()
        self.out.append(f'<circle cx="{cx}" cy="{cy}" r="{DOT}" fill="{bright_to_dark(color)[0]}" stroke="none"/>')

    def ray(self, x, y, dx, dy, both_ways, color, weight):
        """Cut to the drawing's surroundings; the page's edge does the rest."""
        e = self.extents
        cx, cy, size = (e.x0 + e.x1) / 2, (e.y0 + e.y1) / 2, math.hypot(e.x1 - e.x0, e.y1 - e.y0)
        near = (cx - x) * dx + (cy - y) * dy
        start, end = near - size, near + size
        if not both_ways:
            start, end = max(start, 0), max(end, 0)
        if end > start:
            self.stroke([("M", x + start * dx, y + start * dy), ("L", x + end * dx, y + end * dy)], color, weight, None, [])

    def text(self, text, axes, cap_height, color):
        ink, alpha = bright_to_dark(color)
        k = cap_height / CAPITAL / 10 * self.f  # fonts are set at 10 mm: librsvg fails on very small and large ones
        n = NARROWED * k
        matrix = f"{axes[0] * n:.6g} {-axes[1] * n:.6g} {-axes[2] * k:.6g} {axes[3] * k:.6g} {self.xy(*axes[4:])}"
        text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        opacity = f' fill-opacity="{alpha:.3f}"' if alpha < 1 else ""
        self.out.append(f'<text transform="matrix({matrix})" fill="{ink}" stroke="none"{opacity}>{text}</text>')

    def document(self, items):
        for how, what in items:
            getattr(self, how)(*what)
        w, h = f"{self.width:.4f}", f"{self.height:.4f}"
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}mm" height="{h}mm" viewBox="0 0 {w} {h}" xml:space="preserve" '
                'fill="none" stroke-linecap="round" stroke-linejoin="round" font-family="DejaVu Sans, sans-serif" font-size="10">\n'
                + "\n".join(self.out) + "\n</svg>\n")


def load_whatever(tags, doc=None, load=factory.load):
    """An entity that the library fails on becomes one that it does not know, so that the rest can be drawn."""
    try:
        entity = load(tags, doc)
    except MemoryError:
        raise
    except Exception:
        entity = DXFTagStorage.load(tags, doc)
    handle = entity.dxf.get("handle")
    if handle is not None and (handle == "0" or not is_valid_handle(handle)):
        entity.dxf.handle = None  # it gets another
    return entity


# Header variables that the library asks for unseen, and the codes of their values, which are text.
VARIABLES = {"$ACADVER": 1, "$DWGCODEPAGE": 3, "$HANDSEED": 5}


def sane_variables(tags):
    """Of header variables those that have a name and a value, of one group or, for a point, up to three."""
    groups, kept = [], []
    for tag in tags:
        if tag[0] == 9:
            groups.append([tag])
        elif groups:
            groups[-1].append(tag)
    for name, *values in groups:
        code = values[0][0] if values else 0
        if code == 0 or not str(name[1]).startswith("$") or VARIABLES.get(name[1], code) != code:
            continue
        n = 1
        while n < min(3, len(values)) and 10 <= code <= 18 and values[n][0] == code + 10 * n:
            n += 1
        kept += [name, *values[:n]]
    return kept


def end_sequences(tags):
    """The tags of a section with the SEQEND that follows a polyline's vertices, or a block's attributes, where some program left it out."""
    out, is_open = [], False
    for tag in tags:
        if tag[0] == 0:
            if is_open and tag[1] not in ("VERTEX", "ATTRIB", "SEQEND"):
                out.append(DXFTag(0, "SEQEND"))
            is_open = tag[1] in ("VERTEX", "ATTRIB")
        out.append(tag)
    return out + ([DXFTag(0, "SEQEND")] if is_open else [])


def rebuild_sections(self, tags, rebuild=recover.Recover.rebuild_sections):
    """Without what the library fails on: sections of nothing, not even a name, and header variables that are none."""
    sections = [[*section] for section in rebuild(self, tags)]
    if sections[-1][:1] != [(0, "SECTION")]:  # what stands outside of all; variables are looked for there, too
        sections[-1] = sane_variables(sections[-1])
    sections = [section[:2] + sane_variables(section[2:]) if section[1:2] == [(2, "HEADER")] else section for section in sections]
    sections = [end_sequences(section) for section in sections[:-1]] + sections[-1:]
    return [section for section in sections[:-1] if len(section) > 1] + [sections[-1] if len(sections[-1]) > 1 else []]


def is_whole(data):
    return re.search(rb"\s0\s+EOF\s*$", data[-4096:].rstrip(b"\x1a\0 \t\r\n") + b"\n") is not None


def close(data):
    """The whole groups of a file that ends in the middle, and the end that it lacks."""
    lines = data.split(b"\n")
    return b"\n".join(lines[: len(lines) // 2 * 2]) + b"\n0\nENDSEC\n0\nEOF\n"


def read_document(data):
    if data.startswith(b"AutoCAD Binary DXF"):
        quit_with(EXIT_REFUSED, "binary DXF is not read; save the drawing as ASCII DXF")
    if b"\n" not in data:
        data = data.replace(b"\r", b"\n")
    if not is_whole(data):
        data = close(data)
    try:
        return recover.read(io.BytesIO(data))
    except const.DXFError as e:
        line = re.search(r"\(?(?:near|at|in) line:? *(\d+)\)?", str(e))
        text = str(e).replace(line.group(0), "").strip(" .") if line else str(e).strip(" .")
        quit_with(EXIT_MALFORMED, (f"{line.group(1)}:" if line else "") + " not well-formed DXF: " + text)
    except UnicodeDecodeError:  # of the library's message about some faulty tag
        quit_with(EXIT_MALFORMED, "not well-formed DXF: a value that is neither a number nor text")


def choose_layout(document):
    """The model; or the first sheet that holds something, when the model holds nothing."""
    model = document.modelspace()
    if len(model):
        return model
    for name in document.layout_names_in_taborder():
        layout = document.layout(name)
        if any(entity.dxftype() != "VIEWPORT" for entity in layout):
            return layout
    return model


def unit_in_mm(document, layout):
    if layout.is_any_paperspace:
        return 1.0, "mm"  # sheets are drawn at their size on paper
    return UNITS.get(document.header.get("$INSUNITS", 0), (1.0, "no unit, taken for mm"))


def choose_scale(width, height):
    """The largest preferred scale, 1:1 at most, at which a drawing of so many mm fits the paper; small ones are enlarged."""
    def fits(scale):
        w, h = sorted((width * scale + 2 * MARGIN, height * scale + 2 * MARGIN), reverse=True)
        return w <= PAPER[0] and h <= PAPER[1]

    best = next((s for s in SCALES if s <= 1 and fits(s)), SCALES[-1])
    if best < 1 or max(width, height) >= SMALL:
        return best
    larger = [s for s in SCALES if s > 1 and fits(s)]
    return next((s for s in reversed(larger) if max(width, height) * s >= SMALL), larger[0] if larger else 1.0)


def show_scale(scale):
    return f"{scale:g}:1" if scale >= 1 else f"1:{1 / scale:.12g}"


def say(kind, text):
    sys.stderr.write(f"{kind}: {' '.join(text.split())[:200]}\n")


# Faults for which the library deletes what it was to draw.
LOSSES = {AuditError.REMOVED_INVALID_GRAPHIC_ENTITY, AuditError.UNDEFINED_BLOCK, AuditError.INVALID_MAJOR_AXIS,
          *range(AuditError.INVALID_SPLINE_DEFINITION, AuditError.INVALID_SPLINE_WEIGHT_COUNT + 1)}


def report(data, recorder, hand, auditor):
    if hand.left_out:
        parts = sorted(hand.left_out.items(), key=lambda part: (-part[1], part[0]))
        more = [f"and {len(parts) - 8} other kinds"] if len(parts) > 8 else []
        say("warning", "left out: " + ", ".join([f"{n} {kind}" for kind, n in parts[:8]] + more))
    lined = sum(data.count(code) for code in (b"%%u", b"%%U", b"%%o", b"%%O"))
    if lined:
        say("warning", f"{lined} underlines and overlines of text are left out")
    if recorder.lettered:
        say("warning", f"left out: the letters and shapes in the line types of {recorder.lettered} line{'s' * (recorder.lettered > 1)}")
    if recorder.insane:
        say("warning", f"left out: {recorder.insane} with impossible coordinates")
    if not is_whole(data):
        say("warning", "the file ends in the middle; drawn is what it holds")
    if hand.hidden:
        say("detail", f"{hand.hidden} entities are on layers that are off or frozen, or invisible themselves")
    faults = [fault.code for fault in auditor.errors + auditor.fixes]
    lost = sum(code in LOSSES for code in faults)
    if lost:
        say("warning", f"left out: {lost} without a shape, or that refer to nothing")
    if faults:
        say("detail", f"{len(faults)} fault{'' if len(faults) == 1 else 's'} of the file mended")


def draw(data):
    document, auditor = read_document(data)
    layout = choose_layout(document)
    recorder = Recorder()
    config = Configuration.defaults().with_changes(
        pdmode=None, pdsize=None, line_policy=LinePolicy.SOLID, hatching_timeout=math.inf)
    paper = Paper(document, export_mode=True)
    paper.set_current_layout(layout)
    recorder.lettered_types = paper.lettered_types
    hand = Draughtsman(paper, recorder, config)
    hand.draw_layout(layout)
    strayed = recorder.settle()
    if strayed:
        say("warning", f"left out: {strayed} far from all others")
    if recorder.extents.is_empty:
        for how, what in recorder.items:
            if how == "ray":
                recorder.extents.add(what[0], what[1])
    e = recorder.extents
    if e.is_empty:
        e.add(0, 0)
    mm, unit = unit_in_mm(document, layout)
    scale = choose_scale((e.x1 - e.x0) * mm, (e.y1 - e.y0) * mm)
    text = Writer(e, mm * scale).document(recorder.items)
    say("detail", f"DXF {document.dxfversion}, {unit}; {show_scale(scale)} fits A3")
    report(data, recorder, hand, auditor)
    return f"%%Plumbago-tap-dxf 1 {scale:.12g}\n{text}"


def main():
    if len(sys.argv) > 1:
        quit_with(EXIT_USAGE, "tap-dxf takes no arguments")
    logging.disable(logging.CRITICAL)
    ezdxf.options.use_matplotlib = False
    fonts.make_font = Letters
    factory.load = load_whatever
    recover.Recover.rebuild_sections = rebuild_sections
    out, sys.stdout = sys.stdout.buffer, io.StringIO()  # the library prints
    try:
        text = draw(sys.stdin.buffer.read()).encode("utf-8", "replace")
    except MemoryError:
        quit_with(EXIT_LIMIT, "the drawing needs too much memory")
    except Exception as e:  # the library's surprises
        quit_with(EXIT_REFUSED, f"ezdxf cannot read this file: {type(e).__name__}: {e}")
    try:
        out.write(text)
        out.flush()
    except OSError as e:
        quit_with(EXIT_WRITE, str(e))
    sys.stderr.flush()
    os._exit(EXIT_DONE)


main()
