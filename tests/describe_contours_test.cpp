// What there is to see while rows come from contours, of isolines and of critical points.
#include "app/describe/describe_contours.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/describe/describe.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using knit::Stage;

namespace {

Session session_of(const knit::Mesh& mesh, const knit::Parameters& parameters) {
  Session session;
  session.document = Document(knit::Timeline(knit::make_input(mesh), parameters));
  session.document->original = std::make_shared<const knit::Mesh>(mesh);
  apply(session, ToLast{});
  return session;
}

Session contour_session(knit::TimingKind timing = knit::TimingKind::arc_length) {
  knit::Parameters parameters = test_support::small_parameters();
  parameters.timing.kind = timing;
  parameters.rows.source = knit::RowSource::contours;
  return session_of(knit::sphere(40, 16), parameters);
}

// Its level sets split: lying (along y) from the first one on, standing (along x) above the lower saddle.
Session torus_session(knit::AxisKind axis) {
  knit::Parameters parameters = test_support::small_parameters();
  parameters.timing.axis.kind = axis;
  parameters.rows.source = knit::RowSource::contours;
  return session_of(knit::torus(48, 24, 0.7, 0.3), parameters);
}

// Only what the step shows: finished rows are others' matter.
Scene scene_of(const Session& session) { return Describer().describe(session); }

// Moves to the first step of the kind at or after the place; returns it.
template <class Kind>
Kind seek_to(Session& session, const knit::Place& from) {
  for (std::size_t i = 0; i < session.document->timeline.known(); ++i) {
    const knit::Step& step = session.document->timeline.step(i);
    if (step.place < from || !knit::is<Kind>(step)) continue;
    apply(session, SeekTo{i + 1});
    return *knit::get_if<Kind>(step);
  }
  FAIL("the run has no such step");
  return {};
}

const knit::ContourWork& work_of(const Session& session) {
  return std::get<knit::ContourWork>(session.document->timeline.state().work);
}
const knit::Ring& ring_of(const Session& session) {
  const knit::ContourWork& work = work_of(session);
  return work.curve ? *work.curve : knit::current_curve(*session.document->timeline.state().tubes, work);
}

std::size_t points_of(const Scene& scene, Colour colour) {
  return static_cast<std::size_t>(std::count_if(scene.points.begin(), scene.points.end(),
                                                [&](const Point& p) { return p.colour == colour; }));
}
std::size_t lines_of(const Scene& scene, Colour colour) {
  return static_cast<std::size_t>(std::count_if(scene.lines.begin(), scene.lines.end(),
                                                [&](const Line& l) { return l.colour == colour; }));
}
bool has_point(const Scene& scene, const glm::dvec3& at, Colour colour) {
  return std::any_of(scene.points.begin(), scene.points.end(),
                     [&](const Point& p) { return p.position == glm::vec3(at) && p.colour == colour; });
}
std::size_t isoline_segments(const Scene& scene) { return scene.isolines ? scene.isolines->size() : 0; }
std::vector<std::string> captions_of(const Scene& scene) {
  std::vector<std::string> texts;
  for (const Caption& caption : scene.captions) texts.push_back(caption.text);
  return texts;
}
using Texts = std::vector<std::string>;

// How far along the profile of the small sphere, 16 equal chords from pole to pole, a height lies.
double share_of_profile(double y) {
  const auto height = [](int chord) { return -std::cos(std::numbers::pi * chord / 16.0); };
  int chord = 0;
  while (chord < 15 && height(chord + 1) <= y) ++chord;
  return (chord + (y - height(chord)) / (height(chord + 1) - height(chord))) / 16.0;
}

}  // namespace

TEST_CASE("a loop is drawn through all its points and closed") {
  knit::Ring ring;
  ring.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}};
  std::vector<Line> lines;
  add_loop(ring, dark_theme.anchor, 2.0F, lines);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].from == glm::vec3(0, 0, 0));
  for (std::size_t i = 0; i < 3; ++i) CHECK(lines[i].to == lines[(i + 1) % 3].from);
  CHECK(lines[2].colour == dark_theme.anchor);
}

TEST_CASE("the plan of the tubes shows every curve, once") {
  Session session = contour_session();
  seek_to<knit::TubesPlanned>(session, {});
  std::size_t points = 0;
  for (const knit::Tube& tube : session.document->timeline.state().tubes->tubes) {
    for (const auto& curve : tube.curves) points += curve->points.size();
  }
  CHECK(lines_of(scene_of(session), dark_theme.ring) == points);
  apply(session, StepBy{});
  CHECK(lines_of(scene_of(session), dark_theme.ring) == 0);
}

TEST_CASE("a row from a contour: crossings, the loop with its start, its length, its count, its stitches") {
  Session session = contour_session();
  const knit::Place row{Stage::rows, 5, 0};
  seek_to<knit::CutFound>(session, row);
  Scene scene = scene_of(session);
  CHECK(points_of(scene, dark_theme.ring) == ring_of(session).points.size());
  for (const glm::dvec3& point : ring_of(session).points) CHECK(has_point(scene, point, dark_theme.ring));
  CHECK(lines_of(scene, dark_theme.anchor) == 0);
  CHECK(scene.captions.empty());

  const auto closed = seek_to<knit::LoopClosed>(session, row);
  scene = scene_of(session);
  CHECK(points_of(scene, dark_theme.ring) == 0);
  CHECK(lines_of(scene, dark_theme.anchor) == static_cast<std::size_t>(closed.points));
  CHECK(scene.captions.empty());

  const auto measured = seek_to<knit::LengthMeasured>(session, row);
  scene = scene_of(session);
  CHECK(captions_of(scene) == Texts{"L = " + knit::short_number(measured.length)});
  CHECK(scene.captions[0].position == glm::vec3(ring_of(session).points.front()));

  const auto chosen = seek_to<knit::CountChosen>(session, row);
  scene = scene_of(session);
  CHECK(captions_of(scene) == Texts{std::to_string(chosen.count) + " stitches"});
  CHECK(points_of(scene, dark_theme.stitch) == 0);
  CHECK(lines_of(scene, dark_theme.anchor) == static_cast<std::size_t>(closed.points));

  seek_to<knit::RoundBegun>(session, row);
  scene = scene_of(session);
  CHECK(has_point(scene, ring_of(session).points.front(), dark_theme.anchor));
  CHECK(points_of(scene, dark_theme.anchor) == 1);

  for (int stitch = 1; stitch < chosen.count; ++stitch) {
    apply(session, StepBy{});
    scene = scene_of(session);
    REQUIRE(work_of(session).stitches.size() == static_cast<std::size_t>(stitch));
    CHECK(points_of(scene, dark_theme.stitch) == static_cast<std::size_t>(stitch));
    CHECK(points_of(scene, dark_theme.accepted) == 1);
    CHECK(has_point(scene, work_of(session).stitches.back().position, dark_theme.accepted));
    CHECK(scene.captions.empty());
  }
}

TEST_CASE("the stitches of the first row from a contour have the colour of the cast on") {
  Session session = contour_session();
  const auto chosen = seek_to<knit::CountChosen>(session, {Stage::cast_on, 1, 0});
  REQUIRE(chosen.count >= 3);
  apply(session, StepBy{});  // where the round begins
  apply(session, StepBy{});
  apply(session, StepBy{});
  const Scene scene = scene_of(session);
  CHECK(points_of(scene, dark_theme.of(knit::Label::cast)) == 2);
  CHECK(points_of(scene, dark_theme.stitch) == 0);
}

TEST_CASE("without the cycle's layer only the stitches are left, without theirs only the cycle") {
  Session session = contour_session();
  seek_to<knit::RoundBegun>(session, {Stage::rows, 5, 0});
  apply(session, StepBy{});
  apply(session, SetLayer{Layer::criticals, false});
  apply(session, SetLayer{Layer::cycle, false});
  Scene scene = scene_of(session);
  CHECK(scene.lines.empty());
  CHECK(scene.points.size() == 1);
  apply(session, SetLayer{Layer::stitches, false});
  scene = scene_of(session);
  CHECK((scene.lines.empty() && scene.points.empty() && scene.captions.empty()));
  apply(session, SetLayer{Layer::cycle, true});
  scene = scene_of(session);
  CHECK(points_of(scene, dark_theme.stitch) == 0);
  CHECK(lines_of(scene, dark_theme.anchor) > 0);
}

TEST_CASE("isolines lie at equal steps of the time, by height or along the surface") {
  const auto timing = GENERATE(knit::TimingKind::linear, knit::TimingKind::arc_length);
  Session session = contour_session(timing);
  const auto lines =
      isolines_of(dark_theme, session.document->timeline.input(), *session.document->timeline.state().timing);
  std::array<std::size_t, 20> met{};
  std::size_t off = 0;
  for (const Line& line : *lines) {
    CHECK(line.colour == dark_theme.isoline);
    const double y = line.from.y;
    const double time = timing == knit::TimingKind::linear ? (y + 1.0) / 2.0 : share_of_profile(y);
    const double which = std::round(20.0 * time);
    met.at(static_cast<std::size_t>(which)) += 1;
    off += std::abs(20.0 * time - which) < 0.01 && line.from.y == Approx(line.to.y).margin(1e-6) ? 0U : 1U;
  }
  CHECK(off == 0);
  CHECK(met[0] == 0);
  for (std::size_t i = 1; i < 20; ++i) CHECK(met.at(i) > 0);
}

TEST_CASE("isolines are there with their layer once the times are, and are made once") {
  Session session = contour_session();
  Describer describer;
  apply(session, SeekTo{100});
  CHECK(isoline_segments(describer.describe(session)) == 0);
  const auto isolines_at = [&](const knit::Place& place) {
    apply(session, SeekPlace{place});
    const Scene scene = describer.describe(session);
    REQUIRE(isoline_segments(scene) > 0);
    return scene.isolines;
  };
  const auto first = isolines_at({Stage::rows, 3, 1});
  CHECK(isolines_at({Stage::rows, 3, 2}) == first);
  apply(session, SeekPlace{{Stage::done, 0, 0}});  // the knit mesh covers the surface
  CHECK(isoline_segments(describer.describe(session)) == 0);
  CHECK(isolines_at({Stage::cast_on, 1, 0}) == first);
  apply(session, SetLayer{Layer::isolines, false});
  CHECK(isoline_segments(describer.describe(session)) == 0);
  apply(session, SetLayer{Layer::isolines, true});
  CHECK(isolines_at({Stage::rows, 4, 0}) == first);

  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.timing.kind = knit::TimingKind::linear;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  CHECK(isolines_at({Stage::rows, 3, 1}) != first);
}

TEST_CASE("critical points are marked from where they are found, and named there") {
  Session session = contour_session();
  apply(session, SeekTo{100});
  const auto count_marks = [](const Scene& scene) {
    return points_of(scene, dark_theme.time_low) + points_of(scene, dark_theme.time_high) +
           points_of(scene, dark_theme.problem);
  };
  CHECK(count_marks(scene_of(session)) == 0);
  seek_to<knit::CriticalsFound>(session, {});
  const auto& mesh = session.document->timeline.input().mesh;
  Scene scene = scene_of(session);
  CHECK(has_point(scene, mesh.positions.front(), dark_theme.time_low));
  CHECK(has_point(scene, mesh.positions.back(), dark_theme.time_high));
  CHECK(count_marks(scene) == 2);
  CHECK(captions_of(scene) == Texts{"minimum", "maximum"});
  apply(session, StepBy{});
  scene = scene_of(session);
  CHECK(count_marks(scene) == 2);
  CHECK(scene.captions.empty());
  apply(session, SetLayer{Layer::criticals, false});
  CHECK(count_marks(scene_of(session)) == 0);
}

TEST_CASE("at a split the saddle is named, its two arcs have two colours, and the bridge grows between") {
  Session session = torus_session(knit::AxisKind::x);
  REQUIRE(stop_shown(session) == nullptr);
  const auto found = seek_to<knit::GapsFound>(session, {Stage::rows, 2, 0});
  REQUIRE(found.deal == knit::DealKind::split);
  Scene scene = scene_of(session);
  CHECK(captions_of(scene) == Texts{"split"});
  CHECK(scene.captions[0].position ==
        glm::vec3(session.document->timeline.input().mesh.positions[found.vertex]));
  CHECK(points_of(scene, dark_theme.one_side) == static_cast<std::size_t>(found.one));
  CHECK(points_of(scene, dark_theme.other_side) == static_cast<std::size_t>(found.two));
  const auto bridge = static_cast<std::size_t>(work_of(session).deal->bridge.size());
  REQUIRE(bridge > 0);
  CHECK(points_of(scene, dark_theme.anchor) == 0);
  apply(session, StepBy{});
  CHECK(points_of(scene_of(session), dark_theme.anchor) == 1);
  // Dealt, the loop that is not worked waits as a dashed thread.
  const auto dealt = seek_to<knit::LoopsDealt>(session, {Stage::rows, 2, 0});
  CHECK(dealt.bridge == static_cast<std::int32_t>(bridge));
  CHECK(dealt.one + dealt.two == dealt.whole + 2 * dealt.bridge);
  CHECK(captions_of(scene_of(session)).empty());
  CHECK(lines_of(scene_of(session), dark_theme.warning) == static_cast<std::size_t>(dealt.one + dealt.two));
  apply(session, StepBy{});
  CHECK(lines_of(scene_of(session), dark_theme.warning) < static_cast<std::size_t>(dealt.one + dealt.two));
}
