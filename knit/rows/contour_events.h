// What the smallest steps do where rows are cuts through the surface.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/fabric/deal.h"
#include "knit/model/event.h"
#include "knit/rhythm/no_rhythm.h"

namespace knit {

// Why a tube has no round.
enum class Rowless : std::uint8_t {
  no,            // it has some
  dealt_on,      // lower than a round: its stitches are only dealt
  cast_on_edge,  // the edge that two tubes start from
  grafted        // the edge at which two tubes are grafted to each other
};

struct TubeTaken {
  static constexpr std::string_view kind = "tube-taken";
  std::int32_t tube, rows, live;  // live: stitches that it is worked on; 0: it is cast on
  float height, spacing;          // of the tube; from row to row
  std::int32_t held = 0;          // loops that wait on holders while it is worked
  std::int32_t aside = -1;        // of them, the tube that begins to wait for this one; -1: none
  Rowless rowless = Rowless::no;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const TubeTaken&, const TubeTaken&) = default;
};

struct RowsReplanned {
  static constexpr std::string_view kind = "rows-replanned";
  std::int32_t rows;            // still to come, in all tubes
  double width, stitch_height;  // that they are planned for now
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RowsReplanned&, const RowsReplanned&) = default;
};

struct CutFound {
  static constexpr std::string_view kind = "cut-found";
  std::int32_t tube, level;  // level: of the tube's rows, from 0
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
  ideal,            // the length in stitch widths, rounded
  as_cast_on,       // the person said how many
  at_least_three,   // a round needs three
  at_most_double,   // of the row below
  at_least_half,    // of the row below
  room_ahead,       // so that the rows above come nearer to what they hold
  would_be_undone,  // not the one that it holds, which a row within eight rounds would undo
  undone,           // what it holds, although a row within eight rounds undoes the change
  rhythm_change,    // where the rhythm begins or changes
  rhythm_rest,      // as many as below, as the rhythm has it
  rhythm_begins,    // of the live stitches so many that a rhythm can go on from there
};

// The counts of all the tube's rows that are still to come.
struct RhythmPlanned {
  static constexpr std::string_view kind = "rhythm-planned";
  std::int16_t tube, changes, sections;  // changes: the most in a round
  std::int16_t rhythms;                  // segments that shape
  std::int16_t shaping, rounds;          // rounds that shape, of so many
  std::int16_t row;                      // of the piece, from 1: where it is most off
  RhythmStyle style;
  NoRhythm none;
  float local, belt, score;  // seen, in % of the row and of the widest
  bool within;               // the tolerance
  bool apart = false;        // front and back halves differ
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] bool unusual(const Parameters& /*parameters*/) const {
    return none != NoRhythm::no || !within;
  }
  friend bool operator==(const RhythmPlanned&, const RhythmPlanned&) = default;
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

struct RoundBegun {
  static constexpr std::string_view kind = "round-begun";
  std::int32_t passes;               // 0: it begins on the chosen side, or anywhere
  double arc, slid, sum_of_squares;  // along the curve; how far it was moved; of the wales in stitch heights
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RoundBegun&, const RoundBegun&) = default;
};

struct StitchPlaced {
  static constexpr std::string_view kind = "stitch-placed";
  std::int32_t stitch, of;
  double arc;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const StitchPlaced&, const StitchPlaced&) = default;
};

// --- deals, between a tube and the next

// The tubes of a deal: those of its two loops, and of the one loop that is cut or made; -1: of a ring, there is none.
struct DealTubes {
  std::int16_t one = -1, two = -1, whole = -1;
  friend bool operator==(const DealTubes&, const DealTubes&) = default;
};

struct GapsFound {
  static constexpr std::string_view kind = "gaps-found";
  DealKind deal;
  VertexId vertex;        // of the saddle
  std::int32_t tried;     // arcs; join: gaps
  std::int32_t one, two;  // stitches of the two sides
  float gap;              // across the saddle, in stitch widths
  DealTubes tubes = {};
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const GapsFound&, const GapsFound&) = default;
};

struct BridgeCastOn {
  static constexpr std::string_view kind = "bridge-cast-on";
  std::int32_t stitch, of;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const BridgeCastOn&, const BridgeCastOn&) = default;
};

struct LoopsDealt {
  static constexpr std::string_view kind = "loops-dealt";
  DealKind deal;
  std::int32_t one, two, whole, bridge;  // stitches of the two loops, and of the one
  std::int32_t held;                     // loops that wait on holders now
  DealTubes tubes = {};
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const LoopsDealt&, const LoopsDealt&) = default;
};

using ContourEvent =
    std::variant<TubeTaken, RowsReplanned, RhythmPlanned, CutFound, LoopClosed, LengthMeasured, CountChosen,
                 RoundBegun, StitchPlaced, GapsFound, BridgeCastOn, LoopsDealt>;

}  // namespace knit
