// Both themes are readable: contrast as WCAG 2 counts it, for what stands on what in the panels.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "app/panels/kit/style.h"
#include "app/scene/contrast.h"
#include "app/scene/palette.h"
#include "knit/model/words.h"
#include "tests/support/catch.h"

namespace {

using namespace app;

double linear(std::uint8_t byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const Colour& c) {
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

double ratio(const Colour& a, const Colour& b) {
  const double light = std::max(luminance(a), luminance(b));
  const double dark = std::min(luminance(a), luminance(b));
  return (light + 0.05) / (dark + 0.05);
}

// As seen: `c` at so much of its own over the ground.
Colour over(const Colour& c, int alpha, const Colour& ground) {
  const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((a * alpha + b * (255 - alpha)) / 255);
  };
  return {mixed(c.r, ground.r), mixed(c.g, ground.g), mixed(c.b, ground.b)};
}

// In degrees, red 0, green 120, blue 240.
double hue(const Colour& c) {
  const double r = c.r, g = c.g, b = c.b;
  const double degrees = std::atan2(std::sqrt(3.0) * (g - b), 2.0 * r - g - b) * 57.29577951308232;
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

struct Named {
  std::string name;
  Colour colour;
};

std::vector<Named> grounds(const Theme& theme) {
  return {{"panel", theme.panel}, {"raised", theme.raised}, {"background", theme.background}};
}

}  // namespace

TEST_CASE("black on white is 21 to 1") {
  CHECK(ratio({0, 0, 0}, {255, 255, 255}) == Approx(21.0));
  CHECK(ratio({119, 119, 119}, {255, 255, 255}) == Approx(4.48).margin(0.01));
}

TEST_CASE("the program counts contrast as the test does, and finds a colour that can be read") {
  const Colour sky{86, 180, 233};
  CHECK(app::contrast(sky, {24, 27, 33}) == Approx(ratio(sky, {24, 27, 33})));
  for (const Colour ground : {Colour{255, 255, 255}, Colour{0, 0, 0}, Colour{118, 118, 118}, sky}) {
    for (const Colour& words : {sky, Colour{120, 120, 120}, Colour{0, 114, 178, 90}}) {
      const Colour found = readable_on(words, ground);
      CHECK(found.a == 255);
      CHECK(ratio(found, ground) >= 4.5);
      if (ratio(words, ground) >= 4.5) CHECK(found == opaque(words));
    }
  }
}

TEST_CASE("words of both themes stand out from what they stand on") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (const Named& ground : grounds(theme)) {
      INFO("on " << ground.name);
      CHECK(ratio(theme.text, ground.colour) >= 7.0);
      CHECK(ratio(theme.faint_text, ground.colour) >= 4.5);
    }
    CHECK(ratio(theme.faint_text, theme.hovered) >= 4.5);
    for (const Colour& ground : {theme.hovered, theme.pressed}) CHECK(ratio(theme.text, ground) >= 7.0);
    CHECK(ratio(theme.on_accent, theme.accent) >= 4.5);
    // Used as words in panels.
    for (const Colour& colour :
         {theme.warning, theme.problem, theme.anchor, theme.selected, theme.accent, opaque(theme.ghost)})
      CHECK(ratio(colour, theme.panel) >= 4.5);
  }
}

TEST_CASE(
    "words can be read on what lights their line, under a slider's grab, and where nothing can be done") {
  const int disabled = static_cast<int>(255.0f * style::disabled_alpha);
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (const int alpha : {40, 70}) CHECK(ratio(theme.text, over(theme.anchor, alpha, theme.panel)) >= 4.5);
    // A slider's grab; likewise what is selected in a field.
    for (const Colour& ground : {theme.raised, theme.hovered})
      CHECK(ratio(theme.text, over(theme.accent, 100, ground)) >= 4.5);
    for (const Colour& ground : {theme.panel, theme.raised})
      CHECK(ratio(over(theme.text, disabled, ground), ground) >= 4.5);
  }
}

TEST_CASE("every label can be read: its name in the view, its symbol in the chart and on its face") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (std::size_t i = 0; i < theme.labels.size(); ++i) {
      const auto label = static_cast<knit::Label>(i);
      INFO(knit::name_of(label));
      CHECK(ratio(readable_on(theme.of(label), theme.background), theme.background) >= 4.5);
      for (const Colour& paper : {theme.paper, theme.main_paper, theme.lit_paper})
        CHECK(ratio(theme.ink_of(label), paper) >= 4.5);
      CHECK(ratio(theme.symbol_on(label), theme.of(label)) >= 4.5);
    }
  }
}

TEST_CASE("marks and controls of both themes stand out from what they stand on") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (const Named& ground : grounds(theme)) {
      INFO("on " << ground.name);
      for (const Colour& colour : {theme.accent, theme.warning, theme.problem, theme.break_hit})
        CHECK(ratio(colour, ground.colour) >= 3.0);
    }
    for (const Colour& colour : {theme.selected, theme.anchor, theme.ring, theme.stitch, theme.accepted})
      CHECK(ratio(colour, theme.background) >= 3.0);
  }
}

TEST_CASE("the pinned run's line in a plot is seen and is no shade of the present run's") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    CHECK(ratio(theme.pinned, theme.background) >= 3.0);
    CHECK(ratio(theme.accent, theme.background) >= 3.0);
    // The numbers of the pinned run are written in it.
    for (const Named& ground : grounds(theme)) CHECK(ratio(theme.pinned, ground.colour) >= 4.5);
    // Of the hue circle's 360 degrees.
    const double apart = std::abs(hue(theme.pinned) - hue(theme.accent));
    CHECK(std::min(apart, 360.0 - apart) >= 60.0);
    const double from_ideal = std::abs(hue(theme.pinned) - hue(theme.anchor));
    CHECK(std::min(from_ideal, 360.0 - from_ideal) >= 60.0);
  }
}

TEST_CASE("a stage's name can be read on its stretch of the timeline, before it and after") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (std::size_t i = 0; i < theme.stages.size(); ++i) {
      INFO("stage " << i);
      for (const int alpha : {theme.stage_ahead, theme.stage_done})
        CHECK(ratio(theme.text, over(theme.stages[i], alpha, theme.panel)) >= 4.5);
    }
  }
}

TEST_CASE("no panel has a colour of its own, which would be for one theme only") {
  namespace fs = std::filesystem;
  const std::regex own_colour("Colour [a-z_]+ ?[={({] ?[0-9]|Colour ?[{(] ?[0-9]");
  CHECK(std::regex_search("constexpr Colour ideal_line{240, 190, 80};", own_colour));
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(KNIT_SOURCE_DIR "/app/panels")) {
    if (!entry.is_regular_file()) continue;
    ++files;
    std::ifstream in(entry.path());
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    INFO(entry.path().filename().string());
    CHECK_FALSE(std::regex_search(text, own_colour));
  }
  CHECK(files > 50);
}
