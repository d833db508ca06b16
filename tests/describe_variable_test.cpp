// A variable pointed at is lit where its quantity lives; and what a step draws of its quantity by itself.
#include "app/describe/describe_variable.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "app/describe/describe.h"
#include "app/explain/code_variables.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/insight/narrate.h"
#include "knit/model/words.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using knit::Stage;

namespace {

Scene scene_of(const Session& session) { return Describer().describe(session); }

Scene pointed(Session& session, const std::string& name) {
  apply(session, PointAt{name});
  return scene_of(session);
}

glm::vec3 place_of(const Session& session, knit::VertexId vertex) {
  return glm::vec3(session.document->timeline.input().mesh.positions[vertex]);
}

template <class Kind, class Test>
Kind seek_to(Session& session, Test test) {
  for (std::size_t i = 0; i < session.document->timeline.known(); ++i) {
    const auto* what = knit::get_if<Kind>(session.document->timeline.step(i));
    if (what == nullptr || !test(*what)) continue;
    apply(session, SeekTo{i + 1});
    return *what;
  }
  FAIL("the run has no such step");
  return {};
}

std::size_t lit(const Scene& scene) {
  const auto is = [](const auto& thing) { return thing.colour == dark_theme.selected; };
  return static_cast<std::size_t>(std::count_if(scene.points.begin(), scene.points.end(), is) +
                                  std::count_if(scene.lines.begin(), scene.lines.end(), is));
}

bool says(const Scene& scene, const std::string& words) {
  return std::any_of(scene.captions.begin(), scene.captions.end(),
                     [&](const Caption& caption) { return caption.text == words; });
}

bool has_line(const Scene& scene, const glm::vec3& from, const glm::vec3& to, Colour colour) {
  return std::any_of(scene.lines.begin(), scene.lines.end(), [&](const Line& line) {
    return line.from == from && line.to == to && line.colour == colour;
  });
}

knit::CandidateMeasured seek_to_accepted(Session& session) {
  return seek_to<knit::CandidateMeasured>(
      session, [](const auto& m) { return m.verdict == knit::Verdict::accepted && m.anchor_order > 0; });
}

}  // namespace

TEST_CASE("d is the measured line with its number, the anchor and the candidate their vertices") {
  Session session = test_support::finished_small_session();
  const auto step = seek_to_accepted(session);
  CHECK(lit(scene_of(session)) == 0);
  const glm::vec3 anchor = place_of(session, step.anchor);
  const glm::vec3 candidate = place_of(session, step.candidate);
  const Scene distance = pointed(session, "d");
  CHECK(has_line(distance, anchor, candidate, dark_theme.selected));
  CHECK(says(distance, "d = " + knit::short_number(step.distance)));
  const auto lit_point = [&](const std::string& name, const glm::vec3& at) {
    const Scene scene = pointed(session, name);
    return std::any_of(scene.points.begin(), scene.points.end(), [&](const Point& point) {
      return point.position == at && point.colour == dark_theme.selected;
    });
  };
  CHECK(lit_point("anchor", anchor));
  CHECK(lit_point("candidate", candidate));
  CHECK_FALSE(lit_point("candidate", anchor));
  CHECK(lit(pointed(session, "")) == 0);
}

TEST_CASE("w and epsilon are the band round the anchor of the step, though the next is taken") {
  Session session = test_support::finished_small_session();
  const auto step = seek_to_accepted(session);
  for (const char* name : {"width", "epsilon", "verdict"}) {
    const Scene scene = pointed(session, name);
    REQUIRE(scene.band);
    CHECK(scene.band->centre == place_of(session, step.anchor));
    CHECK(scene.band->inner == Approx(0.15));
    CHECK(scene.band->outer == Approx(0.45));
    CHECK(says(scene, "[0.15, 0.45]"));
  }
  CHECK(scene_of(session).band->centre == place_of(session, step.anchor));
}

TEST_CASE("the row below, the ring and the gap are lit") {
  Session session = test_support::finished_small_session();
  seek_to_accepted(session);
  const auto& rows = session.document->timeline.state().fabric.rows();
  CHECK(lit(pointed(session, "below")) == 2 * rows.back()->stitches.size());
  const auto& ring = *std::get<knit::RowWork>(session.document->timeline.state().work).ring;
  CHECK(lit(pointed(session, "cycle")) == ring.points.size());
  CHECK(says(pointed(session, "length"), "L = " + knit::short_number(ring.length)));
  CHECK(lit(pointed(session, "gap")) == 0);  // not before the row closes
  const auto closed = seek_to<knit::RowClosed>(session, [](const auto&) { return true; });
  CHECK(says(pointed(session, "gap"), "g = " + knit::short_number(closed.gap)));
  CHECK(lit(pointed(session, "gap")) > 8);
}

TEST_CASE("every variable may be pointed at anywhere, and one that has a place shows it") {
  std::vector<Session> runs{test_support::finished_small_session()};
  for (const auto change : {0, 1, 2}) {
    knit::Parameters parameters = test_support::small_parameters();
    if (change == 0) parameters.rows.source = knit::RowSource::contours;
    if (change == 1) parameters.stitches.placement = knit::PlacementPolicy::nearest;
    if (change == 2) parameters.timing.kind = knit::TimingKind::geodesic;
    Session session = test_support::small_session();
    apply(session, Tune{parameters});
    apply(session, ToLast{});
    runs.push_back(std::move(session));
  }
  std::set<std::string> shown;
  for (Session& session : runs) {
    Describer describer;
    std::set<std::string_view> seen;
    for (std::size_t position = 1; position <= session.document->timeline.known(); ++position) {
      const bool news = seen.insert(knit::kind_name(session.document->timeline.step(position - 1))).second;
      if (!news && position % 11 != 0 && position != session.document->timeline.known()) continue;
      apply(session, SeekTo{position});
      apply(session, PointAt{""});
      const bool band = describer.describe(session).band.has_value();
      for (const Variable& variable : variables_of(session)) {
        apply(session, PointAt{std::string(variable.of->key)});
        const Scene scene = describer.describe(session);
        if (lit(scene) > 0 || (scene.band && !band)) shown.insert(std::string(variable.of->key));
      }
    }
  }
  for (const char* name :
       {"start",  "end",     "direction", "mag",      "vertex", "diff",  "time",    "cycle",
        "length", "arc",     "anchor",    "d",        "width",  "below", "n",       "gap",
        "course", "rows",    "above",     "mains",    "cell",   "links", "longest", "label",
        "sum",    "corners", "produced",  "consumed", "maxima", "far"}) {
    INFO(name);
    CHECK(shown.count(name) == 1);
  }
}

TEST_CASE("nothing is lit for a word that is no variable, nor while another side is shown") {
  Session session = test_support::finished_small_session();
  seek_to_accepted(session);
  CHECK(lit(pointed(session, "nonsense")) == 0);
  apply(session, ShowSide{SidePanel::report});
  CHECK(lit(pointed(session, "d")) == 0);
}

TEST_CASE("a vertex that is timed shows its time and its height along the axis") {
  Session session = test_support::finished_small_session();
  const auto timed = seek_to<knit::VertexTimed>(session, [](const auto& t) { return t.time > 0.4; });
  const Scene scene = scene_of(session);
  CHECK(says(scene, "t = " + knit::short_number(timed.time)));
  const glm::vec3 at = place_of(session, timed.vertex);
  const bool reaches =
      std::any_of(scene.lines.begin(), scene.lines.end(), [&](const Line& line) { return line.to == at; });
  CHECK(reaches);
  apply(session, SetLayer{Layer::times, false});
  CHECK_FALSE(says(scene_of(session), "t = " + knit::short_number(timed.time)));
}

TEST_CASE("a cast-on stitch shows the arc to it, a row that closes the arc of its gap and the band's edges") {
  Session session = test_support::finished_small_session();
  const auto cast_on = seek_to<knit::StitchCastOn>(session, [](const auto& s) { return s.stitch == 4; });
  CHECK(says(scene_of(session), "s = " + knit::short_number(cast_on.arc) + " along the ring"));
  double length = 0.0;
  for (const Line& line : scene_of(session).lines) {
    if (line.colour == dark_theme.anchor) length += static_cast<double>(glm::distance(line.from, line.to));
  }
  CHECK(length == Approx(cast_on.arc).epsilon(0.02));

  seek_to<knit::RowClosed>(session, [](const auto& closed) { return closed.stitches > 8; });
  const auto& closed = std::get<knit::RowWork>(session.document->timeline.state().work).closed;
  const auto soft = [](const Scene& scene) {
    std::vector<Line> lines;
    for (const Line& line : scene.lines) {
      if (line.colour == with_alpha(dark_theme.anchor, 170)) lines.push_back(line);
    }
    return lines;
  };
  apply(session, SetLayer{Layer::band, false});
  const std::vector<Line> arc = soft(scene_of(session));
  REQUIRE(arc.size() >= 8);
  CHECK(glm::distance(arc.front().from, glm::vec3(closed.stitches.back().position)) < 1e-5F);
  CHECK(glm::distance(arc.back().to, glm::vec3(closed.stitches.front().position)) < 1e-5F);
  apply(session, SetLayer{Layer::band, true});
  CHECK(soft(scene_of(session)).size() == arc.size() + 2);
  apply(session, SetLayer{Layer::row_edges, false});
  CHECK(soft(scene_of(session)).size() == 2);
}

TEST_CASE("a gap that is shared shows by how much each stitch moved") {
  Session session = test_support::finished_small_session();
  const auto shared = seek_to<knit::GapShared>(
      session, [](const auto& s) { return s.shared && !s.resampled && s.stitches > 8; });
  const auto row = session.document->timeline.state().fabric.rows().back();
  const Scene scene = scene_of(session);
  std::size_t moves = 0;
  for (const knit::Stitch& stitch : row->stitches) {
    moves +=
        static_cast<std::size_t>(std::count_if(scene.lines.begin(), scene.lines.end(), [&](const Line& line) {
          return line.to == glm::vec3(stitch.position) && line.colour == dark_theme.anchor;
        }));
  }
  CHECK(moves == static_cast<std::size_t>(shared.stitches));
}
