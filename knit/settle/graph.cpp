#include "knit/settle/graph.h"

#include <algorithm>
#include <iterator>

namespace knit {

namespace {

using Side = std::array<std::uint32_t, 2>;
using Sides = std::vector<Side>;

Side rising(std::uint32_t a, std::uint32_t b) { return a < b ? Side{a, b} : Side{b, a}; }

void make_set(Sides& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

// Both need their ends in order.
Sides without(const Sides& all, const Sides& taken) {
  Sides left;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(), std::back_inserter(left));
  return left;
}

class Gathering {
 public:
  void add_wales(const Sides& column_edges) {
    for (const auto& [lower, upper] : column_edges) graph_.wales.push_back(rising(lower, upper));
  }
  // From the end of a short row to the stitch its turn stands at: no yarn runs there.
  void add_turn(std::uint32_t end, std::uint32_t beside) { across_.push_back(rising(end, beside)); }
  void add_faces(const std::vector<Face>& faces, bool of_strip) {
    for (const Face& face : faces) add_face(face, of_strip);
  }
  SettleGraph finish(std::size_t stitches) {
    graph_.stitches = static_cast<std::uint32_t>(stitches);
    make_set(graph_.wales);
    make_set(graph_.beside);
    Sides sides;
    sides.reserve(along_.size());
    for (const auto& [from, to] : along_) sides.push_back(rising(from, to));
    make_set(sides);
    make_set(across_);
    graph_.courses = without(without(sides, graph_.wales), across_);
    if (!across_.empty())
      std::erase_if(graph_.quads, [&](const std::array<std::uint32_t, 4>& quad) { return spans_turn(quad); });
    graph_.rims = rims_of(std::move(along_));
    return std::move(graph_);
  }

 private:
  void add_face(const Face& face, bool of_strip) {
    const auto count = static_cast<std::size_t>(face.corner_count);
    const auto& c = face.corners;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = i + 1 < count ? i + 1 : 0, last = i > 0 ? i - 1 : count - 1;
      along_.push_back({c[i], c[next]});
      if (i == 0 || count == 4) graph_.corners.push_back({c[i], c[next], c[last]});
      for (std::size_t j = i + 1; j < count; ++j) graph_.beside.push_back(rising(c[i], c[j]));
    }
    graph_.triangles.push_back({c[0], c[1], c[2]});
    if (count == 4) graph_.triangles.push_back({c[0], c[2], c[3]});
    if (count == 4 && of_strip) graph_.quads.push_back(c);
  }

  [[nodiscard]] bool spans_turn(const std::array<std::uint32_t, 4>& quad) const {
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::binary_search(across_.begin(), across_.end(), rising(quad[i], quad[(i + 1) % 4]))) return true;
    }
    return false;
  }

  SettleGraph graph_;
  Sides along_;   // sides of faces, in their direction
  Sides across_;  // turns
};

std::size_t side_from(const Sides& open, const std::vector<bool>& walked, std::uint32_t stitch) {
  auto at =
      static_cast<std::size_t>(std::lower_bound(open.begin(), open.end(), Side{stitch, 0}) - open.begin());
  while (at < open.size() && open[at][0] == stitch && walked[at]) ++at;
  return at < open.size() && open[at][0] == stitch ? at : open.size();
}

}  // namespace

// A face's sides run counter-clockwise, so from a stitch of a rim just one leads on; where openings touch, the one to the
// lower number is taken first.
std::vector<std::vector<std::uint32_t>> rims_of(Sides sides) {
  std::sort(sides.begin(), sides.end());
  Sides back;
  back.reserve(sides.size());
  for (const auto& [from, to] : sides) back.push_back({to, from});
  std::sort(back.begin(), back.end());
  const Sides open = without(sides, back);
  std::vector<std::vector<std::uint32_t>> rims;
  std::vector<bool> walked(open.size(), false);
  for (std::size_t first = 0; first < open.size(); ++first) {
    if (walked[first]) continue;
    std::vector<std::uint32_t> rim;
    std::size_t at = first;
    while (at < open.size() && !walked[at]) {
      walked[at] = true;
      rim.push_back(open[at][0]);
      at = side_from(open, walked, open[at][1]);
    }
    rims.push_back(std::move(rim));
  }
  return rims;
}

SettleGraph make_settle_graph(const Fabric& fabric) {
  Gathering gathering;
  for (const auto& strip : fabric.strips()) {
    gathering.add_wales(strip->column_edges);
    gathering.add_faces(strip->faces, true);
  }
  for (const auto& row : fabric.rows()) {
    if (!is_short(*row)) continue;
    gathering.add_turn(fabric.path_index({row->id, 0}), fabric.path_index(row->turned->before));
    gathering.add_turn(fabric.path_index({row->id, static_cast<std::int32_t>(row->stitches.size()) - 1}),
                       fabric.path_index(row->turned->after));
  }
  for (const auto& deal : fabric.deals()) {
    gathering.add_wales(deal->column_edges);
    gathering.add_faces(deal->faces, !deal->column_edges.empty());
  }
  return gathering.finish(fabric.stitch_count());
}

}  // namespace knit
