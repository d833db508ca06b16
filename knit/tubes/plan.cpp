#include "knit/tubes/plan.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <iterator>

#include "knit/model/ties.h"
#include "knit/tubes/simplify.h"
#include "knit/tubes/twins.h"

namespace knit {

namespace {

constexpr double beside_ring = 0.5;  // rows

double value_at_height(const TubeProfile& profile, double height) {
  const auto above = std::upper_bound(profile.heights.begin(), profile.heights.end(), height);
  if (above == profile.heights.begin()) return profile.values.front();
  if (above == profile.heights.end()) return profile.values.back();
  const auto i = static_cast<std::size_t>(above - profile.heights.begin());
  const double share = (height - profile.heights[i - 1]) / (profile.heights[i] - profile.heights[i - 1]);
  return profile.values[i - 1] + share * (profile.values[i] - profile.values[i - 1]);
}

// Of one row on an open edge, which leaves no height to share out: the whole.
double spacing_of(double height, double steps) { return steps > 0.0 ? height / steps : height; }

Shared<Ring> ring_at(const TubeGraph& graph, std::int32_t part, double value) {
  Ring ring;
  ring.ordered_by = OrderedBy::cut;
  ring.points = curve_at(graph, part, value);
  measure_arcs(ring);
  return Shared<Ring>(std::move(ring));
}

// What is left of a triangle in the level set at a value, and which way is out.
struct CutTriangle {
  glm::dvec3 from, to, outward;  // outward: a unit vector, or zero of a triangle without area
};
CutTriangle cut_triangle(const MorseSurface& surface, const Triangle& triangle, double value) {
  std::array<glm::dvec3, 3> p{};
  std::array<double, 3> v{};
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = surface.positions[triangle[k]];
    v[k] = surface.values[triangle[k]];
  }
  std::array<glm::dvec3, 2> ends{p[0], p[0]};
  std::size_t found = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if ((v[k] <= value) == (v[next] <= value) || found == 2) continue;
    ends[found++] = p[k] + (value - v[k]) / (v[next] - v[k]) * (p[next] - p[k]);
  }
  const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double doubled_area = glm::length(normal);
  return {ends[0], ends[1], doubled_area > 0.0 ? normal / doubled_area : glm::dvec3{0.0}};
}

// Whether the outward normals along the rows' curves face the curves' middles rather than away from them.
bool is_inner(const TubeGraph& graph, const Tube& tube, const Heard& heard) {
  std::vector<glm::dvec3> centres;
  double scale = 0.0;
  for (const Shared<Ring>& curve : tube.curves) {
    centres.push_back(centre_of(*curve));
    scale += curve->length * curve->length;
  }
  double sum = 0.0;
  auto first = tube.values.begin();  // not below the piece; pieces rise, so it is found from the last one on
  for (const std::int32_t part : tube.parts) {
    const auto id = static_cast<std::size_t>(part);
    for (std::uint32_t i = graph.first_piece[id]; i < graph.first_piece[id + 1]; ++i) {
      hear_at(heard, i, graph.pieces.size());
      const TubePiece& piece = graph.pieces[i];
      const Triangle& triangle = graph.surface.triangles[piece.triangle];
      const auto& values = graph.surface.values;
      const double from = values[graph.surface.by_rank[piece.low]];
      const double to = values[graph.surface.by_rank[piece.high]];
      while (first != tube.values.begin() && *std::prev(first) >= from) --first;
      while (first != tube.values.end() && *first < from) ++first;
      for (auto value = first; value != tube.values.end() && *value < std::max(from, to); ++value) {
        const CutTriangle cut = cut_triangle(graph.surface, triangle, *value);
        const glm::dvec3& centre = centres[static_cast<std::size_t>(value - tube.values.begin())];
        sum += glm::distance(cut.from, cut.to) * glm::dot(cut.outward, 0.5 * (cut.from + cut.to) - centre);
      }
    }
  }
  return clearly_less(sum, 0.0, scale);
}

class TubePlanner {
 public:
  TubePlanner(const TubeGraph& graph, const TubeSettingsNow& settings, const Heard& heard)
      : graph_(graph), settings_(settings), heard_(heard) {
    std::vector<TubeSize> sizes;
    for (std::size_t i = 0; i < graph.tubes.size(); ++i) {
      const auto share = [&](std::size_t tube) {
        return 0.7 * static_cast<double>(graph.first_piece[tube]) / static_cast<double>(graph.pieces.size());
      };
      profiles_.push_back(
          profile_of(graph, static_cast<std::int32_t>(i), part_of(heard, share(i), share(i + 1))));
      sizes.push_back({profiles_.back().height(), profiles_.back().longest()});
    }
    simple_ = simplify_tubes(graph.nodes, graph.tubes, sizes, settings);
    twins_ = match_twins(simple_, profiles_, settings.height);
  }

  TubePlan run() {
    plan_.stitch_width = settings_.width;
    plan_.stitch_height = settings_.height;
    for (LeftOut left_out : simple_.left_out) {
      left_out.from = graph_.surface.origin[left_out.from];
      left_out.to = graph_.surface.origin[left_out.to];
      plan_.left_out.push_back(left_out);
    }
    std::vector<std::int32_t> event_at(simple_.nodes.size(), 0);
    for (std::size_t i = 0; i < simple_.nodes.size(); ++i) {
      const auto id = static_cast<std::int32_t>(i);
      if (!simple_.is_kept(id)) continue;
      event_at[i] = static_cast<std::int32_t>(plan_.events.size());
      plan_.events.push_back(event_of(id));
    }
    for (std::size_t i = 0; i < simple_.chains.size(); ++i) {
      Tube tube = tube_of(simple_.chains[i]);
      tube.bottom = event_at[static_cast<std::size_t>(tube.bottom)];
      tube.top = event_at[static_cast<std::size_t>(tube.top)];
      tube.twins = twins_[i];
      plan_.tubes.push_back(std::move(tube));
    }
    for (Tube& tube : plan_.tubes) share_lengths(tube);
    return renumbered(plan_, order_tubes(plan_.tubes, plan_.events));
  }

 private:
  [[nodiscard]] const TubeProfile& profile(std::int32_t part) const {
    return profiles_[static_cast<std::size_t>(part)];
  }

  [[nodiscard]] TubeEvent event_of(std::int32_t id) const {
    const GraphNode& node = simple_.node(id);
    return {simple_.kind_of(id),
            id,
            graph_.surface.origin[node.vertex],
            graph_.surface.positions[node.vertex],
            node.value,
            node.below,
            node.above,
            node.rim};
  }

  // Its ends still as nodes.
  [[nodiscard]] Tube tube_of(const TubeChain& chain) const {
    Tube tube;
    tube.parts = chain.parts;
    tube.bottom = chain.bottom;
    tube.top = chain.top;
    tube.height = chain.height;
    tube.longest = chain.longest;
    tube.forced = chain.forced;
    cut_rows(chain, tube);
    tube.lowest = tube.curves.empty() ? middle_curve(chain) : tube.curves.front();
    tube.inner = is_inner(graph_, tube, part_of(heard_, 0.7, 0.7));
    return tube;
  }

  void cut_rows(const TubeChain& chain, Tube& tube) const {
    if (chain.rows == 0) return;
    const EventKind bottom = simple_.kind_of(chain.bottom);
    const EventKind top = simple_.kind_of(chain.top);
    RowOffsets offsets = row_offsets(simple_.node(chain.bottom), simple_.node(chain.top));
    if (bottom == EventKind::ring_cast_on) offsets.low = beside_ring;
    if (top == EventKind::ring_bind_off) offsets.high = beside_ring;
    tube.spacing = spacing_of(chain.height, chain.rows + offsets.more());
    for (std::int32_t row = 0; row < chain.rows; ++row) {
      const ChainPlace place = place_in(chain, profiles_, tube.spacing * (offsets.low + row));
      tube.values.push_back(value_at_height(profile(place.part), place.height));
      tube.curves.push_back(ring_at(graph_, place.part, tube.values.back()));
    }
    if (bottom == EventKind::cast_on && !simple_.node(chain.bottom).rim) pass_over_short(tube);
    if (top == EventKind::bind_off && !simple_.node(chain.top).rim) {
      while (tube.curves.size() > 1 && too_short(*tube.curves.back(), settings_.width)) {
        tube.curves.pop_back();
        tube.values.pop_back();
      }
    }
  }

  // From below; one row is left.
  void pass_over_short(Tube& tube) const {
    std::ptrdiff_t passed = 0;
    while (passed + 1 < tube.rows() &&
           too_short(*tube.curves[static_cast<std::size_t>(passed)], settings_.width))
      ++passed;
    tube.curves.erase(tube.curves.begin(), tube.curves.begin() + passed);
    tube.values.erase(tube.values.begin(), tube.values.begin() + passed);
  }

  // Half way up the values of the highest part.
  [[nodiscard]] Shared<Ring> middle_curve(const TubeChain& chain) const {
    std::int32_t highest = chain.parts.front();
    for (const std::int32_t part : chain.parts) {
      if (clearly_less(profile(highest).height(), profile(part).height(), settings_.height)) highest = part;
    }
    const std::vector<double>& values = profile(highest).values;
    return ring_at(graph_, highest, 0.5 * (values.front() + values.back()));
  }

  // Twins that have as many curves count stitches by the same lengths.
  void share_lengths(Tube& tube) const {
    const bool shared = std::all_of(tube.twins.begin(), tube.twins.end(),
                                    [&](TubeId id) { return plan_.tube(id).rows() == tube.rows(); });
    for (std::size_t row = 0; row < tube.curves.size(); ++row) {
      double sum = 0.0;
      for (const TubeId id : tube.twins) sum += shared ? plan_.tube(id).curves[row]->length : 0.0;
      tube.lengths.push_back(shared ? sum / static_cast<double>(tube.twins.size())
                                    : tube.curves[row]->length);
    }
  }

  const TubeGraph& graph_;
  const TubeSettingsNow settings_;
  const Heard& heard_;
  std::vector<TubeProfile> profiles_;
  SimpleGraph simple_;
  std::vector<std::vector<TubeId>> twins_;
  TubePlan plan_;
};

// An end of a tube as far as rows beside it go: a pole or an open edge, else where tubes part or meet.
GraphNode node_like(const TubeEvent& event) {
  GraphNode node;
  const bool begins = event.kind == EventKind::cast_on, ends = event.kind == EventKind::bind_off;
  if (!begins) node.below.push_back(0);
  if (!ends) node.above.push_back(0);
  if (!begins && !ends) node.above.push_back(1);
  node.rim = event.rim;
  return node;
}

// A tube of a plan, to be given other rows.
class RowChanger {
 public:
  RowChanger(const TubeGraph& graph, const TubePlan& plan, const TubeSettingsNow& settings, const Tube& tube)
      : graph_(graph), settings_(settings), tube_(tube) {
    for (const std::int32_t part : tube.parts) profiles_.push_back(profile_of(graph, part));
    const TubeEvent &below = plan.event(tube.bottom), &above = plan.event(tube.top);
    const EventKind bottom = below.kind, top = above.kind;
    offsets_ = row_offsets(node_like(below), node_like(above));
    if (bottom == EventKind::ring_cast_on) offsets_.low = beside_ring;
    if (top == EventKind::ring_bind_off) offsets_.high = beside_ring;
    drawn_in_ = top == EventKind::bind_off && !above.rim;
  }

  Tube with_rows_above(std::int32_t made) {
    const auto kept = static_cast<std::size_t>(made);
    tube_.values.resize(kept);
    tube_.curves.resize(kept);
    tube_.lengths.resize(kept);
    const double from = made > 0 ? height_of(tube_.values.back()) : 0.0;
    const double left = tube_.height - from;
    const double below =
        made > 0 ? 0.0
                 : offsets_.low - 1.0;  // the first row of a tube stands where it may, the next a row up
    const double rows = std::floor(left / settings_.height - offsets_.high - below + 0.5);
    const auto count = static_cast<std::int32_t>(std::clamp(rows, made > 0 ? 0.0 : 1.0, 1e6));
    tube_.spacing = spacing_of(left, count + offsets_.high + below);
    for (std::int32_t row = 1; row <= count; ++row) add_row(from + tube_.spacing * (row + below));
    while (drawn_in_ && tube_.curves.size() > std::max<std::size_t>(kept, 1) &&
           too_short(*tube_.curves.back(), settings_.width)) {
      tube_.curves.pop_back();
      tube_.values.pop_back();
      tube_.lengths.pop_back();
    }
    return tube_;
  }

 private:
  [[nodiscard]] double height_of(double value) const {
    double below = 0.0;
    for (const TubeProfile& part : profiles_) {
      if (value <= part.values.back() || &part == &profiles_.back()) {
        const auto after = std::upper_bound(part.values.begin(), part.values.end() - 1, value);
        const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - part.values.begin(), 1));
        const double span = part.values[i] - part.values[i - 1];
        const double share = span > 0.0 ? std::clamp((value - part.values[i - 1]) / span, 0.0, 1.0) : 0.0;
        return below + part.heights[i - 1] + share * (part.heights[i] - part.heights[i - 1]);
      }
      below += part.height();
    }
    return below;
  }

  void add_row(double height) {
    std::size_t part = 0;
    for (; part + 1 < profiles_.size() && height > profiles_[part].height(); ++part)
      height -= profiles_[part].height();
    tube_.values.push_back(value_at_height(profiles_[part], height));
    tube_.curves.push_back(ring_at(graph_, tube_.parts[part], tube_.values.back()));
    tube_.lengths.push_back(tube_.curves.back()->length);
  }

  const TubeGraph& graph_;
  const TubeSettingsNow settings_;
  Tube tube_;
  std::vector<TubeProfile> profiles_;
  RowOffsets offsets_;
  bool drawn_in_ = false;
};

}  // namespace

TubePlan replan_rows(const TubeGraph& graph, const TubePlan& plan, const TubeSettingsNow& settings,
                     std::span<const std::int32_t> made) {
  TubePlan planned = plan;
  planned.stitch_width = settings.width;
  planned.stitch_height = settings.height;
  for (std::size_t id = 0; id < plan.tubes.size(); ++id) {
    const Tube& tube = plan.tubes[id];
    const bool done = tube.rows() == 0 || (made[id] > 0 && made[id] == tube.rows());
    if (!done) planned.tubes[id] = RowChanger(graph, plan, settings, tube).with_rows_above(made[id]);
  }
  return planned;
}

TubePlan plan_tubes(const TubeGraph& graph, const TubeSettingsNow& settings, const Heard& heard) {
  return TubePlanner(graph, settings, heard).run();
}

}  // namespace knit
