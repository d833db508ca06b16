// Both themes are readable: contrast as WCAG 2 counts it, for what stands on what in the panels.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/scene/palette.h"
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

double contrast(const Colour& a, const Colour& b) {
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

struct Named {
  std::string name;
  Colour colour;
};

std::vector<Named> grounds(const Theme& theme) {
  return {{"panel", theme.panel}, {"raised", theme.raised}, {"background", theme.background}};
}

}  // namespace

TEST_CASE("black on white is 21 to 1") {
  CHECK(contrast({0, 0, 0}, {255, 255, 255}) == Approx(21.0));
  CHECK(contrast({119, 119, 119}, {255, 255, 255}) == Approx(4.48).margin(0.01));
}

TEST_CASE("words of both themes stand out from what they stand on") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (const Named& ground : grounds(theme)) {
      INFO("on " << ground.name);
      CHECK(contrast(theme.text, ground.colour) >= 7.0);
      CHECK(contrast(theme.faint_text, ground.colour) >= 4.5);
    }
    for (const Colour& ground : {theme.hovered, theme.pressed}) CHECK(contrast(theme.text, ground) >= 7.0);
    CHECK(contrast(theme.on_accent, theme.accent) >= 4.5);
    // Used as words in panels.
    for (const Colour& colour : {theme.warning, theme.problem, theme.anchor})
      CHECK(contrast(colour, theme.panel) >= 4.5);
  }
}

TEST_CASE("marks and controls of both themes stand out from what they stand on") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (const Named& ground : grounds(theme)) {
      INFO("on " << ground.name);
      for (const Colour& colour : {theme.accent, theme.warning, theme.problem, theme.break_hit})
        CHECK(contrast(colour, ground.colour) >= 3.0);
    }
    for (const Colour& colour : {theme.selected, theme.anchor, theme.ring, theme.stitch, theme.accepted})
      CHECK(contrast(colour, theme.background) >= 3.0);
  }
}

TEST_CASE("a stage's name can be read on its stretch of the timeline, before it and after") {
  for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
    const Theme& theme = theme_of(kind);
    INFO(theme_keys[static_cast<std::size_t>(kind)]);
    for (std::size_t i = 0; i < theme.stages.size(); ++i) {
      INFO("stage " << i);
      for (const int alpha : {theme.stage_ahead, theme.stage_done})
        CHECK(contrast(theme.text, over(theme.stages[i], alpha, theme.panel)) >= 4.5);
    }
  }
}
