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
  for (const auto& row : state.rows) {
    const std::size_t n = row->stitches.size();
    for (std::size_t i = 0; i < n; ++i) {
      lengths.push_back(glm::distance(row->stitches[i].position, row->stitches[(i + 1) % n].position));
    }
  }
  return figures_of(lengths);
}

LengthFigures wale_figures(const State& state) {
  const std::vector<glm::dvec3> path = knitting_path(state);
  std::vector<double> lengths;
  for (const auto& strip : state.strips) {
    for (const auto& [lower, upper] : strip->column_edges)
      lengths.push_back(glm::distance(path[lower], path[upper]));
  }
  return figures_of(lengths);
}

ShapingFigures shaping_figures(const State& state) {
  ShapingFigures figures;
  for (const auto& transition : state.transitions) {
    const std::int32_t change = transition->change();
    (change > 0 ? figures.increases : figures.decreases) += std::abs(change);
    figures.max_in_a_row = std::max(figures.max_in_a_row, std::abs(change));
  }
  return figures;
}

FaceCounts count_faces(const State& state) {
  FaceCounts counts;
  for (const auto& strip : state.strips) {
    for (const Face& face : strip->faces) ++(face.corner_count == 4 ? counts.quads : counts.triangles);
  }
  return counts;
}

std::size_t count_stitches(const State& state) {
  std::size_t stitches = 0;
  for (const auto& row : state.rows) stitches += row->stitches.size();
  return stitches;
}

std::int64_t euler_characteristic(const State& state) {
  const auto vertices = static_cast<std::int64_t>(count_stitches(state));
  std::int64_t edges = vertices;  // a closed row has as many edges as stitches
  for (const auto& strip : state.strips) edges += static_cast<std::int64_t>(strip->column_edges.size());
  const FaceCounts faces = count_faces(state);
  return vertices - edges + static_cast<std::int64_t>(faces.quads + faces.triangles);
}

std::vector<glm::dvec3> knitting_path(const State& state) {
  std::vector<glm::dvec3> path;
  path.reserve(count_stitches(state));
  for (const auto& row : state.rows) {
    for (const Stitch& stitch : row->stitches) path.push_back(stitch.position);
  }
  return path;
}

const Stitch& stitch_at(const State& state, std::uint32_t number) {
  std::size_t i = number;
  std::size_t row = 0;
  while (i >= state.rows[row]->stitches.size()) i -= state.rows[row++]->stitches.size();
  return state.rows[row]->stitches[i];
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
