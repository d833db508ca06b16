#!/usr/bin/env bash
# The command line's contract: exit codes, streams, files, places. Prints what failed.
set -euo pipefail

program=$(realpath "${KNIT_MESH:?the path of the program}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY XAUTHORITY
export XDG_STATE_HOME=$folder/state XDG_CONFIG_HOME=$folder/config
cd "$folder"

checks=0
failures=0
fail() {
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$*"
  [ -z "${last:-}" ] || printf '  after: %s\n' "$last"
  printf '  exit code %s, standard error:\n' "${code:-none}"
  sed 's/^/    /' err 2>/dev/null || true
}
# ok WORDS COMMAND...: the command must succeed.
ok() {
  local words=$1
  shift
  checks=$((checks + 1))
  "$@" >/dev/null 2>&1 || fail "$words"
}
no() { ! "$@"; }

# Runs the program; what it says is in `out` and `err`, its exit code in $code.
run() {
  last="knit-mesh $*"
  code=0
  timeout 120 "$program" "$@" >out 2>err || code=$?
}
# run_to CODE ARGUMENTS...: every line on standard error must be one of ours.
run_to() {
  local wanted=$1
  shift
  run "$@"
  ok "exit code $wanted" [ "$code" = "$wanted" ]
  ok "each message is a line of its own" no grep -qv '^knit-mesh: ' err
}
says() { ok "standard error says \"$1\"" grep -qi -- "$1" err; }
quiet() { ok "nothing on standard error" [ ! -s err ]; }
one_line() { ok "one line on standard error" [ "$(wc -l <err)" = 1 ]; }

have_python=no
command -v python3 >/dev/null && python3 -c 'import json, zlib' 2>/dev/null && have_python=yes

is_json() {
  if [ $have_python = yes ]; then
    python3 -m json.tool "$1" /dev/null
  else
    [ "$(head -c 1 "$1")" = "{" ] && [ "$(tail -n 1 "$1")" = "}" ] && grep -q '"rows"' "$1"
  fi
}
# has FILE TEXT: whatever the white space.
has() { tr -d ' \n' <"$1" | grep -qF -- "$2"; }

# A PNG of that size with the palette's colours of knit, main and M1R, and many more.
is_picture() {
  [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] || return 1
  [ "$(wc -c <"$1")" -gt 20000 ] || return 1
  [ $have_python = no ] || python3 - "$@" <<'PYTHON'
import struct, sys, zlib
data = open(sys.argv[1], 'rb').read()
width, height = (int(n) for n in sys.argv[2:4])
at, packed = 8, b''
while at < len(data):
    size, kind = struct.unpack('>I4s', data[at:at + 8])
    body = data[at + 8:at + 8 + size]
    if kind == b'IHDR':
        assert struct.unpack('>IIBB', body[:10]) == (width, height, 8, 6), body
    if kind == b'IDAT':
        packed += body
    at += size + 12
raw = zlib.decompress(packed)
stride = 4 * width
colours, middle, above = {}, {}, bytearray(stride)
for y in range(height):
    begin = y * (stride + 1)
    how, line = raw[begin], bytearray(raw[begin + 1:begin + 1 + stride])
    for x in range(stride):
        a = line[x - 4] if x >= 4 else 0
        b, c = above[x], above[x - 4] if x >= 4 else 0
        if how == 1: line[x] = line[x] + a & 255
        elif how == 2: line[x] = line[x] + b & 255
        elif how == 3: line[x] = line[x] + (a + b) // 2 & 255
        elif how == 4:
            p, q, r = abs(b - c), abs(a - c), abs(a + b - 2 * c)
            line[x] = line[x] + (a if p <= q and p <= r else b if q <= r else c) & 255
    for x in range(0, stride, 4):
        colour = tuple(line[x:x + 3])
        colours[colour] = colours.get(colour, 0) + 1
        if 0.35 < y / height < 0.65 and 1.8 < x / width < 2.1:  # x counts bytes
            middle[colour] = middle.get(colour, 0) + 1
    above = line
assert len(colours) > 500, len(colours)
assert max(colours.values()) < 0.9 * width * height, 'blank'
assert len(middle) > 100 and max(middle.values()) < 0.5 * sum(middle.values()), 'no mesh in the middle'
for colour in (206, 202, 190), (204, 121, 167), (213, 94, 0):
    assert colours.get(colour, 0) > 20, colour
PYTHON
}

# --- Answers ------------------------------------------------------------------------------------------------

for option in --help --version --list-examples --list-parameters; do
  run_to 0 "$option"
  quiet
  ok "$option answers on standard output" [ -s out ]
done
run_to 0 --list-examples
ok "all examples are there" [ "$(tr '\n' ' ' <out)" = \
  "thesis-sphere sphere stretched-sphere egg capsule cone vase torus heel trousers y starfish octopus mug cup \
double-torus chain-of-three " ]

run_to 0 index 6,12,17,22
quiet
printf '%s\n' '1: [5, 5, 5, 5, 5, 5]' '2: [6, 1, 6, 2, 6, 1, 6, 2, 6, 1, 6, 2]' \
  '3: [6, 1, 0, 0, 2, 6, 1, 0, 0, 0, 6, 1, 0, 0, 0, 6, 1]' \
  '4: [6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 6, 1, 0, 0, 0, 0, 0, 0, 2]' >wanted
ok "index prints the arrays of Appendix A" cmp out wanted

# --- Checking a written pattern ------------------------------------------------------------------------------

printf 'CO 6 sts.\nRnd 1: *K1, m1l; rep from * to end. (12 sts)\nBO all.\n' >ball.txt
run_to 0 check ball.txt
quiet
ok "check says that every count holds" [ "$(cat out)" = \
  '1 round; 3 lines worked, 0 not understood, 0 without instructions: every count holds.' ]
sed 's/12/13/' ball.txt >wrong.txt
run_to 1 check - <wrong.txt
quiet
ok "check names the line" [ "$(head -n 1 out)" = 'line 2: Rnd 1 makes 12 stitches, the line says 13.' ]

# --- Bad usage, unreadable and unfit files: 2, one line, nothing on standard output ---------------------------

printf 'hello, I am no mesh\n' >words.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n' >holed.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n' >beyond.obj
{ cat holed.obj; printf 'f 2 3 4\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n'; } >pieces.obj
: >empty.obj
mkdir -p folder.obj
refused() {
  local wanted=$1
  shift
  run_to 2 "$@"
  one_line
  says "$wanted"
  ok "nothing on standard output" [ ! -s out ]
}
refused 'help' --no-such-option
refused 'help' a.obj b.obj
refused 'not both' a.obj --example egg
refused 'above 0' --epsilon 0 --headless
refused 'STAGE' --at nowhere --headless
refused 'value' --headless --save-report ''
refused 'does not exist' missing.obj --headless
refused 'folder' folder.obj --headless
refused 'words.obj' words.obj --headless
refused 'empty.obj' empty.obj --headless
refused 'vertex' beyond.obj --headless
refused 'hole' holed.obj --headless --save-report -
refused '--repair largest-piece' pieces.obj --headless
refused 'pieces' pieces.obj --repair holes --headless
refused 'largest-piece' pieces.obj --repair darn --headless
refused 'choose one of' --example teapot --headless
refused 'not a vertex' --start 999999 --headless
refused 'double or halve' index 6,13
refused 'no pattern' check words.obj
refused 'does not exist' check missing.txt
# No display and no --headless.
refused '--headless' --example sphere

# --- A whole run, piped and saved ---------------------------------------------------------------------------

mkdir saved
run_to 0 --headless --save-report - --save-mesh saved/mesh.obj --save-map saved/map.txt --save-steps saved/steps.jsonl
quiet
ok "the report on standard output is JSON" is_json out
cp out report.json
ok "the report counts the mesh" has report.json '"vertices":8258,"triangles":16384'
ok "the report counts the faces" has report.json '"faces":{"quads":3307,"triangles":118},"euler":0'
ok "the report has no problem" has report.json '"problems":[]'
ok "the report has the rows" has report.json '"rows":[6,12,17,22,26,33,33,43,43,43,43,65,'
ok "the mesh has a vertex a stitch" [ "$(grep -c '^v ' saved/mesh.obj)" = 3372 ]
ok "the mesh has a group a row" [ "$(grep -c '^g row_[0-9]*$' saved/mesh.obj)" = 63 ]
ok "the mesh has its faces" [ "$(grep -c '^f ' saved/mesh.obj)" = 3425 ]
ok "the map has a line a row" [ "$(grep -cE '^[0-9]+: \[[0-6](, [0-6])*\]$' saved/map.txt)" = 64 ]
ok "the steps are a line each" has report.json "\"steps\":$(wc -l <saved/steps.jsonl),"
ok "nothing else is left behind" [ "$(ls -A saved | tr '\n' ' ')" = "map.txt mesh.obj steps.jsonl " ]
run_to 0 --headless --save-mesh again.obj --save-steps again.jsonl
ok "a second run gives the same mesh" cmp saved/mesh.obj again.obj
ok "a second run takes the same steps" cmp saved/steps.jsonl again.jsonl
run_to 0 --headless --save-map -
ok "any file can go to standard output" cmp out saved/map.txt
run_to 0 --headless --cast-on 8 --epsilon 0.04 --axis 0,2.5,0 --at cast-on --save-report -
ok "parameters reach the report" has out '"axis":"0,2.5,0"'
ok "parameters reach the report" has out '"cast-on":8,"counts":"whole"'
ok "parameters reach the report" has out '"metric":"euclidean","epsilon":0.04'

# --- Where to stop --------------------------------------------------------------------------------------------

# at PLACE STAGE ROW ITEM: the last step taken stands there; PLACE counts items from 1, steps have them from 0.
at() {
  run_to 0 --example sphere --headless --at "$1" --save-steps -
  quiet
  tail -n 1 out >last_step
  ok "--at $1 ends at $2 $3 $4" has last_step "\"stage\":\"$2\",\"row\":$3,\"item\":$4,"
}
at timing timing 0 0
at cast-on cast-on 1 0
at rows rows 2 0
at rows:7 rows 7 0
at rows:7:4 rows 7 3
at stitches stitches 2 0
at faces faces 2 0
at faces:9:5 faces 9 4
at pattern pattern 1 0
run_to 0 --example sphere --headless --at 123 --save-steps -
ok "--at 123 takes 123 steps" [ "$(wc -l <out)" = 123 ]
run_to 0 --example sphere --headless --at 0 --save-report -
ok "--at 0 takes none" has out '"steps":0,'
run_to 0 --example sphere --headless --at 123456789 --save-report -
one_line
says 'showing the last'
run_to 0 --example sphere --headless --at rows:5:99999
one_line
says 'nearest before it'

# --- A mesh that the algorithm stops on: 1, a word about it, and what was finished ------------------------------

# That it has a handle is known when it is opened, so the first line says it.
run_to 1 --example torus --rows rings --headless --save-report report1.json --save-steps steps1.jsonl --save-mesh mesh1.obj \
  --save-map map1.txt --screenshot torus.png
ok "two lines on standard error" [ "$(wc -l <err)" = 2 ]
says 'handle'
says 'split'
says '--rows contours'
ok "the report is written" is_json report1.json
ok "the report says so too" grep -q 'split' report1.json
for file in steps1.jsonl mesh1.obj torus.png; do ok "$file is written" [ -s $file ]; done
ok "the map is written" [ -e map1.txt ]
for option in '--save-pattern p.txt' '--save-pattern p.html' '--save-chart p.svg' '--save-gltf p.glb' '--save-plots p.csv'; do
  run_to 1 --example torus --rows rings --headless $option # the words of the option apart
  ok "$option: why it stopped, and that nothing is written for that" [ "$(wc -l <err)" = 3 ]
  says 'the run stopped'
  ok "$option: nothing is written" [ ! -e p.* ]
done
run_to 2 --example torus --rows rings --headless --save-pattern p.txt --save-report no/such/folder/file
says 'no/such/folder/file'
run_to 2 --headless --at rows:3 --save-pattern p.txt # it did not stop: asked for too early
says 'not there yet'
run_to 1 --headless --epsilon 0.001 --on-stall stop --save-mesh stalled.obj
says 'nothing within'
ok "the rows before the stall are written" grep -q '^g row_001' stalled.obj

# --- Welding, paths with spaces, other folders ------------------------------------------------------------------

vertices_of() { tr -d ' \n' <"$1" | grep -o '"vertices":[0-9]*' | grep -o '[0-9]*$'; }
run_to 0 --headless --weld off --at timing --save-report unwelded.json
run_to 0 --headless --weld on --at timing --save-report welded.json
ok "welding merges vertices" [ "$(vertices_of welded.json)" -lt "$(vertices_of unwelded.json)" ]

mkdir -p 'a folder/with spaces'
cp "$(dirname "$program")/assets/egg/mesh.obj" 'a folder/an egg.obj'
run_to 0 'a folder/an egg.obj' --headless --save-report 'a folder/with spaces/the report.json'
quiet
ok "a path with spaces is fine" is_json 'a folder/with spaces/the report.json'
ln -s "$program" 'a folder/with spaces/knit mesh'
code=0
(cd 'a folder/with spaces' && './knit mesh' '../an egg.obj' --headless --at rows --save-map 'map here.txt' &&
  './knit mesh' --example egg --headless --at rows --save-map 'example.txt') >out 2>err || code=$?
last='./knit mesh, in another folder'
ok "it runs from another folder, by another name" [ "$code" = 0 ]
ok "it writes into that folder" [ -s 'a folder/with spaces/map here.txt' ]
ok "it finds its examples from there" [ -s 'a folder/with spaces/example.txt' ]

# --- Pictures and what cannot be written ---------------------------------------------------------------------------

run_to 0 --headless --size 800x600 --screenshot 'a folder/picture.png'
ok "a picture without a display" is_picture 'a folder/picture.png' 800 600
run_to 0 --example cone --headless --at rows:9 --size 640x480 --screenshot -
ok "a picture on standard output" [ "$(head -c 4 out | tail -c 3)" = PNG ]

for option in --save-mesh --save-map --save-report --save-steps --screenshot; do
  run_to 2 --example sphere --headless --at rows:3 "$option" no/such/folder/file
  one_line
  says 'no/such/folder/file'
done
printf 'old' >kept.json
run_to 2 --example sphere --headless --at rows:3 --save-report kept.json/report.json --save-map other.txt
ok "what can be written is written" [ -s other.txt ]
ok "the file in the way is as it was" [ "$(cat kept.json)" = old ]
if [ -c /dev/full ]; then
  last='knit-mesh --save-report - on a full disk'
  code=0
  timeout 120 "$program" --example sphere --headless --at rows:3 --save-report - >/dev/full 2>err || code=$?
  ok "a full disk is said" [ "$code" = 2 ]
  says 'cannot write'
fi

printf '%s checks, %s failed\n' "$checks" "$failures"
[ "$failures" = 0 ]
