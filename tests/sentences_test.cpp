// All that whole runs say, of every example and of shapes that branch: one of a thing is no plural, no word stands twice, and
// what tells of tubes names them.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/explain/why_words.h"
#include "app/panels/tubes/tubes_words.h"
#include "app/session/document.h"
#include "knit/insight/breaks.h"
#include "knit/insight/causes.h"
#include "knit/insight/narrate.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/mesh/shapes.h"
#include "knit/model/words.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Without what stands about it: "(stitches);" is "stitches".
std::string bare(const std::string& word) {
  std::size_t begin = 0, end = word.size();
  const auto belongs = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  while (begin < end && !belongs(word[begin])) ++begin;
  while (begin < end && !belongs(word[end - 1])) --end;
  return word.substr(begin, end - begin);
}

// Words that end in s and are no plural: "stitch 1 goes to", "in 1 pass".
bool looks_plural(const std::string& word) {
  constexpr std::array<std::string_view, 11> others{"is",    "was",  "has",  "as",     "goes",  "gets",
                                                    "stays", "less", "pass", "across", "begins"};
  if (word == "vertices") return true;
  return word.size() > 1 && word.back() == 's' &&
         std::find(others.begin(), others.end(), word) == others.end();
}

// What is wrong with it; empty: nothing.
std::string fault_of(const std::string& sentence) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : sentence + " ") {
    if (c != ' ' && c != '\n') {
      word += c;
      continue;
    }
    words.push_back(word);
    word.clear();
  }
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string next = bare(words[i + 1]);
    const bool one = !words[i].empty() && words[i].back() == '1' && bare(words[i]) == "1";
    if (one && looks_plural(next)) return "1 " + next;
    const bool of_two_words = one && i + 2 < words.size() && (next == "stitch" || next == "row");
    if (of_two_words && looks_plural(bare(words[i + 2])) &&
        bare(words[i + 2]).find("idth") != std::string::npos)
      return "1 " + next + " " + words[i + 2];
    if (!words[i].empty() && is_letter(words[i].back()) && words[i] == words[i + 1])
      return words[i] + " twice";
  }
  return "";
}

// One sentence a fault, so that a failing test stays readable.
struct Faults {
  std::map<std::string, std::string> found;
  void read(const std::string& sentence) {
    const std::string fault = fault_of(sentence);
    if (!fault.empty()) found.emplace(fault, sentence);
  }
  void read(const Timeline& timeline) {
    for (std::size_t i = 0; i < timeline.known(); ++i)
      read(narrate(timeline.step(i), timeline.parameters_of_step(i)));
    if (timeline.stop() != nullptr) read(narrate(*timeline.stop(), timeline.parameters()));
  }
  void read(const TubePlan& plan, const TubeGraph* graph) {
    const app::TubesLayout layout = app::lay_out(plan);
    for (const std::string& words : app::plan_words(plan, layout, graph)) read(words);
    for (std::size_t i = 0; i < plan.tubes.size(); ++i)
      read(app::tube_words(plan, layout, static_cast<TubeId>(i), {}));
    for (std::size_t i = 0; i < plan.events.size(); ++i)
      read(app::event_words(plan, static_cast<std::int32_t>(i)));
  }
  void check() const {
    for (const auto& [fault, sentence] : found) {
      CAPTURE(fault, sentence);
      CHECK(false);
    }
  }
};

std::vector<std::string> all_examples() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(KNIT_ASSETS_DIR)) {
    if (std::filesystem::exists(entry.path() / "parameters.json"))
      names.push_back(entry.path().filename().string());
  }
  return names;
}

Timeline contour_run(const Mesh& mesh, double width, AxisKind axis = AxisKind::y) {
  const auto input = make_input(mesh);
  Parameters parameters;
  give_width(parameters, width);
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.timing.axis.kind = axis;
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  return timeline;
}

template <class What>
std::vector<std::string> sentences_of(const Timeline& timeline) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    if (is<What>(timeline.step(i)))
      sentences.push_back(narrate(timeline.step(i), timeline.parameters_of_step(i)));
  }
  return sentences;
}

}  // namespace

TEST_CASE("sentences: what the test looks for is found") {
  CHECK(fault_of("A limb, 0.5 rounds high and 1 stitches round.") == "1 stitches");
  CHECK(fault_of("It is (1 vertices), no more.") != "");
  CHECK(fault_of("The cuts are 1 stitch widths apart.") == "1 stitch widths");
  CHECK(fault_of("It is left out and and said.") == "and twice");
  for (const char* sound :
       {"11 stitches.", "1 stitch.", "Main stitch 1 goes to cell 1.", "In 1 pass.", "2.1 rounds."})
    CHECK(fault_of(sound) == "");
}

TEST_CASE("sentences: of no example's run is one a plural, and no word stands twice") {
  const std::vector<std::string> examples = all_examples();
  CHECK(examples.size() > 15);
  Faults faults;
  for (const std::string& name : examples) {
    app::Session session = test_support::example_session(name);
    REQUIRE(session.document);
    Timeline& timeline = session.document->timeline;
    timeline.extend_to_end();
    faults.read(timeline);
    const State& run = timeline.furthest();
    if (run.tubes) faults.read(*run.tubes, run.graph.pointer().get());
  }
  faults.check();
}

TEST_CASE("sentences: of shapes that branch in large stitches, too, where there is one of many things") {
  Faults faults;
  for (const double width : {0.15, 0.3, 0.45, 0.6, 0.9, 1.2}) {
    for (const AxisKind axis : {AxisKind::x, AxisKind::y}) {
      faults.read(contour_run(torus(48, 24, 0.68, 0.32), width, axis));
      faults.read(contour_run(test_support::arch(), width, axis));
    }
  }
  for (const char* condition : {"grows>1", "grows>2", "wider>1", "wider>1.3", "narrower<1", "hold", "row=1"})
    faults.read(words_of(std::get<BreakCondition>(parse_break(condition))));
  for (const double rows : {0.5, 1.0, 3.0}) {
    const auto size = static_cast<float>(rows);
    const Parameters parameters;
    for (const bool handle : {false, true})
      faults.read(narrate({{}, TubeLeftOut{handle, 7, size, size, 0.25F}}, parameters));
    faults.read(
        narrate({{}, TubeLeftOut{false, 7, size, size, 0.25F, static_cast<std::uint16_t>(rows + 0.5), 1}},
                parameters));
  }
  faults.check();
}

// --- tubes by name -------------------------------------------------------------------------------------------------

TEST_CASE("sentences: a split and a join name the tubes that part and meet") {
  const Timeline up = contour_run(test_support::arch(), 0.12);
  REQUIRE(up.furthest().fabric.deals().front()->kind == DealKind::join);
  const std::vector<std::string> meets = sentences_of<GapsFound>(up);
  REQUIRE(meets.size() == 1);
  CHECK(meets[0].find("Tubes A and B meet and go on as C at the saddle") == 0);
  const std::vector<std::string> joined = sentences_of<LoopsDealt>(up);
  REQUIRE(joined.size() == 1);
  CHECK(joined[0].find("The loops of tubes A and B, of ") == 0);
  CHECK(joined[0].find(" stitches for tube C.") != std::string::npos);

  Mesh horns = test_support::arch();
  for (glm::dvec3& p : horns.positions) p = {p.x, -p.y, -p.z};
  const Timeline down = contour_run(horns, 0.12);
  const std::vector<std::string> parts = sentences_of<GapsFound>(down);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].find("Tube A parts into B and C at the saddle") == 0);
  const Deal& deal = *down.furthest().fabric.deals().front();
  const std::vector<std::string> dealt = sentences_of<LoopsDealt>(down);
  REQUIRE(dealt.size() == 1);
  CHECK(dealt[0].find("into one of " + std::to_string(deal.given[0].size()) + " for B and one of " +
                      std::to_string(deal.given[1].size()) + " for C; 1 loop waits") != std::string::npos);
}

TEST_CASE("sentences: a tube without a round says which edge it is") {
  const auto input = make_input(torus(48, 24, 0.68, 0.32));
  Parameters parameters;
  give_width(parameters, 0.12);
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters.tubes.smoothing = Smoothing::off;
  Timeline timeline(input, resolved(parameters, *input));
  timeline.extend_to_end();
  std::size_t starts = 0, grafts = 0;
  for (const std::string& sentence : sentences_of<TubeTaken>(timeline)) {
    starts += sentence.find("the edge that two tubes start from") != std::string::npos ? 1U : 0U;
    grafts += sentence.find("the edge at which two tubes are grafted") != std::string::npos ? 1U : 0U;
    CHECK(sentence.find("passed through") == std::string::npos);
  }
  CHECK(starts == 1);
  CHECK(grafts == 1);
}

TEST_CASE("sentences: limbs lower than a twentieth of a round are told together") {
  // A tube with bumps on its upper end: each is a leaf of its own.
  const Timeline timeline = contour_run(test_support::arch(), 0.12);
  const TubeGraph& graph = *timeline.furthest().graph;
  TubesWork work;
  work.graph = Shared(graph);
  TubePlan plan = *timeline.furthest().tubes;
  const double height = timeline.parameters().stitch.height, width = timeline.parameters().stitch.width;
  for (const double rows : {0.003, 0.4, 0.02, 0.001})
    plan.left_out.push_back({false, rows * height, 4.0 * width, 7, 8, 0.01});
  plan.left_out.push_back({true, 0.01 * height, 4.0 * width, 9, 8, 0.01});  // a hole is always told
  work.plan = Shared(plan);
  work.phase = TubesPhase::plan;
  Shared<TubeGraph> made_graph;
  Shared<TubePlan> made_plan;
  std::vector<TubeLeftOut> told;
  for (;;) {
    const auto step =
        advance_tubes(timeline.input(), *timeline.furthest().timing, timeline.parameters().tubes,
                      timeline.parameters().stitch, work, {made_graph, made_plan});
    const auto* left = std::get_if<TubeLeftOut>(&std::get<TubesEvent>(step.what));
    if (left == nullptr) break;
    told.push_back(*left);
    REQUIRE(told.size() < 9);
  }
  REQUIRE(told.size() == 3);
  CHECK(told[0].rows == Approx(0.4));
  CHECK(told[0].together == 0);
  CHECK(told[1].handle);
  CHECK(told[2].together == 3);
  CHECK(told[2].rows == Approx(0.02));
  CHECK(told[2].at_most > 0);
  CHECK(told[2].at_most < 100);
  const std::string sentence = narrate({{}, told[2]}, timeline.parameters());
  CHECK(sentence.find("3 limbs lower than a twentieth of a round are left out, together at most 0.") == 0);
}

namespace {

// Significant digits of the longest number with a point; whole numbers count things.
std::size_t most_digits(const std::string& words) {
  std::size_t most = 0;
  const auto is_digit = [&](std::size_t i) { return i < words.size() && words[i] >= '0' && words[i] <= '9'; };
  for (std::size_t i = 0; i < words.size();) {
    if (!is_digit(i)) {
      ++i;
      continue;
    }
    std::size_t digits = 0, points = 0;
    for (; is_digit(i) || (words[i] == '.' && is_digit(i + 1)); ++i) {
      points += words[i] == '.' ? 1U : 0U;
      if (words[i] != '.' && (digits > 0 || words[i] != '0')) ++digits;
    }
    if (points == 1) most = std::max(most, digits);
  }
  return most;
}

}  // namespace

TEST_CASE("sentences: no number that is said has more than five digits") {
  CHECK(most_digits("0.01234 of 12345678 at 1.5") == 4);
  CHECK(most_digits("no. 1.234567") == 7);
  for (const char* example : {"thesis-sphere", "torus", "trousers"}) {
    INFO(example);
    app::Session session = test_support::example_session(example);
    Timeline& timeline = session.document->timeline;
    timeline.extend_to_end();
    std::size_t said = 0;
    const auto check = [&](const std::string& words) {
      said += words.empty() ? 0U : 1U;
      if (most_digits(words) <= 5) return;
      INFO(words);
      CHECK(false);
    };
    for (std::size_t step = 0; step < timeline.known(); step += 7)
      check(narrate(timeline.step(step), timeline.parameters_of_step(step)));
    for (RowId row = 1; row <= timeline.furthest().fabric.row_count(); ++row) {
      check(why_count(timeline, row));
      check(app::why_words(timeline, StitchElement{row, 1}));
      check(app::why_words(timeline, LabelElement{row, 1}));
    }
    for (VertexId vertex = 0; vertex < 40; ++vertex) check(app::why_words(timeline, VertexElement{vertex}));
    CHECK(said > 100);
  }
}
