#!/usr/bin/env bash
# What tools/tidy.py and tools/each_file.py leave out because their ledgers know it as clean: only what has not changed
# in anything that the verdict depends on. clang-tidy and the compiler are stand-ins that note what they were asked.
set -euo pipefail

source_dir=${KNIT_SOURCE_DIR:?}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compiler=$(command -v c++ || command -v g++)

fail() {
  printf 'ledger_test: %s\n' "$*" >&2
  exit 1
}

mkdir "$work/bin"
cat >"$work/bin/clang-tidy-14" <<'END'
#!/usr/bin/env bash
case $1 in
  --version) echo "stand-in version 1" && exit ;;
  --dump-config) echo "---" && exit ;;
esac
for word in "$@"; do
  case $word in
    */joined.cpp)
      echo "${word#*/tidy/}" >>"$ASKED"
      ! grep -n BAD "$word" # a finding
      exit
      ;;
  esac
done
END
cat >"$work/bin/noting-c++" <<END
#!/usr/bin/env bash
case "\$*" in
  *-fsyntax-only*) echo "\${!#}" >>"\$ASKED" ;;
esac
exec "$compiler" "\$@"
END
chmod +x "$work"/bin/*
export PATH=$work/bin:$PATH ASKED=$work/asked

# lay_out TREE BUILD FLAG: the commands by which TREE is built in BUILD.
lay_out() {
  local tree=$1 build=$2 flag=$3 path comma=""
  mkdir -p "$build"
  {
    printf '['
    for path in knit/far/far.cpp knit/near/near.cpp; do
      printf '%s\n{"file": "%s", "command": "noting-c++ -I%s -isystem %s/made -DWHERE=\\"%s\\" %s -o x.o -c %s"}' \
        "$comma" "$tree/$path" "$tree" "$build" "$tree" "$flag" "$tree/$path"
      comma=,
    done
    printf ']\n'
  } >"$build/compile_commands.json"
}

# asked TOOL [ARGUMENT...]: runs it in $tree; what its checker was asked of, on one line; its status in $status.
asked() {
  local tool=$1
  shift
  : >"$ASKED"
  status=0
  "$tree/tools/$tool" "$@" "$build" >"$work/said" 2>&1 || status=$?
  words=$(sed "s|^$tree/||" "$ASKED" | sort | tr '\n' ' ')
}

# expect WHAT WORDS STATUS
expect() {
  [ "$words" = "$2" ] || fail "$1: checked '$words', not '$2': $(cat "$work/said")"
  [ "$status" = "$3" ] || fail "$1: ended with $status, not $3: $(cat "$work/said")"
}

tree=$work/tree build=$work/tree/build/plain
mkdir -p "$tree"/{tools,knit/{far,near,deep},app,assets}
cp "$source_dir"/tools/{ledger,tidy,each_file}.py "$tree/tools/"
echo "Checks: 'some'" >"$tree/.clang-tidy"
echo '#include "knit/near/near.h"' >"$tree/knit/near/near.cpp"
printf '#pragma once\n#include "../deep/deep.h"\n' >"$tree/knit/near/near.h" # deep.h is met by way of near.h only
printf '#pragma once\n#include <made.h>\nint deep();\n' >"$tree/knit/deep/deep.h"
echo 'int far() { return 1; }' >"$tree/knit/far/far.cpp"
lay_out "$tree" "$build" -DFLAG
mkdir -p "$build/made"
echo '#pragma once' >"$build/made/made.h"

# Each tool with what it calls its two units.
for tool in tidy.py each_file.py; do
  far=knit/far/far.cpp near=knit/near/near.cpp
  [ $tool = tidy.py ] && far=knit/far/joined.cpp near=knit/near/joined.cpp
  ledger=tools/clean/${tool%.py}.txt

  asked $tool
  expect "$tool, nothing known" "$far $near " 0
  [ ! -e "$tree/$ledger" ] || fail "$tool wrote a ledger unasked"
  asked $tool --record
  expect "$tool, to be recorded" "$far $near " 0
  asked $tool
  expect "$tool, all known" "" 0

  # Elsewhere, built elsewhere.
  cp -r "$tree" "$work/moved"
  mv "$work/moved/build/plain" "$work/elsewhere"
  lay_out "$work/moved" "$work/elsewhere" -DFLAG
  tree=$work/moved build=$work/elsewhere
  asked $tool
  expect "$tool, a moved tree" "" 0
  rm -rf "$work/moved" "$work/elsewhere"
  tree=$work/tree build=$work/tree/build/plain

  # What the verdict depends on, one after the other, each put back.
  for changed in knit/deep/deep.h build/plain/made/made.h; do
    echo "// more" >>"$tree/$changed"
    asked $tool
    expect "$tool, $changed changed" "$near " 0
    sed -i '$d' "$tree/$changed"
  done
  for script in $tool ledger.py; do
    echo "# more" >>"$tree/tools/$script"
    asked $tool
    expect "$tool, $script changed" "$far $near " 0
    sed -i '$d' "$tree/tools/$script"
  done
  lay_out "$tree" "$build" -DOTHER
  asked $tool
  expect "$tool, another flag" "$far $near " 0
  lay_out "$tree" "$build" -DFLAG
  asked $tool
  expect "$tool, all put back" "" 0

  # A fault is told each time, and is never recorded; nor does the line from before it stay.
  echo '#error BAD' >>"$tree/knit/far/far.cpp"
  for time in first second; do
    asked $tool --record
    expect "$tool, a fault, the $time time" "$far " 1
    grep -q "knit/near" "$tree/$ledger" || fail "$tool: a fault in one unit took the other's line away"
    ! grep -q "knit/far" "$tree/$ledger" || fail "$tool recorded a fault"
  done
  sed -i '$d' "$tree/knit/far/far.cpp"
  asked $tool
  expect "$tool, repaired" "$far " 0

  # Two branches' ledgers put together.
  asked $tool --record
  sed -i 'p; s/ .*/ 00000000000000000000000000000000/' "$tree/$ledger"
  asked $tool
  expect "$tool, two lines a unit" "" 0
done

echo "Checks: 'others'" >"$tree/.clang-tidy"
asked tidy.py
expect "other settings" "knit/far/joined.cpp knit/near/joined.cpp " 0
sed -i 's/version 1/version 2/' "$work/bin/clang-tidy-14"
echo "Checks: 'some'" >"$tree/.clang-tidy"
asked tidy.py
expect "another clang-tidy" "knit/far/joined.cpp knit/near/joined.cpp " 0
sed -i 's/version 2/version 1/' "$work/bin/clang-tidy-14"
asked tidy.py
expect "all as recorded" "" 0
