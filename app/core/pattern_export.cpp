#include "app/core/pattern_export.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "knit/fold.h"
#include "knit/pattern_words.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using knit::Hand;

// --- knitspeak -----------------------------------------------------------------------------------

// Increases are capitals there.
std::string_view speak_word(Hand hand) {
  if (hand == Hand::m1r) return "M1R";
  return hand == Hand::m1l ? "M1L" : knit::word_of(hand);
}

std::string speak(const knit::Run& run) {
  const std::string word(speak_word(run.hand));
  if (run.hand == Hand::knit) return word + std::to_string(run.count);
  return run.count == 1 ? word : "[" + word + "] " + std::to_string(run.count) + " times";
}

std::string speak(const std::vector<knit::Run>& runs) {
  std::string out;
  for (const knit::Run& run : runs) out += (out.empty() ? "" : ", ") + speak(run);
  return out;
}

std::string speak(const knit::Phrase& phrase) {
  if (const auto* run = std::get_if<knit::Run>(&phrase)) return speak(*run);
  const auto& repeat = std::get<knit::Repeat>(phrase);
  return "[" + speak(repeat.runs) + "] " + std::to_string(repeat.times) + " times";
}

std::string speak(const std::vector<knit::Phrase>& phrases) {
  if (phrases.size() == 1) {
    if (const auto* repeat = std::get_if<knit::Repeat>(&phrases.front()))
      return "*" + speak(repeat->runs) + ", repeat from *";
    const auto& run = std::get<knit::Run>(phrases.front());
    if (run.hand == Hand::knit) return "knit";
    if (run.count > 1) return "*" + std::string(speak_word(run.hand)) + ", repeat from *";
  }
  std::string out;
  for (const knit::Phrase& phrase : phrases) out += (out.empty() ? "" : ", ") + speak(phrase);
  return out;
}

bool same_work(const knit::Round& a, const knit::Round& b) {
  return a.operations == b.operations && a.after == b.after;
}

// --- JSON ----------------------------------------------------------------------------------------

std::string_view json_word(Hand hand) { return hand == Hand::knit ? "knit" : knit::word_of(hand); }

Json operations_json(const std::vector<knit::Operation>& operations) {
  Json all = Json::array();
  for (std::size_t i = 0, end = 0; i < operations.size(); i = end) {
    for (end = i; end < operations.size() && operations[end] == operations[i];) ++end;
    Json run{{"hand", json_word(operations[i].hand)}, {"count", end - i}};
    if (operations[i].at_main) run["main"] = true;
    all.push_back(std::move(run));
  }
  return all;
}

Json stitch_json(const knit::GraphStitch& stitch, bool cast_on) {
  if (cast_on) return {{"hand", "cast on"}, {"below", Json::array()}};
  Json json{{"hand", json_word(stitch.hand)}, {"below", Json::array()}};
  for (std::int32_t i = 0; i < stitch.count; ++i) json["below"].push_back(stitch.first + i);
  if (stitch.count == 0) json["bar_after"] = stitch.first;
  return json;
}

std::string listed(std::string_view name, const std::vector<Json>& lines) {
  std::string out = "  \"" + std::string(name) + "\": [";
  for (std::size_t i = 0; i < lines.size(); ++i) out += (i == 0 ? "\n    " : ",\n    ") + lines[i].dump();
  return out + (lines.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string pattern_knitspeak(const knit::Rounds& rounds) {
  std::string out = "CO " + std::to_string(rounds.cast_on) + " sts (Rnd 1).\n";
  for (std::size_t i = 0, end = 0; i < rounds.rounds.size(); i = end) {
    const knit::Round& round = rounds.rounds[i];
    for (end = i + 1; end < rounds.rounds.size() && same_work(round, rounds.rounds[end]);) ++end;
    const std::string first = std::to_string(round.number);
    const std::string numbers = end - i == 1
                                    ? "Round " + first
                                    : "Rounds " + first + "-" + std::to_string(rounds.rounds[end - 1].number);
    out += numbers + ": " + speak(knit::fold(round.operations)) + ". (" + std::to_string(round.after) +
           " sts)\n";
  }
  return out;
}

std::string pattern_json(const knit::Rounds& rounds) {
  std::vector<Json> worked, graph;
  for (const knit::Round& round : rounds.rounds)
    worked.push_back({{"number", round.number},
                      {"before", round.before},
                      {"after", round.after},
                      {"operations", operations_json(round.operations)}});
  for (const std::vector<knit::GraphStitch>& row : knit::graph_of(rounds).rows) {
    Json stitches = Json::array();
    for (const knit::GraphStitch& stitch : row) stitches.push_back(stitch_json(stitch, graph.empty()));
    graph.push_back(std::move(stitches));
  }
  return "{\n  \"format\": \"knit-mesh pattern\",\n  \"version\": 1,\n  \"cast_on\": " +
         std::to_string(rounds.cast_on) + ",\n" + listed("rounds", worked) + ",\n" + listed("graph", graph) +
         "\n}\n";
}

}  // namespace app
