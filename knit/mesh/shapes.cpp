#include "knit/mesh/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "knit/base/number_text.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/elementary.h"

namespace knit {

namespace {

constexpr double pi = std::numbers::pi;

void finish_edges(Mesh& mesh) {
  std::vector<std::array<VertexId, 2>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  mesh.edges = unique_edges(edges, mesh.positions.size());
}

// From direction -z towards +x: counter-clockwise for who looks along +y. Never -0.
glm::dvec3 on_circle(double radius, double y, unsigned i, unsigned segments) {
  const TurnPoint at = turn_point(i, segments);
  return {0.0 + radius * at.sine, y, 0.0 - radius * at.cosine};
}

// Points of the curve from t = 0 to 1 at equal distances along it, about `spacing` apart.
template <class Curve>
std::vector<ProfilePoint> evenly_along(const Curve& curve, double spacing) {
  constexpr int fine = 1 << 14;
  std::vector<double> length(fine + 1, 0.0);
  for (int i = 1; i <= fine; ++i) {
    const ProfilePoint a = curve((i - 1.0) / fine);
    const ProfilePoint b = curve(static_cast<double>(i) / fine);
    length[static_cast<std::size_t>(i)] =
        length[static_cast<std::size_t>(i) - 1] + hypotenuse(b.radius - a.radius, b.y - a.y);
  }
  const int parts = std::max(2, static_cast<int>(std::lround(length.back() / spacing)));
  std::vector<ProfilePoint> profile{curve(0.0)};
  for (int j = 1; j < parts; ++j) {
    const double wanted = length.back() * j / parts;
    const auto above = std::upper_bound(length.begin(), length.end(), wanted);
    const double below = above[-1];
    const auto index = static_cast<double>(above - 1 - length.begin());
    profile.push_back(curve((index + (wanted - below) / (*above - below)) / fine));
  }
  profile.push_back(curve(1.0));
  profile.front().radius = profile.back().radius = 0.0;
  return profile;
}

void add_cap(Mesh& mesh, VertexId pole, VertexId ring, unsigned segments, unsigned entries, bool upwards) {
  for (unsigned i = 0; i < segments; ++i) {
    const VertexId here = ring + i;
    const VertexId next = ring + (i + 1) % entries;
    mesh.triangles.push_back(upwards ? Triangle{here, pole, next} : Triangle{pole, here, next});
  }
}

}  // namespace

TurnPoint turn_point(unsigned long num, unsigned long den) {
  if (2 * num > den) {
    const TurnPoint mirrored = turn_point(den - num, den);
    return {0.0 - mirrored.sine, mirrored.cosine};
  }
  if (4 * num > den) {
    const TurnPoint mirrored = turn_point(den - 2 * num, 2 * den);
    return {mirrored.sine, 0.0 - mirrored.cosine};
  }
  if (8 * num > den) {
    const TurnPoint mirrored = turn_point(den - 4 * num, 4 * den);
    return {mirrored.cosine, mirrored.sine};
  }
  const double angle = 2.0 * pi * (static_cast<double>(num) / static_cast<double>(den));
  return {sine(angle), cosine(angle)};
}

Mesh revolve(std::string name, std::span<const ProfilePoint> profile, unsigned segments, bool closing_copy) {
  Mesh mesh;
  mesh.name = std::move(name);
  const std::size_t rings = profile.size() - 2;
  const unsigned entries = segments + (closing_copy ? 1 : 0);
  mesh.positions.emplace_back(0.0, profile.front().y, 0.0);
  for (const ProfilePoint& p : profile.subspan(1, rings))
    for (unsigned i = 0; i < entries; ++i)
      mesh.positions.push_back(on_circle(p.radius, p.y, i % segments, segments));
  mesh.positions.emplace_back(0.0, profile.back().y, 0.0);

  add_cap(mesh, 0, 1, segments, entries, false);
  for (std::size_t j = 0; j + 1 < rings; ++j) {
    const auto low = static_cast<VertexId>(1 + j * entries);
    const VertexId high = low + entries;
    for (unsigned i = 0; i < segments; ++i) {
      const unsigned next = (i + 1) % entries;
      mesh.triangles.push_back({low + i, high + i, high + next});
      mesh.triangles.push_back({low + i, high + next, low + next});
    }
  }
  const auto top = static_cast<VertexId>(mesh.positions.size() - 1);
  add_cap(mesh, top, top - entries, segments, entries, true);
  finish_edges(mesh);
  return mesh;
}

Mesh sphere(unsigned segments, unsigned stacks, bool closing_copy) {
  std::vector<ProfilePoint> profile;
  for (unsigned j = 0; j <= stacks; ++j) {
    const TurnPoint at = turn_point(j, 2ul * stacks);
    profile.push_back({at.sine, 0.0 - at.cosine});
  }
  return revolve("sphere", profile, segments, closing_copy);
}

Mesh stretched_sphere(unsigned segments, double spacing) {
  const auto curve = [](double t) { return ProfilePoint{0.8 * sine(pi * t), -1.6 * cosine(pi * t)}; };
  return revolve("stretched-sphere", evenly_along(curve, spacing), segments, false);
}

Mesh egg(unsigned segments, double spacing) {
  const auto curve = [](double t) {
    const double c = cosine(pi * t);
    return ProfilePoint{0.93 * sine(pi * t) * (1.0 + 0.16 * c), -1.25 * c};
  };
  return revolve("egg", evenly_along(curve, spacing), segments, false);
}

Mesh capsule(unsigned segments, double spacing) {
  constexpr double radius = 0.7;
  constexpr double half = 0.6;  // of the straight part
  const auto curve = [=](double t) {
    const double along = t * (pi * radius + 2.0 * half) - pi * radius / 2.0 - half;  // 0 at the middle
    const double angle = std::clamp(std::abs(along) - half, 0.0, pi * radius / 2.0) / radius;
    const double y = std::min(std::abs(along), half) + radius * sine(angle);
    return ProfilePoint{radius * cosine(angle), std::copysign(y, along)};
  };
  return revolve("capsule", evenly_along(curve, spacing), segments, false);
}

Mesh cone(unsigned segments, double spacing) {
  constexpr double rim = 0.9;
  constexpr double rim_y = -0.8;
  constexpr double dome = 0.4;  // depth of the base below the rim
  constexpr double apex =
      1.2;  // of the sharp cone; a sharp tip would leave its last rings narrower than a stitch
  constexpr double tip = 0.12;  // radius of the ball that rounds it
  const double slope = angle_to(apex - rim_y, rim);
  const double ball_y = apex - tip / sine(slope);
  const auto curve = [=](double t) {
    const double part = 3.0 * t;
    if (part < 1.0) {
      const double angle = 0.5 * pi * part;
      return ProfilePoint{rim * sine(angle), rim_y - dome * cosine(angle)};
    }
    const ProfilePoint touch{tip * cosine(slope), ball_y + tip * sine(slope)};
    if (part < 2.0)
      return ProfilePoint{std::lerp(rim, touch.radius, part - 1.0), std::lerp(rim_y, touch.y, part - 1.0)};
    const double angle = std::lerp(slope, 0.5 * pi, part - 2.0);
    return ProfilePoint{tip * cosine(angle), ball_y + tip * sine(angle)};
  };
  return revolve("cone", evenly_along(curve, spacing), segments, false);
}

Mesh vase(unsigned segments, double spacing) {
  const auto curve = [](double t) {
    const double above = (2.0 * t - 1.0 - 0.38) / 0.2;
    const double neck = 1.0 - 0.62 * exponential(-above * above);
    return ProfilePoint{0.9 * sine(pi * t) * neck, -1.3 * cosine(pi * t)};
  };
  return revolve("vase", evenly_along(curve, spacing), segments, false);
}

Mesh torus(unsigned segments, unsigned tube_segments, double ring_radius, double tube_radius) {
  Mesh mesh;
  mesh.name = "torus";
  for (unsigned j = 0; j < tube_segments; ++j) {
    const TurnPoint at = turn_point(j, tube_segments);  // from the lowest circle outwards and up
    for (unsigned i = 0; i < segments; ++i)
      mesh.positions.push_back(
          on_circle(ring_radius + tube_radius * at.sine, 0.0 - tube_radius * at.cosine, i, segments));
  }
  for (unsigned j = 0; j < tube_segments; ++j) {
    const VertexId low = j * segments;
    const VertexId high = (j + 1) % tube_segments * segments;
    for (unsigned i = 0; i < segments; ++i) {
      const unsigned next = (i + 1) % segments;
      mesh.triangles.push_back({low + i, high + i, high + next});
      mesh.triangles.push_back({low + i, high + next, low + next});
    }
  }
  finish_edges(mesh);
  return mesh;
}

Mesh icosphere(unsigned subdivisions) {
  Mesh mesh;
  mesh.name = "icosphere";
  const double g = std::numbers::phi;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (glm::dvec3& p : mesh.positions) p = glm::normalize(p);
  finish_edges(mesh);
  for (unsigned step = 0; step < subdivisions; ++step) {
    const auto old_count = static_cast<VertexId>(mesh.positions.size());
    for (const auto& [a, b] : mesh.edges)
      mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
    const auto middle = [&](VertexId a, VertexId b) {
      const std::array<VertexId, 2> edge{std::min(a, b), std::max(a, b)};
      const auto at = std::lower_bound(mesh.edges.begin(), mesh.edges.end(), edge);
      return static_cast<VertexId>(old_count + (at - mesh.edges.begin()));
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const VertexId ab = middle(a, b);
      const VertexId bc = middle(b, c);
      const VertexId ca = middle(c, a);
      finer.insert(finer.end(), {Triangle{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
    finish_edges(mesh);
  }
  return mesh;
}

void write_obj(std::ostream& out, const Mesh& mesh, std::string_view comment) {
  std::string text;
  const auto append = [&](auto value) {
    std::array<char, 32> buffer{};
    const auto end = number_into(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(1, ' ').append(buffer.data(), end.ptr);
  };
  for (std::size_t at = 0; at < comment.size();) {
    const std::size_t end = std::min(comment.find('\n', at), comment.size());
    text.append("# ").append(comment.substr(at, end - at)).append("\n");
    at = end + 1;
  }
  for (const glm::dvec3& p : mesh.positions) {
    text += 'v';
    append(p.x);
    append(p.y);
    append(p.z);
    text += '\n';
  }
  for (const Triangle& t : mesh.triangles) {
    text += 'f';
    for (const VertexId v : t) append(std::size_t{v} + 1);
    text += '\n';
  }
  out << text;
}

}  // namespace knit
