// The variables of the pseudo-code: their symbols, what they mean, and their values at a place of the run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/explain/pseudo_code.h"
#include "knit/run/state.h"

namespace app {

// Null where there is no such variable.
const knit::CodeVariable* variable_named(std::string_view key);

struct Variable {
  const knit::CodeVariable* of;
  std::string value;  // in words; empty: it has none at this step
};
// Of the current listing, in its reading order. Every number of the step shown is the value of one of them
// (but a solve's, where it is the line itself).
std::vector<Variable> variables_of(const Session& session);

// The row that a step is about, as far as it has come. Pointers are into the session's state.
struct RowShown {
  const knit::Ring* ring = nullptr;     // once it is in order
  const knit::Row* finished = nullptr;  // once it is
  const knit::Row* below = nullptr;     // from the second row on
  std::optional<std::int32_t> level;    // of the levels, or of the cuts planned
  std::optional<double> time;
};
RowShown row_shown(const knit::State& state, std::int32_t row);

// The join that makes a row, once it is planned; else null.
const knit::Join* join_shown(const knit::State& state, std::int32_t row);

// The contour that a row is being made on; null: none is.
const knit::Ring* curve_shown(const knit::State& state);

// The ends, once they are found; else null.
const knit::Ends* ends_shown(const knit::State& state);

}  // namespace app
