#include "knit/quality/measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace knit {

LengthFigures figures_of(std::span<const double> lengths) {
  LengthFigures figures;
  figures.count = lengths.size();
  if (lengths.empty()) return figures;
  figures.low = figures.high = lengths.front();
  for (const double length : lengths) {
    figures.mean += length;
    figures.low = std::min(figures.low, length);
    figures.high = std::max(figures.high, length);
  }
  const auto count = static_cast<double>(lengths.size());
  figures.mean /= count;
  double squares = 0.0;
  for (const double length : lengths) squares += (length - figures.mean) * (length - figures.mean);
  if (figures.mean > 0.0) figures.cv = std::sqrt(squares / count) / figures.mean;
  return figures;
}

LengthFigures course_figures(const State& state) {
  std::vector<double> lengths;
  for (const auto& row : state.fabric.rows()) {
    for (const auto& [from, to] : edges_of(*row))
      lengths.push_back(glm::distance(row->stitches[from].position, row->stitches[to].position));
  }
  return figures_of(lengths);
}

LengthFigures wale_figures(const State& state) {
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  std::vector<double> lengths;
  for (const auto& strip : state.fabric.strips()) {
    for (const auto& [lower, upper] : strip->column_edges)
      lengths.push_back(glm::distance(path[lower], path[upper]));
  }
  for (const auto& deal : state.fabric.deals()) {
    for (const auto& [lower, upper] : deal->column_edges)
      lengths.push_back(glm::distance(path[lower], path[upper]));
  }
  return figures_of(lengths);
}

ShapingFigures shaping_figures(const State& state) {
  ShapingFigures figures;
  for (const auto& join : state.fabric.joins()) {
    const std::int32_t change = join->change();
    (change > 0 ? figures.increases : figures.decreases) += std::abs(change);
    figures.max_in_a_row = std::max(figures.max_in_a_row, std::abs(change));
  }
  return figures;
}

RowId most_shaped_row(const State& state) {
  RowId row = 0;
  std::int32_t most = 0;
  for (const auto& join : state.fabric.joins()) {
    const std::int32_t change = std::abs(join->change());
    if (change > most) row = join->to;
    most = std::max(most, change);
  }
  return row;
}

FaceCounts count_faces(const State& state) {
  FaceCounts counts;
  const auto add = [&](const std::vector<Face>& faces) {
    for (const Face& face : faces) ++(face.corner_count == 4 ? counts.quads : counts.triangles);
  };
  for (const auto& strip : state.fabric.strips()) add(strip->faces);
  for (const auto& deal : state.fabric.deals()) add(deal->faces);
  return counts;
}

std::int64_t euler_characteristic(const State& state) {
  const auto vertices = static_cast<std::int64_t>(state.fabric.stitch_count());
  std::int64_t edges = 0;
  // A short row hangs together with the stitch beside it at either end, across the turn.
  for (const auto& row : state.fabric.rows())
    edges += static_cast<std::int64_t>(edges_of(*row).size()) + (is_short(*row) ? 2 : 0);
  for (const auto& strip : state.fabric.strips())
    edges += static_cast<std::int64_t>(strip->column_edges.size());
  for (const auto& deal : state.fabric.deals()) edges += static_cast<std::int64_t>(edge_count(*deal));
  const FaceCounts faces = count_faces(state);
  return vertices - edges + static_cast<std::int64_t>(faces.quads + faces.triangles);
}

bool is_unusual(const Step& step, const Parameters& parameters) {
  return visit_event(
      [&](const auto& event) {
        if constexpr (requires { event.unusual(parameters); }) return event.unusual(parameters);
        return std::is_same_v<decltype(event), const Stopped&>;
      },
      step.what);
}

}  // namespace knit
