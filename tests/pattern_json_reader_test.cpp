// The JSON of a pattern read back: one tube, pieces written by hand, and mutants, each refused at a place in the file.
#include "app/reader/pattern_json_reader.h"

#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "app/files/pattern_json.h"
#include "app/script/subcommands.h"
#include "knit/limbs/limb_plan.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/hand_rounds.h"
#include "tests/support/limb_hands.h"
#include "tests/support/random_fabric.h"
#include "tests/support/standing_run.h"

using namespace knit;
using nlohmann::json;

namespace {

ReadLimbs pieces_in(const std::string& text) {
  auto read = app::read_pattern_json(text);
  REQUIRE(std::holds_alternative<ReadLimbs>(read));
  return std::get<ReadLimbs>(std::move(read));
}

ReadPattern tube_in(const std::string& text) {
  auto read = app::read_pattern_json(text);
  REQUIRE(std::holds_alternative<ReadPattern>(read));
  return std::get<ReadPattern>(std::move(read));
}

template <class Read>
std::string mistake_of(const Read& read) {
  return read.mistakes.empty() ? "" : read.mistakes.front().sentence;
}

// A mistake, or why it is no pattern.
std::string said_of(const std::string& text) {
  const auto read = app::read_pattern_json(text);
  if (const auto* why = std::get_if<app::NoPattern>(&read)) return *why;
  const auto* limbs = std::get_if<ReadLimbs>(&read);
  return limbs != nullptr ? mistake_of(*limbs) : mistake_of(std::get<ReadPattern>(read));
}

// --- two legs and a body, by hand --------------------------------------------------------------------------------

json knit_row(std::int32_t count) {
  json row = json::array();
  for (std::int32_t i = 0; i < count; ++i) row.push_back({{"hand", "knit"}, {"below", {i}}});
  return row;
}

json cast_on_row(std::int32_t count) {
  return json(static_cast<std::size_t>(count), json{{"hand", "cast on"}, {"below", json::array()}});
}

json round_of(std::int32_t number, std::int32_t count) {
  return {{"number", number},
          {"before", count},
          {"after", count},
          {"operations", {{{"hand", "knit"}, {"count", count}}}}};
}

json leg(const std::string& name, std::int32_t row, const json& end) {
  return {{"name", name},
          {"begin", {{{"kind", "cast on"}, {"after", 6}}}},
          {"rounds", {round_of(2, 6)}},
          {"graph", {cast_on_row(6), knit_row(6)}},
          {"rows", {row, row + 1}},
          {"starts", {0, 0}},
          {"end", end}};
}

// Three of leg B, two across the gap, leg A from its fifth stitch on, the gap backwards, the other three of leg B.
json two_legs() {
  const json items = {{{"use", "keep"}, {"count", 3}},
                      {{"use", "cast on"}, {"count", 2}, {"gap", 1}},
                      {{"use", "take"}, {"count", 6}, {"holder", "Leg A"}, {"first", 4}, {"held", 6}},
                      {{"use", "pick up"}, {"count", 2}, {"gap", 1}, {"first", 1}},
                      {{"use", "keep"}, {"count", 3}}};
  const json live = {json{"Leg B", 0, 3, 1}, json{"gap 1", 0, 2, 1},  json{"Leg A", 4, 2, 1},
                     json{"Leg A", 0, 4, 1}, json{"gap 1", 1, 2, -1}, json{"Leg B", 3, 3, 1}};
  const json body = {{"name", "Body C"},
                     {"begin", {{{"kind", "join"}, {"after", 16}, {"items", items}}}},
                     {"live", live},
                     {"rounds", {round_of(1, 16)}},
                     {"graph", {knit_row(16)}},
                     {"rows", {5}},
                     {"starts", {0}},
                     {"end", {{"kind", "closed"}}}};
  json second = leg("Leg B", 3, {{"kind", "goes on"}, {"piece", "Body C"}});
  second["twin_of"] = "Leg A";
  return {{"format", "knit-mesh pattern"},
          {"version", 2},
          {"yarns", 2},
          {"holders", 1},
          {"holders_needed", 1},
          {"gaps", {2}},
          {"pieces", {leg("Leg A", 1, {{"kind", "held"}}), second, body}}};
}

// --- mutants -----------------------------------------------------------------------------------------------------

struct JsonMutant {
  json::json_pointer place;
  json other;  // null: dropped
};

// All values that are no lists or objects, and all entries and fields that can be dropped.
void list_places(const json& value, const json::json_pointer& at, std::vector<json::json_pointer>& places) {
  if (!at.empty()) places.push_back(at);
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) list_places(inner, at / key, places);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) list_places(value[i], at / i, places);
  }
}

std::vector<json> others_for(const json& value, const std::vector<std::string>& names) {
  if (value.is_number()) return {value.get<int>() - 1, value.get<int>() + 1};
  if (value.is_boolean()) return {!value.get<bool>()};
  std::vector<json> others;
  if (!value.is_string()) return others;
  for (const std::string& name : names) {
    if (value != name) others.emplace_back(name);
  }
  for (const char* word : {"held", "closed", "divide", "keep", "pick up", "knit", "k2tog", "m1l"}) {
    if (value != word) others.emplace_back(word);
  }
  return others;
}

// What no other number proves: a beginning in the fabric's row, and remarks of a kind.
bool proves_nothing(const std::string& place) {
  return place.find("/starts/") != std::string::npos || place.ends_with("/inner") || place.ends_with("/main");
}

// Of every `every`th value.
std::vector<JsonMutant> json_mutants_of(const json& document, std::size_t every) {
  std::vector<json::json_pointer> places;
  list_places(document, json::json_pointer(), places);
  std::vector<std::string> names{"Limb Z"};
  if (document.contains("pieces"))
    for (const json& piece : document["pieces"]) names.push_back(piece["name"]);
  std::vector<JsonMutant> mutants;
  for (std::size_t i = 0; i < places.size(); i += every) {
    const std::string place = places[i].to_string();
    if (proves_nothing(place)) continue;
    for (const json& other : others_for(document[places[i]], names)) mutants.push_back({places[i], other});
    if (!place.ends_with("/twin_of")) mutants.push_back({places[i], nullptr});  // need not be told
  }
  return mutants;
}

// The same with the value changed, or dropped where it is null.
json changed_at(const json& document, const json::json_pointer& place, const json& other) {
  json changed = document;
  if (!other.is_null()) {
    changed[place] = other;
    return changed;
  }
  json& parent = changed[place.parent_pointer()];
  if (parent.is_array())
    parent.erase(std::stoul(place.back()));
  else
    parent.erase(place.back());
  return changed;
}

// "/pieces/2/rounds/5/after": "pieces[2]"; empty where it is of no piece.
std::string piece_at(const std::string& place) {
  constexpr std::string_view pieces = "/pieces/";
  if (!place.starts_with(pieces)) return "";
  return "pieces[" + place.substr(pieces.size(), place.find('/', pieces.size()) - pieces.size()) + "]";
}

bool is_told_in_its_piece(const std::string& place) {
  for (const char* part : {"/rounds", "/graph", "/live", "/after", "/count", "/first"}) {
    if (place.find(part) != std::string::npos) return true;
  }
  return false;
}

std::size_t check_json_mutants(const json& document, std::size_t every) {
  const std::vector<JsonMutant> mutants = json_mutants_of(document, every);
  const bool in_pieces = document["version"] == 2;
  for (const JsonMutant& mutant : mutants) {
    const std::string place = mutant.place.to_string(), other = mutant.other.dump();
    const json changed = changed_at(document, mutant.place, mutant.other);
    CAPTURE(place, other);
    // What changes nothing but numbers need not be written anew.
    const std::string said = in_pieces && place != "/format" && place != "/version"
                                 ? mistake_of(app::read_pieces_json(changed))
                                 : said_of(changed.dump());
    CAPTURE(said);
    if (said.empty()) FAIL_CHECK("the mutant is not refused");
    if (is_told_in_its_piece(place) && said.find(piece_at(place)) == std::string::npos)
      FAIL_CHECK("the mistake is told of another piece");
  }
  return mutants.size();
}

// What is said when the value there is another, or is dropped.
std::string said_with(const char* place, const json& other) {
  return said_of(changed_at(two_legs(), json::json_pointer(place), other).dump());
}

json written(const State& state) { return json::parse(app::pattern_json(plan_limbs(state))); }

}  // namespace

TEST_CASE("json reader: pieces written by hand become stitches") {
  const ReadLimbs read = pieces_in(two_legs().dump());
  REQUIRE(mistake_of(read) == "");
  REQUIRE(read.limbs.size() == 3);
  CHECK(read.limbs[0].name == "Leg A");
  CHECK(read.cast_on == 12);
  CHECK(read.rounds_read == 3);
  CHECK(read.gaps == std::vector<std::vector<std::int32_t>>{{24, 25}});
  const std::vector<std::int32_t> live{18, 19, 20, 24, 25, 10, 11, 6, 7, 8, 9, 25, 24, 21, 22, 23};
  CHECK(read.limbs[2].live == live);
  CHECK(read.limbs[2].rows.front().size() == 16);
  CHECK(read.stitches[26] == ReadStitch{Hand::knit, 18, -1});
  CHECK(read.closed.size() == 1);
}

TEST_CASE("json reader: what is wrong is said with its place") {
  CHECK(said_with("/pieces/2/begin/0/after", 17) ==
        "pieces[2].begin[0]: 16 stitches are on the needle, \"after\" says 17.");
  CHECK(said_with("/pieces/1/rounds/0/operations/0/count", 5) ==
        "pieces[1].rounds[0]: works 5 of 6 stitches.");
  CHECK(said_with("/pieces/1/rounds/0/number", 3) ==
        "pieces[1].rounds[0]: round 2 is next, \"number\" says 3.");
  CHECK(said_with("/pieces/1/graph/1/3/below/0", 2) ==
        "pieces[1].graph[1][3]: \"below\" must be [3], as the round works it.");
  CHECK(said_with("/pieces/2/begin/0/items/2/holder", "Leg Z") ==
        "pieces[2].begin[0].items[2].holder: there is no piece \"Leg Z\".");
  CHECK(said_with("/pieces/2/begin/0/items/2/holder", "Leg B") ==
        "pieces[2].begin[0].items[2].holder: there are no held stitches of Leg B.");
  CHECK(said_with("/pieces/1/end/piece", "Body D") == "pieces[1].end.piece: there is no piece \"Body D\".");
  CHECK(said_with("/pieces/2/begin/0/items/1", nullptr) ==
        "pieces[2].begin[0].items[2]: gap 1 was not cast on.");
  CHECK(said_with("/pieces/2/begin/0/items/1/count", 3) ==
        "pieces[2].begin[0].items[1]: 3 stitches are cast on across gap 1, \"gaps[0]\" says 2.");
  CHECK(said_with("/pieces/2/begin/0/items/3/count", 3) ==
        "pieces[2].begin[0].items[3]: 3 stitches from stitch 1 backwards are not in gap 1 of 2 stitches.");
  CHECK(said_with("/pieces/2/begin/0/items/2/count", 5) ==
        "pieces[2].begin[0]: not all of Leg A is taken: 5 of 6 stitches.");
  CHECK(said_with("/pieces/2/begin/0/items/0/count", 2) ==
        "pieces[2].begin[0]: 5 of 6 stitches on the needle are used.");
  CHECK(said_with("/pieces/2/begin/0/items/2/first", 5) ==
        "pieces[2].live[2]: another stitch lies there after the deals: the 6. from the marker.");
  CHECK(said_with("/pieces/2/begin/0/kind", "rejoin") ==
        "pieces[2].begin[0]: 6 stitches are still on the needle: hold them or close them first.");
  CHECK(said_with("/pieces/0/end/kind", "closed") ==
        "pieces[2].begin[0].items[2].holder: there are no held stitches of Leg A.");
  CHECK(said_with("/pieces/2/end/kind", "held") == "pieces: 16 stitches are left on the holder of Body C.");
  CHECK(said_with("/pieces/2/begin/0", nullptr) == "pieces[2].begin: nothing says how Body C begins.");
  CHECK(said_with("/pieces/1/rounds/0/after", nullptr) ==
        "\"pieces[1].rounds[0].after\" is missing; add it, or save the file again.");
  CHECK(said_with("/pieces/1/rounds/0/slips", true) ==
        "\"pieces[1].rounds[0].slips\" is no field of a pattern; remove it.");
  CHECK(said_with("/yarns", 3) == "yarns: 2 are used, 3 are told.");
}

TEST_CASE("json reader: every value that is changed or dropped is refused") {
  std::size_t mutants = check_json_mutants(two_legs(), 1);
  mutants += check_json_mutants(written(test_support::standing_run(torus(32, 16, 1.0, 0.4), 0.12)), 211);
  mutants += check_json_mutants(written(test_support::standing_run(test_support::arch(), 0.1)), 211);
  CHECK(mutants > 700);
}

TEST_CASE("json reader: mutants of fabrics of no shape") {
  std::size_t mutants = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    const State state = test_support::RandomFabric(seed).run(4);
    if (has_limbs(state)) mutants += check_json_mutants(written(state), 37);
  }
  CHECK(mutants > 700);
}

TEST_CASE("json reader: a thousand fabrics of no shape come back, stitch by stitch") {
  std::size_t in_pieces = 0;
  for (unsigned seed = 1000; in_pieces < 1000; ++seed) {
    CAPTURE(seed);
    REQUIRE(seed < 3000);
    const State state = test_support::RandomFabric(seed).run(1 + static_cast<int>(seed % 3));
    if (!has_limbs(state) || !limbs_are_known(state)) continue;
    ++in_pieces;
    const LimbPlan plan = plan_limbs(state);
    const ReadLimbs read = pieces_in(app::pattern_json(plan));
    REQUIRE(mistake_of(read) == "");
    REQUIRE(test_support::same_graph(read, test_support::PlanHands(plan).run()));
  }
}

TEST_CASE("json reader: one tube is read, and its mutants are refused") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const Rounds rounds = test_support::random_rounds(seed);
    const std::string text = app::pattern_json(rounds);
    const ReadPattern read = tube_in(text);
    REQUIRE(mistake_of(read) == "");
    CHECK(graph_of(read.rounds) == graph_of(rounds));
    CHECK(read.rounds_read == rounds.rounds.size());
    if (seed < 4) CHECK(check_json_mutants(json::parse(text), 97) > 5);
  }
  json tube = json::parse(app::pattern_json(test_support::random_rounds(3)));
  tube["rounds"][1]["after"] = 99;
  CHECK(mistake_of(tube_in(tube.dump())).starts_with("rounds[1]: makes "));
}

TEST_CASE("json reader: what is no pattern is told in one sentence") {
  const auto said = [](const std::string& text) {
    const app::Answer answer = app::check_text(text, "scarf.json");
    CHECK(answer.exit_code == 2);
    CHECK(answer.out.empty());
    return answer.error;
  };
  const std::string begin = "check: scarf.json cannot be read: ";
  CHECK(said("{\n  \"format\": \"knit-mesh pattern\",\n  \"version\" 2}") ==
        begin +
            "it is no whole JSON: what stands at line 3, column 13 does not go on with it; save the "
            "pattern again.");
  CHECK(said("{}") == begin +
                          "it is JSON, but no pattern: \"format\" must be \"knit-mesh pattern\"; give a "
                          "file that --save-pattern wrote.");
  CHECK(said(R"({"format": "knit-mesh pattern", "version": 3})") ==
        begin +
            "its \"version\" is not 1 or 2, which this program reads; open it with the knit-mesh that "
            "wrote it.");
  const std::string whole = two_legs().dump(1);
  for (std::size_t end = 1; end < whole.size(); end += 37) said(whole.substr(0, end));
}

TEST_CASE("json reader: check works out a pattern's JSON") {
  const app::Answer sound = app::check_text(two_legs().dump(), "legs.json");
  CHECK(sound.exit_code == 0);
  CHECK(sound.out == "3 rounds read, 12 stitches cast on, 42 stitches in all: every count holds.\n");
  json wrong = two_legs();
  wrong["pieces"][1]["rounds"][0]["before"] = 7;
  const app::Answer answer = app::check_text(wrong.dump(), "legs.json");
  CHECK(answer.exit_code == 1);
  CHECK(answer.out ==
        "pieces[1].rounds[0]: 6 stitches are on the needle, \"before\" says 7.\n"
        "1 round read, 12 stitches cast on, 18 stitches in all: 1 mistake.\n");
}

TEST_CASE("pattern JSON: check --json answers in the shape of written patterns") {
  const auto told = [](const json& pattern) {
    return json::parse(app::check_text(pattern.dump(), "legs.json", app::CheckForm::json).out);
  };
  const json sound = told(two_legs());
  CHECK(sound["verdict"] == "holds");
  CHECK(sound["rounds"] == 3);
  CHECK(sound["sizes"][0]["lines"].empty());
  json wrong = two_legs();
  wrong["pieces"][1]["rounds"][0]["before"] = 7;
  CHECK(app::check_text(wrong.dump(), "legs.json", app::CheckForm::json).exit_code == 1);
  const json answer = told(wrong);
  CHECK(answer["verdict"] == "does not add up");
  CHECK(answer["sizes"][0]["verdict"] == "does not add up");
  CHECK(answer["sizes"][0]["lines"][0]["sentence"] ==
        "pieces[1].rounds[0]: 6 stitches are on the needle, \"before\" says 7.");
  const json written =
      json::parse(app::check_text("CO 6 sts.\nRnd 1: Knit.\n", "ball", app::CheckForm::json).out);
  json keys = json::array(), own = json::array();
  for (const auto& [key, value] : written.items()) keys.push_back(key);
  for (const auto& [key, value] : answer.items()) own.push_back(key);
  CHECK(own == keys);
}
