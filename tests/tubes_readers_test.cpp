// Everything that reads rows, on runs that branch: why, breaks, what is drawn and picked, what is written, lessons' judges.
#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/describe/describe.h"
#include "app/describe/describe_coarse.h"
#include "app/describe/describe_motion.h"
#include "app/describe/pick.h"
#include "app/describe/thing_places.h"
#include "app/explain/why_words.h"
#include "app/files/export.h"
#include "app/files/gltf.h"
#include "app/files/plots.h"
#include "app/lessons/lesson_judge.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/insight/breaks.h"
#include "knit/insight/waiting.h"
#include "knit/insight/why.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

// A join, a split, and both with a handle between; a ring at both ends.
enum class Body { arch, horns, torus_on_rim, torus_flat };

Mesh mesh_of(Body body) {
  if (body == Body::arch || body == Body::horns) {
    Mesh mesh = test_support::arch();
    for (glm::dvec3& p : mesh.positions) p = body == Body::horns ? glm::dvec3(p.x, -p.y, -p.z) : p;
    return mesh;
  }
  return torus(48, 24, 0.68, 0.32);
}

Parameters parameters_of(Body body, const Input& input) {
  Parameters parameters;
  give_width(parameters, 0.12);
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  if (body == Body::torus_on_rim) parameters.timing.axis = Axis{AxisKind::x};
  if (body == Body::torus_flat) parameters.tubes.smoothing = Smoothing::off;
  return resolved(parameters, input);
}

app::Session session_of(Body body) {
  const auto input = make_input(mesh_of(body));
  const Parameters parameters = parameters_of(body, *input);
  app::Session session;
  session.document = app::Document(Timeline(input, parameters));
  session.document->defaults = parameters;
  session.document->timeline.extend_to_end();
  REQUIRE(session.document->timeline.stop() == nullptr);
  session.view->gaze.camera.frame(input->bounds, session.view->aspect);
  return session;
}

template <class Is>
std::size_t step_where(const Timeline& timeline, Is is, std::size_t from = 0) {
  for (std::size_t i = from; i < timeline.known(); ++i) {
    if (is(timeline.step(i))) return i;
  }
  FAIL("no such step");
  return 0;
}

// Those that only a branching fabric has.
std::vector<Element> things_of_deals(const Fabric& fabric) {
  std::vector<Element> things;
  for (std::size_t d = 0; d < fabric.deals().size(); ++d) {
    const RowId row = bridge_row(static_cast<std::int32_t>(d) + 1);
    const Deal& deal = *fabric.deals()[d];
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(deal.bridge.size()); ++i) {
      things.emplace_back(StitchElement{row, i});
      if (i > 0) things.emplace_back(RowEdgeElement{row, i - 1});
    }
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(deal.faces.size()); ++i)
      things.emplace_back(FaceElement{row, i});
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(deal.column_edges.size()); ++i)
      things.emplace_back(ColumnEdgeElement{row, i});
  }
  return things;
}

constexpr std::array bodies{Body::arch, Body::horns, Body::torus_on_rim, Body::torus_flat};

std::set<std::array<StitchRef, 2>> edges_of(const std::vector<std::array<StitchRef, 2>>& edges) {
  return {edges.begin(), edges.end()};
}

}  // namespace

// --- why -----------------------------------------------------------------------------------------------------------

TEST_CASE(
    "readers: a bridge's stitches, edges and faces are there after the step that made them and not before") {
  for (const Body body : bodies) {
    app::Session session = session_of(body);
    Timeline& timeline = session.document->timeline;
    const std::vector<Element> things = things_of_deals(timeline.furthest().fabric);
    REQUIRE(things.size() > 3);
    std::size_t wrong = 0;
    for (const Element& thing : things) {
      const auto made = made_by(timeline, thing);
      INFO(app::text_of(thing));
      REQUIRE(made);
      timeline.seek(*made);
      wrong += exists(timeline.state(), thing) ? 1U : 0U;
      timeline.forward();
      wrong += exists(timeline.state(), thing) ? 0U : 1U;
      wrong += touches(timeline, thing, *made) ? 0U : 1U;
      wrong += touch_from(timeline, thing, 0) == *made ? 0U : 1U;
      CHECK(!app::outline_of(timeline.input(), timeline.state(), thing).empty());
    }
    CHECK(wrong == 0);
    CHECK_FALSE(made_by(timeline, StitchElement{bridge_row(99), 0}));
    CHECK_FALSE(exists(timeline.furthest(), StitchElement{-1, 1000}));
    CHECK_FALSE(exists(timeline.furthest(), FaceElement{-1, -1}));
  }
}

TEST_CASE("readers: what is found by walking all steps is found by jumping, on bridges and beside them") {
  const app::Session session = session_of(Body::torus_on_rim);
  const Timeline& timeline = session.document->timeline;
  const Fabric& fabric = timeline.furthest().fabric;
  std::vector<Element> things = things_of_deals(fabric);
  const LiveStitches& on = fabric.deals()[0]->given[0];
  for (const StitchSpan& span : on.spans) {
    if (span.row < 0) continue;
    things.emplace_back(StitchElement{span.row, span.first});
    things.emplace_back(RowEdgeElement{span.row, span.first + span.count - 1});
  }
  for (const Element& thing : things) {
    INFO(app::text_of(thing));
    std::vector<std::size_t> walked;
    for (std::size_t i = 0; i < timeline.known(); ++i) {
      if (touches(timeline, thing, i)) walked.push_back(i);
    }
    std::vector<std::size_t> jumped;
    for (auto at = touch_from(timeline, thing, 0); at; at = touch_from(timeline, thing, *at + 1))
      jumped.push_back(*at);
    REQUIRE(!walked.empty());
    CHECK(walked == jumped);
    CHECK(touch_before(timeline, thing, timeline.known()) == walked.back());
  }
}

TEST_CASE("readers: an edge that a split cuts is touched by no face") {
  const app::Session session = session_of(Body::horns);
  const Timeline& timeline = session.document->timeline;
  const Fabric& fabric = timeline.furthest().fabric;
  const Deal& deal = *fabric.deals().front();
  REQUIRE(deal.kind == DealKind::split);
  // The last stitch of an arc: the next of its row goes to the other side.
  const StitchSpan& arc = deal.given[1].spans.front();
  const Row& row = fabric.row(arc.row);
  const RowEdgeElement cut{arc.row, (arc.first + arc.count - 1) % size_of(row)};
  std::size_t faces = 0;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const Step& step = timeline.step(i);
    if (is<FaceMade>(step) && step.place.row > arc.row) faces += touches(timeline, cut, i) ? 1U : 0U;
  }
  CHECK(faces == 0);
}

TEST_CASE("readers: a vertex lies on a tube between two of its rows, and a saddle is an event") {
  const app::Session session = session_of(Body::torus_on_rim);
  const Timeline& timeline = session.document->timeline;
  const State& run = timeline.furthest();
  std::map<TubeId, int> tubes;
  std::size_t wrong = 0;
  for (VertexId v = 0; v < timeline.input().mesh.positions.size(); v += 7) {
    const auto on = on_tube(timeline, v);
    REQUIRE(on);
    ++tubes[on->tube];
    if (on->below > 0 && on->above > 0) wrong += on->above == on->below + 1 ? 0U : 1U;
    if (on->below > 0) wrong += run.fabric.row(on->below).tube == on->tube ? 0U : 1U;
  }
  CHECK(wrong == 0);
  CHECK(tubes.size() == 4);
  for (std::size_t i = 0; i < run.tubes->events.size(); ++i) {
    const auto on = on_tube(timeline, run.tubes->events[i].vertex);
    REQUIRE(on);
    CHECK(on->event == static_cast<std::int32_t>(i));
    const VertexElement vertex{run.tubes->events[i].vertex};
    const bool deals =
        run.tubes->events[i].kind == EventKind::split || run.tubes->events[i].kind == EventKind::join;
    const std::size_t gaps = deals ? step_where(timeline,
                                                [&](const Step& step) {
                                                  const auto* found = get_if<GapsFound>(step);
                                                  return found != nullptr && found->vertex == vertex.vertex;
                                                })
                                   : 0;
    if (deals) CHECK(touches(timeline, vertex, gaps));
    if (deals) CHECK(touch_from(timeline, vertex, gaps) == gaps);
  }
}

// --- breaks, holders -----------------------------------------------------------------------------------------------

TEST_CASE("readers: what is cast on is found in every tube and on bridges") {
  const app::Session session = session_of(Body::arch);
  const Timeline& timeline = session.document->timeline;
  const State& run = timeline.furthest();
  BreakScanner scanner({std::get<BreakCondition>(parse_break("label=cast"))});
  std::size_t cast_on = 0;
  for (const auto& row : run.fabric.rows()) cast_on += row->on.empty() ? row->stitches.size() : 0U;
  for (const auto& deal : run.fabric.deals()) cast_on += deal->bridge.size();
  REQUIRE(run.fabric.deals().front()->kind == DealKind::join);
  for (std::size_t i = 0; i < timeline.known(); ++i)
    scanner.take(timeline.step(i), timeline.parameters_of_step(i), run.fabric);
  CHECK(scanner.count(0) == cast_on);
}

TEST_CASE("readers: a loop waits until it is worked, and not once it is bound off") {
  app::Session session = session_of(Body::horns);
  Timeline& timeline = session.document->timeline;
  const auto taken = [&](TubeId tube) {
    return step_where(timeline, [&](const Step& step) {
      const auto* what = get_if<TubeTaken>(step);
      return what != nullptr && what->tube == tube;
    });
  };
  timeline.seek(taken(0) + 1);
  CHECK(waiting_tubes(timeline.state()).empty());
  timeline.seek(taken(1) + 2);
  CHECK(waiting_tubes(timeline.state()) == std::vector<TubeId>{2});
  timeline.seek(taken(2) + 2);
  REQUIRE(timeline.state().fabric.live().size() == 2);  // the first horn's tip, too
  CHECK(waiting_tubes(timeline.state()).empty());
}

// --- what is drawn -------------------------------------------------------------------------------------------------

TEST_CASE("readers: a deal adds as many edges as it should, each once") {
  for (const Body body : bodies) {
    const app::Session session = session_of(body);
    for (const auto& deal : session.document->timeline.furthest().fabric.deals()) {
      const auto edges = app::edges_added(*deal);
      CHECK(edges.size() + deal->column_edges.size() == edge_count(*deal));
      CHECK(edges_of(edges).size() == edges.size());
    }
  }
}

TEST_CASE("readers: in the end every deal is sewn in, a graft too, and none before the strip above it") {
  for (const Body body : bodies) {
    app::Session session = session_of(body);
    Timeline& timeline = session.document->timeline;
    const Fabric& whole = timeline.furthest().fabric;
    for (const auto& deal : whole.deals()) CHECK(app::is_sewn(whole, *deal));
    timeline.seek(timeline.position_of({Stage::faces, 2, -1}));
    for (const auto& deal : timeline.state().fabric.deals())
      CHECK_FALSE(app::is_sewn(timeline.state().fabric, *deal));
    timeline.seek(timeline.known());
    std::size_t faces = 0, drawn = 0;
    for (const auto& strip : whole.strips()) faces += strip->faces.size();
    for (const auto& deal : whole.deals()) faces += deal->faces.size();
    for (const auto& shape : app::Describer().describe(session).faces) drawn += shape->faces.size();
    CHECK(drawn == faces);
  }
}

TEST_CASE(
    "readers: drawn coarsely, tubes are no single stack: each begins on its own loop, from far and near") {
  for (const Body body : bodies) {
    app::Session session = session_of(body);
    Timeline& timeline = session.document->timeline;
    for (const std::size_t at : {timeline.known(), timeline.position_of({Stage::faces, 20, -1})}) {
      timeline.seek(at);
      const Fabric& fabric = timeline.state().fabric;
      for (const int stride : {1, 2, 3, 64}) {
        app::Scene scene;
        scene.theme = &app::dark_theme;
        app::Coarse coarse;
        coarse.describe(session, fabric, {stride}, false, scene);
        std::size_t faces = 0;
        double farthest = 0.0;
        for (const auto& shape : scene.faces) {
          faces += shape->faces.size();
          for (const auto& face : shape->faces)
            farthest =
                std::max(farthest, static_cast<double>(glm::distance(face.corners[0], face.corners[3])));
        }
        CHECK((faces > 0) == !fabric.strips().empty());
        // From one row to the next a face is as high as a row, even where a tube begins.
        if (stride == 1) CHECK(farthest < 4.0 * timeline.parameters().stitch.width);
        coarse.describe(session, fabric, {stride}, false, scene);  // kept
      }
    }
  }
}

TEST_CASE("readers: only loops that wait are drawn as waiting") {
  app::Session session = session_of(Body::horns);
  Timeline& timeline = session.document->timeline;
  const auto threads = [&] {
    const app::Scene scene = app::Describer().describe(session);
    return std::count_if(scene.lines.begin(), scene.lines.end(),
                         [&](const app::Line& line) { return line.colour == scene.theme->warning; });
  };
  const std::size_t last = step_where(timeline, [](const Step& step) {
    const auto* taken = get_if<TubeTaken>(step);
    return taken != nullptr && taken->tube == 2;
  });
  timeline.seek(last);
  CHECK(threads() > 0);
  timeline.seek(last + 3);
  CHECK(threads() == 0);
}

TEST_CASE("readers: a row in the making is coloured as cast on in every tube that is") {
  app::Session session = session_of(Body::arch);
  Timeline& timeline = session.document->timeline;
  const std::size_t second = step_where(timeline, [](const Step& step) {
    const auto* taken = get_if<TubeTaken>(step);
    return taken != nullptr && taken->tube == 1;
  });
  const auto large = [&](app::Colour colour) {
    const app::Scene scene = app::Describer().describe(session);
    return std::count_if(scene.points.begin(), scene.points.end(), [&](const app::Point& point) {
      return point.colour == colour && point.diameter_px == 7.0F;
    });
  };
  timeline.seek(step_where(
                    timeline, [](const Step& step) { return is<StitchPlaced>(step); }, second) +
                2);
  CHECK(large(app::dark_theme.of(Label::cast)) == 2);
  CHECK(large(app::dark_theme.stitch) == 0);
}

TEST_CASE("readers: a pinned run that is the same has no ghost, bridges and rows on them included") {
  app::Session session = session_of(Body::torus_on_rim);
  apply(session, app::ToLast{});
  const auto lines = [&] {
    const app::Scene scene = app::Describer().describe(session);
    std::size_t ghosts = 0;
    for (const auto& set : scene.line_sets) {
      ghosts += static_cast<std::size_t>(std::count_if(set->begin(), set->end(), [&](const app::Line& line) {
        return line.colour == scene.theme->ghost;
      }));
    }
    return ghosts;
  };
  apply(session, app::PinRun{});
  CHECK(lines() == 0);
  Parameters other = session.document->timeline.parameters();
  give_width(other, 0.16);
  apply(session, app::Tune{other});
  session.document->timeline.extend_to_end();
  CHECK(lines() > 0);
}

TEST_CASE("readers: a bridge's stitch can be picked, and has a name that reads back") {
  app::Session session = session_of(Body::torus_on_rim);
  apply(session, app::ToLast{});
  const Fabric& fabric = session.document->timeline.state().fabric;
  std::size_t picked = 0, bridged = 0;
  for (std::size_t d = 0; d < fabric.deals().size(); ++d) {
    for (std::size_t i = 0; i < fabric.deals()[d]->bridge.size(); ++i, ++bridged) {
      const knit::Element wanted =
          StitchElement{bridge_row(static_cast<std::int32_t>(d) + 1), static_cast<std::int32_t>(i)};
      for (double yaw = 0.0; yaw < 6.3; yaw += 0.4) {
        for (const double pitch : {-1.2, -0.5, 0.0, 0.5, 1.2}) {
          session.view->gaze.camera.yaw = yaw;
          session.view->gaze.camera.pitch = pitch;
          const app::Sight view = session.view->gaze.camera.view(session.view->aspect);
          const glm::dvec4 at = glm::dmat4(view.projection) * glm::dmat4(view.view) *
                                glm::dvec4(fabric.deals()[d]->bridge[i].position, 1.0);
          const auto thing = app::pick_thing(session, {at.x / at.w, at.y / at.w}, {0.002, 0.001});
          if (thing == wanted) {
            ++picked;
            yaw = 7.0;
            break;
          }
        }
      }
      CHECK(app::words_of(wanted).find("bridge") != std::string::npos);
      CHECK(app::thing_named(app::text_of(wanted)) == wanted);
      CHECK(test_support::contains(app::why_words(session.document->timeline, wanted),
                                   "cast on across the gap"));
    }
  }
  CHECK(bridged > 0);
  CHECK(picked == bridged);
}

TEST_CASE("readers: the steps of a deal move something at one place") {
  app::Session session = session_of(Body::torus_on_rim);
  Timeline& timeline = session.document->timeline;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const Step& step = timeline.step(i);
    if (!is<BridgeCastOn>(step) && !is<GapsFound>(step) && !is<NodeFound>(step)) continue;
    timeline.seek(i + 1);
    CHECK(app::place_of_step(session, step).has_value());
    ++seen;
  }
  CHECK(seen > 6);
}

TEST_CASE("readers: the sentences on a fabric in tubes name the tube") {
  const app::Session session = session_of(Body::torus_on_rim);
  const Timeline& timeline = session.document->timeline;
  const RowId row = timeline.furthest().fabric.row_count();
  CHECK(test_support::contains(app::why_words(timeline, StitchElement{row, 0}), "tube D"));
  const VertexId saddle = timeline.furthest().tubes->events[1].vertex;
  CHECK(test_support::contains(app::why_words(timeline, VertexElement{saddle}), "splits"));
  CHECK(test_support::contains(app::why_words(timeline, VertexElement{3}), "ube "));
}

// --- what is written -----------------------------------------------------------------------------------------------

TEST_CASE("readers: glTF has every stitch, edge and face of a fabric in tubes, and no index out of range") {
  for (const Body body : bodies) {
    app::Session session = session_of(body);
    apply(session, app::ToLast{});
    const auto json = nlohmann::json::parse(app::gltf_file(session, app::GltfFormat::text));
    const Fabric& fabric = session.document->timeline.state().fabric;
    std::size_t quads = 0, triangles = 0, edges = 0, columns = 0;
    const auto count = [&](const std::vector<Face>& faces) {
      for (const Face& face : faces) (face.corner_count == 4 ? quads : triangles) += 1;
    };
    for (const auto& row : fabric.rows()) edges += row->stitches.size();
    for (const auto& strip : fabric.strips()) {
      count(strip->faces);
      columns += strip->column_edges.size();
    }
    for (const auto& deal : fabric.deals()) {
      count(deal->faces);
      edges += app::edges_added(*deal).size();
      columns += deal->column_edges.size();
    }
    const auto& primitives = json["meshes"][0]["primitives"];
    const auto accessor = [&](std::size_t primitive, const char* key) {
      const auto& p = primitives.at(primitive);
      const auto at = std::string(key) == "indices" ? p["indices"] : p["attributes"][key];
      return json["accessors"].at(at.get<std::size_t>())["count"].get<std::size_t>();
    };
    CHECK(accessor(0, "POSITION") == 6 * quads + 3 * triangles);
    CHECK(accessor(1, "POSITION") == fabric.stitch_count());
    CHECK(accessor(1, "indices") == 2 * edges);
    CHECK(accessor(2, "indices") == 2 * columns);
  }
}

TEST_CASE("readers: the OBJ has a deal's faces once strips have come to it, and its edges before") {
  app::Session session = session_of(Body::horns);
  Timeline& timeline = session.document->timeline;
  const auto groups = [&] {
    std::size_t count = 0;
    for (const std::string& line : test_support::lines_of(app::mesh_text(session)))
      count += line.rfind("g deal-", 0) == 0 ? 1U : 0U;
    return count;
  };
  timeline.seek(timeline.known());
  CHECK(groups() == timeline.furthest().fabric.deals().size());
  timeline.seek(timeline.position_of({Stage::faces, 3, 999}));
  CHECK(groups() == 0);
  timeline.seek(timeline.position_of({Stage::stitches, 0, 0}));
  CHECK(groups() == timeline.state().fabric.deals().size());
}

TEST_CASE("readers: plots say where each tube begins, and no line runs from one to the next") {
  app::Session session = session_of(Body::torus_on_rim);
  apply(session, app::ToLast{});
  const std::string svg = app::plots_file_text(session, app::PlotsFormat::svg);
  for (const char* name : {">A<", ">B<", ">C<", ">D<"}) CHECK(test_support::contains(svg, name));
  app::Session one = test_support::finished_small_session();
  CHECK_FALSE(test_support::contains(app::plots_file_text(one, app::PlotsFormat::svg), "class=\"tubes\""));
}

// --- lessons' judges -----------------------------------------------------------------------------------------------

namespace {

app::Truth truth(const app::Session& session, const std::string& judge, const std::string& word) {
  app::Question question;
  const auto table = app::judge_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& info) { return info.name == judge; });
  REQUIRE(found != table.end());
  question.judge.judge = static_cast<std::size_t>(found - table.begin());
  question.judge.word = word;
  return app::truth_of(session, question);
}

std::string answer(const app::Session& session, const std::string& judge, const std::string& word) {
  const app::Truth right = truth(session, judge, word);
  INFO(judge << " of " << word << ": " << right.reason);
  REQUIRE(!right.answers.empty());
  CHECK(test_support::is_one_sentence(right.reason));
  return right.answers.front();
}

}  // namespace

TEST_CASE("readers: judges count tubes, yarns, holders, splits, joins, rings and handles") {
  const app::Session rim = session_of(Body::torus_on_rim), flat = session_of(Body::torus_flat);
  CHECK(answer(rim, "tubes", "tubes") == "4");
  CHECK(answer(rim, "tubes", "yarns") == "2");
  CHECK(answer(rim, "tubes", "holders") == "1");
  CHECK(answer(rim, "tubes", "splits") == "1");
  CHECK(answer(rim, "tubes", "joins") == "1");
  CHECK(answer(rim, "tubes", "rings") == "0");
  CHECK(answer(rim, "tubes", "handles") == "1");
  CHECK(answer(flat, "tubes", "tubes") == "2");
  CHECK(answer(flat, "tubes", "rings") == "2");
  CHECK(answer(flat, "tubes", "handles") == "1");
  CHECK(answer(flat, "begins-on", "A") == "nothing");
  CHECK(answer(flat, "begins-on", "B") == "edge");
  CHECK(answer(rim, "begins-on", "D") == "loop");
  CHECK(truth(rim, "begins-on", "Q").answers.empty());
}

TEST_CASE("readers: judges know what a tube is worked on, who waits and where a yarn is broken") {
  app::Session arch = session_of(Body::arch);
  const Fabric& fabric = arch.document->timeline.furthest().fabric;
  const Deal& deal = *fabric.deals().front();
  const auto loops = static_cast<std::size_t>(deal.arcs[0] + deal.arcs[1]) + 2 * deal.bridge.size();
  CHECK(answer(arch, "worked-on", "C") == std::to_string(loops));
  CHECK(truth(arch, "worked-on", "A").answers.empty());
  CHECK_FALSE(truth(arch, "join-vertex", "").answers.empty());
  const app::Truth broken = truth(arch, "yarn-broken", "");
  const std::set<std::string> rows(broken.answers.begin(), broken.answers.end());
  RowId leg = 1;
  while (fabric.row(leg + 1).tube == 0) ++leg;
  CHECK(rows ==
        std::set<std::string>{"row:" + std::to_string(leg), "row:" + std::to_string(fabric.row_count())});
  Timeline& timeline = arch.document->timeline;
  timeline.seek(timeline.position_of({Stage::rows, leg + 1, 12}));
  CHECK(answer(arch, "waits", "") == "A");
  timeline.seek(timeline.position_of({Stage::rows, leg, 999}) - 1);
  CHECK(answer(arch, "waits", "") == "none");
  timeline.seek(timeline.known());
  CHECK(truth(arch, "waits", "").answers.empty());
}
