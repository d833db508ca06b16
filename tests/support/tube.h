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
struct Tube {
  std::vector<int> sizes{16, 16, 16};
  double radius = 1.0;
  double row_height = 1.0;
  double twist = 0.0;  // each row against the one below, radians
};

inline knit::Row tube_row(const Tube& tube, std::size_t row) {
  knit::Row made;
  made.number = static_cast<std::int32_t>(row + 1);
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

inline knit::Transition tube_transition(int below, int above, std::size_t row) {
  const int cells = std::max(below, above);
  knit::Transition made;
  made.row = static_cast<std::int32_t>(row + 1);
  made.below = below;
  made.above = above;
  made.labels.assign(static_cast<std::size_t>(cells), knit::Label::knit);
  made.partner.assign(made.labels.size(), -1);
  for (int cell = 0; cell < cells; ++cell) made.link.push_back(cell * std::min(below, above) / cells);
  return made;
}

inline knit::State tube_state(const Tube& tube) {
  knit::State state;
  knit::Timing timing;
  timing.ends.direction = {0.0, tube.row_height * static_cast<double>(tube.sizes.size()), 0.0};
  state.timing = knit::Shared<knit::Timing>(timing);
  std::uint32_t first = 0;
  for (std::size_t row = 0; row < tube.sizes.size(); ++row) {
    state.rows.emplace_back(tube_row(tube, row));
    if (row == 0) continue;
    const knit::Transition transition = tube_transition(tube.sizes[row - 1], tube.sizes[row], row);
    state.transitions.emplace_back(transition);
    state.strips.emplace_back(knit::build_strip(transition, first));
    first += static_cast<std::uint32_t>(tube.sizes[row - 1]);
  }
  return state;
}

// A knit mesh as triangles, quads cut between their first and third corner.
inline knit::Mesh mesh_of(const knit::State& state) {
  knit::Mesh mesh;
  mesh.positions = knit::knitting_path(state);
  for (const auto& strip : state.strips) {
    for (const knit::Face& face : strip->faces) {
      const auto& [a, b, c, d] = face.corners;
      mesh.triangles.push_back({a, b, c});
      if (face.corner_count == 4) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

// The state with every stitch moved; what has no place is kept.
template <class Move>
knit::State moved(const knit::State& state, Move move) {
  knit::State made = state;
  for (auto& row : made.rows) {
    knit::Row copy = *row;
    for (knit::Stitch& stitch : copy.stitches) stitch.position = move(stitch.position);
    row = knit::Shared<knit::Row>(copy);
  }
  return made;
}

}  // namespace test_support
