// Yarn as tubes in glTF 2.0.
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/base/glb.h"
#include "app/base/text.h"
#include "app/yarn/yarn_files.h"
#include "knit/mesh/elementary.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t sides = 6;

glm::dvec3 across(const glm::dvec3& along) {
  const bool steep = std::abs(along.x) > 0.5;
  return glm::normalize(glm::cross(along, steep ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
}

// Rings of vertices; a ring's first side is carried on from the ring before, so that tubes do not twist.
struct Tubes {
  std::string positions, normals, indices;
  glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
  std::uint32_t vertices = 0, corners = 0;

  void add(const knit::YarnCurve& curve) {
    const std::vector<glm::dvec3> places = knit::sampled(curve, yarn_places_a_point);
    glm::dvec3 side(0.0);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const glm::dvec3 way = places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0];
      if (glm::length(way) == 0.0) continue;
      const glm::dvec3 along = glm::normalize(way);
      side -= glm::dot(side, along) * along;
      side = glm::length(side) > 1e-6 ? glm::normalize(side) : across(along);
      add_ring(places[i], side, glm::cross(along, side), curve.radius);
      if (i > 0) add_faces();
    }
  }

 private:
  void add_ring(const glm::dvec3& place, const glm::dvec3& x, const glm::dvec3& y, double radius) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      const glm::dvec3 out = knit::cosine(angle) * x + knit::sine(angle) * y;
      const glm::vec3 at(place + radius * out);
      append_vec3(positions, at);
      append_vec3(normals, glm::vec3(out));
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
    vertices += sides;
  }
  void add_faces() {
    const std::uint32_t now = vertices - sides, before = now - sides;
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t next = (i + 1) % sides;
      for (const std::uint32_t corner :
           {before + i, before + next, now + next, before + i, now + next, now + i})
        append_u32(indices, corner);
      corners += 6;
    }
  }
};

Json json_of(const Tubes& tubes, double metres, std::size_t curves) {
  Json file;
  file["asset"] = {{"version", "2.0"},
                   {"generator", "knit-mesh"},
                   {"extras", {{"metres_per_mesh_unit", metres}, {"yarns", curves}}}};
  file["scene"] = 0;
  file["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
  file["nodes"] = Json::array({{{"name", "yarn"}, {"mesh", 0}, {"scale", {metres, metres, metres}}}});
  file["meshes"] =
      Json::array({{{"name", "yarn"},
                    {"primitives", Json::array({{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}},
                                                 {"indices", 2},
                                                 {"material", 0},
                                                 {"mode", 4}}})}}});
  file["materials"] = Json::array(
      {{{"name", "wool"},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.68, 0.58, 0.39, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}},
        {"doubleSided", true}}});
  file["accessors"] = Json::array(
      {{{"bufferView", 0},
        {"componentType", gltf_f32},
        {"count", tubes.vertices},
        {"type", "VEC3"},
        {"min", {tubes.low.x, tubes.low.y, tubes.low.z}},
        {"max", {tubes.high.x, tubes.high.y, tubes.high.z}}},
       {{"bufferView", 1}, {"componentType", gltf_f32}, {"count", tubes.vertices}, {"type", "VEC3"}},
       {{"bufferView", 2}, {"componentType", gltf_u32}, {"count", tubes.corners}, {"type", "SCALAR"}}});
  std::size_t begin = 0;
  file["bufferViews"] = Json::array();
  const auto add_view = [&](const std::string& bytes, int target) {
    file["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size()}, {"target", target}});
    begin += bytes.size();
  };
  add_view(tubes.positions, gltf_vertices);
  add_view(tubes.normals, gltf_vertices);
  add_view(tubes.indices, gltf_indices);
  return file;
}

}  // namespace

std::string yarn_gltf(const knit::Yarn& yarn, double metres, bool binary) {
  Tubes tubes;
  for (const knit::YarnCurve& curve : yarn.curves) tubes.add(curve);
  const std::string buffer = tubes.positions + tubes.normals + tubes.indices;
  Json json = json_of(tubes, metres, yarn.curves.size());
  json["buffers"] = Json::array({{{"byteLength", buffer.size()}}});
  if (!binary) {
    const std::vector<std::uint8_t> bytes(buffer.begin(), buffer.end());
    json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes);
    return json.dump(1) + "\n";
  }
  return glb_of(json.dump(), buffer);
}

}  // namespace app
