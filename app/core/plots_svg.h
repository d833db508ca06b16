// Plots as a drawing for paper: black on white, with axes; its unit is a millimetre.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace app {

// Values a row: as they are, and as they should be. All three are equally long.
struct RowsFigure {
  std::string key;  // the class of its group, and its name in CSV
  std::string title;
  std::string value;  // the axis's title
  std::vector<std::int32_t> rows;
  std::vector<double> made, ideal;
};

// How often values fall into equal bins; no bins: nothing to count yet.
struct HistogramFigure {
  std::string key, title;
  std::string unit;  // the title of the axis along
  int decimals = 2;  // of the mean
  double low = 0.0, high = 1.0;
  std::vector<std::size_t> bins;
  double reference = 1.0;  // the right value
  std::optional<double> mean;
  bool open_above = false;  // the last bin also holds what is higher
};

struct PlotFigures {
  std::string title;
  std::vector<RowsFigure> rows;             // one below the other
  std::vector<HistogramFigure> histograms;  // side by side below
};

// A document of its own. Without an XML declaration; text is UTF-8.
std::string plots_svg(const PlotFigures& figures);

}  // namespace app
