#!/usr/bin/env bash
# Builds the fuzz targets and runs them: tools/fuzz.sh [TARGET|all] [RUNS]. docs/testing.md has more.
# What it finds worth keeping grows in build/fuzz/corpus; an input that breaks something lies in build/fuzz/found.
# KNIT_FUZZ_SEED=N makes a run that can be had again; without it each is another.
# KNIT_FUZZ_PRESET=asan takes the programs of that build instead, which are slower and in CI there already.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"

targets=(obj pattern session lesson pipeline)
wanted=${1:-all}
runs=${2:-100000}
if [ "$wanted" != all ]; then
  [ -e "tests/fuzz/fuzz_$wanted.cpp" ] || {
    say "There is no fuzz target \"$wanted\"; give one of ${targets[*]}, or all."
    exit 2
  }
  targets=("$wanted")
fi
case $runs in '' | *[!0-9]*)
  say "RUNS is a number of executions for each target, not \"$runs\"."
  exit 2
  ;;
esac

install_packages "${build_packages[@]}" clang-14 libclang-rt-14-dev llvm-14
# Watching what is compared teaches short texts, and makes a run several times as slow: not for numbers, nor where
# most of a run is writing.
declare -A preset=([pipeline]=${KNIT_FUZZ_PRESET:-fuzz-fast} [pattern]=${KNIT_FUZZ_PRESET:-fuzz-fast})
for target in "${targets[@]}"; do
  preset[$target]=${preset[$target]:-${KNIT_FUZZ_PRESET:-fuzz}}
  build "${preset[$target]}" "fuzz_$target"
done

# Longer inputs are slower and find no more: what repeats, repeats early.
declare -A longest=([obj]=600 [pattern]=600 [session]=3000 [lesson]=3000 [pipeline]=240)
ASAN_SYMBOLIZER_PATH=$(command -v llvm-symbolizer-14 || true)
# Short traces of allocations, a small quarantine, little filling: several times as fast, and every fault is still found.
export ASAN_SYMBOLIZER_PATH UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=malloc_context_size=0:quarantine_size_mb=4:max_malloc_fill_size=64

for target in "${targets[@]}"; do
  grown=build/fuzz/corpus/$target
  mkdir -p "$grown" build/fuzz/found
  dictionary=()
  [ -e "tests/fuzz/dictionary/$target" ] && dictionary=("-dict=tests/fuzz/dictionary/$target")
  # A run of the pipeline is work for a tenth of a second and more, so a fortieth as many are asked of it.
  asked=$runs
  [ "$target" = pipeline ] && asked=$((runs / 40))
  say "== fuzz_$target: $asked executions"
  "build/${preset[$target]}/fuzz_$target" "$grown" "tests/fuzz/corpus/$target" "${dictionary[@]}" \
    -runs="$asked" -seed="${KNIT_FUZZ_SEED:-0}" -max_len="${longest[$target]}" -timeout=60 -rss_limit_mb=2048 -detect_leaks=0 -entropic=0 \
    -artifact_prefix="build/fuzz/found/$target-" -print_final_stats=1 -verbosity=0 -print_funcs=0
done
say "Nothing found."
