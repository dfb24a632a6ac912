# SPDX-License-Identifier: MIT
# Solid models: what is read, seen, hidden, lit; sizes on paper; what is said about the rest.
. "$ROOT/tests/check.sh"
stage=$ROOT/tests/stage
models=$ROOT/examples/models
list() { "$PLUMBAGO" -q --dump=list "$@"; }
# strokes ARGS...: how many lines the list has, by their width
strokes() { list "$@" | grep -c '^stroke'; }
fills() { list "$@" | grep -c '^fill'; }
page() { list "$@" | awk '$1 == "page" { printf "%.2f %.2f\n", $2, $3 }'; }

# ---- what is read ----
for model in cube.obj tube.stl pyramid.ply colours.off; do
    draws "$model" -o x.png "$stage/$model"
done
draws "binary STL" -o x.png "$ROOT/tests/fuzz/corpus-model/tube-binary.stl"
{ printf 'solid of a program that writes bytes'; head -c 44 /dev/zero; tail -c +81 "$ROOT/tests/fuzz/corpus-model/tube-binary.stl"; } >solid.stl
draws "binary STL that begins with 'solid'" -o x.png solid.stl
draws "PLY with the high byte first" -o x.png "$ROOT/tests/fuzz/corpus-model/pyramid-big.ply"
draws "strips of triangles" -o x.png "$ROOT/tests/fuzz/corpus-model/strip.ply"
plumbago -o y.png - <"$stage/cube.obj"
is "from standard input" $status 0
cp "$stage/cube.obj" cube.txt && draws "by content, not by name" -o x.png cube.txt
sed 's/$/\r/' "$stage/cube.obj" >dos.obj && list dos.obj >a && list "$stage/cube.obj" >b && same "line ends of DOS" a b
tr '\n' '\r' <"$stage/cube.obj" >mac.obj && list mac.obj >a && same "line ends of old" a b
# The same cube by negative numbers, with normals, in one line that goes on.
sed 's/^f 4 3 2 1/f -5\/\/1 -6\/\/1 \\\n -7\/\/1 -8\/\/1/' "$stage/cube.obj" >other.obj && list other.obj >a && same "negative numbers and lines that go on" a b
# Names of materials that stand in a line of their own are kept when the next statement goes on over lines.
printf 'v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 18 0 0\nv 18 9 0\nusemtl \\\nred\nf 1 2 3 4\nusemtl \\\na name that is longer than all that came before it\nusemtl \\\nred\nf 2 5 6 3\n' >names.obj
is "materials by names over several lines" "$(strokes --view front --light none names.obj)" 4
printf 'v 0 0 0\nv 9 0 0\nv 9 9 0\nl 1 2 3\n' >wire.obj
is "lines without faces" "$(strokes --view front wire.obj)" 2

# ---- what is seen ----
is "a cube from the front: four edges" "$(strokes --view front --light none "$stage/cube.obj")" 4
is "a cube from iso: nine" "$(strokes --view iso --light none "$stage/cube.obj")" 9
is "its hidden edges" "$(list --view iso --hidden dashed "$stage/cube.obj" | grep -c 'dash')" 3
is "its hidden edges, faint" "$(list --view iso --hidden faint "$stage/cube.obj" | grep -c 'stroke - colour 0.72')" 3
is "no light: no tone" "$(fills --light none "$models/house.obj")" 0
if [ "$(fills "$models/house.obj")" -gt 5 ]; then ok "light: tones"; else fail "light: tones" "$(fills "$models/house.obj")"; fi
list "$models/house.obj" >a && list --light 40,45 "$models/house.obj" >b && differ "light from the other side" a b
is "flat faces have even tones" "$(list "$models/house.obj" | grep -c '^gradient')" 0
if [ "$(list "$models/knot.obj" | grep -c '^gradient')" -gt 2 ]; then ok "those of round surfaces change"; else fail "those of round surfaces change" "no gradient"; fi
for view in front back left right top bottom iso 35,22 -30,-60; do list --view $view "$models/chair.obj" >"view$view"; done
is "views differ" "$(md5sum view* | cut -d' ' -f 1 | sort -u | wc -l)" 9
list "$models/chair.obj" >a && same "35,22 is what one gets" a view35,22
is "front and back are as wide as each other" "$(page --view front "$models/chair.obj")" "$(page --view back "$models/chair.obj")"
list --projection perspective "$models/chair.obj" >a && list --projection perspective=40 "$models/chair.obj" >b && same "perspective spans 40 degrees" a b
list --projection perspective=90 "$models/chair.obj" >c && differ "or more" a c
list --projection parallel "$models/chair.obj" >c && differ "parallel" a c
for up in x y z; do list --up $up "$models/chair.obj" >"up$up"; done
is "the axis that points upwards" "$(md5sum upx upy upz | cut -d' ' -f 1 | sort -u | wc -l)" 3
# A tube of eight sides has edges along it, when these are sharp.
is "creases" "$(strokes --view front --light none --crease 60 "$stage/tube.stl") $(strokes --view front --light none --crease 40 "$stage/tube.stl")" "4 13"
# Hatching runs along the surface: walls from top to bottom, a tube along its axis, wherever that leads.
hatched() { list "$@" | sed -n 's/^fill .* hatch \([-0-9.]*\) .*/\1/p'; }
is "walls are hatched from top to bottom" "$(hatched "$stage/cube.obj" | awk '{ if (($1 + 180) % 180 != 90) print }')" ""
check "a knot is hatched in many directions" test "$(hatched "$models/knot.obj" | awk '{ n[int(($1 + 180) % 180 / 30)] = 1 } END { for (k in n) c++; print c + 0 }')" -ge 5
# A tube that lies on its side, in view from its side: its axis is level.
awk 'BEGIN { n = 32; for (i = 0; i < n; i++) { a = 6.2831853 * i / n; printf "v -9 %.6f %.6f\nv 9 %.6f %.6f\n", 3 * cos(a), 3 * sin(a), 3 * cos(a), 3 * sin(a) }
    for (i = 0; i < n; i++) printf "f %d %d %d %d\n", 2 * i + 1, 2 * i + 2, 2 * ((i + 1) % n) + 2, 2 * ((i + 1) % n) + 1 }' >lying.obj
is "a tube is hatched along its axis" "$(hatched --view 0,20 lying.obj | awk '{ d = ($1 + 360) % 180; if (d > 90) d = 180 - d; if (d > 3) print } END { print (NR > 0) }')" 1

# Facets that turn by 26 degrees, too little for an edge, too much for a smooth surface: the outline runs along them, and all round.
awk 'BEGIN { for (i = 0; i < 6; i++) printf "v %.6f 0 %.6f\nv %.6f 2 %.6f\n", 8 * cos(i * 1.0471976), 8 * sin(i * 1.0471976), 4 * cos(i * 1.0471976), 4 * sin(i * 1.0471976)
    for (i = 0; i < 6; i++) printf "f %d %d %d %d\n", 2 * i + 1, 2 * i + 2, 2 * ((i + 1) % 6) + 2, 2 * ((i + 1) % 6) + 1
    print "f 2 4 6 8 10 12" }' >block.obj
is "the outline of a coarse mesh" "$(list --view 0,15 --light none block.obj | grep -c 'width 0.5')" 8

# ---- a sheet ----
for sheet in first-angle third-angle; do
    list --sheet $sheet "$models/bracket.obj" >$sheet.list
    is "$sheet: hidden lines and centre lines" "$(awk '/dash/ { n[$10 " " $11 " " $12]++ } END { for (k in n) c++; print c }' $sheet.list)" 2
done
differ "the angles differ" first-angle.list third-angle.list
is "a sheet without hidden lines" "$(list --sheet first-angle --hidden none "$models/chair.obj" | grep -c dash)" 0

# ---- size on paper ----
is "a house of 10 units is enlarged" "$(page --view front --light none "$models/house.obj")" "214.00 149.00"
is "a chair of 920 mm is drawn at 1:5" "$(page --view front "$models/chair.obj")" "98.00 194.00"
is "--scale is that of the thing" "$(page --scale 1:10 --view front "$models/chair.obj")" "49.00 97.00"

# ---- the same bytes ----
"$PLUMBAGO" -q --threads 1 -o one.png "$models/knot.obj"
"$PLUMBAGO" -q --threads 3 -o three.png "$models/knot.obj"
same "on any number of threads" one.png three.png

# ---- what is said ----
warns() { # NAME PATTERN FILE
    plumbago -o x.png "$3"
    if [ $status -eq 0 ] && [ "$(grep -c 'warning: ' "$TMP/err")" -eq 1 ] && grep -qE "warning: $3: $2" "$TMP/err"; then ok "$1"; else fail "$1" "$status $(cat "$TMP/err")"; fi
}
{ echo mtllib a.mtl; cat "$stage/cube.obj"; } >m.obj
warns "materials in another file" "its materials lie in another file, which is not read" m.obj
{ cat "$stage/cube.obj"; echo p 1 2 3; } >p.obj
warns "points" "left out: 3 points" p.obj
{ cat "$stage/cube.obj"; echo v nan 0 0; echo f 1 2 9; } >n.obj
warns "faces that are nowhere" "left out: 1 face with a corner that is nowhere" n.obj
sed 's/^f 5 6 7 8/f 5 6 7 88/' "$stage/cube.obj" >bad.obj
refuses "a corner that is not there, with its line" "bad\.obj:10: a corner names place 88 of 8" bad.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 x 0\n' >word.obj
refuses "a coordinate that is no number" "word\.obj:3: a coordinate is no number" word.obj
printf 'v 1 2 3\n' >point.obj
refuses "no faces" "point\.obj: it has places, and no face" point.obj
head -c 300 "$ROOT/tests/fuzz/corpus-model/pyramid-big.ply" >cut.ply
refuses "a PLY that is cut" "cut\.ply: .*(does not end|ends early)" cut.ply
printf 'OFF BINARY\n1 2 3' >binary.off
refuses "binary OFF" "binary\.off: binary OFF is not read" binary.off
refuses "it has one page" "no page 2" --page 2 "$stage/cube.obj"

# ---- the command line ----
misused "--view of another name" "view takes front, back, left, right, top, bottom or iso, or degrees" --view above "$stage/cube.obj"
misused "--view beyond the zenith" "view takes" --view 0,91 "$stage/cube.obj"
misused "--projection of nothing" "projection takes parallel or perspective" --projection perspective=0 "$stage/cube.obj"
misused "--up" "up takes x, y or z" --up w "$stage/cube.obj"
misused "--crease" "crease takes" --crease 0 "$stage/cube.obj"
misused "--hidden" "hidden takes none, dashed or faint" --hidden dotted "$stage/cube.obj"
misused "--light" "light takes none" --light sun "$stage/cube.obj"
misused "--sheet" "sheet takes none, first-angle or third-angle" --sheet second-angle "$stage/cube.obj"

# ---- structured formats, where they are built ----
# A triangle of 3 m, 2 m high.
numbers=$({ printf '\0\0\0\0\0\0\0\0\0\0\0\0'; printf '\0\0\100\100\0\0\0\0\0\0\0\0'; printf '\0\0\0\0\0\0\0\100\0\0\0\0'; } | base64 -w 0)
cat >triangle.gltf <<END
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,$numbers"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [3, 2, 0]}]}
END
printf 'ISO-10303-21;\nHEADER;\nFILE_SCHEMA((\047AUTOMOTIVE_DESIGN\047));\n' >part.step
refuses "STEP is named, with what helps" "part\.step: this is STEP: save it as STL or OBJ" part.step
mkdir bare && cp "$PLUMBAGO" bare/plumbago
PLUMBAGO=$PWD/bare/plumbago refuses "no tap-assimp" "reading glTF needs tap-assimp" triangle.gltf
if [ -x "$BUILD_DIR/tap-assimp" ]; then
    is "a glTF in metres, at 1:10" "$(page --view front triangle.gltf)" "310.00 210.00"
    is "its edges" "$(strokes --view front --light none triangle.gltf)" 3
    sed 's/data:[^"]*/numbers.bin/' triangle.gltf >other.gltf
    refuses "a glTF with its numbers elsewhere" 'other\.gltf: assimp: .*numbers\.bin' other.gltf
    head -c 200 triangle.gltf >cut.gltf
    refuses "a glTF that is cut" "cut\.gltf: assimp: " cut.gltf
else
    skip "glTF" "this build has no tap-assimp (Debian: libassimp-dev)"
fi
