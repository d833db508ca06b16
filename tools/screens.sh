#!/usr/bin/env bash
# Takes pictures of the real window, screen by screen, to be looked at: what tools/pictures.sh cannot have, since it has no
# window: menus, dialogs, what is worked out beside, hands.
#   tools/screens.sh FOLDER [SCREEN...]     all screens, or those named, in both themes at 1280x720, 1920x1080 and 3840x2160
#                                           (scale 2): FOLDER/SCREEN-THEME-WIDTHxHEIGHT.png
#   tools/screens.sh --sheets FOLDER        what lies there on contact sheets, FOLDER/sheets/THEME-WIDTHxHEIGHT-N.png
#   tools/screens.sh --list                 the screens
# SIZES, THEMES: fewer of them, as SIZES="1280x720" THEMES="light". KNIT_MESH, KNIT_MESHES: as for tools/pictures.sh. Needs Xvfb,
# xdotool and ImageMagick; lessons as printed pages are taken where Chromium is.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=${KNIT_MESH:-$root/build/dev/knit-mesh}
meshes=${KNIT_MESHES:-$root/../shared/meshes}
sizes=${SIZES:-1280x720 1920x1080 3840x2160}
themes=${THEMES:-dark light}

# NAME | what the program is told | what hands do. Hands: a key as xdotool calls it; "word" types it; @X,Y clicks there and
# =X,Y points there, in units, below 0 from the right and from the foot; ~N waits N seconds.
screens() {
  cat <<'LIST'
first-start | | ~1
empty | --empty |
examples-menu | | @27,18 =60,66
row | --example thesis-sphere --at rows:14:13 --list candidates |
number-typed | --example thesis-sphere --at rows:14:13 | @203,350 "0.0" ~1
number-wrong | --example thesis-sphere --at rows:14:13 | @203,592 "9" Return ~1
curves | --example thesis-sphere --at rows:14 --sweep epsilon=0.005:0.095:96 | ~5 =700,400
go-to | --example thesis-sphere --at rows:14 | ctrl+g
go-to-typed | --example thesis-sphere --at rows:14 | ctrl+g "widest round"
why-menu | --example thesis-sphere --at rows:14 | @201,18
why-row | --example thesis-sphere --go-to "why row 7" |
rows | --example thesis-sphere --at rows:30:12 --list rows |
problems | --example thesis-sphere --epsilon 0.012 --at end --list problems |
breaks | --example thesis-sphere --break stall --epsilon 0.012 --list breaks |
cause | --example vase --at rows:22 |
report | --example thesis-sphere --at end --side report |
report-octopus | --example octopus --at end --side report |
stop | --example capsule --axis x --rows rings --at end | ~6
stop-end | --example torus --rows rings --at end --side pattern | ~2
found | MESHES/simple-elbow.obj |
refused | MESHES/teapot.obj |
refused-pieces | MESHES/suzanne.obj |
present | --example thesis-sphere --present --at rows:14:13 | =-300,300
present-lesson | --lesson what-it-does --lesson-page 4 --present |
beside | --example thesis-sphere --at rows:20 --beside stitch-width=0.12 |
compare | --example thesis-sphere --at end --beside stitch-width=0.12 --side compare |
sweep | --example thesis-sphere --at rows:14 --sweep epsilon=0.005:0.05:91 --side sweep | ~2
tubes | --example octopus --at rows:57 --side tubes |
split | --example torus --rows contours --at rows:13:3 --side tubes |
chart | --example vase --preset best-rows --centre chart --side pattern |
pattern | --example octopus --at end --side pattern |
knit-along | --example octopus --knit-along 12 --side pattern |
lesson | --lesson what-it-does --lesson-page 4 |
guess | --lesson picking-a-row --lesson-page 2 |
help | --example thesis-sphere | F1
palette | --example thesis-sphere --at rows:14 | ctrl+p "row"
yarn | --example thesis-sphere --settle on --relax on --show-as yarn --at end |
yarn-rows | MESHES/teddy.obj --preset best-rows --show-as yarn --at rows:40 |
glossary | --example thesis-sphere --at rows:14 | ctrl+p "glossary" Return
open | --example thesis-sphere | ctrl+o
figure-named | --example thesis-sphere | ctrl+p "save a picture" Return
figure | --example thesis-sphere --at end | @27,18 @66,468
animation | --example thesis-sphere --at rows:14 | @27,18 @66,489
worksheet | --lesson what-it-does --lesson-page 4 | ctrl+p "worksheet" Return
view-menu | --example thesis-sphere | @238,18
short-rows | --example heel --at end | =203,600
checker | check PATTERN --window --line 13 |
checker-next | check PATTERN --window | F4 F4
checker-typed | --example thesis-sphere | F7 ~1 @300,300 "CO 6 sts." Return "Rnd 1: Kfb around. (12 sts)" Return "Rnd 2: [K1, kfb] 6 times. (19 sts)"
LIST
}

# A mitten with a wrong count, and a word that is no stitch.
pattern() {
  cat <<'TEXT'
MITTEN
Materials: 50 g of worsted yarn, needles of 4 mm. Gauge: 22 sts and 32 rnds to 10 cm.
Cast on 28 (32, 36) sts. Join in the round, being careful not to twist.
Rnds 1-8: *K2, p2; rep from * to end. (28 (32, 36) sts)
Rnd 9: K13 (15, 17), m1, k2, m1, k to end. (30 (34, 38) sts)
Rnds 10-11: Knit.
Rnd 12: K13 (15, 17), m1, k4, m1, k to end. (32 (36, 40) sts)
Rnd 13: K13 (15, 17), place next 6 sts on a holder for thumb, CO 2 sts, k to end. (28 (32, 36) sts)
Rnds 14-20: Knit.
Rnd 21: *K2, k2tog; rep from * to end. (21 (24, 27) sts)
Rnd 22: Knit.
Rnd 23: *K1, k2tog; rep from * to end. (14 (16, 18) sts)
Rnd 24: [K2tog] 7 (8, 9) times. (8 (8, 9) sts)
Break yarn, thread through remaining sts.

THUMB
Place the 6 held sts of the thumb on the needles. Pick up and knit 2 sts in the gap. (8 sts)
Rnds 1-5: Knit.
Rnd 6: [K2tog] 3 times, k2tig.
Rnd 7: Knit.
Break yarn, thread through remaining 4 sts.
TEXT
}

need() {
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || {
      echo "screens: $tool is missing" >&2
      exit 1
    }
  done
}

case ${1:-} in
  --list)
    screens | cut -d' ' -f1
    echo worksheet-printed
    exit 0
    ;;
  --sheets)
    need montage
    folder=${2:?give the folder of the pictures}
    rm -rf "$folder/sheets"
    mkdir -p "$folder/sheets"
    for theme in $themes; do
      for size in $sizes; do
        pictures=()
        for name in $(screens | cut -d' ' -f1); do
          [ ! -f "$folder/$name-$theme-$size.png" ] || pictures+=("$folder/$name-$theme-$size.png")
        done
        [ ${#pictures[@]} = 0 ] || montage -label '%t' "${pictures[@]}" -tile 2x2 -geometry 960x540+6+4 \
          "$folder/sheets/$theme-$size.png"
      done
    done
    exit 0
    ;;
esac

need Xvfb xdotool import
folder=${1:?give a folder to write into}
shift
wanted=" $* "
mkdir -p "$folder"
aside=$(mktemp -d)
server= pid=
end() {
  [ -z "$pid" ] || kill -KILL "$pid" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  rm -rf "$aside"
}
trap end EXIT
pattern >"$aside/mitten.txt"

await() { # tries COMMAND...: a tenth of a second each
  local tries=$1
  shift
  for _ in $(seq "$tries"); do
    ! "$@" || return 0
    sleep 0.1
  done
  return 1
}
# The head of the screen is not black any more: on a busy machine a window stands there long before its first frame. The pointer
# waits at the foot.
is_drawn() {
  [ "$(tail -c $((wide * high * 4)) "$aside/Xvfb_screen0" | head -c $((wide * 80)) | tr -d '\0' | head -c 1 | wc -c)" = 1 ]
}
is_displayed() { [ -s "$aside/display" ]; }
has_window() { window=$(xdotool search --onlyvisible --name '(^| - )knit-mesh$' 2>/dev/null | head -n 1) && [ -n "$window" ]; }
has_no_window() { ! has_window; }
has_keyboard() {
  xdotool windowfocus "$window" 2>/dev/null || true
  [ "$(xdotool getwindowfocus 2>/dev/null)" = "$window" ]
}
# The screen is a moment later as it was.
rests() {
  cp "$aside/Xvfb_screen0" "$aside/before"
  sleep 0.5
  cmp -s "$aside/Xvfb_screen0" "$aside/before"
}

rests_long() { rests && rests; }

hand() { # what
  local x y
  case $1 in
    '"'*) xdotool type --delay 12 "${1//\"/}" ;;
    '~'*) sleep "${1#\~}" ;;
    [@=]*)
      IFS=, read -r x y <<<"${1:1}"
      x=$((x * scale)) y=$((y * scale))
      [ $x -ge 0 ] || x=$((x + wide))
      [ $y -ge 0 ] || y=$((y + high))
      xdotool mousemove --window "$window" "$x" "$y"
      sleep 0.2
      [ "${1:0:1}" = = ] || xdotool click 1
      sleep 0.5
      ;;
    *) xdotool key --delay 12 "${1/Ctrl/ctrl}" ;;
  esac
}

take() { # name, options, hands, theme
  local file=$folder/$1-$4-${wide}x$high.png options=() deeds=()
  local asked=${2//MESHES/$meshes}
  mapfile -t options < <(xargs -n 1 <<<"${asked//PATTERN/$aside/mitten.txt}")
  mapfile -t deeds < <(grep -oE '"[^"]*"|[^ ]+' <<<"$3" || true)
  rm -rf "$aside/state" "$aside/config"
  xdotool mousemove $((wide - 3)) $((high - 3))
  [ -n "${options[0]}" ] || options=()
  XDG_STATE_HOME=$aside/state XDG_CONFIG_HOME=$aside/config "$program" "${options[@]}" --theme "$4" --scale "$scale" \
    --size "${wide}x$high" 2>"$aside/errors" &
  pid=$!
  if await 300 has_window && await 100 has_keyboard && await 300 is_drawn; then
    await 20 rests_long || true
    local deed
    for deed in "${deeds[@]}"; do hand "$deed"; done
    await 20 rests || echo "screens: $1 does not come to rest" >&2
    import -window root "$file"
  else
    echo "screens: no window for $1: $(cat "$aside/errors")" >&2
  fi
  kill -KILL "$pid" 2>/dev/null || true
  wait "$pid" 2>/dev/null || true
  pid=
  await 100 has_no_window || true  # or the next would take this one's for its own
}

# A lesson as a printed page: no window and no theme, so once.
take_printed() { # name, lesson
  local browser
  browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
  [ -n "$browser" ] || return 0
  "$program" --headless --lesson "$2" --save-worksheet "$aside/$1.html"
  "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$aside/browser" --window-size=820,4000 \
    --screenshot="$folder/$1.png" "file://$aside/$1.html" >/dev/null 2>&1 || echo "screens: no picture of $1" >&2
}
printed=worksheet-printed
if [ "$wanted" = "  " ] || [[ $wanted = *" $printed "* ]]; then take_printed "$printed" what-it-does; fi

for size in $sizes; do
  wide=${size%x*} high=${size#*x} scale=1
  [ "$wide" -lt 3000 ] || scale=2
  : >"$aside/display"
  Xvfb -displayfd 7 -noreset -screen 0 "${size}x24" -nolisten tcp -fbdir "$aside" 7>"$aside/display" 2>/dev/null &
  server=$!
  await 300 is_displayed
  DISPLAY=:$(cat "$aside/display")
  export DISPLAY
  while IFS='|' read -r name options hands; do
    name=${name// /}
    [ "$wanted" = "  " ] || [[ $wanted = *" $name "* ]] || continue
    for theme in $themes; do take "$name" "$options" "$hands" "$theme" </dev/null; done
  done < <(screens)
  kill "$server"
  server=
done
