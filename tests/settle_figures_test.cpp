// Settling on meshes by others: the figures that it is held to, as worked out apart from this program.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "knit/import/obj.h"
#include "knit/mesh/triangle_tree.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/coverage.h"
#include "knit/quality/measures.h"
#include "knit/run/timeline.h"
#include "knit/settle/settle.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;

#ifdef KNIT_SHARED_MESHES
namespace {

struct Case {
  const char* mesh;
  TimingKind timing;
  double width_percent;     // of the bounding box's diagonal
  double wale_cv, longest;  // at most
  std::size_t turned;       // faces that may lie with their inside out: what the study has
  double uncovered;  // the mesh's farthest vertex from the knit mesh, in percent of the diagonal, at most
  double course_cv = 0.16, corner_off = 18.0;  // at most; degrees
};

constexpr TimingKind linear = TimingKind::linear, geodesic = TimingKind::geodesic;
// Table by linear time: a flat plate has none, so that wales are uneven and corners no squarer than placed, as elsewhere
// (0.210 and 0.198, 19 degrees); but no face turns over.
constexpr std::array cases{Case{"bunny", linear, 4, 0.081, 1.5, 0, 3.8},
                           Case{"bunny", geodesic, 4, 0.080, 1.8, 1, 3.8},
                           Case{"spot", linear, 4, 0.110, 2.0, 0, 4.3},
                           Case{"spot", geodesic, 4, 0.0661, 1.45, 0, 5.3},
                           Case{"teddy", linear, 4, 0.069, 1.4, 0, 2.4},
                           Case{"teddy", geodesic, 4, 0.044, 1.3, 0, 2.8},
                           Case{"starfish", linear, 4, 0.093, 1.6, 0, 2.0},
                           Case{"starfish", geodesic, 4, 0.050, 1.3, 0, 1.6},
                           Case{"starfish", linear, 2, 0.103, 1.9, 0, 0.6},
                           Case{"starfish", geodesic, 2, 0.064, 1.6, 0, 0.6},
                           Case{"table", geodesic, 4, 0.0997, 1.9, 0, 3.2},
                           Case{"octopus", linear, 4, 0.047, 1.4, 0, 2.0},
                           Case{"octopus", geodesic, 4, 0.040, 1.3, 0, 1.7},
                           Case{"simple-elbow", linear, 4, 0.085, 1.7, 0, 2.0},
                           Case{"simple-elbow", geodesic, 4, 0.085, 1.7, 0, 2.0},
                           Case{"simple-sphere", linear, 4, 0.032, 1.3, 0, 0.6, 0.16, 8.5},
                           Case{"simple-sphere", geodesic, 4, 0.032, 1.3, 0, 0.6, 0.16, 8.5},
                           Case{"bunny", geodesic, 2, 0.103, 2.45, 0, 1.5},
                           Case{"spot", linear, 2, 0.118, 2.2, 0, 2.1},
                           Case{"teddy", geodesic, 2, 0.0545, 1.7, 0, 0.9},
                           Case{"table", geodesic, 2, 0.117, 2.3, 0, 1.8},
                           Case{"table", linear, 4, 0.225, 2.2, 0, 2.4, 0.19, 20.0},
                           Case{"table", linear, 2, 0.205, 2.4, 0, 0.9, 0.19, 20.0}};

LengthFigures lengths_of(const std::vector<std::array<std::uint32_t, 2>>& edges, const Settled& at) {
  std::vector<double> lengths;
  for (const auto& [a, b] : edges) lengths.push_back(glm::distance(at.positions[a], at.positions[b]));
  return figures_of(lengths);
}

double mean_corner_off(const SettleGraph& graph, const Settled& at) {
  double sum = 0.0;
  for (const auto& quad : graph.quads) {
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3 a = at.positions[quad[(i + 3) % 4]] - at.positions[quad[i]];
      const glm::dvec3 b = at.positions[quad[(i + 1) % 4]] - at.positions[quad[i]];
      const double cosine = glm::dot(a, b) / std::max(glm::length(a) * glm::length(b), 1e-300);
      sum += std::abs(std::acos(std::clamp(cosine, -1.0, 1.0)) - std::numbers::pi / 2);
    }
  }
  return sum / (4.0 * static_cast<double>(graph.quads.size())) * 180.0 / std::numbers::pi;
}

std::vector<Face> faces_of(const Fabric& fabric) {
  std::vector<Face> faces;
  for (const auto& strip : fabric.strips())
    faces.insert(faces.end(), strip->faces.begin(), strip->faces.end());
  for (const auto& deal : fabric.deals()) faces.insert(faces.end(), deal->faces.begin(), deal->faces.end());
  return faces;
}

std::size_t turned_faces(const Input& input, const SettlePlan& plan, const std::vector<Face>& faces,
                         const Settled& at) {
  const TriangleTree tree(input.mesh.positions, input.mesh.triangles);
  std::size_t turned = 0;
  for (const Face& face : faces) {
    const auto corner = [&](std::size_t i) { return at.positions[face.corners[i]]; };
    const bool quad = face.corner_count == 4;
    const glm::dvec3 middle = quad ? (corner(0) + corner(1) + corner(2) + corner(3)) / 4.0
                                   : (corner(0) + corner(1) + corner(2)) / 3.0;
    const glm::dvec3 across = quad ? glm::cross(corner(2) - corner(0), corner(3) - corner(1))
                                   : glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    const SurfacePlace place = tree.nearest(middle);
    const glm::dvec3 normal = normal_at(input, plan.normals, place.triangle, place.point, {0, 1, 0});
    if (glm::dot(across, normal) * plan.terms.facing < 0.0) ++turned;
  }
  return turned;
}

// Openings are closed by fans about their middles: they are not what is asked about.
double uncovered(const Input& input, const SettlePlan& plan, const std::vector<Face>& faces,
                 const Settled& at) {
  std::vector<glm::dvec3> positions = at.positions;
  std::vector<Triangle> triangles;
  for (const Face& face : faces) {
    const auto& c = face.corners;
    triangles.push_back({c[0], c[1], c[2]});
    if (face.corner_count == 4) triangles.push_back({c[0], c[2], c[3]});
  }
  for (const auto& rim : plan.terms.graph.rims) {
    glm::dvec3 middle(0.0);
    for (const std::uint32_t stitch : rim) middle += at.positions[stitch];
    positions.push_back(middle / static_cast<double>(rim.size()));
    for (const auto& [from, to] : Edges(rim.size(), true))
      triangles.push_back({rim[from], rim[to], static_cast<VertexId>(positions.size() - 1)});
  }
  const TriangleTree tree(positions, triangles);
  double farthest = 0.0;
  for (const glm::dvec3& p : input.mesh.positions) farthest = std::max(farthest, tree.distance(p));
  return 100.0 * farthest / input.bounds.diagonal();
}

void check_case(const Case& wanted, const std::filesystem::path& folder) {
  INFO(wanted.mesh << ", timing " << static_cast<int>(wanted.timing) << ", w " << wanted.width_percent
                   << " %");
  auto read = read_obj_file(folder / (std::string(wanted.mesh) + ".obj"));
  REQUIRE(std::holds_alternative<Mesh>(read));
  const auto input = make_input(std::get<Mesh>(std::move(read)));
  Parameters parameters = default_parameters(input->bounds);
  give_width(parameters, wanted.width_percent / 100.0 * input->bounds.diagonal());
  parameters.timing.kind = wanted.timing;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters = resolved(parameters, *input);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  State state = timeline.furthest();
  const Fabric fabric = state.fabric;
  const SettleSettings settings;
  SettleWork work;
  begin_settling(*input, fabric, parameters.stitch, settings, work);
  while (!work.done) advance_settling(*input, settings, work);

  const SettleGraph& graph = work.plan->terms.graph;
  const LengthFigures wales = lengths_of(graph.wales, *work.at),
                      courses = lengths_of(graph.courses, *work.at);
  CHECK(wales.cv <= wanted.wale_cv);
  CHECK(wales.high <= wanted.longest * parameters.stitch.height);
  CHECK(courses.cv <= wanted.course_cv);
  CHECK(mean_corner_off(graph, *work.at) <= wanted.corner_off);
  if (wanted.corner_off <= 18.0)
    CHECK(mean_corner_off(graph, *work.at) < mean_corner_off(graph, work.plan->start));
  const std::vector<Face> faces = faces_of(fabric);
  CHECK(turned_faces(*input, *work.plan, faces, *work.at) <= wanted.turned);
  CHECK(uncovered(*input, *work.plan, faces, *work.at) <= wanted.uncovered);
  CHECK(work.iteration < settings.most_iterations);
  const StitchSize& stitch = parameters.stitch;
  const double before = measure_uncovered(*input, state, stitch.width, stitch.height).share;
  state.fabric = fabric.moved_to(work.at->positions);
  // The most is 0.00084, on spot of 2 %, linear; on the others 0.0003.
  CHECK(measure_uncovered(*input, state, stitch.width, stitch.height).share <= before + 0.0009);
}

}  // namespace

TEST_CASE("settle figures: meshes by others come out as even as elsewhere") {
  const std::filesystem::path folder = KNIT_SHARED_MESHES;
  if (!std::filesystem::exists(folder / "bunny.obj")) return;  // not part of the sources
  std::size_t number = 0;
  for (const Case& wanted : cases) {
    if (test_support::is_tried(number++)) check_case(wanted, folder);
  }
}
#endif
