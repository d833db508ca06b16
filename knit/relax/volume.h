// The room that fabric encloses, and how it changes with each stitch: what stuffing works on.
//
// Each quad is cut both ways, and each way counts half; openings are closed by a fan to the middle of their rim. So the
// gradient is exact and has neither a force nor a torque of its own: with equal shares of a quad's area instead, a piece
// turns for ever.
//
// Inner rows, as those of a mug's hollow, are no wall of the room: the faces between them are left out and the holes that
// appear are closed, as if by a lid. Stuffing would turn them out otherwise, like a glove's finger, without a sign of it.
// A row is inner where its stitches' outsides look to its middle: mean of n . (x - c) / |x - c| < -0.3. Rows within 0.3 of 0
// (flat floors) are as the nearest row of their tube that is decided. Cost: one pass over the faces.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "knit/fabric/fabric.h"

namespace knit {

struct Enclosure {
  std::vector<std::array<std::uint32_t, 4>> quads;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<std::uint32_t>> rims;  // of openings, in the direction of the faces' sides
  [[nodiscard]] auto fields() const { return std::tie(quads, triangles, rims); }
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

// All faces.
Enclosure enclosure_of(const Fabric& fabric);
// Inner rows, rising. Requires positions along the knitting path and that `all` is the fabric's enclosure.
std::vector<RowId> inner_rows(const Fabric& fabric, const Enclosure& all, std::span<const glm::dvec3> at);
// Without the faces all of whose stitches are of these rows.
Enclosure without_rows(const Fabric& fabric, const Enclosure& all, const std::vector<RowId>& rows);

// Positive where faces run counter-clockwise seen from outside.
double volume_of(const Enclosure& enclosure, std::span<const glm::dvec3> at);
// Adds `pressure` times the volume's gradient to `force`.
void add_pressure(const Enclosure& enclosure, std::span<const glm::dvec3> at, double pressure,
                  std::span<glm::dvec3> force);

}  // namespace knit
