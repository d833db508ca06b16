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
  Dissection(const Spokes& spokes, std::span<const glm::dvec3> positions)
      : spokes_(spokes), positions_(positions), side_(positions.size(), 0) {}

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

  Cut smallest_cut(const Vertices& vertices) {
    Cut best = cut_across(vertices, directions[0]);
    for (const glm::dvec3& direction : std::span(directions).subspan(1)) {
      Cut cut = cut_across(vertices, direction);
      if (cut.between.size() < best.between.size()) best = std::move(cut);
    }
    return best;
  }

  // The vertices between are those of one half beside the other, of the half that has fewer of them.
  Cut cut_across(const Vertices& vertices, const glm::dvec3& direction) {
    Keyed keyed;
    keyed.reserve(vertices.size());
    for (const VertexId v : vertices) keyed.emplace_back(glm::dot(direction, positions_[v]), v);
    Keyed ranked = keyed;
    put_least_first(std::span(ranked), ranked.size() / 2, std::less<>());
    const auto middle = ranked[ranked.size() / 2];
    // A number used once for each half, so that vertices of other parts are in neither.
    const std::uint32_t low_side = ++sides_;
    const std::uint32_t high_side = ++sides_;
    for (const auto& key : keyed) side_[key.second] = key < middle ? low_side : high_side;
    Cut from_low;
    Cut from_high;
    for (const auto& key : keyed) {
      const VertexId v = key.second;
      const bool low = key < middle;
      const bool beside = touches(v, low ? high_side : low_side);
      (low ? from_high.low : from_low.high).push_back(v);
      if (low) (beside ? from_low.between : from_low.low).push_back(v);
      if (!low) (beside ? from_high.between : from_high.high).push_back(v);
    }
    return from_low.between.size() <= from_high.between.size() ? std::move(from_low) : std::move(from_high);
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
};

}  // namespace

std::vector<VertexId> order_by_dissection(const Spokes& spokes, std::span<const glm::dvec3> positions) {
  Vertices vertices;
  for (VertexId v = 0; v < positions.size(); ++v)
    if (!spokes.at(v).empty()) vertices.push_back(v);
  Vertices order;
  order.reserve(vertices.size());
  Dissection(spokes, positions).append_order(vertices, order);
  return order;
}

}  // namespace knit
