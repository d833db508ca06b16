// Finding why: clicks that pick, jumps to the step that made a thing, the history, and the command line's --why.
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <set>

#include "app/describe/describe.h"
#include "app/describe/pick.h"
#include "app/explain/why_words.h"
#include "app/scene/scene.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

std::size_t position(const Session& session) { return session.document->timeline.position(); }

knit::VertexId refused_vertex(const knit::Timeline& timeline) {
  for (knit::VertexId v = 0; v < timeline.input().mesh.positions.size(); ++v) {
    if (knit::story_of(timeline, v).fate == knit::Fate::refused) return v;
  }
  return knit::no_vertex;
}

glm::dvec2 on_screen(const Session& session, const glm::dvec3& place) {
  const Sight view = session.view->gaze.camera.view(session.view->aspect);
  const glm::dvec4 at = glm::dmat4(view.projection) * glm::dmat4(view.view) * glm::dvec4(place, 1.0);
  return glm::dvec2(at) / at.w;
}

bool faces_eye(const Session& session, const glm::dvec3& place) {
  return glm::dot(glm::normalize(session.view->gaze.camera.eye() - place), glm::normalize(place)) > 0.4;
}

}  // namespace

TEST_CASE("showing why goes to the step that made it, and back again") {
  Session session = test_support::finished_small_session();
  const std::size_t end = position(session);
  const knit::Element face = knit::FaceElement{5, 2};
  apply(session, ShowWhy{face});
  CHECK(session.document->travel.selected == face);
  CHECK(position(session) == *knit::made_by(session.document->timeline, face) + 1);
  const std::size_t made = position(session);
  apply(session, ShowWhy{knit::StitchElement{3, 1}});
  const std::size_t kept = position(session);
  CHECK(kept < made);
  apply(session, GoBack{});
  CHECK(position(session) == made);
  apply(session, GoBack{});
  CHECK(position(session) == end);
  apply(session, GoForward{});
  apply(session, GoForward{});
  CHECK(position(session) == kept);
  apply(session, GoForward{});
  CHECK(position(session) == kept);
  // A new jump forgets what was ahead.
  apply(session, GoBack{});
  apply(session, ToFirst{});
  CHECK(session.document->travel.history.ahead.empty());
  apply(session, GoBack{});
  CHECK(position(session) == made);
  apply(session, GoForward{});
  CHECK(position(session) == 0);
}

TEST_CASE("dragging along the track is one jump in the history") {
  Session session = test_support::finished_small_session();
  const std::size_t end = position(session);
  const std::size_t before = session.document->travel.history.behind.size();
  for (std::size_t i = 0; i < 30; ++i) apply(session, SeekTo{100 + 40 * i});
  CHECK(session.document->travel.history.behind.size() == before + 1);
  apply(session, GoBack{});
  CHECK(position(session) == end);
  // After stepping by hand another drag is another jump.
  apply(session, SeekTo{300});
  apply(session, StepBy{});
  apply(session, SeekTo{900});
  apply(session, GoBack{});
  CHECK(position(session) == 301);
}

TEST_CASE("a history never grows without end, and outlives tuning") {
  Session session = test_support::finished_small_session();
  for (std::int32_t i = 0; i < 600; ++i) apply(session, ShowWhy{knit::StitchElement{2 + i % 7, i % 5}});
  CHECK(session.document->travel.history.behind.size() <= 200);
  const knit::Place there = session.document->timeline.place();
  apply(session, ToFirst{});
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.stitches.placement = knit::PlacementPolicy::even;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  apply(session, GoBack{});
  apply(session, GoBack{});
  CHECK(session.document->timeline.place() == there);
}

TEST_CASE("the steps that touched what is selected are gone through both ways") {
  Session session = test_support::finished_small_session();
  apply(session, ToTouch{1});
  const std::size_t end = position(session);
  CHECK(end == session.document->timeline.known());
  const knit::Element stitch = knit::StitchElement{6, 2};
  apply(session, Select{stitch});
  std::vector<std::size_t> seen;
  for (;;) {
    const std::size_t before = position(session);
    apply(session, ToTouch{-1});
    if (position(session) == before) break;
    seen.push_back(position(session));
    CHECK(knit::touches(session.document->timeline, stitch, position(session) - 1));
  }
  CHECK(seen.size() >= 5);
  std::vector<std::size_t> again{seen.back()};
  for (;;) {
    const std::size_t before = position(session);
    apply(session, ToTouch{1});
    if (position(session) == before) break;
    again.push_back(position(session));
  }
  CHECK(std::vector<std::size_t>(again.rbegin(), again.rend()) == seen);
}

TEST_CASE("why: with nothing open, or a vertex that is not there, nothing happens") {
  Session empty;
  for (const Action& action : Actions{Select{knit::StitchElement{}}, ShowWhy{knit::FaceElement{}}, ToTouch{1},
                                      GoBack{}, GoForward{}})
    apply(empty, action);
  CHECK_FALSE(empty.document);
  Session session = test_support::finished_small_session();
  apply(session, ShowWhy{knit::VertexElement{99999999}});
  CHECK_FALSE(session.document->travel.selected);
  apply(session, ShowWhy{knit::StitchElement{5000, 1}});
  CHECK(position(session) == session.document->timeline.known());
}

TEST_CASE("why: a window whose run is not worked out yet is not held up") {
  Session session = test_support::small_session();
  session.jobs->beside = true;
  session.document->timeline.extend(1000);
  const std::size_t known = session.document->timeline.known();
  apply(session, ShowWhy{knit::FaceElement{4, 1}});
  CHECK(session.document->timeline.known() == known);
  apply(session, ShowWhy{knit::StitchElement{1, 2}});
  CHECK(session.document->timeline.known() == known);
  CHECK(position(session) > 0);
  apply(session, GoBack{});
  CHECK(position(session) == 0);
}

TEST_CASE("a refused vertex shows its anchor, the distance and the band") {
  Session session = test_support::finished_small_session();
  const knit::VertexId vertex = refused_vertex(session.document->timeline);
  apply(session, ShowWhy{knit::VertexElement{vertex}});
  const auto& step = session.document->timeline.step(position(session) - 1);
  REQUIRE(knit::is<knit::CandidateMeasured>(step));
  CHECK(knit::get_if<knit::CandidateMeasured>(step)->candidate == vertex);
  CHECK(why_words(session.document->timeline, knit::VertexElement{vertex}).find("Passed over") == 0);
  apply(session, ToLast{});
  Describer describer;
  const Scene scene = describer.describe(session);
  REQUIRE(scene.band);
  const auto& measured = *knit::get_if<knit::CandidateMeasured>(step);
  const auto& anchor = session.document->timeline.input().mesh.positions[measured.anchor];
  CHECK(glm::distance(glm::dvec3(scene.band->centre), anchor) < 1e-5);
  CHECK(scene.band->inner == Approx(0.15));
  std::set<std::string> captions;
  for (const Caption& caption : scene.captions) captions.insert(caption.text);
  CHECK(captions.count("vertex " + std::to_string(vertex) + ": " + knit::short_number(measured.distance)) ==
        1);
}

TEST_CASE("what is selected is lit where it is, and faintly where it is still to come") {
  Session session = test_support::finished_small_session();
  Describer describer;
  for (const knit::Element& thing :
       {knit::Element(knit::StitchElement{5, 1}), knit::Element(knit::RowEdgeElement{5, 1}),
        knit::Element(knit::ColumnEdgeElement{5, 1}), knit::Element(knit::FaceElement{5, 1}),
        knit::Element(knit::LabelElement{5, 1}), knit::Element(knit::VertexElement{40})}) {
    CAPTURE(words_of(thing));
    apply(session, Select{});
    apply(session, ToLast{});
    const Scene without = describer.describe(session);
    apply(session, Select{thing});
    const Scene with = describer.describe(session);
    CHECK(with.captions.size() > without.captions.size());
    CHECK(with.points.size() + with.lines.size() > without.points.size() + without.lines.size());
    apply(session, ToFirst{});
    CHECK_FALSE(describer.describe(session).captions.empty());
  }
}

TEST_CASE("a click means the stitch, edge, face or vertex in front under the pointer") {
  Session session = test_support::finished_small_session();
  const knit::State& state = session.document->timeline.state();
  const PickReach reach{0.01, 0.006};
  std::size_t seen = 0;
  std::size_t right = 0;
  for (const auto& row : state.fabric.rows()) {
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(row->stitches.size()); ++i) {
      const glm::dvec3& place = row->stitches[static_cast<std::size_t>(i)].position;
      if (!faces_eye(session, place)) continue;
      ++seen;
      right += pick_thing(session, on_screen(session, place), reach) ==
                       std::optional<knit::Element>(knit::StitchElement{row->id, i})
                   ? 1U
                   : 0U;
    }
  }
  CHECK(seen > 20);
  CHECK(right == seen);
  // Between stitches an edge; with edges hidden the face; with faces hidden the mesh.
  const auto& row = *state.fabric.rows()[state.fabric.rows().size() / 2];
  for (std::size_t i = 0; i + 1 < row.stitches.size(); ++i) {
    const glm::dvec3 middle = 0.5 * (row.stitches[i].position + row.stitches[i + 1].position);
    if (!faces_eye(session, middle)) continue;
    const auto edge = pick_thing(session, on_screen(session, middle), reach);
    REQUIRE(edge);
    CHECK(*edge == knit::Element(knit::RowEdgeElement{row.id, static_cast<std::int32_t>(i)}));
  }
  apply(session, SetLayer{Layer::row_edges, false});
  apply(session, SetLayer{Layer::column_edges, false});
  apply(session, SetLayer{Layer::stitches, false});
  const auto face = pick_thing(session, {0.02, 0.03}, reach);
  REQUIRE(face);
  CHECK(std::holds_alternative<knit::FaceElement>(*face));
  apply(session, SetLayer{Layer::faces, false});
  const auto vertex = pick_thing(session, {0.02, 0.03}, reach);
  REQUIRE(vertex);
  CHECK(std::holds_alternative<knit::VertexElement>(*vertex));
  CHECK_FALSE(pick_thing(session, {0.99, 0.99}, reach));
  CHECK_FALSE(pick_thing(Session{}, {0.0, 0.0}, reach));
}

TEST_CASE("candidates of the row in the making can be clicked, though edges run through them") {
  Session session = test_support::small_session();
  while (!std::holds_alternative<knit::RowWork>(session.document->timeline.state().work) ||
         session.document->timeline.state().fabric.rows().size() < 7 ||
         std::get<knit::RowWork>(session.document->timeline.state().work).walk.kept.size() < 6)
    apply(session, StepBy{});
  const auto& work = std::get<knit::RowWork>(session.document->timeline.state().work);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < work.ring->vertices.size(); ++i) {
    if (!faces_eye(session, work.ring->points[i])) continue;
    const auto& kept = work.walk.kept;
    const auto order = static_cast<std::int32_t>(i);
    const auto picked = pick_thing(session, on_screen(session, work.ring->points[i]), {0.02, 0.01});
    REQUIRE(picked);
    ++seen;
    const bool stitch = std::find(kept.begin(), kept.end(), order) != kept.end();
    CHECK(std::holds_alternative<knit::StitchElement>(*picked) == stitch);
    if (!stitch) CHECK(std::get<knit::VertexElement>(*picked).vertex == work.ring->vertices[i]);
  }
  CHECK(seen > 5);
}

TEST_CASE("things are written and read on the command line the same way") {
  for (const std::string text :
       {"stitch:14:3", "edge:2:1", "column:3:4", "face:7:12", "label:2:5", "vertex:230"}) {
    const auto thing = thing_named(text);
    REQUIRE(thing);
    CHECK(text_of(*thing) == text);
    CHECK_FALSE(fault_of_why(text));
  }
  CHECK(*thing_named("stitch:14:3") == knit::Element(knit::StitchElement{14, 2}));
  for (const std::string text :
       {"", "stitch", "stitch:1", "stitch:0:1", "stitch:2:-1", "stitch:2:0", "stitch:2:3:4", "vertex",
        "vertex:-1", "vertex:4294967295", "loop:1:2", "stitch:a:b"}) {
    CAPTURE(text);
    CHECK_FALSE(thing_named(text));
    REQUIRE(fault_of_why(text));
    CHECK(test_support::is_one_sentence(*fault_of_why(text)));
  }
}

TEST_CASE("the option --why answers with the step, its sentence and its numbers") {
  Session session = test_support::small_session();
  const Answer stitch = why_answer(session, "stitch:5:3");
  CHECK(stitch.exit_code == exit_done);
  CHECK(stitch.out.find("stitch 3 of row 5: ") == 0);
  const auto made = *knit::made_by(session.document->timeline, knit::StitchElement{5, 2});
  CHECK(stitch.out.find("made\tstep " + std::to_string(made + 1) + "\trows:5:") != std::string::npos);
  CHECK(stitch.out.find("chosen\tstep ") != std::string::npos);
  CHECK(stitch.out.find("  distance\t") != std::string::npos);
  CHECK(position(session) == made + 1);  // a picture shows it
  const knit::VertexId vertex = refused_vertex(session.document->timeline);
  const Answer refused = why_answer(session, "vertex:" + std::to_string(vertex));
  CHECK(refused.out.find("Passed over") != std::string::npos);
  CHECK(refused.out.find("measured\tstep ") != std::string::npos);
  for (const std::string text : {"stitch:900:1", "face:2:900", "vertex:9999999"}) {
    const Answer none = why_answer(session, text);
    CHECK(none.exit_code == exit_usage);
    CHECK(none.out.empty());
    CHECK(test_support::is_one_sentence(none.error));
  }
}
