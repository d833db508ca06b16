#!/usr/bin/env bash
# --break on the command line: which step is shown, what is said, the exit code. Prints what failed.
set -euo pipefail

program=$(realpath "${KNIT_MESH:?the path of the program}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY XAUTHORITY
cd "$folder"

failures=0
# expect CODE WORDS ARGUMENTS...: the exit code, and words on standard error.
expect() {
  local wanted=$1 words=$2 code=0
  shift 2
  timeout 120 "$program" --headless "$@" >out 2>err || code=$?
  if [ "$code" = "$wanted" ] && [ ! -s out ] && grep -qF -- "$words" err; then return; fi
  failures=$((failures + 1))
  printf 'FAILED: knit-mesh --headless %s\n  exit code %s, not %s, or without "%s":\n' "$*" "$code" "$wanted" "$words"
  sed 's/^/    /' err
}

expect 0 "knit-mesh: break row=14: Row 14" --break row=14
expect 0 "knit-mesh: break grows>4: Row 2" --break 'row=14' --break 'grows>4'
expect 0 "knit-mesh: break gap: Row 14 closes" --at rows:14 --break gap
expect 0 "knit-mesh: break row=14: Row 14" --at rows:14:1 --break row=14 # it holds there
expect 4 "no break condition holds" --break row=4000
expect 4 "no break condition holds" --at end --break row=14
expect 1 "no break condition holds" --example torus --rows rings --break row=4000
expect 1 "knit-mesh: break stall: " --epsilon 0.001 --on-stall stop --break stall
expect 2 "is no break condition" --break roe=14
expect 2 "a whole number from 1" --break row=0

expect 0 "break stage=faces" --break stage=faces --save-steps steps
tail -n 1 steps | grep -q '"stage": *"faces"' || {
  failures=$((failures + 1))
  echo "FAILED: what is saved does not end at the break"
}
[ "$failures" = 0 ] || exit 1
echo "breaks_cli_test: all as expected"
