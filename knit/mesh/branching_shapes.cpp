#include "knit/mesh/branching_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knit/mesh/evening.h"
#include "knit/mesh/implicit.h"
#include "knit/mesh/shapes.h"
#include "knit/mesh/solids.h"

namespace knit {

namespace {

constexpr double right_angle = 1.5707963267948966;

// The grid is a little finer than the mesh is to be: evening out only takes away.
Mesh made_of(std::string name, const Solid& solid, const GridBlock& block, double edge,
             const std::optional<Rim>& rim = std::nullopt) {
  Mesh mesh = surface_of(solid, block, 0.9 * edge);
  mesh.name = std::move(name);
  return evened(mesh, solid, edge, rim);
}

// Balls along a cubic curve (Bezier) from the first of its four points to the last, `pieces` of them and one more.
std::vector<Ball> balls_along(const std::array<glm::dvec3, 4>& curve, int pieces, double radius,
                              double end_radius) {
  std::vector<Ball> balls;
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const double s = 1.0 - t;
    const glm::dvec3 at =
        s * s * s * curve[0] + 3.0 * s * s * t * curve[1] + 3.0 * s * t * t * curve[2] + t * t * t * curve[3];
    balls.push_back({at, s * radius + t * end_radius});
  }
  return balls;
}

// Half as thick as a cup's wall.
constexpr double half_wall = 0.1;

// The wall ends in a half circle about the line's end; its highest place is right above.
Rim rim_of(const BentLine& wall) { return {wall.end().x, wall.end().y + half_wall}; }

double from_axis(const glm::dvec3& p) { return std::sqrt(p.x * p.x + p.z * p.z); }

}  // namespace

// Its middle line is bent by a quarter of a circle that is little wider than the tube.
Mesh heel(double edge) {
  constexpr double radius = 0.42, bend = 1.2 * radius, leg = 0.85, foot = 1.0;
  constexpr unsigned pieces = 12;
  std::vector<Ball> balls{{{0.0, bend + leg, 0.0}, radius}};
  for (unsigned i = 0; i <= pieces; ++i) {
    const TurnPoint at = turn_point(i, 4 * pieces);
    balls.push_back({{bend * (1.0 - at.cosine), bend * (1.0 - at.sine), 0.0}, radius});
  }
  balls.push_back({{bend + foot, 0.0, 0.0}, radius});
  const auto solid = [&](const glm::dvec3& p) { return limb_distance(p, balls); };
  return made_of("heel", solid, {{-0.6, -0.6, -0.6}, {2.1, 2.0, 0.6}}, edge);
}

// Legs end in a shallow dome each, the waist in a wider one: a flat end would have no lowest place.
Mesh trousers(double edge) {
  const auto leg = [](const glm::dvec3& p, double side) {
    const double tube = limb_distance(p, {{0.21 * side, 0.15, 0.0}, 0.26}, {{0.46 * side, -1.8, 0.0}, 0.22});
    return common_part(tube, ball_distance(p, {{0.41 * side, -0.65, 0.0}, 0.78}), 0.09);
  };
  const auto solid = [&](const glm::dvec3& place) {
    const glm::dvec3 p(place.x, place.y, place.z / 0.8);
    const double tube = limb_distance(p, {{0.0, 0.3, 0.0}, 0.51}, {{0.0, 1.6, 0.0}, 0.33});
    const double trunk = common_part(tube, ball_distance(p, {{0.0, 0.2, 0.0}, 0.8}), 0.12);
    return melted({leg(p, -1.0), leg(p, 1.0), trunk}, 0.1);
  };
  return made_of("trousers", solid, {{-0.9, -1.7, -0.7}, {0.9, 1.2, 0.7}}, edge);
}

Mesh letter_y(double edge) {
  const auto solid = [](const glm::dvec3& p) {
    return melted({limb_distance(p, {{0.0, -1.15, 0.0}, 0.29}, {{0.0, 0.0, 0.0}, 0.26}),
                   limb_distance(p, {{-0.12, 0.15, 0.0}, 0.25}, {{-0.75, 0.95, 0.0}, 0.24}),
                   limb_distance(p, {{0.12, 0.15, 0.0}, 0.25}, {{0.75, 0.95, 0.0}, 0.24})},
                  0.16);
  };
  return made_of("y", solid, {{-1.3, -1.7, -0.6}, {1.3, 1.4, 0.6}}, edge);
}

Mesh starfish(double edge) {
  std::array<glm::dvec3, 5> tips;
  for (unsigned i = 0; i < 5; ++i) {
    const TurnPoint at = turn_point(i, 5);
    tips[i] = {1.25 * at.sine, 1.25 * at.cosine, 0.0};
  }
  const auto solid = [&](const glm::dvec3& place) {
    const glm::dvec3 p(place.x, place.y, place.z / 0.8);
    const auto arm = [&](std::size_t i) { return limb_distance(p, {{}, 0.31}, {tips[i], 0.11}); };
    return melted({arm(0), arm(1), arm(2), arm(3), arm(4)}, 0.14);
  };
  return made_of("starfish", solid, {{-1.6, -1.6, -0.7}, {1.6, 1.6, 0.7}}, edge);
}

// The legs stand at an eighth of a turn from each other, mirrored by x = 0, z = 0 and x = z: so a place is mirrored
// into the sector of one leg, and only that leg and its neighbours are near.
Mesh octopus(double edge) {
  std::vector<std::vector<Ball>> legs;
  for (const unsigned long sixteenth : {15UL, 1UL, 3UL}) {
    const TurnPoint at = turn_point(sixteenth, 16);
    const auto out = [&](double radius, double y) {
      return glm::dvec3(radius * at.cosine, y, radius * at.sine);
    };
    legs.push_back(
        balls_along({out(0.24, 0.1), out(0.75, 0.05), out(0.8, -0.55), out(1.1, -1.15)}, 8, 0.18, 0.1));
  }
  const auto solid = [&](const glm::dvec3& place) {
    const double x = std::abs(place.x);
    const double z = std::abs(place.z);
    const glm::dvec3 p(std::max(x, z), place.y, std::min(x, z));
    const double head =
        melted({ball_distance(p, {{0.0, 0.74, 0.0}, 0.56}), ball_distance(p, {{0.0, 0.12, 0.0}, 0.36})}, 0.4);
    return melted({head, limb_distance(p, legs[0]), limb_distance(p, legs[1]), limb_distance(p, legs[2])},
                  0.12);
  };
  return made_of("octopus", solid, {{-1.4, -1.5, -1.4}, {1.4, 1.5, 1.4}}, edge);
}

// Floors are shallow bowls for the same reason as hems are.
Mesh cup(double edge) {
  constexpr std::array<Bend, 2> bends{{{1.4, 0.3}, {0.5, right_angle - 0.42}}};
  const BentLine wall(-0.85, bends, 1.05);
  const auto solid = [&](const glm::dvec3& p) { return wall.distance({from_axis(p), p.y}) - half_wall; };
  return made_of("cup", solid, {{-1.4, -1.1, -1.4}, {1.4, 1.2, 1.4}}, edge, rim_of(wall));
}

Mesh mug(double edge) {
  constexpr std::array<Bend, 2> bends{{{1.6, 0.3}, {0.24, right_angle - 0.3}}};
  const BentLine wall(-0.75, bends, 1.1);
  const std::vector<Ball> handle = balls_along(
      {glm::dvec3(0.78, 0.52, 0.0), {1.36, 0.34, 0.0}, {1.4, -0.1, 0.0}, {0.78, -0.5, 0.0}}, 14, 0.13, 0.13);
  const auto solid = [&](const glm::dvec3& p) {
    return melted({wall.distance({from_axis(p), p.y}) - half_wall, limb_distance(p, handle)}, 0.08);
  };
  return made_of("mug", solid, {{-1.1, -1.1, -1.1}, {1.7, 1.2, 1.1}}, edge, rim_of(wall));
}

Mesh double_torus(double edge) {
  const auto solid = [](const glm::dvec3& p) {
    const glm::dvec3 up(0.0, 0.58, 0.0);
    return melted({ring_distance(p - up, 0.5, 0.2), ring_distance(p + up, 0.5, 0.2)}, 0.1);
  };
  return made_of("double-torus", solid, {{-0.9, -1.5, -0.4}, {0.9, 1.5, 0.4}}, edge);
}

Mesh chain_of_three(double edge) {
  const auto solid = [](const glm::dvec3& p) {
    const glm::dvec3 up(0.0, 0.92, 0.0);
    const glm::dvec3 turned(p.z, p.y, -p.x);
    return melted({ring_distance(p - up, 0.39, 0.16), ring_distance(turned, 0.39, 0.16),
                   ring_distance(p + up, 0.39, 0.16)},
                  0.08);
  };
  return made_of("chain-of-three", solid, {{-0.8, -1.7, -0.8}, {0.8, 1.7, 0.8}}, edge);
}

}  // namespace knit
