// The real window on a virtual screen: keys and clicks from outside, judged by what it leaves behind.
//
// Nothing here waits a fixed time (but keys have some milliseconds between them: GLFW takes two presses of a
// key in the same one for the same). Keys are queued by the X server in order, and the program is closed by a
// key, too, so that a slow machine only takes longer.
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/files/report.h"
#include "app/panels/parameters/parameters.h"
#include "app/scene/palette.h"
#include "app/script/command_line.h"
#include "app/session/document.h"
#include "app/session/program.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"
#include "tests/support/hands.h"
#include "tests/support/session.h"

// The system's library may hold the same names.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

using namespace app;
using Json = nlohmann::json;
using test_support::Folder;
using test_support::read_text;

namespace {

constexpr int width = 1200;
constexpr int height = 760;

bool have(const std::string& command) {
  return std::system(("command -v " + command + " >/dev/null 2>&1").c_str()) == 0;
}

bool can_run() {
  for (const char* command : {"Xvfb", "xdotool", "timeout"}) {
    if (have(command)) continue;
    WARN("the real window is not tested: " << command << " is missing");
    return false;
  }
  return true;
}

// `start ARGUMENTS...` opens the window and waits until it has the keyboard, as await_window does. `at_once COMMANDS...` lets xdotool
// do all of it while the program sleeps, as if one frame had taken that long. `close` ends it by Ctrl+Q.
const char* const script_head = R"sh(
set -euo pipefail
program=$1
losing_driver=$3
cd "$2"
# The server itself takes a free display, so that several tests may run at once; without -noreset it would be away
# for a moment whenever its last window closes. What an earlier script in this folder was told is taken away first.
rm -f display
Xvfb -displayfd 7 -noreset -screen 0 "${screen:-1280x800}x24" -nolisten tcp 7>display 2>/dev/null &
server=$!
trap 'kill $server 2>/dev/null || true' EXIT
for _ in $(seq 300); do
  [ ! -s display ] || break
  sleep 0.1
done
export DISPLAY=:$(cat display)
export XDG_STATE_HOME=$PWD/state XDG_CONFIG_HOME=$PWD/config  # never the person's own
fail() {
  echo "window test: $1"
  [ -z "${pid:-}" ] || kill -KILL "$pid" 2>/dev/null || true
  exit 1
}
start() {
  "$program" --size "${size:-1200x760}" "$@" 2>errors &
  pid=$!
  await_window
}
await_window() {
  window=
  for _ in $(seq 150); do
    kill -0 $pid 2>/dev/null || fail "the program ended early: $(cat errors)"
    window=$(xdotool search --onlyvisible --name '(^| - )knit-mesh$' 2>/dev/null | head -n 1) || true
    [ -z "$window" ] || break
    sleep 0.1
  done
  [ -n "$window" ] || fail "no window came"
  for _ in $(seq 100); do
    xdotool windowfocus "$window" 2>/dev/null || true
    [ "$(xdotool getwindowfocus 2>/dev/null)" != "$window" ] || return 0
    sleep 0.1
  done
  fail "the window does not take the keyboard"
}
at_once() {
  kill -STOP $pid
  xdotool "$@"
  kill -CONT $pid
}
# await WORDS COMMAND...: until it holds; fails with the words when it never does.
await() {
  local words=$1
  shift
  for _ in $(seq 300); do
    ! "$@" || return 0
    sleep 0.1
  done
  fail "$words"
}
saved_aside() { ls state/knit-mesh/*.json >/dev/null 2>&1; }
close() {
  xdotool key ctrl+q
  for _ in $(seq 250); do
    kill -0 $pid 2>/dev/null || break
    sleep 0.1
  done
  ! kill -0 $pid 2>/dev/null || fail "Ctrl+Q does not close the window"
  code=0
  wait $pid || code=$?
  pid=
  [ $code = 0 ] || fail "exit code $code: $(cat errors)"
}
)sh";

// Runs a script on a virtual screen, in the folder. Nothing, or what went wrong.
std::string run_on_screen(const Folder& folder, const std::string& script, const std::string& sizes = "") {
  test_support::write_text(folder.path() / "script", sizes + "\n" + script_head + script);
  const std::string in = folder.path().string();
  const std::string command = "timeout -k 5 100 bash '" + in + "/script' '" + KNIT_MESH_BINARY + "' '" + in +
                              "' '" + KNIT_LOSING_DRIVER + "' >'" + in + "/log' 2>&1";
  if (std::system(command.c_str()) == 0) return "";
  const std::string log = read_text(folder.path() / "log");
  return log.empty() ? "the virtual screen did not work" : log;
}

std::size_t steps_in(const Folder& folder, const std::string& report) {
  const Json json = Json::parse(read_text(folder.path() / report), nullptr, false);
  CAPTURE(report);
  REQUIRE(json.is_object());
  return json["steps"];
}

struct Picture {
  int width = 0, height = 0;
  std::vector<Colour> pixels;  // top row first
  [[nodiscard]] const Colour& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Picture read_picture(const Folder& folder, const std::string& name) {
  Picture picture;
  int channels = 0;
  unsigned char* data =
      stbi_load((folder.path() / name).string().c_str(), &picture.width, &picture.height, &channels, 4);
  CAPTURE(name);
  REQUIRE(data != nullptr);
  const auto count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  for (std::size_t i = 0; i < count; ++i) {
    picture.pixels.push_back({data[4 * i], data[4 * i + 1], data[4 * i + 2], data[4 * i + 3]});
  }
  stbi_image_free(data);
  return picture;
}

// Pixels in the window's middle, where the scene is, that pass a test.
template <class Test>
int count_in_view(const Picture& picture, Test test) {
  const Box view = layout_of(width, height, 1.0f).view;
  int count = 0;
  for (int y = static_cast<int>(view.y); y < static_cast<int>(view.bottom()); ++y) {
    for (int x = static_cast<int>(view.x); x < static_cast<int>(view.right()); ++x)
      count += test(picture.at(x, y)) ? 1 : 0;
  }
  return count;
}

// Of the same hue, lit more or less.
bool looks_like(const Colour& seen, const Colour& wanted) {
  const double a = std::hypot(seen.r, seen.g, seen.b);
  const double b = std::hypot(wanted.r, wanted.g, wanted.b);
  const double along = seen.r * wanted.r + seen.g * wanted.g + seen.b * wanted.b;
  return a > 60.0 && along > 0.996 * a * b;
}

std::size_t steps_of_whole_run() {
  Session session = test_support::example_session("thesis-sphere");
  apply(session, ToLast{});
  return session.document->timeline.known();
}

// "x y" of the middle of a control, for xdotool.
std::string middle_of(const std::string& control) {
  desk::Desk desk(width, height);
  desk.open();
  const MouseMove middle = desk.over(control);
  return std::to_string(std::lround(middle.x)) + " " + std::to_string(std::lround(middle.y));
}

// A desk with what the program would open.
void open_as(desk::Desk& desk, const Folder& folder, const std::string& options) {
  std::istringstream in(options);
  std::vector<std::string> words{std::istream_iterator<std::string>(in), {}};
  words.front() = (folder.path() / words.front()).string();
  const auto line = parse_command_line(words, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(line));
  REQUIRE_FALSE(open_as_asked(desk.session, std::get<CommandLine>(line)));
  desk.settle();
}

std::string place_of(const desk::Desk& desk, const std::string& control) {
  const MouseMove middle = desk.over(control);
  return std::to_string(std::lround(middle.x)) + " " + std::to_string(std::lround(middle.y));
}

// As xdotool calls them, a blank before each.
std::string keys_of_text(const std::string& text) {
  std::string keys;
  for (const char c : text) keys += c == '.' ? " period" : c == '-' ? " minus" : " " + std::string(1, c);
  return keys;
}

}  // namespace

TEST_CASE("the real window opens, plays, seeks to the end and shows the knit mesh") {
  if (!can_run()) return;
  const Folder folder;
  const std::string trouble = run_on_screen(folder, R"(
size=1440x900 start --save-report opened.json
fits() { xdotool getwindowgeometry $window >geometry 2>&1; grep -q 'Geometry: 1280x800' geometry; }
await "the window is larger than the screen" fits
titled() { xdotool getwindowname $window | grep -qx 'thesis-sphere - knit-mesh'; }
await "the title does not name the mesh" titled
close
start --save-report played.json
xdotool key space
close
start --save-report end.json --screenshot end.png --save-map end.txt
xdotool key End
close
)");
  REQUIRE(trouble == "");
  const std::size_t all = steps_of_whole_run();
  CHECK(steps_in(folder, "opened.json") == 0);
  CHECK(steps_in(folder, "played.json") > 0);
  CHECK(steps_in(folder, "played.json") < all);
  CHECK(steps_in(folder, "end.json") == all);
  CHECK(test_support::lines_of(read_text(folder.path() / "end.txt")).size() == 64);

  const Picture picture = read_picture(folder, "end.png");
  CHECK(picture.width == width);
  CHECK(picture.height == height);
  std::map<std::array<int, 3>, int> colours;
  for (const Colour& pixel : picture.pixels) ++colours[{pixel.r, pixel.g, pixel.b}];
  CHECK(colours.size() > 500);
  for (int label = 0; label < 7; ++label) {
    const Colour colour = dark_theme.of(static_cast<knit::Label>(label));
    CAPTURE(label);
    CHECK(colours[{colour.r, colour.g, colour.b}] > 20);  // in the legend
  }
  const auto in_view = [&](Colour colour) {
    return count_in_view(picture, [&](const Colour& pixel) { return looks_like(pixel, colour); });
  };
  CHECK(in_view(dark_theme.of(knit::Label::knit)) > 20000);
  CHECK(in_view(dark_theme.of(knit::Label::main)) > 2000);
  CHECK(count_in_view(picture, [](const Colour& pixel) { return pixel == dark_theme.background; }) > 20000);
}

TEST_CASE("the real window checks a pattern as one types, and saves what was mended") {
  if (!can_run()) return;
  const Folder folder;
  test_support::write_text(folder.path() / "ball.txt", "CO 6 sts.\nRnd 1: Knit. (7 sts)\n");
  const std::string trouble = run_on_screen(folder, R"(
"$program" check ball.txt --window --size 1200x760 2>errors &
pid=$!
await_window
titled() { xdotool getwindowname $window | grep -qx 'ball.txt - knit-mesh'; }
await "the title does not name the pattern" titled
xdotool key F4
xdotool type --delay 40 'Rnd 1: Knit. '
xdotool key --delay 40 parenleft 6 space s t s parenright ctrl+s
saved() { grep -q 'Rnd 1: Knit. (6 sts)' ball.txt; }
await "what was typed was not saved" saved
close
)");
  REQUIRE(trouble == "");
  CHECK(read_text(folder.path() / "ball.txt") == "CO 6 sts.\nRnd 1: Knit. (6 sts)\n");
}

TEST_CASE("two clicks and four keys that come within one long frame all count") {
  if (!can_run()) return;
  const Folder folder;
  const std::string forward = middle_of("forward");
  const std::string trouble = run_on_screen(folder, R"(
start --save-report quick.json
at_once mousemove --window "$window" )" + forward + R"( click 1 click 1 key --delay 8 Right Right Right Right
close
start --save-report mixed.json
at_once key --delay 8 shift+Right Right ctrl+Right Right Right Left
close
)");
  REQUIRE(trouble == "");
  CHECK(steps_in(folder, "quick.json") == 6);

  Session session = test_support::example_session("thesis-sphere");
  for (const Action& action : Actions{StepBy{Unit::row, 1}, StepBy{}, StepBy{Unit::stage, 1}, StepBy{},
                                      StepBy{}, StepBy{Unit::item, -1}}) {
    apply(session, action);
  }
  CHECK(steps_in(folder, "mixed.json") == session.document->timeline.position());
}

TEST_CASE(
    "numbers clicked, typed, tabbed and dragged within frames that take long lose no digit and hide no "
    "layer") {
  if (!can_run()) return;
  const Folder folder;
  desk::Desk desk(width, height, 1, KNIT_ASSETS_DIR "/fonts");
  desk.session = test_support::example_session("thesis-sphere");
  desk.settle();
  const auto at = [&](const std::string& control) {
    const MouseMove middle = desk.over(control);
    return std::to_string(std::lround(middle.x)) + " " + std::to_string(std::lround(middle.y));
  };
  const std::string script = R"(
start --save-report numbers.json --screenshot numbers.png
at_once mousemove --window "$window" )" +
                             at("knob/stitch-width") +
                             R"( click 1 key --delay 8 0 period 1 2 Tab 0 period 0 9 Tab
at_once mousemove --window "$window" )" +
                             at("knob-label/stitch-width") +
                             R"( key --delay 8 Escape 1 2 period comma
at_once mousemove --window "$window" )" +
                             at("speed") + R"( click 1 key --delay 8 1 2 0 period 5 Return
close
)";
  REQUIRE(run_on_screen(folder, script) == "");
  const Json report = Json::parse(read_text(folder.path() / "numbers.json"), nullptr, false);
  REQUIRE(report.is_object());
  CHECK(report["parameters"]["stitch-width"] == 0.12);
  CHECK(report["parameters"]["stitch-height"] == 0.09);
  CHECK(report["steps"] == 0);  // no key stepped or played
}

TEST_CASE(
    "every number of the left panel is typed, and then dragged, within one long frame each, and none is "
    "lost") {
  if (!can_run()) return;
  constexpr int narrow = 800, tall = 2000, drag_px = 24;  // all of the panel in sight, and little else
  const Folder folder;
  test_support::write_text(folder.path() / "ball.obj", corpus::obj_of(knit::sphere(16, 9, false)));
  const std::string direction =
      " --axis 0.125,1,0.25 --start-direction 1,0.125,0.25 --stitch-width 0.45 --epsilon 0.2";
  for (const std::string rows : {"rings", "contours"}) {
    CAPTURE(rows);
    const std::string options = "ball.obj --rows " + rows + " --settle on" + direction;
    // The same hands at a desk, where what they do is seen one by one.
    desk::Desk desk(narrow, tall, 1, KNIT_ASSETS_DIR "/fonts");
    open_as(desk, folder, options);
    desk::Hands hands(desk);
    std::string typing, dragging;
    // Of sizes that follow each other one view only.
    const std::set<std::string> left_out =
        rows == "rings" ? std::set<std::string>{"stitch-width", "stitch-height", "start", "end"}
                        : std::set<std::string>{"gauge", "height-cm", "start", "end"};
    std::vector<desk::NumberKnob> knobs = desk::number_knobs(desk);
    std::erase_if(knobs, [&](const desk::NumberKnob& knob) { return left_out.count(knob.key) > 0; });
    CHECK(knobs.size() >= 12);
    for (const desk::NumberKnob& knob : knobs) {
      CAPTURE(knob.control);
      // Sizes as they suit a ball of radius 1; epsilon stays below the width.
      const double stitch = desk.session.document->timeline.parameters().stitch.width;
      const std::string half = knit::number_text(std::round(5000.0 * stitch) / 10000.0);
      const bool length = knob.key == "stitch-width" || knob.key == "stitch-height";
      const std::string typed = length                    ? "0.4375"
                                : knob.key == "epsilon"   ? half
                                : knob.key == "height-cm" ? "20"
                                : knob.key == "gauge"     ? "2.5"
                                                          : knob.typed;
      const bool tab = &knob == &knobs.front() || knob.part > 0 || knob.key.size() % 2 == 0;
      hands.click(knob.control);
      hands.type(typed);
      hands.press(tab ? Key::Tab : Key::Enter);
      if (tab) hands.press(Key::Escape);  // the next one is open, and stays as it is
      hands.drain();
      CHECK(desk::value_of(desk, knob) == typed);
      typing += " mousemove --window $window " + place_of(desk, knob.control) + " click 1 key --delay 8" +
                keys_of_text(typed) + (tab ? " Tab Escape" : " Return");
    }
    for (const desk::NumberKnob& knob : knobs) {
      CAPTURE(knob.control);
      const std::string before = desk::value_of(desk, knob);
      hands.drag(knob.control, drag_px, 1);
      CHECK(desk::value_of(desk, knob) != before);
      dragging += " mousemove --window $window " + place_of(desk, knob.control) +
                  " mousedown 1 mousemove_relative -- " + std::to_string(drag_px) + " 0 mouseup 1";
    }
    CHECK(desk.ui.own<KnobTroubles>().empty());
    const std::string script = "start " + options + " --save-report numbers.json\nat_once" + typing +
                               "\nat_once" + dragging + "\nclose\n";
    REQUIRE(run_on_screen(folder, script, "screen=800x2000 size=800x2000") == "");
    const Json report = Json::parse(read_text(folder.path() / "numbers.json"), nullptr, false);
    REQUIRE(report.is_object());
    CHECK(report["parameters"] == Json(to_json(desk.session.document->timeline.parameters())));
    CHECK(report["steps"] == 0);  // no key stepped or played
  }
}

TEST_CASE("after a crash the real window offers the session, and a clean end leaves nothing") {
  if (!can_run()) return;
  const Folder folder;
  desk::Desk desk(width, height);
  desk.open();
  desk.session.program->rescued = Rescued{"", "thesis-sphere, row 30"};
  desk.settle();
  const MouseMove open = desk.over("rescue/open");
  const std::string at = std::to_string(std::lround(open.x)) + " " + std::to_string(std::lround(open.y));
  const std::string trouble = run_on_screen(folder, R"(
start
xdotool key shift+Right
await "nothing was saved aside" saved_aside
kill -KILL $pid
wait $pid || true
start --save-report beside.json
close
saved_aside || fail "what was on offer is gone though nobody took it"
start --save-report rescued.json
xdotool mousemove --window "$window" )" + at + R"( click 1
close
! saved_aside || fail "a clean end left something"
)");
  REQUIRE(trouble == "");
  CHECK(steps_in(folder, "beside.json") == 0);
  CHECK(steps_in(folder, "rescued.json") > 0);
}

TEST_CASE("a window that the graphics driver loses is opened anew and nothing else is lost") {
  if (!can_run()) return;
  const Folder folder;
  const std::string trouble = run_on_screen(folder, R"sh(
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0"
LD_PRELOAD=$losing_driver start --save-report after.json --screenshot after.png
xdotool key shift+Right
await "nothing was saved aside" saved_aside
touch lose-once
two_windows() { [ "$(wc -l <windows)" = 2 ]; }
await "no second window came" two_windows
await_window
xdotool key Right
close
)sh");
  REQUIRE(trouble == "");
  Session session = test_support::example_session("thesis-sphere");
  for (const Action& action : Actions{StepBy{Unit::row, 1}, StepBy{}}) apply(session, action);
  CHECK(steps_in(folder, "after.json") == session.document->timeline.position());
  const Picture picture = read_picture(folder, "after.png");
  CHECK(picture.width == width);
  CHECK(count_in_view(picture, [](const Colour& pixel) { return !(pixel == dark_theme.background); }) >
        20000);
}

TEST_CASE("a graphics driver that loses every window ends the program with a sentence and the session kept") {
  if (!can_run()) return;
  const Folder folder;
  const std::string trouble = run_on_screen(folder, R"sh(
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0"
LD_PRELOAD=$losing_driver start
xdotool key shift+Right
await "nothing was saved aside" saved_aside
touch lose-always
code=0
wait $pid || code=$?
[ $code = 2 ] || fail "exit code $code: $(cat errors)"
[ "$(wc -l <windows)" = 3 ] || fail "not three windows were tried"
[ "$(wc -l <errors)" = 1 ] || fail "not one line: $(cat errors)"
grep -q 'three times.*The session is kept.*--headless' errors || fail "it says: $(cat errors)"
saved_aside || fail "the session is not kept"
)sh");
  REQUIRE(trouble == "");
}

TEST_CASE("the real window remembers theme and panels, but not what the command line said for one start") {
  if (!can_run()) return;
  const Folder folder;
  const std::string trouble = run_on_screen(folder, R"(
file=config/knit-mesh/preferences.json
start
close
[ ! -e $file ] || fail "it was written though nothing had changed"
start
xdotool key F8 F9
close
grep -q '"theme": "light"' $file || fail "the theme is not remembered"
grep -q '"timeline": false' $file || fail "the panels are not remembered"
start --theme dark --scale 1.5
xdotool key F9
close
grep -q '"theme": "light"' $file || fail "--theme was saved"
grep -q '"scale": 1.0' $file || fail "--scale was saved"
grep -q '"timeline": true' $file || fail "the panels did not come back"
)");
  REQUIRE(trouble == "");
}

TEST_CASE("in the real window a drag turns the view, keys hide layers, and the play button plays") {
  if (!can_run()) return;
  const Folder folder;
  const std::string view = middle_of("view");
  const std::string play = middle_of("play");
  const std::string trouble = run_on_screen(folder, R"(
start --at rows:30 --screenshot still.png
close
start --at rows:30 --screenshot turned.png --save-report turned.json
xdotool mousemove --window "$window" )" + view + R"( mousedown 1 mousemove_relative -- -120 60 mouseup 1
close
start --at end --screenshot bare.png
at_once keydown 6 keydown 7 keydown 8 keydown 9 keyup 6 keyup 7 keyup 8 keyup 9
close
start --save-report button.json
xdotool mousemove --window "$window" )" + play + R"( click 1
close
)");
  REQUIRE(trouble == "");
  const Picture still = read_picture(folder, "still.png");
  const Picture turned = read_picture(folder, "turned.png");
  REQUIRE(still.pixels.size() == turned.pixels.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < still.pixels.size(); ++i)
    different += still.pixels[i] == turned.pixels[i] ? 0U : 1U;
  CHECK(different > still.pixels.size() / 50);

  Session session = test_support::example_session("thesis-sphere");
  apply(session, SeekPlace{{knit::Stage::rows, 30, 0}});
  CHECK(steps_in(folder, "turned.json") == session.document->timeline.position());  // dragging is no stepping

  const Picture bare = read_picture(folder, "bare.png");
  const Colour main = dark_theme.of(knit::Label::main);
  CHECK(count_in_view(bare, [&](const Colour& pixel) { return looks_like(pixel, main); }) < 200);
  CHECK(count_in_view(bare, [](const Colour& pixel) { return pixel == dark_theme.background; }) > 20000);
  CHECK(steps_in(folder, "button.json") > 0);
}
