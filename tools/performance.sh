#!/usr/bin/env bash
# Measures all that docs/performance.md says, in one run, and writes it there: some minutes.
#   tools/performance.sh [SUITE.json]     where the figures go as JSON, else build/performance.json
# KNIT_BENCHMARK: the benchmark program, else build/dev/benchmark, which is built.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
suite=${1:-$root/build/performance.json}
if [ -z "${KNIT_BENCHMARK:-}" ]; then
  cmake --build "$root/build/dev" --target benchmark >/dev/null
  KNIT_BENCHMARK=$root/build/dev/benchmark
fi
mesh=$root/../shared/meshes/teddy.obj # where it lies; else a body made in code
[ -e "$mesh" ] || mesh=
"$KNIT_BENCHMARK" --suite ${mesh:+"$mesh"} >"$suite.part"
mv "$suite.part" "$suite"
"$KNIT_BENCHMARK" --table "$suite" "$root/docs/performance.md"
echo "Measured: $suite; written into docs/performance.md"
