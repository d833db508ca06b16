#!/usr/bin/env bash
# What the program says, and what it leaves behind, when the disk, the graphics driver or somebody with kill is
# against it. Prints what failed.
set -euo pipefail

program=$(realpath "${KNIT_MESH:?the path of the program}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY XAUTHORITY
export XDG_STATE_HOME=$folder/state XDG_CONFIG_HOME=$folder/config
mkdir "$folder/work"
cd "$folder/work"

failures=0
fail() {
  failures=$((failures + 1))
  printf 'FAILED: %s\n  standard error:\n' "$*"
  sed 's/^/    /' ../err 2>/dev/null || true
}
# run CODE ARGUMENTS...: what it says is in ../err.
run() {
  local wanted=$1 code=0
  shift
  timeout 120 "$program" "$@" >../out 2>../err || code=$?
  [ "$code" = "$wanted" ] || fail "exit code $code, not $wanted: knit-mesh $*"
  ! grep -qv '^knit-mesh: ' ../err || fail "not every message is a line of ours: knit-mesh $*"
}
says() { grep -qi -- "$1" ../err || fail "standard error does not say \"$1\""; }
only() { [ "$(ls | xargs)" = "$*" ] || fail "here lie \"$(ls | xargs)\", not \"$*\""; }
is_old() { [ "$(tr -d '\0' <"$1" | head -c 11)" = 'the old one' ]; }
sphere=(--example sphere --headless)

# --- a full disk: no file may grow beyond 4 KB, and that is an error, no signal ----------------------------
full() (
  trap '' XFSZ
  ulimit -f 4
  run "$@"
  exit "$failures"
)
for file in report.json mesh.obj ball.json ball.html picture.png film.gif mesh.glb; do
  case $file in
    report.json) option=--save-report ;;
    mesh.obj) option=--save-mesh ;;
    ball.json) option=--save-session ;;
    ball.html) option=--save-pattern ;;
    picture.png) option=--save-picture ;;
    film.gif) option='--frames=3 --save-animation' ;;
    mesh.glb) option=--save-gltf ;;
  esac
  printf 'the old one' >"$file"
  # A session is small: there is room for it.
  wanted=2
  [ "$file" = ball.json ] && wanted=0
  # shellcheck disable=SC2086
  full "$wanted" "${sphere[@]}" --at end $option "$file" || failures=$((failures + 1))
  only "$file"
  if [ "$wanted" = 2 ]; then
    says 'cannot write'
    says "$file"
    is_old "$file" || fail "the old $file is gone"
  fi
  rm -f "$file"
done
full 2 "${sphere[@]}" --frames 3 --save-animation frames || failures=$((failures + 1))
says 'cannot write frames/frame_0001.png'
only

# --- killed in the middle of an animation ------------------------------------------------------------------
# killed_while NAME: ends the program as soon as something of NAME lies aside.
killed_while() {
  "$program" "${sphere[@]}" --frames 2000 --size 320x240 --save-animation "$1" >../out 2>../err &
  local pid=$! waited=0
  until ls "$1".part-* >/dev/null 2>&1; do
    sleep 0.05
    waited=$((waited + 1))
    [ "$waited" -lt 1200 ] || { fail "nothing is written aside of $1"; break; }
  done
  sleep 0.3
  kill -KILL "$pid"
  wait "$pid" 2>/dev/null || true
  ls "$1".part-* >/dev/null 2>&1 || fail "$1 was done before it could be killed"
}
for film in film.gif film.png; do
  printf 'the old one' >"$film"
  killed_while "$film"
  is_old "$film" || fail "the old $film is gone"
  run 0 "${sphere[@]}" --frames 2 --size 320x240 --save-animation "$film"
  only "$film"
  ! is_old "$film" || fail "the new $film is not there"
  rm -f "$film"
done
mkdir frames
printf 'the old one' >frames/frame_0001.png
killed_while frames
is_old frames/frame_0001.png || fail 'the old picture is gone'
run 0 "${sphere[@]}" --frames 2 --size 320x240 --save-animation frames
only frames
rm -rf frames

# --- a folder that cannot be written -----------------------------------------------------------------------
if [ "$(id -u)" = 0 ]; then
  locked=/proc/self # nobody makes files there, not even root
else
  mkdir locked && chmod 555 locked && locked=locked
fi
for name in report.json mesh.obj picture.png film.gif; do
  case $name in
    report.json) option=--save-report ;;
    mesh.obj) option=--save-mesh ;;
    picture.png) option=--save-picture ;;
    film.gif) option='--frames=2 --save-animation' ;;
  esac
  # shellcheck disable=SC2086
  run 2 "${sphere[@]}" --at rows:3 $option "$locked/$name"
  says "cannot write.*$name"
done
[ -d locked ] && rmdir locked

# --- graphics that are not there: everything but pictures goes on -------------------------------------------
picture=(--example sphere --headless --at rows:3 --size 320x240 --save-report report.json --screenshot picture.png)
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
if env -u EGL_PLATFORM "$program" "${picture[@]}" >../out 2>../err && [ -s picture.png ]; then
  rm -f picture.png report.json
  MESA_GL_VERSION_OVERRIDE=2.1 run 2 "${picture[@]}"
  says 'OpenGL 3.3'
  only report.json
  rm -f report.json
  __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null run 2 "${picture[@]}"
  says 'graphics driver'
  only report.json
  rm -f report.json
else
  echo 'skipped: no software graphics here'
fi

# --- no font ------------------------------------------------------------------------------------------------
mkdir bare
cp "$program" bare/knit-mesh
cp -r "$(dirname "$program")/assets" bare/assets
rm -rf bare/assets/fonts
program=$PWD/bare/knit-mesh
run 0 --example sphere --headless --at rows:3 --size 320x240 --screenshot picture.png
[ -s picture.png ] || fail 'no picture without a font'

printf '%s failed\n' "$failures"
[ "$failures" = 0 ]
