// The yarn as it is drawn: worked out from the curve, as far as stitches are made, in its colours, as finely as it is seen.
#include "app/yarn/yarn_shown.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "app/actions/looking.h"
#include "app/describe/describe.h"
#include "app/scene/colour_text.h"
#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/session/view.h"
#include "knit/yarn/yarn.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::finished_small_session;

namespace {

Session yarn_session() {
  Session session = finished_small_session();
  apply(session, SetLayer{Layer::yarn, true});
  return session;
}

Scene scene_of(const Session& session) {
  Describer describer;
  return describer.describe(session);
}

std::size_t spans_of(const YarnShape& shape) {
  std::size_t spans = 0;
  for (const YarnShape::Piece& piece : shape.pieces) spans += piece.spans;
  return spans;
}

knit::Yarn yarn_of(const Session& session) {
  const knit::Fabric& fabric = session.document->timeline.state().fabric;
  return knit::make_yarn(fabric, knit::knitting_path(fabric), session.document->timeline.parameters().stitch);
}

std::set<std::uint32_t> colours_of(const YarnShape& shape) {
  std::set<std::uint32_t> colours;
  for (const YarnShape::Piece& piece : shape.pieces)
    colours.insert((std::uint32_t{piece.colour.r} << 16U) | (std::uint32_t{piece.colour.g} << 8U) |
                   piece.colour.b);
  return colours;
}

}  // namespace

TEST_CASE("yarn shown: all spans of the curve and its points as they are") {
  const Session session = yarn_session();
  const Scene scene = scene_of(session);
  REQUIRE(scene.yarn);
  const knit::Yarn yarn = yarn_of(session);
  std::size_t points = 0, spans = 0;
  for (const knit::YarnCurve& curve : yarn.curves) {
    points += curve.points.size() + 2;
    spans += curve.points.size() - 1;
  }
  CHECK(scene.yarn->points.size() == points);
  CHECK(spans_of(*scene.yarn) == spans);
  const glm::vec4 second = scene.yarn->points.at(2);
  CHECK(glm::distance(glm::vec3(second), glm::vec3(yarn.curves[0].points[1])) < 1e-6F);
  CHECK(second.w > 0.0F);
  for (std::size_t i = 1; i < scene.yarn->pieces.size(); ++i) {
    const auto& a = scene.yarn->pieces[i - 1];
    const auto& b = scene.yarn->pieces[i];
    CHECK(a.spans <= knit::points_a_stitch + 1);
    CHECK(a.first + a.spans <= b.first);
  }
}

TEST_CASE("yarn shown: it is off at first and stands in the place of faces and edges") {
  Session session = finished_small_session();
  CHECK(scene_of(session).yarn == nullptr);
  apply(session, SetLayer{Layer::yarn, true});
  const Scene scene = scene_of(session);
  REQUIRE(scene.yarn);
  CHECK(scene.faces.size() == 1);  // its ground
  CHECK(scene.line_sets.empty());
  CHECK(scene.point_sets.empty());
  CHECK_FALSE(scene.show_surface);
}

TEST_CASE("yarn shown: it grows with the stitches while rows are made") {
  Session session = yarn_session();
  std::size_t before = 0;
  for (const knit::Place place :
       {knit::Place{knit::Stage::rows, 3, 2}, knit::Place{knit::Stage::rows, 3, 9},
        knit::Place{knit::Stage::rows, 6, 4}, knit::Place{knit::Stage::stitches, 4, 1}}) {
    apply(session, SeekPlace{place});
    const Scene scene = scene_of(session);
    REQUIRE(scene.yarn);
    const knit::State& state = session.document->timeline.state();
    std::size_t picked = 0;
    if (const auto* work = std::get_if<knit::RowWork>(&state.work)) picked = work->walk.kept.size();
    // A piece a stitch, and one more for each strand that is lifted for an increase of the row above.
    const std::size_t made = state.fabric.stitch_count() + picked;
    CHECK(scene.yarn->pieces.size() >= made);
    CHECK(scene.yarn->pieces.size() <= 2 * made);
    CHECK(scene.yarn->pieces.size() > before);
    CHECK_FALSE(scene.yarn->closed);
    before = scene.yarn->pieces.size();
  }
  apply(session, ToLast{});
  CHECK(scene_of(session).yarn->pieces.size() > before);
}

TEST_CASE("yarn shown: without a finished run it grows row by row as faces are made") {
  Session session = test_support::small_session();
  apply(session, SetLayer{Layer::yarn, true});
  const auto only_to = [&](const knit::Place& place) {
    knit::Timeline& timeline = session.document->timeline;
    timeline.extend_to(place);
    timeline.seek(timeline.known());
  };
  only_to({knit::Stage::rows, 4, 2});
  CHECK(scene_of(session).yarn == nullptr);
  only_to({knit::Stage::faces, 5, 1});
  const Scene scene = scene_of(session);
  REQUIRE(scene.yarn);
  const knit::Fabric& fabric = session.document->timeline.state().fabric;
  const knit::RowId last = fabric.strips().back()->to;
  CHECK(scene.yarn->pieces.size() >= fabric.first_on_path(last + 1));
  CHECK(scene.line_sets.size() == static_cast<std::size_t>(fabric.row_count() - last));
}

TEST_CASE("yarn shown: kept while nothing changes and made anew where stitches lie elsewhere") {
  Session session = yarn_session();
  Describer describer;
  const auto first = describer.describe(session).yarn;
  CHECK(describer.describe(session).yarn == first);
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.relax.relaxing = knit::Relaxing::on;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  apply(session, SetPositions{Positions::settled});
  const auto on_mesh = describer.describe(session).yarn;
  apply(session, SetPositions{Positions::relaxed});
  const auto in_the_air = describer.describe(session).yarn;
  REQUIRE(in_the_air);
  CHECK(in_the_air->pieces.size() == on_mesh->pieces.size());
  CHECK(in_the_air->points != on_mesh->points);
}

TEST_CASE("yarn shown: wool and stripes and labels and stretch") {
  Session session = yarn_session();
  YarnLook look;
  look.wool = {10, 20, 30};
  look.second = {200, 100, 50};
  apply(session, SetYarnLook{look});
  CHECK(colours_of(*scene_of(session).yarn) == std::set<std::uint32_t>{0x0a141e});
  look.stripe_rounds = 2;
  apply(session, SetYarnLook{look});
  const knit::Fabric& fabric = session.document->timeline.state().fabric;
  const auto rounds = rounds_of_stitches(fabric);
  const auto colours = yarn_colours(fabric, knit::knitting_path(fabric),
                                    session.document->timeline.parameters().stitch, look, dark_theme);
  for (std::size_t i = 0; i < rounds.size(); ++i)
    CHECK(colours[i] == (rounds[i] % 4 < 2 ? look.wool : look.second));
  CHECK(colours_of(*scene_of(session).yarn).size() == 2);
  look.by = YarnColours::label;
  apply(session, SetYarnLook{look});
  const auto labels = colours_of(*scene_of(session).yarn);
  CHECK(labels.size() >= 4);  // knit, cast on, increases, decreases
  look.by = YarnColours::stretch;
  apply(session, SetYarnLook{look});
  CHECK(colours_of(*scene_of(session).yarn).size() > 10);
  look.stripe_rounds = -3;
  apply(session, SetYarnLook{look});
  CHECK(session.view->yarn.stripe_rounds == 0);
}

TEST_CASE("yarn shown: outwards is away from a sphere's middle and its ground lies below") {
  const Session session = yarn_session();
  const Scene scene = scene_of(session);
  for (const YarnShape::Piece& piece : scene.yarn->pieces) {
    if (glm::length(piece.from_out) < 0.5F || glm::length(glm::vec2(piece.centre.x, piece.centre.z)) < 0.4F)
      continue;
    CHECK(glm::dot(piece.from_out, glm::normalize(piece.centre)) > 0.5F);
  }
  float lowest = 10.0F;
  for (const auto& face : scene.faces.at(0)->faces) lowest = std::min(lowest, glm::length(face.corners[0]));
  CHECK(lowest < 1.0F - 0.3F * scene.yarn->width);
}

TEST_CASE("yarn shown: drawn as finely as it is seen") {
  CHECK(yarn_detail(2.0).parts < yarn_detail(8.0).parts);
  CHECK(yarn_detail(8.0).parts < yarn_detail(20.0).parts);
  CHECK(yarn_detail(20.0).parts < yarn_detail(200.0).parts);
  CHECK(yarn_detail(8.0).across == 2);
  CHECK(yarn_detail(30.0).across == 3);
  CHECK_FALSE(yarn_detail(8.0).plies);
  CHECK(yarn_detail(40.0).plies);
}

TEST_CASE("yarn shown: one control from mesh to yarn") {
  Session session = finished_small_session();
  for (const Looking looking : {Looking::mesh, Looking::yarn, Looking::stitches}) {
    apply(session, ShowAs{looking});
    CHECK(looking_of(session) == looking);
  }
  apply(session, ShowAs{Looking::mesh});
  CHECK(session.view->shows(Layer::surface));
  CHECK_FALSE(session.view->shows(Layer::faces));
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.relax.relaxing = knit::Relaxing::on;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  apply(session, ShowAs{Looking::relaxed});
  CHECK(looking_of(session) == Looking::relaxed);
  CHECK(positions_shown(session) == Positions::relaxed);
  apply(session, ShowAs{Looking::stitches});
  CHECK(positions_shown(session) == Positions::settled);
}

TEST_CASE("yarn shown: a colour is read as it is written") {
  CHECK(hex_text({216, 180, 140}) == "#d8b48c");
  CHECK(colour_of_hex("#D8b48c") == Colour{216, 180, 140});
  for (const char* wrong : {"d8b48c", "#d8b48", "#d8b48cc", "#d8b48g", "#-8b48c", "red", ""})
    CHECK_FALSE(colour_of_hex(wrong).has_value());
}
