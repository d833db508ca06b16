// Opening one's own mesh: what was found stands in a line, a chosen preset goes along, and where the largest piece cannot
// be made fit another is offered.
#include <cmath>
#include <fstream>

#include "app/explain/found_words.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/presets.h"
#include "knit/model/settings_table.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;
using test_support::contains;
using test_support::Folder;

namespace {

std::filesystem::path obj_of(const Folder& folder, const std::string& name,
                             const std::vector<knit::Mesh>& meshes) {
  const std::filesystem::path path = folder.path() / name;
  std::ofstream out(path);
  std::size_t before = 1;
  for (const knit::Mesh& mesh : meshes) {
    for (const glm::dvec3& p : mesh.positions) out << "v " << p.x << " " << p.y << " " << p.z << "\n";
    for (const knit::Triangle& t : mesh.triangles)
      out << "f " << t[0] + before << " " << t[1] + before << " " << t[2] + before << "\n";
    before += mesh.positions.size();
  }
  return path;
}

// A strip with half a twist: no repair makes it fit.
knit::Mesh one_sided() {
  constexpr unsigned count = 12;
  knit::Mesh mesh;
  for (unsigned i = 0; i < count; ++i) {
    const double turn = 2.0 * 3.14159265358979 * i / count;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 5.0 + side * std::cos(0.5 * turn);
      mesh.positions.emplace_back(radius * std::cos(turn), side * std::sin(0.5 * turn),
                                  radius * std::sin(turn));
    }
  }
  for (unsigned i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const knit::VertexId a = 2 * i;
    const knit::VertexId b = a + 1;
    const knit::VertexId c = last ? 1 : a + 2;
    const knit::VertexId d = last ? 0 : a + 3;
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({b, d, c});
  }
  return mesh;
}

}  // namespace

TEST_CASE("own mesh: where the largest piece cannot be made fit, one that can is offered", "[own-mesh]") {
  const Folder folder;
  REQUIRE(one_sided().triangles.size() == 24);
  knit::Mesh many = knit::sphere(4, 3, false);
  REQUIRE(many.triangles.size() < 24);
  const auto offered = obj_of(folder, "offered.obj", {one_sided(), many});
  Session session;
  apply(session, OpenFile{offered});
  REQUIRE(session.jobs->repair_offer);
  CHECK(contains(session.jobs->repair_offer->plan->steps.front().would, "piece 2"));
  CHECK(contains(session.jobs->repair_offer->finding, "No piece before piece 2 can be repaired."));
  // The one that cannot be: said, and the other is still to choose.
  apply(session, OpenFile{offered, {true, {knit::keeping_piece(1)}}});
  CHECK(session.jobs->repair_offer);
  CHECK(session.outbox->notices.size() == 1);
  apply(session, RepairAndOpen{});
  REQUIRE(session.document);
  CHECK(session.document->timeline.input().mesh.triangles.size() == many.triangles.size());
}

TEST_CASE("own mesh: a preset that was chosen counts for the next one, with its numbers as they were changed",
          "[own-mesh]") {
  const Folder folder;
  const auto ball = obj_of(folder, "ball.obj", {knit::sphere(16, 9, false)});
  Session session;
  apply(session, OpenFile{ball});
  const knit::Parameters first = session.document->timeline.base_parameters();
  apply(session, OpenFile{ball});
  CHECK(session.document->timeline.base_parameters() == first);  // none was chosen
  apply(session, ApplyPreset{"knitters-gauge"});
  knit::Parameters changed = session.document->timeline.parameters();
  REQUIRE_FALSE(knit::set_value(*knit::find_parameter(knit::keys::gauge), changed, "18,24"));
  apply(session, Tune{changed});
  apply(session, OpenFile{ball});
  const knit::Parameters& now = session.document->timeline.base_parameters();
  CHECK(now.rows.source == knit::RowSource::contours);
  CHECK(now.size.from() == knit::SizesFrom::gauge);
  CHECK(now.stitch.gauge.stitches == Approx(18.0));
  CHECK(contains(session.outbox->notices.back().text, "Knitter's gauge"));
  CHECK(session.document->defaults == first);  // what reset goes back to
}

TEST_CASE("own mesh: what was found stands in a line until it is put away", "[own-mesh]") {
  const Folder folder;
  Desk desk;
  apply(desk.session, OpenFile{obj_of(folder, "ring.obj", {knit::torus(16, 8, 2.0, 0.8)})});
  const std::string words = shape_words(desk.session.document->timeline.input());
  CHECK(contains(words, "Closed, 256 triangles"));
  CHECK(contains(words, "rings along no axis; 1 handle."));
  CHECK(contains(shape_words(*knit::make_input(knit::sphere(16, 9, false))), "; rings along "));
  desk.settle();
  REQUIRE(desk.ui.controls.count("found") == 1);
  desk.session.document->timeline.extend_to_end();
  CHECK(contains(knitted_words(desk.session), "from contours"));
  CHECK(desk.click("found/away").empty());
  desk.settle();
  CHECK(desk.ui.controls.count("found") == 0);
}

TEST_CASE("own mesh: of a shape with limbs their number is said and of a ring that it has none",
          "[own-mesh]") {
  Session session = test_support::example_session("trousers");
  session.document->timeline.extend_to_end();
  CHECK(contains(knitted_words(session), ", as 3 tubes with 3 limbs."));
  session = test_support::example_session("torus");
  session.document->timeline.extend_to_end();
  CHECK(contains(knitted_words(session), ", as 4 tubes."));
}
