// The shape of a checked pattern at a gauge: what it would look like if it lay there, roughly. Rounds are rings, rows
// are strips, pieces stand side by side.
//
// Lengths in cm. The y axis points up; work begins at y = 0. A round of n stitches is a ring n stitches long, so its
// radius is n w / 2 pi, where w is a stitch's width; it stands the height of a row h above the one below, along the
// slope: sqrt(h^2 - dr^2), and not at all where the radius changes by more than h. A row is as wide as its
// stitches and stands h above the one below: a flat piece lies flat.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/checker/checker.h"
#include "app/scene/scene.h"

namespace app {

struct PlacedRound {
  std::size_t line = 1;  // of the text
  std::int64_t stitches = 0;
  double half = 0.0;    // the radius, or half the width
  double height = 0.0;  // above the foot
};

struct PlacedPiece {
  std::string name;  // "Thumb, 2 of them": for a person
  bool flat = false;
  double middle = 0.0;  // x of its axis
  double half = 0.0;    // the most of its rounds'
  std::vector<PlacedRound> rounds;
};

struct CheckedShape {
  std::vector<PlacedPiece> pieces;
  knit::Bounds bounds;
};

// Counts beyond a hundred thousand stitches are drawn as that many. O(rounds).
CheckedShape shape_of(const knit::CheckedSize& size, const CheckedGauge& gauge);

// Corners of a round: of a ring `ring_corners`, in order, of a row its two ends.
inline constexpr std::size_t ring_corners = 40;
std::vector<glm::dvec3> corners_of(const PlacedPiece& piece, const PlacedRound& round);

// Of so many rounds one is drawn: more than a screen has lines are of no use.
std::size_t stride_of(const CheckedShape& shape);

// The line of the text whose round lies under a place of the view ([-1, 1], up positive), the nearest to the eye.
// `sight`: where it is seen from. O(rounds).
std::optional<std::size_t> line_under(const CheckedShape& shape, const Sight& sight, const glm::dvec2& place);

}  // namespace app
