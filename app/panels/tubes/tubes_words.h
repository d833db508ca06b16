// What the panel of tubes says about them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/panels/kit/tube_marks.h"
#include "app/panels/tubes/tubes_layout.h"
#include "knit/tubes/graph.h"

namespace app {

// How many rows of a tube the run has so far, and their stitches.
struct TubeCount {
  std::int32_t rows = 0;
  std::int64_t stitches = 0;
};

// "340 stitches"; "about 340" while not all its rows are there: what their lengths hold.
std::string stitches_of_tube(const knit::TubePlan& plan, knit::TubeId tube, const TubeCount& count,
                             std::string_view word);
std::string tube_words(const knit::TubePlan& plan, const TubesLayout& layout, knit::TubeId tube,
                       const TubeCount& count);

// A few sentences about all of them; the graph may be missing.
std::vector<std::string> plan_words(const knit::TubePlan& plan, const TubesLayout& layout,
                                    const knit::TubeGraph* graph);

}  // namespace app
