// The mesh as settling walks on it: nearest places that are reached without going through the shape.
//
// A stitch that is moved off the surface goes to the nearest place that can be walked to from where it was: over triangles
// and their sides within the ball that reaches back to where it was, and none whose outside looks the other way. So it stays
// on its side of a thin sheet, however close the other side is. Cost: the triangles within the ball. Normals are those of the
// vertices, weighted by area and interpolated, of length 1. Mesh units.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"

namespace knit {

// Outwards, whatever way the triangles face [knit/mesh/outside.h]. Per vertex of the mesh, that of its twin; of length 1, or 0
// where no triangle with an area is.
struct VertexNormals {
  std::vector<glm::dvec3> normals;
  std::vector<std::uint8_t> inward;  // per triangle, as inward_triangles gives them
  [[nodiscard]] bool faces_in(std::uint32_t triangle) const {
    return !inward.empty() && inward[triangle] != 0;
  }
  [[nodiscard]] auto fields() const { return std::tie(normals, inward); }
  friend bool operator==(const VertexNormals&, const VertexNormals&) = default;
};
VertexNormals vertex_normals(const Input& input, const Heard& heard = {});

// Where a stitch is.
struct OnSurface {
  std::uint32_t triangle = 0;
  glm::dvec3 point{0.0};
  glm::dvec3 normal{0.0, 1.0, 0.0};
};

// Of a place on a triangle; `otherwise` where the corners' normals cancel out.
glm::dvec3 normal_at(const Input& input, const VertexNormals& normals, std::uint32_t triangle,
                     const glm::dvec3& point, const glm::dvec3& otherwise);

// Refers to what it is given, and keeps its memory from walk to walk.
class SurfaceWalk {
 public:
  SurfaceWalk() = default;
  SurfaceWalk(const Input& input, const VertexNormals& normals);
  void refer_to(const Input& input, const VertexNormals& normals);
  [[nodiscard]] OnSurface nearest(const OnSurface& from, const glm::dvec3& to);

 private:
  const Input* input_ = nullptr;
  const VertexNormals* normals_ = nullptr;
  std::vector<std::uint32_t> met_;  // per triangle: the walk that met it last
  std::uint32_t walks_ = 0;
  std::vector<std::uint32_t> queue_;
};

}  // namespace knit
