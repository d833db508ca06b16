#include "app/files/gltf.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "app/base/glb.h"
#include "app/base/text.h"
#include "app/describe/describe_step.h"
#include "app/describe/thing_places.h"
#include "app/session/document.h"
#include "app/session/shown.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

constexpr int mode_lines = 1, mode_triangles = 4;

void append_u16(std::string& bytes, std::uint16_t value) {
  bytes += static_cast<char>(static_cast<unsigned char>(value & 0xffU));
  bytes += static_cast<char>(static_cast<unsigned char>(value >> 8U));
}

// Colours on a screen are sRGB; the standard wants them linear.
double linear_of(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
std::uint16_t linear_u16(std::uint8_t channel) {
  return static_cast<std::uint16_t>(std::lround(65535.0 * linear_of(channel)));
}

class GltfDocument {
 public:
  explicit GltfDocument(const Session& session)
      : state_(shown_state(session)),
        metres_(session.document->timeline.parameters().stitch.centimetres_per_unit / 100.0) {
    add_faces();
    add_lines();
  }

  [[nodiscard]] std::string binary() const { return glb_of(json(false).dump(), buffer_); }
  [[nodiscard]] std::string text() const { return json(true).dump(1) + "\n"; }

 private:
  // Gives the accessor's number. All are of multiples of four bytes, so that each begins at one.
  int add_view(const std::string& bytes, int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}, {"target", target}});
    buffer_ += bytes;
    return static_cast<int>(views_.size()) - 1;
  }
  int add_accessor(int view, int component, std::size_t count, const char* type) {
    accessors_.push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(accessors_.size()) - 1;
  }
  int add_positions(std::span<const glm::vec3> places) {
    std::string bytes;
    glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& place : places) {
      append_vec3(bytes, place);
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], place[i]);
        high[i] = std::max(high[i], place[i]);
      }
    }
    const int at = add_accessor(add_view(bytes, gltf_vertices), gltf_f32, places.size(), "VEC3");
    accessors_.back()["min"] = {low.x, low.y, low.z};
    accessors_.back()["max"] = {high.x, high.y, high.z};
    return at;
  }
  int add_indices(const std::vector<std::uint32_t>& indices) {
    std::string bytes;
    for (const std::uint32_t index : indices) append_u32(bytes, index);
    return add_accessor(add_view(bytes, gltf_indices), gltf_u32, indices.size(), "SCALAR");
  }
  int add_material(const char* name, const glm::dvec3& colour) {
    materials_.push_back({{"name", name},
                          {"pbrMetallicRoughness",
                           {{"baseColorFactor", {colour.r, colour.g, colour.b, 1.0}},
                            {"metallicFactor", 0.0},
                            {"roughnessFactor", 0.9}}},
                          {"doubleSided", true}});
    return static_cast<int>(materials_.size()) - 1;
  }
  static glm::dvec3 linear(Colour c) { return {linear_of(c.r), linear_of(c.g), linear_of(c.b)}; }

  // Flat, so that colours do not run into each other: three vertices a triangle, as they are shown.
  void add_faces() {
    std::vector<glm::vec3> places;
    std::string normals, colours;
    const knit::KnittingPath path(state_.fabric);
    for (const knit::Strip& strip : all_strips()) {
      const FaceShape shape = faces_of(light_theme, strip, strip.faces.size(), path);
      for (const FaceShape::Face& face : shape.faces) {
        const auto& [a, b, c, d] = face.corners;
        places.insert(places.end(), {a, b, c});
        if (face.is_quad()) places.insert(places.end(), {a, c, d});
        for (int corner = 0; corner < (face.is_quad() ? 6 : 3); ++corner) {
          append_vec3(normals, face.normal);
          for (const std::uint8_t channel : {face.colour.r, face.colour.g, face.colour.b})
            append_u16(colours, linear_u16(channel));
          append_u16(colours, 65535);
        }
      }
    }
    if (places.empty()) return;
    Json attributes;
    attributes["POSITION"] = add_positions(places);
    attributes["NORMAL"] = add_accessor(add_view(normals, gltf_vertices), gltf_f32, places.size(), "VEC3");
    attributes["COLOR_0"] = add_accessor(add_view(colours, gltf_vertices), gltf_u16, places.size(), "VEC4");
    accessors_.back()["normalized"] = true;
    const int material = add_material("faces by label", glm::dvec3(1.0));
    primitives_.push_back({{"attributes", attributes}, {"material", material}, {"mode", mode_triangles}});
  }

  // Those of rows, and what deals sew together.
  [[nodiscard]] std::vector<knit::Strip> all_strips() const {
    std::vector<knit::Strip> strips;
    for (const auto& strip : state_.fabric.strips()) strips.push_back(*strip);
    for (const auto& deal : state_.fabric.deals()) {
      if (is_sewn(state_.fabric, *deal)) strips.push_back(strip_of(*deal));
    }
    return strips;
  }

  // Places are the knitting path's, bridges between rows too: what strips count by.
  void add_lines() {
    const knit::Fabric& fabric = state_.fabric;
    std::vector<glm::vec3> places;
    for (const glm::dvec3& place : knit::knitting_path(fabric)) places.emplace_back(place);
    std::vector<std::uint32_t> rows, columns;
    for (const auto& row : fabric.rows()) {
      const std::uint32_t first = fabric.first_on_path(row->id);
      for (const auto& [from, to] : knit::edges_of(*row)) {
        rows.push_back(first + static_cast<std::uint32_t>(from));
        rows.push_back(first + static_cast<std::uint32_t>(to));
      }
    }
    for (const auto& deal : fabric.deals()) {
      for (const auto& edge : edges_added(*deal)) {
        for (const knit::StitchRef& end : edge) rows.push_back(fabric.path_index(end));
      }
    }
    for (const knit::Strip& strip : all_strips()) {
      for (const auto& edge : strip.column_edges) columns.insert(columns.end(), edge.begin(), edge.end());
    }
    const int positions = add_positions(places);
    const auto add = [&](const std::vector<std::uint32_t>& indices, const char* name, Colour colour) {
      if (indices.empty()) return;
      const int at = add_indices(indices);
      const int material = add_material(name, linear(colour));
      primitives_.push_back({{"attributes", {{"POSITION", positions}}},
                             {"indices", at},
                             {"material", material},
                             {"mode", mode_lines}});
    };
    add(rows, "row edges", light_theme.row_edge);
    add(columns, "column edges", light_theme.column_edge);
  }

  [[nodiscard]] Json json(bool embedded) const {
    Json buffer{{"byteLength", buffer_.size()}};
    if (embedded) {
      const std::vector<std::uint8_t> bytes(buffer_.begin(), buffer_.end());
      buffer["uri"] = "data:application/octet-stream;base64," + base64(bytes);
    }
    Json file;
    file["asset"] = {{"version", "2.0"},
                     {"generator", "knit-mesh"},
                     {"extras", {{"metres_per_mesh_unit", metres_}, {"rows", state_.fabric.rows().size()}}}};
    file["scene"] = 0;
    file["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
    file["nodes"] =
        Json::array({{{"name", "knit mesh"}, {"mesh", 0}, {"scale", {metres_, metres_, metres_}}}});
    file["meshes"] = Json::array({{{"name", "knit mesh"}, {"primitives", primitives_}}});
    file["materials"] = materials_;
    file["accessors"] = accessors_;
    file["bufferViews"] = views_;
    file["buffers"] = Json::array({buffer});
    return file;
  }

  const knit::State state_;
  double metres_;  // a mesh unit
  std::string buffer_;
  Json views_ = Json::array(), accessors_ = Json::array(), materials_ = Json::array(),
       primitives_ = Json::array();
};

}  // namespace

std::optional<GltfFormat> gltf_format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".glb") return GltfFormat::binary;
  if (ending == ".gltf") return GltfFormat::text;
  return std::nullopt;
}

std::optional<std::string> gltf_missing(const Session& session) {
  if (!session.document->timeline.state().fabric.empty()) return std::nullopt;
  if (stop_shown(session) != nullptr)
    return "the run stopped before the cast on, so there is nothing to write as glTF.";
  return "there is nothing knit yet to write as glTF; go on until the cast on is done.";
}

std::string gltf_file(const Session& session, GltfFormat format) {
  const GltfDocument document(session);
  return format == GltfFormat::binary ? document.binary() : document.text();
}

}  // namespace app
