// Rounds as a person types them, counted as the written pattern counts: "12", and "12.1" for the first short row on round 12.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace app {

struct RoundWords {
  std::int32_t round = 1;      // from 1
  std::int32_t short_row = 0;  // on it, from 1; 0: the round itself
};

// None: the words are no round.
std::optional<RoundWords> read_round(std::string_view words);

}  // namespace app
