// The pseudo-code against real runs: every kind of step has its line, every line has its step, and every number
// of a step is the value of a variable.
#include "app/explain/pseudo_code.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "app/explain/code_variables.h"
#include "app/explain/step_table.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "knit/insight/narrate.h"
#include "knit/insight/step_fields.h"
#include "knit/model/stitch_size.h"
#include "knit/model/words.h"
#include "knit/run/machine.h"
#include "knit/timing/timing_code.h"
#include "tests/support/bent_ellipsoid.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;

namespace {

Session run_with(const knit::Parameters& parameters) {
  Session session = test_support::small_session();
  session.document->timeline = knit::Timeline(session.document->timeline.input_pointer(), parameters);
  session.document->timeline.extend_to_end();
  return session;
}

template <class Change>
Session run_changed(Change change) {
  knit::Parameters parameters = test_support::small_parameters();
  change(parameters);
  return run_with(parameters);
}

Session example_with(const std::string& name) {
  Session session = test_support::example_session(name);
  session.document->timeline.extend_to_end();
  return session;
}

Session standing_torus(double width) {
  Session session = test_support::example_session("torus");
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.rows.source = knit::RowSource::contours;
  parameters.timing.axis.kind = knit::AxisKind::x;
  parameters.tubes.smoothing = knit::Smoothing::by_itself;
  knit::give_width(parameters, width);
  session.document->timeline.tune(parameters);
  session.document->timeline.extend_to_end();
  return session;
}

Session edited_on_the_way() {
  Session session = run_changed([](knit::Parameters& p) { p.rows.source = knit::RowSource::contours; });
  knit::Timeline& timeline = session.document->timeline;
  timeline.seek(timeline.position_of({knit::Stage::rows, 4, 0}));
  knit::Parameters parameters = timeline.parameters();
  knit::give_height(parameters, 0.1);
  timeline.edit_from_here(parameters);
  timeline.extend_to_end();
  return session;
}

// Together they take every way through the algorithm.
std::vector<Session> all_ways() {
  using knit::Parameters;
  std::vector<Session> runs;
  const auto add = [&](auto change) { runs.push_back(run_changed(change)); };
  add([](Parameters& p) { p.timing.start = 100, p.timing.end = 500; });
  for (const auto kind :
       {knit::TimingKind::arc_length, knit::TimingKind::geodesic, knit::TimingKind::harmonic}) {
    add([&](Parameters& p) {
      p.timing.kind = kind, p.timing.start = 100, p.timing.end = 300, knit::give_width(p, 0.5);
    });
    add([&](Parameters& p) { p.timing.kind = kind; });
  }
  add([](Parameters& p) { p.timing.start = 7, p.timing.end = 7; });
  for (const char* axis : {"y", "x"}) {
    add([&](Parameters& p) {
      p.timing.axis.kind = *axis == 'x' ? knit::AxisKind::x : knit::AxisKind::y;
      p.timing.kind = knit::TimingKind::by_itself, p.rows.source = knit::RowSource::by_itself;
    });
  }
  add([](Parameters& p) { knit::give_epsilon(p, 0.01); });
  add([](Parameters& p) { knit::give_epsilon(p, 0.01), p.rows.on_stall = knit::OnStall::stop; });
  add([](Parameters& p) { knit::give_width(p, 9.0); });
  add([](Parameters& p) { p.rows.cast_on = 3, p.rows.last_anchor = knit::LastAnchor::drop; });
  add([](Parameters& p) { p.rows.cast_on = 3, p.rows.resample = knit::Resample::off; });
  add([](Parameters& p) { p.stitches.placement = knit::PlacementPolicy::even, p.rows.cast_on = 13; });
  add([](Parameters& p) { p.stitches.placement = knit::PlacementPolicy::nearest; });
  add([](Parameters& p) {
    p.rows.source = knit::RowSource::contours, p.settle.settling = knit::Settling::on;
  });
  add([](Parameters& p) { p.relax.relaxing = knit::Relaxing::on; });
  add([](Parameters& p) { p.rows.source = knit::RowSource::contours, p.rows.cast_on = 4; });
  add([](Parameters& p) { p.rows.source = knit::RowSource::contours, knit::give_height(p, 0.7); });
  add([](Parameters& p) { p.rows.source = knit::RowSource::contours, knit::give_height(p, 1e-7); });
  add([](Parameters& p) { p.rows.source = knit::RowSource::contours, knit::give_width(p, 9.0); });
  add([](Parameters& p) {
    p.rows.source = knit::RowSource::contours, p.rhythm.counts = knit::CountPlanning::rhythm;
  });
  runs.push_back(example_with("torus"));
  runs.push_back(test_support::torus_from_rings());
  runs.back().document->timeline.extend_to_end();
  runs.push_back(standing_torus(0.2));
  runs.push_back(standing_torus(1.2));
  runs.push_back(edited_on_the_way());
  runs.push_back(example_with("thesis-sphere"));
  knit::Parameters contours = runs.back().document->timeline.parameters();
  contours.rows.source = knit::RowSource::contours;
  knit::give_width(contours, 0.15);
  knit::give_height(contours, 0.09);
  runs.back().document->timeline.tune(contours);
  runs.back().document->timeline.extend_to_end();
  runs.push_back(example_with("thesis-sphere"));
  runs.push_back(test_support::small_session());
  const auto bent = test_support::bent_ellipsoid(1.8);
  runs.back().document->timeline =
      knit::Timeline(bent, test_support::parameters_of(*bent, knit::ShortRows::automatic));
  runs.back().document->timeline.extend_to_end();
  return runs;
}

struct Reached {
  std::set<std::string_view> kinds;
  std::set<const CodeLine*> lines;
  std::size_t wrong = 0;         // steps that are no line of their listing
  std::set<std::string> hidden;  // numbers whose names a step log's line has already

  void take(const knit::Step& step, const knit::Parameters& parameters) {
    const PseudoCode& code = listing_of(step, parameters);
    const LinesRun run = lines_of(step, parameters);
    wrong += run.first <= run.last && run.last < code.lines.size() ? 0U : 1U;
    wrong += line_of(step, parameters) == run.last ? 0U : 1U;
    wrong += code.lines[run.last].lit(knit::any_event(step)) ? 0U : 1U;
    kinds.insert(knit::kind_name(step));
    for (std::size_t line = run.first; line <= run.last; ++line) lines.insert(&code.lines[line]);
    static constexpr std::array<std::string_view, 6> own{"step", "stage", "row", "item", "kind", "what"};
    for (const knit::StepField& field : knit::fields_of(step))
      if (std::ranges::count(own, field.name) > 0)
        hidden.insert(std::string(knit::kind_name(step)) + ": " + std::string(field.name));
  }
  void take(const knit::Timeline& timeline) {
    for (std::size_t i = 0; i < timeline.known(); ++i) take(timeline.step(i), timeline.parameters_of_step(i));
    if (timeline.stop() != nullptr) take(*timeline.stop(), timeline.parameters_of_stop());
  }
};

// No small run is so crowded that mains or turns find no room.
void take_crowded_rows(Reached& reached) {
  for (const auto placement : {knit::PlacementPolicy::thesis, knit::PlacementPolicy::even}) {
    knit::Parameters parameters;
    parameters.stitches.placement = placement;
    const knit::SpacingChosen dense{knit::Rule::dense, knit::Rule::remainder_last, true, 0, 0, 5};
    reached.take({{knit::Stage::stitches, 3, 1}, dense}, parameters);
    reached.take({{knit::Stage::stitches, 3, 2}, knit::TurnPlaced{3, knit::Label::turn_left}}, parameters);
  }
  knit::Parameters rhythm;
  rhythm.rows.source = knit::RowSource::contours;
  rhythm.rhythm.counts = knit::CountPlanning::rhythm;
  reached.take({{knit::Stage::stitches, 3, 2}, knit::TurnPlaced{3, knit::Label::turn_left}}, rhythm);
  reached.take({{knit::Stage::rows, 7, 3}, knit::PairDropped{3, 9, knit::DropReason{}}}, {});
}

std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::size_t blanks_in(std::string_view text) {
  std::size_t blanks = 0;
  for (std::size_t at = text.find("{}"); at != text.npos; at = text.find("{}", at + 1)) ++blanks;
  return blanks;
}

// "docs/algorithm.md, Rows: Stalls" names headings or bold words of that file.
std::vector<std::string> places_in_docs(const std::string& source) {
  const std::string file = "docs/algorithm.md, ";
  const std::size_t at = source.find(file);
  std::vector<std::string> names;
  if (at == std::string::npos) return names;
  std::string rest = source.substr(at + file.size());
  for (std::size_t colon = rest.find(": "); colon != std::string::npos; colon = rest.find(": ")) {
    names.push_back(rest.substr(0, colon));
    rest = rest.substr(colon + 2);
  }
  names.push_back(rest);
  return names;
}

}  // namespace

TEST_CASE("every kind of step has its line, and every line that is no mere head is some step's") {
  Reached reached;
  for (const Session& session : all_ways()) reached.take(session.document->timeline);
  take_crowded_rows(reached);
  CHECK(reached.wrong == 0);
  CHECK(reached.kinds.size() == knit::event_count);
  CHECK(reached.hidden == std::set<std::string>{});
  std::ifstream file(std::string(KNIT_SOURCE_DIR) + "/docs/command-line.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const std::string_view kind : reached.kinds) {
    INFO(kind << " has a line in the table of steps");
    CHECK(contains(page, "| `" + std::string(kind) + "` |"));
  }
  for (const PseudoCode* code : listings()) {
    for (const CodeLine& line : code->lines) {
      INFO(code->title << ": " << line.text);
      CHECK((line.structural || reached.lines.count(&line) == 1));
    }
  }
}

TEST_CASE("each verdict, reason to stop and rule ends at a line of its own") {
  const knit::Parameters parameters;
  const knit::Place place{knit::Stage::rows, 5, 3};
  const auto text = [&](const knit::Step& step) {
    return shown_text(listing_of(step, parameters).lines[line_of(step, parameters)]);
  };
  const auto measured = [&](knit::Verdict verdict) {
    return text({place, knit::CandidateMeasured{1, 2, 0, 1, 1, verdict, 0.1}});
  };
  CHECK(contains(measured(knit::Verdict::too_near), "if d"));
  CHECK(contains(measured(knit::Verdict::accepted), "v0 \xE2\x86\x90 vi"));
  CHECK(contains(measured(knit::Verdict::too_far), "else if d >"));
  const auto stopped = [&](knit::StopReason reason) {
    return text({place, knit::Stopped{reason, {}, 3, 2, 2, 0, 0.0, 0.5}});
  };
  CHECK(contains(stopped(knit::StopReason::stall), "or stop"));
  CHECK(contains(stopped(knit::StopReason::changes_too_much), "if not p"));
  CHECK(contains(stopped(knit::StopReason::splits), "order v"));
  const knit::Place index{knit::Stage::stitches, 5, 1};
  std::set<std::string> rules;
  for (const auto rule : {knit::Rule::from_cast_on, knit::Rule::plain, knit::Rule::equal, knit::Rule::follow,
                          knit::Rule::remainder_last, knit::Rule::dense})
    rules.insert(text({index, knit::SpacingChosen{rule, rule, false, 1, 0, 1}}));
  CHECK(rules.size() == 6);
}

TEST_CASE("lines fit their panel and say what they mean and where they come from") {
  const std::string docs = test_support::read_text(std::string(KNIT_SOURCE_DIR) + "/docs/algorithm.md");
  for (const PseudoCode* code : listings()) {
    CHECK_FALSE(code->title.empty());
    // A choice is short; a way of doing it is not.
    CHECK(code->lines.size() >= (contains(std::string(code->title), "Choosing") ? 2 : 5));
    CHECK(code->lines.size() <= 12);
    for (const CodeLine& line : code->lines) {
      INFO(code->title << ": " << line.text);
      CHECK(blanks_in(line.text) == static_cast<std::size_t>(std::count_if(
                                        line.variables.begin(), line.variables.end(),
                                        [](const auto* variable) { return variable != nullptr; })));
      CHECK(columns(shown_text(line)) <= knit::most_code_columns);
      CHECK(shown_text(line).find('{') == std::string::npos);
      CHECK(test_support::is_one_sentence(std::string(line.meaning)) == (line.meaning.size() > 20));
      CHECK(line.meaning.back() == '.');
      CHECK_FALSE(line.source.empty());
      for (const std::string& name : places_in_docs(std::string(line.source))) {
        INFO(name);
        std::string coded = name;
        for (const char* policy : {"thesis", "even", "nearest"}) {
          if (name == std::string("Placement ") + policy) coded = std::string("Placement `") + policy + "`";
        }
        CHECK(contains(docs, coded));
      }
    }
  }
}

TEST_CASE("every variable has a symbol and a meaning, and a name that no other has") {
  std::map<std::string_view, const knit::CodeVariable*> named;
  for (const PseudoCode* code : listings()) {
    for (const knit::CodeVariable* variable : variables_in(*code)) {
      INFO(variable->key);
      CHECK(named.emplace(variable->key, variable).first->second == variable);
      CHECK(variable_named(variable->key) == variable);
      CHECK_FALSE(variable->symbol.empty());
      CHECK(variable->meaning.size() > 10);
      CHECK(variable->meaning.back() == '.');
    }
  }
  CHECK(named.size() > 70);
  CHECK(variable_named("nonsense") == nullptr);
}

TEST_CASE("every number of a step is the value of a variable") {
  std::set<std::string> missing;
  for (Session& session : all_ways()) {
    const std::size_t known = session.document->timeline.known();
    const std::size_t stride = known > 6000 ? 31 : 1;
    for (std::size_t position = 1; position <= known; position += stride) {
      session.document->timeline.seek(position);
      const knit::Step* step = last_step(session);
      if (knit::is<knit::FieldSolved>(*step)) continue;
      const std::vector<Variable> variables = variables_of(session);
      for (const auto& number : numbers_of(*step)) {
        const bool found = std::any_of(variables.begin(), variables.end(), [&](const Variable& variable) {
          return variable.value == number.second;
        });
        if (!found && !stop_shown(session))
          missing.insert(std::string(knit::kind_name(*step)) + ": " + number.first);
      }
    }
  }
  CHECK(missing == std::set<std::string>{});
}

TEST_CASE("the variables of a measured candidate are those of its step, by the thesis's symbols") {
  Session session = test_support::finished_small_session();
  apply(session, SeekPlace{{knit::Stage::rows, 5, 9}});
  const auto& step = *knit::get_if<knit::CandidateMeasured>(*last_step(session));
  const std::vector<Variable> variables = variables_of(session);
  const auto value = [&](std::string_view symbol) {
    const auto at = std::find_if(variables.begin(), variables.end(),
                                 [&](const Variable& v) { return v.of->symbol == symbol; });
    REQUIRE(at != variables.end());
    return at->value;
  };
  CHECK(value("d") == knit::short_number(step.distance));
  CHECK(value("v0") == std::to_string(step.anchor));
  CHECK(value("vi") == std::to_string(step.candidate));
  CHECK(value("w") == "0.3");
  CHECK(value("\xCE\xB5") == "0.15");
  CHECK(value("g").empty());  // not before the row closes
}

TEST_CASE("before the first step the listing is that of what comes, and no line is lit") {
  Session session = run_changed([](knit::Parameters& p) { p.timing.kind = knit::TimingKind::harmonic; });
  session.document->timeline.seek(0);
  const auto at = explained(session);
  REQUIRE(at);
  CHECK(at->step == nullptr);
  CHECK(at->code == &knit::harmonic_code);
  CHECK_FALSE(at->lines);
  CHECK_FALSE(explained(Session{}));
  CHECK(variables_of(Session{}).empty());
}

TEST_CASE("the option explain prints the code with one mark, the values and the sentence") {
  Session session = test_support::finished_small_session();
  apply(session, SeekPlace{{knit::Stage::rows, 5, 9}});
  const Answer answer = explain_answer(session);
  CHECK(answer.exit_code == exit_done);
  const auto lines = test_support::lines_of(answer.out);
  CHECK(lines[0] == "rows:5:10\tAlgorithm 2: a row from a ring");
  CHECK(lines[1] == sentence(session));
  CHECK(std::count_if(lines.begin(), lines.end(), [](const auto& line) { return line[0] == '>'; }) == 1);
  CHECK(contains(answer.out, "\nepsilon\t\xCE\xB5\t0.15\t"));
  CHECK(explain_answer(Session{}).exit_code == exit_usage);

  Session stopped = run_changed(
      [](knit::Parameters& p) { knit::give_epsilon(p, 0.01), p.rows.on_stall = knit::OnStall::stop; });
  apply(stopped, ToLast{});
  CHECK(contains(explain_answer(stopped).out, "\tstopped\t"));
  CHECK_FALSE(fault_of_point("epsilon"));
  CHECK_FALSE(fault_of_point(""));
  REQUIRE(fault_of_point("speed"));
  CHECK(test_support::is_one_sentence(*fault_of_point("speed")));
}

TEST_CASE("the command line asks to explain and to point, and refuses what is no variable") {
  const auto parsed = parse_command_line({"--headless", "--explain", "--point", "d"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  CHECK(std::get<CommandLine>(parsed).explain);
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  CHECK_FALSE(open_as_asked(session, std::get<CommandLine>(parsed)));
  CHECK(session.learning->pointed_variable == "d");
  const auto refused = parse_command_line({"--point", "speed"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<Answer>(refused));
  CHECK(std::get<Answer>(refused).exit_code == exit_usage);
}
