// Stage settle, one iteration a step: the stitches find where they are at ease. docs/algorithm.md, Settling.
#pragma once

#include "knit/model/event.h"
#include "knit/settle/settle.h"
#include "knit/settle/settle_events.h"

namespace knit {

// The fabric's stitches are moved with each iteration; it needs faces.
Advanced<SettleEvent> advance_settle(const Input& input, const SettleSettings& settings,
                                     const StitchSize& stitch, SettleWork& work, Fabric& fabric,
                                     const Heard& heard = {});

}  // namespace knit
