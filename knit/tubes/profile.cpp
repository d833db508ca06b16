// How high the tubes of a graph are, and how long their curves: a sum over triangles, exact in each.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "knit/tubes/graph.h"

namespace knit {

namespace {

constexpr std::size_t quantiles_of_profile = 96;
constexpr std::size_t steps_of_profile = 48;
constexpr std::size_t steps_at_ends = 12;
// Of a band: its curves are measured so far inside, so that a flat end counts alike whatever rounding makes of it.
constexpr double just_inside = 1e-6;
// Of a tube's range: values nearer to each other than this are one.
constexpr double least_step_of_profile = 1e-9;

struct ProfileSpan {
  double low = 0.0, high = 0.0;  // values of the tube's ends
  std::uint32_t bottom_rank = 0, top_rank = 0;
};

ProfileSpan profile_span(const TubeGraph& graph, std::int32_t tube) {
  const auto& [bottom, top] = graph.tubes[static_cast<std::size_t>(tube)];
  const GraphNode& below = graph.nodes[static_cast<std::size_t>(bottom)];
  const GraphNode& above = graph.nodes[static_cast<std::size_t>(top)];
  return {below.value, above.value, graph.surface.rank[below.vertex], graph.surface.rank[above.vertex]};
}

// A triangle by its corners' values, and what of it lies below a value.
class RisingTriangle {
 public:
  RisingTriangle(const MorseSurface& surface, const std::array<VertexId, 3>& rising) {
    const glm::dvec3& a = surface.positions[rising[0]];
    const glm::dvec3 to_middle = surface.positions[rising[1]] - a;
    const glm::dvec3 to_high = surface.positions[rising[2]] - a;
    low_ = surface.values[rising[0]];
    middle_ = surface.values[rising[1]];
    high_ = surface.values[rising[2]];
    area_ = 0.5 * glm::length(glm::cross(to_middle, to_high));
    if (high_ > low_) widest_ = glm::length(to_middle - (middle_ - low_) / (high_ - low_) * to_high);
  }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  // Requires low <= value < high: just above the value, where that is a corner's.
  [[nodiscard]] double length_at(double value) const {
    return value < middle_ ? widest_ * ((value - low_) / (middle_ - low_))
                           : widest_ * ((high_ - value) / (high_ - middle_));
  }
  // Requires low <= value <= high, not all the same.
  [[nodiscard]] double area_below(double value) const {
    if (value <= low_) return 0.0;
    if (value <= middle_)
      return area_ * ((value - low_) / (high_ - low_)) * ((value - low_) / (middle_ - low_));
    if (value >= high_) return area_;
    return area_ * (1.0 - (high_ - value) / (high_ - low_) * ((high_ - value) / (high_ - middle_)));
  }

 private:
  double low_ = 0.0, middle_ = 0.0, high_ = 0.0;
  double area_ = 0.0;
  double widest_ = 0.0;  // the length of its level line at the middle value
};

// The corners of each triangle that the tube has a piece of, by rank.
std::vector<std::array<VertexId, 3>> rising_triangles(const TubeGraph& graph, std::int32_t tube) {
  const MorseSurface& surface = graph.surface;
  const auto number = static_cast<std::size_t>(tube);
  std::vector<std::array<VertexId, 3>> triangles;
  triangles.reserve(graph.first_piece[number + 1] - graph.first_piece[number]);
  for (std::uint32_t i = graph.first_piece[number]; i < graph.first_piece[number + 1]; ++i) {
    Triangle t = surface.triangles[graph.pieces[i].triangle];
    for (const std::size_t k : {0U, 1U, 0U})
      if (surface.rank[t[k + 1]] < surface.rank[t[k]]) std::swap(t[k], t[k + 1]);
    triangles.push_back(t);
  }
  return triangles;
}

// Ranks within the tube, each once and rising: by ticking them off where they lie close, as those of a large tube do.
void put_in_order(std::vector<std::uint32_t>& ranks, const ProfileSpan& span) {
  constexpr std::size_t close = 16;
  if ((span.top_rank - span.bottom_rank) / close > ranks.size()) {
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    return;
  }
  std::vector<std::uint8_t> met(span.top_rank - span.bottom_rank, 0);
  for (const std::uint32_t rank : ranks) met[rank - span.bottom_rank] = 1;
  ranks.clear();
  for (std::uint32_t i = 0; i < met.size(); ++i)
    if (met[i] != 0) ranks.push_back(span.bottom_rank + i);
}

// Of the vertices within the tube, rising. Each is the middle of two triangles, as none of them is critical.
std::vector<double> values_within(const MorseSurface& surface, const ProfileSpan& span,
                                  const std::vector<std::array<VertexId, 3>>& triangles) {
  std::vector<std::uint32_t> ranks;
  ranks.reserve(triangles.size());
  for (const auto& t : triangles) {
    const std::uint32_t rank = surface.rank[t[1]];
    if (rank > span.bottom_rank && rank < span.top_rank) ranks.push_back(rank);
  }
  put_in_order(ranks, span);
  std::vector<double> values;
  // Equal ones count once: how many vertices of a flat part are within hangs on rounding.
  const double least = least_step_of_profile * (span.high - span.low);
  double last = span.low;
  for (const std::uint32_t rank : ranks) {
    const double value = surface.values[surface.by_rank[rank]];
    if (value - last <= least || span.high - value <= least) continue;
    values.push_back(value);
    last = value;
  }
  return values;
}

// Where the profile is taken; `within` rises.
std::vector<double> profile_values(const ProfileSpan& span, const std::vector<double>& within) {
  std::vector<double> values{span.low, span.high};
  for (std::size_t i = 0; i < quantiles_of_profile && !within.empty(); ++i) {
    const std::size_t place = i * (within.size() - 1);
    const std::size_t at = place / (quantiles_of_profile - 1);
    const double share = static_cast<double>(place % (quantiles_of_profile - 1)) / (quantiles_of_profile - 1);
    const double next = within[std::min(at + 1, within.size() - 1)];
    values.push_back(within[at] + share * (next - within[at]));
  }
  const double range = span.high - span.low;
  for (std::size_t i = 1; i + 1 < steps_of_profile; ++i)
    values.push_back(span.low + range * (static_cast<double>(i) / (steps_of_profile - 1)));
  // Round a pole height grows as the root of the value: closer together there, so that rows between may be interpolated.
  for (std::size_t i = 1; i < steps_at_ends; ++i) {
    const double share = static_cast<double>(i) / steps_at_ends;
    const double in = share * share * range / (steps_of_profile - 1);
    values.insert(values.end(), {span.low + in, span.high - in});
  }
  for (double& value : values) value = std::clamp(value, span.low, span.high);
  std::sort(values.begin(), values.end());
  std::vector<double> kept{span.low};
  for (const double value : values)
    if (value - kept.back() > least_step_of_profile * range) kept.push_back(value);
  if (kept.size() < 2) kept.push_back(span.high);
  kept.back() = span.high;
  return kept;
}

// Between two values: the area, and the lengths of the curves just above the lower and just below the higher one.
struct ProfileBand {
  double area = 0.0, low_length = 0.0, high_length = 0.0;
  // Exact where lengths grow evenly with height, as round a pole: there the curve midway in value would be too long.
  [[nodiscard]] double height() const {
    const double length = low_length + high_length;
    return length > 0.0 ? 2.0 * area / length : 0.0;
  }
};

// The band that a value lies in, found from where the one before lay: triangles come rising, so that is mostly the same.
std::size_t band_of_value(const std::vector<double>& values, double value, std::size_t before) {
  if (values[before] > value)
    return static_cast<std::size_t>(std::upper_bound(values.begin(), values.end(), value) - values.begin()) -
           1;
  while (before + 1 < values.size() && values[before + 1] <= value) ++before;
  return before;
}

// Adds a triangle's part of each band, and the lengths of its level lines midway. `band`: where the triangle before began.
void add_to_profile(const RisingTriangle& triangle, TubeProfile& profile, std::vector<ProfileBand>& bands,
                    std::size_t& band) {
  const std::vector<double>& values = profile.values;
  const double low = std::max(triangle.low(), values.front());
  const double high = std::min(triangle.high(), values.back());
  if (!(low < high)) return;
  band = band_of_value(values, low, band);
  double below = triangle.area_below(low);
  for (std::size_t i = band; values[i] < high; ++i) {
    const double below_next = triangle.area_below(std::min(values[i + 1], high));
    bands[i].area += below_next - below;
    below = below_next;
    const double inside = just_inside * (values[i + 1] - values[i]);
    const double from = values[i] + inside, to = values[i + 1] - inside;
    if (low <= from && from < high) bands[i].low_length += triangle.length_at(from);
    if (low <= to && to < high) bands[i].high_length += triangle.length_at(to);
    const double midway = 0.5 * (values[i] + values[i + 1]);
    if (low <= midway && midway < high) profile.lengths[i] += triangle.length_at(midway);
  }
}

}  // namespace

double TubeProfile::longest() const { return *std::max_element(lengths.begin(), lengths.end()); }

TubeProfile profile_of(const TubeGraph& graph, std::int32_t tube, const Heard& heard) {
  const ProfileSpan span = profile_span(graph, tube);
  if (!(span.low < span.high)) return {{span.low, span.high}, {0.0, 0.0}, {0.0}};
  const std::vector<std::array<VertexId, 3>> triangles = rising_triangles(graph, tube);
  TubeProfile profile;
  hear(heard, 0.2);
  profile.values = profile_values(span, values_within(graph.surface, span, triangles));
  profile.lengths.assign(profile.values.size() - 1, 0.0);
  std::vector<ProfileBand> bands(profile.lengths.size());
  const Heard rest = part_of(heard, 0.4, 1.0);
  std::size_t began = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    hear_at(rest, i, triangles.size());
    add_to_profile(RisingTriangle(graph.surface, triangles[i]), profile, bands, began);
  }
  profile.heights.push_back(0.0);
  for (const ProfileBand& band : bands) profile.heights.push_back(profile.heights.back() + band.height());
  return profile;
}

}  // namespace knit
