#include "knit/quality/quality.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "knit/mesh/elementary.h"
#include "knit/mesh/ranking.h"
#include "knit/quality/mirror.h"

namespace knit {

namespace {

constexpr std::size_t long_row = 12;  // shorter ones are all curvature

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

struct Stop {
  glm::dvec3 position{0.0};
  glm::dvec3 tangent{0.0};  // of its row, towards the next stitch
  std::size_t in_row = 0;   // the row's number of stitches
};

// The stitches along the knitting path.
std::vector<Stop> stops_of(const State& state) {
  std::vector<Stop> stops;
  std::size_t deal = 0;
  const auto& deals = state.fabric.deals();
  for (const auto& row : state.fabric.rows()) {
    const std::size_t n = row->stitches.size();
    const bool back = works_back(*row);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = back ? n - 1 - k : k;
      const glm::dvec3 along = after(*row, i).position - before(*row, i).position;
      stops.push_back({row->stitches[i].position, unit(along), n});
    }
    // A bridge stands in no row; it is short.
    for (; deal < deals.size() && deals[deal]->after == row->id; ++deal) {
      for (const Stitch& stitch : deals[deal]->bridge)
        stops.push_back({stitch.position, glm::dvec3(0.0), deals[deal]->bridge.size()});
    }
  }
  return stops;
}

std::vector<double> course_lengths(const Row& row, double width) {
  std::vector<double> lengths;
  for (const auto& [from, to] : edges_of(row))
    lengths.push_back(glm::distance(row.stitches[from].position, row.stitches[to].position) / width);
  return lengths;
}

void measure_courses(Quality& quality, const State& state) {
  std::vector<double> all;
  std::vector<double> in_long_rows;
  double longest = 0.0;
  for (const auto& row : state.fabric.rows()) {
    const std::vector<double> lengths = course_lengths(*row, quality.stitch_width);
    all.insert(all.end(), lengths.begin(), lengths.end());
    if (lengths.size() >= long_row) in_long_rows.insert(in_long_rows.end(), lengths.begin(), lengths.end());
    RowFit fit;
    fit.row = row->id;
    fit.stitches = size_of(*row);
    fit.length = row->ring ? row->ring->length : 0.0;
    if (is_short(*row)) fit.length += quality.stitch_width;  // from end to end, and half a stitch beyond each
    fit.ideal = fit.length / quality.stitch_width;
    fit.course_cv = figures_of(lengths).cv;
    if (fit.course_cv > quality.worst_course_cv_in_row) quality.uneven_row = row->id;
    quality.worst_course_cv_in_row = std::max(quality.worst_course_cv_in_row, fit.course_cv);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (lengths[i] <= longest) continue;
      longest = lengths[i];
      quality.longest_course = {row->id, static_cast<std::int32_t>(i)};
    }
    quality.rows.push_back(fit);
  }
  quality.course = spread_of(all, 0.0, 2.0, 40);
  quality.long_course = spread_of(in_long_rows, 0.0, 2.0, 40);
}

double along_rows(const Stop& lower, const Stop& upper) {
  return std::abs(glm::dot(upper.position - lower.position, unit(lower.tangent + upper.tangent)));
}

void measure_wales(Quality& quality, const State& state, const std::vector<Stop>& stops) {
  std::vector<double> lengths;
  double longest = 0.0;
  const auto measure = [&](RowId row, const std::vector<std::array<std::uint32_t, 2>>& column_edges) {
    EdgeAt at{row, -1};
    for (const auto& [p, q] : column_edges) {
      ++at.edge;
      const Stop& lower = stops[p];
      const Stop& upper = stops[q];
      lengths.push_back(glm::distance(lower.position, upper.position) / quality.stitch_height);
      if (lengths.back() > longest) quality.longest_wale = at;
      longest = std::max(longest, lengths.back());
      const double offset = along_rows(lower, upper) / quality.stitch_width;
      if (offset > quality.offset) quality.leans_most = at;
      quality.offset = std::max(quality.offset, offset);
      if (std::min(lower.in_row, upper.in_row) >= long_row) {
        quality.long_offset = std::max(quality.long_offset, offset);
      }
    }
  };
  for (const auto& strip : state.fabric.strips()) measure(strip->to, strip->column_edges);
  std::int32_t number = 0;
  for (const auto& deal : state.fabric.deals()) measure(bridge_row(++number), deal->column_edges);
  quality.wale = spread_of(lengths, 0.0, 2.0, 40);
}

void measure_tubes(Quality& quality, const State& state, const std::vector<Stop>& stops) {
  std::vector<std::vector<double>> wales;
  std::vector<std::size_t> tube_of(static_cast<std::size_t>(state.fabric.next_row()),
                                   0);  // by a row's number
  for (std::size_t i = 0; i < quality.rows.size(); ++i) {
    const RowFit& fit = quality.rows[i];
    const TubeId tube = state.fabric.row(fit.row).tube;
    if (quality.tubes.empty() || quality.tubes.back().tube != tube)
      quality.tubes.push_back({tube, fit.row, 0, 0, 0, 0.0, 0.0, 0.0, {}, 0});
    TubeFit& of = quality.tubes.back();
    of.rounds += is_short(state.fabric.row(fit.row)) ? 0 : 1;
    of.stitches += fit.stitches;
    if (fit.course_cv > of.worst_course_cv_in_row) of.uneven_row = fit.row;
    of.worst_course_cv_in_row = std::max(of.worst_course_cv_in_row, fit.course_cv);
    tube_of[static_cast<std::size_t>(fit.row)] = quality.tubes.size();
  }
  wales.resize(quality.tubes.size());
  for (const auto& strip : state.fabric.strips()) {
    const std::size_t tube = tube_of[static_cast<std::size_t>(strip->to)];
    if (tube == 0) continue;
    TubeFit& of = quality.tubes[tube - 1];
    EdgeAt at{strip->to, -1};
    for (const auto& [lower, upper] : strip->column_edges) {
      ++at.edge;
      wales[tube - 1].push_back(glm::distance(stops[lower].position, stops[upper].position) /
                                quality.stitch_height);
      if (wales[tube - 1].back() <= of.longest_wale) continue;
      of.longest_wale = wales[tube - 1].back();
      of.longest = at;
    }
  }
  for (std::size_t i = 0; i < wales.size(); ++i) {
    const LengthFigures figures = figures_of(wales[i]);
    quality.tubes[i].wales = figures.count;
    quality.tubes[i].wale_cv = figures.cv;
  }
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return angle_to(glm::dot(a, b), glm::length(glm::cross(a, b))) * 180.0 / std::numbers::pi;
}

void measure_corners(Quality& quality, const State& state) {
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  std::vector<double> angles, off;
  for (const auto& strip : state.fabric.strips()) {
    for (const Face& face : strip->faces) {
      const auto n = static_cast<std::size_t>(face.corner_count);
      const std::array<double, 4> of_face = corner_angles(face, path);
      for (std::size_t i = 0; i < n; ++i) {
        angles.push_back(of_face.at(i));
        if (n == 4) off.push_back(std::abs(angles.back() - 90.0));
      }
    }
  }
  quality.corner = spread_of(angles, 0.0, 180.0, 36);
  quality.corner_off = spread_of(off, 0.0, 90.0, 18);
}

// Of the stitches that have a strip below and one above.
double regular_share(const State& state, std::size_t stitches) {
  if (state.fabric.strips().size() < 2) return 0.0;
  std::vector<std::int32_t> up(stitches, 0);
  std::vector<std::int32_t> down(stitches, 0);
  for (const auto& strip : state.fabric.strips()) {
    for (const auto& [lower, upper] : strip->column_edges) {
      ++up[lower];
      ++down[upper];
    }
  }
  std::size_t regular = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < stitches; ++i) {
    all += up[i] > 0 && down[i] > 0 ? 1 : 0;
    regular += up[i] == 1 && down[i] == 1 ? 1 : 0;
  }
  return all > 0 ? static_cast<double>(regular) / static_cast<double>(all) : 0.0;
}

Histogram histogram_of(std::span<const double> values, double low, double high, std::size_t bins) {
  Histogram histogram{low, high, std::vector<std::size_t>(bins, 0)};
  if (bins == 0) return histogram;
  const auto last = static_cast<double>(bins - 1);
  for (const double value : values) {
    const double bin = std::floor((value - low) / (high - low) * static_cast<double>(bins));
    // Written so that what is no number has a bin too.
    ++histogram.bins[bin > 0.0 ? static_cast<std::size_t>(std::min(bin, last)) : 0];
  }
  return histogram;
}

}  // namespace

std::array<double, 4> corner_angles(const Face& face, std::span<const glm::dvec3> path) {
  const auto n = static_cast<std::size_t>(face.corner_count);
  std::array<double, 4> angles{};
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3& corner = path[face.corners[i]];
    angles.at(i) = degrees_between(path[face.corners[(i + 1) % n]] - corner,
                                   path[face.corners[(i + n - 1) % n]] - corner);
  }
  return angles;
}

Spread spread_of(std::span<const double> values, double histogram_low, double histogram_high,
                 std::size_t bins) {
  const LengthFigures figures = figures_of(values);
  Spread spread{figures.count, figures.mean, figures.cv, figures.low, figures.high, 0.0, {}};
  spread.histogram = histogram_of(values, histogram_low, histogram_high, bins);
  if (values.empty()) return spread;
  std::vector<double> ranked(values.begin(), values.end());
  const std::size_t rank = (95 * ranked.size() + 99) / 100;  // from 1
  put_least_first(std::span(ranked), rank - 1, std::less<>());
  spread.p95 = ranked[rank - 1];
  return spread;
}

Quality measure_quality(const Input& input, const State& state, double stitch_width, double stitch_height) {
  Quality quality;
  quality.stitch_width = stitch_width;
  quality.stitch_height = stitch_height;
  quality.steady_shaping =
      static_cast<std::int32_t>(std::ceil(2.0 * std::numbers::pi * stitch_height / stitch_width));
  measure_courses(quality, state);
  quality.shaping = shaping_figures(state);
  quality.most_shaped_row = most_shaped_row(state);
  const std::vector<Stop> stops = stops_of(state);
  measure_wales(quality, state, stops);
  measure_tubes(quality, state, stops);
  measure_corners(quality, state);
  quality.faces = count_faces(state);
  const std::size_t faces = quality.faces.quads + quality.faces.triangles;
  if (faces > 0) quality.quad_share = static_cast<double>(quality.faces.quads) / static_cast<double>(faces);
  quality.regular_share = regular_share(state, stops.size());
  quality.mirror = mirror_error(input, state, stitch_width);
  return quality;
}

}  // namespace knit
