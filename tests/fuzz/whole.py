#!/usr/bin/env -S PYTHONHASHSEED=0 /usr/bin/python3 -sBP
# SPDX-License-Identifier: MIT
"""Mutation of the whole program: plumbago with its taps, on changed drawings of every format.

    whole.py PROGRAM SECONDS SEED FOLDER FILE...

Changes the files by bytes, numbers, words and lines, and draws each for so many seconds of the clock. Whatever the input, the
program ends with status 0 or 1. With 0 there is a whole picture; with 1 exactly one line on standard error, which names the
program, and the picture that was there before is untouched. A sanitizer's report or a signal is a finding in any case.
What breaks a promise is kept in FOLDER, with a line on standard output; the last line counts.
"""
import os
import random
import re
import subprocess
import sys
import time

NUMBER = re.compile(rb"-?\d+(?:\.\d+)?")
WORD = re.compile(rb"[A-Za-z][A-Za-z-]{2,}")
# Values at which readers go wrong: signs, zeros, sizes of machine words, what is no number.
NUMBERS = [b"0", b"-1", b"1e-300", b"1e308", b"-1e308", b"2147483648", b"4294967295", b"9223372036854775807", b"0.0000001", b"nan", b"1e", b"65536", b""]
STARTED_FROM = b"the picture that was there before"
LIMITS = ["-q", "-d", "20", "--limit-time", "5", "--limit-memory", "256", "--limit-length", "200"]
REPORT = re.compile(rb"Sanitizer|runtime error|Assertion|assertion failed")


def change_once(data, other, dice):
    """One small change of `data`; `other` is a drawing of the same format to take pieces from."""
    deed = dice.randrange(7)
    if deed == 0 and data:
        at = dice.randrange(len(data))
        return data[:at] + bytes([dice.randrange(256)]) + data[at + 1 :]
    if deed == 1:
        found = list(NUMBER.finditer(data))
        if found:
            number = dice.choice(found)
            return data[: number.start()] + dice.choice(NUMBERS) + data[number.end() :]
    if deed == 2:
        found = list(WORD.finditer(data))
        words = WORD.findall(other)
        if found and words:
            word = dice.choice(found)
            return data[: word.start()] + dice.choice(words) + data[word.end() :]
    start = dice.randrange(len(data) + 1)
    end = min(len(data), start + int(2 ** dice.uniform(0, 9)))
    if deed == 3:
        return data[:start] + data[end:]
    if deed == 4:
        return data[:end] + data[start:]
    if deed == 5:
        place = dice.randrange(len(other) + 1)
        return data[:start] + other[place : place + int(2 ** dice.uniform(0, 9))] + data[end:]
    return data[:start] if dice.random() < 0.2 else data


def fault(program, drawing, picture):
    """What the program promised and did not hold on this drawing, or None."""
    with open(picture, "wb") as before:
        before.write(STARTED_FROM)
    try:
        run = subprocess.run([program, *LIMITS, "-o", picture, drawing], stdin=subprocess.DEVNULL, capture_output=True, timeout=120)
    except subprocess.TimeoutExpired:
        return "no end after 120 s"
    with open(picture, "rb") as after:
        touched = after.read() != STARTED_FROM
    if run.returncode not in (0, 1):
        return f"status {run.returncode}: {run.stderr[-200:]!r}"
    if REPORT.search(run.stderr):
        return f"report: {REPORT.search(run.stderr).group()!r}"
    if run.returncode == 1:
        if touched:
            return "the picture was touched, status 1"
        if run.stderr.count(b"\n") != 1 or not run.stderr.startswith(b"plumbago: "):
            return f"not one line: {run.stderr[:200]!r}"
    elif not touched:
        return "no picture, status 0"
    return None


def main():
    program, seconds, seed, folder, *files = sys.argv[1:]
    dice = random.Random(int(seed))
    kinds = {}
    for file in files:
        with open(file, "rb") as drawing:
            kinds.setdefault(os.path.splitext(file)[1], []).append(drawing.read())
    os.makedirs(folder, exist_ok=True)
    end = time.monotonic() + float(seconds)
    runs = drawn = found = 0
    picture = os.path.join(folder, "picture.png")
    while time.monotonic() < end:
        kind = dice.choice(sorted(kinds))
        data = dice.choice(kinds[kind])
        for _ in range(dice.choice((1, 1, 2, 4, 8))):
            data = change_once(data, dice.choice(kinds[kind]), dice)
        drawing = os.path.join(folder, "drawing" + kind)
        with open(drawing, "wb") as out:
            out.write(data)
        broken = fault(program, drawing, picture)
        runs += 1
        with open(picture, "rb") as after:
            drawn += after.read(4) == b"\x89PNG"
        if broken:
            found += 1
            kept = os.path.join(folder, f"found-{runs}{kind}")
            os.rename(drawing, kept)
            print(f"FAIL {kept}: {broken}", flush=True)
    print(f"{runs} drawings, {drawn} drawn, {found} findings")
    sys.exit(found > 0)


main()
