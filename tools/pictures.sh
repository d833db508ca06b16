#!/usr/bin/env bash
# Takes the program's pictures by its own command line: eleven scenes, in both themes, at two sizes, and one at 4K.
#   tools/pictures.sh FOLDER          all of them, FOLDER/SCENE-THEME-WIDTHxHEIGHT.png
#   tools/pictures.sh --docs          those of README and docs, into docs/pictures
# KNIT_MESH: the program, else build/dev/knit-mesh.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=${KNIT_MESH:-$root/build/dev/knit-mesh}

scenes=(empty start row stall labels finished lesson chart split hold limbs)

options_of() {
  case $1 in
    empty) echo "--empty" ;;
    start) echo "--example thesis-sphere --at 0" ;;
    row) echo "--example thesis-sphere --at rows:14:12 --list candidates" ;;
    stall) echo "--example thesis-sphere --epsilon 0.012 --break stall --list candidates" ;;
    labels) echo "--example vase --at stitches:15:14" ;;
    finished) echo "--example thesis-sphere" ;;
    lesson) echo "--lesson what-it-does --lesson-page 4" ;;
    split) echo "--example torus --axis x --rows contours --placement nearest --at rows:13:2 --side tubes" ;;
    hold) echo "--example octopus --at rows:57 --side tubes" ;;
    limbs) echo "--example octopus --settle on --side report" ;;
    chart) echo "--example vase --preset best-rows --centre chart --side pattern" ;;
    *) return 1 ;;
  esac
}

take() { # scene theme size scale file
  local options
  read -r -a options <<<"$(options_of "$1")"
  local code=0
  "$program" "${options[@]}" --headless --theme "$2" --size "$3" --scale "$4" --screenshot "$5" 2>/dev/null || code=$?
  # A stall that the run goes on after is no failure; neither is a run that stops.
  [ "$code" -le 1 ] && [ -s "$5" ] || {
    echo "pictures: $1 could not be taken (exit code $code)" >&2
    return 1
  }
}

if [ "${1:-}" = --docs ]; then
  for scene in "${scenes[@]}"; do
    for theme in dark light; do
      take "$scene" "$theme" 1280x720 1 "$root/docs/pictures/$scene-$theme.png"
    done
  done
  exit 0
fi

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
