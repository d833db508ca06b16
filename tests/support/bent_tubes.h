// Open tubes that bend, lean or end obliquely, from formulas: what short rows are for.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "knit/mesh/mesh.h"

namespace test_support {

// A tube that is open at both ends, its triangles facing out, and where its first round is to begin.
struct BentTube {
  std::string name;
  knit::Mesh mesh;
  glm::dvec3 bottom{0.0}, beginning{0.0};
  unsigned around = 0;  // points of a ring
};

struct TubeNet {
  unsigned around = 64, along = 90;
};

// Rings one above the other: the place of the point at `turn` of a full turn on the ring at `up`, both from 0 to 1. Turns
// run counter-clockwise seen from above. The first round begins at `turn` 0.
inline BentTube ringed_tube(const std::string& name, const TubeNet& net,
                            const std::function<glm::dvec3(double up, double turn)>& place) {
  BentTube tube{name, {}, {}, place(0.0, 0.0), net.around};
  tube.mesh.name = name;
  for (unsigned i = 0; i <= net.along; ++i) {
    for (unsigned j = 0; j < net.around; ++j) {
      tube.mesh.positions.push_back(
          place(static_cast<double>(i) / net.along, static_cast<double>(j) / net.around));
      if (i == 0) tube.bottom += tube.mesh.positions.back() / static_cast<double>(net.around);
    }
  }
  for (unsigned i = 0; i < net.along; ++i) {
    for (unsigned j = 0; j < net.around; ++j) {
      const knit::VertexId p = i * net.around + j, q = i * net.around + (j + 1) % net.around;
      tube.mesh.triangles.push_back({p, q, q + net.around});
      tube.mesh.triangles.push_back({p, q + net.around, p + net.around});
    }
  }
  return tube;
}

// About a circle in the plane z = 0 with its middle in the origin: by how much of it `up` has come round, and how wide it
// is there. Turn 0 is on its outer side.
inline BentTube arched_tube(const std::string& name, const TubeNet& net, double bend_radius,
                            const std::function<glm::dvec2(double up)>& angle_and_radius) {
  return ringed_tube(name, net, [=](double up, double turn) {
    const glm::dvec2 at = angle_and_radius(up);
    const double t = 2.0 * std::numbers::pi * turn;
    const double out = bend_radius + at.y * std::cos(t);
    return glm::dvec3(out * std::cos(at.x), out * std::sin(at.x), -at.y * std::sin(t));
  });
}

inline BentTube half_ring(const TubeNet& net = {}) {
  return arched_tube("half ring", net, 2.0, [](double up) { return glm::dvec2(std::numbers::pi * up, 1.0); });
}

// A round ended tube along an arc of 2 radians, cut off where it is a quarter as wide.
inline BentTube banana(const TubeNet& net = {64, 120}) {
  return arched_tube("banana", net, 3.0, [](double up) {
    constexpr double length = 6.0, rim = 0.25;
    const double cut = 1.0 - std::sqrt(1.0 - rim * rim);
    const double way = cut + 0.5 * (1.0 - std::cos(std::numbers::pi * up)) * (length - 2.0 * cut);
    const double to_end = std::min(way, length - way);
    const double radius = to_end < 1.0 ? std::sqrt(1.0 - (1.0 - to_end) * (1.0 - to_end)) : 1.0;
    return glm::dvec2(way / 3.0, radius);
  });
}

// A leg 3 long, a quarter bend of radius 1.2, a foot 4 long, radius 1. Turn 0 is on the sole's side.
inline BentTube heel(const TubeNet& net = {64, 120}) {
  constexpr double bend = 1.2, leg = 3.0, foot = 4.0;
  return ringed_tube("heel", net, [=](double up, double turn) {
    const double arc = std::numbers::pi / 2.0 * bend, way = up * (leg + arc + foot);
    const double angle = std::clamp((way - leg) / bend, 0.0, std::numbers::pi / 2.0);
    const glm::dvec3 ahead(std::sin(angle), -std::cos(angle), 0.0),
        out(-std::cos(angle), -std::sin(angle), 0.0);
    const glm::dvec3 middle = glm::dvec3(bend, -leg, 0.0) + bend * out +
                              ahead * (std::min(0.0, way - leg) + std::max(0.0, way - leg - arc));
    const double t = 2.0 * std::numbers::pi * turn;
    return middle + std::cos(t) * out + std::sin(t) * glm::cross(ahead, out);
  });
}

// Rings that stay level and get smaller while they move to one side.
inline BentTube oblique_cone(const TubeNet& net = {}) {
  return ringed_tube("oblique cone", net, [](double up, double turn) {
    const double radius = 1.5 - 1.1 * up, t = 2.0 * std::numbers::pi * turn;
    return glm::dvec3(3.0 * up + radius * std::cos(t), radius * std::sin(t), 4.0 * up);
  });
}

// Cut off obliquely at the top: it is higher on the side of turn 0. Slope 0: a plain cylinder.
inline BentTube slanted_cylinder(double slope = 0.8, const TubeNet& net = {}) {
  return ringed_tube("slanted cylinder", net, [=](double up, double turn) {
    const double t = 2.0 * std::numbers::pi * turn;
    return glm::dvec3(std::cos(t), std::sin(t), up * (4.0 + slope * std::cos(t)));
  });
}

// Cut off obliquely, and wider on the side of positive y than on the other, so that it is no mirror image of itself.
inline BentTube lopsided_cylinder(const TubeNet& net = {}) {
  return ringed_tube("lopsided cylinder", net, [](double up, double turn) {
    const double t = 2.0 * std::numbers::pi * turn;
    const double radius = 1.0 + 0.15 * std::max(0.0, std::sin(t)) * std::sin(std::numbers::pi * up);
    return glm::dvec3(radius * std::cos(t), radius * std::sin(t), up * (4.0 + 0.8 * std::cos(t)));
  });
}

// A surface of revolution about z: radius and height by `up`.
inline BentTube turned_tube(const std::string& name, const std::function<glm::dvec2(double up)>& profile,
                            const TubeNet& net = {}) {
  return ringed_tube(name, net, [=](double up, double turn) {
    const glm::dvec2 at = profile(up);
    const double t = 2.0 * std::numbers::pi * turn;
    return glm::dvec3(at.x * std::cos(t), at.x * std::sin(t), at.y);
  });
}

// With flat lids on both ends, of rings of triangles about their middles: the last two vertices, the low one first.
inline BentTube lidded(BentTube tube, unsigned rings = 12) {
  knit::Mesh& mesh = tube.mesh;
  const auto around = tube.around;
  const auto count = static_cast<knit::VertexId>(mesh.positions.size());
  const auto add_lid = [&](knit::VertexId rim, bool low) {
    glm::dvec3 middle(0.0);
    for (knit::VertexId j = 0; j < around; ++j) middle += mesh.positions[rim + j] / double(around);
    const auto add = [&](knit::VertexId a, knit::VertexId b, knit::VertexId c) {
      mesh.triangles.push_back(low ? knit::Triangle{a, c, b} : knit::Triangle{a, b, c});
    };
    knit::VertexId outer = rim;
    for (unsigned ring = 1; ring < rings; ++ring) {
      const auto inner = static_cast<knit::VertexId>(mesh.positions.size());
      for (knit::VertexId j = 0; j < around; ++j) {
        const glm::dvec3 on_rim = mesh.positions[rim + j];
        mesh.positions.push_back(on_rim + (middle - on_rim) * (double(ring) / rings));
      }
      for (knit::VertexId j = 0; j < around; ++j) {
        const knit::VertexId k = (j + 1) % around;
        add(outer + j, outer + k, inner + k);
        add(outer + j, inner + k, inner + j);
      }
      outer = inner;
    }
    mesh.positions.push_back(middle);
    for (knit::VertexId j = 0; j < around; ++j)
      add(outer + j, outer + (j + 1) % around, static_cast<knit::VertexId>(mesh.positions.size() - 1));
  };
  add_lid(0, true);
  add_lid(count - around, false);
  std::swap(mesh.positions[count + (rings - 1) * around], mesh.positions[mesh.positions.size() - 2]);
  const knit::VertexId one = count + (rings - 1) * around,
                       other = static_cast<knit::VertexId>(mesh.positions.size() - 2);
  for (knit::Triangle& f : mesh.triangles)
    for (knit::VertexId& v : f) v = v == one ? other : v == other ? one : v;
  return tube;
}

// Mirrored in the plane z = 0; its triangles face out again.
inline BentTube mirrored(BentTube tube) {
  for (glm::dvec3& p : tube.mesh.positions) p.z = -p.z;
  for (knit::Triangle& f : tube.mesh.triangles) std::swap(f[1], f[2]);
  tube.bottom.z = -tube.bottom.z;
  tube.beginning.z = -tube.beginning.z;
  return tube;
}

}  // namespace test_support
