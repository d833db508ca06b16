// What there is to see at each step: what the step is about, in the palette's colours, layer by layer.
#include "app/describe/describe.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/insight/narrate.h"
#include "knit/model/stitch_size.h"
#include "knit/model/words.h"
#include "knit/quality/measures.h"
#include "knit/run/machine.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using knit::Stage;
using test_support::finished_small_session;
using test_support::small_session;

namespace {

Scene scene_of(const Session& session) { return Describer().describe(session); }

glm::vec3 vertex_place(const Session& session, knit::VertexId vertex) {
  return glm::vec3(session.document->timeline.input().mesh.positions[vertex]);
}

// Moves to the first step from the position on that is of the kind and passes the test; returns it.
template <class Kind, class Test>
Kind seek_to_step(Session& session, Test test) {
  for (std::size_t i = session.document->timeline.position(); i < session.document->timeline.known(); ++i) {
    const auto* what = knit::get_if<Kind>(session.document->timeline.step(i));
    if (what == nullptr || !test(*what)) continue;
    apply(session, SeekTo{i + 1});
    return *what;
  }
  FAIL("the run has no such step");
  return {};
}
template <class Kind>
Kind seek_to_step(Session& session) {
  return seek_to_step<Kind>(session, [](const Kind&) { return true; });
}

std::size_t count_points(const Scene& scene, Colour colour) {
  const auto is = [&](const Point& point) { return point.colour == colour; };
  auto count = std::count_if(scene.points.begin(), scene.points.end(), is);
  for (const auto& set : scene.point_sets) count += std::count_if(set->begin(), set->end(), is);
  return static_cast<std::size_t>(count);
}

std::size_t count_lines(const Scene& scene, Colour colour) {
  const auto is = [&](const Line& line) { return line.colour == colour; };
  auto count = std::count_if(scene.lines.begin(), scene.lines.end(), is);
  for (const auto& set : scene.line_sets) count += std::count_if(set->begin(), set->end(), is);
  return static_cast<std::size_t>(count);
}

bool has_point(const Scene& scene, const glm::vec3& place, Colour colour) {
  return std::any_of(scene.points.begin(), scene.points.end(),
                     [&](const Point& p) { return p.position == place && p.colour == colour; });
}

// Triangles of the scene's faces, or of those in a colour; a quad is two.
std::size_t count_triangles(const Scene& scene, std::optional<Colour> colour = std::nullopt) {
  std::size_t triangles = 0;
  for (const auto& shape : scene.faces) {
    for (const FaceShape::Face& face : shape->faces)
      if (!colour || face.colour == *colour) triangles += face.is_quad() ? 2U : 1U;
  }
  return triangles;
}

// Yarn stands in the place of others.
void set_all_layers(Session& session, bool on) {
  session.view->layers.fill(on);
  session.view->layers[static_cast<std::size_t>(Layer::yarn)] = false;
}

// A run with stalls that are repaired, so that every kind of step is there.
Session uneven_session() {
  Session session = small_session();
  knit::Parameters parameters = session.document->timeline.parameters();
  knit::give_epsilon(parameters, 0.01);
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  return session;
}

}  // namespace

TEST_CASE("with nothing open there is a background and no mesh") {
  const Scene scene = scene_of(Session{});
  CHECK(scene.mesh == nullptr);
  CHECK(scene.background == dark_theme.background);
  CHECK(scene.points.empty());
}

TEST_CASE("the mesh: every vertex with its normal outward, and times up to the vertex timed last") {
  Session session = small_session();
  Scene scene = scene_of(session);
  const knit::Mesh& mesh = session.document->timeline.input().mesh;
  REQUIRE(scene.mesh);
  REQUIRE(scene.mesh->positions.size() == mesh.positions.size());
  REQUIRE(scene.mesh->normals.size() == mesh.positions.size());
  CHECK(scene.mesh->triangles.size() == 3 * mesh.triangles.size());
  CHECK(scene.mesh->edges.size() == 2 * mesh.edges.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    CHECK(glm::dot(scene.mesh->normals[v], scene.mesh->positions[v]) > 0.95F);  // a sphere about the origin
  }
  CHECK(scene.timed_vertices == 0);
  CHECK(scene.time_low == dark_theme.time_low);
  CHECK(scene.time_high == dark_theme.time_high);

  apply(session, ToLast{});
  apply(session, SeekTo{51});
  scene = scene_of(session);
  CHECK(scene.timed_vertices == 50);
  const auto& timed = *knit::get_if<knit::VertexTimed>(*last_step(session));
  CHECK(timed.vertex == 49);
  CHECK(has_point(scene, vertex_place(session, 49), dark_theme.accepted));
  CHECK(scene.times->at(49) == static_cast<float>(timed.time));

  apply(session, ToLast{});
  CHECK(scene_of(session).timed_vertices == mesh.positions.size());
}

TEST_CASE("a seam does not show in the normals") {
  const Session session = small_session(true);
  const Scene scene = scene_of(session);
  const auto& twin = session.document->timeline.input().twin;
  std::size_t twins = 0;
  for (std::size_t v = 0; v < twin.size(); ++v) {
    if (twin[v] != v) ++twins;
    CHECK(scene.mesh->normals[v] == scene.mesh->normals[twin[v]]);
    CHECK(glm::dot(scene.mesh->normals[v], scene.mesh->positions[v]) > 0.999F);
  }
  CHECK(twins > 5);
}

TEST_CASE("the first step shows start and end by name") {
  Session session = finished_small_session();
  apply(session, ToFirst{});
  const auto ends = seek_to_step<knit::EndsFound>(session);
  const Scene scene = scene_of(session);
  CHECK(has_point(scene, vertex_place(session, ends.start), dark_theme.time_low));
  CHECK(has_point(scene, vertex_place(session, ends.end), dark_theme.time_high));
  REQUIRE(scene.captions.size() == 2);
  CHECK(scene.captions[0].text == "start");
  CHECK(scene.captions[0].position == vertex_place(session, ends.start));
  CHECK(scene.captions[1].text == "end");
}

TEST_CASE("cast on: the cycle, and the stitches placed so far in the colour of the cast on") {
  Session session = finished_small_session();
  apply(session, ToFirst{});
  const auto found = seek_to_step<knit::CycleFound>(session);
  CHECK(count_points(scene_of(session), dark_theme.ring) == static_cast<std::size_t>(found.vertices));
  seek_to_step<knit::StitchCastOn>(session, [](const auto& s) { return s.stitch == 4; });
  CHECK(count_points(scene_of(session), dark_theme.of(knit::Label::cast)) == 4);
}

TEST_CASE("while a row is walked: anchor, band, candidates, and the distance as a caption") {
  Session session = finished_small_session();
  apply(session, SeekPlace{{Stage::rows, 5, 0}});
  for (const knit::Verdict verdict : {knit::Verdict::too_near, knit::Verdict::accepted}) {
    const auto measured = seek_to_step<knit::CandidateMeasured>(session, [&](const auto& m) {
      return m.verdict == verdict && m.distance > 0.0 && m.anchor_order > 0;
    });
    const Scene scene = scene_of(session);
    REQUIRE(scene.band);
    // The band that the verdict fell by, though an accepted candidate is the anchor by now.
    const knit::VertexId anchor = measured.anchor;
    CHECK(scene.band->centre == vertex_place(session, anchor));
    CHECK(scene.band->inner == Approx(0.15));
    CHECK(scene.band->middle == Approx(0.3));
    CHECK(scene.band->outer == Approx(0.45));
    CHECK(glm::length(scene.band->normal) == Approx(1.0));
    CHECK(scene.band->colour == dark_theme.band);
    CHECK(has_point(scene, vertex_place(session, anchor), dark_theme.anchor));

    REQUIRE(scene.captions.size() == 1);
    CHECK(scene.captions[0].text == knit::short_number(measured.distance));
    const glm::vec3 from = vertex_place(session, measured.anchor);
    const glm::vec3 to = vertex_place(session, measured.candidate);
    REQUIRE(scene.captions[0].other_end);
    CHECK(scene.captions[0].position == from);
    CHECK(*scene.captions[0].other_end == to);
    const bool drawn = std::any_of(scene.lines.begin(), scene.lines.end(),
                                   [&](const Line& line) { return line.from == from && line.to == to; });
    CHECK(drawn);
    const Colour colour = verdict == knit::Verdict::accepted ? dark_theme.accepted : dark_theme.ring;
    CHECK(has_point(scene, to, colour));
    // The whole cycle is there: measured or not yet.
    const auto ring = std::get<knit::RowWork>(session.document->timeline.state().work).ring;
    CHECK(count_points(scene, dark_theme.ring) + count_points(scene, dark_theme.too_near) >=
          ring->vertices.size());
  }
}

TEST_CASE("who guesses sees the band that the next verdict falls by") {
  Session session = finished_small_session();
  apply(session, SeekPlace{{Stage::rows, 5, 0}});
  const auto accepted = seek_to_step<knit::CandidateMeasured>(session, [](const auto& measured) {
    return measured.verdict == knit::Verdict::accepted && measured.anchor_order > 0;
  });
  CHECK(scene_of(session).band->centre == vertex_place(session, accepted.anchor));
  apply(session, SetPredicting{true});
  CHECK(scene_of(session).band->centre == vertex_place(session, accepted.candidate));
}

TEST_CASE("finished faces cover the surface from the first row to the last that they reach") {
  Session session = finished_small_session();
  const auto& rows = session.document->timeline.furthest().fabric.rows();
  Scene scene = scene_of(session);
  REQUIRE(scene.covered);
  CHECK(scene.covered->from == static_cast<float>(rows.front()->time));
  CHECK(scene.covered->to == static_cast<float>(rows.back()->time));
  apply(session, SeekPlace{{Stage::faces, 4, 1}});
  REQUIRE(session.document->timeline.state().fabric.strips().size() == 2);
  scene = scene_of(session);
  REQUIRE(scene.covered);
  CHECK(scene.covered->to == static_cast<float>(rows[2]->time));
  apply(session, SetLayer{Layer::faces, false});
  CHECK_FALSE(scene_of(session).covered);
}

TEST_CASE("a row that closes shows its gap with its length") {
  Session session = finished_small_session();
  apply(session, SeekPlace{{Stage::rows, 5, 0}});
  const auto closed = seek_to_step<knit::RowClosed>(session);
  const Scene scene = scene_of(session);
  CHECK_FALSE(scene.band);
  REQUIRE(scene.captions.size() == 1);
  CHECK(scene.captions[0].text == knit::short_number(closed.gap));
  CHECK(count_lines(scene, dark_theme.anchor) == 1);
  CHECK(scene.points.size() >= static_cast<std::size_t>(closed.stitches));
}

TEST_CASE("a stall that was repaired shows as a problem, with its distance") {
  Session session = uneven_session();
  apply(session, ToFirst{});
  const auto missed = seek_to_step<knit::BandMissed>(session);
  const Scene scene = scene_of(session);
  CHECK(has_point(scene, vertex_place(session, missed.taken), dark_theme.problem));
  CHECK(count_lines(scene, dark_theme.problem) == 1);
  const bool said = std::any_of(scene.captions.begin(), scene.captions.end(), [&](const Caption& caption) {
    return caption.text == knit::short_number(missed.distance);
  });
  CHECK(said);
}

TEST_CASE("finished rows: an edge and a point a stitch, first and last row in the colour of the cast on") {
  Session session = finished_small_session();
  const Scene scene = scene_of(session);
  const auto& rows = session.document->timeline.state().fabric.rows();
  std::size_t stitches = 0;
  for (const auto& row : rows) stitches += row->stitches.size();
  const std::size_t ends = rows.front()->stitches.size() + rows.back()->stitches.size();
  CHECK(count_points(scene, dark_theme.of(knit::Label::cast)) == ends);
  CHECK(count_points(scene, dark_theme.stitch) == stitches - ends);
  CHECK(count_lines(scene, dark_theme.of(knit::Label::cast)) == ends);
  CHECK(count_lines(scene, dark_theme.row_edge) == stitches - ends);
  std::size_t columns = 0;
  for (const auto& strip : session.document->timeline.state().fabric.strips())
    columns += strip->column_edges.size();
  CHECK(count_lines(scene, dark_theme.column_edge) == columns);
}

TEST_CASE("labels are placed as coloured stitches, each with its name as it is placed, the last one too") {
  Session session = finished_small_session();
  apply(session, SeekPlace{{Stage::stitches, 2, 0}});
  std::set<std::string> seen;
  std::size_t wrong = 0;
  while (session.document->timeline.place().stage == Stage::stitches) {
    const auto* shaping = knit::get_if<knit::ShapingPlaced>(*last_step(session));
    const bool main = knit::is<knit::MainPlaced>(*last_step(session));
    const Scene scene = scene_of(session);
    if (shaping != nullptr || main) {
      const knit::Label label = main ? knit::Label::main : shaping->label;
      REQUIRE(scene.captions.size() == 1);
      const Caption& caption = scene.captions[0];
      wrong += caption.text == knit::name_of(label) && caption.colour == dark_theme.of(label) &&
                       has_point(scene, caption.position, dark_theme.of(label))
                   ? 0U
                   : 1U;
      seen.insert(caption.text);
    } else {
      CHECK(scene.captions.empty());
    }
    apply(session, StepBy{});
  }
  CHECK(wrong == 0);
  CHECK(seen == std::set<std::string>{"M1R", "M1L", "K2tog", "SSK", "main"});
}

TEST_CASE("faces carry the palette's colour of their label") {
  Session session = finished_small_session();
  const Scene scene = scene_of(session);
  std::array<std::size_t, 7> triangles{};
  std::set<int> labels;
  for (const auto& strip : session.document->timeline.state().fabric.strips()) {
    for (const knit::Face& face : strip->faces) {
      triangles.at(static_cast<std::size_t>(face.label)) += face.corner_count == 4 ? 2U : 1U;
      labels.insert(static_cast<int>(face.label));
    }
  }
  CHECK(labels.size() >= 6);
  for (const int label : labels) {
    CAPTURE(label);
    CHECK(count_triangles(scene, dark_theme.of(static_cast<knit::Label>(label))) ==
          triangles.at(static_cast<std::size_t>(label)));
  }
  for (const auto& shape : scene.faces) {
    for (const FaceShape::Face& face : shape->faces) {
      for (const glm::vec3& corner : face.corners) CHECK(glm::dot(face.normal, corner) > 0.0F);
      CHECK(glm::length(face.normal) == Approx(1.0F));
    }
  }
}

TEST_CASE("faces appear one by one, the newest outlined, the last of a row too") {
  Session session = finished_small_session();
  apply(session, SeekPlace{{Stage::faces, 4, 0}});
  std::size_t before = count_triangles(scene_of(session));
  std::size_t wrong = 0;
  for (int i = 0; i < 60; ++i) {
    apply(session, StepBy{});
    const auto& made = *knit::get_if<knit::FaceMade>(*last_step(session));
    const Scene scene = scene_of(session);
    const auto corners = static_cast<std::size_t>(made.corner_count);
    wrong += count_triangles(scene) == before + corners - 2 ? 0U : 1U;
    wrong += count_lines(scene, dark_theme.accepted) == corners ? 0U : 1U;
    before = count_triangles(scene);
  }
  CHECK(wrong == 0);
  CHECK(session.document->timeline.place().row > 4);
}

TEST_CASE("the four shaping colours, knit, main and cast on differ clearly from each other") {
  for (int a = 0; a < 7; ++a) {
    for (int b = 0; b < a; ++b) {
      const Colour x = dark_theme.of(static_cast<knit::Label>(a));
      const Colour y = dark_theme.of(static_cast<knit::Label>(b));
      CAPTURE(a, b);
      CHECK(std::abs(x.r - y.r) + std::abs(x.g - y.g) + std::abs(x.b - y.b) > 60);
    }
  }
}

TEST_CASE("with all layers off nothing is left, at any step") {
  for (Session session : {uneven_session(), finished_small_session()}) {
    set_all_layers(session, false);
    Describer describer;
    std::set<std::string> drawn;
    for (std::size_t position = 0; position <= session.document->timeline.known();
         position += position < 4 ? 1 : 7) {
      apply(session, SeekTo{position});
      const Scene scene = describer.describe(session);
      const bool empty = scene.points.empty() && scene.lines.empty() && scene.captions.empty() &&
                         !scene.band && scene.faces.empty() && !scene.isolines && scene.line_sets.empty() &&
                         scene.point_sets.empty();
      if (!empty) drawn.insert(std::string(knit::kind_name(*last_step(session))));
      CHECK_FALSE((scene.show_surface || scene.show_times || scene.show_wire));
    }
    CHECK(drawn == std::set<std::string>{});
  }
}

TEST_CASE("each layer takes away its own and nothing else") {
  const auto amount = [](const Scene& scene) {
    std::size_t things =
        scene.points.size() + scene.lines.size() + scene.captions.size() + (scene.band ? 1U : 0U);
    if (scene.isolines) things += scene.isolines->size();
    for (const auto& set : scene.line_sets) things += set->size();
    for (const auto& set : scene.point_sets) things += set->size();
    for (const auto& set : scene.faces) things += set->faces.size();
    return things;
  };
  const std::vector<knit::Place> places{
      {Stage::cast_on, 1, 3}, {Stage::rows, 5, 9}, {Stage::stitches, 4, 3}, {Stage::faces, 5, 3}};
  for (const knit::Place& place : places) {
    Session session = finished_small_session();
    apply(session, SeekPlace{place});
    set_all_layers(session, true);
    const Scene all = scene_of(session);
    std::size_t taken = 0;
    for (std::size_t i = 0; i < layer_count; ++i) {
      session.view->layers[i] = false;
      const Scene less = scene_of(session);
      session.view->layers[i] = true;
      CHECK(amount(less) <= amount(all));
      taken += amount(all) - amount(less);
    }
    CHECK(taken == amount(all));  // everything belongs to exactly one layer
  }
}

TEST_CASE("layers by name: surface, times, mesh edges, faces, edges, stitches, band") {
  Session session = finished_small_session();
  const auto without = [&](Layer layer) {
    set_all_layers(session, true);
    apply(session, SetLayer{layer, false});
    return scene_of(session);
  };
  CHECK_FALSE(without(Layer::surface).show_surface);
  CHECK_FALSE(without(Layer::times).show_times);
  CHECK_FALSE(without(Layer::wire).show_wire);
  CHECK(without(Layer::faces).faces.empty());
  CHECK(count_lines(without(Layer::column_edges), dark_theme.column_edge) == 0);
  CHECK(count_lines(without(Layer::column_edges), dark_theme.row_edge) > 0);
  CHECK(count_lines(without(Layer::row_edges), dark_theme.row_edge) == 0);
  CHECK(count_lines(without(Layer::row_edges), dark_theme.column_edge) > 0);
  CHECK(without(Layer::stitches).point_sets.empty());

  apply(session, SeekPlace{{Stage::rows, 5, 9}});
  CHECK(without(Layer::stitches).band);
  CHECK_FALSE(without(Layer::band).band);
  CHECK(count_points(without(Layer::band), dark_theme.anchor) == 0);
  CHECK(count_points(without(Layer::cycle), dark_theme.ring) == 0);
  CHECK(without(Layer::cycle).captions.empty());
}

TEST_CASE("finished products keep their shapes from frame to frame, forward and back") {
  Session session = finished_small_session();
  Describer describer;
  // The same session twice: every shape is the same object.
  const Scene first = describer.describe(session);
  const Scene again = describer.describe(session);
  CHECK(first.mesh == again.mesh);
  CHECK(first.faces == again.faces);
  CHECK(first.line_sets == again.line_sets);
  CHECK(first.point_sets == again.point_sets);

  // A few steps on in the middle of a row: what was finished is the same.
  apply(session, SeekPlace{{Stage::rows, 6, 2}});
  const Scene middle = describer.describe(session);
  apply(session, SeekPlace{{Stage::rows, 6, 20}});
  const Scene later = describer.describe(session);
  CHECK(middle.mesh == first.mesh);
  CHECK(later.mesh == first.mesh);
  REQUIRE(middle.line_sets.size() == 5);  // five rows
  CHECK(middle.isolines == later.isolines);
  CHECK(later.line_sets == middle.line_sets);
  CHECK(later.point_sets == middle.point_sets);

  // Looking from elsewhere changes no shape either.
  apply(session, Orbit{1.0, 0.3});
  CHECK(describer.describe(session).line_sets == later.line_sets);
}

TEST_CASE("what is shown never depends on what was shown before") {
  Session session = finished_small_session();
  Describer used;
  const auto check_same = [&] {
    const Scene a = used.describe(session);
    const Scene b = scene_of(session);
    const auto same_line = [](const Line& x, const Line& y) {
      return x.from == y.from && x.to == y.to && x.colour == y.colour;
    };
    const auto same_point = [](const Point& x, const Point& y) {
      return x.position == y.position && x.colour == y.colour;
    };
    const auto same_face = [](const FaceShape::Face& x, const FaceShape::Face& y) {
      return x.corners == y.corners && x.colour == y.colour;
    };
    const auto equal = [](const auto& x, const auto& y, auto same) {
      return std::equal(x.begin(), x.end(), y.begin(), y.end(), same);
    };
    const auto equal_sets = [&](const auto& x, const auto& y, auto same) {
      return equal(x, y, [&](const auto& p, const auto& q) { return equal(*p, *q, same); });
    };
    CHECK(equal(a.points, b.points, same_point));
    CHECK(equal(a.lines, b.lines, same_line));
    CHECK(equal_sets(a.point_sets, b.point_sets, same_point));
    CHECK(equal_sets(a.line_sets, b.line_sets, same_line));
    CHECK(equal(a.faces, b.faces,
                [&](const auto& p, const auto& q) { return equal(p->faces, q->faces, same_face); }));
    CHECK(a.mesh->positions == b.mesh->positions);
    REQUIRE((a.times == nullptr) == (b.times == nullptr));
    if (a.times != nullptr) CHECK(*a.times == *b.times);
  };
  const std::size_t all = session.document->timeline.known();
  for (const std::size_t position :
       {all, std::size_t{900}, all - 30, std::size_t{10}, std::size_t{1200}, all}) {
    apply(session, SeekTo{position});
    check_same();
  }
  knit::Parameters tuned = session.document->timeline.parameters();
  for (const double epsilon : {0.1, 0.15}) {
    knit::give_epsilon(tuned, epsilon);
    apply(session, Tune{tuned});
    apply(session, ToLast{});
    check_same();
  }
  tuned.timing.axis = knit::Axis{knit::AxisKind::custom, {0.0, -1.0, 0.0}};
  apply(session, Tune{tuned});
  apply(session, ToLast{});
  check_same();
  apply(session, OpenExample{"egg"});
  check_same();
}

TEST_CASE("the current row is lit at every stage that goes through its stitches, and none at the end") {
  Session session = finished_small_session();
  const knit::Timeline& timeline = session.document->timeline;
  for (const Stage stage : {Stage::stitches, Stage::faces, Stage::pattern}) {
    const std::size_t at = timeline.position_of({stage, 3, 0});
    apply(session, SeekTo{at});
    REQUIRE(timeline.place().stage == stage);
    REQUIRE(timeline.place().row == 3);
    const Scene scene = scene_of(session);
    const knit::Row& row = timeline.state().fabric.row(3);
    for (const auto& edge : knit::edges_of(row)) {
      const bool lit = std::any_of(scene.lines.begin(), scene.lines.end(), [&](const Line& line) {
        return line.colour == with_alpha(scene.theme->accepted, 235) && line.width_px > 3.0F &&
               line.from == glm::vec3(row.stitches[edge.from].position) &&
               line.to == glm::vec3(row.stitches[edge.to].position);
      });
      CHECK(lit);
    }
  }
  apply(session, ToLast{});
  const Scene scene = scene_of(session);
  CHECK(std::none_of(scene.lines.begin(), scene.lines.end(), [&](const Line& line) {
    return line.colour == with_alpha(scene.theme->accepted, 235);
  }));
}
