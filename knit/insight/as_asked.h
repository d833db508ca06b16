// A finished piece beside what was asked for: its size in centimetres, and a swatch that yarn can make.
//
// The size as asked is the mesh's, so high as was said; the size as knitted comes from the counts of stitches and rounds.
// Rows of the mesh's rings stand where the mesh has vertices, not one stitch height apart, so that the two may differ by
// half. Counts are whole numbers, and at 16 stitches and 22 rounds a ball comes out 4 % off: a tenth is not passed over.
//
// A swatch: in stockinette a stitch is 0.65 to 0.77 as high as it is wide (measured gauges); tight rounds come to 0.6, and
// stranded colourwork is about square. What lies outside is another fabric, or stitches and rounds were mixed up.
#pragma once

#include <optional>
#include <vector>

#include "knit/insight/problems.h"

namespace knit {

inline constexpr double size_off = 0.1;                               // of the size asked for
inline constexpr double flattest_stitch = 0.6, tallest_stitch = 1.0;  // height over width

// In centimetres. No height where it depends on how pieces lie.
struct PieceSize {
  std::optional<double> height_cm;
  double around_cm = 0.0;  // at the widest round
};

// The girth of the longest curve that a row was taken from, and the height that was asked for.
PieceSize size_asked(const State& state, const Parameters& parameters);
// The sentence, where one of them is off; none: as asked.
std::optional<Remark> remark_on_size(const PieceSize& knitted, const PieceSize& asked,
                                     const Parameters& parameters);
std::optional<Remark> remark_on_swatch(const Parameters& parameters);
// Where an edit of how stitches are placed came when pairs of short rows stood already. `wished`: with what is on auto.
std::optional<Remark> remark_on_placement(const State& state, const Parameters& wished);
// Where stitches and rounds are hardly those of one fabric: the rounds that go with the stitches, a whole number.
std::optional<double> rounds_that_go_with(const Gauge& gauge);

}  // namespace knit
