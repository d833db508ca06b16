// What comes off the needles, in figures: how high and wide it is against what was asked, what sinks in, what is not round,
// what is stretched, and what turns or swells. Lengths in mesh units; shares of what they are of.
//
//   axis      of one tube: the line along which its rows' middles lie farthest apart; else the direction of knitting
//   height    along the axis; width: twice the greatest mean distance of a row's stitches from the axis (of one tube), else the
//             largest extent across
//   sunk      how far the mean of an end row lies below the extreme along the axis
//   rounding  a row's farthest by its nearest distance from its middle, of rows with 20 stitches or more
// Cost: one pass over stitches and springs.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/relax/relax.h"

namespace knit {

struct Extent {
  double height = 0.0, width = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(height, width); }
  friend bool operator==(const Extent&, const Extent&) = default;
};
// Requires positions along the knitting path. `along`: the direction of knitting, of any length but zero.
Extent extent_of(const Fabric& fabric, std::span<const glm::dvec3> at, const glm::dvec3& along);

// A row by how much it is off.
struct RowShare {
  RowId row = 0;
  double share = 1.0;
  [[nodiscard]] auto fields() const { return std::tie(row, share); }
  friend bool operator==(const RowShare&, const RowShare&) = default;
};
// A tube whose line from its first row's middle to its last one's leans away from where it was placed.
struct TurnedTube {
  TubeId tube = 0;
  RowId row = 0;  // its first
  double degrees = 0.0;
  [[nodiscard]] auto fields() const { return std::tie(tube, row, degrees); }
  friend bool operator==(const TurnedTube&, const TurnedTube&) = default;
};

struct KnittedFigures {
  Extent knitted, placed;
  std::array<double, 2> sunk{};          // first row, last row; of one tube
  std::optional<RowShare> out_of_round;  // the worst row; none is large enough
  double out_of_round_median = 1.0;
  // Of lengths against what they rest at: the least and the greatest of courses and wales, drawn ends left out.
  RowShare least, greatest;
  std::vector<RowShare>
      stretched;  // rows whose stitches are stretched by more than a tenth on average, rising
  std::vector<TurnedTube> turned;  // by more than `turned_from`, of what branches
  double bend_placed = 0.0,
         bend_knitted = 0.0;                   // degrees between a tube's first and last eighth; of one tube
  double volume_share = 1.0;                   // inside all faces, of what it was as placed
  glm::dvec3 extent_share{1.0};                // along x, y and z, of what it was as placed
  std::vector<std::array<RowId, 2>> touching;  // rows, each pair once, rising
  [[nodiscard]] auto fields() const {
    return std::tie(knitted, placed, sunk, out_of_round, out_of_round_median, least, greatest, stretched,
                    turned, bend_placed, bend_knitted, volume_share, extent_share, touching);
  }
  friend bool operator==(const KnittedFigures&, const KnittedFigures&) = default;
};
inline constexpr double turned_from = 20.0;  // degrees

KnittedFigures knitted_figures(const Fabric& fabric, const RelaxPlan& plan, const Relaxed& relaxed,
                               const glm::dvec3& along);

// What the stage relax makes.
struct KnittedPiece {
  Relaxed relaxed;
  KnittedFigures figures;
  [[nodiscard]] auto fields() const { return std::tie(relaxed, figures); }
  friend bool operator==(const KnittedPiece&, const KnittedPiece&) = default;
};

}  // namespace knit
