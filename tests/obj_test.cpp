#include "knit/import/obj.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <random>
#include <sstream>

#include "knit/import/check.h"
#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"

using namespace knit;

namespace {

std::variant<Mesh, ObjError> read(const std::string& text) {
  std::istringstream in(text);
  return read_obj(in, "test.obj");
}

Mesh mesh_of(const std::string& text) {
  auto result = read(text);
  INFO(text);
  if (const auto* error = std::get_if<ObjError>(&result)) FAIL(error->sentence);
  return std::get<Mesh>(std::move(result));
}

// The error, or nothing where there is a mesh; always one line that names the file and ends as a sentence.
std::string error_of(const std::variant<Mesh, ObjError>& result) {
  const auto* error = std::get_if<ObjError>(&result);
  if (error == nullptr) return {};
  CHECK(error->sentence.find('\n') == std::string::npos);
  CHECK((error->sentence.back() == '.' || error->sentence.back() == '?'));
  return error->sentence;
}

std::string error_of(const std::string& text) {
  const std::string sentence = error_of(read(text));
  INFO(sentence);
  CHECK((sentence.empty() || sentence.starts_with("test.obj")));
  return sentence;
}

bool mentions(const std::string& sentence, const std::string& part) {
  return sentence.find(part) != std::string::npos;
}

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string tetrahedron = corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    sum += 0.5 * glm::length(glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                        mesh.positions[t[2]] - mesh.positions[t[0]]));
  }
  return sum;
}

// A folder of its own for each test, gone afterwards.
struct Folder {
  std::filesystem::path path;
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "knit-obj-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path = pattern;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }
};

}  // namespace

TEST_CASE("obj: a tetrahedron in all the ways that OBJ allows", "[obj]") {
  const Mesh plain = mesh_of(tetrahedron);
  CHECK(plain.name == "test.obj");
  CHECK(plain.positions == std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(plain.triangles == std::vector<Triangle>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  CHECK(plain.edges == std::vector<std::array<VertexId, 2>>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});

  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
      text.replace(at, from.size(), to);
    }
    return text;
  };
  for (const std::string& same : {
           replaced(tetrahedron, "\n", "\r\n"),
           replaced(tetrahedron, "\n", "\r"),
           replaced(tetrahedron, "\n", "\n\n# a comment\\\n \t\n"),
           replaced(tetrahedron, "\n", " \t\n"),
           replaced(tetrahedron, " ", "\t"),
           replaced(tetrahedron, " ", "   "),
           replaced(tetrahedron, "f 1 ", "f 1 \\\n  "),
           replaced(tetrahedron, "f 1 ", "f 1 \\\r\n"),
           replaced(replaced(tetrahedron, "v ", "  v "), "f ", " f "),
           "\xEF\xBB\xBF" + tetrahedron,
           "mtllib a b\\\no thing\ng one two\ns off\nusemtl red\n" + tetrahedron +
               "l 1 2\np 1\nvw 1 99999999999999\n",
           corners + "f 1/1/1 3/2 2//3\nf 1// 2/ 4/1/\nf 1 4 3 # last but one\nf 2 3 4 #",
           corners + "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1",
           "f 1 3 2\nf 1 2 4\n" + corners + "f 1 4 3\nf 2 3 4",
           "v 0. -0 +0 1.0\nv 1e0 .0e5 0 0.5 0.5 0.5\nv 0 10.0E-1 0\nv 0 0 +1.000 # corner\n" +
               tetrahedron.substr(corners.size()),
       }) {
    INFO(same);
    const Mesh mesh = mesh_of(same);
    CHECK(mesh.positions == plain.positions);
    CHECK(mesh.triangles == plain.triangles);
    CHECK(mesh.edges == plain.edges);
  }
}

TEST_CASE("obj: numbers are doubles", "[obj]") {
  const Mesh mesh = mesh_of("v 0.1 12345678.123456789 -1e-7\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(mesh.positions[0].x == Approx(0.1).epsilon(1e-15));
  CHECK(mesh.positions[0].y == Approx(12345678.123456789).epsilon(1e-15));
  CHECK(mesh.positions[0].z == Approx(-1e-7).epsilon(1e-14));
}

TEST_CASE("obj: a quad is cut along its shorter diagonal and drawn without it", "[obj]") {
  const Mesh wide = mesh_of("v 0 0 0\nv 3 0 0\nv 4 1 0\nv 1 1 0\nf 1 2 3 4\n");
  CHECK(wide.triangles == std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}});
  CHECK(wide.edges == std::vector<std::array<VertexId, 2>>{{0, 1}, {0, 3}, {1, 2}, {2, 3}});
  const Mesh turned = mesh_of("v 0 0 0\nv 3 0 0\nv 4 1 0\nv 1 1 0\nf 2 3 4 1\n");
  CHECK(turned.triangles == std::vector<Triangle>{{1, 2, 3}, {1, 3, 0}});
}

TEST_CASE("obj: a concave quad is cut inside, even where that diagonal is longer", "[obj]") {
  // An arrow head whose notch is corner 4: the diagonal 1-3 lies outside.
  const std::string arrow = "v 0 0 0\nv 1 3 0\nv 2 0 0\nv 1 0.5 0\n";
  CHECK(area(mesh_of(arrow + "f 1 2 3 4\n")) == Approx(2.5));
  CHECK(area(mesh_of(arrow + "f 2 3 4 1\n")) == Approx(2.5));
  CHECK(area(mesh_of(arrow + "f 4 3 2 1\n")) == Approx(2.5));
}

TEST_CASE("obj: polygons keep area and direction, convex, concave, in any plane", "[obj]") {
  struct Case {
    std::vector<glm::dvec2> points;
    double area;
  };
  std::vector<Case> cases{
      {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3.0},                  // an L
      {{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 5.0},  // a U
      {{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}, 4.0},  // corners on straight edges
      {{{0, 0}, {5, 0}, {5, 5}, {1, 5}, {1, 2}, {3, 2}, {3, 3}, {2, 3}, {2, 4}, {4, 4}, {4, 1}, {0, 1}},
       15.0},
  };
  Case star;
  for (unsigned long i = 0; i < 24; ++i) {
    const TurnPoint at = turn_point(i, 24);
    const double r = i % 2 == 0 ? 2.0 : 0.5;
    star.points.push_back({r * at.cosine, r * at.sine});
  }
  star.area = 24 * 0.5 * 2.0 * 0.5 * turn_point(1, 24).sine;
  cases.push_back(star);

  const glm::dvec3 axes[][2] = {{{1, 0, 0}, {0, 1, 0}},
                                {{0, 1, 0}, {1, 0, 0}},
                                {{0, 0, 1}, {0, 1, 0}},
                                {{1, 0, 0}, {0, 0, -1}},
                                {{0.6, 0.8, 0}, {0, 0, 1}}};
  for (const Case& shape : cases) {
    for (const auto& [u, v] : axes) {
      for (std::size_t shift = 0; shift < shape.points.size(); ++shift) {
        std::ostringstream text;
        text.precision(17);
        for (const glm::dvec2& p : shape.points) {
          const glm::dvec3 q = u * p.x + v * p.y;
          text << "v " << q.x << ' ' << q.y << ' ' << q.z << '\n';
        }
        text << 'f';
        for (std::size_t i = 0; i < shape.points.size(); ++i)
          text << ' ' << (i + shift) % shape.points.size() + 1;
        const Mesh mesh = mesh_of(text.str() + "\n");
        CHECK(mesh.triangles.size() == shape.points.size() - 2);
        CHECK(mesh.edges.size() == shape.points.size());
        CHECK(area(mesh) == Approx(shape.area));
        const glm::dvec3 normal = glm::cross(u, v);
        for (const Triangle& t : mesh.triangles) {
          const glm::dvec3 n = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                          mesh.positions[t[2]] - mesh.positions[t[0]]);
          CHECK(glm::dot(n, normal) > 1e-9);
        }
      }
    }
  }
}

TEST_CASE("obj: a closed solid of polygons stays closed", "[obj]") {
  // A prism over an L, and one over a polygon of 300 corners (tinyobjloader's arrays hold at most 255).
  for (const unsigned long n : {6ul, 300ul}) {
    std::ostringstream text;
    text.precision(17);
    const double l[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const int z : {0, 1}) {
      for (unsigned long i = 0; i < n; ++i) {
        const TurnPoint at = turn_point(i, n);
        text << "v " << (n == 6 ? l[i][0] : at.cosine) << ' ' << (n == 6 ? l[i][1] : at.sine) << ' ' << z
             << '\n';
      }
    }
    text << 'f';
    for (unsigned long i = n; i > 0; --i) text << ' ' << i;
    text << "\nf";
    for (unsigned long i = 1; i <= n; ++i) text << ' ' << n + i;
    text << '\n';
    for (unsigned long i = 0; i < n; ++i) {
      const unsigned long next = (i + 1) % n;
      text << "f " << i + 1 << ' ' << next + 1 << ' ' << n + next + 1 << ' ' << n + i + 1 << '\n';
    }
    const Mesh mesh = mesh_of(text.str());
    CHECK(mesh.triangles.size() == 2 * (n - 2) + 2 * n);
    CHECK(mesh.edges.size() == 3 * n);
    const CheckResult result = check(mesh);
    CHECK(result.findings.empty());
  }
}

TEST_CASE("obj: polygons with no clear inside still get their triangles", "[obj]") {
  CHECK(mesh_of("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n").triangles.size() == 2);  // crossed
  CHECK(mesh_of("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 3 3 3\nf 1 2 3 4 5\n").triangles.size() == 3);
  CHECK(mesh_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nf 1 2 3 4 5\n").triangles.size() ==
        3);  // a line
  CHECK(mesh_of("v 0 0 0\nv 1 0 0\nf 1 1 2 2 1 2\n").triangles.size() == 4);
  CHECK(mesh_of("v 0 0 0\nv 1e999 0 0\nv 1 1e308 0\nv -1e308 1 1e308\nf 1 2 3 4\nf 1 2 3 4 1\n")
            .triangles.size() == 5);
}

TEST_CASE("obj: what is not OBJ is refused in one sentence", "[obj]") {
  CHECK(mentions(error_of(""), "is empty"));
  CHECK(mentions(error_of("\xEF\xBB\xBF"), "no vertices"));
  CHECK(mentions(error_of("\n\n\n"), "no vertices"));
  CHECK(mentions(error_of("Dear Sir or Madam,\nhow are you?\n"), "no vertices"));
  CHECK(mentions(error_of("- one\n- two\n"), "line 1: a line that begins with \"-\" is not OBJ"));
  CHECK(mentions(error_of(std::string("solid\0\x80\x3f", 8)), "is not text"));
  CHECK(mentions(error_of(std::string("v\0 \0"
                                      "0\0",
                                      6)),
                 "is not text"));
  CHECK(mentions(error_of("\x89PNG\r\n\x1a\nabc"), "line 1"));
  CHECK(mentions(error_of("V 0 0 0\nf 1 1 1\n"), "line 1"));
  CHECK(error_of(corners).empty());
  CHECK(check(mesh_of(corners)).findings.at(0).kind == FindingKind::no_triangles);
}

TEST_CASE("obj: coordinates are never repaired", "[obj]") {
  for (const char* bad : {"nan",
                          "inf",
                          "-inf",
                          "NaN",
                          "1,5",
                          "abc",
                          "1.0f",
                          "0x10",
                          "1e",
                          "1e+",
                          "1e5x",
                          ".",
                          "-",
                          "+-1",
                          "1.2.3",
                          "--1",
                          "1e99999999999",
                          "1d5",
                          "\xE2\x88\x92"
                          "1",
                          "1;",
                          "\"1\"",
                          "1\xA0",
                          "1e2147483649"}) {
    const std::string sentence = error_of("v 0 0 0\nv 0 " + std::string(bad) + " 0\n");
    INFO(bad);
    CHECK(mentions(sentence, "line 2"));
    CHECK(mentions(sentence, "decimal number"));
  }
  CHECK(mentions(error_of("v 0 0 0\nv 1 2\n"), "line 2: a vertex needs three coordinates"));
  CHECK(mentions(error_of("v 0 0 0\nv\n"), "line 2: a vertex needs three coordinates"));
  CHECK(mentions(error_of(tetrahedron + "v"), "line 9"));
  CHECK(mentions(error_of("v 0 0 # 0\n"), "line 1"));
}

TEST_CASE("obj: numbers beyond a double are found by the check", "[obj]") {
  for (const char* huge : {"1e308", "-1e309", "1e999", "0e9999", "1e51"}) {
    const Mesh mesh = mesh_of("v 0 0 " + std::string(huge) + "\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" +
                              tetrahedron.substr(corners.size()));
    INFO(huge);
    const CheckResult result = check(mesh);
    REQUIRE(result.findings.size() == 1);
    CHECK(result.findings[0].kind == FindingKind::not_finite);
  }
}

TEST_CASE("obj: indices are never repaired", "[obj]") {
  CHECK(mentions(error_of(corners + "f 0 1 2\n"), "line 5: a face asks for vertex 0"));
  CHECK(mentions(error_of(corners + "f 1 2 5\n"), "line 5: a face asks for vertex 5, but the file has 4"));
  CHECK(mentions(error_of(corners + "f 1 2 3\nf 1 2 9\nf 1 2 7\n"), "line 6: a face asks for vertex 9"));
  CHECK(mentions(error_of(corners + "f -5 1 2\n"), "line 5: a face asks for vertex \"-5\""));
  CHECK(mentions(error_of("f -1 1 2\n" + corners), "line 1"));
  // 2^32 + 1 and 2^64 + 1 would wrap round to 1.
  for (const char* huge : {"4294967297", "18446744073709551617", "99999999999999999999999999", "2147483648",
                           "9999999999", "-4294967297", "-2147483649"}) {
    INFO(huge);
    CHECK(mentions(error_of(corners + "f 1 2 " + huge + "\n"), "line 5: a face asks for vertex"));
  }
  for (const char* bad : {"a", "1.5", "1a", "1/a", "1/2/3/4", "/1", "1/2x", "+1", "-", "1e2", "1\\",
                          "1/99999999999999999999"}) {
    INFO(bad);
    CHECK(mentions(error_of(corners + "f 1 2 " + bad + " 3\n"), "line 5: the corner"));
  }
}

TEST_CASE("obj: faces of too few or too many corners", "[obj]") {
  CHECK(mentions(error_of(corners + "f 1\n"), "line 5: a face needs three corners and has 1"));
  CHECK(mentions(error_of(corners + "f\n"), "has 0"));
  CHECK(mentions(error_of(tetrahedron + "f 1 2"),
                 "line 9: a face needs three corners and has 2"));  // cut short
  std::string many = corners + "f";
  for (int i = 0; i < 5000; ++i) many += " 1";
  CHECK(mentions(error_of(many), "line 5: a face has 5000 corners"));
}

TEST_CASE("obj: faces of two corners are left out and counted", "[obj]") {
  std::istringstream in(corners + "f 1 2\nf 1 2 # 3\n" + tetrahedron.substr(corners.size()) +
                        "f 3/1 \\\n 4/2\n");
  ObjNotes notes;
  const auto read = read_obj(in, "test.obj", nullptr, &notes);
  REQUIRE(std::holds_alternative<Mesh>(read));
  CHECK(std::get<Mesh>(read).triangles == mesh_of(tetrahedron).triangles);
  CHECK(std::get<Mesh>(read).edges == mesh_of(tetrahedron).edges);
  CHECK(notes.loose_edges == 3);
  CHECK(notes.loose_line == 5);
  CHECK(mentions(error_of(corners + "f 1 9\n"), "line 5: a face asks for vertex 9"));
}

TEST_CASE("obj: what writers leave behind changes nothing", "[obj]") {
  const Mesh plain = mesh_of(tetrahedron);
  const auto changed = [](char from, const std::string& to) {
    std::string text;
    for (const char c : tetrahedron) text += c == from ? to : std::string(1, c);
    return text;
  };
  for (const std::string& text : {
           changed(' ', "\f"), changed(' ', "\v"), changed(' ', " \f\v\t"),
           changed(' ', " \\ \t\n "),                                       // blanks after the backslash
           changed(' ', " \\ \r\n"), changed('f', "fo"),                    // the old name of a face
           tetrahedron + std::string(1, '\0'),                              // ZBrush
           tetrahedron + std::string("\0\0\n\0", 4), tetrahedron + "\x1A",  // DOS
           "g blank behind \\ \n" + tetrahedron,                            // a name, and no line to go on
       }) {
    INFO(text);
    const Mesh mesh = mesh_of(text);
    CHECK(mesh.positions == plain.positions);
    CHECK(mesh.triangles == plain.triangles);
  }
  CHECK(mentions(error_of(corners + std::string(1, '\0') + "f 1 2 3\n"), "is not text"));
}

TEST_CASE("obj: lines are counted as an editor counts them", "[obj]") {
  CHECK(mentions(error_of("v 0 0 0\r\nv 0 x 0\r\n"), "line 2"));
  CHECK(mentions(error_of("v 0 0 0\rv 0 x 0\r"), "line 2"));
  CHECK(mentions(error_of("v 0 0 \\\n 0\nv 0 x 0\n"), "line 3"));
  CHECK(mentions(error_of("# C:\\meshes\\\nv 0 x 0\n"), "line 2"));
}

TEST_CASE("obj: a hostile polygon is quick", "[obj]") {
  std::ostringstream text;  // a comb of 4,000 corners, every second one reflex
  for (int i = 0; i < 3998; ++i) text << "v " << i << ' ' << (i % 2 == 0 ? 1 : 1000) << " 0\n";
  text << "v 3998 0 0\nv 0 0 0\nf";
  for (int i = 4000; i > 0; --i) text << ' ' << i;
  const Mesh mesh = mesh_of(text.str() + "\n");
  CHECK(mesh.triangles.size() == 3998);
}

TEST_CASE("obj: any cut or changed file gives a mesh or a sentence, never a crash", "[obj]") {
  std::ostringstream out;
  write_obj(out, sphere(6, 4), "small");
  const std::string whole = out.str();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto result = read(whole.substr(0, size));
    if (const auto* mesh = std::get_if<Mesh>(&result))
      CHECK_FALSE((check(*mesh).findings.empty() && size + 1 < whole.size()));
  }
  std::mt19937 random(1);  // seeded: the same files each time
  const std::string letters = "vf 0123456789-+./\\#\n\r\teE,\xFF";
  for (int round = 0; round < 3000; ++round) {
    std::string text = whole;
    for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
      text[random() % text.size()] = letters[random() % letters.size()];
    }
    const auto result = read(text);
    error_of(result);
    if (const auto* mesh = std::get_if<Mesh>(&result)) {
      if (check(*mesh).fit()) CHECK(make_input(*mesh)->neighbours.size() > 0);
    }
  }
}

TEST_CASE("obj: files that cannot be read", "[obj]") {
  const Folder folder;
  const auto sentence = [](const std::filesystem::path& path) { return error_of(read_obj_file(path)); };
  CHECK(mentions(sentence(folder.path / "none.obj"), "none.obj does not exist"));
  CHECK(mentions(sentence(folder.path), "is a folder"));
  REQUIRE(mkfifo((folder.path / "pipe.obj").c_str(), 0600) == 0);
  CHECK(mentions(sentence(folder.path / "pipe.obj"), "is no ordinary file"));
  CHECK(mentions(sentence("/dev/zero"), "is no ordinary file"));
  std::filesystem::create_symlink("itself.obj", folder.path / "itself.obj");
  CHECK(mentions(sentence(folder.path / "itself.obj"), "cannot be reached"));
  std::ofstream(folder.path / "empty.obj");
  CHECK(mentions(sentence(folder.path / "empty.obj"), "empty.obj: the file is empty"));
  CHECK(mentions(sentence(folder.path / "empty.obj" / "x.obj"), "x.obj"));
  std::ofstream(folder.path / "closed.obj") << tetrahedron;
  std::filesystem::permissions(folder.path / "closed.obj", std::filesystem::perms::none);
  if (geteuid() != 0) {
    CHECK(mentions(sentence(folder.path / "closed.obj"), "cannot be opened (Permission denied)"));
  }
}

TEST_CASE("obj: a file's mesh is named after it", "[obj]") {
  const Folder folder;
  const std::filesystem::path path = folder.path / "a thing.v2.obj";
  std::ofstream(path) << tetrahedron;
  const auto result = read_obj_file(path);
  REQUIRE(std::holds_alternative<Mesh>(result));
  CHECK(std::get<Mesh>(result).name == "a thing.v2");
  CHECK(std::get<Mesh>(result).triangles.size() == 4);
}

#ifdef KNIT_SHARED_MESHES
TEST_CASE("obj: meshes by others are read whole", "[obj][shared]") {
  struct Size {
    const char* name;
    std::size_t vertices, triangles;
  };
  for (const auto& [name, vertices, triangles] :
       {Size{"teddy.obj", 4610, 9216}, Size{"spot.obj", 2930, 5856}, Size{"suzanne.obj", 507, 968},
        Size{"teapot.obj", 3644, 6320}, Size{"stanford-bunny.obj", 35947, 69451},
        Size{"bunny.obj", 3490, 6976}}) {
    const std::filesystem::path path = std::filesystem::path(KNIT_SHARED_MESHES) / name;
    if (!std::filesystem::exists(path)) {
      WARN("skipped: " << name << " is not there");
      continue;
    }
    const auto result = read_obj_file(path);
    INFO(name << ' ' << error_of(result));
    REQUIRE(std::holds_alternative<Mesh>(result));
    CHECK(std::get<Mesh>(result).positions.size() == vertices);
    CHECK(std::get<Mesh>(result).triangles.size() == triangles);
  }
}
#endif
