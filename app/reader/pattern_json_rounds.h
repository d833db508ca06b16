// Rounds and rows of the JSON of a pattern, for the readers of pattern_json_reader.h: what is told is taken as it is wanted, or
// the fields have a fault; what does not add up is a sentence.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_fields.h"
#include "knit/pattern/rounds.h"

namespace app {

struct JsonRound {
  std::int32_t number = 0, before = 0, after = 0;
  bool slips_back = false;
  std::vector<knit::Operation> operations;
  std::vector<knit::ShortRowPair> pairs;
};
JsonRound json_round(JsonFields& fields);

// Why the round cannot be worked as number `number` on `live` stitches; empty: it can. "works 11 of 12 stitches."
std::string round_fault(const JsonRound& round, std::int32_t number, std::int64_t live);

// Where a row of the graph does not say what the round makes: "[4]: ..." after the row's place; empty: it does. A round's
// stitches hang on those of the row below, told from the marker.
std::string row_fault(const nlohmann::json& row, const JsonRound& round);
// The short rows of rounds, each with its number in the list of rows below; empty: they are told as the pairs make them.
std::vector<knit::GraphShortRow> short_rows_of(const JsonRound& round, std::int32_t below);
std::string short_rows_fault(const nlohmann::json& fields, const std::vector<knit::GraphShortRow>& made);
std::string cast_on_fault(const nlohmann::json& row, std::int64_t count);

// Blames a field that stands there and says nothing.
void only_fields(JsonFields& fields, std::initializer_list<std::string_view> known);

}  // namespace app
