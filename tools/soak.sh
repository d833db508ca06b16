#!/usr/bin/env bash
# Drives the program by its own actions, over and over, and watches its memory: open, tune, play, scrub, ask, export,
# save, open again.
#   tools/soak.sh [SECONDS]     an hour, unless given; a line a round; exit code 1 when memory grows
# KNIT_BENCHMARK: the benchmark program, else build/dev/benchmark, which is built.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
seconds=${1:-3600}
if [ -z "${KNIT_BENCHMARK:-}" ]; then
  cmake --build "$root/build/dev" --target benchmark >/dev/null
  KNIT_BENCHMARK=$root/build/dev/benchmark
fi
exec "$KNIT_BENCHMARK" --soak "$seconds"
