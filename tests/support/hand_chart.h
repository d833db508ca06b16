// Charts of tubes that are round and upright, by how high they are at each column.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "knit/short_rows/tube_chart.h"

namespace test_support {

// A chart of a few columns whose cells are as wide as is said, and levels that end where their columns do.
inline knit::TubeChart hand_chart(const std::vector<double>& ends, std::int32_t levels) {
  knit::TubeChart chart;
  chart.columns = static_cast<std::int32_t>(ends.size());
  for (std::int32_t l = 0; l < levels; ++l) {
    chart.times.push_back(static_cast<double>(l) / (levels - 1));
    for (std::int32_t j = 0; j < chart.columns; ++j) {
      const double turn = 2.0 * std::numbers::pi * j / chart.columns;
      const double height = ends[static_cast<std::size_t>(j)] * chart.times.back();
      const double radius = 1.0 / (2.0 * std::sin(std::numbers::pi / chart.columns));  // cells 1 wide
      chart.points.push_back({radius * std::cos(turn), radius * std::sin(turn), 0.0});
      chart.heights.push_back(height);
    }
  }
  return chart;
}

}  // namespace test_support
