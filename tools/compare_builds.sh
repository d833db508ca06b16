#!/usr/bin/env bash
# Compares what two builds write, byte for byte: every example and every mesh of a folder, with its own parameters and
# with each preset, and some runs that take other ways. A change that should change nothing is held against this.
#
#   tools/compare_builds.sh OLD/knit-mesh NEW/knit-mesh [FOLDER_OF_OBJ]
#
# Prints a line for each output that differs, with its first lines that do; exits with 1 if there is any.
set -euo pipefail

old=$1 new=$2 meshes=${3:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

write_all() { # write_all PROGRAM FOLDER ARGUMENTS...
  local program=$1 folder=$2 code=0
  shift 2
  mkdir -p "$folder"
  "$program" "$@" --headless --save-steps "$folder/steps" --save-report "$folder/report" --save-mesh "$folder/mesh" \
    --save-map "$folder/map" >"$folder/out" 2>"$folder/error" || code=$?
  echo "$code" >"$folder/exit"
  code=0
  "$program" "$@" --headless --save-pattern "$folder/pattern.txt" >"$folder/pattern-out" 2>"$folder/pattern-error" ||
    code=$?
  echo "$code" >"$folder/pattern-exit"
  sed -Ei '/^ *"(load|run)": [0-9.e-]+,?$/d' "$folder/report" 2>/dev/null || true # milliseconds
  # The folder's own name may stand in a message.
  sed -i "s#$folder#FOLDER#g" "$folder"/{out,error,pattern-out,pattern-error}
}

compare() { # compare NUMBER ARGUMENTS...
  local number=$1 name file
  shift
  write_all "$old" "$work/$number/old" "$@"
  write_all "$new" "$work/$number/new" "$@"
  for file in "$work/$number"/old/* "$work/$number"/new/*; do
    name=$(basename "$file")
    [ "$file" = "$work/$number/new/$name" ] && [ -e "$work/$number/old/$name" ] && continue
    if ! cmp -s "$work/$number/old/$name" "$work/$number/new/$name"; then
      echo "differs: $name of $*"
      { diff "$work/$number/old/$name" "$work/$number/new/$name" 2>&1 || true; } | head -4 | cut -c1-200 | sed 's/^/    /'
    fi
  done
  rm -rf "${work:?}/$number"
}
export -f compare write_all
export old new work

runs=()
sources=()
while IFS= read -r example; do sources+=("--example $example"); done < <("$old" --list-examples)
if [ -n "$meshes" ]; then
  for mesh in "$meshes"/*.obj; do sources+=("$mesh"); done
fi
for source in "${sources[@]}"; do
  runs+=("$source")
  for preset in thesis best-rows knitters-gauge; do runs+=("$source --preset $preset"); done
done
runs+=(
  "--example thesis-sphere --placement even"
  "--example thesis-sphere --metric geodesic --epsilon 0.03"
  "--example thesis-sphere --metric arc --last-anchor drop --close none"
  "--example thesis-sphere --epsilon 0.012 --on-stall stop"
  "--example thesis-sphere --resample off"
  "--example sphere --timing geodesic --rows contours"
  "--example egg --timing harmonic --rows contours --placement nearest --follow-mains on"
  "--example vase --timing arc-length --rows contours --stacking-penalty 0.5 --placement nearest"
  "--example capsule --axis 1,1,0 --rows contours --sizes gauge --gauge 18,26"
  "--example cone --start 0 --rows contours --start-direction 1,0,0"
)

printf '%s\n' "${runs[@]}" | awk '{ print NR, $0 }' |
  xargs -d '\n' -P "$(nproc)" -I LINE bash -c 'compare $1' _ LINE >"$work/differences"
cat "$work/differences"
echo "${#runs[@]} runs compared, $(grep -c '^differs' "$work/differences" || true) outputs differ"
! grep -q '^differs' "$work/differences"
