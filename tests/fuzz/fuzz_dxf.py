#!/usr/bin/env -S PYTHONHASHSEED=0 /usr/bin/python3 -sBP
# SPDX-License-Identifier: MIT
"""A fuzzer of tap-dxf, which knows what DXF is made of: groups of a code and a value, entities of groups.

    fuzz_dxf.py TAP replay FILE...                       a line "ok FILE" or "FAIL FILE: why" for each
    fuzz_dxf.py TAP fuzz SECONDS SEED FOLDER FILE...     changes the files for so many seconds of processor time

The tap is loaded once; each input runs in a forked process with the limits that it has under plumbago. Whatever the input, it
must end in time with a status that its head lists, say nothing but its lines, and write well-formed SVG of finite
numbers. What does not is kept in FOLDER, with a line on standard output.
"""
import os
import random
import re
import resource
import select
import signal
import sys
import time
import xml.parsers.expat

SECONDS, MEMORY, OUTPUT_MOST = 8, 1 << 30, 256 << 20  # as process.h, input.h
STATUS_DONE, STATUS_REFUSED, STATUSES = 0, 3, (0, 2, 3, 5)  # tap_dxf.py: done, malformed, refused, limit
HEAD = re.compile(rb"%%Plumbago-tap-dxf 1 ([0-9.e+-]+)\n")


# ---- one run ---------------------------------------------------------------------------------------------------


def load_tap(file):
    """The script's names, and its code without the last line, which runs it."""
    with open(file, encoding="utf-8") as script:
        text = script.read()
    assert text.endswith("\nmain()\n")
    names = {"__name__": "tap_dxf", "__file__": file}
    exec(compile(text[: -len("main()\n")], file, "exec"), names)
    return names


def be_child(tap, data, out, err):
    for what, limit in ((resource.RLIMIT_CPU, SECONDS), (resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_CORE, 0), (resource.RLIMIT_FSIZE, 0)):
        resource.setrlimit(what, (limit, limit + (what == resource.RLIMIT_CPU)))
    inner, outer = os.pipe()
    if os.fork() == 0:  # who feeds it
        os.close(inner)
        try:
            while data:
                data = data[os.write(outer, data) :]
        except OSError:
            pass
        os._exit(0)
    os.close(outer)
    for fd, to in ((inner, 0), (out, 1), (err, 2)):
        os.dup2(fd, to)
    os.closerange(3, 64)
    sys.argv = ["tap-dxf"]
    streams = os.fdopen(0), os.fdopen(1, "w", encoding="utf-8"), os.fdopen(2, "w", 1, encoding="utf-8", errors="backslashreplace")
    sys.stdin, sys.stdout, sys.stderr = streams
    try:
        tap["main"]()
    except BaseException as e:
        sys.stderr.write(f"Traceback: {type(e).__name__}: {e}\n")
        sys.stderr.flush()
        os._exit(1)
    os._exit(0)


def read_ends(ends, until):
    """What comes from both, or None when the time is up."""
    parts = {fd: [] for fd in ends}
    waiting = set(ends)
    while waiting:
        ready, _, _ = select.select(list(waiting), [], [], max(0, until - time.monotonic()))
        if not ready:
            return None
        for fd in ready:
            part = os.read(fd, 1 << 16)
            parts[fd].append(part)
            if not part or sum(map(len, parts[fd])) > OUTPUT_MOST:
                waiting.discard(fd)
    return [b"".join(parts[fd]) for fd in ends]


def run(tap, data):
    """(status or -signal or None when the time is up, output, messages, seconds)."""
    out, err = os.pipe(), os.pipe()
    child = os.fork()
    if child == 0:
        be_child(tap, data, out[1], err[1])
    os.close(out[1])
    os.close(err[1])
    texts = read_ends((out[0], err[0]), time.monotonic() + 10 * SECONDS)
    if texts is None:
        os.kill(child, signal.SIGKILL)
    _, state, use = os.wait4(child, 0)
    os.close(out[0])
    os.close(err[0])
    output, messages = texts or (b"", b"")
    return (None if texts is None else os.waitstatus_to_exitcode(state)), output, messages, use.ru_utime + use.ru_stime


# ---- what must hold --------------------------------------------------------------------------------------------


def fault_of_output(output):
    head = HEAD.match(output)
    if not head or not 0 < float(head.group(1)) < 1e15:
        return "no head, or no scale"
    text = output[head.end() :]
    try:
        xml.parsers.expat.ParserCreate().Parse(text, True)
    except xml.parsers.expat.ExpatError as e:
        return f"the output is not well-formed XML: {e}"
    if re.search(rb'[ "MLCQ(](-?(nan|inf))\b', re.sub(rb">[^<]*<", b"><", text)):
        return "a number that is none"
    size = re.match(rb'<svg [^>]*width="([0-9.]+)mm" height="([0-9.]+)mm"', text)
    if not size or not all(0 < float(n) < 1e6 for n in size.groups()):
        return "no size, or an absurd one"
    return None


def fault_of(status, output, messages):
    lines = messages.split(b"\n")[:-1]
    if status in (None, -signal.SIGKILL, -signal.SIGXCPU):
        return None  # its limit, which plumbago reports
    if status not in STATUSES:
        return f"status {status}: {messages[:300]!r}"
    if messages and not messages.endswith(b"\n"):
        return "half a line"
    if any(b"Traceback" in line or len(line) > 1000 for line in lines):
        return f"not for a user: {messages[:300]!r}"
    if status != STATUS_DONE:
        return None if len(lines) == 1 and not output else f"{len(lines)} lines, {len(output)} bytes of output"
    strange = [line for line in lines if not line.startswith((b"warning: ", b"detail: "))]
    return f"it says {strange[0][:300]!r}" if strange else fault_of_output(output)


# ---- changing a drawing ----------------------------------------------------------------------------------------

NUMBERS = (b"0", b"-0", b"1", b"-1", b"2", b"3", b"7", b"64", b"255", b"256", b"65536", b"2147483647", b"-2147483648", b"4294967296", b"1e300",
           b"-1e300", b"1e-300", b"1e308", b"nan", b"inf", b"-inf", b"1e12", b"9e11", b"0.1", b"1e999", b"1_000", b" 5 ", b"0x10", b"", b"x")
TEXTS = (b"", b"*U1", b"*MODEL_SPACE", b"*Paper_Space", b"BYLAYER", b"BYBLOCK", b"CONTINUOUS", b"0", b"a" * 3000, b"{\\fArial|b1;x}", b"\\S1/2;",
         b"\\A1;\\H99999999x;t", b"{" * 500, b"%%d%%u%%o\\U+00E4", b"<&>\"'", b"\xff\xfe\x80", b"\\P" * 400, b"^J^I", b"ANSI31", b"SOLID", b"1F", b"\x00")
CODES = (0, 1, 2, 3, 5, 6, 8, 10, 20, 30, 11, 21, 12, 22, 13, 23, 40, 41, 42, 48, 50, 51, 52, 60, 62, 67, 70, 71, 72, 73, 75, 76, 78, 90, 91, 92, 93, 94,
         95, 97, 98, 100, 102, 210, 220, 230, 330, 340, 360, 370, 420, 440, 450, 1000, 1001, 1070)
KINDS = (b"LINE", b"CIRCLE", b"ARC", b"ELLIPSE", b"SPLINE", b"LWPOLYLINE", b"POLYLINE", b"VERTEX", b"SEQEND", b"TEXT", b"MTEXT", b"INSERT", b"ATTRIB",
         b"ATTDEF", b"HATCH", b"MPOLYGON", b"SOLID", b"TRACE", b"3DFACE", b"DIMENSION", b"LEADER", b"MULTILEADER", b"MLINE", b"POINT", b"RAY", b"XLINE", b"WIPEOUT",
         b"IMAGE", b"VIEWPORT", b"MESH", b"REGION", b"3DSOLID", b"TOLERANCE", b"SHAPE", b"HELIX", b"OLE2FRAME", b"ACAD_TABLE", b"BLOCK", b"ENDBLK", b"LAYER", b"STYLE",
         b"LTYPE", b"DIMSTYLE", b"ENDSEC", b"SECTION", b"ENDTAB", b"TABLE", b"EOF", b"ARC_DIMENSION", b"BODY", b"UNDERLAY", b"PDFUNDERLAY", b"SURFACE", b"LIGHT", b"ACAD_PROXY_ENTITY")


def groups_of(data):
    lines = data.replace(b"\r\n", b"\n").split(b"\n")
    return [[code, value] for code, value in zip(lines[::2], lines[1::2])]


def bytes_of(groups):
    return b"".join(code + b"\n" + value + b"\n" for code, value in groups)


def entities_of(groups):
    """[start, end) of what begins with a code 0."""
    starts = [i for i, (code, _) in enumerate(groups) if code.strip() == b"0"]
    return list(zip(starts, starts[1:] + [len(groups)]))


class Changer:
    def __init__(self, seed, files):
        self.random = random.Random(seed)
        self.seeds, self.pool = [], []
        for file in files:
            with open(file, "rb") as f:
                groups = groups_of(f.read())
            if len(groups) <= 4000:
                self.seeds.append(groups)
            self.pool += [groups[a:b] for a, b in entities_of(groups) if b - a <= 300]

    def value(self, groups):
        r = self.random
        how = r.randrange(4)
        if how == 0:
            return r.choice(groups)[1]
        if how == 1:
            return b"%g" % (r.uniform(-1, 1) * 10 ** r.randrange(-3, 6))
        return r.choice(NUMBERS if how == 2 else TEXTS)

    def change(self, groups):
        r = self.random
        i = r.randrange(len(groups))
        a, b = r.choice(entities_of(groups) or [(0, len(groups))])
        how = r.randrange(14)
        if how <= 3:  # of one entity, which is where the numbers are
            groups[r.randrange(a, b)][1] = self.value(groups)
        elif how == 4:
            groups[i][0] = b"%d" % r.choice(CODES)
        elif how == 5:
            del groups[i]
        elif how == 6:
            groups.insert(i, [b"%d" % r.choice(CODES), self.value(groups)])
        elif how == 7:
            groups[a][1] = r.choice(KINDS)
        elif how == 8:
            del groups[a:b]
        elif how == 9:
            groups[b:b] = [g[:] for g in groups[a:b]] * r.choice((1, 1, 2, 30))
        elif how <= 11:
            groups[a:a] = [g[:] for g in r.choice(self.pool)]
        elif how == 12:
            c, d = r.choice(entities_of(groups) or [(0, len(groups))])
            groups[a:b], moved = [], groups[a:b]
            groups[min(c, len(groups)) : min(c, len(groups))] = moved
        else:
            del groups[r.randrange(len(groups)) :]

    def make(self):
        r = self.random
        groups = [g[:] for g in r.choice(self.seeds)]
        for _ in range(r.choice((1, 1, 2, 3, 5, 8, 20))):
            if groups:
                self.change(groups)
        data = bytearray(bytes_of(groups))
        if data and r.randrange(10) == 0:
            for _ in range(r.randrange(1, 5)):
                data[r.randrange(len(data))] = r.randrange(256)
        if r.randrange(30) == 0:
            data = data.replace(b"\n", r.choice((b"\r\n", b"\r")))
        return bytes(data)


# ---- the commands ----------------------------------------------------------------------------------------------


def replay(tap, files):
    for file in files:
        with open(file, "rb") as f:
            status, output, messages, _ = run(tap, f.read())
        fault = fault_of(status, output, messages)
        if not fault and status == STATUS_REFUSED:  # once mended, it is mended
            fault = f"refused: {messages[:300]!r}"
        print(f"FAIL {os.path.basename(file)}: {fault}" if fault else f"ok dxf: {os.path.basename(file)}", flush=True)


def fuzz(tap, seconds, seed, folder, files):
    changer, spent, tried, counts, said = Changer(seed, files), 0.0, 0, {}, set()
    os.makedirs(folder, exist_ok=True)
    while spent < seconds:
        data = changer.make()
        status, output, messages, used = run(tap, data)
        spent, tried = spent + used, tried + 1
        fault = fault_of(status, output, messages)
        kind = "fault" if fault else f"status {status}"
        if not fault and status == STATUS_REFUSED:  # a surprise: one fault should not cost the whole drawing
            kind = re.sub(r"'[^']*'|[0-9]+", "_", messages.decode("utf-8", "replace").strip())[:120]
        if (fault or status is None or status < 0 or status == STATUS_REFUSED or used > SECONDS / 2) and (fault or kind) not in said:
            said.add(fault or kind)
            name = f"{folder}/{seed}-{tried}.dxf"
            with open(name, "wb") as f:
                f.write(data)
            print(f"{name}: {fault or kind}, {used:.1f} s", flush=True)
        counts[kind] = counts.get(kind, 0) + 1
    print(f"{tried} inputs, {spent:.0f} s; " + ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items(), key=lambda c: -c[1])))


def main():
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    tap = load_tap(sys.argv[1])
    if sys.argv[2] == "replay":
        replay(tap, sys.argv[3:])
    else:
        fuzz(tap, float(sys.argv[3]), int(sys.argv[4]), sys.argv[5], sys.argv[6:])


main()
