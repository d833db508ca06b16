#include "knit/relax/springs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/settle/graph.h"

namespace knit {

namespace {

using Pair = std::array<std::uint32_t, 2>;

// Lower and upper stitch, each pair once.
std::vector<Pair> wales_of(const Fabric& fabric) {
  std::vector<Pair> wales;
  for (const auto& strip : fabric.strips())
    wales.insert(wales.end(), strip->column_edges.begin(), strip->column_edges.end());
  for (const auto& deal : fabric.deals())
    wales.insert(wales.end(), deal->column_edges.begin(), deal->column_edges.end());
  std::sort(wales.begin(), wales.end());
  wales.erase(std::unique(wales.begin(), wales.end()), wales.end());
  return wales;
}

// Per stitch those that it is joined to up or down a wale, rising.
using Beside = std::vector<std::vector<std::uint32_t>>;

// Sides along openings: how many stitches go round.
class Rims {
 public:
  explicit Rims(const std::vector<std::vector<std::uint32_t>>& rims) {
    for (const auto& rim : rims) {
      for (const auto& [from, to] : Edges(rim.size(), true)) {
        const auto [low, high] = std::minmax(rim[from], rim[to]);
        sides_.push_back({{low, high}, rim.size()});
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }
  // 0: no rim.
  [[nodiscard]] std::size_t around(const Pair& side) const {
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), std::pair{side, std::size_t{0}});
    return at != sides_.end() && at->first == side ? at->second : 0;
  }

 private:
  std::vector<std::pair<Pair, std::size_t>> sides_;
};

void add_row_bends(const Fabric& fabric, SpringNet& net) {
  constexpr std::size_t least = 5;
  for (const auto& row : fabric.rows()) {
    const std::uint32_t first = fabric.first_on_path(row->id);
    const auto count = static_cast<std::uint32_t>(row->stitches.size());
    if (count < least) continue;
    for (std::uint32_t i = row->closed ? 0 : 1; i < (row->closed ? count : count - 1); ++i)
      net.bends.push_back({first + (i + count - 1) % count, first + i, first + (i + 1) % count});
  }
}

}  // namespace

SpringNet make_spring_net(const Fabric& fabric, const StitchSize& stitch) {
  const double w = stitch.width, h = stitch.height, diagonal = std::sqrt(w * w + h * h);
  const SettleGraph graph = make_settle_graph(fabric);
  const Rims rims(graph.rims);
  SpringNet net;
  net.stitches = graph.stitches;
  for (const Pair& side : graph.courses) {
    const std::size_t around = rims.around(side);
    const bool drawn = around > 0 && around <= drawn_end;
    const double share = drawn ? 2.0 : around > 0 ? 0.5 : 1.0;
    net.springs.push_back({side[0], side[1], drawn ? drawn_to * w : w, share * course_stiffness * h / w,
                           drawn ? SpringKind::drawn : SpringKind::course});
  }
  const std::vector<Pair> wales = wales_of(fabric);
  Beside up(net.stitches), down(net.stitches);
  for (const auto& [lower, upper] : wales) {
    up[lower].push_back(upper);
    down[upper].push_back(lower);
  }
  for (const auto& [lower, upper] : wales) {
    const bool leans = up[lower].size() > 1 || down[upper].size() > 1;
    net.springs.push_back({lower, upper, leans ? std::sqrt(h * h + 0.25 * w * w) : h, wale_stiffness * w / h,
                           SpringKind::wale});
  }
  for (const auto& quad : graph.quads) {
    for (std::size_t i = 0; i < 2; ++i)
      net.springs.push_back({quad[i], quad[i + 2], diagonal, shear_stiffness * w * h / (diagonal * diagonal),
                             SpringKind::shear});
  }
  add_row_bends(fabric, net);
  for (std::uint32_t i = 0; i < net.stitches; ++i) {
    if (up[i].empty() || down[i].empty()) continue;
    net.bends.push_back({down[i][(down[i].size() - 1) / 2], i, up[i][(up[i].size() - 1) / 2]});
  }
  return net;
}

void add_pull(const SpringNet& net, std::span<const glm::dvec3> at, std::span<glm::dvec3> force) {
  constexpr double nothing = 1e-12;
  for (const Spring& spring : net.springs) {
    const glm::dvec3 way = at[spring.a] - at[spring.b];
    const double length = std::sqrt(glm::dot(way, way));
    if (length < nothing * spring.rest) continue;
    const glm::dvec3 pull = way * (spring.stiffness * (spring.rest / length - 1.0));
    force[spring.a] += pull;
    force[spring.b] -= pull;
  }
  for (const auto& [a, m, b] : net.bends) {
    const glm::dvec3 pull = (at[a] - 2.0 * at[m] + at[b]) * bend_stiffness;
    force[a] -= pull;
    force[m] += 2.0 * pull;
    force[b] -= pull;
  }
}

Joined::Joined(const SpringNet& net) : first_(net.stitches + 1, 0), met_(net.stitches, 0) {
  const auto joins = [](const Spring& spring) { return spring.kind != SpringKind::shear; };
  for (const Spring& spring : net.springs) {
    if (!joins(spring)) continue;
    ++first_[spring.a + 1];
    ++first_[spring.b + 1];
  }
  for (std::size_t i = 0; i < net.stitches; ++i) first_[i + 1] += first_[i];
  beside_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const Spring& spring : net.springs) {
    if (!joins(spring)) continue;
    beside_[next[spring.a]++] = spring.b;
    beside_[next[spring.b]++] = spring.a;
  }
}

void Joined::within(std::uint32_t stitch, int steps, std::vector<std::uint32_t>& found) {
  ++searches_;
  found.assign(1, stitch);
  met_[stitch] = searches_;
  for (std::size_t begin = 0; steps > 0; --steps) {
    const std::size_t end = found.size();
    for (; begin < end; ++begin) {
      const std::uint32_t from = found[begin];
      for (std::uint32_t at = first_[from]; at < first_[from + 1]; ++at) {
        if (met_[beside_[at]] == searches_) continue;
        met_[beside_[at]] = searches_;
        found.push_back(beside_[at]);
      }
    }
  }
  std::sort(found.begin(), found.end());
}

}  // namespace knit
