#include "app/reader/pattern_json_rounds.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "knit/pattern/passes.h"
#include "knit/reader/reader_work.h"

namespace app {

namespace {

using RowJson = nlohmann::json;

constexpr std::array<std::string_view, 5> hands_told{"knit", "m1r", "m1l", "k2tog", "ssk"};
static_assert(hands_told.size() == static_cast<std::size_t>(knit::Hand::ssk) + 1);

std::string_view told(knit::Hand hand) { return hands_told.at(static_cast<std::size_t>(hand)); }

bool says(const RowJson& stitch, const char* key, std::string_view word) {
  return stitch.contains(key) && stitch[key].is_string() && stitch[key] == word;
}

std::string in_list(const std::vector<std::int64_t>& numbers) {
  std::string all;
  for (const std::int64_t number : numbers) all += (all.empty() ? "" : ", ") + std::to_string(number);
  return "[" + all + "]";
}

std::string stitch_fault(const RowJson& stitch, std::string_view hand, const std::vector<std::int64_t>& below,
                         std::int64_t bar_after) {
  if (!stitch.is_object() || !says(stitch, "hand", hand))
    return "\"hand\" must be \"" + std::string(hand) + "\", as the round works it.";
  if (!stitch.contains("below") || stitch["below"] != RowJson(below))
    return "\"below\" must be " + in_list(below) + ", as the round works it.";
  const bool is_bar = bar_after >= 0;
  if (is_bar ? !stitch.contains("bar_after") || stitch["bar_after"] != bar_after
             : stitch.contains("bar_after"))
    return is_bar ? "\"bar_after\" must be " + std::to_string(bar_after) + ", as the round works it."
                  : "\"bar_after\" is told of a stitch that is not made from a bar.";
  return stitch.size() == (is_bar ? 3U : 2U) ? "" : "a field is not known; remove it.";
}

std::string length_fault(const RowJson& row, std::int64_t count) {
  if (!row.is_array()) return ": must be a list of stitches, [ ... ].";
  const auto there = static_cast<std::int64_t>(row.size());
  if (there == count) return "";
  return ": " + knit::stitches_text(there) + (there == 1 ? " is" : " are") + " told, the round makes " +
         std::to_string(count) + ".";
}

void read_pairs(JsonFields& fields, JsonRound& round) {
  for (const RowJson& pair : fields.array("pairs")) {
    const auto column = [](const RowJson& value) {
      return value.is_number_integer() && value >= -knit::most_stitches && value <= knit::most_stitches;
    };
    if (!pair.is_array() || pair.size() != 2 || !column(pair[0]) || !column(pair[1]))
      return fields.set_fault("pairs", "must hold [first, last] of each pair of short rows.");
    round.pairs.push_back({pair[0].get<std::int32_t>(), pair[1].get<std::int32_t>()});
  }
}

}  // namespace

void only_fields(JsonFields& fields, std::initializer_list<std::string_view> known) {
  if (!fields.json().is_object()) return;
  for (const auto& [key, value] : fields.json().items()) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      fields.set_fault(key, "is no field of a pattern; remove it.");
  }
}

JsonRound json_round(JsonFields& fields) {
  JsonRound round;
  only_fields(fields, {"number", "before", "after", "operations", "slips_back", "pairs"});
  const auto count = [&](const char* key) {
    return static_cast<std::int32_t>(fields.whole(key, 0, knit::most_stitches));
  };
  round.number = count("number");
  round.before = count("before");
  round.after = count("after");
  round.slips_back = fields.has("slips_back") && fields.flag("slips_back");
  const std::size_t runs = fields.array("operations").size();
  for (std::size_t i = 0; i < runs && fields.fault().empty(); ++i) {
    JsonFields run = fields.entry("operations", i);
    only_fields(run, {"hand", "count", "main"});
    const auto hand = static_cast<knit::Hand>(run.choice("hand", hands_told));
    const bool main = run.has("main") && run.flag("main");
    const auto times = static_cast<std::size_t>(run.whole("count", 1, knit::most_stitches));
    if (round.operations.size() + times > static_cast<std::size_t>(knit::most_stitches)) {
      fields.set_fault("operations",
                       "make more than " + std::to_string(knit::most_stitches) + " stitches in a round.");
      break;
    }
    round.operations.insert(round.operations.end(), times, {hand, main});
  }
  if (fields.has("pairs")) read_pairs(fields, round);
  return round;
}

std::vector<knit::GraphShortRow> short_rows_of(const JsonRound& round, std::int32_t below) {
  const knit::Rounds alone{round.before, {{2, round.operations, round.before, round.after, round.pairs}}};
  std::vector<knit::GraphShortRow> rows = knit::graph_of(alone).short_rows;
  for (knit::GraphShortRow& row : rows) row.row = below;
  return rows;
}

std::string short_rows_fault(const RowJson& fields, const std::vector<knit::GraphShortRow>& made) {
  RowJson wanted = RowJson::array();
  for (const knit::GraphShortRow& row : made)
    wanted.push_back({{"row", row.row},
                      {"first", row.first},
                      {"stitches", row.stitches},
                      {"side", row.wrong_side ? "WS" : "RS"},
                      {"worked", row.worked}});
  const RowJson& there = fields.contains("short_rows") ? fields["short_rows"] : RowJson::array();
  if (!there.is_array()) return ": must be a list of short rows, [ ... ].";
  for (std::size_t i = 0; i < std::min(there.size(), wanted.size()); ++i) {
    if (there[i] != wanted[i])
      return "[" + std::to_string(i) + "]: must be " + wanted[i].dump() + ", as the pairs say.";
  }
  if (there.size() == wanted.size()) return "";
  return ": " + std::to_string(there.size()) + " are told, the pairs make " + std::to_string(wanted.size()) +
         ".";
}

std::string round_fault(const JsonRound& round, std::int32_t number, std::int64_t live) {
  if (round.number != number)
    return "round " + std::to_string(number) + " is next, \"number\" says " + std::to_string(round.number) +
           ".";
  if (live == 0) return "there are no stitches on the needle.";
  if (round.before != live)
    return knit::stitches_text(live) + (live == 1 ? " is" : " are") + " on the needle, \"before\" says " +
           std::to_string(round.before) + ".";
  const knit::OperationCount all = knit::count(round.operations);
  if (all.consumed != live)
    return "works " + std::to_string(all.consumed) + " of " + knit::stitches_text(live) + ".";
  if (all.produced != round.after)
    return "makes " + knit::stitches_text(all.produced) + ", \"after\" says " + std::to_string(round.after) +
           ".";
  if (round.pairs.empty()) return "";
  if (round.slips_back) return "short rows stand before a last stitch that is slipped back.";
  if (!knit::can_be_worked({2, round.operations, round.before, round.after, round.pairs}))
    return "its pairs of short rows cannot be worked: each needs 3 stitches, turns between plain ones, and "
           "lies over the "
           "beginning of the round or a stitch away from it.";
  return "";
}

std::string row_fault(const RowJson& row, const JsonRound& round) {
  if (auto fault = length_fault(row, round.after); !fault.empty()) return fault;
  const std::int64_t n = round.before;
  // From the marker. The stitch that is slipped back comes first and is the last of them.
  const auto from_marker = [&](std::int64_t worked) {
    return round.slips_back ? (worked - 1 + n) % n : worked;
  };
  std::int64_t worked = 0;
  for (std::size_t i = 0; i < round.operations.size(); ++i) {
    const knit::Hand hand = round.operations[i].hand;
    const std::int64_t takes = knit::consumed_by(hand);
    std::vector<std::int64_t> below;
    for (std::int64_t k = 0; k < takes; ++k) below.push_back(from_marker(worked + k));
    const auto fault = stitch_fault(row[i], told(hand), below, takes == 0 ? from_marker(worked) : -1);
    if (!fault.empty()) return "[" + std::to_string(i) + "]: " + fault;
    worked += takes;
  }
  return "";
}

std::string cast_on_fault(const RowJson& row, std::int64_t count) {
  if (auto fault = length_fault(row, count); !fault.empty()) return fault;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (const auto fault = stitch_fault(row[i], "cast on", {}, -1); !fault.empty())
      return "[" + std::to_string(i) + "]: " + fault;
  }
  return "";
}

}  // namespace app
