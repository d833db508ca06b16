#include "knit/insight/sized.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/base/number_text.h"
#include "knit/model/words.h"
#include "knit/quality/quality.h"

namespace knit {

namespace {

using ColumnEdges = std::vector<std::array<std::uint32_t, 2>>;

void add_courses(const State& state, const StitchSize& stitch, const SizeRange& range,
                 std::vector<SizedThing>& things) {
  for (const auto& row : state.fabric.rows()) {
    for (const auto& [from, to] : edges_of(*row)) {
      const double length = glm::distance(row->stitches[from].position, row->stitches[to].position);
      if (range.holds(length / stitch.width))
        things.push_back({RowEdgeElement{row->id, static_cast<std::int32_t>(from)},
                          {row->stitches[from].position, row->stitches[to].position}});
    }
  }
}

void add_wales(const State& state, const StitchSize& stitch, const SizeRange& range,
               std::vector<SizedThing>& things) {
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  const auto add = [&](RowId row, const ColumnEdges& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double length = glm::distance(path[edges[i][0]], path[edges[i][1]]);
      if (range.holds(length / stitch.height))
        things.push_back(
            {ColumnEdgeElement{row, static_cast<std::int32_t>(i)}, {path[edges[i][0]], path[edges[i][1]]}});
    }
  };
  for (const auto& strip : state.fabric.strips()) add(strip->to, strip->column_edges);
  std::int32_t number = 0;
  for (const auto& deal : state.fabric.deals()) add(bridge_row(++number), deal->column_edges);
}

void add_corners(const State& state, const SizeRange& range, std::vector<SizedThing>& things) {
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  for (const auto& strip : state.fabric.strips()) {
    for (std::size_t i = 0; i < strip->faces.size(); ++i) {
      const Face& face = strip->faces[i];
      const auto angles = corner_angles(face, path);
      const auto count = static_cast<std::size_t>(face.corner_count);
      const auto corners = std::span(angles).first(count);
      if (std::none_of(corners.begin(), corners.end(), [&](double a) { return range.holds(a); })) continue;
      SizedThing thing{FaceElement{strip->to, static_cast<std::int32_t>(i)}, {}, count};
      for (std::size_t k = 0; k < count; ++k) thing.points.at(k) = path[face.corners.at(k)];
      things.push_back(thing);
    }
  }
}

std::optional<double> size_number(std::string_view text) {
  double value = 0.0;
  const auto [end, fault] = number_from(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::vector<SizedThing> things_of_size(const State& state, const StitchSize& stitch, const SizeRange& range) {
  std::vector<SizedThing> things;
  switch (range.of) {
    case Measured::course:
      add_courses(state, stitch, range, things);
      break;
    case Measured::wale:
      add_wales(state, stitch, range, things);
      break;
    case Measured::corner:
      add_corners(state, range, things);
      break;
  }
  return things;
}

std::string words_of(const SizeRange& range) {
  constexpr std::array<std::string_view, 3> what{"course edges", "wale edges", "faces with corners"};
  constexpr std::array<std::string_view, 3> units{" w", " h", "\xC2\xB0"};
  const auto of = static_cast<std::size_t>(range.of);
  const auto number = [](double value) { return short_number(std::round(value * 1000.0) / 1000.0); };
  const std::string unit(units.at(of));
  const std::string words(what.at(of));
  if (!std::isfinite(range.from)) return words + " below " + number(range.to) + unit;
  if (!std::isfinite(range.to)) return words + " of " + number(range.from) + unit + " and more";
  return words + " of " + number(range.from) + " to " + number(range.to) + unit;
}

std::optional<SizeRange> size_range_named(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto key = std::find(measured_keys.begin(), measured_keys.end(), text.substr(0, colon));
  if (colon == std::string_view::npos || key == measured_keys.end()) return std::nullopt;
  const std::string_view numbers = text.substr(colon + 1);
  const std::size_t second = numbers.find(':');
  SizeRange range{static_cast<Measured>(key - measured_keys.begin())};
  const auto from = size_number(numbers.substr(0, second));
  if (!from) return std::nullopt;
  range.from = *from;
  if (second == std::string_view::npos) return range;
  const auto to = size_number(numbers.substr(second + 1));
  if (!to || *to <= range.from) return std::nullopt;
  range.to = *to;
  return range;
}

}  // namespace knit
