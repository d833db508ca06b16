// What there is to say and to draw of a run's rhythms: planned and ideal stitches row by row, and where a row stands in
// its rhythm. Rows are the fabric's, counted from 1; those that are not made yet are known too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "knit/rhythm/tube_rhythm.h"
#include "knit/run/state.h"

namespace app {

// Of a tube, from the row on at which its rhythm was planned last. The three are equally long.
struct RhythmFigures {
  knit::Shared<knit::TubeRhythm> rhythm;
  std::int32_t first_row = 1;
  std::vector<double> planned, ideal;
  std::vector<double> seen;  // deviation in stitches, as the mean over six rows; below 0: too few
  [[nodiscard]] bool has(std::int32_t row) const {
    return row >= first_row && row - first_row < static_cast<std::int32_t>(planned.size());
  }
};
// In the order of their tubes' first rows; tubes for which no rhythm was found are left out.
std::vector<RhythmFigures> rhythm_figures_of(const knit::State& state);
// That has the row, else the first.
const RhythmFigures* figures_at(const std::vector<RhythmFigures>& all, std::int32_t row);

// "Row 31: 64 planned, 66.2 ideal: 2.2 fewer (3.3 %). Seen over six rows: 2.9 % too narrow." Requires has(row).
std::string deviation_words(const RhythmFigures& figures, std::int32_t row);

// Where a row stands.
struct RhythmPlace {
  std::int32_t change = 0;           // stitches, with its sign; 0: it rests
  std::int32_t turn = 0, turns = 0;  // of a change: which of its segment's, from 1, of how many
  std::int32_t rest = 0, rests = 0;  // of a plain row: which of the stretch between two changes
  std::optional<std::int32_t>
      to_next;  // plain rows between it and the next change; none: nothing is shaped any more
  bool next_grows = false;
};
RhythmPlace place_in_rhythm(const knit::RhythmPlan& plan, std::size_t index);
// "Increase round 3 of 6, 8 more stitches; 2 knit rounds until the next shaping round." Empty where no rhythm has the row.
std::string rhythm_place_words(const std::vector<RhythmFigures>& all, std::int32_t row);

}  // namespace app
