#include "knit/relax/volume.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <map>

#include "knit/fabric/edges.h"
#include "knit/settle/graph.h"

namespace knit {

namespace {

using Sides = std::vector<std::array<std::uint32_t, 2>>;

void find_rims(Enclosure& enclosure) {
  Sides sides;
  for (const auto& quad : enclosure.quads) {
    for (std::size_t i = 0; i < 4; ++i) sides.push_back({quad[i], quad[(i + 1) % 4]});
  }
  for (const auto& triangle : enclosure.triangles) {
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({triangle[i], triangle[(i + 1) % 3]});
  }
  enclosure.rims = rims_of(std::move(sides));
}

void add_faces(const std::vector<Face>& faces, Enclosure& enclosure) {
  for (const Face& face : faces) {
    const auto& [a, b, c, d] = face.corners;
    if (face.corner_count == 4)
      enclosure.quads.push_back({a, b, c, d});
    else
      enclosure.triangles.push_back({a, b, c});
  }
}

glm::dvec3 middle_of(std::span<const glm::dvec3> at) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& place : at) sum += place;
  return sum / static_cast<double>(std::max<std::size_t>(at.size(), 1));
}

glm::dvec3 middle_of(const std::vector<std::uint32_t>& rim, std::span<const glm::dvec3> at) {
  glm::dvec3 sum(0.0);
  for (const std::uint32_t stitch : rim) sum += at[stitch];
  return sum / static_cast<double>(rim.size());
}

// Of length 1, or 0; weighted by area, and counter-clockwise.
std::vector<glm::dvec3> normals_of(const Enclosure& all, std::span<const glm::dvec3> at) {
  std::vector<glm::dvec3> normals(at.size(), glm::dvec3(0.0));
  for (const auto& quad : all.quads) {
    const glm::dvec3 area = glm::cross(at[quad[2]] - at[quad[0]], at[quad[3]] - at[quad[1]]);
    for (const std::uint32_t stitch : quad) normals[stitch] += area;
  }
  for (const auto& [a, b, c] : all.triangles) {
    const glm::dvec3 area = glm::cross(at[b] - at[a], at[c] - at[a]);
    for (const std::uint32_t stitch : {a, b, c}) normals[stitch] += area;
  }
  for (glm::dvec3& normal : normals) {
    const double length = glm::length(normal);
    if (length > 0.0) normal /= length;
  }
  return normals;
}

// How far a row's outsides look away from its middle, -1 to 1.
double outwardness(const Fabric& fabric, const Row& row, std::span<const glm::dvec3> normals,
                   std::span<const glm::dvec3> at) {
  const std::size_t first = fabric.first_on_path(row.id), count = row.stitches.size();
  const glm::dvec3 middle = middle_of(at.subspan(first, count));
  double sum = 0.0;
  for (std::size_t i = first; i < first + count; ++i) {
    const glm::dvec3 out = at[i] - middle;
    const double length = glm::length(out);
    if (length > 0.0) sum += glm::dot(normals[i], out) / length;
  }
  return sum / static_cast<double>(count);
}

}  // namespace

Enclosure enclosure_of(const Fabric& fabric) {
  Enclosure all;
  for (const auto& strip : fabric.strips()) add_faces(strip->faces, all);
  for (const auto& deal : fabric.deals()) add_faces(deal->faces, all);
  find_rims(all);
  return all;
}

std::vector<RowId> inner_rows(const Fabric& fabric, const Enclosure& all, std::span<const glm::dvec3> at) {
  constexpr double decided = 0.3;
  const std::vector<glm::dvec3> normals = normals_of(all, at);
  const double facing = volume_of(all, at) < 0.0 ? -1.0 : 1.0;
  struct Seen {
    RowId row;
    double out;
  };
  std::map<TubeId, std::vector<Seen>> tubes;
  for (const auto& row : fabric.rows())
    tubes[row->tube].push_back({row->id, facing * outwardness(fabric, *row, normals, at)});
  std::vector<RowId> inner;
  for (const auto& [tube, rows] : tubes) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Seen* nearest = nullptr;
      std::size_t best = rows.size();
      for (std::size_t j = 0; j < rows.size(); ++j) {
        const std::size_t apart = i < j ? j - i : i - j;
        if (std::abs(rows[j].out) <= decided || apart >= best) continue;
        best = apart;
        nearest = &rows[j];
      }
      if (nearest != nullptr && nearest->out < 0.0) inner.push_back(rows[i].row);
    }
  }
  std::sort(inner.begin(), inner.end());
  return inner;
}

Enclosure without_rows(const Fabric& fabric, const Enclosure& all, const std::vector<RowId>& rows) {
  if (rows.empty()) return all;
  std::vector<bool> of_them(fabric.stitch_count(), false);
  for (const RowId row : rows) {
    const std::size_t first = fabric.first_on_path(row);
    for (std::size_t i = 0; i < fabric.row(row).stitches.size(); ++i) of_them[first + i] = true;
  }
  const auto is_left_out = [&](const auto& face) {
    return std::all_of(face.begin(), face.end(), [&](std::uint32_t stitch) { return of_them[stitch]; });
  };
  Enclosure left;
  for (const auto& quad : all.quads) {
    if (!is_left_out(quad)) left.quads.push_back(quad);
  }
  for (const auto& triangle : all.triangles) {
    if (!is_left_out(triangle)) left.triangles.push_back(triangle);
  }
  find_rims(left);
  return left;
}

double volume_of(const Enclosure& enclosure, std::span<const glm::dvec3> at) {
  const glm::dvec3 o = middle_of(at);
  double sum = 0.0;  // twelve times
  for (const auto& quad : enclosure.quads) {
    const glm::dvec3 a = at[quad[0]] - o, b = at[quad[1]] - o, c = at[quad[2]] - o, d = at[quad[3]] - o;
    const glm::dvec3 cd = glm::cross(c, d);
    sum += glm::dot(a, glm::cross(b, c) + cd + glm::cross(b, d)) + glm::dot(b, cd);
  }
  for (const auto& [a, b, c] : enclosure.triangles)
    sum += 2.0 * glm::dot(at[a] - o, glm::cross(at[b] - o, at[c] - o));
  for (const auto& rim : enclosure.rims) {
    const glm::dvec3 middle = middle_of(rim, at) - o;
    for (const auto& [from, to] : Edges(rim.size(), true))
      sum += 2.0 * glm::dot(middle, glm::cross(at[rim[to]] - o, at[rim[from]] - o));
  }
  return sum / 12.0;
}

void add_pressure(const Enclosure& enclosure, std::span<const glm::dvec3> at, double pressure,
                  std::span<glm::dvec3> force) {
  const glm::dvec3 o = middle_of(at);
  const double half = pressure / 12.0, whole = pressure / 6.0;
  for (const auto& quad : enclosure.quads) {
    const glm::dvec3 a = at[quad[0]] - o, b = at[quad[1]] - o, c = at[quad[2]] - o, d = at[quad[3]] - o;
    const glm::dvec3 ab = glm::cross(a, b), ac = glm::cross(a, c), ad = glm::cross(a, d);
    const glm::dvec3 bc = glm::cross(b, c), bd = glm::cross(b, d), cd = glm::cross(c, d);
    force[quad[0]] += (bc + cd + bd) * half;
    force[quad[1]] += (cd - ac - ad) * half;
    force[quad[2]] += (ab - ad - bd) * half;
    force[quad[3]] += (ac + ab + bc) * half;
  }
  for (const auto& [i, j, k] : enclosure.triangles) {
    const glm::dvec3 a = at[i] - o, b = at[j] - o, c = at[k] - o;
    force[i] += glm::cross(b, c) * whole;
    force[j] += glm::cross(c, a) * whole;
    force[k] += glm::cross(a, b) * whole;
  }
  for (const auto& rim : enclosure.rims) {
    const glm::dvec3 middle = middle_of(rim, at) - o;
    glm::dvec3 on_middle(0.0);
    for (const auto& [from, to] : Edges(rim.size(), true)) {
      const glm::dvec3 a = at[rim[to]] - o, b = at[rim[from]] - o;
      force[rim[to]] += glm::cross(b, middle) * whole;
      force[rim[from]] += glm::cross(middle, a) * whole;
      on_middle += glm::cross(a, b) * whole;
    }
    on_middle /= static_cast<double>(rim.size());
    for (const std::uint32_t stitch : rim) force[stitch] += on_middle;
  }
}

}  // namespace knit
