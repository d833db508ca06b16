#include "knit/timing/levels.h"

#include <algorithm>
#include <functional>

#include "knit/model/heard_sort.h"
#include "knit/timing/critical.h"

namespace knit {

Levels group_levels(const Input& input, const std::vector<double>& times, const Criticals& criticals,
                    double tolerance, const Heard& heard) {
  std::vector<std::pair<double, VertexId>> sorted;
  sorted.reserve(times.size());
  for (VertexId v = 0; v < times.size(); ++v) {
    if (input.referenced[v] != 0) sorted.emplace_back(times[v], v);
  }
  // Many files list their vertices from one end to the other; then there is nothing to sort.
  sort_heard(sorted, std::less<>(), part_of(heard, 0.0, 0.6));
  hear(heard, 0.6);

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
  hear(heard, 0.9);
  levels.split = find_split(input, times, criticals, levels, part_of(heard, 0.9, 1.0));
  return levels;
}

}  // namespace knit
