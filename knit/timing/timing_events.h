// What the smallest steps of the stage timing do.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"
#include "knit/model/products.h"

namespace knit {

struct EndsFound {
  static constexpr std::string_view kind = "ends-found";
  VertexId start, end;
  double length;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const EndsFound&, const EndsFound&) = default;
};

// With `--timing auto`: what the axis alone would do, and what follows.
struct TimingChosen {
  static constexpr std::string_view kind = "timing-chosen";
  TimingKind timing;
  bool for_flat;    // why not linear; else for unevenness
  VertexId vertex;  // where it is worst
  double flat, unevenness;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const TimingChosen&, const TimingChosen&) = default;
};

struct VertexTimed {
  static constexpr std::string_view kind = "vertex-timed";
  VertexId vertex;
  bool clamped;
  double time;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] bool unusual(const Parameters& /*parameters*/) const { return clamped; }
  friend bool operator==(const VertexTimed&, const VertexTimed&) = default;
};

// One of the solves on the surface that a time is made from.
enum class FieldStep : std::uint8_t { net, heat, slopes, distance, harmonic };

struct FieldSolved {
  static constexpr std::string_view kind = "field-solved";
  FieldStep which;
  VertexId vertex;     // the start; distance: the farthest vertex
  std::int64_t count;  // of triangles (net, slopes) or of unknowns
  double high;         // distance: the greatest, in mesh units
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const FieldSolved&, const FieldSolved&) = default;
};

struct HeightsMeasured {
  static constexpr std::string_view kind = "heights-measured";
  std::int32_t bands;  // of area between two levels
  double height;       // from start to end along the surface, mean over each level
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const HeightsMeasured&, const HeightsMeasured&) = default;
};

struct CriticalsFound {
  static constexpr std::string_view kind = "criticals-found";
  std::int32_t minima, saddles, maxima, euler;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const CriticalsFound&, const CriticalsFound&) = default;
};

struct LevelsGrouped {
  static constexpr std::string_view kind = "levels-grouped";
  std::int32_t levels, outside, split_level, split_loops;  // split_level -1: one tube all the way
  double tolerance;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const LevelsGrouped&, const LevelsGrouped&) = default;
};

using TimingEvent = std::variant<EndsFound, TimingChosen, FieldSolved, HeightsMeasured, VertexTimed,
                                 CriticalsFound, LevelsGrouped>;

// Why the stage stopped, and what a person may do.
std::string timing_stop_sentence(const Stopped& stop);

}  // namespace knit
