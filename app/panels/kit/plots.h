// Small plots for any panel: plain data in; each is one item at the cursor, as wide and high as asked.
#pragma once

#include <imgui.h>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "app/base/text.h"
#include "app/panels/kit/frame.h"
#include "app/panels/kit/style.h"

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
  std::optional<std::size_t> lit;   // the bin whose things are lit in the view
};
// What the bin counts: from <= value < to; without end where it also holds what lies beyond.
std::pair<double, double> span_of_bin(const HistogramPlot& plot, std::size_t bin);
// The bin that was clicked, if it counts anything.
std::optional<std::size_t> draw_histogram(PanelFrame& frame, const HistogramPlot& plot, ImVec2 size);

// Two values a row: as it is (steps) and as it should be (a line). Rows are counted from `first` in words.
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
  std::optional<std::size_t> current;      // index of the current row; may be one that is not there yet
  std::string missing;
  std::size_t first = 1;  // number of the first row
  bool gaps = false;      // what lies between steps and line is filled
  std::function<std::string(std::size_t)> words =
      {};  // for the tip of a row, by its index; empty: its two values
};
// The index of the row that was clicked.
std::optional<std::size_t> draw_row_plot(PanelFrame& frame, const RowPlot& plot, ImVec2 size);

// Distance of marks on an axis from 0 to `high`: 1, 2 or 5 times a power of ten, so that at most `most` fit in.
// At least 1.
double tick_step(double high, int most);

// What every plot stands on: its ground, the axis below, words around. For the files that draw plots.

namespace plot_parts {

inline Colour bar() { return theme().accent; }

// One plot on the screen: the title above, the ground that values are drawn on, the axis below.
struct Stand {
  ImDrawList& list;
  float left;  // of the title
  Box ground;
  float line;      // of its thin lines
  float axis_top;  // of the words below
  bool clicked;
  bool hovered;  // long enough for a tooltip
  bool inside;   // the pointer is over the ground, hovered or clicking
};

// Takes the item's room and draws title and ground; `gutter` is left free beside the ground for words.
Stand begin_stand(PanelFrame& frame, const std::string& name, const std::string& title, ImVec2 size,
                  float gutter);
// The axis itself comes last, over the feet of what stands on it.
void draw_foot(const Stand& stand);
// Instead of values.
void draw_missing(const PanelFrame& frame, const Stand& stand, const std::string& words,
                  const std::string& help);

// Whole units, so that thin lines are as wide everywhere.
float whole(float x);
void fill(const Stand& stand, float x0, float y0, float x1, float y1, ImU32 colour);
// The same, level and in dashes counted from the ground's left edge.
void fill_dashed(const PanelFrame& frame, const Stand& stand, float x0, float y0, float x1, float y1,
                 ImU32 colour);

// Words below the axis. Those given first are drawn first, and what would touch them is left out.
struct AxisWord {
  float x;
  float align;
  std::string words;
  Colour colour = theme().faint_text;
};
void draw_axis_words(const PanelFrame& frame, const Stand& stand, std::span<const AxisWord> words);

// Words at the right end of the title's line: in the colour of what they speak of, or with a line of it before
// them.
struct PlotKey {
  std::string words;
  Colour colour;
  bool line;
  bool dashed = false;
};
// Gives where they begin, so that the next stand before them. Left out where they would touch the title.
float draw_key(const PanelFrame& frame, const Stand& stand, const std::string& title, float right,
               const PlotKey& key);

}  // namespace plot_parts

}  // namespace app
