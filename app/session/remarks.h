// What a finished run did not do as asked, for the list of problems, the report, the card and the pattern: one source.
#pragma once

#include <string>
#include <vector>

#include "knit/insight/as_asked.h"
#include "knit/run/timeline.h"

namespace app {

// As the pattern's counts make it, of a finished run.
knit::PieceSize size_knitted(const knit::State& state, const knit::Gauge& gauge);

// Size and swatch first, then what `coverage` shows; null: not measured. Empty before the run has finished.
std::vector<knit::Remark> remarks_of(const knit::Timeline& timeline, const knit::Coverage* coverage);

// For the pattern's notes: the first of each kind.
std::vector<std::string> notes_of(const std::vector<knit::Remark>& remarks);

}  // namespace app
