// Yarn in files, each opened by a reader that knows nothing of the writer.
#include "app/yarn/yarn_files.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/files/export.h"
#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/session/view.h"
#include "app/yarn/stitch_mesh.h"
#include "knit/relax/relax.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"
#include "tests/support/short_tube.h"

using namespace app;

namespace {

using Places = std::vector<glm::vec3>;

class Bytes {
 public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes) {}
  std::string text(std::size_t count) {
    REQUIRE(at_ + count <= bytes_.size());
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }
  std::uint64_t number(std::size_t bytes) {
    const std::string raw = text(bytes);
    std::uint64_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) value = value << 8U | static_cast<unsigned char>(raw[i]);
    return value;
  }
  float real() { return std::bit_cast<float>(static_cast<std::uint32_t>(number(4))); }
  glm::vec3 place() {
    const float x = real(), y = real(), z = real();
    return {x, y, z};
  }
  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

// The curves of a binary curve collection: uniform Catmull-Rom, three dimensions, open.
std::vector<Places> read_bcc(const std::string& file) {
  Bytes bytes(file);
  REQUIRE(bytes.text(3) == "BCC");
  REQUIRE(bytes.number(1) == 0x44);
  REQUIRE(bytes.text(2) == "C0");
  REQUIRE(bytes.number(1) == 3);
  CHECK(bytes.number(1) == 1);
  const std::uint64_t curves = bytes.number(8), points = bytes.number(8);
  bytes.text(40);
  std::vector<Places> all(curves);
  std::uint64_t met = 0;
  for (Places& curve : all) {
    const auto count = static_cast<std::int32_t>(bytes.number(4));
    REQUIRE(count > 1);
    for (std::int32_t i = 0; i < count; ++i) curve.push_back(bytes.place());
    met += curve.size();
  }
  CHECK(met == points);
  CHECK(bytes.at_end());
  return all;
}

struct ReadYarn {
  Places points;
  float radius = 0.0F;
};
std::vector<ReadYarn> read_yarns(const std::string& file) {
  Bytes bytes(file);
  const auto chunk = [&](const char* name, std::size_t item) {
    REQUIRE(bytes.text(4) == name);
    const std::uint64_t size = bytes.number(4);
    REQUIRE(size % item == 0);
    return size / item;
  };
  Places points(chunk("f3..", 12));
  for (glm::vec3& point : points) point = bytes.place();
  REQUIRE(chunk("src.", 4) == points.size());
  bytes.text(4 * points.size());
  std::vector<ReadYarn> all(chunk("yarn", 16));
  for (ReadYarn& yarn : all) {
    const std::uint64_t begin = bytes.number(4), end = bytes.number(4);
    REQUIRE(begin < end);
    REQUIRE(end <= points.size());
    yarn.points.assign(points.begin() + static_cast<std::ptrdiff_t>(begin),
                       points.begin() + static_cast<std::ptrdiff_t>(end));
    yarn.radius = bytes.real();
    CHECK(bytes.text(4)[3] == '\xff');
  }
  CHECK(chunk("strs", 1) == 0);
  CHECK(chunk("unit", 12) == 0);
  CHECK(chunk("chk.", 12) == 0);
  CHECK(bytes.at_end());
  return all;
}

struct ReadLines {
  Places places;
  std::vector<std::vector<std::size_t>> lines;  // from 0
  std::vector<std::string> groups;              // of the lines
};
ReadLines read_obj(const std::string& file) {
  ReadLines read;
  std::istringstream text(file);
  std::string line, group;
  while (std::getline(text, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      glm::vec3 place;
      REQUIRE(words >> place.x >> place.y >> place.z);
      read.places.push_back(place);
    } else if (word == "g") {
      words >> group;
    } else if (word == "l") {
      read.lines.emplace_back();
      read.groups.push_back(group);
      for (std::size_t number = 0; words >> number;) read.lines.back().push_back(number - 1);
    } else {
      CHECK(word == "#");
    }
  }
  return read;
}

Session finished() { return test_support::finished_small_session(); }

knit::Yarn yarn_of(const Session& session) {
  const knit::Fabric fabric = shown_fabric(session);
  const knit::StitchSize& stitch = session.document->timeline.parameters().stitch;
  return knit::make_yarn(fabric, knit::relax(fabric, stitch, {}).positions, stitch);
}

std::uint32_t u32_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}
glm::vec3 vec3_at(const std::string& bytes, std::size_t at) {
  glm::vec3 value;
  std::memcpy(&value, bytes.data() + at, 12);
  return value;
}

}  // namespace

TEST_CASE("yarn files: a curve collection holds the control points") {
  const Session session = finished();
  const knit::Yarn yarn = yarn_of(session);
  const std::vector<Places> read = read_bcc(yarn_file(session, YarnFormat::bcc));
  REQUIRE(read.size() == yarn.curves.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    REQUIRE(read[i].size() == yarn.curves[i].points.size());
    for (std::size_t k = 0; k < read[i].size(); ++k)
      REQUIRE(glm::distance(read[i][k], glm::vec3(yarn.curves[i].points[k])) == 0.0F);
  }
}

TEST_CASE("yarn files: splines run along the curve") {
  const Session session = finished();
  const knit::Yarn yarn = yarn_of(session);
  const std::vector<ReadYarn> read = read_yarns(yarn_file(session, YarnFormat::yarns));
  REQUIRE(read.size() == yarn.curves.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const auto& curve = yarn.curves[i];
    CHECK(read[i].radius == static_cast<float>(curve.radius));
    REQUIRE(read[i].points.size() == 2 * (curve.points.size() - 1) + 1);
    // A quadratic B-spline is at (a + 6 b + c) / 8 in the middle of the stretch that b rules.
    double farthest = 0.0;
    for (std::size_t k = 1; k + 1 < curve.points.size(); ++k) {
      const glm::vec3 &a = read[i].points[2 * k - 1], &b = read[i].points[2 * k],
                      &c = read[i].points[2 * k + 1];
      const glm::vec3 there = (a + 6.0F * b + c) / 8.0F;
      farthest = std::max(farthest, glm::distance(glm::dvec3(there), curve.points[k]));
    }
    CHECK(farthest < 0.15 * curve.radius);
  }
}

TEST_CASE("yarn files: polylines are one unbroken way a yarn and a row a line") {
  const Session session = finished();
  const knit::Yarn yarn = yarn_of(session);
  const ReadLines read = read_obj(yarn_file(session, YarnFormat::obj));
  std::size_t places = 0, next = 0;
  for (const auto& curve : yarn.curves) places += 2 * (curve.points.size() - 1) + 1;
  REQUIRE(read.places.size() == places);
  for (const auto& line : read.lines) {
    REQUIRE(line.size() >= 2);
    CHECK((line.front() == next || line.front() == next + 1));
    for (std::size_t i = 1; i < line.size(); ++i) REQUIRE(line[i] == line[i - 1] + 1);
    next = line.back();
  }
  CHECK(next + 1 == read.places.size());
  CHECK(read.groups.front() == "row_001");
  const std::size_t rows = session.document->timeline.state().fabric.rows().size();
  CHECK(read.lines.size() == rows + 1);  // and what holds the last
}

TEST_CASE("yarn files: tubes are of the yarn's radius and look outwards") {
  const Session session = finished();
  const knit::Yarn yarn = yarn_of(session);
  const std::string file = yarn_file(session, YarnFormat::gltf_binary);
  REQUIRE(file.substr(0, 4) == "glTF");
  REQUIRE(u32_at(file, 8) == file.size());
  const std::size_t text = u32_at(file, 12);
  const auto json = nlohmann::json::parse(file.substr(20, text));
  const std::string buffer = file.substr(28 + text);
  REQUIRE(buffer.size() == json["buffers"][0]["byteLength"]);
  std::array<std::size_t, 3> begin{}, count{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& view = json["bufferViews"].at(json["accessors"].at(i)["bufferView"].get<std::size_t>());
    begin[i] = view["byteOffset"];
    count[i] = json["accessors"][i]["count"];
    REQUIRE(begin[i] + view["byteLength"].get<std::size_t>() <= buffer.size());
    CHECK(view["byteLength"] == count[i] * (i < 2 ? 12 : 4));
  }
  std::size_t vertices = 0;
  for (const auto& curve : yarn.curves) vertices += 6 * (2 * (curve.points.size() - 1) + 1);
  CHECK(count[0] == vertices);
  REQUIRE(count[1] == count[0]);
  const auto radius = static_cast<float>(yarn.curves[0].radius);
  glm::vec3 low(1e30F), high(-1e30F);
  for (std::size_t i = 0; i < count[0]; ++i) {
    const glm::vec3 at = vec3_at(buffer, begin[0] + 12 * i), out = vec3_at(buffer, begin[1] + 12 * i);
    low = glm::min(low, at);
    high = glm::max(high, at);
    REQUIRE(std::abs(glm::length(out) - 1.0F) < 1e-4F);
    // The sides opposite each other in a ring are twice the radius apart.
    const std::size_t opposite = i - i % 6 + (i % 6 + 3) % 6;
    REQUIRE(std::abs(glm::distance(at, vec3_at(buffer, begin[0] + 12 * opposite)) - 2.0F * radius) <
            0.01F * radius);
  }
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(json["accessors"][0]["min"][static_cast<std::size_t>(axis)] == low[axis]);
    CHECK(json["accessors"][0]["max"][static_cast<std::size_t>(axis)] == high[axis]);
  }
  std::size_t inward = 0;
  for (std::size_t i = 0; i < count[2]; i += 3) {
    std::array<glm::vec3, 3> at{};
    glm::vec3 out(0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = u32_at(buffer, begin[2] + 4 * (i + k));
      REQUIRE(vertex < count[0]);
      at[k] = vec3_at(buffer, begin[0] + 12 * vertex);
      out += vec3_at(buffer, begin[1] + 12 * vertex);
    }
    if (glm::dot(glm::cross(at[1] - at[0], at[2] - at[0]), out) <= 0.0F) ++inward;
  }
  // Where the yarn bends more sharply than it is thick, a tube folds.
  CHECK(inward < count[2] / 3 / 50);
  const double metres = session.document->timeline.parameters().stitch.centimetres_per_unit / 100.0;
  CHECK(json["nodes"][0]["scale"][0] == metres);
  const auto whole = nlohmann::json::parse(yarn_file(session, YarnFormat::gltf_text));
  CHECK(whole["accessors"] == json["accessors"]);
}

TEST_CASE("yarn files: the ending chooses and what is missing is said") {
  CHECK(yarn_format_of("a.OBJ") == YarnFormat::obj);
  CHECK(yarn_format_of("a.bcc") == YarnFormat::bcc);
  CHECK(yarn_format_of("a.yarns") == YarnFormat::yarns);
  CHECK(yarn_format_of("a.glb") == YarnFormat::gltf_binary);
  CHECK_FALSE(yarn_format_of("a.txt"));
  Session session = finished();
  CHECK_FALSE(yarn_missing(session));
  REQUIRE(find_export("yarn") != nullptr);
  CHECK(option_of(*find_export("yarn")) == "--save-yarn");
  session.document->timeline.seek(5);
  REQUIRE(yarn_missing(session));
  CHECK(export_to_file(session, {"yarn", "never.bcc"}));
  CHECK(export_to_file(session, {"yarn", "never.txt"}));
}

TEST_CASE("yarn files: of the thickness that is asked for, stuffed as the run is") {
  Session session = finished();
  YarnLook look;
  look.radius = 0.1;
  apply(session, SetYarnLook{look});
  const double width = session.document->timeline.parameters().stitch.width;
  CHECK(read_yarns(yarn_file(session, YarnFormat::yarns)).front().radius == static_cast<float>(0.1 * width));
  const std::string plain = yarn_file(session, YarnFormat::bcc);
  look.easing = 5;
  apply(session, SetYarnLook{look});
  const std::string eased = yarn_file(session, YarnFormat::bcc);
  CHECK(eased.size() == plain.size());
  CHECK(eased != plain);
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.relax.stuffing = 0.1;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  REQUIRE_FALSE(yarn_missing(session));
  const auto largest = [&](const std::string& file) {
    float size = 0.0F;
    for (const Places& curve : read_bcc(file)) {
      for (const glm::vec3& place : curve) size = std::max(size, glm::length(place));
    }
    return size;
  };
  CHECK(largest(yarn_file(session, YarnFormat::bcc)) > 1.01F * largest(eased));
}

namespace {

// A stitch mesh as its format's description has it.
struct ReadStitchMesh {
  struct ReadFace {
    std::vector<std::size_t> corners;
    std::vector<std::string> edges;  // of its kind
    std::string name;
  };
  std::size_t vertices = 0;
  std::vector<ReadFace> faces;
  std::size_t joined = 0, loops_joined = 0;
};

ReadStitchMesh read_smobj(const std::string& text) {
  ReadStitchMesh mesh;
  std::vector<std::vector<std::string>> library;
  std::istringstream lines(text);
  std::map<std::pair<std::size_t, std::size_t>, int> used;
  const auto side = [&](const std::string& word) {
    const std::size_t slash = word.find('/');
    return std::pair{std::stol(word.substr(0, slash)), std::stol(word.substr(slash + 1))};
  };
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string mark, word;
    words >> mark;
    if (mark == "L") {
      library.emplace_back();
      while (words >> word) library.back().push_back(word);
    } else if (mark == "v") {
      ++mesh.vertices;
    } else if (mark == "f") {
      mesh.faces.emplace_back();
      for (std::size_t corner = 0; words >> corner;) mesh.faces.back().corners.push_back(corner - 1);
    } else if (mark == "T") {
      std::size_t kind = 0;
      words >> kind;
      REQUIRE((kind >= 1 && kind <= library.size()));
      auto& face = mesh.faces.back();
      face.name = library[kind - 1].front();
      face.edges.assign(library[kind - 1].begin() + 1, library[kind - 1].end());
      REQUIRE(face.edges.size() == face.corners.size());
    } else if (mark == "e") {
      std::string first, second;
      words >> first >> second;
      const auto [a, edge_a] = side(first);
      const auto [b, edge_b] = side(second);
      const auto ends = [&](long face, long edge) {
        const auto& corners = mesh.faces.at(static_cast<std::size_t>(face - 1)).corners;
        const auto i = static_cast<std::size_t>(std::abs(edge) - 1);
        std::pair both{corners.at(i), corners.at((i + 1) % corners.size())};
        if (edge < 0) std::swap(both.first, both.second);
        return both;
      };
      const auto kind = [&](long face, long edge) {
        return mesh.faces.at(static_cast<std::size_t>(face - 1))
            .edges.at(static_cast<std::size_t>(std::abs(edge) - 1));
      };
      CHECK(ends(a, edge_a) == ends(b, edge_b));
      // What goes out of the one comes into the other.
      CHECK(kind(a, edge_a).substr(1) == kind(b, edge_b).substr(1));
      CHECK(kind(a, edge_a) != kind(b, edge_b));
      CHECK(++used[{static_cast<std::size_t>(a), static_cast<std::size_t>(edge_a)}] == 1);
      ++mesh.joined;
      if (kind(a, edge_a)[1] == 'l') ++mesh.loops_joined;
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("yarn files: a stitch mesh has its loops and its yarn go from face to face") {
  const Session session = finished();
  const knit::Fabric& fabric = session.document->timeline.state().fabric;
  const ReadStitchMesh mesh = read_smobj(smobj_text(fabric));
  CHECK(mesh.vertices == fabric.stitch_count());
  std::size_t faces = 0, columns = 0, inner = 0;
  for (const auto& strip : fabric.strips()) {
    faces += strip->faces.size();
    columns += strip->column_edges.size();
  }
  for (std::size_t i = 1; i + 1 < fabric.rows().size(); ++i) inner += fabric.rows()[i]->stitches.size();
  CHECK(mesh.faces.size() == faces);
  // The yarn goes over each column edge, a loop through each edge of a row but the first and the last.
  CHECK(mesh.joined - mesh.loops_joined == columns);
  CHECK(mesh.loops_joined == inner);
  std::map<std::string, std::size_t> named;
  for (const auto& face : mesh.faces) ++named[face.name];
  CHECK(named["knit-to-left"] > 0);
  CHECK(named["increase-to-left"] > 0);
  CHECK(named["decrease-to-left"] > 0);
  CHECK(named.size() == 3);
}
