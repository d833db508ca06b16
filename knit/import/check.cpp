#include "knit/import/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "knit/base/number_text.h"
#include "knit/import/check_topology.h"
#include "knit/import/quoting.h"
#include "knit/mesh/edge_table.h"

namespace knit {

namespace {

// Beyond these, squares and products of lengths overflow or vanish.
constexpr double largest_coordinate = 1e50;
constexpr double smallest_diagonal = 1e-50;
// Relative to the diagonal (squared for areas): well above rounding, well below any stitch.
constexpr double no_thickness = 1e-9;
constexpr double no_area = 1e-14;
constexpr std::size_t vertices_shown = 8;
// An open edge is one to knit from if it is at least so long, as a share of the diagonal: six stitches of the usual width;
// and no single triangle's.
constexpr double least_rim = 0.18;
constexpr std::size_t least_rim_sides = 4;
constexpr std::size_t most_rims = 2;

std::string text(double value) {
  std::array<char, 32> buffer{};
  const auto end = number_into(buffer.data(), buffer.data() + buffer.size(), value, 6);
  return {buffer.data(), end.ptr};
}

// Findings about one mesh, each with the words for its place.
class Report {
 public:
  explicit Report(const Mesh& checked) : mesh(checked) {}

  [[nodiscard]] std::string place(VertexId v) const {
    std::string words = "vertex " + std::to_string(v);
    if (v >= mesh.positions.size()) return words;
    const glm::dvec3& p = mesh.positions[v];
    return words + " (" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + ")";
  }

  // `where` need not be sorted; only its lowest few are kept.
  void add(FindingKind kind, Severity severity, std::size_t count, std::vector<VertexId> where,
           std::string sentence) {
    std::sort(where.begin(), where.end());
    where.erase(std::unique(where.begin(), where.end()), where.end());
    if (where.size() > vertices_shown) where.resize(vertices_shown);
    result.findings.push_back({kind, severity, count, std::move(where), std::move(sentence)});
  }

  CheckResult finish() {
    std::stable_partition(result.findings.begin(), result.findings.end(),
                          [](const Finding& finding) { return finding.severity == Severity::error; });
    return std::move(result);
  }

 private:
  const Mesh& mesh;
  CheckResult result;
};

// Whether every number can be calculated with; the other checks rely on it.
bool check_numbers(const Mesh& mesh, Report& report) {
  if (mesh.triangles.empty()) {
    report.add(FindingKind::no_triangles, Severity::error, 1, {},
               "The mesh has no faces. Export it with its faces and open it again.");
    return false;
  }
  std::vector<VertexId> unusable;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3& p = mesh.positions[v];
    const bool usable = std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate &&
                        std::abs(p.z) <= largest_coordinate;
    if (!usable) unusable.push_back(static_cast<VertexId>(v));
  }
  if (!unusable.empty()) {
    report.add(FindingKind::not_finite, Severity::error, unusable.size(), unusable,
               counted(unusable.size(), "vertex has", "vertices have") +
                   " a coordinate that is no finite number or is beyond 1e50; the first is " +
                   report.place(unusable.front()) + ". Correct the coordinates or export the mesh again.");
  }
  std::size_t astray = 0;
  VertexId example = no_vertex;
  std::vector<VertexId> beside;
  for (const Triangle& triangle : mesh.triangles) {
    const VertexId highest = std::max({triangle[0], triangle[1], triangle[2]});
    if (highest < mesh.positions.size()) continue;
    if (astray++ == 0) example = highest;
    for (const VertexId v : triangle)
      if (v < mesh.positions.size() && beside.size() < vertices_shown) beside.push_back(v);
  }
  if (astray > 0) {
    report.add(FindingKind::index_out_of_range, Severity::error, astray, beside,
               counted(astray, "face names a vertex", "faces name vertices") +
                   " that the mesh does not have; the first asks for " + report.place(example) +
                   ", which has " + std::to_string(mesh.positions.size()) + ". Export the mesh again.");
  }
  return unusable.empty() && astray == 0;
}

void report_no_surface(const Mesh& mesh, Report& report) {
  report.add(FindingKind::no_extent, Severity::error, mesh.triangles.size(), {mesh.triangles.front()[0]},
             "Every face has two corners or more at one place, so there is no surface; the first is at " +
                 report.place(mesh.triangles.front()[0]) + ". Open a mesh of a solid shape.");
}

// Whether the used vertices have some thickness in every direction: farthest point, farthest from that line,
// farthest from that plane.
bool has_extent(const Mesh& mesh, std::span<const std::uint8_t> used, double diagonal) {
  if (!(diagonal >= smallest_diagonal)) return false;
  std::size_t first = 0;
  while (used[first] == 0) ++first;
  const auto farthest = [&](auto&& distance) {
    std::size_t best = first;
    double most = 0.0;
    for (std::size_t v = first; v < used.size(); ++v) {
      if (used[v] == 0) continue;
      const double d = distance((mesh.positions[v] - mesh.positions[first]) / diagonal);
      if (d > most) most = d, best = v;
    }
    return std::pair(most, (mesh.positions[best] - mesh.positions[first]) / diagonal);
  };
  const auto [reach, end] = farthest([](const glm::dvec3& p) { return glm::length(p); });
  if (reach <= no_thickness) return false;
  const glm::dvec3 along = end / reach;
  const auto [breadth, corner] =
      farthest([&](const glm::dvec3& p) { return glm::length(glm::cross(along, p)); });
  if (breadth <= no_thickness) return false;
  const glm::dvec3 normal = glm::normalize(glm::cross(along, corner));
  return farthest([&](const glm::dvec3& p) { return std::abs(glm::dot(normal, p)); }).first > no_thickness;
}

void check_extent(const Mesh& mesh, std::span<const std::uint8_t> used, double diagonal, Report& report) {
  if (has_extent(mesh, used, diagonal)) return;
  const std::size_t count = mesh.triangles.size();
  const std::string what =
      diagonal >= smallest_diagonal
          ? "All faces lie in one plane or on one line, so there is nothing to knit around."
          : "All faces lie at one place, or the mesh is smaller than 1e-50.";
  report.add(FindingKind::no_extent, Severity::error, count, {mesh.triangles.front()[0]},
             what + " The first is at " + report.place(mesh.triangles.front()[0]) +
                 ". Open a mesh of a solid shape.");
}

void check_areas(const Mesh& mesh, double diagonal, Report& report) {
  if (!(diagonal >= smallest_diagonal)) return;
  std::size_t count = 0;
  std::vector<VertexId> where;
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = (mesh.positions[t[1]] - mesh.positions[t[0]]) / diagonal;
    const glm::dvec3 b = (mesh.positions[t[2]] - mesh.positions[t[0]]) / diagonal;
    if (0.5 * glm::length(glm::cross(a, b)) > no_area) continue;
    ++count;
    if (where.size() < vertices_shown) where.push_back(std::min({t[0], t[1], t[2]}));
  }
  if (count == 0) return;
  report.add(FindingKind::zero_area, Severity::warning, count, where,
             counted(count, "triangle has", "triangles have") + " no area; the first is at " +
                 report.place(where.front()) +
                 ". Such triangles are harmless here; remove them if other programs stumble over them.");
}

void check_vertices(std::span<const std::uint8_t> used, std::span<const VertexId> twin, Report& report) {
  std::vector<VertexId> unreferenced;
  std::vector<VertexId> coincident;
  for (std::size_t v = 0; v < twin.size(); ++v) {
    if (used[v] == 0) unreferenced.push_back(static_cast<VertexId>(v));
    if (twin[v] != v) coincident.push_back(static_cast<VertexId>(v));
  }
  if (!unreferenced.empty()) {
    report.add(FindingKind::unreferenced, Severity::warning, unreferenced.size(), unreferenced,
               counted(unreferenced.size(), "vertex belongs", "vertices belong") +
                   " to no face; the first is " + report.place(unreferenced.front()) +
                   ". Such vertices are passed over; remove them from the mesh if they are strays.");
  }
  if (!coincident.empty()) {
    const VertexId first = coincident.front();
    report.add(FindingKind::coincident, Severity::warning, coincident.size(), coincident,
               counted(coincident.size(), "vertex is", "vertices are") +
                   " at the same place as an earlier one; the first is " + report.place(first) +
                   ", at the place of vertex " + std::to_string(twin[first]) +
                   ". They count as one corner of the surface; --weld on merges them.");
  }
}

void report_pieces(const Topology& topology, Report& report) {
  if (topology.pieces.size() < 2) return;
  std::vector<VertexId> where;
  std::string sizes;
  for (const SurfacePiece& piece : topology.pieces) {
    where.push_back(piece.lowest);
    if (where.size() <= vertices_shown)
      sizes += (sizes.empty() ? "" : ", ") + std::to_string(piece.triangles);
  }
  if (where.size() > vertices_shown) sizes += ", ...";
  constexpr std::size_t fewest_of_a_solid = 4;
  const auto solids =
      std::count_if(topology.pieces.begin(), topology.pieces.end(),
                    [](const SurfacePiece& piece) { return piece.triangles >= fewest_of_a_solid; });
  std::string which = ", and open the mesh again.";
  if (solids > 1)
    which =
        ": --piece 1 opens that of most triangles, --piece 2 the next; --piece all knits each, without a "
        "window.";
  report.add(FindingKind::several_pieces, Severity::error, topology.pieces.size(), where,
             "The mesh is in " + std::to_string(topology.pieces.size()) + " pieces that share no edge (of " +
                 sizes + " triangles); the second begins at " + report.place(where[1]) +
                 ". Join them, or keep only one" + which);
}

// Long edges are where a piece begins and ends; short ones are holes.
void report_open_edges(const Mesh& mesh, const Topology& topology, std::span<const VertexId> twin,
                       const Bounds& bounds, Report& report) {
  const auto is_long = [&](const std::vector<VertexId>& loop) {
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      length += glm::distance(mesh.positions[loop[i]], mesh.positions[loop[(i + 1) % loop.size()]]);
    return loop.size() >= least_rim_sides && length >= least_rim * bounds.diagonal();
  };
  const std::vector<std::vector<VertexId>> loops = boundary_loops(mesh.triangles, twin);
  const auto edges = static_cast<std::size_t>(std::count_if(loops.begin(), loops.end(), is_long));
  const bool sound = topology.crowded_edges.empty() && topology.pinched.empty() &&
                     topology.one_sided_at == no_vertex && topology.pieces.size() == 1;
  const std::string first = "; the first is at " + report.place(topology.holes.front());
  const std::string sides = " (" + counted(topology.open_edges, "open edge", "open edges") + ")";
  if (sound && edges == loops.size() && edges <= most_rims) {
    const char* const what = edges == 1 ? ". It is cast on there, and closed at the far end"
                                        : ". It is cast on at one and bound off at the other";
    return report.add(FindingKind::open_edges, Severity::warning, edges, topology.holes,
                      "The mesh is open at " + counted(edges, "edge", "edges") + sides + first + what +
                          "; --swap-ends on turns that round. An edge that is a hole: close it with --mend "
                          "openings.");
  }
  if (sound && edges == loops.size())
    return report.add(FindingKind::open_edges, Severity::error, edges, topology.holes,
                      "The mesh is open at " + counted(edges, "edge", "edges") + sides + first +
                          ". A piece begins at one edge and ends at one other: close all but two of them and "
                          "open the mesh again.");
  report.add(FindingKind::open_edges, Severity::error, topology.holes.size(), topology.holes,
             "The surface has " + counted(topology.holes.size(), "hole", "holes") + sides + first +
                 ". A hole so small is no edge to knit from: close every hole and open the mesh again.");
}

void report_edges(const Mesh& mesh, const Topology& topology, std::span<const VertexId> twin,
                  const Bounds& bounds, Report& report) {
  const auto& crowded = topology.crowded_edges;
  if (!crowded.empty()) {
    std::vector<VertexId> where;
    for (const auto& edge : crowded) where.insert(where.end(), edge.begin(), edge.end());
    report.add(FindingKind::edge_not_manifold, Severity::error, crowded.size(), where,
               counted(crowded.size(), "edge belongs", "edges belong") +
                   " to three or more triangles; the first runs from " + report.place(crowded.front()[0]) +
                   " to " + report.place(crowded.front()[1]) +
                   ". Remove doubled faces, inner walls and fins there, and open the mesh again.");
  }
  if (topology.open_edges > 0) report_open_edges(mesh, topology, twin, bounds, report);
  if (!topology.pinched.empty()) {
    report.add(FindingKind::vertex_not_manifold, Severity::error, topology.pinched.size(), topology.pinched,
               counted(topology.pinched.size(), "vertex joins", "vertices join") +
                   " parts of the surface that touch only there, like the two halves of an hourglass; the "
                   "first is " +
                   report.place(topology.pinched.front()) +
                   ". Pull the parts apart there, or join them by more than a point.");
  }
}

void report_orientation(const Mesh& mesh, const Topology& topology, const Bounds& bounds, Report& report) {
  if (!topology.crowded_edges.empty()) return;
  if (topology.one_sided_at != no_vertex) {
    report.add(
        FindingKind::not_orientable, Severity::error, 1, {topology.one_sided_at},
        "The surface has only one side, like a Moebius strip; its sides meet at " +
            report.place(topology.one_sided_at) +
            ". Only a surface with an inside and an outside can be knitted; open a mesh of a solid shape.");
  } else if (!topology.minority.empty()) {
    std::vector<VertexId> where;
    for (const std::size_t t : topology.minority)
      where.insert(where.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    const VertexId first = *std::min_element(where.begin(), where.end());
    report.add(FindingKind::flipped_faces, Severity::warning, topology.minority.size(), where,
               counted(topology.minority.size(), "triangle faces", "triangles face") +
                   " the other way than the rest; the first is at " + report.place(first) +
                   ". The rows do not depend on it; make the normals agree to have the colours right.");
  } else if (topology.open_edges == 0 && bounds.diagonal() >= smallest_diagonal &&
             signed_volume(mesh, bounds) < 0.0) {
    report.add(FindingKind::inside_out, Severity::warning, mesh.triangles.size(), {mesh.triangles.front()[0]},
               "All " + std::to_string(mesh.triangles.size()) + " triangles face inwards, beginning at " +
                   report.place(mesh.triangles.front()[0]) +
                   ". The rows do not depend on it; flip the normals to have the outside out.");
  }
}

}  // namespace

bool CheckResult::fit() const {
  return std::none_of(findings.begin(), findings.end(),
                      [](const Finding& finding) { return finding.severity == Severity::error; });
}

CheckResult check(const Mesh& mesh, Progress* progress) {
  const auto tell = [&](double share) {
    if (progress != nullptr) progress->at(share);
  };
  if (progress != nullptr) progress->begin(Progress::Task::checking);
  Report report(mesh);
  if (!check_numbers(mesh, report)) return report.finish();

  // A triangle with two corners at one place is no part of the surface, wherever it lies.
  const std::vector<VertexId> twin = find_twins(mesh.positions);
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  bool surface = false;
  for (const Triangle& triangle : mesh.triangles) {
    if (collapsed(twins_of(triangle, twin))) continue;
    surface = true;
    for (const VertexId v : triangle) used[v] = 1;
  }
  if (!surface) {
    report_no_surface(mesh, report);
    return report.finish();
  }
  std::vector<glm::dvec3> corners;
  corners.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) corners.push_back(mesh.positions[v]);
  const Bounds bounds = bounds_of(corners);
  tell(0.3);
  const Topology topology = study_topology(mesh.triangles, twin);

  tell(0.8);
  check_extent(mesh, used, bounds.diagonal(), report);
  tell(0.9);
  report_pieces(topology, report);
  report_orientation(mesh, topology, bounds,
                     report);  // before holes: closing those of a one-sided surface is no help
  report_edges(mesh, topology, twin, bounds, report);
  check_areas(mesh, bounds.diagonal(), report);
  check_vertices(used, twin, report);
  return report.finish();
}

}  // namespace knit
