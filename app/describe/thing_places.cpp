#include "app/describe/thing_places.h"

#include <algorithm>

#include "app/describe/describe_step.h"

namespace app {

namespace {

std::vector<glm::dvec3> positions_of(const std::vector<knit::Stitch>& stitches) {
  std::vector<glm::dvec3> places;
  places.reserve(stitches.size());
  for (const knit::Stitch& stitch : stitches) places.push_back(stitch.position);
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
    const knit::Strip& strip = *knit::planned_strip(state, e.row);
    const auto& [lower, upper] = strip.column_edges[static_cast<std::size_t>(e.edge)];
    return {place_on(path, lower), place_on(path, upper)};
  }
  Places operator()(const knit::FaceElement& f) const {
    const knit::KnittingPath path(state.fabric);
    const knit::Face& face = knit::planned_strip(state, f.row)->faces[static_cast<std::size_t>(f.face)];
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
  return strips;
}

std::vector<glm::dvec3> outline_of(const knit::Input& input, const knit::State& state,
                                   const knit::Element& thing) {
  const auto* vertex = std::get_if<knit::VertexElement>(&thing);
  if (vertex != nullptr && vertex->vertex >= input.mesh.positions.size()) return {};
  if (!knit::exists(state, thing)) return {};
  return std::visit(Outline{input, state}, thing);
}

}  // namespace app
