#include "app/reader/pattern_json_reader.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/base/json_fields.h"
#include "app/reader/pattern_json_rounds.h"
#include "knit/reader/reader_work.h"

namespace app {

namespace {

using PatternDocument = nlohmann::json;

// One tube: a chain of rounds, and the graph that they must make.
class TubeJsonReader {
 public:
  explicit TubeJsonReader(const PatternDocument& document) : fields_(document) {}

  knit::ReadPattern run() {
    only_fields(fields_, {"format", "version", "cast_on", "rounds", "graph", "short_rows"});
    const auto cast_on = static_cast<std::int32_t>(fields_.whole("cast_on", 1, knit::most_stitches));
    const std::size_t rounds = fields_.array("rounds").size(), rows = fields_.array("graph").size();
    if (fields_.fault().empty() && rows != rounds + 1)
      fail("graph", ": " + std::to_string(rows) + (rows == 1 ? " row is" : " rows are") +
                        " told, the cast on and the rounds make " + std::to_string(rounds + 1) + ".");
    if (!fails()) {
      read_.rounds.cast_on = cast_on;
      read_.stitches = cast_on;
      fail("graph[0]", cast_on_fault(fields_.json()["graph"][0], cast_on));
    }
    for (std::size_t i = 0; i < rounds && !fails(); ++i) work(i);
    if (!fails()) fail("short_rows", short_rows_fault(fields_.json(), read_.short_rows));
    return std::move(read_);
  }

 private:
  void work(std::size_t index) {
    JsonFields fields = fields_.entry("rounds", index);
    JsonRound round = json_round(fields);
    if (fields.has("slips_back"))
      fields.set_fault("slips_back", "is told of one piece, whose rounds begin at the marker.");
    if (fails()) return;
    const std::int32_t live = read_.rounds.last_count();
    const std::string number = "[" + std::to_string(index) + "]",
                      row = "graph[" + std::to_string(index + 1) + "]";
    const auto number_of = static_cast<std::int32_t>(index) + 2;
    if (const auto fault = round_fault(round, number_of, live); !fault.empty())
      return fail("rounds" + number, ": " + fault);
    fail(row, row_fault(fields_.json()["graph"][index + 1], round));
    ++read_.rounds_read;
    read_.stitches += round.after;
    const std::vector<knit::GraphShortRow> made = short_rows_of(round, static_cast<std::int32_t>(index));
    read_.short_rows.insert(read_.short_rows.end(), made.begin(), made.end());
    read_.rounds.rounds.push_back(
        {number_of, std::move(round.operations), live, round.after, std::move(round.pairs)});
  }
  void fail(const std::string& place, const std::string& fault) {
    if (read_.mistakes.empty() && !fault.empty()) read_.mistakes.push_back({0, place + fault});
  }
  bool fails() {
    fail("", fields_.fault());
    return !read_.mistakes.empty();
  }

  JsonFields fields_;
  knit::ReadPattern read_;
};

// "line 3, column 7"
std::string place_in(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last = before.rfind('\n');
  const std::size_t column = before.size() - (last == std::string_view::npos ? 0 : last + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

NoPattern fault_of_kind(const PatternDocument& document) {
  constexpr std::string_view format = "knit-mesh pattern";
  if (!document.is_object() || !document.contains("format") || document["format"] != format)
    return "it is JSON, but no pattern: \"format\" must be \"" + std::string(format) +
           "\"; give a file that --save-pattern wrote.";
  if (document.contains("version") && (document["version"] == 1 || document["version"] == 2)) return "";
  return "its \"version\" is not 1 or 2, which this program reads; open it with the knit-mesh that wrote it.";
}

}  // namespace

bool begins_like_json(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

JsonPattern read_pattern_json(std::string_view text) {
  PatternDocument document;
  try {
    document = PatternDocument::parse(text);
  } catch (const PatternDocument::parse_error& error) {
    return NoPattern("it is no whole JSON: what stands at " + place_in(text, error.byte) +
                     " does not go on with it; save the pattern again.");
  }
  if (auto fault = fault_of_kind(document); !fault.empty()) return fault;
  if (document["version"] == 1) return TubeJsonReader(document).run();
  return read_pieces_json(document);
}

}  // namespace app
