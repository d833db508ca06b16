// What the smallest steps do where rows are cuts through the surface.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"

namespace knit {

struct RowsPlanned {
  static constexpr std::string_view kind = "rows-planned";
  std::int32_t rows, passed_over;
  double height, row_height, stitch_height;  // still to go along the surface; of a row; what was asked
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RowsPlanned&, const RowsPlanned&) = default;
};

struct CutFound {
  static constexpr std::string_view kind = "cut-found";
  std::int32_t level, edges, loops;
  double time;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const CutFound&, const CutFound&) = default;
};

struct LoopClosed {
  static constexpr std::string_view kind = "loop-closed";
  std::int32_t points;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const LoopClosed&, const LoopClosed&) = default;
};

struct LengthMeasured {
  static constexpr std::string_view kind = "length-measured";
  double length, ideal;  // ideal: stitches of width w that it holds
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const LengthMeasured&, const LengthMeasured&) = default;
};

enum class CountReason : std::uint8_t {
  ideal,           // the length in stitch widths, rounded
  as_cast_on,      // the person said how many
  at_least_three,  // a round needs three
  at_most_double,  // of the row below
  at_least_half,   // of the row below
  room_ahead,      // so that the rows above come nearer to what they hold
};

struct CountChosen {
  static constexpr std::string_view kind = "count-chosen";
  std::int32_t count, below;  // below: 0 for the first row
  CountReason reason;
  double ideal, course;  // course: the stitch width that comes out
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const CountChosen&, const CountChosen&) = default;
};

struct StitchPlaced {
  static constexpr std::string_view kind = "stitch-placed";
  std::int32_t stitch, of;
  double arc;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const StitchPlaced&, const StitchPlaced&) = default;
};

using ContourEvent =
    std::variant<RowsPlanned, CutFound, LoopClosed, LengthMeasured, CountChosen, StitchPlaced>;

}  // namespace knit
