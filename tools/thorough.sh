#!/usr/bin/env bash
# What .ci/run does in part, done in full: long monkeys, and every repetition of every test under the sanitizers.
# Takes an hour or more. Worth it after changes to actions, timelines, readers or the pipeline.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

build dev
cd "$root"
KNIT_MONKEY_ACTIONS=10000 build/dev/knit_tests "a monkey*"
build asan
ASAN_SYMBOLIZER_PATH=$(command -v llvm-symbolizer-14) KNIT_WHOLE=1 KNIT_MONKEY_ACTIONS=700 \
  ctest --preset asan --parallel "$(nproc 2>/dev/null || echo 2)" "$@"
