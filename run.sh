#!/usr/bin/env bash
# Installs what is missing, builds, and runs knit-mesh with the arguments given.
# Without arguments it opens the thesis sphere. Without a display it works headless.
# ./run.sh --web serves it as a page on this machine; --web --single-file makes one HTML file of it.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

if [ "${1:-}" = --web ]; then
  [ "${2:-}" != --single-file ] || exec "$root/tools/web.sh" single
  exec "$root/tools/web.sh" serve "${2:-}"
fi

install_packages "${build_packages[@]}"
build dev knit-mesh
program=$root/build/dev/knit-mesh

has_display() {
  [ "$(uname -s)" != Linux ] || [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ]
}

if [ $# -eq 0 ] && has_display; then
  exec "$program" --example thesis-sphere
elif [ $# -eq 0 ]; then
  out=knit-mesh-output
  say "There is no display, so no window: knitting the thesis sphere into $out/ in the current folder."
  mkdir -p "$out"
  exec "$program" --example thesis-sphere --headless --save-mesh "$out/mesh.obj" --save-map "$out/map.txt" \
    --save-report "$out/report.json" --screenshot "$out/picture.png"
fi

if ! has_display; then
  headless=no # or nothing that needs a window was asked for
  for argument in "$@"; do
    case $argument in
      --headless | --headless=* | --help | -h | --version | --list-* | index | check) headless=yes ;;
    esac
  done
  if [ $headless = no ]; then
    say "There is no display, so no window: adding --headless."
    set -- --headless "$@"
  fi
fi
exec "$program" "$@"
