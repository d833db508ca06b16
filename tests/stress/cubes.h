// Bodies of cubes in a grid: they part, meet and have handles as the cubes lie. For random runs, fuzzing and measuring.
//
// Any choice of cubes becomes a solid whose surface is one closed surface without pinches: cubes are added where others
// touch along an edge or at a corner alone, the largest piece is kept, hollows are filled. A cube is of size 1.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "knit/mesh/mesh.h"

namespace test_support {

class CubeGrid {
 public:
  using Cell = std::array<int, 3>;

  explicit CubeGrid(const Cell& size) : size_(size), full_(count(), 0) {}

  [[nodiscard]] const Cell& size() const { return size_; }
  [[nodiscard]] bool has(const Cell& cell) const { return inside(cell) && full_[index_of(cell)] != 0; }
  void fill(const Cell& cell) { full_.at(index_of(cell)) = 1; }

  // At least one cube is filled.
  void make_solid() {
    mend_touching();
    keep_largest();
    fill_hollows();
  }

  // Each cube's face in refine x refine quads of two triangles. Requires a solid.
  [[nodiscard]] knit::Mesh surface(int refine) const {
    const auto fine = static_cast<std::size_t>(refine);
    knit::Mesh mesh;
    mesh.name = "cubes";
    const Cell corners{size_[0] * refine + 1, size_[1] * refine + 1, size_[2] * refine + 1};
    std::vector<knit::VertexId> id_at(
        static_cast<std::size_t>(corners[0]) * static_cast<std::size_t>(corners[1] * corners[2]),
        knit::no_vertex);
    const auto vertex = [&](const Cell& at) {
      knit::VertexId& id = id_at[static_cast<std::size_t>((at[0] * corners[1] + at[1]) * corners[2] + at[2])];
      if (id == knit::no_vertex) {
        id = static_cast<knit::VertexId>(mesh.positions.size());
        mesh.positions.push_back(glm::dvec3(at[0], at[1], at[2]) / static_cast<double>(fine));
      }
      return id;
    };
    for (std::size_t i = 0; i < full_.size(); ++i) {
      for (std::size_t side = 0; side < 6 && full_[i] != 0; ++side) {
        if (has(beside(cell_of(i), side))) continue;
        for (std::size_t quad = 0; quad < fine * fine; ++quad) {
          const auto [a, b, c, d] = quad_of(cell_of(i), side, refine, static_cast<int>(quad));
          const knit::VertexId first = vertex(a), third = vertex(c);
          mesh.triangles.push_back({first, vertex(b), third});
          mesh.triangles.push_back({first, third, vertex(d)});
        }
      }
    }
    return mesh;
  }

 private:
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1] * size_[2]);
  }
  [[nodiscard]] bool inside(const Cell& cell) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell.at(k) < 0 || cell.at(k) >= size_.at(k)) return false;
    }
    return true;
  }
  [[nodiscard]] std::size_t index_of(const Cell& cell) const {
    return static_cast<std::size_t>((cell[0] * size_[1] + cell[1]) * size_[2] + cell[2]);
  }
  [[nodiscard]] Cell cell_of(std::size_t index) const {
    const auto i = static_cast<int>(index);
    return {i / (size_[1] * size_[2]), i / size_[2] % size_[1], i % size_[2]};
  }
  // Sides 0 to 5: towards +x, -x, +y, -y, +z, -z.
  static Cell beside(Cell cell, std::size_t side) {
    cell.at(side / 2) += side % 2 == 0 ? 1 : -1;
    return cell;
  }

  // In the finer grid, counter-clockwise seen from outside.
  static std::array<Cell, 4> quad_of(const Cell& cell, std::size_t side, int refine, int quad) {
    const std::size_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    Cell corner{cell[0] * refine, cell[1] * refine, cell[2] * refine};
    if (side % 2 == 0) corner.at(axis) += refine;
    corner.at(u) += quad / refine;
    corner.at(v) += quad % refine;
    std::array<Cell, 4> corners{corner, corner, corner, corner};
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) ++corners.at(k).at(u);
    for (const std::size_t k : {std::size_t{2}, std::size_t{3}}) ++corners.at(k).at(v);
    if (side % 2 == 1) std::swap(corners[1], corners[3]);
    return corners;
  }

  // Cube k of the eight round a corner of the grid, whose least one is `low`.
  static Cell of_eight(const Cell& low, std::size_t k) {
    const auto bits = static_cast<int>(k);
    return {low[0] + (bits & 1), low[1] + (bits >> 1 & 1), low[2] + (bits >> 2 & 1)};
  }
  // Whether these of the eight hang together across faces.
  static bool hangs_together(unsigned chosen) {
    if (chosen == 0) return true;
    unsigned reached = chosen & (~chosen + 1U);
    for (unsigned before = 0; before != reached;) {
      before = reached;
      for (unsigned k = 0; k < 8; ++k) {
        if ((reached >> k & 1U) != 0) reached |= chosen & (1U << (k ^ 1U) | 1U << (k ^ 2U) | 1U << (k ^ 4U));
      }
    }
    return reached == chosen;
  }
  // True where a cube was added.
  bool mend_at(const Cell& low) {
    unsigned filled = 0;
    for (std::size_t k = 0; k < 8; ++k) filled |= has(of_eight(low, k)) ? 1U << k : 0U;
    if (hangs_together(filled) && hangs_together(~filled & 0xFFU)) return false;
    for (std::size_t k = 0; k < 8; ++k) {
      const Cell cell = of_eight(low, k);
      if (!inside(cell) || has(cell)) continue;
      fill(cell);
      return true;
    }
    return false;
  }
  // Ends because each turn but the last fills a cube.
  void mend_touching() {
    for (bool added = true; added;) {
      added = false;
      for (int x = -1; x < size_[0]; ++x)
        for (int y = -1; y < size_[1]; ++y)
          for (int z = -1; z < size_[2]; ++z) added = mend_at({x, y, z}) || added;
    }
  }

  // The cubes that hang together with the first across faces, filled as it is, or empty as it is.
  std::vector<std::size_t> piece_of(std::size_t first, std::vector<std::uint8_t>& seen) const {
    std::vector<std::size_t> piece{first};
    seen[first] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      for (std::size_t side = 0; side < 6; ++side) {
        const Cell cell = beside(cell_of(piece[next]), side);
        if (!inside(cell) || seen[index_of(cell)] != 0 || full_[index_of(cell)] != full_[first]) continue;
        seen[index_of(cell)] = 1;
        piece.push_back(index_of(cell));
      }
    }
    return piece;
  }
  void keep_largest() {
    std::vector<std::uint8_t> seen(full_.size(), 0);
    std::vector<std::size_t> largest;
    for (std::size_t i = 0; i < full_.size(); ++i) {
      if (full_[i] == 0 || seen[i] != 0) continue;
      std::vector<std::size_t> piece = piece_of(i, seen);
      if (piece.size() > largest.size()) largest = std::move(piece);
    }
    std::fill(full_.begin(), full_.end(), std::uint8_t{0});
    for (const std::size_t i : largest) full_[i] = 1;
  }
  void fill_hollows() {
    std::vector<std::uint8_t> seen(full_.size(), 0);
    for (std::size_t i = 0; i < full_.size(); ++i) {
      if (full_[i] != 0 || seen[i] != 0) continue;
      const std::vector<std::size_t> piece = piece_of(i, seen);
      const bool outside = std::any_of(piece.begin(), piece.end(), [&](std::size_t cell) {
        for (std::size_t side = 0; side < 6; ++side) {
          if (!inside(beside(cell_of(cell), side))) return true;
        }
        return false;
      });
      for (const std::size_t cell : piece) full_[cell] = outside ? 0 : 1;
    }
  }

  Cell size_;
  std::vector<std::uint8_t> full_;
};

// Each vertex half way to the mean of its neighbours, so many times: edges are rounded off.
inline void round_off(knit::Mesh& mesh, int times) {
  std::vector<glm::dvec3> sums;
  std::vector<double> counts;
  for (int i = 0; i < times; ++i) {
    sums.assign(mesh.positions.size(), glm::dvec3(0.0));
    counts.assign(mesh.positions.size(), 0.0);
    for (const knit::Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        sums[t.at(k)] += mesh.positions[t.at((k + 1) % 3)];
        counts[t.at(k)] += 1.0;
      }
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
      mesh.positions[v] = 0.5 * mesh.positions[v] + 0.5 / counts[v] * sums[v];
  }
}

}  // namespace test_support
