// Where the run stands, in rows and rounds, and wishes to be elsewhere: shared by panels that list either.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/panels/kit/frame.h"

namespace app {

// Of the row in progress; none: 0.
std::int32_t current_row(const PanelFrame& frame);
// To the end of a row in the current stage.
void wish_row(PanelFrame& frame, std::int32_t number);
// Under the pointer, by a stitch, a square, a line of the text or the timeline.
std::optional<RoundSpan> rounds_meant(const Session& session);
// These and, where the same words stand for twins, theirs.
std::vector<RoundSpan> all_rounds_meant(const Session& session);

}  // namespace app
