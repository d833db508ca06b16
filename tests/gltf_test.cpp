// glTF by a reader of its own that lets nothing pass.
#include "app/files/gltf.h"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/describe/describe_step.h"
#include "app/files/export.h"
#include "app/session/document.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using Json = nlohmann::json;

namespace {

std::uint32_t u32_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

struct Gltf {
  Json json;
  std::string buffer;
};

std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const auto value = letters.find(c);
    REQUIRE(value != std::string::npos);
    bits = bits << 6U | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count));
  }
  return bytes;
}

Gltf read_binary(const std::string& file) {
  REQUIRE(file.size() >= 28);
  CHECK(file.substr(0, 4) == "glTF");
  CHECK(u32_at(file, 4) == 2);
  CHECK(u32_at(file, 8) == file.size());
  const std::size_t text = u32_at(file, 12);
  CHECK(text % 4 == 0);
  CHECK(file.substr(16, 4) == "JSON");
  const std::size_t data = u32_at(file, 20 + text);
  CHECK(data % 4 == 0);
  CHECK(file.substr(24 + text, 4) == std::string("BIN\0", 4));
  REQUIRE(28 + text + data == file.size());
  return {Json::parse(file.substr(20, text)), file.substr(28 + text)};
}

Gltf read_text(const std::string& file) {
  Gltf gltf{Json::parse(file), ""};
  const std::string uri = gltf.json["buffers"][0]["uri"];
  const std::string head = "data:application/octet-stream;base64,";
  REQUIRE(uri.substr(0, head.size()) == head);
  gltf.buffer = from_base64(uri.substr(head.size()));
  return gltf;
}

std::size_t components_of(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

// The numbers of an accessor, row by row; every rule on the way is checked.
std::vector<std::vector<double>> values_of(const Gltf& gltf, std::size_t accessor) {
  const Json& a = gltf.json["accessors"].at(accessor);
  const Json& view = gltf.json["bufferViews"].at(a["bufferView"].get<std::size_t>());
  const int component = a["componentType"];
  const std::size_t size = component == 5123 ? 2 : 4;
  const std::size_t width = components_of(a["type"]);
  REQUIRE(width > 0);
  const std::size_t offset = view["byteOffset"], length = view["byteLength"], count = a["count"];
  CHECK(view["buffer"] == 0);
  CHECK(count > 0);
  CHECK(offset % size == 0);
  CHECK(size * width % 4 == 0);  // of vertices: each begins at a multiple of four
  CHECK(count * size * width == length);
  REQUIRE(offset + length <= gltf.buffer.size());
  std::vector<std::vector<double>> values(count, std::vector<double>(width));
  for (std::size_t i = 0; i < count * width; ++i) {
    const std::size_t at = offset + i * size;
    double value = 0.0;
    if (component == 5126) value = static_cast<double>(std::bit_cast<float>(u32_at(gltf.buffer, at)));
    if (component == 5125) value = u32_at(gltf.buffer, at);
    if (component == 5123)
      value = (static_cast<unsigned char>(gltf.buffer[at]) +
               256 * static_cast<unsigned char>(gltf.buffer[at + 1])) /
              65535.0;
    values[i / width][i % width] = value;
  }
  return values;
}

glm::dvec3 vec(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

void check_bounds(const Gltf& gltf, std::size_t accessor) {
  const Json& a = gltf.json["accessors"].at(accessor);
  const auto places = values_of(gltf, accessor);
  for (std::size_t c = 0; c < 3; ++c) {
    double low = 1e300, high = -1e300;
    for (const auto& place : places) {
      low = std::min(low, place[c]);
      high = std::max(high, place[c]);
    }
    CHECK(a["min"][c].get<double>() == low);
    CHECK(a["max"][c].get<double>() == high);
  }
}

const Json& primitive_of(const Gltf& gltf, const std::string& material) {
  for (const Json& primitive : gltf.json["meshes"][0]["primitives"]) {
    if (gltf.json["materials"].at(primitive["material"].get<std::size_t>())["name"] == material)
      return primitive;
  }
  FAIL("no primitive of " << material);
  return gltf.json;
}

double screen_of(double linear) {
  return 255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

std::size_t triangles_in(const knit::State& state) {
  std::size_t count = 0;
  for (const auto& strip : state.fabric.strips()) {
    for (const knit::Face& face : strip->faces) count += static_cast<std::size_t>(face.corner_count) - 2;
  }
  return count;
}

}  // namespace

TEST_CASE("glTF holds the faces in their colours with normals outward") {
  const Session session = test_support::finished_small_session();
  const knit::State& state = session.document->timeline.state();
  const Gltf gltf = read_binary(gltf_file(session, GltfFormat::binary));
  CHECK(gltf.json["asset"]["version"] == "2.0");
  CHECK(gltf.json["buffers"][0]["byteLength"] == gltf.buffer.size());
  CHECK_FALSE(gltf.json["buffers"][0].contains("uri"));
  const Json& faces = primitive_of(gltf, "faces by label");
  CHECK(faces["mode"] == 4);
  const Json& attributes = faces["attributes"];
  check_bounds(gltf, attributes["POSITION"]);
  const auto places = values_of(gltf, attributes["POSITION"]);
  const auto normals = values_of(gltf, attributes["NORMAL"]);
  const auto colours = values_of(gltf, attributes["COLOR_0"]);
  CHECK(gltf.json["accessors"][attributes["COLOR_0"].get<std::size_t>()]["normalized"] == true);
  REQUIRE(places.size() == 3 * triangles_in(state));
  REQUIRE(normals.size() == places.size());
  REQUIRE(colours.size() == places.size());
  std::size_t outward = 0, wound = 0, of_labels = 0;
  for (std::size_t i = 0; i < places.size(); i += 3) {
    const glm::dvec3 a = vec(places[i]), b = vec(places[i + 1]), c = vec(places[i + 2]);
    const glm::dvec3 normal = vec(normals[i]);
    CHECK(glm::length(normal) == Approx(1.0).margin(1e-5));
    outward += glm::dot(normal, a + b + c) > 0.0 ? 1U : 0U;  // of a ball around the origin
    wound += glm::dot(glm::cross(b - a, c - a), normal) >= 0.0 ? 1U : 0U;
    for (int label = 0; label < 7; ++label) {
      const Colour wanted = light_theme.of(static_cast<knit::Label>(label));
      const bool same = std::abs(screen_of(colours[i][0]) - wanted.r) < 0.6 &&
                        std::abs(screen_of(colours[i][1]) - wanted.g) < 0.6 &&
                        std::abs(screen_of(colours[i][2]) - wanted.b) < 0.6;
      of_labels += same ? 1U : 0U;
    }
    CHECK(colours[i][3] == 1.0);
  }
  CHECK(outward == places.size() / 3);
  CHECK(wound == places.size() / 3);
  CHECK(of_labels == places.size() / 3);
}

TEST_CASE("glTF holds row edges and column edges as lines, and metres by the gauge") {
  const Session session = test_support::finished_small_session();
  const knit::State& state = session.document->timeline.state();
  const Gltf gltf = read_text(gltf_file(session, GltfFormat::text));
  std::size_t stitches = 0, columns = 0;
  for (const auto& row : state.fabric.rows()) stitches += row->stitches.size();
  for (const auto& strip : state.fabric.strips()) columns += strip->column_edges.size();
  const Json& rows = primitive_of(gltf, "row edges");
  CHECK(rows["mode"] == 1);
  check_bounds(gltf, rows["attributes"]["POSITION"]);
  CHECK(values_of(gltf, rows["attributes"]["POSITION"]).size() == stitches);
  const auto row_ends = values_of(gltf, rows["indices"]);
  CHECK(row_ends.size() == 2 * stitches);  // closed rows
  const Json& walls = primitive_of(gltf, "column edges");
  CHECK(walls["mode"] == 1);
  const auto column_ends = values_of(gltf, walls["indices"]);
  CHECK(column_ends.size() == 2 * columns);
  for (const auto* ends : {&row_ends, &column_ends}) {
    for (const auto& end : *ends) CHECK(end[0] < static_cast<double>(stitches));
  }
  const double metres = session.document->timeline.parameters().stitch.centimetres_per_unit / 100.0;
  CHECK(gltf.json["nodes"][0]["scale"] == Json({metres, metres, metres}));
  CHECK(gltf.json["asset"]["extras"]["metres_per_mesh_unit"] == metres);
}

TEST_CASE("both forms of glTF say the same, every time") {
  const Session session = test_support::finished_small_session();
  const std::string binary = gltf_file(session, GltfFormat::binary);
  CHECK(binary == gltf_file(session, GltfFormat::binary));
  Gltf a = read_binary(binary), b = read_text(gltf_file(session, GltfFormat::text));
  CHECK(a.buffer.substr(0, b.buffer.size()) == b.buffer);
  b.json["buffers"][0].erase("uri");
  CHECK(a.json == b.json);
}

TEST_CASE("before faces are made glTF has only rows, and before rows it says so") {
  Session session = test_support::small_session();
  CHECK(gltf_missing(session).has_value());
  const test_support::Folder folder;
  const auto early = export_to_file(session, {"gltf", folder.path() / "x.glb"});
  REQUIRE(early.has_value());
  CHECK(test_support::is_one_sentence(*early));
  apply(session, SeekPlace{{knit::Stage::rows, 5, 0}});
  CHECK_FALSE(gltf_missing(session).has_value());
  const Gltf gltf = read_binary(gltf_file(session, GltfFormat::binary));
  CHECK(gltf.json["meshes"][0]["primitives"].size() == 1);
  primitive_of(gltf, "row edges");
  const auto odd = export_to_file(session, {"gltf", folder.path() / "x.obj"});
  REQUIRE(odd.has_value());
  CHECK(test_support::is_one_sentence(*odd));
  CHECK(test_support::contains(*odd, ".glb"));
  CHECK(folder.files() == 0);
  CHECK_FALSE(export_to_file(session, {"gltf", folder.path() / "X.GLB"}).has_value());
  CHECK(folder.files() == 1);
}
