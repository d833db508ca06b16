// Works one round's words on live stitches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "knit/reader/reader_grammar.h"

namespace knit {

// More than any hand will knit; keeps hostile numbers quick.
inline constexpr std::int64_t most_stitches = 100'000;

// Behind so many stitches a marker stands, ascending; the last is the round's beginning. Empty: none is placed.
using Markers = std::vector<std::int64_t>;
// Of the same markers but the beginning's; none where sections are alike.
using MarkerNames = std::vector<MarkerName>;

struct WorkedRound {
  std::vector<Operation> operations;
  std::int64_t made = 0;
  bool told = true;     // Rounds has a hand for each stitch
  std::string mistake;  // empty, or why it cannot be worked on these stitches
  Markers markers;      // afterwards; empty where a stitch took loops from both sides of one
};

// The operations take exactly `live` stitches wherever there is no mistake. An increase at a marker is made before it:
// a marker is slipped once the stitch behind it is worked.
WorkedRound work_round(const std::vector<WorkNode>& nodes, std::int64_t live, const Markers& markers = {},
                       const MarkerNames& names = {});

// What a round takes, where that does not depend on what is there.
std::optional<std::int64_t> fixed_takes(const std::vector<WorkNode>& nodes);

// "5 stitches", "1 stitch"
std::string stitches_text(std::int64_t count);

}  // namespace knit
