#include "knit/settle/cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "knit/mesh/surface_area.h"
#include "knit/mesh/triangle_tree.h"

namespace knit {

namespace {

constexpr double finest = 0.5;      // edge, in w
constexpr double finest_of = 0.1;   // and in the side of a square as large as the surface has for a stitch
constexpr double bends_from = 0.3;  // how far outside its neighbours' middle, in w

// Of each stitch's neighbours' neighbours, as often as they are that, itself too.
std::vector<glm::dvec3> middles_around(const SettleGraph& graph, std::span<const glm::dvec3> positions) {
  std::vector<glm::dvec3> sums(graph.stitches, glm::dvec3(0.0)), middles(positions.begin(), positions.end());
  std::vector<double> counts(graph.stitches, 0.0), all(graph.stitches, 1.0);
  for (const auto& [a, b] : graph.beside) {
    sums[a] += positions[b];
    sums[b] += positions[a];
    counts[a] += 1.0;
    counts[b] += 1.0;
  }
  for (const auto& [a, b] : graph.beside) {
    middles[a] += sums[b];
    middles[b] += sums[a];
    all[a] += counts[b];
    all[b] += counts[a];
  }
  for (std::size_t i = 0; i < middles.size(); ++i) middles[i] /= all[i];
  return middles;
}

// A width that is far from what was knitted, as after an edit half way, asks for no more places than the fabric can tell apart.
double size_of_cubes(const Input& input, const PlacedFabric& placed) {
  const double all = surface_area(input.mesh.positions, input.mesh.triangles);
  const double of_a_stitch = all / static_cast<double>(placed.graph.stitches);
  return std::max(finest * placed.width, finest_of * std::sqrt(of_a_stitch));
}

class Sampling {
 public:
  Sampling(const glm::dvec3& low, double size) : low_(low), size_(size) {}

  // Halves the longest edge until none is longer than the cubes; the corners of what is left share its area.
  void cut(const std::array<glm::dvec3, 3>& corners) {
    std::size_t longest = 0;
    std::array<double, 3> edges{};
    for (std::size_t i = 0; i < 3; ++i) {
      edges[i] = glm::distance(corners[i], corners[(i + 1) % 3]);
      if (edges[i] > edges[longest]) longest = i;
    }
    if (!(edges[longest] > size_)) {
      const double area = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2.0;
      for (const glm::dvec3& corner : corners) add(corner, area / 3.0);
      return;
    }
    const glm::dvec3& from = corners[longest];
    const glm::dvec3& to = corners[(longest + 1) % 3];
    const glm::dvec3& beyond = corners[(longest + 2) % 3];
    const glm::dvec3 half = (from + to) * 0.5;
    cut({from, half, beyond});
    cut({half, to, beyond});
  }
  [[nodiscard]] std::vector<CoverPlace> finish() { return std::move(places_); }

 private:
  void add(const glm::dvec3& at, double area) {
    std::array<std::int64_t, 3> cube{};
    for (int axis = 0; axis < 3; ++axis)
      cube[static_cast<std::size_t>(axis)] = std::llround((at[axis] - low_[axis]) / size_);
    const auto [found, is_new] = cubes_.try_emplace(cube, places_.size());
    if (is_new) places_.push_back({at});
    places_[found->second].area += area;
  }

  glm::dvec3 low_;
  double size_;
  std::map<std::array<std::int64_t, 3>, std::size_t> cubes_;
  std::vector<CoverPlace> places_;
};

}  // namespace

std::vector<CoverPlace> places_to_cover(const Input& input, const PlacedFabric& placed, const Heard& heard) {
  const SettleGraph& graph = placed.graph;
  if (graph.triangles.empty()) return {};
  const std::vector<glm::dvec3> middles = middles_around(graph, placed.positions);
  const TriangleTree tree(placed.positions, graph.triangles);
  Sampling sampling(input.bounds.low, size_of_cubes(input, placed));
  for (std::size_t t = 0; t < input.mesh.triangles.size(); ++t) {
    if (t % 4096 == 0)
      hear(heard, 0.5 * static_cast<double>(t) / static_cast<double>(input.mesh.triangles.size()));
    const auto& [a, b, c] = input.mesh.triangles[t];
    sampling.cut({input.mesh.positions[a], input.mesh.positions[b], input.mesh.positions[c]});
  }
  std::vector<CoverPlace> places = sampling.finish(), kept;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i % 4096 == 0) hear(heard, 0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(places.size()));
    CoverPlace& place = places[i];
    const SurfacePlace nearest = tree.nearest(place.at);
    double out = 0.0;
    for (const std::uint32_t stitch : graph.triangles[nearest.triangle])
      out = std::max(out, glm::dot(place.at - middles[stitch], placed.normals[stitch]));
    if (out < bends_from * placed.width) continue;
    place.near = nearest.triangle;
    place.allowed = std::max(glm::distance(nearest.point, place.at), left_from * placed.height);
    kept.push_back(place);
  }
  return kept;
}

}  // namespace knit
