#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Arguments go to ctest: ./test.sh -R thesis
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

install_packages "${build_packages[@]}" "${test_packages[@]}"
build dev
cd "$root"
exec ctest --preset dev --parallel "$(nproc 2>/dev/null || echo 2)" "$@"
