#!/usr/bin/env bash
# Every example has its small picture, light enough to be shown beside others, and of the mesh and parameters that it has
# now; tools/pictures.sh --examples takes them.
set -euo pipefail

source_dir=${KNIT_SOURCE_DIR:?}
program=${KNIT_MESH:?}

fail() {
  printf 'pictures_test: %s\n' "$*" >&2
  exit 1
}

number_at() { # file, byte: four bytes, the highest first
  printf '%d' "0x$(od -An -tx1 -j "$2" -N 4 "$1" | tr -d ' ')"
}

count=0
while read -r name _; do
  picture=$source_dir/assets/$name/picture.png
  [ -f "$picture" ] || fail "$name has no picture; run tools/pictures.sh --examples"
  [ "$(od -An -tx1 -N 8 "$picture" | tr -d ' ')" = 89504e470d0a1a0a ] || fail "$picture is no PNG"
  [ "$(number_at "$picture" 16)x$(number_at "$picture" 20)" = 160x120 ] || fail "$picture is not 160x120"
  [ "$(stat -c %s "$picture")" -le 8192 ] || fail "$picture has more than 8 KB"
  cmp -s "$picture" "$(dirname "$program")/assets/$name/picture.png" || fail "$picture is not with the program"
  now=$(KNIT_MESH=$program "$source_dir/tools/pictures.sh" --digest "$name")
  grep -qxF "$name $now" "$source_dir/assets/pictures.txt" ||
    fail "the example $name is not what its picture shows; run tools/pictures.sh --examples"
  count=$((count + 1))
done < <("$program" --list-examples)
[ "$count" -ge 17 ] || fail "only $count examples"
echo "pictures_test: $count pictures"
