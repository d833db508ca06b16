#include "knit/tubes/simplify.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "knit/mesh/union_find.h"
#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr double above_event = 0.25;  // rows
constexpr double beside_pole = 1.0;
constexpr double on_rim = 0.0;
constexpr double least_girth = 2.5;         // stitches: what rounds to three
constexpr double least_handle_girth = 1.5;  // stitches
constexpr double plateau_share = 0.06;      // of the usual slope
constexpr double most_that_fit = 1e6;       // of a tube: callers refuse far fewer

// The field's rise over height: the median over all tubes, weighted by height.
double usual_slope(std::span<const GraphNode> nodes, std::span<const GraphTube> tubes,
                   std::span<const TubeSize> sizes) {
  struct Weighted {
    double slope, height;
  };
  std::vector<Weighted> slopes;
  double whole = 0.0;
  for (std::size_t i = 0; i < tubes.size(); ++i) {
    const double height = sizes[i].height;
    if (height <= 0.0) continue;
    const double rise = nodes[static_cast<std::size_t>(tubes[i].top)].value -
                        nodes[static_cast<std::size_t>(tubes[i].bottom)].value;
    slopes.push_back({rise / height, height});
    whole += height;
  }
  std::stable_sort(slopes.begin(), slopes.end(),
                   [](const Weighted& a, const Weighted& b) { return a.slope < b.slope; });
  double sum = 0.0;
  for (const Weighted& tube : slopes) {
    sum += tube.height;
    if (!clearly_less(sum, 0.5 * whole, whole)) return tube.slope;
  }
  return 1.0;
}

// Chains are numbered by their first part until the end; of one that is gone `parts` is empty.
class Simplifier {
 public:
  Simplifier(std::span<const GraphNode> nodes, std::span<const GraphTube> tubes,
             std::span<const TubeSize> sizes, const TubeSettingsNow& settings)
      : settings_(settings), slope_(usual_slope(nodes, tubes, sizes)) {
    graph_.nodes.assign(nodes.begin(), nodes.end());
    for (std::size_t i = 0; i < tubes.size(); ++i)
      graph_.chains.push_back(
          {{static_cast<std::int32_t>(i)}, tubes[i].bottom, tubes[i].top, sizes[i].height, sizes[i].longest});
  }

  SimpleGraph run() {
    while (true) {
      if (const auto limb = smallest_limb()) {
        leave_out(*limb, false);
      } else if (const auto handle = smallest_handle()) {
        leave_out(*handle, true);
      } else {
        break;
      }
    }
    renumber();
    give_rows();
    return std::move(graph_);
  }

 private:
  [[nodiscard]] TubeChain& chain(TubeId id) { return graph_.chains[static_cast<std::size_t>(id)]; }
  [[nodiscard]] GraphNode& node(std::int32_t id) { return graph_.nodes[static_cast<std::size_t>(id)]; }
  [[nodiscard]] NodeKind kind(std::int32_t node) const { return graph_.node(node).kind(); }
  [[nodiscard]] RowOffsets offsets(const TubeChain& chain) const {
    return row_offsets(graph_.node(chain.bottom), graph_.node(chain.top));
  }
  [[nodiscard]] bool is_leaf(const TubeChain& chain) const {
    return (kind(chain.bottom) == NodeKind::minimum) != (kind(chain.top) == NodeKind::maximum);
  }
  // Nearly flat: its curves are noise.
  [[nodiscard]] bool is_plateau(const TubeChain& chain) const {
    const double rise = graph_.node(chain.top).value - graph_.node(chain.bottom).value;
    return is_leaf(chain) &&
           clearly_less(rise, plateau_share * slope_ * chain.height, slope_ * settings_.height);
  }
  // Rows that the chain must have room for, or it gets none.
  [[nodiscard]] std::int32_t least_rows(const TubeChain& chain) const {
    const std::int32_t least = is_leaf(chain) ? std::max(settings_.smallest_limb, 1) : 1;
    return is_plateau(chain) ? std::max(least, 2) : least;
  }
  [[nodiscard]] std::int32_t wanted(const TubeChain& chain) const {
    if (clearly_less(chain.longest, least_girth * settings_.width, settings_.width)) return 0;
    const std::int32_t least = least_rows(chain);
    const std::int32_t rows = rows_that_fit(chain.height, offsets(chain), settings_.height);
    if (rows >= least) return rows;
    return clearly_less(chain.height, rows_high(chain) * settings_.height, settings_.height) ? 0 : least;
  }
  // How high it must be for its least rows, in stitches' heights. A limb is as well off with its one row too near to what is
  // beside it as without one too far from it: by the ratio, not by the difference.
  [[nodiscard]] double rows_high(const TubeChain& chain) const {
    const std::int32_t least = least_rows(chain);
    const double more = offsets(chain).more();
    return is_leaf(chain) && least == 1 ? std::sqrt(more * (1.0 + more)) : least - 0.5 + more;
  }
  // Of a stitch as high by its width as the one that is set.
  [[nodiscard]] double width_that_keeps(const TubeChain& chain) const {
    return std::min(chain.longest / least_girth,
                    chain.height / rows_high(chain) * (settings_.width / settings_.height));
  }

  // A rowless leaf whose other end would become regular: the least height x girth.
  [[nodiscard]] std::optional<TubeId> smallest_limb() const {
    std::optional<TubeId> found;
    double least = 0.0;
    for (std::size_t i = 0; i < graph_.chains.size(); ++i) {
      const TubeChain& chain = graph_.chains[i];
      if (chain.parts.empty() || wanted(chain) > 0) continue;
      const NodeKind bottom = kind(chain.bottom);
      const NodeKind top = kind(chain.top);
      if (!(bottom == NodeKind::minimum && top == NodeKind::join) &&
          !(top == NodeKind::maximum && bottom == NodeKind::split))
        continue;
      const double size = chain.height * chain.longest;
      if (found && !clearly_less(size, least, settings_.width * settings_.height)) continue;
      found = static_cast<TubeId>(i);
      least = size;
    }
    return found;
  }

  // Whether the rest stays in one piece without it.
  [[nodiscard]] bool is_in_ring(TubeId id) const {
    UnionFind nodes(graph_.nodes.size());
    for (std::size_t i = 0; i < graph_.chains.size(); ++i) {
      const TubeChain& other = graph_.chains[i];
      if (!other.parts.empty() && static_cast<TubeId>(i) != id)
        nodes.join(static_cast<std::uint32_t>(other.bottom), static_cast<std::uint32_t>(other.top));
    }
    return nodes.find(static_cast<std::uint32_t>(graph_.chain(id).bottom)) ==
           nodes.find(static_cast<std::uint32_t>(graph_.chain(id).top));
  }

  // The lowest rowless tube from a split to a join that closes a ring with rowless tubes no higher, or is too thin.
  [[nodiscard]] std::optional<TubeId> smallest_handle() const {
    std::vector<TubeId> rowless;
    for (std::size_t i = 0; i < graph_.chains.size(); ++i) {
      if (!graph_.chains[i].parts.empty() && wanted(graph_.chains[i]) == 0)
        rowless.push_back(static_cast<TubeId>(i));
    }
    sort_by_rule(
        rowless, [&](TubeId id) { return graph_.chain(id).height; }, settings_.height);
    UnionFind nodes(graph_.nodes.size());
    for (const TubeId id : rowless) {
      const TubeChain& chain = graph_.chain(id);
      const bool closes =
          !nodes.join(static_cast<std::uint32_t>(chain.bottom), static_cast<std::uint32_t>(chain.top));
      const bool thin = clearly_less(chain.longest, least_handle_girth * settings_.width, settings_.width);
      if (kind(chain.bottom) == NodeKind::split && kind(chain.top) == NodeKind::join &&
          (closes || (thin && is_in_ring(id))))
        return id;
    }
    return std::nullopt;
  }

  void leave_out(TubeId id, bool handle) {
    TubeChain& gone = chain(id);
    // A limb of no size is what rounding makes of a flat part: nobody misses it.
    const bool is_there = handle || clearly_less(0.0, gone.height, settings_.height) ||
                          clearly_less(0.0, gone.longest, settings_.width);
    if (is_there)
      graph_.left_out.push_back({handle, gone.height, gone.longest, graph_.node(gone.bottom).vertex,
                                 graph_.node(gone.top).vertex, width_that_keeps(gone)});
    gone.parts.clear();
    std::erase(node(gone.bottom).above, id);
    std::erase(node(gone.top).below, id);
    make_regular(gone.bottom);
    make_regular(gone.top);
  }

  // Where one tube is left below and one above, they are one.
  void make_regular(std::int32_t at) {
    GraphNode& between = node(at);
    if (between.below.size() != 1 || between.above.size() != 1) return;
    TubeChain& lower = chain(between.below.front());
    TubeChain& upper = chain(between.above.front());
    std::vector<std::int32_t>& ends = node(upper.top).below;
    std::replace(ends.begin(), ends.end(), between.above.front(), between.below.front());
    std::sort(ends.begin(), ends.end());
    lower.parts.insert(lower.parts.end(), upper.parts.begin(), upper.parts.end());
    lower.top = upper.top;
    lower.height += upper.height;
    lower.longest = std::max(lower.longest, upper.longest);
    upper.parts.clear();
    between.below.clear();
    between.above.clear();
  }

  void renumber() {
    std::vector<TubeId> number(graph_.chains.size(), 0);
    std::vector<TubeChain> kept;
    for (std::size_t i = 0; i < graph_.chains.size(); ++i) {
      number[i] = static_cast<TubeId>(kept.size());
      if (!graph_.chains[i].parts.empty()) kept.push_back(std::move(graph_.chains[i]));
    }
    graph_.chains = std::move(kept);
    for (GraphNode& at : graph_.nodes) {
      for (TubeId& id : at.below) id = number[static_cast<std::size_t>(id)];
      for (TubeId& id : at.above) id = number[static_cast<std::size_t>(id)];
    }
  }

  void give_rows() {
    for (TubeChain& chain : graph_.chains) chain.rows = wanted(chain);
    const auto all_have_rows = [&](const std::vector<TubeId>& ids) {
      return std::all_of(ids.begin(), ids.end(), [&](TubeId id) { return graph_.chain(id).rows > 0; });
    };
    for (TubeChain& chain : graph_.chains) {
      if (chain.rows > 0) continue;
      const bool starts =
          kind(chain.bottom) == NodeKind::minimum &&
          !(kind(chain.top) == NodeKind::split && all_have_rows(graph_.node(chain.top).above));
      const bool ends =
          kind(chain.top) == NodeKind::maximum &&
          !(kind(chain.bottom) == NodeKind::join && all_have_rows(graph_.node(chain.bottom).below));
      if (!starts && !ends) continue;
      chain.rows = 1;
      chain.forced = true;
    }
  }

  const TubeSettingsNow settings_;
  const double slope_;
  SimpleGraph graph_;
};

}  // namespace

bool SimpleGraph::is_kept(std::int32_t id) const {
  return !node(id).below.empty() || !node(id).above.empty();
}

EventKind SimpleGraph::kind_of(std::int32_t id) const {
  const GraphNode& at = node(id);
  switch (at.kind()) {
    case NodeKind::minimum:
      return EventKind::cast_on;
    case NodeKind::maximum:
      return EventKind::bind_off;
    case NodeKind::split: {
      const TubeChain& foot = chain(at.below.front());
      const bool ring = foot.rows == 0 && node(foot.bottom).kind() == NodeKind::minimum;
      return ring ? EventKind::ring_cast_on : EventKind::split;
    }
    case NodeKind::join:
      break;
  }
  const TubeChain& head = chain(at.above.front());
  const bool ring = head.rows == 0 && node(head.top).kind() == NodeKind::maximum;
  return ring ? EventKind::ring_bind_off : EventKind::join;
}

SimpleGraph simplify_tubes(std::span<const GraphNode> nodes, std::span<const GraphTube> tubes,
                           std::span<const TubeSize> sizes, const TubeSettingsNow& settings) {
  return Simplifier(nodes, tubes, sizes, settings).run();
}

RowOffsets row_offsets(const GraphNode& bottom, const GraphNode& top) {
  const auto beside_end = [](const GraphNode& end) { return end.rim ? on_rim : beside_pole; };
  return {bottom.kind() == NodeKind::minimum ? beside_end(bottom) : above_event,
          top.kind() == NodeKind::maximum ? beside_end(top) : 1.0 - above_event};
}

std::int32_t rows_that_fit(double height, const RowOffsets& offsets, double stitch_height) {
  return static_cast<std::int32_t>(
      std::clamp(rounded(height / stitch_height - offsets.more()), 0.0, most_that_fit));
}

}  // namespace knit
