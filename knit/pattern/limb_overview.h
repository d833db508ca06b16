// The list of the pieces: what each begins on, how much is knitted, how large it becomes, and where its stitches go.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "knit/limbs/limb_plan.h"
#include "knit/model/settings.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/written_pattern.h"

namespace knit {

// Of pieces made together, in working order.
std::vector<PieceFacts> piece_facts(const LimbPlan& plan, const LimbNames& names, const Gauge& gauge);
// "Limbs B and C, each: cast on 5; 7 rnds, 26 sts at the end, about 2 cm (0.8 in) long, 12 cm (4.7 in) around; ..."
std::string overview_line(const PieceFacts& facts);

// Holders that are entered elsewhere than at their first stitch: where a second marker is hung.
struct SecondMarker {
  std::int32_t stitch = 0;  // of the held ones, from 1
  std::int32_t piece = 0;   // that begins with it
};
using SecondMarkers =
    std::map<std::pair<std::int32_t, std::int32_t>, SecondMarker>;  // by piece and number of the holder
SecondMarkers second_markers(const LimbPlan& plan);

}  // namespace knit
