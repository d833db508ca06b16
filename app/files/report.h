// A step as JSON, one object a line: what step logs and reports are made of.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "app/session/session.h"
#include "knit/model/settings_table.h"
#include "knit/quality/closeness.h"
#include "knit/quality/coverage.h"
#include "knit/quality/quality.h"
#include "knit/run/step.h"
#include "knit/stitches/appendix.h"

namespace app {

nlohmann::ordered_json to_json(const knit::Parameters& parameters);

// `index`: the step's number in the run, from 1.
nlohmann::ordered_json to_json(const knit::Step& step, std::size_t index, const knit::Parameters& parameters);

// The report card as JSON, for the report and for scripts. Its fields are a contract.
//
// What is not there yet is null: a whole group without values (`wale`, `mirror`, `distance`), else the value.

nlohmann::ordered_json to_json(const knit::Quality& quality);
nlohmann::ordered_json to_json(const knit::Closeness& closeness);
nlohmann::ordered_json to_json(const knit::Uncovered& uncovered);
nlohmann::ordered_json to_json(const std::vector<knit::Stretched>& stretched);

// Both in one object. Without a closeness, `distance` and `area_ratio` are null.
nlohmann::ordered_json quality_json(const knit::Quality& quality, const knit::Closeness* closeness);

// The report: what came out, as JSON that scripts read. Its fields are a contract; docs/command-line.md lists
// them.

// Requires an open mesh.
nlohmann::ordered_json report_json(const Session& session);

// The label arrays of the rows finished so far, tube after tube in working order; requires at least one row.
struct TubeLabels {
  knit::TubeId tube = 0;
  std::vector<knit::LabelRow> rows;  // numbered without short rows
  knit::RowId last = 0;              // of the fabric
};
std::vector<TubeLabels> label_rows(const knit::State& state);

}  // namespace app
