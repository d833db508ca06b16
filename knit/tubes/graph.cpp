#include "knit/tubes/graph.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "knit/mesh/edge_table.h"
#include "knit/mesh/union_find.h"
#include "knit/model/bug.h"

namespace knit {

namespace {

constexpr std::int32_t no_node = -1;

// Of a triangle's corners, rising.
struct CornerRanks {
  std::uint32_t low, middle, high;
};

CornerRanks corner_ranks(const MorseSurface& surface, const Triangle& t) {
  const auto [low, high] = std::minmax({surface.rank[t[0]], surface.rank[t[1]], surface.rank[t[2]]});
  return {low, surface.rank[t[0]] ^ surface.rank[t[1]] ^ surface.rank[t[2]] ^ low ^ high, high};
}

// Each half-edge's other side.
std::vector<HalfEdge> opposite_sides(const MorseSurface& surface) {
  std::vector<VertexId> itself(surface.positions.size());
  std::iota(itself.begin(), itself.end(), VertexId{0});
  const EdgeTable table = make_edge_table(surface.triangles, itself);
  std::vector<HalfEdge> across(3 * surface.triangles.size(), no_half_edge);
  const auto origin = [&](HalfEdge h) { return surface.triangles[h / 3][h % 3]; };
  for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
    const std::uint32_t end = table.first[v + 1];
    for (std::uint32_t i = table.first[v]; i < end; i += 2) {
      const EdgeUse& use = table.uses[i];
      const bool paired = i + 1 < end && table.uses[i + 1].high == use.high;
      const bool crowded = i + 2 < end && table.uses[i + 2].high == use.high;
      if (!paired || crowded || origin(use.half_edge) == origin(table.uses[i + 1].half_edge))
        throw Bug("an edge of the surface has not two triangles that agree");
      across[use.half_edge] = table.uses[i + 1].half_edge;
      across[table.uses[i + 1].half_edge] = use.half_edge;
    }
  }
  return across;
}

class TubeCutter {
 public:
  TubeCutter(const MorseSurface& surface, const Heard& heard)
      : surface_(surface),
        heard_(heard),
        worked_out_(surface.across.empty() ? opposite_sides(surface) : std::vector<HalfEdge>{}),
        across_(surface.across.empty() ? worked_out_ : surface.across) {
    hear(heard_, 0.1);
    corners_.reserve(surface.triangles.size());
    for (const Triangle& t : surface.triangles) corners_.push_back(corner_ranks(surface, t));
    hear(heard_, 0.2);
    find_nodes();
    hear(heard_, 0.25);
    cut_along_curves();
  }
  TubeCutter(const TubeCutter&) = delete;
  TubeCutter& operator=(const TubeCutter&) = delete;

  // Of the surface: its parts and the nodes between them.
  void write_to(TubeGraph& graph) {
    UnionFind parts(first_part_.back());
    glue(parts, part_of(heard_, 0.3, 0.5));
    graph.nodes = nodes_;
    hear(heard_, 0.5);
    const std::vector<std::uint32_t> tube_of_part = find_ends(parts, graph);
    hear(heard_, 0.75);
    write_pieces(tube_of_part, graph);
  }

 private:
  // Of the triangle's cuts, those at or below a rank.
  [[nodiscard]] std::uint32_t cuts_up_to(std::uint32_t triangle, std::uint32_t rank) const {
    const auto begin = cuts_.begin() + first_cut_[triangle];
    const auto end = cuts_.begin() + first_cut_[triangle + 1];
    return static_cast<std::uint32_t>(std::upper_bound(begin, end, rank) - begin);
  }
  [[nodiscard]] std::uint32_t rank_at(HalfEdge h) const {
    return surface_.rank[surface_.triangles[h / 3][h % 3]];
  }

  // The vertices at which the level curves change, by rank.
  void find_nodes() {
    std::vector<std::uint8_t> middles(surface_.rank.size(), 0);
    for (const CornerRanks& corners : corners_)
      if (++middles[corners.middle] > 4) throw Bug("a multi-saddle has not been unfolded");
    node_at_.assign(middles.size(), no_node);
    for (std::uint32_t r = 0; r < middles.size(); ++r) {
      if (middles[r] == 2) continue;
      node_at_[r] = static_cast<std::int32_t>(nodes_.size());
      const VertexId vertex = surface_.by_rank[r];
      const bool rim = std::any_of(surface_.caps.begin(), surface_.caps.end(),
                                   [&](const RimCap& cap) { return cap.apex == vertex; });
      nodes_.push_back({vertex, surface_.values[vertex], {}, {}, rim});
    }
  }

  // The triangles that the level curve at a node crosses, from one whose middle corner the node is to the next such.
  void follow_curve(std::uint32_t triangle, std::uint32_t rank, std::vector<std::uint32_t>& crossed) const {
    HalfEdge side = 3 * triangle;
    while (rank_at(previous_in_triangle(side)) != rank) side = next_in_triangle(side);
    crossed.push_back(triangle);
    while (true) {
      side = across_[side];
      crossed.push_back(side / 3);
      const std::uint32_t opposite = rank_at(previous_in_triangle(side));
      if (opposite == rank) return;
      // It leaves by the side whose ends are apart.
      const bool with_origin = (opposite < rank) == (rank_at(side) < rank);
      side = with_origin ? next_in_triangle(side) : previous_in_triangle(side);
    }
  }

  void cut_along_curves() {
    struct AtNode {
      std::uint32_t rank, triangle;
    };
    std::vector<AtNode> starts;
    for (std::uint32_t t = 0; t < corners_.size(); ++t)
      if (node_at_[corners_[t].middle] != no_node) starts.push_back({corners_[t].middle, t});
    std::stable_sort(starts.begin(), starts.end(),
                     [](const AtNode& a, const AtNode& b) { return a.rank < b.rank; });
    // At each node four ways begin, and two of them are the others' ends.
    std::vector<AtNode> all;  // by rank
    std::vector<std::uint32_t> crossed;
    // Per triangle: the rank of the curve that ended there.
    std::vector<std::uint32_t> ended(corners_.size(), no_vertex);
    for (const auto& [rank, triangle] : starts) {
      if (ended[triangle] == rank) continue;
      crossed.clear();
      follow_curve(triangle, rank, crossed);
      ended[crossed.back()] = rank;
      for (const std::uint32_t t : crossed) all.push_back({rank, t});
    }
    first_cut_.assign(corners_.size() + 1, 0);
    for (const AtNode& cut : all) ++first_cut_[cut.triangle + 1];
    std::partial_sum(first_cut_.begin(), first_cut_.end(), first_cut_.begin());
    std::vector<std::uint32_t> next(first_cut_.begin(), first_cut_.end() - 1);
    cuts_.resize(all.size());
    for (const AtNode& cut : all) cuts_[next[cut.triangle]++] = cut.rank;
    first_part_.reserve(corners_.size() + 1);
    for (std::uint32_t t = 0; t <= corners_.size(); ++t) first_part_.push_back(first_cut_[t] + t);
  }

  // Across each edge, part by part: what crosses the edge cuts the triangles on both sides.
  void glue(UnionFind& parts, const Heard& heard) const {
    for (HalfEdge h = 0; h < across_.size(); ++h) {
      hear_at(heard, h, across_.size());
      if (across_[h] < h) continue;
      const std::uint32_t here = h / 3;
      const std::uint32_t there = across_[h] / 3;
      const auto [low, high] = std::minmax({rank_at(h), rank_at(next_in_triangle(h))});
      const std::uint32_t first_here = cuts_up_to(here, low);
      const std::uint32_t first_there = cuts_up_to(there, low);
      const std::uint32_t within = cuts_up_to(here, high - 1) - first_here;
      if (cuts_up_to(there, high - 1) - first_there != within) throw Bug("a level curve ends at an edge");
      for (std::uint32_t i = 0; i <= within; ++i)
        parts.join(first_part_[here] + first_here + i, first_part_[there] + first_there + i);
    }
  }

  // The ranks between which a triangle's part lies.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ranks_of(std::uint32_t triangle,
                                                                 std::uint32_t part) const {
    const std::uint32_t cut = part - triangle;  // the one above it
    return {cut == first_cut_[triangle] ? corners_[triangle].low : cuts_[cut - 1],
            cut == first_cut_[triangle + 1] ? corners_[triangle].high : cuts_[cut]};
  }

  // Calls visit(triangle, part, ranks) for all.
  template <class Visit>
  void for_each_part(Visit visit) const {
    for (std::uint32_t t = 0; t < corners_.size(); ++t)
      for (std::uint32_t part = first_part_[t]; part < first_part_[t + 1]; ++part)
        visit(t, part, ranks_of(t, part));
  }

  // Numbers the tubes by the nodes that they begin at, those of one node by the first of the triangles that they have
  // below the next node. Returns the tube of each part.
  std::vector<std::uint32_t> find_ends(UnionFind& parts, TubeGraph& graph) const {
    struct Found {
      std::int32_t bottom = no_node, top = no_node;
      std::uint32_t triangle = no_vertex, part = 0;
    };
    std::vector<Found> found(first_part_.back());
    const auto meet = [](std::int32_t& end, std::int32_t node) {
      if (node != no_node && end != no_node && end != node) throw Bug("a tube has two ends on one side");
      if (node != no_node) end = node;
    };
    for_each_part([&](std::uint32_t, std::uint32_t part, const auto& ranks) {
      Found& tube = found[parts.find(part)];
      meet(tube.bottom, node_at_[ranks.first]);
      meet(tube.top, node_at_[ranks.second]);
    });
    hear(heard_, 0.6);
    for_each_part([&](std::uint32_t t, std::uint32_t part, const auto& ranks) {
      Found& tube = found[parts.find(part)];
      tube.part = parts.find(part);
      if (tube.bottom == no_node || tube.top == no_node) throw Bug("a tube has no end");
      const GraphNode& next = nodes_[static_cast<std::size_t>(tube.bottom) + 1];
      if (ranks.first < surface_.rank[next.vertex]) tube.triangle = std::min(tube.triangle, t);
    });
    found.erase(
        std::remove_if(found.begin(), found.end(), [](const Found& tube) { return tube.top == no_node; }),
        found.end());
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
      return std::tie(a.bottom, a.triangle) < std::tie(b.bottom, b.triangle);
    });
    std::vector<std::uint32_t> tube_of_part(first_part_.back());
    for (std::uint32_t i = 0; i < found.size(); ++i) {
      graph.tubes.push_back({found[i].bottom, found[i].top});
      graph.nodes[static_cast<std::size_t>(found[i].bottom)].above.push_back(static_cast<std::int32_t>(i));
      graph.nodes[static_cast<std::size_t>(found[i].top)].below.push_back(static_cast<std::int32_t>(i));
      tube_of_part[found[i].part] = i;
    }
    for (std::uint32_t part = 0; part < tube_of_part.size(); ++part)
      tube_of_part[part] = tube_of_part[parts.find(part)];
    return tube_of_part;
  }

  // Dealt out by `low`, then by tube: each time those that come first stay first, so within a tube pieces rise by `low`, and
  // of one rank by triangle. O(parts + ranks).
  void write_pieces(const std::vector<std::uint32_t>& tube_of_part, TubeGraph& graph) const {
    struct Part {
      TubePiece piece;
      std::uint32_t tube;
    };
    std::vector<std::uint32_t> next(surface_.rank.size() + 1, 0);
    for_each_part([&](std::uint32_t, std::uint32_t, const auto& ranks) { ++next[ranks.first + 1]; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Part> rising(tube_of_part.size());
    for_each_part([&](std::uint32_t t, std::uint32_t part, const auto& ranks) {
      rising[next[ranks.first]++] = {{t, ranks.first, ranks.second}, tube_of_part[part]};
    });
    hear(heard_, 0.9);
    graph.first_piece.assign(graph.tubes.size() + 1, 0);
    for (const Part& part : rising) ++graph.first_piece[part.tube + 1];
    std::partial_sum(graph.first_piece.begin(), graph.first_piece.end(), graph.first_piece.begin());
    next.assign(graph.first_piece.begin(), graph.first_piece.end() - 1);
    graph.pieces.resize(rising.size());
    for (const Part& part : rising) graph.pieces[next[part.tube]++] = part.piece;
  }

  const MorseSurface& surface_;
  const Heard& heard_;
  const std::vector<HalfEdge> worked_out_;
  const std::vector<HalfEdge>& across_;
  std::vector<CornerRanks> corners_;   // of each triangle
  std::vector<std::int32_t> node_at_;  // of each rank
  std::vector<GraphNode> nodes_;       // without tubes
  // The ranks of the curves that cut triangle t, rising: cuts_[first_cut_[t] .. first_cut_[t + 1]). Its parts, one
  // more, are numbered from first_part_[t] on, from below.
  std::vector<std::uint32_t> cuts_, first_cut_, first_part_;
};

void check_graph(const TubeGraph& graph) {
  std::int64_t euler = 0;
  for (const GraphNode& node : graph.nodes) {
    const std::size_t below = node.below.size();
    const std::size_t above = node.above.size();
    if (below + above != 1 && (below + above != 3 || below == 0 || above == 0))
      throw Bug("a node of the graph of tubes is of no kind");
    euler += below + above == 1 ? 1 : -1;
  }
  UnionFind parts(graph.nodes.size());
  std::size_t joined = 1;
  for (const GraphTube& tube : graph.tubes)
    if (parts.join(static_cast<std::uint32_t>(tube.bottom), static_cast<std::uint32_t>(tube.top))) ++joined;
  if (joined != graph.nodes.size()) throw Bug("a graph of tubes is of several surfaces");
  if (2 * std::int64_t{graph.loops()} != 2 - euler)
    throw Bug("a graph of tubes has not as many loops as the surface");
}

}  // namespace

TubeGraph find_tubes(MorseSurface surface, const Heard& heard) {
  TubeGraph graph;
  graph.surface = std::move(surface);
  TubeCutter(graph.surface, heard).write_to(graph);
  graph.surface.across = {};
  check_graph(graph);
  return graph;
}

}  // namespace knit
