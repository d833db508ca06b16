// The stages in calling order, by the names that the command line, the report and the timeline use.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace knit {

// `import` comes before the machine; `done` follows its last step.
enum class Stage : std::uint8_t {
  import,
  timing,
  tubes,
  cast_on,
  rows,
  stitches,
  faces,
  settle,
  relax,
  pattern,
  done
};

inline constexpr std::array machine_stages{Stage::timing, Stage::tubes,    Stage::cast_on,
                                           Stage::rows,   Stage::stitches, Stage::faces,
                                           Stage::settle, Stage::relax,    Stage::pattern};

std::string_view name_of(Stage stage);  // "cast-on"
std::optional<Stage> stage_named(std::string_view name);

// Where in the algorithm a step stands; rises from step to step. Rows count from 1 as knitters and Appendix A
// do; stages that have no rows use 0. Items count from 0 within their row.
struct Place {
  Stage stage = Stage::timing;
  std::int32_t row = 0;
  std::int32_t item = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};

}  // namespace knit
