// What is drawn while stitches settle: edges in the colours of their stretch, the way of each stitch, and the same piece as
// placed.
#include "app/describe/describe_stretch.h"

#include <glm/geometric.hpp>

#include "app/describe/describe.h"
#include "app/describe/pick.h"
#include "app/session/shown.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;
using test_support::example_session;

namespace {

void go(Session& session, knit::Stage stage, std::int32_t item) {
  apply(session, SeekPlace{{stage, 0, item}});
}

// Trousers, as they come and settling.
Session settling_session() {
  Session session = example_session("trousers");
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.settle.settling = knit::Settling::on;
  apply(session, Tune{parameters});
  session.document->timeline.extend_to_end();
  go(session, knit::Stage::settle, 1);
  return session;
}

Scene scene_of_settling(const Session& session) { return Describer().describe(session); }

std::size_t lines_in(const Scene& scene, Colour colour) {
  const auto is = [&](const Line& line) { return line.colour == colour; };
  auto count = std::count_if(scene.lines.begin(), scene.lines.end(), is);
  for (const auto& set : scene.line_sets) count += std::count_if(set->begin(), set->end(), is);
  return static_cast<std::size_t>(count);
}

bool all_faces_are(const Scene& scene, Colour colour) {
  for (const auto& shape : scene.faces)
    for (const FaceShape::Face& face : shape->faces)
      if (face.colour != colour) return false;
  return !scene.faces.empty();
}

}  // namespace

TEST_CASE("stretch has three colours and all between, alike for so many times longer and shorter") {
  for (const Theme& theme : {dark_theme, light_theme}) {
    CHECK(stretch_colour(theme, 1.0) == theme.stretch_even);
    CHECK(stretch_colour(theme, full_stretch) == theme.stretch_long);
    CHECK(stretch_colour(theme, 1.0 / full_stretch) == theme.stretch_short);
    CHECK(stretch_colour(theme, 100.0) == theme.stretch_long);
    CHECK(stretch_colour(theme, 0.0) == theme.stretch_short);
    CHECK(stretch_colour(theme, 1.2) != theme.stretch_even);
    CHECK(stretch_colour(theme, 1.2) != theme.stretch_long);
  }
}

TEST_CASE("stretch is drawn while stitches settle, over plain faces, and afterwards where no faces are") {
  Session session = settling_session();
  REQUIRE(has_settled(session));
  CHECK(stretch_shown(session));
  const Scene scene = scene_of_settling(session);
  CHECK(all_faces_are(scene, scene.theme->ground));
  CHECK(lines_in(scene, scene.theme->column_edge) == 0);
  CHECK(lines_in(scene, scene.theme->row_edge) == 0);

  SECTION("not before") {
    go(session, knit::Stage::faces, 0);
    CHECK_FALSE(stretch_shown(session));
  }
  SECTION("not without its layer") {
    apply(session, SetLayer{Layer::stretch, false});
    const Scene plain = scene_of_settling(session);
    CHECK_FALSE(all_faces_are(plain, plain.theme->ground));
    CHECK(lines_in(plain, plain.theme->column_edge) > 100);
  }
  SECTION("at the end faces bear their labels") {
    apply(session, ToLast{});
    CHECK_FALSE(stretch_shown(session));
    apply(session, SetLayer{Layer::faces, false});
    CHECK(stretch_shown(session));
    CHECK(lines_in(scene_of_settling(session), dark_theme.column_edge) == 0);
  }
}

TEST_CASE("stretch of an edge is by what it should measure, and a stretched one is wider") {
  std::vector<Line> lines{{{0, 0, 0}, {2, 0, 0}, {}}, {{0, 0, 0}, {0, 4, 0}, {}}, {{0, 0, 0}, {0, 0, 1}, {}}};
  colour_by_stretch(dark_theme, 2.0, full_stretch, lines);
  CHECK(lines[0].colour == dark_theme.stretch_even);
  CHECK(lines[1].colour == dark_theme.stretch_long);
  CHECK(lines[2].colour == dark_theme.stretch_short);
  CHECK(lines[1].width_px > 1.5F * lines[0].width_px);
  CHECK(lines[1].width_px == lines[2].width_px);
}

TEST_CASE("moves lead each stitch from where it was placed to where it is") {
  Session session = settling_session();
  const knit::State& state = session.document->timeline.state();
  const std::vector<glm::dvec3> now = knit::knitting_path(state.fabric);
  const Scene scene = scene_of_settling(session);
  std::size_t moves = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const glm::vec3 from((*state.placed)[i]), to(now[i]);
    moves += std::any_of(scene.lines.begin(), scene.lines.end(),
                         [&](const Line& line) { return line.from == from && line.to == to; })
                 ? 1U
                 : 0U;
  }
  CHECK(moves > now.size() / 2);
  apply(session, SetLayer{Layer::moves, false});
  CHECK(scene_of_settling(session).lines.size() + moves <= scene.lines.size());
  apply(session, SetLayer{Layer::moves, true});
  go(session, knit::Stage::settle, 0);  // nothing has moved yet
  CHECK(lines_in(scene_of_settling(session), dark_theme.accepted) == 0);
}

TEST_CASE("as placed the same stitches are drawn and picked where they were") {
  Session session = settling_session();
  apply(session, ToLast{});
  const knit::State& state = session.document->timeline.state();
  const auto point_at = [](const Scene& scene, const glm::dvec3& place) {
    for (const auto& set : scene.point_sets)
      for (const Point& point : *set)
        if (point.position == glm::vec3(place)) return true;
    return false;
  };
  const glm::dvec3 settled = knit::knitting_path(state.fabric)[40], placed = (*state.placed)[40];
  REQUIRE(settled != placed);
  CHECK(point_at(scene_of_settling(session), settled));
  Describer describer;
  session.view->positions = Positions::placed;
  const Scene scene = describer.describe(session);
  CHECK(point_at(scene, placed));
  CHECK_FALSE(point_at(scene, settled));
  CHECK(describer.describe(session).point_sets == scene.point_sets);  // not made anew
  const Sight view = session.view->gaze.camera.view(session.view->aspect);
  const auto on_screen = [&](const glm::dvec3& place) {
    const glm::dvec4 at = glm::dmat4(view.projection) * glm::dmat4(view.view) * glm::dvec4(place, 1.0);
    return glm::dvec2(at) / at.w;
  };
  CHECK(pick_stitch(session, on_screen(placed), 1e-4));
  session.view->positions = Positions::settled;
  CHECK_FALSE(pick_stitch(session, on_screen(placed), 1e-9));
}

TEST_CASE("the view's legend has the stretch, and a switch for where stitches are shown") {
  Desk desk;
  desk.session = settling_session();
  desk.settle();
  CHECK(desk.ui.controls.count("legend/stretch") == 1);
  CHECK(only<SetPositions>(desk.click("positions/placed")).positions == Positions::placed);
  desk.session.view->positions = Positions::placed;
  apply(desk.session, ToLast{});
  desk.ui.controls.clear();
  desk.settle();
  CHECK(desk.ui.controls.count("legend/stretch") == 0);
  REQUIRE(desk.ui.controls.count("positions/settled") == 1);  // never hidden while it is not as usual
  CHECK(only<SetPositions>(desk.click("positions/settled")).positions == Positions::settled);
}
