#include "knit/short_rows/tube_chart.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/model/words.h"
#include "knit/short_rows/annulus.h"
#include "knit/short_rows/chart_mirror.h"

namespace knit {

namespace {

constexpr std::size_t retimings = 4, levels_of_retiming = 400;
constexpr std::int32_t columns_of_retiming = 128;
constexpr double levels_a_stitch = 8.0;
constexpr double rim_margin = 1e-7;  // of the time: a level on a rim is taken this far inside

// A row of points a level, of points on every column.
struct Samples {
  std::size_t columns = 0;
  std::vector<glm::dvec3> points;
  [[nodiscard]] std::size_t levels() const { return points.size() / columns; }
  [[nodiscard]] const glm::dvec3& at(std::size_t level, std::size_t column) const {
    return points[level * columns + column % columns];
  }
};

struct Crossing {
  double angle;  // in [0, 1)
  glm::dvec3 point;
};

// Where the levels cross the sides of triangles, by angle.
std::vector<std::vector<Crossing>> crossings_of(const TubePart& part, const AnnulusFields& fields,
                                                const std::vector<double>& levels) {
  std::vector<std::vector<Crossing>> crossings(levels.size());
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      // Upwards: an inner side is crossed so in one of its two triangles.
      const std::size_t l = (k + 1) % 3;
      const VertexId a = part.triangles[t][k], b = part.triangles[t][l];
      const double from = fields.time[a], to = fields.time[b];
      if (from >= to) continue;
      const auto first = std::upper_bound(levels.begin(), levels.end(), from),
                 last = std::upper_bound(first, levels.end(), to);
      for (auto at = first; at != last; ++at) {
        const double share = (*at - from) / (to - from);
        const double angle = (1.0 - share) * fields.angle[t][k] + share * fields.angle[t][l];
        crossings[static_cast<std::size_t>(at - levels.begin())].push_back(
            {std::min(angle - std::floor(angle), 1.0 - 1e-16),
             (1.0 - share) * part.points[a] + share * part.points[b]});
      }
    }
  }
  for (auto& level : crossings) {
    std::stable_sort(level.begin(), level.end(),
                     [](const Crossing& a, const Crossing& b) { return a.angle < b.angle; });
  }
  return crossings;
}

// Empty where a level crosses nothing.
Samples sample(const TubePart& part, const AnnulusFields& fields, std::vector<double> levels,
               std::size_t columns) {
  for (double& level : levels) level = std::clamp(level, rim_margin, 1.0 - rim_margin);
  Samples samples{columns, {}};
  samples.points.reserve(levels.size() * columns);
  for (const std::vector<Crossing>& level : crossings_of(part, fields, levels)) {
    if (level.empty()) return {columns, {}};
    std::size_t next = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      const double angle = static_cast<double>(j) / static_cast<double>(columns);
      while (next < level.size() && level[next].angle < angle) ++next;
      const Crossing& after = level[next < level.size() ? next : 0];
      const Crossing& before = level[next > 0 ? next - 1 : level.size() - 1];
      const double gap = after.angle - before.angle + (next == 0 || next == level.size() ? 1.0 : 0.0);
      const double along = angle - before.angle + (next == 0 ? 1.0 : 0.0);
      const double share = gap > 0.0 ? along / gap : 0.0;
      samples.points.push_back((1.0 - share) * before.point + share * after.point);
    }
  }
  return samples;
}

// Of each level, the mean length of the columns from the low rim on, by how wide they are.
std::vector<double> mean_heights(const Samples& samples) {
  std::vector<double> heights{0.0};
  for (std::size_t l = 0; l + 1 < samples.levels(); ++l) {
    double sum = 0.0, widths = 0.0;
    for (std::size_t j = 0; j < samples.columns; ++j) {
      const double width = glm::length(samples.at(l, j + 1) - samples.at(l, j)) +
                           glm::length(samples.at(l + 1, j + 1) - samples.at(l + 1, j));
      sum += width * glm::length(samples.at(l + 1, j) - samples.at(l, j));
      widths += width;
    }
    heights.push_back(heights.back() + sum / widths);
  }
  return heights;
}

// Where a rising function of `at` has each of `count` values spread evenly from its first to its last.
std::vector<double> spread(const std::vector<double>& rising, const std::vector<double>& at,
                           std::size_t count) {
  std::vector<double> result;
  std::size_t next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = rising.back() * static_cast<double>(i) / static_cast<double>(count - 1);
    while (next + 1 < rising.size() && rising[next] < value) ++next;
    const double step = rising[next] - rising[next - 1];
    const double share = step > 0.0 ? std::clamp((value - rising[next - 1]) / step, 0.0, 1.0) : 0.0;
    result.push_back((1.0 - share) * at[next - 1] + share * at[next]);
  }
  return result;
}

bool is_finite(const Samples& samples) {
  return std::all_of(samples.points.begin(), samples.points.end(), [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

std::vector<double> column_lengths(const Samples& samples) {
  std::vector<double> heights(samples.columns, 0.0);
  heights.reserve(samples.points.size());
  for (std::size_t l = 1; l < samples.levels(); ++l) {
    for (std::size_t j = 0; j < samples.columns; ++j) {
      heights.push_back(heights[(l - 1) * samples.columns + j] +
                        glm::length(samples.at(l, j) - samples.at(l - 1, j)));
    }
  }
  return heights;
}

// A level between two of the chart's.
struct Between {
  std::size_t below;
  double share;
};
Between between(const TubeChart& chart, double level) {
  const double inside = std::clamp(level, 0.0, chart.last_level());
  const double below = std::min(std::floor(inside), chart.last_level() - 1.0);
  return {static_cast<std::size_t>(below), inside - below};
}

}  // namespace

std::string sentence_of(const ChartRefusal& refusal) {
  if (refusal.reason == ChartRefusal::Reason::not_solved)
    return "no short rows: the equations of this tube's chart cannot be solved; repair triangles without "
           "area";
  return "no short rows: this tube's chart is off by " + percent_text(refusal.residual) + ", and at most " +
         percent_text(greatest_residual) + " is right; a finer mesh near its short loops helps";
}

std::variant<TubeChart, ChartRefusal> make_tube_chart(const TubePart& part, double stitch_height,
                                                      std::int32_t columns, const Heard& heard) {
  using Reason = ChartRefusal::Reason;
  const std::optional<AnnulusFields> fields = solve_annulus(part, part_of(heard, 0.0, 0.6));
  if (!fields) return ChartRefusal{Reason::not_solved, 0.0};
  if (!(fields->residual <= greatest_residual)) return ChartRefusal{Reason::residual, fields->residual};

  std::vector<double> times(levels_of_retiming), heights(levels_of_retiming);
  for (std::size_t i = 0; i < times.size(); ++i)
    heights[i] = times[i] = static_cast<double>(i) / static_cast<double>(levels_of_retiming - 1);
  for (std::size_t round = 0; round < retimings; ++round) {
    hear(heard, 0.6 + 0.08 * static_cast<double>(round));
    const Samples samples = sample(part, *fields, times, columns_of_retiming);
    if (samples.points.empty() || !is_finite(samples)) return ChartRefusal{Reason::not_solved, 0.0};
    heights = mean_heights(samples);
    if (round + 1 < retimings) times = spread(heights, times, times.size());
  }
  const double levels = std::ceil(heights.back() / stitch_height * levels_a_stitch) + 1.0;
  hear(heard, 0.92);
  TubeChart chart;
  chart.columns = columns;
  chart.times = spread(heights, times, std::max<std::size_t>(2, static_cast<std::size_t>(levels)));
  Samples samples = sample(part, *fields, chart.times, static_cast<std::size_t>(columns));
  if (samples.points.empty() || !is_finite(samples)) return ChartRefusal{Reason::not_solved, 0.0};
  chart.heights = column_lengths(samples);
  chart.points = std::move(samples.points);
  chart.mean_height = heights.back();
  chart.residual = fields->residual;
  chart.mirror = mirror_of(chart, stitch_height);
  hear(heard, 1.0);
  return chart;
}

glm::dvec3 point_at(const TubeChart& chart, double level, double column) {
  const auto [below, up] = between(chart, level);
  const auto count = static_cast<std::size_t>(chart.columns);
  const double floor = std::floor(column), across = column - floor;
  const double wrapped = floor - std::floor(floor / chart.columns) * chart.columns;
  const std::size_t j = static_cast<std::size_t>(wrapped) % count, k = (j + 1) % count;
  const glm::dvec3 *const low = &chart.points[below * count], *const high = low + count;
  return (1.0 - up) * ((1.0 - across) * low[j] + across * low[k]) +
         up * ((1.0 - across) * high[j] + across * high[k]);
}

std::vector<double> heights_at(const TubeChart& chart, double level) {
  const auto [below, up] = between(chart, level);
  const auto count = static_cast<std::size_t>(chart.columns);
  std::vector<double> result;
  result.reserve(count);
  for (std::size_t j = 0; j < count; ++j) {
    result.push_back((1.0 - up) * chart.heights[below * count + j] +
                     up * chart.heights[(below + 1) * count + j]);
  }
  return result;
}

Ring ring_at(const TubeChart& chart, double level, double first_column) {
  Ring ring;
  ring.ordered_by = OrderedBy::cut;
  for (std::int32_t j = 0; j < chart.columns; ++j)
    ring.points.push_back(point_at(chart, level, first_column + static_cast<double>(j)));
  measure_arcs(ring);
  return ring;
}

double column_of(const TubeChart& chart, const Ring& ring, double first_column, double arc) {
  const double wrapped = std::clamp(arc, 0.0, ring.length);
  const auto after = std::upper_bound(ring.arc.begin(), ring.arc.end(), wrapped);
  const auto i = static_cast<std::size_t>(after - ring.arc.begin()) - 1;
  const double end = after == ring.arc.end() ? ring.length : *after;
  const double share = end > ring.arc[i] ? (wrapped - ring.arc[i]) / (end - ring.arc[i]) : 0.0;
  return first_column + std::min(static_cast<double>(i) + share, static_cast<double>(chart.columns));
}

}  // namespace knit
