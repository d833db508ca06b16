// What differs between two runs, a and b: the pinned one and the current one, or those of two sessions.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/compare/tube_figures.h"
#include "app/session/run_figures.h"

namespace app {

// A run to its end, finished or stopped; the references must outlive the comparison.
struct RunEnd {
  const knit::Input& input;
  const Knobs& knobs;
  const knit::State& state;
  const RunFigures& figures;
  std::optional<double> uncovered = std::nullopt;  // share of the surface; none: not measured
};

struct FigureLine {
  std::string key, name;  // "course-cv", "Course CV"
  // As text; the difference is b's over a's, empty where they are equal and a dash where one of them is missing.
  std::string a, b, difference;
  [[nodiscard]] bool differs() const;
};

struct ParameterLine {
  std::string key, label, a, b;
};

// Of the first row that is not the same in both.
enum class RowDiffers : std::uint8_t { size, places, shaping, missing };
struct FirstRow {
  std::int32_t row = 1;
  RowDiffers how = RowDiffers::size;
  std::int32_t a = 0, b = 0;  // stitches; 0 where there is no such row
};

struct RunDifference {
  bool same_mesh = true;
  std::vector<ParameterLine> parameters;  // those that differ from the start
  bool edits_differ = false;
  std::optional<FirstRow> first_row;
  std::int32_t rows_differ = 0, rows = 0;  // of so many; rows of the longer run
  std::vector<FigureLine> figures;  // all of them, equal or not; those of tubes where a run has more than one
  std::vector<TubeLine> tubes;      // likewise
  std::string stop_a, stop_b;       // why they stopped; empty: finished
  [[nodiscard]] bool any() const;
};
RunDifference difference_of(const RunEnd& a, const RunEnd& b);

// "29 of 64 rows differ, first row 7: 44 stitches and 45."
std::string rows_words(const RunDifference& difference, const RunNames& names = {});
// A line each; tables are aligned. The names head the two columns.
std::string text_of(const RunDifference& difference, std::string_view a_name, std::string_view b_name);

}  // namespace app
