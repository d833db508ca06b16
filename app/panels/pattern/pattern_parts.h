// What chart, written rounds and knitting along share, and what they remember.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>

#include "app/panels/kit/widgets.h"
#include "app/panels/pattern/pattern_lines.h"
#include "knit/pattern/chart.h"

namespace app {

struct SquareLook {
  float side = 16.0f;
  bool lit = false;  // of the current round
  bool hovered = false;
};

// One square with its symbol; `low` is its upper left corner.
void draw_square(ImDrawList& list, ImVec2 low, const knit::ChartSquare& square, const SquareLook& look);

// That is knitted along, or in progress; none: 0.
std::int32_t current_round(const PanelFrame& frame);
// There, as wish_row; who knits along goes on from there, or from a deal before it.
void wish_round(PanelFrame& frame, std::int32_t number, std::int16_t deal = 0);

// What is typed about the pattern; follows the session's options unless they are what was typed.
struct PatternFields {
  bool open = false;
  std::optional<knit::PatternOptions> shown;  // what the buffers stand for
  TextBuffer title, yarn, colour, needle;
  std::string trouble;  // why the needle is refused
};

// The written pattern's place in its panel.
struct PatternView {
  PatternLayout layout;
  std::int32_t followed = 0;                // the current round that was scrolled to
  std::int16_t followed_deal = 0;           // and the deal before it
  std::optional<RoundSpan> followed_meant;  // and the rounds under the pointer elsewhere
};

// How the chart is held: as fits the panel, times `zoom`, moved by `move`.
struct ChartView {
  float zoom = 1.0f;
  ImVec2 move{0.0f, 0.0f};
};

}  // namespace app
