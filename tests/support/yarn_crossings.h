// What a curve of yarn is in itself, counted from its points: over and under which strands it runs, and where it overlaps.
//
// Which stitch hangs on which is read here from joins, not from the stage that makes the curve. Seen along the outside at the
// stitch below, a loop that is drawn through another from behind to the front reads "bffb": behind its strand, twice in front,
// behind.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/yarn/yarn_curve.h"

namespace test_support {

using Points = std::vector<glm::dvec3>;

// A loop and what it is drawn through: the loop of a stitch, or the bar that was lifted for it.
struct Through {
  enum class Kind { knit, decrease, bar } kind = Kind::knit;
  std::uint32_t loop = 0, parent = 0;
  knit::Label label = knit::Label::knit;
};

inline std::vector<Through> all_through(const knit::Fabric& fabric) {
  std::vector<Through> all;
  for (const auto& join : fabric.joins()) {
    const auto below = fabric.path_indices(join->from);
    const auto above = fabric.path_indices(knit::all_of(fabric.row(join->to)));
    std::map<std::uint32_t, knit::Label> decreased;
    for (std::size_t cell = 0; cell < join->labels.size(); ++cell) {
      if (knit::is_decrease(join->labels[cell]))
        decreased[above[static_cast<std::size_t>(join->link[cell])]] = join->labels[cell];
    }
    for (std::size_t cell = 0; cell < join->labels.size(); ++cell) {
      const auto link = static_cast<std::size_t>(join->link[cell]);
      const knit::Label label = join->labels[cell];
      if (knit::cells_above(*join)) {
        all.push_back({knit::is_increase(label) ? Through::Kind::bar : Through::Kind::knit, above[cell],
                       below[link], label});
      } else {
        const auto at = decreased.find(above[link]);
        const bool two = at != decreased.end();
        all.push_back({two ? Through::Kind::decrease : Through::Kind::knit, above[link], below[cell],
                       two ? at->second : knit::Label::knit});
      }
    }
  }
  return all;
}

inline Points outsides(const knit::Fabric& fabric, std::span<const glm::dvec3> at) {
  Points out(at.size(), glm::dvec3(0.0));
  for (const auto& strip : fabric.strips()) {
    for (const knit::Face& face : strip->faces) {
      const auto& c = face.corners;
      glm::dvec3 area = glm::cross(at[c[1]] - at[c[0]], at[c[2]] - at[c[0]]);
      if (face.corner_count == 4) area += glm::cross(at[c[2]] - at[c[0]], at[c[3]] - at[c[0]]);
      for (int i = 0; i < face.corner_count; ++i) out[c[static_cast<std::size_t>(i)]] += area;
    }
  }
  for (glm::dvec3& n : out) n = glm::length(n) > 0.0 ? glm::normalize(n) : glm::dvec3(0, 0, 1);
  return out;
}

// The pieces of a yarn by what they are of.
class YarnPieces {
 public:
  // `narrow`: stitches whose foot is no stitch wide, increases; the loop beside one begins in it.
  YarnPieces(std::span<const knit::YarnCurve> curves, const std::vector<std::uint8_t>& narrow) {
    constexpr std::size_t fine = 4;
    for (const knit::YarnCurve& curve : curves) {
      const Points places = knit::sampled(curve, fine);
      for (std::size_t i = 0; i < curve.points.size();) {
        std::size_t end = i + 1;
        while (end < curve.points.size() && curve.stitches[end] == curve.stitches[i] &&
               curve.parts[end] == curve.parts[i])
          ++end;
        // Beside a lifted bar or an increase the foot of a loop begins a point earlier.
        const auto reaches = [&](std::size_t k) {
          return curve.parts[k] == knit::YarnPart::bar || narrow[curve.stitches[k]] != 0;
        };
        const bool bar_before = i > 0 && reaches(i - 1);
        const bool bar_after = end < curve.points.size() && reaches(end);
        const std::size_t from = i * fine > 0 ? i * fine - (bar_before ? fine : 1) : 0;
        const std::size_t to = std::min(end * fine + (bar_after ? fine + 1 : 2), places.size());
        Points piece(places.begin() + static_cast<std::ptrdiff_t>(from),
                     places.begin() + static_cast<std::ptrdiff_t>(to));
        auto& kept = of_[{curve.stitches[i], curve.parts[i]}];
        // Of two pieces of one loop, as where a bar's foot is its last point, the longer.
        if (piece.size() > kept.size()) kept = std::move(piece);
        i = end;
      }
    }
  }
  [[nodiscard]] const Points& at(std::uint32_t stitch, knit::YarnPart part) const {
    static const Points none;
    const auto found = of_.find({stitch, part});
    return found != of_.end() ? found->second : none;
  }

 private:
  std::map<std::pair<std::uint32_t, knit::YarnPart>, Points> of_;
};

// Where `a` runs over ('f') and under ('b') any of `others`, along `a`, seen against `out` with `up` upwards.
inline std::string crossings(const Points& a, const std::vector<const Points*>& others, const glm::dvec3& out,
                             glm::dvec3 up) {
  up = glm::normalize(up - out * glm::dot(up, out));
  const glm::dvec3 side = glm::cross(up, out);
  const auto seen = [&](const glm::dvec3& p) {
    return glm::dvec3(glm::dot(p, side), glm::dot(p, up), glm::dot(p, out));
  };
  std::vector<std::pair<double, char>> met;
  for (const Points* b : others) {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      const glm::dvec3 a0 = seen(a[i]), r = seen(a[i + 1]) - a0;
      for (std::size_t j = 0; j + 1 < b->size(); ++j) {
        const glm::dvec3 b0 = seen((*b)[j]), q = seen((*b)[j + 1]) - b0, d = b0 - a0;
        const double cross = r.x * q.y - r.y * q.x;
        if (cross == 0.0) continue;
        const double t = (d.x * q.y - d.y * q.x) / cross, u = (d.x * r.y - d.y * r.x) / cross;
        if (t < 0.0 || t >= 1.0 || u < 0.0 || u >= 1.0) continue;
        met.emplace_back(static_cast<double>(i) + t, a0.z + t * r.z > b0.z + u * q.z ? 'f' : 'b');
      }
    }
  }
  std::sort(met.begin(), met.end());
  std::string text;
  for (const auto& [where, how] : met) text += how;
  return text;
}

// b..., f twice or more, b...
inline bool drawn_through(const std::string& text) {
  const std::size_t first = text.find('f'), last = text.rfind('f');
  return first != std::string::npos && first > 0 && last + 1 < text.size() && last > first &&
         text.find('b', first) > last;
}

struct Tally {
  int right = 0, all = 0;
  std::vector<std::pair<std::uint32_t, std::string>> wrong;
  void add(std::uint32_t stitch, const std::string& text, bool fits) {
    ++all;
    right += fits ? 1 : 0;
    if (!fits) wrong.emplace_back(stitch, text);
  }
  [[nodiscard]] double share() const { return all > 0 ? static_cast<double>(right) / all : 1.0; }
};

struct Crossings {
  Tally knit, decrease, bar;
  int no_bar = 0;
};

inline Crossings crossings_of(const knit::Fabric& fabric, std::span<const glm::dvec3> at,
                              std::span<const knit::YarnCurve> curves) {
  using knit::YarnPart;
  const Points out = outsides(fabric, at);
  const std::vector<Through> all = all_through(fabric);
  std::vector<Through::Kind> kinds(at.size(), Through::Kind::knit);
  std::vector<std::uint8_t> cast_on(at.size(), 1);
  for (const Through& each : all) {
    kinds[each.loop] = each.kind;
    cast_on[each.loop] = 0;
  }
  std::vector<std::uint8_t> narrow(at.size(), 0);
  for (const Through& each : all) narrow[each.loop] = each.kind == Through::Kind::bar ? 1 : 0;
  const YarnPieces pieces(curves, narrow);
  // Two stitches that are taken together hang one behind the other: what is drawn through them is tested with both.
  Crossings counted;
  for (const Through& each : all) {
    const Points& loop = pieces.at(each.loop, YarnPart::loop);
    const glm::dvec3 up = at[each.loop] - at[each.parent];
    if (each.kind == Through::Kind::bar) {
      const Points& bar = pieces.at(each.loop, YarnPart::bar);
      if (bar.empty()) {
        ++counted.no_bar;
        continue;
      }
      const std::string text = crossings(loop, {&bar}, out[each.parent], up);
      counted.bar.add(each.loop, text, std::count(text.begin(), text.end(), 'f') >= 2);
      continue;
    }
    if (each.kind == Through::Kind::decrease) {
      const std::string text =
          crossings(loop, {&pieces.at(each.parent, YarnPart::loop)}, out[each.parent], up);
      counted.decrease.add(each.loop, text, std::count(text.begin(), text.end(), 'f') >= 2);
      continue;
    }
    if (cast_on[each.parent] != 0 || kinds[each.parent] != Through::Kind::knit) continue;
    std::vector<const Points*> row{&pieces.at(each.parent, YarnPart::loop)};
    if (each.parent > 0) row.push_back(&pieces.at(each.parent - 1, YarnPart::loop));
    if (each.parent + 1 < at.size()) row.push_back(&pieces.at(each.parent + 1, YarnPart::loop));
    const std::string text = crossings(loop, row, out[each.parent], up);
    counted.knit.add(each.loop, text, drawn_through(text));
  }
  return counted;
}

// The share of the yarn that lies nearer to other yarn than (1 - deep) of its thickness; other: more than 0.75 of a stitch's
// width along it. By cubes of the thickness's size, sorted.
inline double overlapping(std::span<const knit::YarnCurve> curves, double width, double deep) {
  struct Spot {
    std::array<std::int64_t, 3> cube;
    glm::dvec3 at;
    double along;
  };
  std::vector<Spot> spots;
  double from = 0.0, near = 0.0;
  for (const knit::YarnCurve& curve : curves) {
    near = 2.0 * curve.radius * (1.0 - deep);
    const Points places = knit::sampled(curve, 3);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i > 0) from += glm::distance(places[i - 1], places[i]);
      std::array<std::int64_t, 3> cube{};
      for (int axis = 0; axis < 3; ++axis)
        cube[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(places[i][axis] / near));
      spots.push_back({cube, places[i], from});
    }
    from += 10.0 * width;
  }
  std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.cube < b.cube; });
  std::size_t met = 0;
  for (const Spot& spot : spots) {
    bool touches = false;
    for (std::int64_t x = -1; x <= 1 && !touches; ++x) {
      for (std::int64_t y = -1; y <= 1 && !touches; ++y) {
        const std::array low{spot.cube[0] + x, spot.cube[1] + y, spot.cube[2] - 1};
        const std::array high{low[0], low[1], low[2] + 2};
        auto other = std::lower_bound(spots.begin(), spots.end(), low,
                                      [](const Spot& a, const auto& cube) { return a.cube < cube; });
        for (; other != spots.end() && other->cube <= high && !touches; ++other)
          touches =
              std::abs(other->along - spot.along) > 0.75 * width && glm::distance(other->at, spot.at) < near;
      }
    }
    met += touches ? 1U : 0U;
  }
  return spots.empty() ? 0.0 : static_cast<double>(met) / static_cast<double>(spots.size());
}

}  // namespace test_support
