#include "knit/timing/fields.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "knit/mesh/elementary.h"
#include "knit/model/bug.h"
#include "knit/timing/dissection.h"
#include "knit/timing/elimination.h"
#include "knit/timing/intrinsic.h"

namespace knit {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// How many times the square root of the heat time the surface may reach: the heat falls to no less than
// exp(-500).
constexpr double farthest_reach = 500.0;
// No edge's weight is less, so that nothing comes loose where rounding takes a weight away.
constexpr double least_weight = 1e-12;
// How many times the square root of the surface's area it may be smoothed over: by then little is left but the mean, and
// the masses must not drown in the Laplacian's rounding.
constexpr double most_smoothing = 100.0;

// Of what is heard: until the edges of each vertex are, until the order is there, until the matrix is.
constexpr double share_of_spokes = 0.02, share_of_order = 0.3, share_of_matrix = 0.35;

// The places that the net uses, numbered in the order of elimination; -1 for all other vertices.
struct Unknowns {
  std::vector<int> of_vertex;
  int count = 0;
};

Unknowns number_unknowns(const Input& input, const Spokes& spokes, const Heard& heard) {
  Unknowns unknowns{std::vector<int>(input.twin.size(), -1), 0};
  for (const VertexId v :
       order_by_dissection(spokes, input.mesh.positions, part_of(heard, share_of_spokes, share_of_order)))
    unknowns.of_vertex[v] = unknowns.count++;
  return unknowns;
}

int unknown_at(const Input& input, const Unknowns& unknowns, VertexId vertex) {
  if (vertex >= input.twin.size() || unknowns.of_vertex[input.twin[vertex]] < 0)
    throw Bug("a field is to begin or end at a vertex that no triangle uses");
  return unknowns.of_vertex[input.twin[vertex]];
}

std::vector<double> to_vertices(const Input& input, const std::vector<int>& of_vertex, const Vector& values) {
  std::vector<double> result(input.twin.size(), 0.0);
  for (std::size_t v = 0; v < result.size(); ++v) {
    const int unknown = of_vertex[input.twin[v]];
    if (unknown >= 0) result[v] = values[unknown];
  }
  return result;
}

struct LaplacianEntry {
  int row;
  double value;
};

// All entries of the lower half, column after column, in each as they come: a zero on the diagonal, then a triangle's three
// sides after another's. first[j] .. first[j + 1) are those of column j.
struct LaplacianEntries {
  std::vector<std::size_t> first;
  std::vector<LaplacianEntry> entries;
};

LaplacianEntries laplacian_entries(const IntrinsicMesh& intrinsic, const Unknowns& unknowns,
                                   const Heard& heard) {
  const auto column_of = [&](std::size_t t, std::size_t k) {
    return static_cast<std::size_t>(std::min(unknowns.of_vertex[intrinsic.triangles[t][k]],
                                             unknowns.of_vertex[intrinsic.triangles[t][(k + 1) % 3]]));
  };
  const auto columns = static_cast<std::size_t>(unknowns.count);
  const std::size_t triangles = intrinsic.triangles.size();
  LaplacianEntries made{std::vector<std::size_t>(columns + 1, 1),
                        std::vector<LaplacianEntry>(columns + 3 * triangles)};
  made.first[0] = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t k = 0; k < 3; ++k) ++made.first[column_of(t, k) + 1];
  }
  hear(heard, 0.0);
  std::partial_sum(made.first.begin(), made.first.end(), made.first.begin());
  std::vector<std::size_t> next(made.first.begin(), made.first.end() - 1);
  for (int j = 0; j < unknowns.count; ++j) made.entries[next[static_cast<std::size_t>(j)]++] = {j, 0.0};
  for (std::size_t t = 0; t < triangles; ++t) {
    hear_at(heard, t, triangles);
    const std::array<double, 3> cotangents = cotangents_of(intrinsic.lengths[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = unknowns.of_vertex[intrinsic.triangles[t][k]];
      const int j = unknowns.of_vertex[intrinsic.triangles[t][(k + 1) % 3]];
      made.entries[next[column_of(t, k)]++] = {std::max(i, j), -0.5 * cotangents[(k + 2) % 3]};
    }
  }
  return made;
}

// By row, equal ones as they come. Columns are short but at a pole.
void sort_column(std::span<LaplacianEntry> column) {
  constexpr std::size_t few = 32;
  const auto less = [](const LaplacianEntry& a, const LaplacianEntry& b) { return a.row < b.row; };
  if (column.size() > few) return std::stable_sort(column.begin(), column.end(), less);
  for (std::size_t i = 1; i < column.size(); ++i)
    for (std::size_t at = i; at > 0 && less(column[at], column[at - 1]); --at)
      std::swap(column[at], column[at - 1]);
}

// Entries at one place are summed as they come.
Matrix summed(LaplacianEntries all, const Heard& heard) {
  const std::size_t columns = all.first.size() - 1;
  Matrix matrix(static_cast<int>(columns), static_cast<int>(columns));
  matrix.reserve(static_cast<Eigen::Index>((all.entries.size() + columns) / 2 + 1));
  for (std::size_t j = 0; j < columns; ++j) {
    hear_at(heard, j, columns);
    const auto begin = all.entries.begin() + static_cast<std::ptrdiff_t>(all.first[j]);
    const auto end = all.entries.begin() + static_cast<std::ptrdiff_t>(all.first[j + 1]);
    sort_column(std::span(all.entries).subspan(all.first[j], all.first[j + 1] - all.first[j]));
    matrix.startVec(static_cast<Eigen::Index>(j));
    for (auto at = begin; at != end;) {
      const int row = at->row;
      double sum = (at++)->value;
      while (at != end && at->row == row) sum += (at++)->value;
      matrix.insertBack(row, static_cast<Eigen::Index>(j)) = sum;
    }
  }
  matrix.finalize();
  return matrix;
}

// The Laplacian as (L u)_i = sum of w_ij (u_i - u_j): its lower half. Every w_ij is positive.
Matrix make_laplacian(const IntrinsicMesh& intrinsic, const Unknowns& unknowns, const Heard& heard) {
  Matrix laplacian =
      summed(laplacian_entries(intrinsic, unknowns, part_of(heard, 0.0, 0.4)), part_of(heard, 0.4, 0.8));
  const Heard weights = part_of(heard, 0.8, 1.0);
  Vector sums = Vector::Zero(unknowns.count);
  for (int j = 0; j < unknowns.count; ++j) {
    hear_at(weights, static_cast<std::size_t>(j), static_cast<std::size_t>(unknowns.count));
    for (Matrix::InnerIterator it(laplacian, j); it; ++it) {
      if (it.row() == j) continue;
      it.valueRef() = std::min(it.value(), -least_weight);
      sums[j] -= it.value();
      sums[it.row()] -= it.value();
    }
  }
  // Written last: an edge back to where it starts leaves no trace.
  for (int j = 0; j < unknowns.count; ++j) laplacian.coeffRef(j, j) = sums[j];
  return laplacian;
}

Vector lumped_masses(const IntrinsicMesh& intrinsic, const Unknowns& unknowns) {
  Vector masses = Vector::Zero(unknowns.count);
  for (std::size_t t = 0; t < intrinsic.triangles.size(); ++t) {
    const double third = area_of(intrinsic.lengths[t]) / 3.0;
    for (const VertexId v : intrinsic.triangles[t]) masses[unknowns.of_vertex[v]] += third;
  }
  return masses;
}

struct Pin {
  int unknown;
  double value;
};

// Of a compressed matrix.
Vector solve(const Matrix& lower_half, Vector right, const Heard& heard) {
  const auto size = static_cast<std::size_t>(lower_half.cols()),
             entries = static_cast<std::size_t>(lower_half.nonZeros());
  const Elimination factors({{lower_half.outerIndexPtr(), size + 1},
                             {lower_half.innerIndexPtr(), entries},
                             {lower_half.valuePtr(), entries}},
                            part_of(heard, share_of_matrix, 0.95));
  if (!factors.factored()) throw Bug("the Laplacian of the mesh could not be factored");
  factors.solve({right.data(), size}, part_of(heard, 0.95, 1.0));
  return right;
}

// Solves L u = right with some values given. Their columns move to the right side.
Vector solve_pinned(const IntrinsicMesh& intrinsic, const Unknowns& unknowns, Vector right,
                    std::span<const Pin> pins, const Heard& heard) {
  Matrix matrix = make_laplacian(intrinsic, unknowns, part_of(heard, share_of_order, share_of_matrix));
  std::vector<const Pin*> pin_at(static_cast<std::size_t>(matrix.cols()), nullptr);
  for (const Pin& pin : pins) pin_at[static_cast<std::size_t>(pin.unknown)] = &pin;
  for (int j = 0; j < matrix.outerSize(); ++j) {
    const Pin* const column = pin_at[static_cast<std::size_t>(j)];
    for (Matrix::InnerIterator it(matrix, j); it; ++it) {
      const Pin* const row = pin_at[static_cast<std::size_t>(it.row())];
      if (it.row() == j || (column == nullptr && row == nullptr)) continue;
      if (column != nullptr) right[it.row()] -= it.value() * column->value;
      if (row != nullptr) right[j] -= it.value() * row->value;
      it.valueRef() = 0.0;
    }
  }
  for (const Pin& pin : pins) right[pin.unknown] = matrix.coeff(pin.unknown, pin.unknown) * pin.value;
  Vector values = solve(matrix, right, heard);
  hear(heard, 1.0);
  for (const Pin& pin : pins) values[pin.unknown] = pin.value;
  return values;
}

// -grad u / |grad u| times each edge. Heat may be as small as 1e-217, so nothing here may square it.
std::array<double, 3> unit_slopes_in(const SideLengths& lengths, const std::array<double, 3>& heat) {
  const auto base =
      static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  const Apex apex = lay_out(lengths, base);
  const auto fall_to = [&](std::size_t k) { return heat[base] - heat[k % 3]; };
  const double x = fall_to(base + 1) / lengths[base];
  const double y = (fall_to(base + 2) - x * apex.x) / apex.y;
  const double steepness = hypotenuse(x, y);
  std::array<double, 3> slopes{};
  if (!(steepness > 0.0)) return slopes;
  slopes[base] = x / steepness * lengths[base];
  slopes[(base + 2) % 3] = -(x * apex.x + y * apex.y) / steepness;
  slopes[(base + 1) % 3] = -slopes[base] - slopes[(base + 2) % 3];
  return slopes;
}

}  // namespace

std::vector<double> spread_heat(const Input& input, const IntrinsicMesh& intrinsic, VertexId start,
                                const Heard& heard) {
  const Spokes spokes = spokes_of(intrinsic, input.twin.size(), part_of(heard, 0.0, share_of_spokes));
  const Unknowns unknowns = number_unknowns(input, spokes, heard);
  const int source = unknown_at(input, unknowns, start);
  const double reach =
      reach_along_edges(spokes, input.twin[start], part_of(heard, share_of_order, share_of_order));
  const double spread = std::max(intrinsic.mean_edge, reach / farthest_reach);
  Matrix matrix = make_laplacian(intrinsic, unknowns, part_of(heard, share_of_order, share_of_matrix));
  // M + t L over t: without a unit of length.
  matrix.diagonal() += lumped_masses(intrinsic, unknowns) / (spread * spread);
  Vector unit = Vector::Zero(unknowns.count);
  unit[source] = 1.0;
  const Vector heat = solve(matrix, unit, heard);
  hear(heard, 1.0);
  return to_vertices(input, unknowns.of_vertex, heat / heat[source]);
}

EdgeSlopes unit_slopes(const IntrinsicMesh& intrinsic, const std::vector<double>& heat, const Heard& heard) {
  EdgeSlopes slopes;
  slopes.reserve(intrinsic.triangles.size());
  for (std::size_t t = 0; t < intrinsic.triangles.size(); ++t) {
    hear_at(heard, t, intrinsic.triangles.size());
    const auto& [a, b, c] = intrinsic.triangles[t];
    slopes.push_back(unit_slopes_in(intrinsic.lengths[t], {heat[a], heat[b], heat[c]}));
  }
  return slopes;
}

std::vector<double> distance_from(const Input& input, const IntrinsicMesh& intrinsic,
                                  const EdgeSlopes& slopes, VertexId start, const Heard& heard) {
  const Unknowns unknowns = number_unknowns(
      input, spokes_of(intrinsic, input.twin.size(), part_of(heard, 0.0, share_of_spokes)), heard);
  const Pin pin{unknown_at(input, unknowns, start), 0.0};
  Vector rise = Vector::Zero(unknowns.count);  // minus the slopes' divergence
  const Heard flows = part_of(heard, share_of_order, share_of_order);
  for (std::size_t t = 0; t < intrinsic.triangles.size(); ++t) {
    hear_at(flows, t, intrinsic.triangles.size());
    const std::array<double, 3> cotangents = cotangents_of(intrinsic.lengths[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double flow = 0.5 * cotangents[(k + 2) % 3] * slopes[t][k];
      rise[unknowns.of_vertex[intrinsic.triangles[t][k]]] -= flow;
      rise[unknowns.of_vertex[intrinsic.triangles[t][(k + 1) % 3]]] += flow;
    }
  }
  const Vector distance = solve_pinned(intrinsic, unknowns, rise, {&pin, 1}, heard);
  return to_vertices(input, unknowns.of_vertex, distance.cwiseMax(0.0));
}

std::vector<double> solve_harmonic(const Input& input, const IntrinsicMesh& intrinsic, VertexId start,
                                   VertexId end, const Heard& heard) {
  return solve_harmonic(input, intrinsic, std::span(&start, 1), std::span(&end, 1), heard);
}

std::vector<double> solve_harmonic(const Input& input, const IntrinsicMesh& intrinsic,
                                   std::span<const VertexId> start, std::span<const VertexId> end,
                                   const Heard& heard) {
  const Unknowns unknowns = number_unknowns(
      input, spokes_of(intrinsic, input.twin.size(), part_of(heard, 0.0, share_of_spokes)), heard);
  std::vector<Pin> pins;
  pins.reserve(start.size() + end.size());
  for (const VertexId v : start) pins.push_back({unknown_at(input, unknowns, v), 0.0});
  for (const VertexId v : end) {
    pins.push_back({unknown_at(input, unknowns, v), 1.0});
    for (std::size_t i = 0; i < start.size(); ++i)
      if (pins[i].unknown == pins.back().unknown) throw Bug("a harmonic field begins and ends at one place");
  }
  const Vector zero = Vector::Zero(unknowns.count);
  return to_vertices(input, unknowns.of_vertex,
                     solve_pinned(intrinsic, unknowns, zero, pins, heard).cwiseMin(1.0));
}

struct FieldSmoother::Kept {
  std::vector<int> unknown_of;  // vertex, in the order of elimination; -1: none
  Matrix laplacian;
  Vector masses;
};

FieldSmoother::FieldSmoother(const Input& input, const IntrinsicMesh& intrinsic, const Heard& heard) {
  Unknowns unknowns = number_unknowns(
      input, spokes_of(intrinsic, input.twin.size(), part_of(heard, 0.0, share_of_spokes)), heard);
  const Matrix laplacian = make_laplacian(intrinsic, unknowns, part_of(heard, share_of_order, 1.0));
  Vector masses = lumped_masses(intrinsic, unknowns);
  kept_ = std::make_shared<const Kept>(Kept{std::move(unknowns.of_vertex), laplacian, std::move(masses)});
}

std::vector<double> FieldSmoother::smooth(const Input& input, const std::vector<double>& field, double length,
                                          const Heard& heard) const {
  const auto& [unknown_of, laplacian, masses] = *kept_;
  Vector rough = Vector::Zero(masses.size());
  for (std::size_t v = 0; v < field.size(); ++v)
    if (unknown_of[v] >= 0) rough[unknown_of[v]] = field[v];
  const double longest = most_smoothing * std::sqrt(masses.sum());
  const double reach = std::min(length, longest);
  Matrix matrix = laplacian * (reach * reach);
  matrix.diagonal() += masses;
  const Vector smooth = solve(matrix, masses.cwiseProduct(rough), heard);
  // But for rounding the extremes are never passed, as no weight is negative.
  return to_vertices(input, unknown_of, smooth.cwiseMax(rough.minCoeff()).cwiseMin(rough.maxCoeff()));
}

}  // namespace knit
