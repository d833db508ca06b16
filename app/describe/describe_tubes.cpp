#include "app/describe/describe_tubes.h"

#include <algorithm>
#include <array>
#include <span>

#include "app/describe/describe_contours.h"
#include "app/describe/describe_step.h"
#include "app/describe/describe_stretch.h"
#include "app/describe/state_shown.h"
#include "app/describe/thing_places.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/fabric/edges.h"
#include "knit/insight/waiting.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr std::size_t most_curves_shown = 150;

Colour colour_of_node(const Theme& theme, knit::NodeKind kind) {
  switch (kind) {
    case knit::NodeKind::minimum:
      return theme.time_low;
    case knit::NodeKind::split:
    case knit::NodeKind::join:
      return theme.problem;
    case knit::NodeKind::maximum:
      return theme.time_high;
  }
  return theme.ring;
}

std::string_view word_of_node(knit::NodeKind kind) {
  switch (kind) {
    case knit::NodeKind::minimum:
      return "a tube begins";
    case knit::NodeKind::split:
      return "a split";
    case knit::NodeKind::join:
      return "a join";
    case knit::NodeKind::maximum:
      return "a tube ends";
  }
  return "";
}

// The sweep so far: every critical vertex that a step has told of, the last one named.
void add_nodes(const knit::TubesWork& work, const knit::Step& step, Scene& scene) {
  const bool sweeping = work.phase == knit::TubesPhase::nodes || knit::is<knit::NodeFound>(step);
  if (!work.graph || !sweeping) return;
  const knit::TubeGraph& graph = *work.graph;
  const auto shown = std::min(static_cast<std::size_t>(work.shown), graph.nodes.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const knit::GraphNode& node = graph.nodes[i];
    const glm::vec3 at(graph.surface.positions[node.vertex]);
    const Colour colour = colour_of_node(*scene.theme, node.kind());
    scene.points.push_back({at, colour, i + 1 == shown ? 12.0F : 8.0F});
    if (i + 1 == shown) scene.captions.push_back({at, std::string(word_of_node(node.kind())), colour});
  }
}

void add_curves(const knit::TubePlan& plan, Scene& scene) {
  std::size_t rows = 0;
  for (const knit::Tube& tube : plan.tubes) rows += tube.curves.size();
  const std::size_t stride = 1 + rows / most_curves_shown;
  for (std::size_t id = 0; id < plan.tubes.size(); ++id) {
    const knit::Tube& tube = plan.tubes[id];
    for (std::size_t i = 0; i < tube.curves.size(); i += stride)
      add_loop(*tube.curves[i], scene.theme->ring, 1.2F, scene.lines);
    if (plan.tubes.size() == 1 || tube.curves.empty()) continue;
    const knit::Ring& middle = *tube.curves[tube.curves.size() / 2];
    scene.captions.push_back({glm::vec3(middle.points.front()),
                              knit::tube_name(static_cast<std::int32_t>(id)), scene.theme->ring});
  }
}

std::vector<glm::vec3> places_of(std::span<const knit::Stitch> stitches) {
  std::vector<glm::vec3> places;
  places.reserve(stitches.size());
  for (const knit::Stitch& stitch : stitches) places.emplace_back(stitch.position);
  return places;
}
std::vector<glm::vec3> places_of(const knit::Fabric& fabric, const knit::LiveStitches& live) {
  return places_of(fabric.stitches_of(live));
}

// A thread through them: dashes from stitch to stitch.
void add_thread(const std::vector<glm::vec3>& places, Colour colour, Scene& scene) {
  for (const auto& [i, next] : knit::Edges(places.size(), true)) {
    const glm::vec3 way = places[next] - places[i];
    scene.lines.push_back({places[i] + 0.2F * way, places[i] + 0.8F * way, colour, 3.0F});
  }
}

void add_path(const std::vector<glm::vec3>& places, Colour colour, Scene& scene) {
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    scene.lines.push_back({places[i], places[i + 1], colour, 4.0F});
  for (const glm::vec3& place : places) scene.points.push_back({place, colour, 8.0F});
}

// The two sides in two colours, the saddle, and the bridge as far as it is cast on.
void add_deal(const knit::Fabric& fabric, const knit::Deal& deal, std::int32_t bridged, Scene& scene) {
  const Theme& theme = *scene.theme;
  const std::array<Colour, 2> colours{theme.one_side, theme.other_side};
  if (deal.kind == knit::DealKind::split) {
    const knit::LiveStitches& loop = deal.taken.front();
    // What a child gets of the loop: its stitches but for the bridge's.
    for (std::size_t child = 0; child < deal.given.size(); ++child) {
      std::vector<glm::vec3> places;
      for (const knit::StitchSpan& span : deal.given[child].spans) {
        if (span.row < 0) continue;
        for (std::int32_t i = 0; i < span.count; ++i)
          places.emplace_back(fabric.position({span.row, span.first + i}));
      }
      for (const glm::vec3& place : places) scene.points.push_back({place, colours[child], 8.0F});
    }
    add_thread(places_of(fabric, loop), theme.ring, scene);
  } else {
    for (std::size_t side = 0; side < deal.taken.size() && side < 2; ++side) {
      const std::vector<glm::vec3> places = places_of(fabric, deal.taken[side]);
      for (const glm::vec3& place : places) scene.points.push_back({place, colours[side], 8.0F});
      add_thread(places, colours[side], scene);
    }
  }
  if (deal.kind == knit::DealKind::ring_cast_on || deal.kind == knit::DealKind::ring_bind_off) return;
  const glm::vec3 saddle(deal.saddle);
  // No larger than a stitch of the bridge, which runs over it.
  scene.points.push_back({saddle, theme.problem, 8.0F});
  std::string words = deal.kind == knit::DealKind::split ? "split" : "join";
  if (bridged > 0) words += ", bridge of " + std::to_string(bridged);
  scene.captions.push_back({saddle, words, theme.problem});
  add_path(places_of(std::span(deal.bridge).first(static_cast<std::size_t>(bridged))), theme.anchor, scene);
}

void add_bridge(const Session& session, const knit::Fabric& fabric, const knit::Deal& deal, Scene& scene) {
  const auto stretch = stretch_shown(session);
  if (session.view->shows(Layer::row_edges)) {
    std::vector<Line> edges;
    for (const auto& [from, to] : edges_added(deal))
      edges.push_back(
          {glm::vec3(fabric.position(from)), glm::vec3(fabric.position(to)), scene.theme->row_edge, 1.8F});
    if (stretch) colour_by_stretch(*scene.theme, stretch->width, stretch->full, edges);
    scene.lines.insert(scene.lines.end(), edges.begin(), edges.end());
  }
  if (!session.view->shows(Layer::stitches)) return;
  for (const knit::Stitch& stitch : deal.bridge)
    scene.points.push_back({glm::vec3(stitch.position), scene.theme->of(knit::Label::cast), 3.2F});
}

void add_seam(const Session& session, const knit::Deal& deal, const knit::KnittingPath& path, Scene& scene) {
  const auto stretch = stretch_shown(session);
  const knit::Strip strip = strip_of(deal);
  if (session.view->shows(Layer::faces)) {
    FaceShape faces = faces_of(*scene.theme, strip, strip.faces.size(), path);
    if (stretch) make_plain(*scene.theme, faces);
    scene.faces.push_back(std::make_shared<const FaceShape>(std::move(faces)));
  }
  if (!session.view->shows(Layer::column_edges)) return;
  std::vector<Line> columns = columns_of(*scene.theme, strip, strip.column_edges.size(), path);
  if (stretch) colour_by_stretch(*scene.theme, stretch->height, stretch->full, columns);
  scene.lines.insert(scene.lines.end(), columns.begin(), columns.end());
}

// Bridges that are there with the edges over them, and what a deal sews together once strips come to it.
void add_finished_deals(const Session& session, Scene& scene) {
  const StateShown state(session);
  const knit::KnittingPath path(state->fabric);
  for (const auto& deal : state->fabric.deals()) {
    add_bridge(session, state->fabric, *deal, scene);
    if (is_sewn(state->fabric, *deal)) add_seam(session, *deal, path, scene);
  }
}

}  // namespace

void describe_tubes(const Session& session, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  const knit::Step* step = last_step(session);
  if (const auto* work = std::get_if<knit::TubesWork>(&state.work); work != nullptr && step != nullptr)
    add_nodes(*work, *step, scene);
  if (!state.tubes) return;
  if (step != nullptr && knit::is<knit::TubesPlanned>(*step) && session.view->shows(Layer::cycle))
    add_curves(*state.tubes, scene);
  add_finished_deals(session, scene);
  for (const knit::LiveLoop& loop : knit::waiting_loops(state))
    add_thread(places_of(state.fabric, loop.stitches), scene.theme->warning, scene);
  const auto* work = std::get_if<knit::ContourWork>(&state.work);
  if (work == nullptr) return;
  if (work->deal) add_deal(state.fabric, *work->deal, work->bridged, scene);
}

}  // namespace app
