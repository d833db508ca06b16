// What the smallest steps of Algorithm 2 do, which makes rows of rings of vertices.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"
#include "knit/model/products.h"

namespace knit {

struct CycleGathered {
  static constexpr std::string_view kind = "cycle-gathered";
  std::int32_t level, vertices;
  double time;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const CycleGathered&, const CycleGathered&) = default;
};

struct CycleOrdered {
  static constexpr std::string_view kind = "cycle-ordered";
  VertexId first;
  std::int32_t vertices;
  OrderedBy by;
  double length;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const CycleOrdered&, const CycleOrdered&) = default;
};

enum class Verdict : std::uint8_t { too_near, accepted, too_far };
std::string_view name_of(Verdict verdict);  // "too near"

struct CandidateMeasured {
  static constexpr std::string_view kind = "candidate-measured";
  VertexId anchor, candidate;
  std::int32_t anchor_order, candidate_order;  // places in the ring
  std::int32_t stitch;                         // the anchor's number in the row, from 1
  Verdict verdict;
  double distance;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const CandidateMeasured&, const CandidateMeasured&) = default;
};

// Nothing lay in the band; the robust continuation took the vertex nearest to the stitch width.
struct BandMissed {
  static constexpr std::string_view kind = "band-missed";
  VertexId anchor, taken;
  std::int32_t stitch, taken_order;
  double distance, skipped_distance;  // of the taken; of the other one at the band (negative: there was none)
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] static bool unusual(const Parameters& /*parameters*/) { return true; }
  friend bool operator==(const BandMissed&, const BandMissed&) = default;
};

struct RowClosed {
  static constexpr std::string_view kind = "row-closed";
  std::int32_t stitches;
  bool in_band, dropped_last;
  double gap;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RowClosed&, const RowClosed&) = default;
};

enum class ResampleReason : std::uint8_t { too_few, more_than_double, less_than_half };

struct RowResampled {
  static constexpr std::string_view kind = "row-resampled";
  std::int32_t from, to, below;
  ResampleReason reason;
  double length;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] static bool unusual(const Parameters& /*parameters*/) { return true; }
  friend bool operator==(const RowResampled&, const RowResampled&) = default;
};

struct GapShared {
  static constexpr std::string_view kind = "gap-shared";
  std::int32_t stitches;
  Closing how;
  bool shared;        // false: left as it was
  bool resampled;     // left because the row had been spread evenly already
  double per_stitch;  // thesis: each stitch moves by its number times this; arc: the even spacing
  double gap_before, gap_after;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] bool unusual(const Parameters& parameters) const;
  friend bool operator==(const GapShared&, const GapShared&) = default;
};

using RingEvent = std::variant<CycleGathered, CycleOrdered, CandidateMeasured, BandMissed, RowClosed,
                               RowResampled, GapShared>;

}  // namespace knit
