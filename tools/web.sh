#!/usr/bin/env bash
# The program as a page (docs/browser.md).
#
#   tools/web.sh build           into build/web/page/: knit-mesh.html as index.html, with what it fetches
#   tools/web.sh single          the same as one file, build/web/knit-mesh.html, which opens by a double click
#   tools/web.sh serve [PORT]    serves build/web/page/ on this machine and prints the address (8000)
#   tools/web.sh bits            whether six runs give the same bits here and there
#   tools/web.sh times           how long reading and six runs take here and there, under Node
#   tools/web.sh sizes           bytes that a page fetches: as they are, by gzip, by brotli
#   tools/web.sh test            bits, and drives headless Chromium through the page; keeps in tools/clean that all held
#   tools/web.sh check           the same, as in CI: nothing where tools/clean knows these files, and writes nothing
#
# Needs Debian's emscripten; what is missing is installed. Dear ImGui has no package for it, so its source is fetched.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

web_packages=(emscripten nodejs fonttools)
web_test_packages=(chromium)
out=$root/build/web
page=$out/page
ledger=$root/tools/clean/page.txt

# Debian's own source package, by lists of our own beside the system's.
fetch_imgui() {
  [ -e "$out/imgui/imgui.cpp" ] && return 0
  local lists=$out/apt place
  mkdir -p "$lists/lists/partial" "$lists/sources" "$out/imgui"
  for place in /etc/apt/sources.list.d/*.sources; do
    [ -e "$place" ] && grep -q 'debian\.org' "$place" &&
      sed 's/^Types: deb$/Types: deb-src/' "$place" >"$lists/sources/$(basename "$place")"
  done
  if [ -e /etc/apt/sources.list ]; then
    sed -n 's/^deb \(.*debian\.org.*\)/deb-src \1/p' /etc/apt/sources.list >"$lists/sources/system.list"
  fi
  local apt=(apt-get -q -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$lists/sources"
    -o "Dir::State::lists=$lists/lists" -o APT::Sandbox::User=root)
  (cd "$lists" && "${apt[@]}" update >&2 && "${apt[@]}" source --download-only imgui >&2)
  tar xf "$lists"/imgui_*.orig.tar.* -C "$out/imgui" --strip-components=1
}

# What is packed into the page. Fonts are cut down to what the program asks of them (glyph_ranges in
# app/panels/kit/imgui_glue.cpp), a fifth of them.
gather_assets() {
  local assets=$out/assets.new font
  rm -rf "$assets"
  cp -r "$root/build/dev/assets" "$assets"
  for font in "$assets"/fonts/*; do
    pyftsubset "$font" --unicodes=20-ff,370-3ff,2010-2027,2030-203a,2190-21ff,2200-22ff,25a0-25ff --layout-features= \
      --no-recalc-timestamp --output-file="$font.cut"
    mv "$font.cut" "$font"
  done
  diff -rq "$assets" "$out/assets" >/dev/null 2>&1 && return 0
  rm -rf "$out/assets" "$out/knit-mesh.js" # so that it is packed anew
  mv "$assets" "$out/assets"
}

# Meshes are made natively: sines of another C library differ in their last bits.
build_page() {
  install_packages "${build_packages[@]}" "${web_packages[@]}"
  need cmake ninja emcc node pyftsubset
  build dev assets
  fetch_imgui
  gather_assets
  export NODE_PATH=/usr/share/nodejs
  (cd "$root" && cmake --preset web "-DKNIT_IMGUI_SOURCE=$out/imgui" "-DKNIT_WEB_ASSETS=$out/assets" >&2)
  cmake --build "$out" --target knit-mesh >&2
  mkdir -p "$page"
  cp "$out/page.html" "$page/index.html"
  cp "$out/page.js" "$out/knit-mesh.js" "$out/knit-mesh.wasm" "$out/knit-mesh.data" "$page/"
}

serve_page() {
  node "$root/tools/serve_page.mjs" "$page" "${1:-8000}"
}

# Of all that the page and its tests are made of.
digest() {
  (cd "$root" && find CMakeLists.txt CMakePresets.json cmake third_party knit app assets shaders tests/web tests/bits \
    tools/setup.sh tools/web.sh tools/serve_page.mjs tools/single_page.mjs -type f -print0 |
    LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum | cut -d' ' -f1)
}

print_times() {
  build dev bits
  cmake --build "$out" --target bits >&2
  echo "here:"
  "$root/build/dev/bits" "$root/build/dev/assets" 9
  echo "there:"
  node --no-experimental-fetch "$out/bits.js" "$root/build/dev/assets" 9
}

compare_bits() {
  build dev bits
  cmake --build "$out" --target bits >&2
  "$root/tests/bits/compare.sh"
}

test_page() {
  build_page
  compare_bits
  node "$root/tools/single_page.mjs" "$page" "$out/knit-mesh.html"
  install_packages "${web_test_packages[@]}"
  build dev knit-mesh
  node "$root/tests/web/page_test.mjs" "$page" "$out/knit-mesh.html" "$root/build/dev/knit-mesh"
}

case ${1:-} in
  build) build_page ;;
  single)
    build_page
    node "$root/tools/single_page.mjs" "$page" "$out/knit-mesh.html"
    say "One file: $out/knit-mesh.html"
    ;;
  serve)
    build_page
    serve_page "${2:-}"
    ;;
  bits)
    build_page
    compare_bits
    ;;
  times)
    build_page
    print_times
    ;;
  sizes)
    build_page
    install_packages brotli
    for file in "$page"/{index.html,page.js,knit-mesh.js,knit-mesh.wasm,knit-mesh.data}; do
      echo "$(basename "$file") $(stat -c %s "$file") $(gzip -9 -c "$file" | wc -c) $(brotli -q 11 -c "$file" | wc -c)"
    done | awk '{ print; for (i = 2; i <= 4; ++i) sum[i] += $i } END { print "all", sum[2], sum[3], sum[4] }'
    ;;
  test)
    test_page
    echo "page $(digest)" >"$ledger"
    ;;
  check)
    if grep -qs "^page $(digest)$" "$ledger"; then
      say "The page was tested as it is."
    else
      test_page
    fi
    ;;
  *)
    sed -n '2,13s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac
