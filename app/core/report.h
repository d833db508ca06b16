// The report: what came out, as JSON that scripts read. Its fields are a contract; docs/command-line.md lists
// them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "app/core/session.h"
#include "knit/pattern.h"

namespace app {

// Requires an open mesh.
nlohmann::ordered_json report_json(const Session& session);

// The label arrays of the rows finished so far; requires at least one row.
std::vector<knit::LabelRow> label_rows(const knit::State& state);

}  // namespace app
