// What settling reads of the fabric: which stitches are joined, by their numbers along the knitting path.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "knit/fabric/fabric.h"

namespace knit {

struct SettleGraph {
  std::uint32_t stitches = 0;
  std::vector<std::array<std::uint32_t, 2>> wales;  // low number first, rising
  std::vector<std::array<std::uint32_t, 2>>
      courses;  // sides of faces that are no wale and lead over no turn, likewise
  std::vector<std::array<std::uint32_t, 4>>
      quads;  // of strips, a ring's too; none of a deal without a bridge, none with a side over a turn
  // The stitch, the next in its face and the one before: all of quads, one of triangles.
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::array<std::uint32_t, 3>>
      triangles;  // faces; quads are cut between their first and third corner
  // Pairs of stitches of one face, low number first, rising: what a move of one may mean to another.
  std::vector<std::array<std::uint32_t, 2>> beside;
  std::vector<std::vector<std::uint32_t>> rims;  // of the openings, one after the other round them
  [[nodiscard]] auto fields() const {
    return std::tie(stitches, wales, courses, quads, corners, triangles, beside, rims);
  }
  friend bool operator==(const SettleGraph&, const SettleGraph&) = default;
};

SettleGraph make_settle_graph(const Fabric& fabric);

// Rims of the openings between faces whose sides these are, in the faces' direction: sides without a face beyond, followed
// round each opening.
std::vector<std::vector<std::uint32_t>> rims_of(std::vector<std::array<std::uint32_t, 2>> sides);

}  // namespace knit
