// What tells one run from another: equal keys give equal steps.
#pragma once

#include <memory>
#include <vector>

#include "knit/run/timeline.h"

namespace app {

struct RunKey {
  std::shared_ptr<const knit::Input> input;
  knit::Parameters base;
  std::vector<knit::Edit> edits;
  friend bool operator==(const RunKey&, const RunKey&) = default;
};

inline RunKey run_key(const knit::Timeline& timeline) {
  return {timeline.input_pointer(), timeline.base_parameters(), timeline.edits()};
}

}  // namespace app
