#!/usr/bin/env bash
# Which lines of knit/*.cpp the tests meet: builds, runs every test, prints the table; fails below 95 %.
# Arguments go to ctest: tools/coverage.sh -R pattern
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
cd "$root"

install_packages "${build_packages[@]}" "${test_packages[@]}" gcovr
need gcovr
build coverage
find build/coverage -name '*.gcda' -delete
# A test that fails has met its lines too; ./test.sh is where it must pass. Where no file may grow, as in one test,
# the counts would be cut off as well.
ctest --test-dir build/coverage --parallel "$(nproc 2>/dev/null || echo 2)" --exclude-regex '^faults_test$' "$@" >&2 ||
  say "Some tests failed; the table counts what they met."
# Headers are compiled into whoever includes them, so that counting them in knit/ alone says nothing.
gcovr --root "$root" --filter 'knit/.*\.cpp' --txt build/coverage/coverage.txt \
  --html-details build/coverage/coverage.html --fail-under-line 95 build/coverage/CMakeFiles/knit.dir >&2 && code=0 || code=$?
cat build/coverage/coverage.txt
exit "$code"
