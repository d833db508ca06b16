// What the smallest steps of short rows do: a tube's chart and arcs before its first row, its pairs and passes between rounds.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"
#include "knit/short_rows/kept_choice.h"
#include "knit/short_rows/pair_plan.h"
#include "knit/short_rows/planned_pairs.h"

namespace knit {

// One of the ways to keep rows beside events, settled.
struct KeptTried {
  static constexpr std::string_view kind = "kept-tried";
  std::int32_t kept;  // no_short_rows: none
  std::int32_t pairs, stitches;
  float sum;   // a stitch
  bool best;   // so far
  bool worse;  // its wales are less even than without short rows, or the longest is longer
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const KeptTried&, const KeptTried&) = default;
};

struct KeptChosen {
  static constexpr std::string_view kind = "kept-chosen";
  std::int32_t kept, pairs;
  float sum, without;  // a stitch: of what is chosen, and without short rows; both 0: nothing was settled
  ChosenBy by;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const KeptChosen&, const KeptChosen&) = default;
};

struct TubeCharted {
  static constexpr std::string_view kind = "tube-charted";
  std::int16_t tube;
  NoChart none;
  std::int32_t levels, rounds, rows;  // levels of the chart; full rounds, and rows that the tube had
  float residual, spacing;            // of the angle; from round to round on the near side
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] bool unusual(const Parameters& /*parameters*/) const { return none != NoChart::no; }
  friend bool operator==(const TubeCharted&, const TubeCharted&) = default;
};

struct GapMeasured {
  static constexpr std::string_view kind = "gap-measured";
  std::int32_t gap, column;  // column: with the greatest
  float greatest, least;     // rows that are missing
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const GapMeasured&, const GapMeasured&) = default;
};

struct ArcTried {
  static constexpr std::string_view kind = "arc-tried";
  std::int32_t gap, from, to;  // columns
  bool taken;
  float gain, price;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const ArcTried&, const ArcTried&) = default;
};

struct PairsChosen {
  static constexpr std::string_view kind = "pairs-chosen";
  std::int16_t tube;
  std::int32_t pairs, rounds;
  float greatest_lag;  // that is left
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const PairsChosen&, const PairsChosen&) = default;
};

struct PairPlaced {
  static constexpr std::string_view kind = "pair-placed";
  std::int32_t first, last, moved;  // stitches of the round below; how far a turn was moved
  float gain, price, lag;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const PairPlaced&, const PairPlaced&) = default;
};

struct PairDropped {
  static constexpr std::string_view kind = "pair-dropped";
  std::int32_t first, last;
  DropReason reason;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] bool unusual(const Parameters& /*parameters*/) const { return true; }
  friend bool operator==(const PairDropped&, const PairDropped&) = default;
};

struct ShortRowWorked {
  static constexpr std::string_view kind = "short-row-worked";
  std::int32_t stitches, first, last;
  bool back;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const ShortRowWorked&, const ShortRowWorked&) = default;
};

using ShortRowEvent = std::variant<KeptTried, KeptChosen, TubeCharted, GapMeasured, ArcTried, PairsChosen,
                                   PairPlaced, PairDropped, ShortRowWorked>;

}  // namespace knit
