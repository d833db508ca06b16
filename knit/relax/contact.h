// Where fabric comes near fabric in the air: pairs of stitches that shall not pass each other, and places where it has.
//
// Stitches go into cubes of the size of what is near, sorted, and each is compared with those of the 27 cubes around;
// triangles into every cube that their boxes touch, and each edge is tried against those of its own cubes. Cost: n log n, and
// what is found. Mesh units.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/relax/springs.h"
#include "knit/relax/volume.h"

namespace knit {

using StitchPair = std::array<std::uint32_t, 2>;  // the lower number first

// Pairs nearer than `near` and more than `steps` along courses and wales apart, rising.
std::vector<StitchPair> pairs_near(Joined& joined, std::span<const glm::dvec3> at, double near, int steps);

// An edge of a face that goes through another face, more than `steps` along courses and wales from it.
struct Crossing {
  StitchPair edge{};
  std::array<std::uint32_t, 3> triangle{};
  friend bool operator==(const Crossing&, const Crossing&) = default;
};
inline constexpr int crossing_apart = 4;
// Quads are cut between their first and third corner. Each edge and triangle once, rising by edge. `size`: of the cubes.
std::vector<Crossing> crossings_of(const Enclosure& all, Joined& joined, std::span<const glm::dvec3> at,
                                   double size);

}  // namespace knit
