// Tubes of stitches built by hand, for exact figures, and knit meshes as meshes.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "knit/quality/measures.h"
#include "knit/stitches/faces.h"

namespace test_support {

// Rows of equally spaced stitches on a cylinder about y, from y = 0 up, each from direction -z on.
struct HandTube {
  std::vector<int> sizes{16, 16, 16};
  double radius = 1.0;
  double row_height = 1.0;
  double twist = 0.0;  // each row against the one below, radians
};

inline knit::Row tube_row(const HandTube& tube, std::size_t row) {
  knit::Row made;
  made.id = static_cast<knit::RowId>(row + 1);
  const double turn = 2.0 * std::numbers::pi / tube.sizes[row];
  for (int i = 0; i < tube.sizes[row]; ++i) {
    const double angle = turn * i + tube.twist * static_cast<double>(row);
    made.stitches.push_back({{tube.radius * std::sin(angle), tube.row_height * static_cast<double>(row),
                              -tube.radius * std::cos(angle)},
                             knit::no_vertex});
  }
  knit::Ring ring;
  ring.length = tube.sizes[row] * 2.0 * tube.radius * std::sin(turn / 2.0);
  made.ring = knit::Shared<knit::Ring>(ring);
  return made;
}

inline knit::Join tube_join(int below, int above, std::size_t row) {
  const int cells = std::max(below, above);
  knit::Join made;
  made.to = static_cast<knit::RowId>(row + 1);
  made.below = below;
  made.above = above;
  made.labels.assign(static_cast<std::size_t>(cells), knit::Label::knit);
  made.partner.assign(made.labels.size(), -1);
  for (int cell = 0; cell < cells; ++cell) made.link.push_back(cell * std::min(below, above) / cells);
  return made;
}

inline knit::State tube_state(const HandTube& tube) {
  knit::State state;
  knit::Timing timing;
  timing.ends.direction = {0.0, tube.row_height * static_cast<double>(tube.sizes.size()), 0.0};
  state.timing = knit::Shared<knit::Timing>(timing);
  knit::Fabric& fabric = state.fabric;
  for (std::size_t i = 0; i < tube.sizes.size(); ++i) {
    knit::Row row = tube_row(tube, i);
    row.on = fabric.live(0);
    fabric.add(std::move(row));
    if (i == 0) continue;
    knit::Join join = tube_join(tube.sizes[i - 1], tube.sizes[i], i);
    join.from = fabric.row(join.to).on;
    fabric.add(knit::Shared(knit::build_strip(join, fabric.path_indices(join.from),
                                              fabric.path_indices(knit::all_of(fabric.row(join.to))))));
    fabric.add(knit::Shared(join));
  }
  return state;
}

// A knit mesh as triangles, quads cut between their first and third corner.
inline knit::Mesh mesh_of(const knit::State& state) {
  knit::Mesh mesh;
  mesh.positions = knit::knitting_path(state.fabric);
  for (const auto& strip : state.fabric.strips()) {
    for (const knit::Face& face : strip->faces) {
      const auto& [a, b, c, d] = face.corners;
      mesh.triangles.push_back({a, b, c});
      if (face.corner_count == 4) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

// The fabric with each row and each strip changed, up to the first strip for which the change returns false.
template <class ChangeRow, class ChangeStrip>
knit::Fabric remade(const knit::Fabric& fabric, ChangeRow change_row, ChangeStrip change_strip) {
  knit::Fabric made;
  for (const auto& row : fabric.rows()) {
    knit::Row copy = *row;
    change_row(copy);
    made.add(std::move(copy));
  }
  for (const auto& join : fabric.joins()) made.add(join);
  for (const auto& strip : fabric.strips()) {
    knit::Strip copy = *strip;
    if (!change_strip(copy)) break;
    made.add(knit::Shared(std::move(copy)));
  }
  return made;
}

inline knit::Fabric first_strips(const knit::Fabric& fabric, std::size_t count) {
  return remade(
      fabric, [](knit::Row&) {}, [&](knit::Strip&) { return count-- > 0; });
}

// The state with every stitch moved; what has no place is kept.
template <class Move>
knit::State moved(const knit::State& state, Move move) {
  knit::State made = state;
  const auto move_row = [&](knit::Row& row) {
    for (knit::Stitch& stitch : row.stitches) stitch.position = move(stitch.position);
  };
  made.fabric = remade(state.fabric, move_row, [](knit::Strip&) { return true; });
  return made;
}

}  // namespace test_support
