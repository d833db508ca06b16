// A needle of the world's patterns as counts between markers, and a round worked on it.
//
// `left` is worked onto `right`. A turn swaps them; a round that ends moves right to left. So short rows and rows to and
// fro need nothing of their own. Equal stitches are worked as one step where no marker stands among them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "knit/trade/world_grammar.h"

namespace knit {

using Segments = std::vector<std::int64_t>;  // at least one; a marker stands between each two

struct WorldNeedle {
  Segments left{0}, right{0};  // left: from its tip on; right: its tip last
  bool marked = false;         // markers were placed in words that were followed
  [[nodiscard]] std::int64_t count() const;
  [[nodiscard]] std::int64_t left_count() const;
  void set(std::int64_t stitches);
};

// What the needle alone cannot do.
struct WorldHands {
  std::function<std::string(const WorldNode&, std::int64_t)> hold;                  // a complaint, or nothing
  std::function<std::optional<std::int64_t>(const WorldNode&, std::string&)> take;  // how many
};

struct WorldOutcome {
  std::string wrong;    // does not add up
  std::string unknown;  // cannot be followed
  std::size_t at = 0, length = 0;
  bool turned = false;
  [[nodiscard]] bool sound() const { return wrong.empty() && unknown.empty(); }
};

// Works the round; on `flat` needles the work is turned after it. `budget` is what may still be worked.
WorldOutcome work_on(WorldNeedle& needle, const std::vector<WorldNode>& nodes, bool flat,
                     const WorldHands& hands, std::int64_t& budget);

// What a list takes and makes, where that hangs on nothing.
struct FixedWork {
  std::int64_t takes = 0, makes = 0;
};
std::optional<FixedWork> fixed_work(const std::vector<WorldNode>& nodes);

}  // namespace knit
