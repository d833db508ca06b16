// Works one round's words on live stitches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "knit/reader/reader_grammar.h"

namespace knit {

// More than any hand will knit; keeps hostile numbers quick.
inline constexpr std::int64_t most_stitches = 100'000;

struct WorkedRound {
  std::vector<Operation> operations;
  std::int64_t made = 0;
  bool told = true;     // Rounds has a hand for each stitch
  std::string mistake;  // empty, or why it cannot be worked on these stitches
};

// The operations take exactly `live` stitches wherever there is no mistake.
WorkedRound work_round(const std::vector<WorkNode>& nodes, std::int64_t live);

// What a round takes, where that does not depend on what is there.
std::optional<std::int64_t> fixed_takes(const std::vector<WorkNode>& nodes);

// "5 stitches", "1 stitch"
std::string stitches_text(std::int64_t count);

}  // namespace knit
