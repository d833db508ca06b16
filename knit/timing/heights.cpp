#include "knit/timing/heights.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr std::size_t bands = 1024;
constexpr int most_passes = 8;

// A triangle by rising field.
struct Slope {
  std::array<double, 3> value;
  double area = 0.0;
  double widest = 0.0;  // the level line through the middle corner

  // Of the part below `v`.
  [[nodiscard]] double area_below(double v) const {
    if (v <= value[0]) return 0.0;
    if (v >= value[2]) return area;
    const double whole = value[2] - value[0];
    if (v <= value[1]) {
      const double up = v - value[0];
      return area * (up / (value[1] - value[0])) * (up / whole);
    }
    const double down = value[2] - v;
    return area * (1.0 - (down / (value[2] - value[1])) * (down / whole));
  }
  // Of the level line at `v`, within (lowest, highest].
  [[nodiscard]] double length_at(double v) const {
    if (v <= value[1]) return widest * ((v - value[0]) / (value[1] - value[0]));
    return widest * ((value[2] - v) / (value[2] - value[1]));
  }
};

// A level that runs along edges at either end of the field is there whatever rounding says: what is nearer to the end
// than a billionth of the triangle's farthest corner is at it.
void pin_to_ends(std::array<double, 3>& rising) {
  const double far_from_start = rising[2];
  const double far_from_end = 1.0 - rising[0];
  for (double& value : rising) {
    if (!clearly_less(0.0, value, far_from_start)) value = 0.0;
    if (!clearly_less(value, 1.0, far_from_end)) value = 1.0;
  }
}

Slope slope_of(const Input& input, const std::vector<double>& field, Triangle t) {
  Slope slope;
  for (std::size_t i = 0; i < 3; ++i) slope.value[i] = field[t[i]];
  // By rising value; of equals the first stays first.
  for (const std::size_t i : {0U, 1U, 0U}) {
    if (slope.value[i + 1] >= slope.value[i]) continue;
    std::swap(slope.value[i], slope.value[i + 1]);
    std::swap(t[i], t[i + 1]);
  }
  pin_to_ends(slope.value);
  const auto& p = input.mesh.positions;
  slope.area = 0.5 * glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
  const double whole = slope.value[2] - slope.value[0];
  if (whole > 0.0) {
    const double share = (slope.value[1] - slope.value[0]) / whole;
    slope.widest = glm::distance(p[t[1]], p[t[0]] + share * (p[t[2]] - p[t[0]]));
  }
  return slope;
}

struct Bands {
  std::vector<double> area;    // between neighbouring values
  std::vector<double> length;  // of the level at each value
};

// Levels count to the triangles below them, so that one which runs along edges is measured once; the lowest
// is measured from above.
Bands measure_bands(const Input& input, const std::vector<double>& field, const std::vector<double>& values,
                    const Heard& heard) {
  Bands result{std::vector<double>(values.size() - 1, 0.0), std::vector<double>(values.size(), 0.0)};
  for (std::size_t i = 0; i < input.mesh.triangles.size(); ++i) {
    hear_at(heard, i, input.mesh.triangles.size());
    const Slope slope = slope_of(input, field, input.mesh.triangles[i]);
    if (slope.value[2] <= slope.value[0]) continue;
    if (slope.value[1] <= values.front()) result.length.front() += slope.widest;
    const auto after = std::upper_bound(values.begin(), values.end(), slope.value[0]);
    auto band = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - values.begin() - 1, 0));
    double below = 0.0;
    for (; band + 1 < values.size(); ++band) {
      const double top = values[band + 1];
      const double area = slope.area_below(top);
      result.area[band] += area - below;
      below = area;
      if (top > slope.value[2]) break;
      result.length[band + 1] += slope.length_at(top);
      if (top == slope.value[2]) break;
    }
  }
  return result;
}

HeightScale scale_over(const Input& input, const std::vector<double>& field, std::vector<double> values,
                       const Heard& heard) {
  const Bands measured = measure_bands(input, field, values, heard);
  HeightScale scale{std::move(values), {0.0}};
  for (std::size_t i = 0; i < measured.area.size(); ++i) {
    const double around = measured.length[i] + measured.length[i + 1];
    const double height = around > 0.0 ? 2.0 * measured.area[i] / around : 0.0;
    scale.heights.push_back(scale.heights.back() + height);
  }
  return scale;
}

// `y` at `x` where both rise with the index.
double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto after = std::upper_bound(xs.begin(), xs.end(), x);
  if (after == xs.begin()) return ys.front();
  if (after == xs.end()) return ys.back();
  const auto i = static_cast<std::size_t>(after - xs.begin());
  return ys[i - 1] + (ys[i] - ys[i - 1]) * ((x - xs[i - 1]) / (xs[i] - xs[i - 1]));
}

double widest_band(const HeightScale& scale) {
  double widest = 0.0;
  for (std::size_t i = 1; i < scale.heights.size(); ++i)
    widest = std::max(widest, scale.heights[i] - scale.heights[i - 1]);
  return widest;
}

}  // namespace

HeightScale measure_heights(const Input& input, const std::vector<double>& field, const Heard& heard) {
  std::vector<double> even(bands + 1);
  for (std::size_t i = 0; i <= bands; ++i) even[i] = static_cast<double>(i) / bands;
  // Of what is heard each pass is a third of what is left, as nobody knows how many there will be.
  double heard_until = 1.0 / 3.0;
  HeightScale scale = scale_over(input, field, even, part_of(heard, 0.0, heard_until));
  // A level set that grows like a pole's is steep in one variable and flat in the other: again, with bands of
  // equal height, until they are about that.
  for (int pass = 0; pass < most_passes && (pass < 2 || widest_band(scale) > 2.0 * scale.total() / bands);
       ++pass) {
    std::vector<double> values{0.0};
    for (std::size_t i = 1; i < bands; ++i) {
      const double value = value_at(scale, scale.total() * static_cast<double>(i) / bands);
      if (value > values.back() && value < 1.0) values.push_back(value);
    }
    values.push_back(1.0);
    const double from = std::exchange(heard_until, heard_until + (1.0 - heard_until) / 3.0);
    scale = scale_over(input, field, std::move(values), part_of(heard, from, heard_until));
  }
  return scale;
}

double height_at(const HeightScale& scale, double value) {
  return interpolate(scale.values, scale.heights, value);
}

double value_at(const HeightScale& scale, double height) {
  return interpolate(scale.heights, scale.values, height);
}

}  // namespace knit
