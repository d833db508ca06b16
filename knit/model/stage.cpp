#include "knit/model/stage.h"

namespace knit {

namespace {
constexpr std::array<std::string_view, 11> stage_names{"import", "timing",   "tubes", "cast-on",
                                                       "rows",   "stitches", "faces", "settle",
                                                       "relax",  "pattern",  "done"};
}

std::string_view name_of(Stage stage) { return stage_names.at(static_cast<std::size_t>(stage)); }

std::optional<Stage> stage_named(std::string_view name) {
  for (const Stage stage : machine_stages) {
    if (name_of(stage) == name) return stage;
  }
  return std::nullopt;
}

}  // namespace knit
