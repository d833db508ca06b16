#include "app/describe/thing_places.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "app/describe/describe_step.h"

namespace app {

namespace {

std::vector<glm::dvec3> positions_of(const std::vector<knit::Stitch>& stitches) {
  std::vector<glm::dvec3> places;
  places.reserve(stitches.size());
  for (const knit::Stitch& stitch : stitches) places.push_back(stitch.position);
  return places;
}

// As far as it is cast on.
std::vector<glm::dvec3> bridge_places(const knit::State& state, knit::RowId row) {
  const knit::Deal* deal = knit::deal_numbered(state, -row);
  if (deal == nullptr) return {};
  std::vector<glm::dvec3> places = positions_of(deal->bridge);
  const bool done = static_cast<std::size_t>(-row) <= state.fabric.deals().size();
  if (!done) places.resize(static_cast<std::size_t>(std::get<knit::ContourWork>(state.work).bridged));
  return places;
}

std::vector<glm::dvec3> kept_places(const knit::RowWork& work) {
  std::vector<glm::dvec3> places;
  for (const std::int32_t order : work.walk.kept)
    places.push_back(work.ring->points[static_cast<std::size_t>(order)]);
  return places;
}

// Of the strip below a row; its rows are finished.
struct Outline {
  const knit::Input& input;
  const knit::State& state;
  using Places = std::vector<glm::dvec3>;

  Places operator()(const knit::StitchElement& s) const {
    const Places row = stitch_places(state, s.row);
    return {row[static_cast<std::size_t>(s.stitch)]};
  }
  Places operator()(const knit::RowEdgeElement& e) const {
    const Places row = stitch_places(state, e.row);
    const auto from = static_cast<std::size_t>(e.stitch);
    return {row[from], row[from + 1 < row.size() ? from + 1 : 0]};
  }
  Places operator()(const knit::ColumnEdgeElement& e) const {
    const knit::KnittingPath path(state.fabric);
    const auto& edges = e.row < 0 ? knit::deal_numbered(state, -e.row)->column_edges
                                  : knit::planned_strip(state, e.row)->column_edges;
    const auto& [lower, upper] = edges[static_cast<std::size_t>(e.edge)];
    return {place_on(path, lower), place_on(path, upper)};
  }
  Places operator()(const knit::FaceElement& f) const {
    const knit::KnittingPath path(state.fabric);
    const auto& faces =
        f.row < 0 ? knit::deal_numbered(state, -f.row)->faces : knit::planned_strip(state, f.row)->faces;
    const knit::Face& face = faces[static_cast<std::size_t>(f.face)];
    Places corners;
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
      corners.emplace_back(place_on(path, face.corners[i]));
    return corners;
  }
  Places operator()(const knit::LabelElement& l) const {
    const knit::Join& join = *knit::planned_join(state, l.row);
    return {state.fabric.position(state.fabric.larger(join).at(l.cell))};
  }
  Places operator()(const knit::VertexElement& v) const { return {input.mesh.positions[v.vertex]}; }
};

}  // namespace

std::vector<glm::dvec3> stitch_places(const knit::State& state, std::int32_t row) {
  if (row < 0) return bridge_places(state, row);
  if (row < 1 || row > state.fabric.next_row()) return {};
  if (const knit::Row* finished = state.fabric.find_row(row)) return positions_of(finished->stitches);
  if (const auto* cast_on = std::get_if<knit::CastOnWork>(&state.work))
    return positions_of(cast_on->stitches);
  if (const auto* contour = std::get_if<knit::ContourWork>(&state.work))
    return positions_of(contour->stitches);
  const auto* walk = std::get_if<knit::RowWork>(&state.work);
  if (walk == nullptr) return {};
  return walk->closed.stitches.empty() ? kept_places(*walk) : positions_of(walk->closed.stitches);
}

std::vector<MadeStrip> made_strips(const knit::State& state) {
  std::vector<MadeStrip> strips;
  for (const auto& strip : state.fabric.strips())
    strips.push_back({strip->to, strip->faces, strip->column_edges});
  const auto* work = std::get_if<knit::FacesWork>(&state.work);
  if (work != nullptr && work->plan) {
    const auto made = static_cast<std::size_t>(work->made);
    strips.push_back({work->plan->to, std::span(work->plan->faces).first(made),
                      std::span(work->plan->column_edges).first(made)});
  }
  const auto& deals = state.fabric.deals();
  for (std::size_t i = 0; i < deals.size(); ++i) {
    if (is_sewn(state.fabric, *deals[i]))
      strips.push_back(
          {knit::bridge_row(static_cast<std::int32_t>(i) + 1), deals[i]->faces, deals[i]->column_edges});
  }
  return strips;
}

bool is_sewn(const knit::Fabric& fabric, const knit::Deal& deal) {
  if (fabric.strips().empty()) return false;
  const knit::RowId above = fabric.next_worked(deal.after);
  return above > 0 ? fabric.strip_into(above) != nullptr : fabric.strips().size() == fabric.joins().size();
}

knit::Strip strip_of(const knit::Deal& deal) { return {0, deal.faces, deal.column_edges}; }

std::vector<std::array<knit::StitchRef, 2>> edges_added(const knit::Deal& deal) {
  using Edge = std::array<knit::StitchRef, 2>;
  if (!deal.column_edges.empty()) return {};
  const auto edges_of = [](const std::vector<knit::LiveStitches>& loops) {
    std::set<Edge> edges;
    for (const knit::LiveStitches& loop : loops) {
      const std::int32_t n = loop.size();
      for (std::int32_t i = 0; i < n; ++i) {
        const knit::StitchRef from = loop.at(i), to = loop.at(i + 1 < n ? i + 1 : 0);
        edges.insert({std::min(from, to), std::max(from, to)});
      }
    }
    return edges;
  };
  const std::set<Edge> before = edges_of(deal.taken), after = edges_of(deal.given);
  std::vector<Edge> added;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
  return added;
}

std::vector<glm::dvec3> outline_of(const knit::Input& input, const knit::State& state,
                                   const knit::Element& thing) {
  const auto* vertex = std::get_if<knit::VertexElement>(&thing);
  if (vertex != nullptr && vertex->vertex >= input.mesh.positions.size()) return {};
  if (!knit::exists(state, thing)) return {};
  return std::visit(Outline{input, state}, thing);
}

}  // namespace app
