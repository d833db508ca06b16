#!/usr/bin/env bash
# Whether a page's runs and a native build's come to the same bits; tools/web.sh bits builds what it needs.
# Prints the runs, and what differs.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
assets=$root/build/dev/assets
# The script of emscripten 3.1.6 takes a newer Node for a browser where Node can fetch.
native=$("$root/build/dev/bits" "$assets")
page=$(node --no-experimental-fetch "$root/build/web/bits.js" "$assets")
printf '%s\n' "$native"
if [ "$native" = "$page" ]; then
  echo "The page comes to the same bits."
else
  echo "The page comes to other bits:"
  diff <(printf '%s\n' "$native") <(printf '%s\n' "$page")
fi
