// The stretched rows of coverage.h.
#include <algorithm>
#include <glm/geometric.hpp>

#include "knit/quality/coverage.h"

namespace knit {

namespace {

// The wales that end at one row's stitches.
struct RowWales {
  std::size_t count = 0, stretched = 0;
  double longest = 0.0;  // in h
  StitchRef at;
};

std::vector<RowWales> wales_of(const State& state, double stitch_height) {
  const KnittingPath path(state.fabric);
  std::vector<RowWales> rows(static_cast<std::size_t>(state.fabric.next_row()));  // by their numbers
  const auto measure = [&](const std::vector<std::array<std::uint32_t, 2>>& column_edges) {
    for (const auto& [lower, upper] : column_edges) {
      const StitchRef at = path.at(upper);
      if (is_bridge(at)) continue;
      RowWales& row = rows[static_cast<std::size_t>(at.row)];
      const double length = glm::distance(path.position(lower), path.position(upper)) / stitch_height;
      ++row.count;
      row.stretched += length > stretched_above ? 1 : 0;
      if (length <= row.longest) continue;
      row.longest = length;
      row.at = at;
    }
  };
  for (const auto& strip : state.fabric.strips()) measure(strip->column_edges);
  for (const auto& deal : state.fabric.deals()) measure(deal->column_edges);
  return rows;
}

}  // namespace

std::vector<Stretched> stretched_rows(const State& state, double stitch_height) {
  const std::vector<RowWales> wales = wales_of(state, stitch_height);
  std::vector<Stretched> all;
  std::size_t wales_of_last = 0, stretched_of_last = 0;
  for (const auto& row : state.fabric.rows()) {
    const RowWales& of = wales[static_cast<std::size_t>(row->id)];
    if (of.stretched == 0) continue;
    const bool goes_on = !all.empty() && all.back().tube == row->tube && all.back().to + 1 == row->id;
    if (!goes_on) {
      all.push_back({row->tube, row->id, row->id, 0.0, 0.0, {}});
      wales_of_last = stretched_of_last = 0;
    }
    Stretched& last = all.back();
    last.to = row->id;
    wales_of_last += of.count;
    stretched_of_last += of.stretched;
    last.share = static_cast<double>(stretched_of_last) / static_cast<double>(wales_of_last);
    if (of.longest <= last.longest) continue;
    last.longest = of.longest;
    last.at = of.at;
  }
  return all;
}

}  // namespace knit
