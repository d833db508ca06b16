// What there is to see, as plain data: no GL, no ImGui. `describe` makes it from a session, a Renderer draws
// it.
//
// Coordinates are mesh units in float, colours linear-free sRGB bytes as seen on the screen. A Shape is
// immutable and shared: a renderer uploads it once and keeps it as long as the pointer lives.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/palette.h"
#include "app/scene/yarn_shape.h"

namespace app {

// The ground: the mesh that came in.
struct MeshShape {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  // smooth, outward, same length as positions
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> edges;  // pairs
};

// Coloured flat faces: the knit mesh. A quad is the triangles a b c and a c d; a triangle has its third corner twice.
struct FaceShape {
  struct Face {
    std::array<glm::vec3, 4> corners;
    glm::vec3 normal;
    Colour colour;
    [[nodiscard]] bool is_quad() const { return corners[3] != corners[2]; }
  };
  std::vector<Face> faces;
};

struct Line {
  glm::vec3 from;
  glm::vec3 to;
  Colour colour;
  float width_px = 1.5f;
  friend bool operator==(const Line&, const Line&) = default;
};

struct Point {
  glm::vec3 position;
  Colour colour;
  float diameter_px = 6.0f;
  friend bool operator==(const Point&, const Point&) = default;
};

// A word or number that stands at a place in the view; the panels' overlay writes it. With `other_end` it is about
// the line from one to the other and stands below its middle.
struct Caption {
  glm::vec3 position;
  std::string text;
  Colour colour;
  std::optional<glm::vec3> other_end = std::nullopt;
  friend bool operator==(const Caption&, const Caption&) = default;
};

// The anchor's reach on the surface: w - epsilon to w + epsilon, drawn as an annulus on the mesh with a thin line
// at w itself.
struct Band {
  glm::vec3 centre;
  float inner = 0.0f;
  float middle = 0.0f;
  float outer = 0.0f;
  Colour colour;
  glm::vec3 normal{0.0f};  // of the surface there
  friend bool operator==(const Band&, const Band&) = default;
};

// Of the mesh's vertices.
struct TimeSpan {
  float from = 0.0f, to = 0.0f;
  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

// Where the view is seen from.
struct Sight {
  glm::mat4 view{1.0f};
  glm::mat4 projection{1.0f};
  glm::vec3 eye{0.0f};
  friend bool operator==(const Sight&, const Sight&) = default;
};

struct Scene {
  const Theme* theme = &dark_theme;  // never null
  Sight view;
  Colour background;
  std::shared_ptr<const MeshShape> mesh;  // null: nothing open, or not ready yet
  // Algorithm 1's value per vertex of the mesh, negative where there is none; null: nowhere one.
  std::shared_ptr<const std::vector<float>> times;
  bool show_surface = true;
  bool show_wire = true;
  bool show_times = true;            // else the calm ground colour
  std::uint32_t timed_vertices = 0;  // vertices [0, this) carry their time's colour
  // Faces cover the surface where what is told of its vertices lies within: it need not be drawn there. That is their
  // times, which is right for one tube only, or else `covered_by`, one a vertex.
  std::optional<TimeSpan> covered;
  std::shared_ptr<const std::vector<float>> covered_by;
  Colour ground;
  Colour time_low, time_middle, time_high;  // the ramp over [0, 1]
  std::optional<Band> band;
  std::vector<std::shared_ptr<const FaceShape>> faces;  // opaque
  bool calm = false;        // line_sets and point_sets stand back behind this frame's own
  bool unfinished = false;  // more of what is shared comes with the next frame
  int coarse = 1;           // so many rows and stitches stand for one: describe_coarse.h
  // Hidden parts of lines and points are drawn faintly through the surface, so that nothing is lost behind
  // it.
  std::shared_ptr<const std::vector<Line>> isolines;  // null: none; no line_set, as it comes and goes
  std::vector<std::shared_ptr<const std::vector<Line>>> line_sets;  // shared: finished rows
  std::vector<std::shared_ptr<const std::vector<Point>>> point_sets;
  std::vector<Line> lines;  // this frame's own
  std::vector<Point> points;
  std::vector<Caption> captions;
  // The piece as yarn; null: it is not shown, or not known yet. Then `faces` are the ground of it, seen from outside only.
  std::shared_ptr<const YarnShape> yarn;
  // Of equal scenes one picture is made. What is shared is the same one, or counts as another.
  friend bool operator==(const Scene&, const Scene&) = default;
};

}  // namespace app
