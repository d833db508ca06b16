// A small mesh and any parameters, made from bytes, for the pipeline's fuzz target.
#pragma once

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "knit/mesh/shapes.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "tests/fuzz/bytes.h"
#include "tests/stress/cubes.h"

namespace fuzz {

inline glm::dvec3 vector_of(Bytes& bytes) {
  const double x = bytes.between(-1, 1), y = bytes.between(-1, 1), z = bytes.between(-1, 1);
  return {x, y, z};
}

inline knit::Mesh revolved(Bytes& bytes) {
  const unsigned segments = 3 + bytes.below(6);
  std::vector<knit::ProfilePoint> profile{{0.0, 0.0}};
  for (unsigned rings = 1 + bytes.below(6); rings > 0; --rings) {
    const double y = profile.back().y + bytes.between(-0.1, 1.0);
    profile.push_back({bytes.between(0.05, 1.6), y});
  }
  profile.push_back({0.0, profile.back().y + bytes.between(-0.1, 1.0)});
  return knit::revolve("mesh", profile, segments, bytes.below(2) == 1);
}

// Any triangles between a few places on a coarse grid, so that places coincide.
inline knit::Mesh soup(Bytes& bytes) {
  knit::Mesh mesh;
  const unsigned vertices = 4 + bytes.below(9);
  for (unsigned i = 0; i < vertices; ++i) {
    const unsigned at = bytes.byte();
    mesh.positions.emplace_back(at % 6, at / 6 % 6, at / 36);
  }
  for (unsigned count = 4 + bytes.below(24); count > 0; --count)
    mesh.triangles.push_back({bytes.below(vertices), bytes.below(vertices), bytes.below(vertices)});
  return mesh;
}

// Any of the 27 cubes of a grid, one a bit: what parts, meets, lies as a ring or has handles.
inline knit::Mesh cubes(Bytes& bytes) {
  const unsigned how = bytes.byte();
  unsigned chosen = 0;
  for (unsigned i = 0; i < 4; ++i) chosen |= bytes.byte() << (8 * i);
  test_support::CubeGrid grid({3, 3, 3});
  if ((chosen & 0x7FFFFFFU) == 0) grid.fill({1, 1, 1});
  for (int i = 0; i < 27; ++i) {
    if ((chosen >> static_cast<unsigned>(i) & 1U) != 0) grid.fill({i / 9, i / 3 % 3, i % 3});
  }
  grid.make_solid();
  knit::Mesh mesh = grid.surface(1 + static_cast<int>(how % 2));
  test_support::round_off(mesh, static_cast<int>(how / 2 % 4));
  return mesh;
}

inline knit::Mesh shape_of(Bytes& bytes) {
  const unsigned shape = bytes.byte();
  if (shape >= 192) return cubes(bytes);
  switch (shape % 6) {
    case 0:
    case 1:
      return revolved(bytes);
    case 2:
      return knit::icosphere(0);
    case 3:
      return knit::icosphere(1);
    case 4:
      return knit::torus(3 + bytes.below(5), 3 + bytes.below(4), bytes.between(0.6, 1.5),
                         bytes.between(0.1, 0.6));
    default:
      return soup(bytes);
  }
}

// Moved about, stretched, set on a grid, turned inside out, scaled: as the bytes say.
inline knit::Mesh mesh_of(Bytes& bytes) {
  const unsigned how = bytes.byte();
  knit::Mesh mesh = shape_of(bytes);
  if ((how & 1U) != 0) {
    const std::array<glm::dvec3, 3> column{vector_of(bytes), vector_of(bytes), vector_of(bytes)};
    for (glm::dvec3& p : mesh.positions) p += p.x * column[0] + p.y * column[1] + p.z * column[2];
  }
  if ((how & 2U) != 0)
    for (glm::dvec3& p : mesh.positions) p += 0.4 * vector_of(bytes);
  if ((how & 4U) != 0)
    for (glm::dvec3& p : mesh.positions) p = glm::floor(4.0 * p + 0.5) / 4.0;
  if ((how & 8U) != 0)
    for (knit::Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  if ((how & 16U) != 0 && !mesh.triangles.empty()) std::swap(mesh.triangles[0][0], mesh.triangles[0][2]);
  if ((how & 32U) != 0) mesh.positions.emplace_back(vector_of(bytes));
  constexpr std::array scales{1.0, 1e-9, 1e9, 1e45};
  const double scale = scales.at(how >> 6U);
  for (glm::dvec3& p : mesh.positions) p *= scale;
  return mesh;
}

// A length: mostly some tenths of the mesh, now and then far from it.
inline double length_of(Bytes& bytes, double size) {
  const unsigned drawn = bytes.byte();
  if (drawn >= 252) return std::array{1e-13, 1e-3, 1e3, 1e11}.at(drawn - 252);
  return size * (0.1 + drawn / 200.0);
}

inline glm::dvec3 direction_of(Bytes& bytes) {
  const double scale = std::array{1.0, 1.0, 1e-12, 1e12}.at(bytes.below(4));
  return scale * vector_of(bytes);
}

// Any parameters, also those that fault_of refuses. `size`: of the mesh.
inline knit::Parameters parameters_of(Bytes& bytes, double size, unsigned vertices) {
  knit::Parameters p;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (const auto* choice = std::get_if<knit::Choice>(&info.kind))
      choice->set(p, static_cast<int>(bytes.below(static_cast<unsigned>(choice->names.size()))));
  }
  const knit::SizesFrom given = p.size.from();
  p.timing.axis.kind = static_cast<knit::AxisKind>(bytes.below(4));
  if (p.timing.axis.kind == knit::AxisKind::custom) p.timing.axis.custom = direction_of(bytes);
  const unsigned picks = bytes.byte();
  if ((picks & 1U) != 0) p.timing.start = bytes.below(vertices + 1);
  if ((picks & 2U) != 0) p.timing.end = bytes.below(vertices + 1);
  if ((picks & 4U) != 0) p.rows.start_direction = direction_of(bytes);
  if ((picks & 8U) != 0)
    p.rows.cast_on =
        (picks & 16U) != 0 ? static_cast<int>(bytes.byte()) : 3 + static_cast<int>(bytes.below(16));
  if ((picks & 32U) != 0) p.timing.level_tolerance = bytes.between(0.0, 0.1);
  if ((picks & 64U) != 0) knit::give_height(p, length_of(bytes, size));
  if ((picks & 128U) != 0) knit::give_gauge(p, {bytes.between(0.5, 60.0), bytes.between(0.5, 60.0)});
  knit::give_width(p, length_of(bytes, size));
  const unsigned band = bytes.byte();
  knit::give_epsilon(p, band == 255 ? length_of(bytes, size) : p.stitch.width * (band + 1) / 256.0);
  knit::give_sizes(p, given);
  p.size.height_cm = p.size.from() == knit::SizesFrom::gauge ? bytes.between(0.1, 4.0) : 12.0;
  const unsigned last = bytes.byte();
  p.stitches.stacking_penalty = last % 2 == 1 ? bytes.between(0.0, 10.0) : 0.0;
  p.tubes.smallest_limb = 1 + static_cast<int>(last / 2 % 4);
  p.settle.most_iterations = 3;  // as good as sixty to find what breaks
  if ((last & 64U) != 0) p.tubes.smoothing_length = bytes.between(0.0, 10.0);
  return p;
}

}  // namespace fuzz
