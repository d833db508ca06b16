#include "knit/quality/coverage.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <tuple>

#include "knit/mesh/outside.h"
#include "knit/mesh/triangle_tree.h"
#include "knit/mesh/union_find.h"
#include "knit/quality/knit_surface.h"

namespace knit {

namespace {

// However low a stitch is (with rings its height only judges), a mesh is not cut smaller than this.
constexpr double most_cuts = 65536.0;

double area_of(const Corners& t) { return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2.0; }
glm::dvec3 middle_of(const Corners& t) { return (t[0] + t[1] + t[2]) / 3.0; }

std::array<VertexId, 3> corners_of(const Input& input, std::size_t triangle) {
  return input.mesh.triangles[triangle];
}
// Counter-clockwise seen from outside; `inward` as of inward_triangles.
Corners places_of(const Input& input, const std::vector<std::uint8_t>& inward, std::size_t triangle) {
  const auto [a, b, c] = corners_of(input, triangle);
  const auto& positions = input.mesh.positions;
  if (!inward.empty() && inward[triangle] != 0) return {positions[a], positions[c], positions[b]};
  return {positions[a], positions[b], positions[c]};
}

// A row's hole, drawn together at its middle. `outward`: the stitches go round counter-clockwise seen from outside.
void close_hole(KnitSurface& surface, const std::vector<std::uint32_t>& stitches, bool outward) {
  glm::dvec3 middle(0.0);
  for (const std::uint32_t stitch : stitches) middle += surface.positions[stitch];
  const auto at = static_cast<VertexId>(surface.positions.size());
  surface.positions.push_back(middle / static_cast<double>(stitches.size()));
  for (std::size_t i = 0; i < stitches.size(); ++i) {
    const VertexId a = stitches[i];
    const VertexId b = stitches[i + 1 < stitches.size() ? i + 1 : 0];
    surface.triangles.push_back(outward ? Triangle{at, a, b} : Triangle{at, b, a});
  }
}

// Few stitches at a cast on, or left at the end of a tube.
void close_ends(KnitSurface& surface, const State& state) {
  const auto close = [&](const LiveStitches& loop, bool outward) {
    const auto count = static_cast<std::size_t>(loop.size());
    if (loop.closed && count > 0 && count <= most_closing)
      close_hole(surface, state.fabric.path_indices(loop), outward);
  };
  for (const auto& row : state.fabric.rows()) {
    if (row->on.empty()) close(all_of(*row), true);
  }
  for (const LiveLoop& loop : state.fabric.live()) close(loop.stitches, false);
}

KnitSurface closed_surface(const State& state) {
  KnitSurface surface = knit_surface(state);
  close_ends(surface, state);
  return surface;
}

// A small piece of a triangle of the mesh.
struct Piece {
  Corners corners;
  std::size_t triangle = 0;
};

// Cuts triangles in halves, always the longest edge, until no edge is longer than `finest`; keeps those pieces whose
// middle is farther than `limit` from the knit mesh. An edge that two triangles share is cut at the same places in both,
// so that pieces beside each other share corners to the bit.
//
// Along the surface the distance d changes by no more than one goes, so a triangle with its corners within r of its
// middle is covered whole where d + r <= limit, and not at all where d - r > limit: only the rim is looked at closely.
class Cutter {
 public:
  Cutter(const TriangleTree& knit, double limit, double finest)
      : knit_(knit), limit_(limit), finest_(finest) {}
  void cut(const Corners& corners, std::size_t triangle) {
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = glm::length(normal);
    if (size > 0.0) cut({corners, triangle}, normal / size, false);
  }
  [[nodiscard]] const std::vector<Piece>& uncovered() const { return uncovered_; }

 private:
  void cut(const Piece& piece, const glm::dvec3& facing, bool sure) {
    const Corners& c = piece.corners;
    std::array<double, 3> edges{};
    for (std::size_t i = 0; i < 3; ++i) edges[i] = glm::distance(c[i], c[(i + 1) % 3]);
    const auto longest =
        static_cast<std::size_t>(std::max_element(edges.begin(), edges.end()) - edges.begin());
    const bool last = !(edges[longest] > finest_);
    if (!sure) {
      const glm::dvec3 middle = middle_of(c);
      double radius = 0.0;
      for (const glm::dvec3& corner : c) radius = std::max(radius, glm::distance(middle, corner));
      const double distance = knit_.distance(middle, facing, limit_ + radius);
      if (distance + radius <= limit_ || (last && distance <= limit_)) return;
      sure = last || distance - radius > limit_;
    }
    if (last) return uncovered_.push_back(piece);
    const glm::dvec3& from = c[longest];
    const glm::dvec3& to = c[(longest + 1) % 3];
    const glm::dvec3& beyond = c[(longest + 2) % 3];
    const glm::dvec3 half = (from + to) * 0.5;
    cut({{from, half, beyond}, piece.triangle}, facing, sure);
    cut({{half, to, beyond}, piece.triangle}, facing, sure);
  }

  const TriangleTree& knit_;
  double limit_, finest_;
  std::vector<Piece> uncovered_;
};

// Pieces that share a corner are of one patch, which goes by its first piece.
std::vector<std::uint32_t> patches_of(const std::vector<Piece>& pieces) {
  std::vector<std::uint32_t> corners(3 * pieces.size());
  std::iota(corners.begin(), corners.end(), 0U);
  const auto place = [&](std::uint32_t i) {
    const glm::dvec3& p = pieces[i / 3].corners[i % 3];
    return std::tie(p.x, p.y, p.z);
  };
  std::stable_sort(corners.begin(), corners.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  UnionFind patches(pieces.size());
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (place(corners[i - 1]) == place(corners[i])) patches.join(corners[i - 1] / 3, corners[i] / 3);
  }
  std::vector<std::uint32_t> patch_of(pieces.size());
  for (std::uint32_t i = 0; i < patch_of.size(); ++i) patch_of[i] = patches.find(i);
  return patch_of;
}

struct Patch {
  double area = 0.0;
  glm::dvec3 middle{0.0};
  std::vector<std::uint32_t> pieces;
};

// All, the largest first.
std::vector<Patch> gather(const std::vector<Piece>& pieces) {
  const std::vector<std::uint32_t> patch_of = patches_of(pieces);
  std::vector<Patch> patches;
  std::vector<std::size_t> index(pieces.size(), 0);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (patch_of[i] == i) {
      index[i] = patches.size();
      patches.emplace_back();
    }
    Patch& patch = patches[index[patch_of[i]]];
    const double area = area_of(pieces[i].corners);
    patch.area += area;
    patch.middle += area * middle_of(pieces[i].corners);
    patch.pieces.push_back(i);
  }
  for (Patch& patch : patches) {
    if (patch.area > 0.0) patch.middle /= patch.area;
  }
  // Mirror images differ by rounding only: the first one first.
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.area > b.area * (1.0 + 1e-9); });
  return patches;
}

// How much higher the surface gets over a patch, along the knitting, in mesh units: by the times of its triangles.
double rise_of(const Input& input, const Timing& timing, const Patch& patch,
               const std::vector<Piece>& pieces) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::uint32_t i : patch.pieces) {
    for (const VertexId v : corners_of(input, pieces[i].triangle)) {
      low = std::min(low, timing.times[v]);
      high = std::max(high, timing.times[v]);
    }
  }
  const double total = timing.scale.total() > 0.0 ? timing.scale.total() : glm::length(timing.ends.direction);
  return (high - low) * total;
}

// A limb or handle that is left out, with an end of it in the patch: the one left out last, which is the largest.
const LeftOut* left_out_at(const Input& input, const TubePlan& plan, const Patch& patch,
                           const std::vector<Piece>& pieces) {
  const auto holds = [&](VertexId vertex) {
    if (vertex == no_vertex) return false;
    return std::any_of(patch.pieces.begin(), patch.pieces.end(), [&](std::uint32_t i) {
      const auto corners = corners_of(input, pieces[i].triangle);
      return std::any_of(corners.begin(), corners.end(),
                         [&](VertexId v) { return input.twin[v] == input.twin[vertex]; });
    });
  };
  const auto found = std::find_if(plan.left_out.rbegin(), plan.left_out.rend(),
                                  [&](const LeftOut& left) { return holds(left.from) || holds(left.to); });
  return found != plan.left_out.rend() ? &*found : nullptr;
}

UncoveredPlace place_of(const Input& input, const Patch& patch, const std::vector<Piece>& pieces) {
  UncoveredPlace place;
  double nearest = std::numeric_limits<double>::infinity();
  double nearest_vertex = nearest;
  for (const std::uint32_t i : patch.pieces) {
    const glm::dvec3 middle = middle_of(pieces[i].corners);
    const double distance = glm::distance(middle, patch.middle);
    if (distance < nearest) {
      nearest = distance;
      place.at = middle;
    }
    for (const VertexId v : corners_of(input, pieces[i].triangle)) {
      const double to_vertex = glm::distance(input.mesh.positions[v], patch.middle);
      if (to_vertex >= nearest_vertex) continue;
      nearest_vertex = to_vertex;
      place.vertex = input.twin[v];
    }
  }
  return place;
}

// Rows as they were placed, where they have settled elsewhere since.
class PlacedCover {
 public:
  PlacedCover(const State& state, double limit)
      : surface_(closed_surface(placed_state(state))),
        tree_(surface_.positions, surface_.triangles),
        limit_(limit) {}
  // Whether they covered more than half of a patch.
  [[nodiscard]] bool held(const Patch& patch, const std::vector<Piece>& pieces) const {
    double covered = 0.0;
    for (const std::uint32_t i : patch.pieces) {
      const Corners& c = pieces[i].corners;
      const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
      const double size = glm::length(normal);
      const double farther = 2.0 * limit_;
      if (size > 0.0 && tree_.distance(middle_of(c), normal / size, farther) <= limit_) covered += size / 2.0;
    }
    return covered > 0.5 * patch.area;
  }

 private:
  KnitSurface surface_;
  TriangleTree tree_;
  double limit_;
};

// Why it is there.
void explain(UncoveredPlace& place, const Input& input, const State& state, double stitch_height,
             const Patch& patch, const std::vector<Piece>& pieces) {
  const bool timed = state.timing && state.timing->times.size() == input.mesh.positions.size();
  if (timed && rise_of(input, *state.timing, patch, pieces) < stitch_height) {
    place.kind = UncoveredKind::flat;
    return;
  }
  const LeftOut* left = state.tubes ? left_out_at(input, *state.tubes, patch, pieces) : nullptr;
  if (left == nullptr) return;
  place.kind = UncoveredKind::limb;
  place.width_that_keeps = left->width_that_keeps;
}

}  // namespace

Uncovered measure_uncovered(const Input& input, const State& state, double stitch_width,
                            double stitch_height) {
  Uncovered uncovered;
  const std::vector<std::uint8_t> inward = inward_triangles(input);
  double whole = 0.0;
  for (std::size_t t = 0; t < input.mesh.triangles.size(); ++t) whole += area_of(places_of(input, inward, t));
  if (!(whole > 0.0)) return uncovered;
  const KnitSurface surface = closed_surface(state);
  const double limit = covered_within * stitch_height;
  std::optional<PlacedCover> placed;
  if (state.placed) placed.emplace(state, limit);
  const TriangleTree knit(surface.positions, surface.triangles);
  Cutter cutter(knit, limit, std::max(stitch_height, std::sqrt(whole / most_cuts)));
  for (std::size_t t = 0; t < input.mesh.triangles.size(); ++t) cutter.cut(places_of(input, inward, t), t);

  const std::vector<Piece>& pieces = cutter.uncovered();
  for (const Patch& patch : gather(pieces)) {
    uncovered.share += patch.area / whole;
    const bool tiny = patch.area < tiny_place * stitch_width * stitch_height;
    if (tiny || uncovered.places.size() == most_places) continue;
    UncoveredPlace place = place_of(input, patch, pieces);
    place.share = patch.area / whole;
    explain(place, input, state, stitch_height, patch, pieces);
    if (placed && placed->held(patch, pieces)) place.kind = UncoveredKind::slid;
    uncovered.places.push_back(place);
  }
  return uncovered;
}

std::optional<Coverage> measure_coverage(const Input& input, const State& state, double stitch_width,
                                         double stitch_height) {
  if (state.stage() <= Stage::faces || state.fabric.strips().empty()) return std::nullopt;
  std::vector<TubeId> tubes;
  for (const auto& row : state.fabric.rows()) tubes.push_back(row->tube);
  std::sort(tubes.begin(), tubes.end());
  const auto different = std::unique(tubes.begin(), tubes.end()) - tubes.begin();
  return Coverage{measure_uncovered(input, state, stitch_width, stitch_height),
                  stretched_rows(state, stitch_height), static_cast<std::size_t>(different),
                  measure_turned(input, state)};
}

}  // namespace knit
