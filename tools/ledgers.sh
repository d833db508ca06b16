#!/usr/bin/env bash
# Every file by itself and clang-tidy, but for what tools/clean knows as clean; writes there what is found clean.
# tools/ledgers.sh [--check]    --check, as in CI: writes nothing
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

record=--record
[ "${1:-}" = --check ] && record=
need clang++-14 clang-tidy-14
cd "$root"
cmake --preset asan -B build/plain -DKNIT_UNITY=OFF -DKNIT_PRECOMPILE=OFF -DKNIT_JOIN_TESTS=1 -DKNIT_FUZZ=OFF \
  -DKNIT_SANITIZE=OFF >&2
cmake --build build/plain --target knit_glad >&2 # the one header that is made
failed=0
tools/each_file.py $record build/plain || failed=1
tools/tidy.py $record build/plain || failed=1
exit $failed
