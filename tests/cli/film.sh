# SPDX-License-Identifier: MIT
# A film in which the drawing draws itself: another reader finds the picture in its last frame, graphite only grows, threads change nothing, and a film that
# fails leaves no file.
. "$ROOT/tests/check.sh"
cat >a.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm" viewBox="0 0 60 40" fill="none" stroke="black" stroke-width=".4">
<path d="M5 35L55 30"/><circle cx="30" cy="18" r="12"/><path d="M5 5C20 0 40 12 55 4"/><path d="M10 10V30"/></svg>
SVG
draws "a picture" -d 100 a.svg -o still.png
draws "a film" --film -d 100 --duration 1.5 --fps 20 a.svg
draws "on three threads" --film -d 100 --duration 1.5 --fps 20 --threads 3 a.svg -o three.png
same "threads change nothing" a.film.png three.png
plumbago --film -d 100 --duration 1.5 --fps 20 a.svg -o - && cp "$TMP/out" piped.png
same "a pipe gets the same bytes" a.film.png piped.png
mkdir out
draws "numbered pictures" --film -d 100 --duration 1.5 --fps 20 --pause 0 a.svg -o 'out/%03d.png'
is "they are 31" "$(find out -type f | wc -l)" 31
if /usr/bin/python3 -c 'import PIL, numpy' 2>/dev/null; then
    report "read by another program" "$(/usr/bin/python3 - 2>&1 <<'PY'
from PIL import Image
import numpy
film, still = Image.open("a.film.png"), numpy.array(Image.open("still.png").convert("L")).astype(int)
frames = []
for k in range(film.n_frames):
    film.seek(k)
    frames.append(numpy.array(film.convert("L")).astype(int))
if (frames[0] != 255).any(): print("the first frame is not blank")
if (frames[-1] != still).any(): print("the last frame is not the picture")
if any((b > a).any() for a, b in zip(frames, frames[1:])): print("graphite vanishes")
if not 20 <= len(frames) <= 31: print("frames:", len(frames))
if film.info["duration"] != 2050: print("the pause is", film.info["duration"])
PY
)"
else
    skip "read by another program" "no python3-pil here"
fi
draws "three tracings" --film --boil 3 --hold 2 -d 200 a.svg -o boil.png
draws "the drawing" -d 200 a.svg -o still200.png
if /usr/bin/python3 -c 'import PIL, numpy' 2>/dev/null; then
    report "three pictures, the first is the drawing, none strays far" "$(/usr/bin/python3 - 2>&1 <<'PY'
from PIL import Image, ImageFilter
import numpy
film, still = Image.open("boil.png"), numpy.array(Image.open("still200.png").convert("L"))
frames = []
for k in range(film.n_frames):
    film.seek(k)
    frames.append(film.convert("L").copy())
    if film.info["duration"] != 80: print("held for", film.info["duration"])
if len({f.tobytes() for f in frames}) != 3 or len(frames) != 3: print("pictures:", len(frames))
if (numpy.array(frames[0]) != still).any(): print("the first is not the drawing")
if film.info["loop"] != 0: print("it ends")
# 0.85 mm are 6.7 pixels: what is dark in one lies within so much of something in each other.
for a in frames:
    for b in frames:
        near = numpy.array(b.filter(ImageFilter.MinFilter(13)))
        if (near[numpy.array(a) < 200] > 250).any(): print("a line strays")
PY
)"
fi
draws "a GIF" --film -d 100 --duration 1.5 --fps 20 a.svg -o a.gif
if /usr/bin/python3 -c 'import PIL, numpy' 2>/dev/null; then
    report "its frames are those of the APNG" "$(/usr/bin/python3 - 2>&1 <<'PY'
from PIL import Image
a, b = Image.open("a.film.png"), Image.open("a.gif")
if a.n_frames != b.n_frames: print(a.n_frames, b.n_frames)
for k in range(min(a.n_frames, b.n_frames)):
    a.seek(k), b.seek(k)
    if a.convert("L").tobytes() != b.convert("L").tobytes(): print("frame", k)
    if a.info["duration"] != b.info["duration"]: print("duration", k, b.info["duration"])
PY
)"
fi
refuses "a GIF in colours" "grey films on paper only" --film --colour a.svg -o x.gif
refuses "no such kind" "no film is written with the suffix" --film a.svg -o x.jpg
refuses "no such folder" "nowhere" --film a.svg -o nowhere/x.png
