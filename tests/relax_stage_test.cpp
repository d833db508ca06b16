// Stage relax of the machine: off it changes nothing; on, each of its states can be gone back to, bit by bit, a long one is heard
// and broken off, and what is shown, measured and saved of the piece in the air is what the stage made.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>

#include <nlohmann/json.hpp>

#include "app/files/export.h"
#include "app/files/knitted.h"
#include "app/files/pattern_export.h"
#include "app/files/report.h"
#include "app/scene/scene.h"
#include "app/session/remarks.h"
#include "app/session/shown.h"
#include "knit/insight/knitted_remarks.h"
#include "knit/insight/narrate.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/relax/relax_stage.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

Parameters relaxed_parameters(bool settled = true) {
  Parameters parameters = test_support::small_parameters();
  parameters.rows.source = settled ? RowSource::contours : RowSource::rings;
  parameters.settle.settling = settled ? Settling::on : Settling::off;
  parameters.relax.relaxing = Relaxing::on;
  return parameters;
}

Timeline run(const Parameters& parameters) {
  Timeline timeline(test_support::small_sphere(), parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  return timeline;
}

std::size_t first_in_the_air(const Timeline& timeline) {
  const auto& steps = timeline.steps();
  const auto first = std::find_if(steps.begin(), steps.end(),
                                  [](const Step& step) { return step.place.stage == Stage::relax; });
  REQUIRE(first != steps.end());
  return static_cast<std::size_t>(first - steps.begin());
}

std::size_t steps_in_the_air(const Timeline& timeline) {
  return static_cast<std::size_t>(
      std::count_if(timeline.steps().begin(), timeline.steps().end(),
                    [](const Step& step) { return step.place.stage == Stage::relax; }));
}

}  // namespace

TEST_CASE("relax stage: off it changes nothing and on it changes nothing else") {
  for (const bool settled : {true, false}) {
    Parameters off = relaxed_parameters(settled);
    off.relax.relaxing = Relaxing::off;
    const Timeline without = run(off), with = run(relaxed_parameters(settled));
    CHECK(steps_in_the_air(without) == 0);
    CHECK_FALSE(without.furthest().relaxed);
    CHECK(relaxed_places(without.furthest()) == nullptr);
    REQUIRE(with.furthest().relaxed);
    const std::size_t air = steps_in_the_air(with);
    CHECK(with.known() == without.known() + air);
    CHECK(air == static_cast<std::size_t>(with.furthest().relaxed->relaxed.iterations) + 2);
    CHECK(with.furthest().fabric == without.furthest().fabric);
    CHECK(with.furthest().lines == without.furthest().lines);
    std::vector<Step> others;
    for (const Step& step : with.steps()) {
      if (step.place.stage != Stage::relax) others.push_back(step);
    }
    CHECK(others == without.steps());
    // Stuffing is nobody's business while it is off.
    Parameters firm = off;
    firm.relax.stuffing = stuffing_hard;
    CHECK(hash_of(run(firm).furthest()) == hash_of(without.furthest()));
  }
}

TEST_CASE("relax stage: the same bits twice and from wherever one comes") {
  const Timeline once = run(relaxed_parameters());
  Timeline timeline = run(relaxed_parameters());
  CHECK(hash_of(timeline.furthest()) == hash_of(once.furthest()));
  CHECK(timeline.steps() == once.steps());
  const std::size_t first = first_in_the_air(timeline), last = first + steps_in_the_air(timeline);
  timeline.seek(first);
  std::vector<std::uint64_t> hashes{hash_of(timeline.state())};
  while (timeline.position() < last && timeline.forward()) hashes.push_back(hash_of(timeline.state()));
  REQUIRE(hashes.size() == last - first + 1);
  CHECK(std::adjacent_find(hashes.begin(), hashes.end()) == hashes.end());
  std::size_t wrong = 0;
  for (std::size_t i = hashes.size(); i-- > 0;) {
    timeline.seek(first + i);
    wrong += hash_of(timeline.state()) != hashes[i] ? 1U : 0U;
  }
  for (std::size_t i = 0; i < hashes.size(); i += 7) {
    timeline.seek(first + (i * 31) % hashes.size());
    wrong += hash_of(timeline.state()) != hashes[(i * 31) % hashes.size()] ? 1U : 0U;
  }
  CHECK(wrong == 0);
  // A replay crosses at most sixteen iterations.
  CHECK(timeline.keyframe_count() >= (last - first) / 16);
}

TEST_CASE("relax stage: it is what the plain function makes") {
  const Timeline timeline = run(relaxed_parameters());
  const State& end = timeline.furthest();
  const Parameters& parameters = timeline.parameters_of_stop();
  const Relaxed plain = relax(end.fabric, parameters.stitch, parameters.relax);
  CHECK(end.relaxed->relaxed == plain);
  CHECK(end.relaxed->relaxed.settled);
  REQUIRE(relaxed_places(end));
  CHECK(*relaxed_places(end) == plain.positions);
  const auto& steps = timeline.steps();
  const RelaxDone* done = nullptr;
  for (const Step& step : steps) {
    if (const auto* told = get_if<RelaxDone>(step)) done = told;
  }
  REQUIRE(done != nullptr);
  CHECK(done->iterations == plain.iterations);
  CHECK(done->height == static_cast<float>(end.relaxed->figures.knitted.height));
}

TEST_CASE("relax stage: firmer stuffing makes it larger and is run anew from there") {
  Timeline timeline = run(relaxed_parameters());
  const std::size_t first = first_in_the_air(timeline);
  const std::vector<Step> before(timeline.steps().begin(),
                                 timeline.steps().begin() + static_cast<std::ptrdiff_t>(first));
  double least = timeline.furthest().relaxed->figures.volume_share;
  const ParameterInfo& stuffing = *find_parameter("stuffing");
  for (const char* name : {"firm", "hard"}) {
    Parameters parameters = timeline.base_parameters();
    REQUIRE_FALSE(set_value(stuffing, parameters, name));
    CHECK(value_text(stuffing, parameters) == name);
    timeline.tune(parameters);
    CHECK(timeline.known() >= first);
    timeline.extend_to_end();
    CHECK(std::equal(before.begin(), before.end(), timeline.steps().begin()));
    CHECK(timeline.furthest().relaxed->figures.volume_share > least);
    least = timeline.furthest().relaxed->figures.volume_share;
  }
  Parameters parameters = timeline.base_parameters();
  REQUIRE_FALSE(set_value(stuffing, parameters, "0.04"));
  CHECK(parameters.relax.stuffing == 0.04);
  CHECK(value_text(stuffing, parameters) == "0.04");
  CHECK(set_value(stuffing, parameters, "full")->find("none, soft, usual, firm or hard") !=
        std::string::npos);
}

TEST_CASE("relax stage: where the stuffing is more than the fabric holds it ends and says so") {
  Parameters parameters = relaxed_parameters();
  parameters.relax.stuffing = 0.5;
  const Timeline timeline = run(parameters);
  const KnittedPiece& piece = *timeline.furthest().relaxed;
  CHECK_FALSE(piece.relaxed.settled);
  CHECK(piece.relaxed.iterations < parameters.relax.most_iterations);
  CHECK(std::isfinite(piece.figures.knitted.height));
  CHECK(std::isfinite(piece.figures.volume_share));
  std::string words;
  for (const Step& step : timeline.steps())
    if (get_if<RelaxDone>(step) != nullptr) words = narrate(step, parameters);
  CHECK(words == swelled_words);
  const std::vector<Remark> told = remarks_on(timeline.furthest().fabric, piece, parameters);
  REQUIRE(told.size() == 1);
  CHECK(told[0].words == swelled_words);
}

TEST_CASE("relax stage: a long step is heard and broken off without a trace") {
  struct BrokenOff {};
  const auto input = test_support::small_sphere();
  Parameters parameters = relaxed_parameters();
  parameters = resolved(parameters, *input);
  State state;
  while (state.stage() != Stage::relax) advance(*input, parameters, state);
  for (int step = 0; step < 3; ++step) {
    // With no memory of the factor each time, so that it is made each time.
    if (auto* work = std::get_if<RelaxWork>(&state.work)) work->memory = {};
    State whole = state;
    std::size_t heard = 0;
    advance(*input, parameters, whole, [&](double /*share*/) { ++heard; });
    CHECK(heard >= 2);
    State broken = state;
    std::size_t calls = 0;
    const Heard stopping = [&](double /*share*/) {
      if (++calls == heard) throw BrokenOff{};
    };
    CHECK_THROWS_AS(advance(*input, parameters, broken, stopping), BrokenOff);
    CHECK(broken == state);
    advance(*input, parameters, broken);
    CHECK(broken == whole);
    state = whole;
  }
}

TEST_CASE("relax stage: a large piece and each new factor are worked out elsewhere") {
  const auto input = test_support::small_sphere();
  Parameters parameters = resolved(relaxed_parameters(), *input);
  State state;
  while (state.stage() != Stage::relax) advance(*input, parameters, state);
  CHECK_FALSE(step_is_long(*input, parameters, state));  // some hundred stitches
  RelaxWork work;
  CHECK(next_factors(work));
  CHECK(relaxing_sweeps(work));
  begin_relaxing(state.fabric, parameters.stitch, parameters.relax, work);
  CHECK(next_factors(work));
  advance_relaxing(parameters.relax, work);
  CHECK_FALSE(next_factors(work));
  CHECK_FALSE(relaxing_sweeps(work));
  for (int i = 1; i < 15; ++i) advance_relaxing(parameters.relax, work);
  CHECK(relaxing_sweeps(work));
}

TEST_CASE("relax stage: the piece in the air is shown and saved and reported as the stage made it") {
  app::Session session = test_support::small_session();
  apply(session, app::Tune{relaxed_parameters()});
  apply(session, app::ToLast{});
  const Timeline& timeline = session.document->timeline;
  REQUIRE(timeline.state().relaxed);
  REQUIRE(app::has_relaxed(session));
  CHECK(app::positions_shown(session) == app::Positions::relaxed);  // whoever asks for it sees it
  apply(session, app::SetPositions{app::Positions::settled});
  const std::string settled = app::mesh_text(session);
  CHECK(app::places_shown(session) == nullptr);
  CHECK(knitting_path(app::shown_fabric(session)) == knitting_path(timeline.state().fabric));
  apply(session, app::SetPositions{app::Positions::relaxed});
  CHECK(app::positions_shown(session) == app::Positions::relaxed);
  CHECK(knitting_path(app::shown_fabric(session)) == timeline.state().relaxed->relaxed.positions);
  CHECK(app::mesh_text(session) != settled);
  CHECK(app::shown_words(session) == " as relaxed");
  const auto without_remarks = [](const std::string& text) {
    std::string rest;
    for (const std::string& line : test_support::lines_of(text)) {
      if (line.rfind('#', 0) != 0) rest += line + "\n";
    }
    return rest;
  };
  CHECK(without_remarks(app::mesh_text(session)) == without_remarks(app::relaxed_text(session)));
  const auto report = nlohmann::json::parse(app::report_text(session));
  CHECK(report["positions"] == "relaxed");
  CHECK(report["knitted"]["iterations"] == timeline.state().relaxed->relaxed.iterations);
  CHECK(report["wale"]["max"] != nullptr);
  // One size, that of the piece as it comes off the needles.
  const std::vector<std::string> notes = app::pattern_notes(timeline, nullptr);
  const std::string pattern = app::pattern_file_text(session, app::PatternFormat::text, {});
  CHECK(test_support::contains(pattern, "Knitted and stuffed, about "));
  CHECK_FALSE(test_support::contains(pattern, "across when stuffed"));
  CHECK(pattern.find("cm high") == pattern.rfind("cm high"));
  CHECK(std::none_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.starts_with("Not as asked: Knitted and stuffed");
  }));
  // Before the stage there is nothing in the air.
  apply(session, app::SeekPlace{{Stage::faces, 4, 0}});
  CHECK(app::positions_shown(session) == app::Positions::settled);
  CHECK(app::places_shown(session) == nullptr);
  apply(session, app::SeekPlace{{Stage::relax, 0, 5}});
  CHECK(app::positions_shown(session) == app::Positions::relaxed);
  CHECK(app::places_shown(session) != nullptr);
}

TEST_CASE("relax stage: what a maker must be told leads to its row") {
  Parameters parameters = relaxed_parameters();
  const Timeline timeline = run(parameters);
  const State& end = timeline.furthest();
  KnittedPiece piece = *end.relaxed;
  const double asked = piece.figures.placed.height;
  piece.figures = {};
  piece.figures.placed = piece.figures.knitted = {asked, asked};
  piece.figures.least = piece.figures.greatest = {1, 1.0};
  piece.relaxed.settled = true;
  const Parameters& known = timeline.parameters_of_stop();
  CHECK(remarks_on(end.fabric, piece, known).empty());
  piece.figures.knitted.height = 1.2 * asked;
  piece.figures.sunk = {0.0, known.stitch.height};
  piece.figures.out_of_round = RowShare{3, 1.35};
  piece.figures.greatest = {4, 1.5};
  piece.figures.bend_placed = 30.0;
  piece.figures.bend_knitted = 5.0;
  piece.figures.turned = {{1, 2, 45.0}};
  piece.figures.volume_share = 1.5;
  for (RowId row = 1; row <= 6; ++row) piece.figures.touching.push_back({row, row + 3});
  piece.relaxed.settled = false;
  piece.relaxed.iterations = known.relax.most_iterations;
  const std::vector<Remark> remarks = remarks_on(end.fabric, piece, known);
  std::vector<std::int32_t> rows;
  for (const Remark& remark : remarks) {
    CHECK(remark.kind == RemarkKind::knitted);
    CHECK(remark.words.back() == '.');
    rows.push_back(remark.at ? remark.at->row : 0);
  }
  CHECK(rows == std::vector<std::int32_t>{0, 0, end.fabric.row_count(), 3, 4, 1, 2, 1, 2, 3, 4, 0});
  // The list of problems has those of the run.
  const auto all = app::remarks_of(timeline, nullptr);
  const std::vector<Remark> told = remarks_on(end.fabric, *end.relaxed, as_chosen(known, end));
  CHECK(!told.empty());
  CHECK(static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Remark& remark) {
          return remark.kind == RemarkKind::knitted;
        })) == told.size());
}

TEST_CASE("relax stage: who has the piece relaxed sees it so and whole") {
  app::Session session = test_support::small_session();
  apply(session, app::FrameAll{});
  const double distance = session.view->gaze.camera.distance;
  Parameters settled = relaxed_parameters();
  settled.relax.relaxing = Relaxing::off;
  apply(session, app::Tune{settled});
  apply(session, app::ToLast{});
  CHECK(session.view->positions == app::Positions::settled);
  Parameters swollen = relaxed_parameters();
  swollen.relax.stuffing = stuffing_hard;
  apply(session, app::Tune{swollen});
  apply(session, app::ToLast{});
  CHECK(app::positions_shown(session) == app::Positions::relaxed);
  const app::Camera& camera = session.view->gaze.camera;
  const auto is_seen_whole = [&] {
    const app::Sight sight = camera.view(session.view->aspect);
    const auto places = app::places_shown(session);
    return std::all_of(places->begin(), places->end(), [&](const glm::dvec3& place) {
      const glm::vec4 at = sight.projection * sight.view * glm::vec4(glm::vec3(place), 1.0f);
      return std::abs(at.x) < at.w && std::abs(at.y) < at.w;
    });
  };
  const Bounds& mesh = session.document->timeline.input().bounds;
  const auto places = app::places_shown(session);
  double farthest = 0.0;
  for (const glm::dvec3& place : *places)
    farthest = std::max(farthest, glm::distance(place, mesh.centre()) / mesh.radius);
  REQUIRE(farthest > 1.02);
  CHECK(camera.distance > distance);
  CHECK(is_seen_whole());
  // No step of its making moves the view.
  const double all = camera.distance;
  apply(session, app::SeekPlace{{Stage::rows, 4, 0}});
  CHECK(camera.distance == all);
  apply(session, app::SetPositions{app::Positions::settled});
  CHECK(camera.distance == Approx(distance));
  apply(session, app::SetPositions{app::Positions::relaxed});
  // Whoever has come nearer stays there.
  apply(session, app::Zoom{0.5, {}});
  const double near = camera.distance;
  apply(session, app::SetPositions{app::Positions::settled});
  CHECK(camera.distance == near);
  apply(session, app::SetPositions{app::Positions::relaxed});
  apply(session, app::Tune{settled});
  CHECK(session.view->positions == app::Positions::settled);
  CHECK(camera.distance == near);
}
