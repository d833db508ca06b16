#include "app/describe/describe_quantity.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/explain/code_variables.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/rows/ring.h"

namespace app {

namespace {

constexpr std::uint8_t soft = 170;  // what goes with a quantity and is not it

glm::dvec3 unit(const glm::dvec3& way) {
  const double length = glm::length(way);
  return length > 0.0 ? way / length : glm::dvec3(0.0);
}

// Across the ring at a place of it: away from its centre and ahead, so that it shows from all around.
glm::dvec3 across(const glm::dvec3& centre, const glm::dvec3& ahead, const glm::dvec3& place) {
  return unit(unit(place - centre) + ahead);
}

// How far along the ring from `from` a place stands `distance` away through the air; nothing within half of it.
std::optional<double> ahead_by(const knit::Ring& ring, double from, double distance) {
  constexpr int samples = 256;
  const glm::dvec3 start = knit::point_at(ring, from);
  for (int i = 1; i <= samples; ++i) {
    const double ahead = 0.5 * ring.length * i / samples;
    if (glm::distance(start, knit::point_at(ring, from + ahead)) >= distance) return from + ahead;
  }
  return std::nullopt;
}

// How high along the axis the vertex stands: what Algorithm 1 makes its time of.
void describe_time(const Session& session, const knit::VertexTimed& timed, Scene& scene) {
  if (!session.view->shows(Layer::times)) return;
  const knit::State& state = session.document->timeline.state();
  const glm::dvec3 at = session.document->timeline.input().mesh.positions[timed.vertex];
  const Colour colour = scene.theme->anchor;
  scene.captions.push_back({glm::vec3(at), "t = " + knit::short_number(timed.time), colour});
  const knit::Ends* ends = ends_shown(state);
  const auto* work = std::get_if<knit::TimingWork>(&state.work);
  if (ends == nullptr || work == nullptr || work->kind != knit::TimingKind::linear) return;
  const glm::dvec3 foot = ends->origin + timed.time * ends->direction;
  scene.lines.push_back({glm::vec3(ends->origin), glm::vec3(foot), colour, 3.0F});
  scene.lines.push_back({glm::vec3(foot), glm::vec3(at), with_alpha(colour, soft), 1.5F});
}

void describe_cast_on(const Session& session, const knit::Step& step, const knit::StitchCastOn& cast_on,
                      Scene& scene) {
  const RowShown row = row_shown(session.document->timeline.state(), step.place.row);
  if (!session.view->shows(Layer::cycle) || row.ring == nullptr) return;
  const Colour colour = scene.theme->anchor;
  add_arc(*row.ring, RingArc{0.0, cast_on.arc}, colour, 3.0F, scene);
  const glm::vec3 at(knit::point_at(*row.ring, cast_on.arc));
  scene.captions.push_back({at, "s = " + knit::short_number(cast_on.arc) + " along the ring", colour});
}

void describe_gap(const Session& session, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  const auto gap = gap_arc(state);
  if (!gap) return;
  const knit::Ring& ring = *std::get<knit::RowWork>(state.work).ring;
  const Colour colour = with_alpha(scene.theme->anchor, soft);
  if (session.view->shows(Layer::row_edges)) add_arc(ring, *gap, colour, 2.0F, scene);
  if (session.view->shows(Layer::band)) {
    const knit::Parameters& parameters = parameters_of_last_step(session);
    const knit::Band band = knit::band_of(parameters.rows, parameters.stitch);
    add_band_ticks(ring, *gap, band, colour, scene);
  }
}

// The vertices that the row's walk picked, read from its steps: what the stitches stood at before they moved.
std::vector<knit::VertexId> picked_vertices(const knit::Timeline& timeline) {
  std::vector<knit::VertexId> picked;  // the last first
  const std::size_t last = timeline.position() - 1;
  const knit::Place place = timeline.step(last).place;
  knit::VertexId anchor = knit::no_vertex;
  bool dropped = false;
  for (std::size_t i = last; i-- > 0 && timeline.step(i).place.row == place.row;) {
    const knit::Event& what = timeline.step(i).what;
    if (const auto* closed = knit::get_if<knit::RowClosed>(what)) dropped = closed->dropped_last;
    const auto* measured = knit::get_if<knit::CandidateMeasured>(what);
    const auto* missed = knit::get_if<knit::BandMissed>(what);
    const bool took =
        missed != nullptr || (measured != nullptr && measured->verdict == knit::Verdict::accepted);
    if (took) picked.push_back(missed != nullptr ? missed->taken : measured->candidate);
    if (measured != nullptr || missed != nullptr)
      anchor = missed != nullptr ? missed->anchor : measured->anchor;
  }
  if (anchor != knit::no_vertex) picked.push_back(anchor);
  if (dropped && !picked.empty()) picked.erase(picked.begin());
  std::reverse(picked.begin(), picked.end());
  return picked;
}

void describe_shares(const Session& session, const knit::Step& step, const knit::GapShared& shared,
                     Scene& scene) {
  const knit::Row* row = row_shown(session.document->timeline.state(), step.place.row).finished;
  if (!shared.shared || row == nullptr || !session.view->shows(Layer::stitches)) return;
  const std::vector<knit::VertexId> picked = picked_vertices(session.document->timeline);
  if (picked.size() != row->stitches.size()) return;
  for (std::size_t i = 0; i < picked.size(); ++i) {
    const glm::vec3 from(session.document->timeline.input().mesh.positions[picked[i]]);
    const glm::vec3 to(row->stitches[i].position);
    scene.points.push_back({from, scene.theme->ring, 4.5F});
    scene.lines.push_back({from, to, scene.theme->anchor, 3.0F});
  }
}

}  // namespace

void add_arc(const knit::Ring& ring, const RingArc& arc, Colour colour, float width_px, Scene& scene) {
  constexpr double pi = 3.14159265358979323846;
  const double way = arc.to - arc.from;
  if (!(way > 0.0) || !(ring.length > 0.0)) return;
  const auto pieces = static_cast<int>(std::clamp(std::ceil(256.0 * way / ring.length), 8.0, 256.0));
  const glm::dvec3 centre = centre_of(ring);
  const auto place = [&](int piece) {
    const double share = static_cast<double>(piece) / pieces;
    const glm::dvec3 at = knit::point_at(ring, arc.from + share * way);
    return glm::vec3(at + across(centre, arc.ahead, at) * (arc.lift * std::sin(pi * share)));
  };
  for (int i = 0; i < pieces; ++i) scene.lines.push_back({place(i), place(i + 1), colour, width_px});
}

std::optional<RingArc> gap_arc(const knit::State& state) {
  const auto* making = std::get_if<knit::RowWork>(&state.work);
  if (making == nullptr) return std::nullopt;
  const knit::RowWork& work = *making;
  const bool closed = work.phase == knit::RowPhase::resample || work.phase == knit::RowPhase::share;
  if (!closed || !work.ring || work.closed.orders.empty()) return std::nullopt;
  const auto n = static_cast<double>(work.closed.stitches.size());
  const auto last = static_cast<std::size_t>(work.closed.orders.back());
  const double from = work.closed.resampled ? work.ring->length * (n - 1.0) / n : work.ring->arc[last];
  const double way = work.ring->length - from;
  const knit::Ends* ends = ends_shown(state);
  return RingArc{from, work.ring->length, 0.35 * way,
                 ends != nullptr ? unit(ends->direction) : glm::dvec3(0.0)};
}

void add_band_ticks(const knit::Ring& ring, const RingArc& gap, const knit::Band& band, Colour colour,
                    Scene& scene) {
  const glm::dvec3 centre = centre_of(ring);
  for (const double edge : {band.low, band.high}) {
    const auto at = edge > 0.0 ? ahead_by(ring, gap.from, edge) : std::nullopt;
    if (!at) continue;
    const glm::dvec3 place = knit::point_at(ring, *at);
    const glm::dvec3 half = across(centre, gap.ahead, place) * (0.1 * (band.low + band.high));
    scene.lines.push_back({glm::vec3(place - half), glm::vec3(place + half), colour, 2.0F});
  }
}

void describe_quantity(const Session& session, Scene& scene) {
  const knit::Step* step = last_step(session);
  if (step == nullptr) return;
  if (const auto* timed = knit::get_if<knit::VertexTimed>(*step)) {
    describe_time(session, *timed, scene);
  } else if (const auto* cast_on = knit::get_if<knit::StitchCastOn>(*step)) {
    describe_cast_on(session, *step, *cast_on, scene);
  } else if (const auto* shared = knit::get_if<knit::GapShared>(*step)) {
    describe_shares(session, *step, *shared, scene);
  } else {
    describe_gap(session, scene);
  }
}

}  // namespace app
