# Sourced by run.sh, test.sh and .ci/run: installs what is missing, configures, builds.
# All chatter goes to stderr, so that a report on stdout can be piped.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The lists are used by the scripts that source this file.
# shellcheck disable=SC2034
build_packages=(
  g++ cmake ninja-build pkg-config
  libglm-dev libeigen3-dev libtinyobjloader-dev nlohmann-json3-dev libcli11-dev
  libimgui-dev libglfw3-dev libstb-dev python3-glad libegl-dev libopengl-dev libgif-dev catch2
  libgl1-mesa-dri fonts-inter fonts-jetbrains-mono
)
# shellcheck disable=SC2034
test_packages=(xvfb xauth xdotool)

packages_changed=no

say() { printf '%s\n' "$*" >&2; }

missing_packages() {
  local installed
  # dpkg-query fails when it does not know a name, which is an answer too.
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
  for package in "$@"; do
    grep -qxF "installed $package" <<<"$installed" || printf '%s\n' "$package"
  done
}

install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    if ! [ -e "$root/build/dev/build.ninja" ]; then
      say "This is no Debian system. Needed are the equivalents of these Debian packages:"
      say "  $*"
      say "Libraries that are missing are fetched from their own sites."
    fi
    return 0
  fi
  local missing become_root=()
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "Packages are missing, and there is no sudo to install them with. As root, run:"
      say "  apt-get install --no-install-recommends ${missing[*]}"
      return 0
    fi
    become_root=(sudo)
  fi
  say "Installing: ${missing[*]}"
  local apt=("${become_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120)
  # One unreachable list out of many must not stop us.
  "${apt[@]}" update >&2 || say "apt-get update failed; trying with the lists that are there."
  packages_changed=yes
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >&2 ||
    say "Some packages could not be installed; going on without them."
}

need() {
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || {
      say "The command $tool is needed and was not found."
      exit 1
    }
  done
}

# build <preset> [target...]
build() {
  local preset=$1 folder=$root/build/$1 fresh=()
  shift
  need cmake ninja
  if [ -e "$folder/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    fresh=(--fresh) # the tree was moved or copied
  fi
  if [ ! -e "$folder/build.ninja" ] || [ ${#fresh[@]} -ne 0 ] || [ $packages_changed = yes ] ||
    [ "$root/CMakePresets.json" -nt "$folder/build.ninja" ]; then
    (cd "$root" && cmake --preset "$preset" ${fresh[@]+"${fresh[@]}"} >&2)
  fi
  cmake --build "$folder" ${1:+--target "$@"} >&2
}
