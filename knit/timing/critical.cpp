#include "knit/timing/critical.h"

#include <algorithm>

#include "knit/mesh/edge_table.h"
#include "knit/mesh/union_find.h"
#include "knit/model/ties.h"

namespace knit {

namespace {

// Times with ties broken by index, so that no two corners of a triangle are equal.
struct Corner {
  VertexId place;
  double time;
  // Without a branch: which corner is the lower one is anybody's guess.
  [[nodiscard]] bool below(const Corner& other) const {
    return static_cast<bool>(static_cast<int>(time < other.time) |
                             (static_cast<int>(time == other.time) & static_cast<int>(place < other.place)));
  }
};

bool is_place(const Input& input, VertexId v) { return input.twin[v] == v && input.referenced[v] != 0; }

struct Middles {
  std::vector<std::int32_t> count;  // per vertex: of triangles whose middle corner it is
  std::int64_t triangles = 0;       // that have three corners at all
};

Middles count_middles(const Input& input, const std::vector<double>& times, const Heard& heard) {
  Middles middles{std::vector<std::int32_t>(times.size(), 0), 0};
  for (std::size_t i = 0; i < input.mesh.triangles.size(); ++i) {
    hear_at(heard, i, input.mesh.triangles.size());
    const Triangle p = twins_of(input.mesh.triangles[i], input.twin);
    if (collapsed(p)) continue;
    ++middles.triangles;
    const Corner a{p[0], times[p[0]]}, b{p[1], times[p[1]]}, c{p[2], times[p[2]]};
    const bool a_below_b = a.below(b);
    const bool a_below_c = a.below(c);
    const bool b_below_c = b.below(c);
    // One of the two others is below the middle one.
    const std::size_t middle = a_below_b != a_below_c ? 0 : a_below_b == b_below_c ? 1 : 2;
    ++middles.count[p[middle]];
  }
  return middles;
}

// What is known of a flat part: of most, that it is one regular vertex.
struct Flat {
  std::int32_t doubled_index = 0;
  bool any_below = false, any_above = false;
};

Flat flat_at(const Input& input, const std::vector<double>& times, VertexId v, std::int32_t middles) {
  Flat part{2 - middles, false, false};
  for (const VertexId n : input.neighbours_of(v)) {
    part.any_below = part.any_below || clearly_less(times[n], times[v], 1.0);
    part.any_above = part.any_above || clearly_less(times[v], times[n], 1.0);
    if (part.any_below && part.any_above) break;
  }
  return part;
}

// `triangles`: with three corners.
std::int32_t euler_of(const Input& input, std::int64_t triangles) {
  std::int64_t places = 0;
  for (VertexId v = 0; v < input.twin.size(); ++v) places += is_place(input, v) ? 1 : 0;
  return static_cast<std::int32_t>(places - static_cast<std::int64_t>(input.neighbours.size() / 2) +
                                   triangles);
}

UnionFind join_flat_parts(const Input& input, const std::vector<double>& times, const Heard& heard) {
  UnionFind parts(times.size());
  for (VertexId v = 0; v < times.size(); ++v) {
    hear_at(heard, v, times.size());
    if (!is_place(input, v)) continue;
    for (const VertexId n : input.neighbours_of(v)) {
      if (n > v && std::abs(times[n] - times[v]) <= tie) parts.join(v, n);
    }
  }
  return parts;
}

// Without anything below (above) a part is a minimum (maximum), whatever its shape; what then lacks in the
// index is saddles: a ring of minima is what is left of one minimum and one saddle.
std::vector<CriticalPoint> points_of(const Flat& part, VertexId vertex, double time) {
  std::vector<CriticalPoint> points;
  std::int32_t index = part.doubled_index / 2;
  if (!part.any_below || !part.any_above || index > 0) {
    points.push_back({vertex, part.any_below ? CriticalKind::maximum : CriticalKind::minimum, 1, time});
    --index;
  }
  if (index < 0) points.push_back({vertex, CriticalKind::saddle, -index, time});
  return points;
}

struct Crossing {
  std::array<VertexId, 2> edge;
  std::uint32_t triangle;
};

}  // namespace

Criticals find_criticals(const Input& input, const std::vector<double>& times, const Heard& heard) {
  const Middles middles = count_middles(input, times, part_of(heard, 0.0, 0.4));
  UnionFind parts = join_flat_parts(input, times, part_of(heard, 0.4, 0.6));
  const Heard rest = part_of(heard, 0.6, 0.9);
  std::vector<Flat> flats(times.size());
  for (VertexId v = 0; v < times.size(); ++v) {
    hear_at(rest, v, times.size());
    if (!is_place(input, v)) continue;
    const Flat here = flat_at(input, times, v, middles.count[v]);
    Flat& whole = flats[parts.find(v)];
    whole.doubled_index += here.doubled_index;
    whole.any_below = whole.any_below || here.any_below;
    whole.any_above = whole.any_above || here.any_above;
  }
  hear(heard, 0.9);
  Criticals criticals;
  for (VertexId v = 0; v < times.size(); ++v) {
    if (!is_place(input, v) || parts.find(v) != v) continue;
    for (const CriticalPoint& point : points_of(flats[v], v, times[v])) criticals.points.push_back(point);
  }
  sort_by_rule(
      criticals.points, [](const CriticalPoint& point) { return point.time; }, 1.0);
  for (const CriticalPoint& point : criticals.points) {
    if (point.kind == CriticalKind::minimum) ++criticals.minima;
    if (point.kind == CriticalKind::saddle) criticals.saddles += point.multiplicity;
    if (point.kind == CriticalKind::maximum) ++criticals.maxima;
  }
  criticals.euler = euler_of(input, middles.triangles);
  return criticals;
}

std::int32_t count_loops(const Input& input, const std::vector<double>& times, double time) {
  // Crossed triangles that share a crossed edge belong to the same loop.
  std::vector<Crossing> crossings;
  std::uint32_t crossed = 0;
  for (const Triangle& t : input.mesh.triangles) {
    if (collapsed(twins_of(t, input.twin))) continue;
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
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
  });
  UnionFind loops(crossed);
  auto count = static_cast<std::int32_t>(crossed);
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    if (crossings[i].edge != crossings[i - 1].edge) continue;
    if (loops.join(crossings[i].triangle, crossings[i - 1].triangle)) --count;
  }
  return count;
}

namespace {

// The vertex at which two parts of the surface that are apart below `time` first meet; no_vertex: it is one
// part there.
VertexId meeting_of_parts(const Input& input, const std::vector<double>& times, double time) {
  std::vector<VertexId> rising;
  for (VertexId v = 0; v < times.size(); ++v) {
    if (is_place(input, v)) rising.push_back(v);
  }
  std::stable_sort(rising.begin(), rising.end(), [&](VertexId a, VertexId b) { return times[a] < times[b]; });
  UnionFind parts(times.size());
  std::vector<std::uint8_t> added(times.size(), 0);
  std::vector<std::uint8_t> deep(times.size(), 0);  // of a part's representative: it reaches below `time`
  for (const VertexId v : rising) {
    const bool above = times[v] >= time;
    added[v] = 1;
    deep[v] = above ? 0 : 1;
    for (const VertexId n : input.neighbours_of(v)) {
      if (added[n] == 0) continue;
      const std::uint32_t a = parts.find(v);
      const std::uint32_t b = parts.find(n);
      if (a == b) continue;
      if (above && deep[a] != 0 && deep[b] != 0) return v;
      parts.join(a, b);
      deep[parts.find(v)] = deep[a] | deep[b];
    }
  }
  return no_vertex;
}

}  // namespace

Split explain_split(const Input& input, const std::vector<double>& times, const Criticals& criticals,
                    double time) {
  Split split;
  split.vertex = meeting_of_parts(input, times, time);
  if (split.vertex != no_vertex) {
    split.cause = CriticalKind::minimum;
    split.time = times[split.vertex];
    return split;
  }
  // The last saddle below which the level set was still one loop.
  for (std::size_t i = criticals.points.size(); i-- > 0;) {
    const CriticalPoint& point = criticals.points[i];
    if (point.kind != CriticalKind::saddle || point.time > time) continue;
    split.vertex = point.vertex;
    split.time = point.time;
    if (count_loops(input, times, point.time) <= 1) break;
  }
  return split;
}

std::optional<Split> find_split(const Input& input, const std::vector<double>& times,
                                const Criticals& criticals, const Levels& levels, const Heard& heard) {
  if (criticals.points.size() <= 2) return std::nullopt;  // one minimum, one maximum: a single tube
  std::int32_t looked_at = -1;
  for (const CriticalPoint& point : criticals.points) {
    const auto above = std::upper_bound(levels.times.begin(), levels.times.end(), point.time);
    const auto level = static_cast<std::int32_t>(above - levels.times.begin()) - 1;
    if (above == levels.times.end() || level == looked_at) continue;
    looked_at = level;
    hear(heard, 0.0);
    const std::int32_t loops = count_loops(input, times, *above);
    if (loops <= 1) continue;
    Split split = explain_split(input, times, criticals, *above);
    split.level = level;
    split.loops = loops;
    return split;
  }
  return std::nullopt;
}

}  // namespace knit
