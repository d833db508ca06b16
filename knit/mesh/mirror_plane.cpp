#include "knit/mesh/mirror_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "knit/mesh/elementary.h"

namespace knit {

namespace {

constexpr std::size_t samples = 24'000;
constexpr std::size_t whole_stride = 12, first_look_stride = 48;

struct Strewn {
  std::vector<glm::dvec3> places;
  double area = 0.0;
};

Strewn strewn_over(const Mesh& mesh) {
  std::vector<double> up_to;
  Strewn strewn;
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    strewn.area += glm::length(glm::cross(b - a, c - a)) / 2.0;
    up_to.push_back(strewn.area);
  }
  if (!(strewn.area > 0.0)) return strewn;
  constexpr double plastic = 1.32471795724474602596;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto number = static_cast<double>(i);
    const double target = strewn.area * (number + 0.5) / static_cast<double>(samples);
    while (triangle + 1 < up_to.size() && up_to[triangle] < target) ++triangle;
    double u = number / plastic - std::floor(number / plastic);
    const double second = number / (plastic * plastic);
    double v = second - std::floor(second);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const Triangle& t = mesh.triangles[triangle];
    const glm::dvec3& a = mesh.positions[t[0]];
    strewn.places.push_back(a + u * (mesh.positions[t[1]] - a) + v * (mesh.positions[t[2]] - a));
  }
  return strewn;
}

// The nearest of many places: halved by the longest side of their box, over and over, down to a handful.
class NearestSample {
 public:
  explicit NearestSample(std::vector<glm::dvec3> places) : places_(std::move(places)) {
    part(0, places_.size());
  }
  [[nodiscard]] double distance_to(const glm::dvec3& place) const {
    double square = std::numeric_limits<double>::infinity();
    look(0, places_.size(), 0, place, square);
    return std::sqrt(square);
  }

 private:
  static constexpr std::size_t handful = 8;
  struct Node {
    glm::length_t across = 0;
    double at = 0.0;
    std::size_t second_half = 0;  // its node
  };

  std::size_t part(std::size_t begin, std::size_t end) {
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    if (end - begin <= handful) return node;
    glm::dvec3 low = places_[begin], high = places_[begin];
    for (std::size_t i = begin; i < end; ++i) {
      low = glm::min(low, places_[i]);
      high = glm::max(high, places_[i]);
    }
    const glm::dvec3 side = high - low;
    const glm::length_t across = side.x >= side.y && side.x >= side.z ? 0 : (side.y >= side.z ? 1 : 2);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return places_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(begin), at(end), [&](const glm::dvec3& a, const glm::dvec3& b) {
      if (a[across] != b[across]) return a[across] < b[across];
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    nodes_[node].across = across;
    nodes_[node].at = places_[middle][across];
    part(begin, middle);
    const std::size_t second = part(middle, end);
    nodes_[node].second_half = second;
    return node;
  }

  void look(std::size_t begin, std::size_t end, std::size_t number, const glm::dvec3& place,
            double& square) const {
    if (end - begin <= handful) {
      for (std::size_t i = begin; i < end; ++i) {
        const glm::dvec3 d = places_[i] - place;
        square = std::min(square, glm::dot(d, d));
      }
      return;
    }
    const Node& node = nodes_[number];
    const std::size_t middle = (begin + end) / 2;
    const double beyond = place[node.across] - node.at;
    const auto first = [&] { look(begin, middle, number + 1, place, square); };
    const auto second = [&] { look(middle, end, node.second_half, place, square); };
    if (beyond < 0.0) {
      first();
      if (beyond * beyond < square) second();
    } else {
      second();
      if (beyond * beyond < square) first();
    }
  }

  std::vector<glm::dvec3> places_;
  std::vector<Node> nodes_;
};

// Planes by their number: every 2 degrees.
class Planes {
 public:
  static constexpr std::size_t count = 90;
  Planes(const std::vector<glm::dvec3>& places, const glm::dvec3& axis, const glm::dvec3& right)
      : places_(places), nearest_(places), right_(right), ahead_(glm::cross(right, axis)) {
    for (const glm::dvec3& place : places) middle_ += place;
    middle_ /= static_cast<double>(places.size());
  }
  [[nodiscard]] MirrorPlane plane(std::size_t number) const {
    const double angle = static_cast<double>(number) * 2.0 * std::numbers::pi / 180.0;
    const double c = cosine(angle), s = sine(angle);
    const glm::dvec3 back = c * right_ - s * ahead_;
    return {middle_, glm::normalize(c * ahead_ + s * right_),
            glm::normalize(glm::dot(back, right_) < 0.0 ? -back : back)};
  }
  // Infinite once it is more than `most`.
  [[nodiscard]] double apart(std::size_t number, std::size_t stride, double most) const {
    const MirrorPlane mirror = plane(number);
    const std::size_t reflected = (places_.size() + stride - 1) / stride;
    const auto taken = static_cast<double>(reflected);
    double sum = 0.0;
    for (std::size_t i = 0; i < places_.size(); i += stride) {
      sum += nearest_.distance_to(mirror.reflect(places_[i]));
      if (sum > most * taken) return std::numeric_limits<double>::infinity();
    }
    return sum / taken;
  }

 private:
  const std::vector<glm::dvec3>& places_;
  NearestSample nearest_;
  glm::dvec3 right_, ahead_, middle_{0.0};
};

}  // namespace

std::optional<MirrorMeasure> measure_mirror(const Mesh& mesh, const glm::dvec3& axis,
                                            const glm::dvec3& right) {
  constexpr double looks_alike = 1.1, is_alike = 1.02;
  constexpr std::size_t most_measured = 12;
  const Strewn strewn = strewn_over(mesh);
  if (strewn.places.empty()) return std::nullopt;
  const Planes planes(strewn.places, axis, right);
  std::array<double, Planes::count> looks{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < Planes::count; ++i) {
    looks[i] = planes.apart(i, first_look_stride, looks_alike * least);
    least = std::min(least, looks[i]);
  }
  double best = std::numeric_limits<double>::infinity();
  std::vector<std::pair<std::size_t, double>> measured;
  for (std::size_t i = 0; i < Planes::count && measured.size() < most_measured; ++i) {
    if (looks[i] > looks_alike * least) continue;
    measured.emplace_back(i, planes.apart(i, whole_stride, is_alike * best));
    best = std::min(best, measured.back().second);
  }
  const auto first = std::find_if(measured.begin(), measured.end(),
                                  [&](const auto& plane) { return plane.second <= is_alike * best; });
  MirrorMeasure found;
  found.degrees = 2.0 * static_cast<double>(first->first);
  found.apart = first->second;
  found.chance = std::sqrt(strewn.area / static_cast<double>(samples)) / 2.0;
  found.plane = planes.plane(first->first);
  return found;
}

std::optional<MirrorPlane> find_mirror_plane(const Mesh& mesh, const glm::dvec3& axis,
                                             const glm::dvec3& right) {
  const std::optional<MirrorMeasure> found = measure_mirror(mesh, axis, right);
  if (!found || !found->is_mirror()) return std::nullopt;
  return found->plane;
}

}  // namespace knit
