#!/usr/bin/env bash
# Takes the program's pictures by its own command line.
#   tools/pictures.sh FOLDER            every scene, in both themes, at two sizes, and one at 4K:
#                                       FOLDER/SCENE-THEME-WIDTHxHEIGHT.png
#   tools/pictures.sh --docs            those of README and docs, into docs/pictures
#   tools/pictures.sh --examples        the small ones of what each example is when it is knitted: assets/EXAMPLE/picture.png, and
#                                       in assets/pictures.txt of which mesh and parameters they are. Needs ImageMagick
#   tools/pictures.sh --digest EXAMPLE  that of its mesh and parameters
#   tools/pictures.sh --pair NAME ...   a mesh as its rows were placed and as it settled: NAME-placed.png, NAME-settled.png;
#                                       ... is a mesh with what else the program is told. YAW, PITCH: where from
#   tools/pictures.sh --short-rows NAME ...  a mesh settled in whole rounds and with short rows: NAME-off.png, NAME-auto.png
# KNIT_MESH: the program, else build/dev/knit-mesh. KNIT_MESHES: where simple-elbow.obj may lie, else ../shared/meshes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=${KNIT_MESH:-$root/build/dev/knit-mesh}
meshes=${KNIT_MESHES:-$root/../shared/meshes}
aside=$(mktemp -d)
trap 'rm -rf "$aside"' EXIT

scenes=(empty start row stall labels finished lesson chart split hold limbs)
docs_dark=(row lesson split hold limbs)
docs_light=(finished chart)
small_epsilon="--example thesis-sphere --epsilon 0.012"

options_of() {
  case $1 in
    empty) echo "--empty" ;;
    start) echo "--example thesis-sphere --at 0" ;;
    row) echo "--example thesis-sphere --at rows:14:13 --list candidates" ;;
    stall | debug-stall) echo "$small_epsilon --break stall --list candidates" ;;
    labels) echo "--example vase --at stitches:15:15" ;;
    finished) echo "--example thesis-sphere" ;;
    lesson) echo "--lesson what-it-does --lesson-page 4" ;;
    split) echo "--example torus --axis x --rows contours --placement nearest --at rows:13:3 --side tubes" ;;
    hold) echo "--example octopus --at rows:57 --side tubes" ;;
    limbs) echo "--example octopus --settle on --side report" ;;
    chart) echo "--example vase --preset best-rows --centre chart --side pattern" ;;
    best-rows) echo "--preset best-rows --side report" ;;
    debug-problems) echo "$small_epsilon --list problems" ;;
    debug-sweep) echo "$small_epsilon --sweep epsilon=0.005:0.05:181 --side sweep" ;;
    debug-compare) echo "$small_epsilon --diff $aside/wide.json --side compare" ;;
    *) return 1 ;;
  esac
}

take() { # scene theme size scale file
  local options
  read -r -a options <<<"$(options_of "$1")"
  local code=0
  "$program" "${options[@]}" --headless --theme "$2" --size "$3" --scale "$4" --screenshot "$5" >/dev/null 2>&1 || code=$?
  # A stall that the run goes on after is no failure; neither is a run that stops.
  [ "$code" -le 1 ] && [ -s "$5" ] || {
    echo "pictures: $1 could not be taken (exit code $code)" >&2
    return 1
  }
}

# Edges in the colours of their stretch, and no lines from where each stitch came. The last iteration is the place
# before one that no run comes to.
pair() { # name, and what the program is told
  local name=$1
  shift
  "$program" "$@" --headless --at settle:0:1000 --save-session "$aside/pair.json" 2>/dev/null
  sed -E -i -e 's/"moves": true/"moves": false/' -e "s/\"yaw\": [^,]*/\"yaw\": ${YAW:-3.65}/" \
    -e "s/\"pitch\": [^,]*/\"pitch\": ${PITCH:--0.42}/" "$aside/pair.json"
  local positions
  for positions in placed settled; do
    "$program" --session "$aside/pair.json" --positions "$positions" --headless --alone --size 700x700 \
      --save-picture "$name-$positions.png"
  done
}

short_rows() { # name, and what the program is told
  local name=$1
  shift
  local rows
  for rows in off auto; do
    "$program" "$@" --short-rows "$rows" --settle on --headless --at settle:0:1000 --save-session "$aside/short.json" 2>/dev/null
    sed -E -i -e 's/"moves": true/"moves": false/' -e "s/\"yaw\": [^,]*/\"yaw\": ${YAW:-5.85}/" \
      -e "s/\"pitch\": [^,]*/\"pitch\": ${PITCH:--0.24}/" "$aside/short.json"
    "$program" --session "$aside/short.json" --headless --alone --size 700x700 --save-picture "$name-$rows.png"
  done
}

docs() {
  local into=$root/docs/pictures
  "$program" --example thesis-sphere --headless --save-session "$aside/wide.json"
  local scene
  for scene in "${docs_dark[@]}"; do take "$scene" dark 1280x720 1 "$into/$scene-dark.png"; done
  for scene in "${docs_light[@]}"; do take "$scene" light 1280x720 1 "$into/$scene-light.png"; done
  for scene in debug-problems debug-stall debug-sweep debug-compare; do
    take "$scene" dark 1280x720 1 "$into/$scene.png"
  done
  take best-rows dark 1440x900 1 "$into/best-rows.png"
  pair "$into/ball" --example sphere --preset best-rows
  pair "$into/starfish" --example starfish --settle on
  short_rows "$into/heel" --example heel
  if [ -f "$meshes/simple-elbow.obj" ]; then
    YAW=2.1 PITCH=-0.25 pair "$into/elbow" "$meshes/simple-elbow.obj"
    YAW=2.1 PITCH=-0.25 short_rows "$into/elbow" "$meshes/simple-elbow.obj" --timing harmonic
  else
    echo "pictures: no simple-elbow.obj in $meshes, so the elbow stays as it was" >&2
  fi
}

digest_of() {
  local home
  home=$(dirname "$program")/assets/$1
  cat "$home/mesh.obj" "$home/parameters.json" | sha256sum | cut -c 1-16
}

# Drawn four times as large and made smaller, for stitches are finer than these pixels; 64 colours keep them light.
examples() {
  local name lines=""
  while read -r name _; do
    "$program" --example "$name" --headless --alone --transparent --size 640x480 --scale 2 \
      --save-picture "$aside/large.png" >/dev/null 2>&1 || [ -s "$aside/large.png" ]
    convert "$aside/large.png" -resize 160x120 +dither -colors 64 -strip -define png:compression-level=9 \
      "$root/assets/$name/picture.png"
    rm "$aside/large.png"
    lines+="$name $(digest_of "$name")"$'\n'
  done < <("$program" --list-examples)
  printf '%s' "$lines" >"$root/assets/pictures.txt"
}

case ${1:-} in
  --examples)
    examples
    exit 0
    ;;
  --digest)
    digest_of "${2:?give an example}"
    exit 0
    ;;
  --docs)
    docs
    exit 0
    ;;
  --pair)
    shift
    pair "$@"
    exit 0
    ;;
  --short-rows)
    shift
    short_rows "$@"
    exit 0
    ;;
esac

folder=${1:?give a folder to write into}
mkdir -p "$folder"
for scene in "${scenes[@]}"; do
  for theme in dark light; do
    take "$scene" "$theme" 1280x720 1 "$folder/$scene-$theme-1280x720.png"
    take "$scene" "$theme" 1920x1080 1 "$folder/$scene-$theme-1920x1080.png"
  done
done
# One stands for all: pictures at 4K take longer than all others together.
take row light 3840x2160 2 "$folder/row-light-3840x2160.png"
echo "pictures: $(find "$folder" -name '*.png' | wc -l) in $folder"
