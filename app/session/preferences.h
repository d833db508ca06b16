// What a person has set about the program itself, for every mesh: remembered from one start to the next.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/palette.h"

namespace app {

// What can be closed. The view cannot.
enum class Panel : std::uint8_t { parameters, side, timeline };
inline constexpr std::array<std::string_view, 3> panel_keys{"parameters", "side", "timeline"};
// In ShowPanel: all that can be closed, at once.
inline constexpr Panel every_panel{static_cast<Panel>(panel_keys.size())};

// The line between two panels that can be dragged: its panel's width or height, in units of a plain screen.
// 0: as there is room.
enum class Split : std::uint8_t { left, right, bottom };
inline constexpr std::array<std::string_view, 3> split_keys{"left", "right", "bottom"};

// Of words and lines, on top of what the display asks for.
inline constexpr double smallest_scale = 0.75;
inline constexpr double largest_scale = 2.5;
inline constexpr double projector_scale = 1.5;

// Of the questions of a lesson, the best so far.
struct LessonScore {
  std::int32_t right = 0, of = 0;
  friend bool operator==(const LessonScore&, const LessonScore&) = default;
};

// What the list of rows says of each, besides its number.
enum class RowColumn : std::uint8_t { stitches, change, holds, course, tube };
inline constexpr std::array<std::string_view, 5> row_column_keys{"stitches", "change", "holds", "course",
                                                                 "tube"};

struct Preferences {
  ThemeKind theme = ThemeKind::dark;
  double scale = 1.0;
  bool motion = true;  // short movements in the view
  std::array<bool, panel_keys.size()> panels{true, true, true};
  std::array<double, split_keys.size()> splits{};
  std::vector<std::string> recent;  // what was opened, newest first: an absolute path, or "example:NAME"
  std::map<std::string, LessonScore> lessons;  // by key
  std::int32_t longest_streak = 0;             // of right guesses
  std::array<bool, row_column_keys.size()> row_columns{true, true, false, false, false};
  friend bool operator==(const Preferences&, const Preferences&) = default;

  [[nodiscard]] bool shows(Panel panel) const { return panels[static_cast<std::size_t>(panel)]; }
  [[nodiscard]] bool shows(RowColumn column) const { return row_columns[static_cast<std::size_t>(column)]; }
};

}  // namespace app
