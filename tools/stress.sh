#!/usr/bin/env bash
# Random runs over shapes that branch, under the sanitizers: tools/stress.sh [RUNS] [MESH.obj...]. docs/testing.md has more.
# In two of three the stitches settle, and the same run without that is held against it.
# Without meshes those of ../shared/meshes are taken, where they are there; bodies made in code come in any case.
# A run that fails is printed with the options that repeat it; the exit code is 1 then.
# KNIT_STRESS_SEED=N draws other runs than those of seed 1.
# KNIT_STRESS_PRESET=dev takes the program of that build instead, which is several times as fast.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

runs=${1:-500}
case $runs in '' | *[!0-9]* | 0)
  say "RUNS is a number of runs, not \"$runs\"."
  exit 2
  ;;
esac
shift $(($# > 0 ? 1 : 0))
meshes=("$@")
if [ ${#meshes[@]} -eq 0 ]; then
  for mesh in "$root"/../shared/meshes/*.obj; do
    [ -e "$mesh" ] && meshes+=("$mesh")
  done
fi

preset=${KNIT_STRESS_PRESET:-asan}
packages=("${build_packages[@]}")
[ "$preset" = asan ] && packages+=(clang-14 libclang-rt-14-dev llvm-14)
install_packages "${packages[@]}"
build "$preset" stress

ASAN_SYMBOLIZER_PATH=$(command -v llvm-symbolizer-14 || true)
# Short traces of allocations and little filling: several times as fast, and every fault is still found.
export ASAN_SYMBOLIZER_PATH UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=malloc_context_size=2:max_malloc_fill_size=64
exec "$root/build/$preset/stress" "$runs" --seed "${KNIT_STRESS_SEED:-1}" ${meshes[@]+"${meshes[@]}"}
