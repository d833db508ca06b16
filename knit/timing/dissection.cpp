#include "knit/timing/dissection.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

#include "knit/mesh/ranking.h"

namespace knit {

namespace {

// So few are ordered as they come.
constexpr std::size_t smallest_part = 8;

// Along the axes and the diagonals of the planes between them; the best cut is taken.
constexpr std::array<glm::dvec3, 9> directions{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {0, 1, 1}, {0, 1, -1}, {1, 0, 1}, {-1, 0, 1}}};

using Vertices = std::vector<VertexId>;

// No edge leads from `low` to `high`.
struct Cut {
  Vertices low, high, between;
};

class Dissection {
 public:
  // Of so many vertices, that are halved again and again.
  Dissection(const Spokes& spokes, std::span<const glm::dvec3> positions, std::size_t vertices,
             const Heard& heard)
      : spokes_(spokes), positions_(positions), side_(positions.size(), 0), heard_(heard) {
    std::size_t levels = 0;
    for (std::size_t part = vertices; part > smallest_part; part /= 2) ++levels;
    expected_ = directions.size() * vertices * levels;
  }

  // Appends the order of these vertices. As deep as the vertices can be halved.
  void append_order(const Vertices& vertices, Vertices& order) {
    if (vertices.size() <= smallest_part) {
      order.insert(order.end(), vertices.begin(), vertices.end());
      return;
    }
    const Cut cut = smallest_cut(vertices);
    append_order(cut.low, order);
    append_order(cut.high, order);
    order.insert(order.end(), cut.between.begin(), cut.between.end());
  }

 private:
  using Keyed = std::vector<std::pair<double, VertexId>>;

  // A plane's halves: those below `middle` in this order, and the rest.
  struct Halves {
    Keyed keyed;
    std::pair<double, VertexId> middle;
    std::uint32_t low_side = 0,
                  high_side = 0;  // numbers used once, so that vertices of other parts are in neither
    [[nodiscard]] bool is_low(const std::pair<double, VertexId>& key) const { return key < middle; }
  };

  Halves halve(const Vertices& vertices, const glm::dvec3& direction) {
    Halves halves{{}, {}, sides_ + 1, sides_ + 2};
    sides_ += 2;
    halves.keyed.reserve(vertices.size());
    for (const VertexId v : vertices) halves.keyed.emplace_back(glm::dot(direction, positions_[v]), v);
    ranked_ = halves.keyed;
    put_least_first(std::span(ranked_), ranked_.size() / 2, std::less<>());
    halves.middle = ranked_[ranked_.size() / 2];
    mark(halves);
    return halves;
  }

  // Before so many vertices are looked at.
  void say(std::size_t vertices) {
    constexpr std::size_t rarely = 1 << 15;
    seen_ += vertices;
    if (seen_ - said_ < rarely) return;
    hear(heard_, std::min(1.0, static_cast<double>(said_) / static_cast<double>(expected_)));
    said_ = seen_;
  }

  void mark(const Halves& halves) {
    for (const auto& key : halves.keyed)
      side_[key.second] = halves.is_low(key) ? halves.low_side : halves.high_side;
  }

  // How many of each half, low and high, are beside the other.
  [[nodiscard]] std::array<std::size_t, 2> beside_each_other(const Halves& halves) const {
    std::array<std::size_t, 2> counts{};
    for (const auto& key : halves.keyed) {
      const bool low = halves.is_low(key);
      if (touches(key.second, low ? halves.high_side : halves.low_side)) ++counts[low ? 0 : 1];
    }
    return counts;
  }

  // The vertices between are those of one half beside the other, of the half that has fewer of them.
  Cut smallest_cut(const Vertices& vertices) {
    Halves best;
    std::array<std::size_t, 2> fewest{vertices.size() + 1, vertices.size() + 1};
    for (const glm::dvec3& direction : directions) {
      say(vertices.size());
      Halves halves = halve(vertices, direction);
      const std::array<std::size_t, 2> counts = beside_each_other(halves);
      if (std::min(counts[0], counts[1]) >= std::min(fewest[0], fewest[1])) continue;
      fewest = counts;
      best = std::move(halves);
    }
    mark(best);
    return cut(best, fewest[0] <= fewest[1]);
  }

  [[nodiscard]] Cut cut(const Halves& halves, bool from_low) const {
    Cut cut;
    for (const auto& key : halves.keyed) {
      const VertexId v = key.second;
      const bool low = halves.is_low(key);
      const bool between = low == from_low && touches(v, low ? halves.high_side : halves.low_side);
      (between ? cut.between : low ? cut.low : cut.high).push_back(v);
    }
    return cut;
  }

  [[nodiscard]] bool touches(VertexId v, std::uint32_t side) const {
    const std::span<const Spoke> around = spokes_.at(v);
    return std::any_of(around.begin(), around.end(),
                       [&](const Spoke& spoke) { return side_[spoke.end] == side; });
  }

  const Spokes& spokes_;
  std::span<const glm::dvec3> positions_;
  std::vector<std::uint32_t> side_;
  std::uint32_t sides_ = 0;
  Keyed ranked_;  // kept for its memory
  const Heard& heard_;
  std::size_t expected_ = 0, seen_ = 0, said_ = 0;  // vertices, once for each direction
};

}  // namespace

std::vector<VertexId> order_by_dissection(const Spokes& spokes, std::span<const glm::dvec3> positions,
                                          const Heard& heard) {
  Vertices vertices;
  for (VertexId v = 0; v < positions.size(); ++v)
    if (!spokes.at(v).empty()) vertices.push_back(v);
  Vertices order;
  order.reserve(vertices.size());
  Dissection(spokes, positions, vertices.size(), heard).append_order(vertices, order);
  return order;
}

}  // namespace knit
