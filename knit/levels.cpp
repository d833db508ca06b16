#include "knit/levels.h"

#include <algorithm>
#include <numeric>

namespace knit {

namespace {

// Times with ties broken by index, so that no two corners of a triangle are equal.
struct Order {
  const Input& input;
  const std::vector<double>& times;
  [[nodiscard]] bool below(VertexId a, VertexId b) const {
    const VertexId at = input.twin[a];
    const VertexId bt = input.twin[b];
    return times[at] != times[bt] ? times[at] < times[bt] : at < bt;
  }
};

bool collapsed(const Input& input, const Triangle& t) {
  return input.twin[t[0]] == input.twin[t[1]] || input.twin[t[1]] == input.twin[t[2]] ||
         input.twin[t[2]] == input.twin[t[0]];
}

// Vertices at which a level set changes its number of loops, were ties really broken by index: minima,
// saddles, maxima.
std::vector<VertexId> critical_vertices(const Input& input, const std::vector<double>& times) {
  const Order order{input, times};
  std::vector<std::uint32_t> middles(times.size(), 0);
  for (const Triangle& t : input.mesh.triangles) {
    if (collapsed(input, t)) continue;
    VertexId low = t[0];
    VertexId middle = t[1];
    VertexId high = t[2];
    if (order.below(middle, low)) std::swap(low, middle);
    if (order.below(high, middle)) std::swap(middle, high);
    if (order.below(middle, low)) std::swap(low, middle);
    ++middles[input.twin[middle]];
  }
  std::vector<VertexId> critical;
  for (VertexId v = 0; v < times.size(); ++v) {
    if (input.twin[v] == v && input.referenced[v] != 0 && middles[v] != 2) critical.push_back(v);
  }
  return critical;
}

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

Levels group_levels(const Input& input, const std::vector<double>& times, double tolerance) {
  std::vector<std::pair<double, VertexId>> sorted;
  sorted.reserve(times.size());
  for (VertexId v = 0; v < times.size(); ++v) {
    if (input.referenced[v] != 0) sorted.emplace_back(times[v], v);
  }
  // Many files list their vertices from one end to the other; then there is nothing to sort.
  if (!std::is_sorted(sorted.begin(), sorted.end())) std::sort(sorted.begin(), sorted.end());

  Levels levels;
  levels.vertices.reserve(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i].first - sorted[i - 1].first > tolerance) {
      levels.begin.push_back(static_cast<std::uint32_t>(i));
      levels.times.push_back(sorted[i].first);
    }
    levels.vertices.push_back(sorted[i].second);
  }
  levels.begin.push_back(static_cast<std::uint32_t>(sorted.size()));
  for (std::size_t i = 0; i < levels.times.size(); ++i) {
    const auto first = levels.vertices.begin() + levels.begin[i];
    const auto last = levels.vertices.begin() + levels.begin[i + 1];
    if (!std::is_sorted(first, last)) std::sort(first, last);
  }
  levels.split = find_split(input, times, levels);
  return levels;
}

std::int32_t count_loops(const Input& input, const std::vector<double>& times, double time) {
  // Crossed triangles that share a crossed edge belong to the same loop.
  struct Crossing {
    std::array<VertexId, 2> edge;
    std::size_t triangle;
  };
  std::vector<Crossing> crossings;
  std::size_t crossed = 0;
  for (const Triangle& t : input.mesh.triangles) {
    if (collapsed(input, t)) continue;
    bool any = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = input.twin[t[i]];
      const VertexId b = input.twin[t[(i + 1) % 3]];
      if ((times[a] < time) == (times[b] < time)) continue;
      crossings.push_back({{std::min(a, b), std::max(a, b)}, crossed});
      any = true;
    }
    if (any) ++crossed;
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.edge < b.edge; });
  UnionFind loops(crossed);
  std::int32_t count = static_cast<std::int32_t>(crossed);
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    if (crossings[i].edge != crossings[i - 1].edge) continue;
    if (loops.find(crossings[i].triangle) == loops.find(crossings[i - 1].triangle)) continue;
    loops.join(crossings[i].triangle, crossings[i - 1].triangle);
    --count;
  }
  return count;
}

std::optional<Split> find_split(const Input& input, const std::vector<double>& times, const Levels& levels) {
  std::vector<VertexId> critical = critical_vertices(input, times);
  if (critical.size() <= 2) return std::nullopt;  // one minimum, one maximum: a single tube
  std::sort(critical.begin(), critical.end(), [&](VertexId a, VertexId b) { return times[a] < times[b]; });

  std::int32_t looked_at = -1;
  for (const VertexId vertex : critical) {
    const auto above = std::upper_bound(levels.times.begin(), levels.times.end(), times[vertex]);
    const auto level = static_cast<std::int32_t>(above - levels.times.begin()) - 1;
    if (above == levels.times.end() || level == looked_at) continue;
    looked_at = level;
    double highest = levels.times[static_cast<std::size_t>(level)];
    for (const VertexId v : levels.level(level)) highest = std::max(highest, times[v]);
    const std::int32_t loops = count_loops(input, times, 0.5 * (highest + *above));
    if (loops > 1) return Split{level, loops, vertex, times[vertex]};
  }
  return std::nullopt;
}

}  // namespace knit
