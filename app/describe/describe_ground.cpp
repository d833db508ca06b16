#include "app/describe/describe_ground.h"

#include <glm/geometric.hpp>

#include "app/describe/describe_contours.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

// Area-weighted, joined across seams.
std::vector<glm::vec3> smooth_normals(const knit::Input& input) {
  const knit::Mesh& mesh = input.mesh;
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  for (const knit::Triangle& t : mesh.triangles) {
    const glm::dvec3& a = mesh.positions[t[0]];
    const glm::dvec3 normal = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    for (const knit::VertexId v : t) sums[input.twin[v]] += normal;
  }
  std::vector<glm::vec3> normals;
  normals.reserve(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const glm::dvec3& sum = sums[input.twin[v]];
    const double length = glm::length(sum);
    normals.emplace_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0, 1, 0));
  }
  return normals;
}

std::shared_ptr<const MeshShape> shape_of(const knit::Input& input) {
  MeshShape shape;
  shape.positions.assign(input.mesh.positions.begin(), input.mesh.positions.end());
  shape.normals = smooth_normals(input);
  shape.triangles.reserve(3 * input.mesh.triangles.size());
  shape.edges.reserve(2 * input.mesh.edges.size());
  for (const knit::Triangle& t : input.mesh.triangles)
    shape.triangles.insert(shape.triangles.end(), t.begin(), t.end());
  for (const auto& edge : input.mesh.edges) shape.edges.insert(shape.edges.end(), edge.begin(), edge.end());
  return std::make_shared<const MeshShape>(std::move(shape));
}

}  // namespace

// Times as the whole run has them; the scene says up to which vertex they are shown.
void Ground::describe_times(const Session& session, Scene& scene) {
  const auto timing = session.document->timeline.furthest().timing.pointer();
  const bool same = timing == timing_ || (timing && timing_ && timing->times == timing_->times);
  if (!same || !timing) {
    times_ = timing ? std::make_shared<const std::vector<float>>(timing->times.begin(), timing->times.end())
                    : nullptr;
  }
  timing_ = timing;
  scene.times = times_;
}

void Ground::describe(const Session& session, bool beside, Scene& scene) {
  const auto input = session.document->timeline.input_pointer();
  const knit::State& state = session.document->timeline.state();
  const bool by_worker = beside && input->mesh.triangles.size() >= made_beside_triangles;
  scene.mesh = shape_.get(input, by_worker, [input] { return shape_of(*input); });
  scene.unfinished = scene.unfinished || !scene.mesh;
  scene.show_surface = session.view->shows(Layer::surface);
  scene.show_wire = session.view->shows(Layer::wire);
  scene.show_times = session.view->shows(Layer::times);
  scene.timed_vertices = static_cast<std::uint32_t>(input->mesh.positions.size());
  if (const auto* work = std::get_if<knit::TimingWork>(&state.work))
    scene.timed_vertices = static_cast<std::uint32_t>(work->times.size());
  describe_times(session, scene);
  // Under the knit mesh isolines would only shine through.
  if (!state.timing || !session.view->shows(Layer::isolines) || !state.fabric.strips().empty()) return;
  const auto lines = isolines_.get(
      state.timing.pointer(), by_worker,
      [input, timing = state.timing, theme = scene.theme] { return isolines_of(*theme, *input, *timing); });
  scene.isolines = lines;
  scene.unfinished = scene.unfinished || !lines;
}

}  // namespace app
