#include "knit/curves/between.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "knit/curves/cut.h"
#include "knit/curves/embed.h"
#include "knit/curves/refused.h"
#include "knit/curves/shortest_way.h"
#include "knit/mesh/union_find.h"

namespace knit {
namespace {

using Ring = std::vector<VertexId>;

std::set<EdgeKey> ring_edges(const Ring& ring) {
  std::set<EdgeKey> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.insert(edge_key(ring[i], ring[(i + 1) % ring.size()]));
  return edges;
}

double triangle_area(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.positions;
  return 0.5 * glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
}

// Triangles that hang together without stepping over a cut edge.
struct Parts {
  std::vector<std::size_t> of;  // per triangle
  std::vector<double> areas;    // per part
};

Parts parts_between(const Mesh& mesh, const std::set<EdgeKey>& cut) {
  UnionFind sets(mesh.triangles.size());
  std::map<EdgeKey, std::uint32_t> first;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const EdgeKey edge = edge_key(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      if (cut.contains(edge)) continue;
      const auto [entry, fresh] = first.try_emplace(edge, t);
      if (!fresh) sets.join(entry->second, t);
    }
  Parts parts;
  std::map<std::uint32_t, std::size_t> number;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t part = number.try_emplace(sets.find(t), number.size()).first->second;
    parts.of.push_back(part);
    parts.areas.resize(number.size());
    parts.areas[part] += triangle_area(mesh, mesh.triangles[t]);
  }
  return parts;
}

struct Cuts {
  Mesh mesh;
  std::vector<Cycle> cycles;
  std::vector<Ring> rings;  // per cycle
  std::vector<Ring> edges;  // the open edges of the mesh as it was
  std::vector<std::string> notes;
};

bool has_cycle(const std::vector<Cycle>& cycles, CycleEnd as) {
  return std::any_of(cycles.begin(), cycles.end(), [&](const Cycle& cycle) { return cycle.as == as; });
}

double ring_height(const Mesh& mesh, const Ring& ring, const glm::dvec3& up) {
  double height = 0.0;
  for (const VertexId v : ring) height += glm::dot(mesh.positions[v], up);
  return height / static_cast<double>(ring.size());
}

// A start where none is given. Whether an end is missing shows once the start is cut.
void choose_start(Cuts& cuts, const glm::dvec3& up) {
  if (has_cycle(cuts.cycles, CycleEnd::start)) return;
  if (cuts.edges.empty()) {
    cuts.cycles.push_back({.kind = CycleKind::farthest});
    return;
  }
  const auto lowest =
      std::min_element(cuts.edges.begin(), cuts.edges.end(), [&](const Ring& a, const Ring& b) {
        return ring_height(cuts.mesh, a, up) < ring_height(cuts.mesh, b, up);
      });
  cuts.notes.push_back("start: the edge of the mesh that lies lowest (" + std::to_string(lowest->size()) +
                       " vertices)");
  cuts.cycles.insert(cuts.cycles.begin(),
                     Cycle{.kind = CycleKind::boundary, .points = {cuts.mesh.positions[lowest->front()]}});
}

void choose_end(Cuts& cuts) {
  if (has_cycle(cuts.cycles, CycleEnd::end)) return;
  std::vector<const Ring*> others;
  for (const Ring& edge : cuts.edges) {
    const bool used = std::any_of(cuts.rings.begin(), cuts.rings.end(), [&](const Ring& ring) {
      return std::find(ring.begin(), ring.end(), edge.front()) != ring.end();
    });
    if (!used) others.push_back(&edge);
  }
  if (others.size() > 1)
    throw CurveRefused("The mesh has " + std::to_string(others.size()) +
                       " more edges. Say which is the end, or repair the others.");
  Cycle end{.as = CycleEnd::end, .kind = CycleKind::farthest};
  if (others.size() == 1) {
    cuts.notes.emplace_back("end: the other edge of the mesh");
    end.kind = CycleKind::boundary;
    end.points.push_back(cuts.mesh.positions[others.front()->front()]);
  }
  cuts.cycles.push_back(end);
}

// The vertex farthest from the first start, on the greatest of the parts beside it.
Cycle circle_at_farthest(Cuts& cuts, const Cycle& cycle) {
  Ring from;
  for (std::size_t i = 0; i < cuts.rings.size() && from.empty(); ++i)
    if (cuts.cycles[i].as != cycle.as) from = cuts.rings[i];
  if (from.empty()) throw CurveRefused(called(cycle) + ": farthest needs another curve to be far from.");
  const std::vector<double> distance = ShortestWays(cuts.mesh, 1.0).distances(from);
  const Parts parts = parts_between(cuts.mesh, ring_edges(from));
  const auto greatest = static_cast<std::size_t>(std::max_element(parts.areas.begin(), parts.areas.end()) -
                                                 parts.areas.begin());
  VertexId best = from.front();
  for (std::size_t t = 0; t < parts.of.size(); ++t) {
    if (parts.of[t] != greatest) continue;
    for (const VertexId v : cuts.mesh.triangles[t]) {
      const bool farther = distance[v] > distance[best] || (distance[v] == distance[best] && v < best);
      if (farther && distance[v] < std::numeric_limits<double>::infinity()) best = v;
    }
  }
  Cycle circle = cycle;
  circle.kind = CycleKind::circle;
  circle.points = {cuts.mesh.positions[best]};
  cuts.notes.push_back(called(cycle) + ": the point farthest from the other, " +
                       place_text(cuts.mesh.positions[best]) + ", with a circle about it");
  return circle;
}

std::string both_called(const Cuts& cuts, std::size_t a, std::size_t b) {
  return called(cuts.cycles[a]) + " and " + called(cuts.cycles[b]);
}

// The last cut went through a ring of before: not all edges of that are there any more.
void refuse_crossing(const Cuts& cuts) {
  const std::vector<EdgeKey> alive = edges_of(cuts.mesh.triangles);
  for (std::size_t i = 0; i + 1 < cuts.rings.size(); ++i) {
    const std::set<EdgeKey> edges = ring_edges(cuts.rings[i]);
    if (!std::includes(alive.begin(), alive.end(), edges.begin(), edges.end()))
      throw CurveRefused(both_called(cuts, i, cuts.rings.size() - 1) +
                         " cross each other. Move one of them away.");
  }
}

Cuts cut_all(const Mesh& mesh, std::span<const Cycle> cycles, const BetweenSettings& settings) {
  Cuts cuts{
      .mesh = sewn(mesh), .cycles = {cycles.begin(), cycles.end()}, .rings = {}, .edges = {}, .notes = {}};
  cuts.edges = boundary_rings(cuts.mesh.triangles);
  const CutSizes sizes{.diagonal = bounds_of(mesh.positions).diagonal(),
                       .radius = 6.0 * settings.stitch_width / (2.0 * std::numbers::pi),
                       .up = settings.up};
  choose_start(cuts, settings.up);
  for (std::size_t i = 0; i < cuts.cycles.size(); ++i) {
    if (cuts.cycles[i].kind == CycleKind::farthest) cuts.cycles[i] = circle_at_farthest(cuts, cuts.cycles[i]);
    cuts.rings.push_back(cut_cycle(cuts.mesh, cuts.cycles[i], sizes));
    refuse_crossing(cuts);
    if (i + 1 == cuts.cycles.size()) choose_end(cuts);
  }
  return cuts;
}

void refuse_touching(const Cuts& cuts) {
  std::map<VertexId, std::size_t> owner;
  for (std::size_t i = 0; i < cuts.rings.size(); ++i)
    for (const VertexId v : cuts.rings[i]) {
      const auto [entry, fresh] = owner.try_emplace(v, i);
      if (!fresh)
        throw CurveRefused(both_called(cuts, entry->second, i) + " touch. They must not share a point.");
    }
}

// Which cycles are on the border of each part.
std::vector<std::vector<std::size_t>> borders(const Cuts& cuts, const Parts& parts) {
  std::map<EdgeKey, std::size_t> cycle_at;
  for (std::size_t i = 0; i < cuts.rings.size(); ++i)
    cycle_at[edge_key(cuts.rings[i][0], cuts.rings[i][1])] = i;
  std::vector<std::set<std::size_t>> found(parts.areas.size());
  for (std::size_t t = 0; t < parts.of.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& triangle = cuts.mesh.triangles[t];
      const auto at = cycle_at.find(edge_key(triangle[k], triangle[(k + 1) % 3]));
      if (at != cycle_at.end()) found[parts.of[t]].insert(at->second);
    }
  std::vector<std::vector<std::size_t>> lists;
  lists.reserve(found.size());
  for (const auto& set : found) lists.emplace_back(set.begin(), set.end());
  return lists;
}

void refuse_not_parting(const Cuts& cuts, const std::vector<std::vector<std::size_t>>& border) {
  for (std::size_t i = 0; i < cuts.rings.size(); ++i) {
    if (cuts.cycles[i].kind == CycleKind::boundary) continue;
    const auto sides = std::count_if(border.begin(), border.end(), [&](const auto& list) {
      return std::find(list.begin(), list.end(), i) != list.end();
    });
    if (sides > 1) continue;
    throw CurveRefused(
        called(cuts.cycles[i]) +
        " does not part the surface: both its sides are the same piece. On a ring shape a start "
        "and an end are both needed, and each must go round the same arm.");
  }
}

std::size_t choose_part(Cuts& cuts, const Parts& parts, const std::vector<std::vector<std::size_t>>& border) {
  std::vector<std::size_t> good;
  for (std::size_t part = 0; part < border.size(); ++part) {
    std::array<bool, 2> has{};
    for (const std::size_t i : border[part]) has[cuts.cycles[i].as == CycleEnd::start ? 0 : 1] = true;
    if (has[0] && has[1]) good.push_back(part);
  }
  if (good.empty())
    throw CurveRefused("No piece of the surface lies between start and end: they are on different pieces.");
  if (good.size() > 1)
    cuts.notes.push_back(std::to_string(good.size()) +
                         " pieces lie between start and end; the largest is knitted");
  return *std::max_element(good.begin(), good.end(),
                           [&](std::size_t a, std::size_t b) { return parts.areas[a] < parts.areas[b]; });
}

void tell_caps(const Cuts& cuts, const Parts& parts, const std::vector<std::vector<std::size_t>>& border,
               std::size_t chosen, Between& out) {
  const double whole = std::accumulate(parts.areas.begin(), parts.areas.end(), 0.0);
  double away = 0.0;
  for (std::size_t part = 0; part < border.size(); ++part) {
    if (part == chosen) continue;
    CutCap cap{.share = parts.areas[part] / whole, .beyond = {}};
    std::string names;
    for (const std::size_t i : border[part]) {
      cap.beyond.push_back(called(cuts.cycles[i]));
      const bool plain = cuts.cycles[i].name.empty();
      names += (names.empty() ? "" : " and ") + std::string(plain ? "the " : "") + cap.beyond.back();
    }
    away += cap.share;
    const double tenths = std::round(1000.0 * cap.share) / 10.0;
    out.notes.push_back("left out: " + three_digits(tenths) + " % of the surface" +
                        (names.empty() ? ", which hangs together with neither" : " beyond " + names));
    out.caps.push_back(std::move(cap));
  }
  if (away > 0.5)
    out.notes.push_back("more than half of the surface is left out, " +
                        three_digits(std::round(1000.0 * away) / 10.0) +
                        " %. Are start and end where they should be?");
}

void take_part(const Cuts& cuts, const Parts& parts, std::size_t chosen, std::size_t vertices, Between& out) {
  std::vector<VertexId> number(cuts.mesh.positions.size(), no_vertex);
  std::vector<VertexId> used;
  for (std::size_t t = 0; t < parts.of.size(); ++t)
    if (parts.of[t] == chosen)
      used.insert(used.end(), cuts.mesh.triangles[t].begin(), cuts.mesh.triangles[t].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  out.mesh.name = cuts.mesh.name;
  for (const VertexId v : used) {
    number[v] = static_cast<VertexId>(out.mesh.positions.size());
    out.mesh.positions.push_back(cuts.mesh.positions[v]);
    out.before.push_back(v < vertices ? v : no_vertex);
  }
  for (std::size_t t = 0; t < parts.of.size(); ++t) {
    if (parts.of[t] != chosen) continue;
    const Triangle& old = cuts.mesh.triangles[t];
    out.mesh.triangles.push_back({number[old[0]], number[old[1]], number[old[2]]});
  }
  for (const auto& [a, b] : edges_of(out.mesh.triangles)) out.mesh.edges.push_back({a, b});
  const std::vector<Ring> rings = boundary_rings(out.mesh.triangles);
  for (std::size_t i = 0; i < cuts.rings.size(); ++i) {
    const VertexId one = number[cuts.rings[i].front()];
    for (const Ring& ring : rings)
      if (std::find(ring.begin(), ring.end(), one) != ring.end())
        out.rims.push_back({cuts.cycles[i].as, called(cuts.cycles[i]), time_of(cuts.cycles[i]), ring});
  }
}

void refuse_more_than_a_tube(const Between& piece) {
  std::vector<Ring> others;
  for (const Ring& ring : boundary_rings(piece.mesh.triangles)) {
    const bool rim = std::any_of(piece.rims.begin(), piece.rims.end(),
                                 [&](const CutRim& one) { return one.vertices == ring; });
    if (!rim) others.push_back(ring);
  }
  if (!others.empty()) {
    const Ring& ring = others.front();
    double length = 0.0;
    glm::dvec3 middle(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::dvec3& at = piece.mesh.positions[ring[i]];
      length += glm::length(piece.mesh.positions[ring[(i + 1) % ring.size()]] - at);
      middle += at / static_cast<double>(ring.size());
    }
    throw CurveRefused("The piece between start and end has " + std::to_string(others.size()) + " more edge" +
                       (others.size() > 1 ? "s" : "") + " (" + (others.size() > 1 ? "the first " : "") +
                       three_digits(length) + " long, near " + place_text(middle) +
                       "): close the hole, or make it an end.");
  }
  const auto count = [](std::size_t size) { return static_cast<std::ptrdiff_t>(size); };
  const std::ptrdiff_t euler = count(piece.mesh.positions.size()) - count(piece.mesh.edges.size()) +
                               count(piece.mesh.triangles.size());
  const std::ptrdiff_t handles = (2 - count(piece.rims.size()) - euler) / 2;
  if (handles > 0)
    throw CurveRefused("The piece between start and end has " + std::to_string(handles) + " handle" +
                       (handles > 1 ? "s" : "") + ": its rows part there.");
}

}  // namespace

std::variant<Between, std::string> between_cycles(const Mesh& mesh, std::span<const Cycle> cycles,
                                                  const BetweenSettings& settings) {
  try {
    Cuts cuts = cut_all(mesh, cycles, settings);
    refuse_touching(cuts);
    std::set<EdgeKey> cut;
    for (const Ring& ring : cuts.rings) cut.merge(ring_edges(ring));
    const Parts parts = parts_between(cuts.mesh, cut);
    const std::vector<std::vector<std::size_t>> border = borders(cuts, parts);
    refuse_not_parting(cuts, border);
    const std::size_t chosen = choose_part(cuts, parts, border);
    Between piece;
    piece.notes = cuts.notes;
    tell_caps(cuts, parts, border, chosen, piece);
    take_part(cuts, parts, chosen, mesh.positions.size(), piece);
    refuse_more_than_a_tube(piece);
    return piece;
  } catch (const CurveRefused& refused) {
    return std::string(refused.what());
  }
}

std::shared_ptr<const Input> input_of(const Between& piece) {
  Input input = *make_input(piece.mesh);
  for (MeshRim& rim : input.rims)
    for (const CutRim& cut : piece.rims)
      if (std::find(cut.vertices.begin(), cut.vertices.end(), rim.vertices.front()) != cut.vertices.end())
        rim.role = cut.as == CycleEnd::start ? RimRole::start : RimRole::end;
  return std::make_shared<const Input>(std::move(input));
}

}  // namespace knit
