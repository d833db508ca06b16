// What is drawn of stitches too small to be told apart, of the last step's movement and of symbols come near.
#include "app/describe/describe_coarse.h"

#include <algorithm>
#include <set>

#include "app/describe/describe.h"
#include "app/describe/describe_motion.h"
#include "app/describe/describe_symbols.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

// A run of more stitches than are always drawn whole.
Session fine_session() {
  Session session;
  session.document = Document(knit::Timeline(knit::make_input(knit::sphere(48, 25, false)), [] {
    knit::Parameters fine;
    fine.rows.source = knit::RowSource::contours;
    fine.stitches.placement = knit::PlacementPolicy::even;
    knit::give_width(fine, 0.019), knit::give_height(fine, 0.019);
    knit::give_epsilon(fine, 0.009);
    return fine;
  }()));
  session.view->gaze.camera.frame(session.document->timeline.input().bounds, session.view->aspect);
  apply(session, ToLast{});
  return session;
}

std::size_t stitches_of(const Session& session) {
  std::size_t count = 0;
  for (const auto& row : session.document->timeline.state().fabric.rows()) count += row->stitches.size();
  return count;
}

std::size_t triangles_of(const Scene& scene) {
  std::size_t count = 0;
  for (const auto& shape : scene.faces) count += 2 * shape->faces.size();
  return count;
}

}  // namespace

TEST_CASE("stitches smaller than some pixels are drawn coarsely, and as they are from near") {
  Session session = fine_session();
  REQUIRE(stitches_of(session) > always_whole_stitches);
  const int stride = coarseness(session, 600.0);
  CHECK(stride > 1);
  CHECK(coarseness(session, 1200.0) < stride);
  const Scene far = Describer().describe(session);
  CHECK(far.coarse == stride);
  CHECK(far.point_sets.empty());
  const auto all = static_cast<double>(stitches_of(session));
  const double share = static_cast<double>(triangles_of(far)) / (2.0 * all);
  CHECK(share < 1.3 / (stride * stride));
  CHECK(share > 0.7 / (stride * stride));
  session.view->gaze.camera.distance *= 0.2;
  const Scene near = Describer().describe(session);
  CHECK(near.coarse == 1);
  CHECK(static_cast<double>(triangles_of(near)) > 1.8 * all);
}

TEST_CASE("drawn coarsely, it reaches from the first row to the last, and shows the rarer labels") {
  const Session session = fine_session();
  const Scene scene = Describer().describe(session);
  const auto& rows = session.document->timeline.state().fabric.rows();
  const glm::vec3 first(rows.front()->stitches.front().position);
  const glm::vec3 last(rows.back()->stitches.front().position);
  bool starts = false;
  bool ends = false;
  std::set<std::array<int, 3>> colours;
  for (const auto& shape : scene.faces) {
    for (const FaceShape::Face& face : shape->faces) {
      for (const glm::vec3& corner : face.corners) {
        starts = starts || corner == first;
        ends = ends || corner == last;
      }
      colours.insert({face.colour.r, face.colour.g, face.colour.b});
    }
  }
  CHECK(starts);
  CHECK(ends);
  for (const knit::Label label : {knit::Label::knit, knit::Label::main, knit::Label::m1r}) {
    const Colour colour = dark_theme.of(label);
    CHECK(colours.count({colour.r, colour.g, colour.b}) == 1);
  }
}

TEST_CASE("few stitches are always drawn whole, however far away") {
  Session session = test_support::finished_small_session();
  session.view->gaze.camera.distance *= 50.0;
  CHECK(coarseness(session, 300.0) == 1);
}

TEST_CASE("in pieces coarse shapes are made over some frames, at once they are whole, in a window too") {
  Session session = fine_session();
  session.jobs->beside = true;
  // So large that much is made, and still coarsely.
  Showing showing{600.0, 1.0};
  while (coarseness(session, 1.2 * showing.height_px) > 1) showing.height_px *= 1.2;
  const Scene whole = Describer().describe(session, showing);
  CHECK_FALSE(whole.unfinished);
  REQUIRE(whole.coarse > 1);
  REQUIRE(triangles_of(whole) > cells_a_frame);
  showing.in_pieces = true;
  Describer describer;
  Scene scene = describer.describe(session, showing);
  CHECK(scene.unfinished);
  CHECK(triangles_of(scene) < triangles_of(whole));
  for (int frame = 0; scene.unfinished && frame < 100; ++frame) scene = describer.describe(session, showing);
  CHECK_FALSE(scene.unfinished);
  CHECK(triangles_of(scene) == triangles_of(whole));
}

TEST_CASE("a step's movement ends where it says, and is not there without a place or a wish for it") {
  Session session = test_support::finished_small_session();
  apply(session, ToFirst{});
  while (last_step(session) == nullptr || !knit::is<knit::CandidateMeasured>(*last_step(session)))
    apply(session, StepBy{Unit::item, 1});
  const auto at = place_of_step(session, *last_step(session));
  REQUIRE(at.has_value());
  const auto& measured = *knit::get_if<knit::CandidateMeasured>(*last_step(session));
  CHECK(*at == glm::vec3(session.document->timeline.input().mesh.positions[measured.candidate]));
  const auto points = [&](double appeared) {
    return Describer().describe(session, {600.0, appeared}).points;
  };
  const std::size_t still = points(1.0).size();
  REQUIRE(points(0.0).size() == still + 1);
  CHECK(points(0.0).back().position == *at);
  CHECK(points(0.0).back().diameter_px > points(0.9).back().diameter_px);
  session.program->preferences.motion = false;
  CHECK(points(0.0).size() == still);
}

TEST_CASE("every step that makes something at one place has it") {
  Session session = test_support::finished_small_session();
  for (std::size_t i = 0; i < session.document->timeline.known(); ++i) {
    apply(session, SeekTo{i + 1});
    const knit::Step& step = session.document->timeline.step(i);
    const bool places = knit::is<knit::VertexTimed>(step) || knit::is<knit::StitchCastOn>(step) ||
                        knit::is<knit::CandidateMeasured>(step) || knit::is<knit::MainPlaced>(step) ||
                        knit::is<knit::ShapingPlaced>(step) || knit::is<knit::FaceMade>(step);
    if (places != place_of_step(session, step).has_value()) FAIL_CHECK("step " << i);
  }
}

TEST_CASE("faces bear their symbols when they are near") {
  Session session = test_support::finished_small_session();
  const auto ink = [&](double height_px) {
    const Scene scene = Describer().describe(session, {height_px, 1.0});
    std::ptrdiff_t count = 0;
    for (const auto& set : scene.line_sets) {
      count += std::count_if(set->begin(), set->end(), [&](const Line& line) {
        return with_alpha(line.colour, 255) == with_alpha(scene.theme->symbol, 255);
      });
    }
    return count;
  };
  CHECK(ink(60.0) == 0);
  const auto drawn = ink(2000.0);
  std::size_t shaping = 0;
  for (const auto& strip : session.document->timeline.state().fabric.strips())
    for (const knit::Face& face : strip->faces) shaping += knit::is_shaping(face.label) ? 1U : 0U;
  CHECK(static_cast<std::size_t>(drawn) >= shaping);
  CHECK(static_cast<std::size_t>(drawn) <= 2 * shaping);
  apply(session, SetLayer{Layer::faces, false});
  CHECK(ink(2000.0) == 0);
}
