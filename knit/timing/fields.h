// Stage 1, timing by solving on the surface: distance from a vertex, and the harmonic field between two.
//
// Vertices at the same place are one (Input::twin): results have one value a mesh vertex, twins alike;
// vertices that no triangle uses get 0. Cotangent Laplacian and lumped masses on the intrinsic Delaunay
// triangulation, so that no weight is negative and the harmonic field has no peak or pit along the edges of that
// net (along the mesh's own edges small ones may show); direct sparse Cholesky.
// K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in Heat", 2013; U. Pinkall, K. Polthier, "Computing
// discrete minimal surfaces and their conjugates", 1993.
//
// The solves are direct and take seconds on a million triangles; meant for a worker. `start` and `end` must
// be vertices of a triangle with three places.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/timing/intrinsic.h"

namespace knit {

// The heat method's three steps. Heat after a short time, at each vertex, as a share of that at `start`, from
// where it flows: in (0, 1]. The time is the square of the mean edge; more where the surface reaches so far
// that the heat would fall below the smallest double.
std::vector<double> spread_heat(const Input& input, const IntrinsicMesh& intrinsic, VertexId start,
                                const Heard& heard = {});

// How steep the heat falls along each edge of each triangle once every slope is made 1: the unit field
// -grad u / |grad u|, as its dot product with edge k -> k + 1 of triangle t. 0 where the heat is level.
using EdgeSlopes = std::vector<std::array<double, 3>>;
EdgeSlopes unit_slopes(const IntrinsicMesh& intrinsic, const std::vector<double>& heat,
                       const Heard& heard = {});

// The function whose slopes come nearest to these, 0 at `start` and nowhere negative: the distance from
// `start` along the surface.
std::vector<double> distance_from(const Input& input, const IntrinsicMesh& intrinsic,
                                  const EdgeSlopes& slopes, VertexId start, const Heard& heard = {});

// 0 at `start`, 1 at `end`, and in between at every vertex the weighted mean of its neighbours.
std::vector<double> solve_harmonic(const Input& input, const IntrinsicMesh& intrinsic, VertexId start,
                                   VertexId end, const Heard& heard = {});
// Likewise from all of some vertices to all of others; no vertex is among both.
std::vector<double> solve_harmonic(const Input& input, const IntrinsicMesh& intrinsic,
                                   std::span<const VertexId> start, std::span<const VertexId> end,
                                   const Heard& heard = {});

// Smooths fields on one surface. What does not depend on the field and the length is worked out once: the order of
// elimination, Laplacian and masses. Copies share it.
class FieldSmoother {
 public:
  FieldSmoother(const Input& input, const IntrinsicMesh& intrinsic, const Heard& heard = {});

  // The field with its level sets smoothed over about `length`: solves (M + length^2 L) f' = M f with the lumped masses M.
  // Between the least and the greatest of the field everywhere. More than 100 times the square root of the area counts as
  // that.
  [[nodiscard]] std::vector<double> smooth(const Input& input, const std::vector<double>& field,
                                           double length, const Heard& heard = {}) const;

 private:
  struct Kept;
  std::shared_ptr<const Kept> kept_;
};

}  // namespace knit
