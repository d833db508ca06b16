// What two runs, or the runs of a sweep, are compared by where their rows are worked in tubes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knit/run/state.h"

namespace app {

struct TubeFigures {
  std::int32_t tubes = 0, splits = 0, joins = 0, genus = 0;
  std::int32_t yarns = 0, holders = 0;  // holders: at once
  std::int32_t left_out = 0;            // limbs and holes smaller than a round
};
// As planned; of a run whose rows are rings: the one tube that it is. Before there is any row: nothing.
TubeFigures tube_figures_of(const knit::State& state);
// Of a finished run, a share of the surface; the stitch is the one in force at its end. Takes as long as
// knit::measure_coverage.
std::optional<double> uncovered_share(const knit::Input& input, const knit::State& state,
                                      const knit::StitchSize& stitch);

// A tube in two runs.
struct TubeLine {
  std::string name_a, name_b;               // "B"; empty: that run has no such tube
  std::int32_t rounds_a = 0, rounds_b = 0;  // made
  std::int64_t stitches_a = 0, stitches_b = 0;
  [[nodiscard]] bool differs() const {
    return name_a.empty() || name_b.empty() || rounds_a != rounds_b || stitches_a != stitches_b;
  }
};

// Tubes that are the same part of the surface, in b's order; then those that only a has. On one mesh they are paired by
// where they begin, end and have their middle row, nearest first, where all three lie nearer than the higher one is high;
// on two meshes by their names. None where both have one tube only, or one has rows of rings.
// Cost: the product of the numbers of tubes.
std::vector<TubeLine> tube_lines(const knit::State& a, const knit::State& b, bool same_mesh);

// As a sentence calls the two runs.
struct RunNames {
  std::string_view a = "the first run", b = "the second run";
};

// "Tube B has 12 rounds, 14 before, and 300 stitches, 340 before." Requires a line that differs.
std::string words_of(const TubeLine& line, const RunNames& names = {});

}  // namespace app
