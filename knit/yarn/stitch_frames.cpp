#include "knit/yarn/stitch_frames.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace knit {

namespace {

using Places = std::vector<glm::dvec3>;
using Numbers = std::vector<std::uint32_t>;

// A row as its stitches' numbers, in the order of the row.
struct RowLine {
  Numbers stitches;
  bool closed = true, is_short = false;
};

std::vector<RowLine> lines_of(const Fabric& fabric) {
  std::vector<RowLine> lines;
  for (const auto& row : fabric.rows())
    lines.push_back({fabric.path_indices(all_of(*row)), row->closed, is_short(*row)});
  for (std::size_t i = 0; i < fabric.deals().size(); ++i) {
    const RowId id = bridge_row(static_cast<std::int32_t>(i) + 1);
    const auto count = static_cast<std::int32_t>(fabric.deals()[i]->bridge.size());
    if (count > 0) lines.push_back({fabric.path_indices({{{id, 0, count}}, false}), false, false});
  }
  return lines;
}

// [1 2 1]/4 along the row, `times` over.
void smooth(const RowLine& line, int times, Places& along) {
  const std::size_t count = line.stitches.size();
  Places kept(count);
  for (; times > 0; --times) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = i > 0 ? i - 1 : line.closed ? count - 1 : 0;
      const std::size_t after = i + 1 < count ? i + 1 : line.closed ? 0 : i;
      kept[i] =
          0.25 * (along[line.stitches[before]] + 2.0 * along[line.stitches[i]] + along[line.stitches[after]]);
    }
    for (std::size_t i = 0; i < count; ++i) along[line.stitches[i]] = kept[i];
  }
}

// The wale edges of each stitch: what it hangs on, and what hangs on it.
struct Wales {
  std::vector<Numbers> up, down;
};

Wales wales_of(const Fabric& fabric, std::size_t stitches) {
  Wales wales{std::vector<Numbers>(stitches), std::vector<Numbers>(stitches)};
  const auto add = [&](std::uint32_t below, std::uint32_t above) {
    wales.up[below].push_back(above);
    wales.down[above].push_back(below);
  };
  for (const auto& strip : fabric.strips()) {
    for (const auto& [below, above] : strip->column_edges) add(below, above);
  }
  return wales;
}

glm::dvec3 mean_of(const Numbers& stitches, std::span<const glm::dvec3> at) {
  glm::dvec3 sum(0.0);
  for (const std::uint32_t stitch : stitches) sum += at[stitch];
  return sum / static_cast<double>(stitches.size());
}

// Of a bridge: towards the tube worked first, away from the other.
glm::dvec3 bridge_wale(const Numbers& above, std::span<const glm::dvec3> at, const glm::dvec3& place) {
  if (above.empty()) return glm::dvec3(0.0);
  const auto [first, last] = std::minmax_element(above.begin(), above.end());
  const glm::dvec3 one = at[*first] - place;
  return *first == *last ? one : 0.5 * (one - (at[*last] - place));
}

// f, of a row after what it stands on.
std::vector<double> shares(const std::vector<RowLine>& lines, std::span<const WorkedFrom> worked) {
  constexpr double a_row = 0.25;
  std::vector<double> share(worked.size(), 0.0);
  for (const RowLine& line : lines) {
    for (std::size_t i = 0; i < line.stitches.size(); ++i) {
      const std::uint32_t stitch = line.stitches[i];
      const WorkedFrom& from = worked[stitch];
      if (from.kind == LoopKind::bridge || from.kind == LoopKind::picked_up) continue;
      const double level = static_cast<double>(i) / static_cast<double>(line.stitches.size()) - 0.5;
      const std::uint32_t below = is_increase(from.kind) ? from.beside[1] : from.parents[0];
      if (from.kind == LoopKind::cast_on) {
        share[stitch] = level;
      } else if (line.is_short) {
        share[stitch] = share[below];
      } else {
        share[stitch] = share[below] + std::clamp(level - share[below], -a_row, a_row);
      }
    }
  }
  return share;
}

Places on_helix(const std::vector<RowLine>& lines, const Wales& wales, std::span<const double> share,
                std::span<const glm::dvec3> at) {
  Places up(at.size(), glm::dvec3(0.0)), down = up, moved(at.begin(), at.end());
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!wales.up[i].empty()) up[i] = mean_of(wales.up[i], at) - at[i];
    if (!wales.down[i].empty()) down[i] = at[i] - mean_of(wales.down[i], at);
    if (wales.up[i].empty()) up[i] = down[i];
    if (wales.down[i].empty()) down[i] = up[i];
  }
  for (const RowLine& line : lines) {
    smooth(line, 3, up);
    smooth(line, 3, down);
  }
  for (std::size_t i = 0; i < at.size(); ++i) moved[i] += share[i] * (share[i] > 0.0 ? up[i] : down[i]);
  return moved;
}

Places normals_of(const Fabric& fabric, std::span<const glm::dvec3> at) {
  Places normals(at.size(), glm::dvec3(0.0));
  const auto add = [&](const std::vector<Face>& faces) {
    for (const Face& face : faces) {
      const auto& [a, b, c, d] = face.corners;
      const bool quad = face.corner_count == 4;
      const glm::dvec3 area = glm::cross(at[c] - at[a], quad ? at[d] - at[b] : at[c] - at[b]);
      for (std::int32_t i = 0; i < face.corner_count; ++i)
        normals[face.corners[static_cast<std::size_t>(i)]] += area;
    }
  };
  for (const auto& strip : fabric.strips()) add(strip->faces);
  for (const auto& deal : fabric.deals()) add(deal->faces);
  for (glm::dvec3& normal : normals) {
    const double length = glm::length(normal);
    if (length > 0.0) normal /= length;
  }
  return normals;
}

// Of each stitch those before and after it along its yarn, in the order of its row.
struct Neighbours {
  Numbers before, after;
};

Neighbours neighbours_of(const std::vector<RowLine>& lines, std::span<const YarnPath> paths,
                         std::size_t stitches) {
  Neighbours beside{Numbers(stitches, no_stitch), Numbers(stitches, no_stitch)};
  for (const YarnPath& path : paths) {
    for (std::size_t i = 1; i < path.steps.size(); ++i) {
      const YarnStep &a = path.steps[i - 1], &b = path.steps[i];
      if (a.back || b.back) continue;
      beside.after[a.stitch] = b.stitch;
      beside.before[b.stitch] = a.stitch;
    }
  }
  for (const RowLine& line : lines) {
    for (std::size_t i = 0; i < line.stitches.size(); ++i) {
      const bool first = i == 0, last = i + 1 == line.stitches.size();
      if (!first) beside.before[line.stitches[i]] = line.stitches[i - 1];
      if (!last) beside.after[line.stitches[i]] = line.stitches[i + 1];
      if (first && !line.closed) beside.before[line.stitches[i]] = no_stitch;
      if (last && !line.closed) beside.after[line.stitches[i]] = no_stitch;
    }
  }
  return beside;
}

glm::dvec3 course_of(std::uint32_t before, std::uint32_t stitch, std::uint32_t after, const Places& at) {
  constexpr double far = 3.0;  // the yarn runs on elsewhere
  glm::dvec3 in = before != no_stitch ? at[stitch] - at[before] : glm::dvec3(0.0);
  glm::dvec3 on = after != no_stitch ? at[after] - at[stitch] : glm::dvec3(0.0);
  if (before == no_stitch) in = on;
  if (after == no_stitch) on = in;
  if (glm::length(in) > far * glm::length(on)) in = on;
  if (glm::length(on) > far * glm::length(in)) on = in;
  return 0.5 * (in + on);
}

}  // namespace

std::vector<LoopFrame> stitch_frames(const Fabric& fabric, std::span<const glm::dvec3> positions,
                                     std::span<const WorkedFrom> worked, std::span<const YarnPath> paths) {
  const std::vector<RowLine> lines = lines_of(fabric);
  const Wales wales = wales_of(fabric, positions.size());
  const Places at = on_helix(lines, wales, shares(lines, worked), positions);
  const Places out = normals_of(fabric, at);
  const Neighbours beside = neighbours_of(lines, paths, at.size());
  Places wale(at.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (worked[i].kind == LoopKind::bridge && wales.down[i].empty()) {
      wale[i] = bridge_wale(wales.up[i], at, at[i]);
      continue;
    }
    if (!wales.up[i].empty()) wale[i] += mean_of(wales.up[i], at) - at[i];
    if (!wales.down[i].empty()) wale[i] += at[i] - mean_of(wales.down[i], at);
    if (!wales.up[i].empty() && !wales.down[i].empty()) wale[i] *= 0.5;
  }
  for (const RowLine& line : lines) smooth(line, 2, wale);
  std::vector<LoopFrame> frames(at.size());
  for (std::uint32_t i = 0; i < frames.size(); ++i)
    frames[i] = {at[i], course_of(beside.before[i], i, beside.after[i], at), wale[i], out[i], 0.0};
  return frames;
}

}  // namespace knit
