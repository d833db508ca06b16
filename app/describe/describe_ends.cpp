#include "app/describe/describe_ends.h"

#include <cstddef>

namespace app {

namespace {

// The field by the mesh's vertices; of those at one place at the lowest only.
std::vector<double> field_of(const knit::Input& input, const knit::MorseSurface& surface) {
  std::vector<double> field(input.mesh.positions.size(), 0.0);
  for (std::size_t i = 0; i < surface.origin.size(); ++i) field[surface.origin[i]] = surface.values[i];
  return field;
}

template <class Beyond>
void walk_beyond(const knit::Input& input, knit::VertexId from, const Beyond& beyond,
                 std::vector<float>& ends) {
  std::vector<knit::VertexId> open{input.twin[from]};
  while (!open.empty()) {
    const knit::VertexId vertex = open.back();
    open.pop_back();
    if (ends[vertex] == beyond_an_end || !beyond(vertex)) continue;
    ends[vertex] = beyond_an_end;
    const auto neighbours = input.neighbours_of(vertex);
    open.insert(open.end(), neighbours.begin(), neighbours.end());
  }
}

}  // namespace

std::vector<float> ends_of(const knit::Input& input, const knit::TubeGraph& graph,
                           const knit::TubePlan& plan) {
  const std::vector<double> field = field_of(input, graph.surface);
  std::vector<float> ends(field.size(), between_ends);
  for (const knit::TubeEvent& event : plan.events) {
    const bool begins = event.kind == knit::EventKind::cast_on;
    if (!begins && event.kind != knit::EventKind::bind_off) continue;
    const knit::Tube& tube = plan.tube(begins ? event.above.front() : event.below.front());
    if (tube.values.empty()) continue;
    const double row = begins ? tube.values.front() : tube.values.back();
    walk_beyond(
        input, event.vertex,
        [&](knit::VertexId vertex) { return begins ? field[vertex] < row : field[vertex] > row; }, ends);
  }
  for (std::size_t vertex = 0; vertex < ends.size(); ++vertex) ends[vertex] = ends[input.twin[vertex]];
  return ends;
}

}  // namespace app
