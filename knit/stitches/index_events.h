// What the smallest steps of the stage stitch index do.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"
#include "knit/model/label.h"
#include "knit/model/products.h"

namespace knit {

struct JoinCounted {
  static constexpr std::string_view kind = "transition-counted";
  std::int32_t below, above, change, mains_wanted, mains_before;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const JoinCounted&, const JoinCounted&) = default;
};

struct SpacingChosen {
  static constexpr std::string_view kind = "spacing-chosen";
  Rule rule, tried;
  bool fell_back;
  std::int32_t spacing, remainder, mains;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const SpacingChosen&, const SpacingChosen&) = default;
};

// nearest: which stitch each cell of the larger row hangs on.
struct RowsMatched {
  static constexpr std::string_view kind = "rows-matched";
  std::int32_t links, doubled;     // doubled: stitches of the smaller row with two links
  double sum_of_squares, longest;  // of the wale edges
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RowsMatched&, const RowsMatched&) = default;
};

struct MainPlaced {
  static constexpr std::string_view kind = "main-placed";
  std::int32_t cell, of_mains;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const MainPlaced&, const MainPlaced&) = default;
};

struct ShapingPlaced {
  static constexpr std::string_view kind = "shaping-placed";
  std::int32_t cell, partner, count;  // count: shaping placed so far in this transition
  Label label;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const ShapingPlaced&, const ShapingPlaced&) = default;
};

// Of short rows: where one is turned, or a stitch that a turn marked and that is worked again.
struct TurnPlaced {
  static constexpr std::string_view kind = "turn-placed";
  std::int32_t cell;
  Label label;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const TurnPlaced&, const TurnPlaced&) = default;
};

using IndexEvent =
    std::variant<JoinCounted, SpacingChosen, RowsMatched, MainPlaced, ShapingPlaced, TurnPlaced>;

}  // namespace knit
