// Small plots for any panel: plain data in; each is one item at the cursor, as wide and high as asked.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>

#include "app/core/fixed_text.h"
#include "app/panels/panels.h"

namespace app {

// How often values fall into equal bins over [low, high].
struct HistogramPlot {
  std::string name;  // of the item and its mark: "plot/course"
  std::string title;
  std::string help;       // for the title's tooltip
  std::string unit;       // after a number in a tooltip: " w"
  std::string axis_unit;  // after the numbers below the axis
  std::string counted;    // what the bins count, in a tooltip: "edges"
  double low = 0.0, high = 1.0;
  int decimals = 2;  // of numbers in words
  std::span<const std::size_t> bins;
  std::optional<double> reference;  // the right value: dashed, and written below
  std::optional<double> mean;       // a full line, and written above
  bool open_below = false;          // the first bin also holds what is lower
  bool open_above = false;          // the last bin also holds what is higher
  std::string missing;              // said while there is nothing: "after the faces"
};
void draw_histogram(PanelFrame& frame, const HistogramPlot& plot, ImVec2 size);

// Two values a row: as it is (steps) and as it should be (a line). Rows are counted from 1 in words.
struct RowPlot {
  std::string name;
  std::string title;
  std::string help;
  std::string value_words, ideal_words;    // of the two: "made", "ideal"
  std::span<const double> values, ideals;  // of the first, second ... row; equally many, or no ideals
  std::span<const double> ghosts;          // the same of the run compared with, pale; may be empty
  int decimals = 0;                        // of values in words
  std::size_t rows = 0;                    // that the axis has room for, at least: it stays still in a run
  double highest = 0.0;                    // likewise
  std::optional<std::size_t> current;      // index of the row at hand; may be one that is not there yet
  std::string missing;
};
// The index of the row that was clicked.
std::optional<std::size_t> draw_row_plot(PanelFrame& frame, const RowPlot& plot, ImVec2 size);

// Distance of marks on an axis from 0 to `high`: 1, 2 or 5 times a power of ten, so that at most `most` fit in.
// At least 1.
double tick_step(double high, int most);

}  // namespace app
