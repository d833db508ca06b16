// What a person says of a rhythm: the counts of a piece planned at once, so that shaping comes in regular repeats.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace knit {

// Where a section's shaping stands (knit/stitches/repeats.h draws them).
enum class RhythmStyle : std::uint8_t { pairs, lines, centre, stagger };
inline constexpr std::array<std::string_view, 4> rhythm_style_names{"pairs", "lines", "centre", "stagger"};

// Row by row as many as its length holds, or all of a piece at once.
enum class CountPlanning : std::uint8_t { whole, rhythm };
// Whether front and back of a body that is not round may be shaped apart (knit/rhythm/joint_plan.h).
enum class RhythmHalves : std::uint8_t { by_themselves, off };
inline constexpr std::array<std::string_view, 2> rhythm_halves_names{"auto", "off"};

enum class FitSize : std::uint8_t { off, on };  // whether the piece may be made a little larger or smaller

struct RhythmSettings {
  CountPlanning counts = CountPlanning::whole;
  RhythmStyle style = RhythmStyle::pairs;
  std::int32_t changes = 0;  // stitches that a shaping round adds or takes; 0: chosen
  double tolerance = 3.5;    // the most that a circumference may be seen to be off, in %
  FitSize fit_size = FitSize::on;
  RhythmHalves halves = RhythmHalves::by_themselves;
  double dial = 0.0;  // what a rhythm costs: large, few rhythms; small, the true shape. 0: all are tried
  friend bool operator==(const RhythmSettings&, const RhythmSettings&) = default;
};

}  // namespace knit
