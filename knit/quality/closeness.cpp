#include "knit/quality/closeness.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "knit/mesh/surface_area.h"
#include "knit/mesh/triangle_tree.h"
#include "knit/quality/knit_surface.h"
#include "knit/quality/measures.h"

namespace knit {

namespace {

// A quad's middle is that of the diagonal its two triangles share, so that samples lie on the surface.
void append_samples(std::vector<glm::dvec3>& samples, const Face& face, const std::vector<glm::dvec3>& path) {
  const auto at = [&](std::size_t corner) { return path[face.corners[corner]]; };
  const bool quad = face.corner_count == 4;
  const glm::dvec3 middle = quad ? (at(0) + at(2)) * 0.5 : (at(0) + at(1) + at(2)) / 3.0;
  samples.push_back(middle);
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i) {
    samples.push_back((middle + at(i)) * 0.5);
  }
}

std::vector<glm::dvec3> knit_samples(const State& state, const std::vector<glm::dvec3>& path) {
  std::vector<glm::dvec3> samples = path;
  for (const auto& row : state.fabric.rows()) {
    for (const auto& [from, to] : edges_of(*row))
      samples.push_back((row->stitches[from].position + row->stitches[to].position) * 0.5);
  }
  for (const auto& strip : state.fabric.strips()) {
    for (const auto& [lower, upper] : strip->column_edges) {
      samples.push_back((path[lower] + path[upper]) * 0.5);
    }
    for (const Face& face : strip->faces) append_samples(samples, face, path);
  }
  for (const auto& deal : state.fabric.deals()) {
    for (const Face& face : deal->faces) append_samples(samples, face, path);
  }
  return samples;
}

std::vector<glm::dvec3> mesh_samples(const Input& input) {
  const Mesh& mesh = input.mesh;
  std::vector<glm::dvec3> samples;
  samples.reserve(mesh.positions.size() + mesh.triangles.size());
  std::vector<bool> taken(mesh.positions.size(), false);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (input.referenced[v] == 0 || taken[input.twin[v]]) continue;
    taken[input.twin[v]] = true;
    samples.push_back(mesh.positions[v]);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    samples.push_back((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0);
  }
  return samples;
}

Distances distances_to(const TriangleTree& tree, const std::vector<glm::dvec3>& samples) {
  Distances distances;
  distances.samples = samples.size();
  for (const glm::dvec3& sample : samples) {
    const double distance = tree.distance(sample);
    distances.mean += distance;
    distances.max = std::max(distances.max, distance);
  }
  if (!samples.empty()) distances.mean /= static_cast<double>(samples.size());
  return distances;
}

}  // namespace

std::optional<Closeness> measure_closeness(const Input& input, const State& state) {
  const KnitSurface knit = knit_surface(state);
  const Mesh& mesh = input.mesh;
  if (knit.triangles.empty() || mesh.triangles.empty()) return std::nullopt;
  Closeness closeness;
  closeness.knit_to_mesh =
      distances_to(TriangleTree(mesh.positions, mesh.triangles), knit_samples(state, knit.positions));
  closeness.mesh_to_knit = distances_to(TriangleTree(knit.positions, knit.triangles), mesh_samples(input));
  closeness.diagonal = input.bounds.diagonal();
  closeness.knit_area = surface_area(knit.positions, knit.triangles);
  closeness.mesh_area = surface_area(mesh.positions, mesh.triangles);
  return closeness;
}

std::optional<Closeness> measure_closeness(const Input& input, const State& state, double stitch_width,
                                           double stitch_height) {
  std::optional<Closeness> closeness = measure_closeness(input, state);
  if (!closeness) return closeness;
  closeness->coverage = measure_coverage(input, state, stitch_width, stitch_height);
  if (state.relaxed) {
    State relaxed = state;
    relaxed.fabric = state.fabric.moved_to(state.relaxed->relaxed.positions);
    auto measured = measure_closeness(input, relaxed);
    if (measured) {
      measured->coverage = closeness->coverage;  // of the mesh, which it has left
      closeness->relaxed = std::make_shared<const Closeness>(std::move(*measured));
    }
  }
  if (!state.placed) return closeness;
  if (auto placed = measure_closeness(input, placed_state(state), stitch_width, stitch_height))
    closeness->placed = std::make_shared<const Closeness>(std::move(*placed));
  return closeness;
}

}  // namespace knit
