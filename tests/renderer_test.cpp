// Draws small scenes without a display and looks at the pixels.
#include "app/render/renderer.h"

#include <imgui.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "app/panels/kit/imgui_glue.h"
#include "app/render/headless_gl.h"
#include "app/render/imgui_draw.h"
#include "app/render/target.h"
#include "tests/support/catch.h"

namespace {

using namespace app;

constexpr int size = 200;
constexpr Colour background{20, 30, 60, 255}, ground{200, 200, 200, 255}, red{255, 0, 0, 255},
    green{0, 200, 0, 255}, blue{0, 0, 255, 255};

// A square wall from -1 to 1 that looks at the eye, as two triangles.
std::shared_ptr<const MeshShape> wall() {
  MeshShape shape;
  shape.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  shape.normals.assign(4, {0, 0, 1});
  shape.triangles = {0, 1, 2, 0, 2, 3};
  shape.edges = {0, 1, 1, 2, 2, 3, 3, 0};
  return std::make_shared<const MeshShape>(shape);
}

// Covers x and y from 0 to 0.5, a little behind the wall, as knit faces are.
std::shared_ptr<const FaceShape> patch(float z) {
  FaceShape shape;
  const glm::vec3 a{0, 0, z}, b{0.5f, 0, z}, c{0.5f, 0.5f, z}, d{0, 0.5f, z};
  shape.faces.push_back({{a, b, c, d}, {0, 0, 1}, red});
  return std::make_shared<const FaceShape>(shape);
}

Scene scene_of_wall() {
  Scene scene;
  scene.view.eye = {0, 0, 5};
  scene.view.view = glm::lookAt(scene.view.eye, glm::vec3(0), glm::vec3(0, 1, 0));
  scene.view.projection = glm::ortho(-2.0f, 2.0f, -2.0f, 2.0f, 0.1f, 20.0f);
  scene.background = background;
  scene.ground = ground;
  scene.time_low = {68, 1, 84, 255};
  scene.time_middle = {33, 145, 140, 255};
  scene.time_high = {253, 231, 37, 255};
  scene.mesh = wall();
  scene.times = std::make_shared<const std::vector<float>>(std::vector<float>{0, 0, 1, 1});
  scene.show_wire = false;
  return scene;
}

// Draws in one context; pixels by the world's x and y.
class Studio {
 public:
  Studio() : gl_(std::get<HeadlessGl>(HeadlessGl::open())) {}
  void draw(const Scene& scene) {
    target.begin(size, size);
    renderer.draw(scene, {0, 0, size, size}, 1.0f);
    target.resolve();
    image = target.read();
  }
  glm::ivec3 at(float x, float y) const {
    const auto column = static_cast<std::size_t>((x + 2.0f) / 4.0f * size);
    const auto row = static_cast<std::size_t>((2.0f - y) / 4.0f * size);
    const std::uint8_t* pixel = &image.rgba[4 * (row * size + column)];
    return {pixel[0], pixel[1], pixel[2]};
  }
  template <class Wanted>
  int count(Wanted wanted) const {
    int found = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      found += wanted(glm::ivec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2])) ? 1 : 0;
    }
    return found;
  }

 private:
  HeadlessGl gl_;  // first: the others need it to the end

 public:
  Target target;
  Renderer renderer;
  Image image;
};

bool reddish(glm::ivec3 c) { return c.r > 150 && c.g < 90 && c.b < 90; }
bool greenish(glm::ivec3 c) { return c.g > 120 && c.r < 60 && c.b < 60; }

}  // namespace

TEST_CASE("the background is exact, the ground is lit") {
  Studio studio;
  studio.draw(scene_of_wall());
  CHECK(studio.at(-1.8f, 1.8f) == glm::ivec3(20, 30, 60));
  CHECK(studio.at(1.8f, -1.8f) == glm::ivec3(20, 30, 60));
  const glm::ivec3 lit = studio.at(-0.5f, 0.1f);
  CHECK(lit.r > 150);
  CHECK(std::abs(lit.r - lit.b) < 20);
  CHECK(studio.target.samples() >= 1);
}

TEST_CASE("timed vertices carry the ramp, the others the ground") {
  Studio studio;
  Scene scene = scene_of_wall();
  scene.timed_vertices = 4;
  studio.draw(scene);
  const glm::ivec3 low = studio.at(0.0f, -0.95f);
  const glm::ivec3 high = studio.at(0.0f, 0.95f);
  CHECK(low.b > low.g);
  CHECK(high.r > 180);
  CHECK(high.b < 100);
  scene.timed_vertices = 0;
  studio.draw(scene);
  CHECK(std::abs(studio.at(0.0f, 0.95f).r - studio.at(0.0f, 0.95f).b) < 20);
  scene.timed_vertices = 4;
  scene.show_times = false;
  studio.draw(scene);
  CHECK(std::abs(studio.at(0.0f, 0.95f).r - studio.at(0.0f, 0.95f).b) < 20);
}

TEST_CASE("faces win over the surface although they cut below it") {
  Studio studio;
  Scene scene = scene_of_wall();
  scene.faces = {patch(-0.02f)};
  studio.draw(scene);
  CHECK(reddish(studio.at(0.25f, 0.25f)));
  CHECK_FALSE(reddish(studio.at(-0.25f, 0.25f)));
  const int area = studio.count(reddish);
  CHECK(area > 550);  // 25 x 25 pixels
  CHECK(area < 700);
}

TEST_CASE("what faces cover of the surface is not drawn, and it does not show") {
  Studio studio;
  Scene scene = scene_of_wall();
  // Three bands, one above another; the middle one has a face before it.
  MeshShape shape;
  std::vector<float> times;
  for (const float y : {-1.0f, -0.4f, 0.4f, 1.0f}) {
    shape.positions.insert(shape.positions.end(), {{-1, y, 0}, {1, y, 0}});
    times.insert(times.end(), {0.5f + 0.5f * y, 0.5f + 0.5f * y});
  }
  shape.normals.assign(8, {0, 0, 1});
  for (const std::uint32_t low : {0U, 2U, 4U}) {
    for (const std::uint32_t corner : {0U, 1U, 3U, 0U, 3U, 2U}) shape.triangles.push_back(low + corner);
  }
  scene.mesh = std::make_shared<const MeshShape>(shape);
  scene.times = std::make_shared<const std::vector<float>>(times);
  FaceShape face;
  const glm::vec3 a{-1, -0.4f, 0.01f}, b{1, -0.4f, 0.01f}, c{1, 0.4f, 0.01f}, d{-1, 0.4f, 0.01f};
  face.faces.push_back({{a, b, c, d}, {0, 0, 1}, red});
  scene.faces = {std::make_shared<const FaceShape>(face)};
  studio.draw(scene);
  const Image whole = studio.image;
  const std::size_t all = studio.renderer.counters().triangles;
  scene.covered = TimeSpan{0.25f, 0.75f};
  studio.draw(scene);
  CHECK(studio.image.rgba == whole.rgba);
  CHECK(studio.renderer.counters().triangles == all - 2);
  scene.covered = TimeSpan{0.0f, 0.35f};
  studio.draw(scene);
  CHECK(studio.at(0.0f, -0.7f) == glm::ivec3(20, 30, 60));  // it really is left out
}

TEST_CASE("faces are left out from behind only where surface and faces together hide it") {
  Studio studio;
  Scene scene = scene_of_wall();
  FaceShape
      face;  // before the wall, with its back to the eye; its far corner makes room for an eye among the faces
  const glm::vec3 a{0.1f, 0.1f, 0.1f}, b{0.5f, 0.1f, 0.1f}, c{0.5f, 0.5f, 0.1f}, d{0.1f, 0.5f, 0.1f},
      e{0.1f, 0.2f, 9.0f};
  face.faces = {{{a, d, c, b}, {0, 0, -1}, red}, {{a, e, d, d}, {0, 0, -1}, red}};
  scene.faces = {std::make_shared<const FaceShape>(face)};
  const auto shows = [&] {
    studio.draw(scene);
    const glm::ivec3 colour = studio.at(0.4f, 0.25f);  // dark: its light is on the other side
    return colour.r > colour.g + 20;
  };
  CHECK(shows());
  scene.covered = TimeSpan{2.0f, 3.0f};
  CHECK_FALSE(shows());
  scene.show_surface = false;
  CHECK(shows());
  scene.show_surface = true;
  scene.view.eye = {0.3f, 0.3f, 5.0f};  // among the faces
  CHECK(shows());
}

TEST_CASE("a line is as wide as it says, everywhere") {
  Studio studio;
  Scene scene = scene_of_wall();
  scene.lines = {{{-0.8f, 0.5f, 0.01f}, {0.8f, 0.5f, 0.01f}, green, 4.0f}};
  studio.draw(scene);
  const int drawn = studio.count(greenish);  // 80 pixels long, 4 wide
  CHECK(drawn > 230);
  CHECK(drawn < 420);
  scene.view.projection = glm::perspective(glm::radians(40.0f), 1.0f, 0.1f, 20.0f);
  studio.draw(scene);
  CHECK(studio.count(greenish) > 230);
}

TEST_CASE("what is behind the surface shows through faintly") {
  Studio studio;
  Scene scene = scene_of_wall();
  studio.draw(scene);
  const glm::ivec3 wall_colour = studio.at(0.0f, -0.5f);
  scene.lines = {{{-1.6f, -0.5f, -1}, {1.6f, -0.5f, -1}, green, 6.0f}};
  scene.points = {{{0, 0.5f, -1}, blue, 12.0f}};
  studio.draw(scene);
  const glm::ivec3 behind = studio.at(0.0f, -0.5f);
  CHECK(wall_colour.r - behind.r > 8);
  CHECK(wall_colour.r - behind.r < 50);
  CHECK(greenish(studio.at(1.4f, -0.5f)));  // beside the wall it is in plain view
  const glm::ivec3 point = studio.at(0.0f, 0.5f);
  CHECK(point.b > point.r + 4);
  CHECK(point.r > 120);
}

TEST_CASE("a point is a disc with a dark rim") {
  Studio studio;
  Scene scene = scene_of_wall();
  scene.points = {{{0, 0, 0}, blue, 20.0f}};
  studio.draw(scene);
  CHECK(studio.at(0, 0) == glm::ivec3(0, 0, 255));
  CHECK(studio.at(0.215f, 0).r < 110);
  CHECK(studio.at(0.3f, 0).r > 150);
  CHECK(studio.at(0.18f, 0.18f).r > 150);  // the corner of its square
}

TEST_CASE("the band is a ring on the surface, with or without the surface") {
  Studio studio;
  Scene scene = scene_of_wall();
  scene.band = Band{{0, 0, 0}, 0.4f, 0.0f, 0.8f, red};
  studio.draw(scene);
  const auto warmth = [&](float x, float y) { return studio.at(x, y).r - studio.at(x, y).b; };
  CHECK(std::abs(warmth(0.1f, 0.1f)) < 20);
  CHECK(warmth(0.6f, 0.0f) > 40);
  CHECK(warmth(0.0f, -0.6f) > 40);
  CHECK(std::abs(warmth(0.9f, 0.0f)) < 20);
  CHECK(warmth(0.8f, 0.0f) > warmth(0.6f, 0.0f));  // the edge stands out
  const glm::ivec3 plain = studio.at(0.5f, 0.0f);
  scene.band->middle = 0.5f;
  studio.draw(scene);
  const glm::ivec3 lined = studio.at(0.5f, 0.0f);  // a line in a dark casing
  CHECK(std::abs(lined.r - plain.r) + std::abs(lined.g - plain.g) + std::abs(lined.b - plain.b) > 60);
  scene.show_surface = false;
  studio.draw(scene);
  CHECK(studio.at(0.1f, 0.1f) == glm::ivec3(20, 30, 60));
  CHECK(warmth(0.6f, 0.0f) > 40);
}

TEST_CASE("a shape is uploaded once and freed when nobody holds it") {
  Studio studio;
  Scene scene = scene_of_wall();
  scene.faces = {patch(-0.01f)};
  scene.line_sets = {std::make_shared<const std::vector<Line>>(3)};
  scene.point_sets = {std::make_shared<const std::vector<Point>>(5)};
  for (int frame = 0; frame < 3; ++frame) {
    studio.draw(scene);
  }
  CHECK(studio.renderer.counters().uploads == 4);
  CHECK(studio.renderer.counters().shapes_kept == 4);
  CHECK(studio.renderer.counters().triangles == 4);
  CHECK(studio.renderer.counters().lines == 3);
  CHECK(studio.renderer.counters().points == 5);
  scene.faces.clear();
  scene.line_sets.clear();
  studio.draw(scene);
  CHECK(studio.renderer.counters().shapes_kept == 2);
  scene.mesh = wall();
  studio.draw(scene);
  CHECK(studio.renderer.counters().uploads == 5);
  CHECK(studio.renderer.counters().shapes_kept == 2);
}

TEST_CASE("what two scenes have in common from the beginning is not sent again") {
  Studio studio;
  Scene scene = scene_of_wall();
  for (int i = 0; i < 4; ++i)
    scene.line_sets.push_back(std::make_shared<const std::vector<Line>>(
        std::vector<Line>{{{-0.8f, 0.3f * float(i), 0.01f}, {0.8f, 0.3f * float(i), 0.01f}, green, 4.0f}}));
  const auto all = scene.line_sets;
  studio.draw(scene);
  CHECK(studio.renderer.counters().uploads == 5);
  scene.line_sets.resize(2);
  studio.draw(scene);
  CHECK(studio.renderer.counters().lines == 2);
  CHECK_FALSE(greenish(studio.at(0.0f, 0.9f)));
  scene.line_sets = all;
  studio.draw(scene);
  CHECK(studio.renderer.counters().uploads == 5);
  CHECK(greenish(studio.at(0.0f, 0.9f)));
  scene.line_sets[1] = std::make_shared<const std::vector<Line>>(
      std::vector<Line>{{{-0.8f, -0.6f, 0.01f}, {0.8f, -0.6f, 0.01f}, green, 4.0f}});
  studio.draw(scene);
  CHECK(studio.renderer.counters().uploads == 8);  // it and those after it
  CHECK(greenish(studio.at(0.0f, -0.6f)));
  CHECK_FALSE(greenish(studio.at(0.0f, 0.3f)));
  CHECK(greenish(studio.at(0.0f, 0.9f)));
  CHECK(studio.renderer.counters().draw_calls <= 4);
}

TEST_CASE("of very many lines only those in the view are drawn") {
  Studio studio;
  Scene scene = scene_of_wall();
  std::vector<Line> lines;
  for (int i = 0; i < 20000; ++i) {
    const float x = -100.0f + 0.01f * float(i);  // the view shows -2 to 2
    lines.push_back({{x, -0.5f, 0.01f}, {x + 0.01f, -0.5f, 0.01f}, green, 4.0f});
  }
  scene.line_sets = {std::make_shared<const std::vector<Line>>(lines)};
  studio.draw(scene);
  CHECK(studio.renderer.counters().lines >= 400);
  CHECK(studio.renderer.counters().lines < 700);
  for (const float x : {-1.9f, -0.4f, 0.0f, 1.9f}) CHECK(greenish(studio.at(x, -0.5f)));
}

TEST_CASE("an empty scene and a viewport inside the picture are drawn") {
  Studio studio;
  Scene scene;
  scene.background = background;
  studio.draw(scene);
  CHECK(studio.count([](glm::ivec3 c) { return c == glm::ivec3(20, 30, 60); }) == size * size);
  studio.target.begin(size, size);
  scene.background = red;
  studio.renderer.draw(scene, {0, 0, size / 2, size / 2}, 1.0f);  // lower left quarter
  studio.target.resolve();
  studio.image = studio.target.read();
  CHECK(studio.at(-1, -1) == glm::ivec3(255, 0, 0));
  CHECK(studio.at(1, 1) != glm::ivec3(255, 0, 0));
  studio.renderer.draw(scene, {0, 0, 0, 0}, 1.0f);
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("a picture of impossible size is refused in a sentence") {
  Studio studio;
  CHECK_THROWS_AS(studio.target.begin(0, 10), GlError);
  CHECK_THROWS_AS(studio.target.begin(1 << 24, 10), GlError);
  studio.draw(scene_of_wall());
  CHECK(studio.at(-1.8f, 1.8f) == glm::ivec3(20, 30, 60));
}

TEST_CASE("panels are drawn over the picture, after fonts changed too") {
  Studio studio;
  ImGuiGlue glue;
  ImGuiDraw draw;
  for (int round = 0; round < 2; ++round) {
    glue.load_fonts("no such folder", 1.0f + static_cast<float>(round));
    draw.forget_fonts();
    studio.draw(scene_of_wall());
    draw.new_frame();
    glue.begin_frame({.width = size, .height = size}, {});
    ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {40, 40}, 0xff00ff00U);
    ImGui::GetForegroundDrawList()->AddText({100, 100}, 0xff00ff00U, "MMMM");
    glue.end_frame();
    draw.draw();
    studio.image = studio.target.read();
    CHECK(studio.at(-1.8f, 1.8f) == glm::ivec3(0, 255, 0));
    CHECK(studio.count([](glm::ivec3 c) { return c == glm::ivec3(0, 255, 0); }) > 40 * 40 + 10);
    CHECK(studio.at(1.8f, -1.8f) == glm::ivec3(20, 30, 60));
  }
}

TEST_CASE("one context after another in the same process") {
  for (int round = 0; round < 2; ++round) {
    Studio studio;
    studio.draw(scene_of_wall());
    CHECK(studio.at(-1.8f, 1.8f) == glm::ivec3(20, 30, 60));
  }
}

namespace {

// A straight yarn along x at this height and depth, in two pieces.
void add_strand(YarnShape& shape, float y, float z, Colour colour, const glm::vec3& out) {
  const auto first = static_cast<std::uint32_t>(shape.points.size());
  for (int i = 0; i < 7; ++i) shape.points.emplace_back(-1.5f + 0.5f * static_cast<float>(i), y, z, 0.0f);
  for (const std::uint32_t begin : {1U, 3U})
    shape.pieces.push_back({first + begin, 2, colour, {begin == 1 ? -0.5f : 0.5f, y, z}, out, out});
}

Scene scene_of_strand(const glm::vec3& out, bool closed) {
  YarnShape shape;
  shape.radius = 0.2f;
  shape.width = 0.8f;
  shape.closed = closed;
  add_strand(shape, 0.0f, 0.0f, red, out);
  Scene scene;
  scene.view.eye = {0, 0, 5};
  scene.view.view = glm::lookAt(scene.view.eye, glm::vec3(0), glm::vec3(0, 1, 0));
  scene.view.projection = glm::ortho(-2.0f, 2.0f, -2.0f, 2.0f, 0.1f, 20.0f);
  scene.background = background;
  scene.yarn = std::make_shared<const YarnShape>(shape);
  return scene;
}

}  // namespace

TEST_CASE("yarn is a tube as wide as it is and darker at its rims") {
  Studio studio;
  studio.draw(scene_of_strand({0, 0, 1}, false));
  // From -1 to 1 and 0.4 wide: 100 x 20 pixels.
  const int area = studio.count([](glm::ivec3 c) { return c.r > c.b + 20; });
  CHECK(area > 1800);
  CHECK(area < 2200);
  const glm::ivec3 middle = studio.at(0.3f, 0.0f), rim = studio.at(0.3f, -0.18f);
  CHECK(middle.r > rim.r + 20);
  CHECK(middle.g < 40);
  CHECK(studio.at(0.3f, 0.3f) == glm::ivec3(20, 30, 60));
  CHECK(studio.at(1.3f, 0.0f) == glm::ivec3(20, 30, 60));
}

TEST_CASE("yarn in front hides yarn behind whichever comes first") {
  for (const bool near_first : {true, false}) {
    Studio studio;
    Scene scene = scene_of_strand({0, 0, 1}, false);
    YarnShape shape = *scene.yarn;
    shape.points.clear();
    shape.pieces.clear();
    for (const bool near : {near_first, !near_first})
      add_strand(shape, 0.0f, near ? 0.5f : -0.5f, near ? red : green, {0, 0, 1});
    scene.yarn = std::make_shared<const YarnShape>(shape);
    studio.draw(scene);
    CHECK(reddish(studio.at(0.3f, 0.0f)));
  }
}

TEST_CASE("yarn that looks away is left out of a closed piece and drawn with less of an open one") {
  Studio studio;
  studio.draw(scene_of_strand({0, 0, 1}, true));
  const std::size_t facing = studio.renderer.counters().triangles;
  CHECK(facing > 0);
  studio.draw(scene_of_strand({0, 0, -1}, true));
  CHECK(studio.renderer.counters().triangles == 0);
  CHECK(studio.at(0.3f, 0.0f) == glm::ivec3(20, 30, 60));
  studio.draw(scene_of_strand({0, 0, -1}, false));
  CHECK(studio.renderer.counters().triangles > 0);
  CHECK(studio.renderer.counters().triangles < facing);
  CHECK(studio.at(0.3f, 0.0f).r > 80);  // its inner side has light, too
}

TEST_CASE("the ground of yarn hides nothing from one who is inside") {
  Studio studio;
  Scene scene = scene_of_strand({0, 0, -1}, false);
  FaceShape shape;
  // Between the eye and the yarn, looking away.
  shape.faces.push_back(
      {{glm::vec3{-1, -1, 0.4f}, {-1, 1, 0.4f}, {1, 1, 0.4f}, {1, -1, 0.4f}}, {0, 0, -1}, green});
  scene.faces = {std::make_shared<const FaceShape>(shape)};
  studio.draw(scene);
  CHECK_FALSE(greenish(studio.at(0.3f, 0.0f)));
  CHECK(studio.at(0.3f, 0.0f).r > 80);
}
