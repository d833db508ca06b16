// Draws a Scene into the framebuffer that is bound, and nothing else: it never thinks.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "app/render/batch.h"
#include "app/render/program.h"
#include "app/render/shape_cache.h"
#include "app/render/yarn_drawer.h"
#include "app/scene/scene.h"

namespace app {

// Pixels, from the lower left corner as OpenGL counts.
struct Rect {
  int x = 0, y = 0, width = 0, height = 0;
};

class Renderer {
 public:
  // Needs a current OpenGL 3.3 core context, at destruction too. Throws GlError.
  Renderer();

  // Clears the viewport to the scene's background, which may be transparent, and draws. `ui_scale`: pixels of
  // this screen for one pixel of a plain one; the scene's widths and diameters are multiplied by it.
  // Afterwards depth test, blending and scissor are off and the viewport is `viewport`.
  void draw(const Scene& scene, Rect viewport, float ui_scale);

  // Looks whether one of the shaders was saved meanwhile, each time at the next one; draw() does so too. True: what was
  // drawn may look otherwise now.
  bool refresh_next_program();

  // Empty, or why a shader that was saved while the program runs is not in use, as of the last draw().
  [[nodiscard]] const std::string& shader_problem() const { return shader_problem_; }

  // For tests and for the curious.
  struct Counters {
    std::size_t uploads = 0;      // shared shapes sent to the card, ever
    std::size_t shapes_kept = 0;  // on the card now
    std::size_t draw_calls = 0;   // in the last draw(), as the rest
    std::size_t triangles = 0;
    std::size_t lines = 0;
    std::size_t points = 0;
  };
  Counters counters() const;

 private:
  struct Frame;  // what the passes of one draw() share
  void start(const ShaderProgram& program, const Frame& frame) const;
  void draw_surface(const Frame& frame);
  bool closed_from_outside(const Frame& frame) const;
  void draw_yarn(const Frame& frame, bool behind);
  void draw_faces(const Frame& frame);
  void draw_band_alone(const Frame& frame);
  void draw_wire(const Frame& frame);
  void draw_lines(const Frame& frame, bool hidden);
  void draw_points(const Frame& frame, bool hidden);
  void upload(const Scene& scene);

  std::array<ShaderProgram*, 9> programs();

  // The plain ones are for frames without a band, which most are.
  ShaderProgram surface_, surface_plain_, face_, face_plain_, band_, wire_, line_, point_, yarn_;
  ShapeCache<MeshShape, MeshBuffers> meshes_;
  ShapeCache<std::vector<float>, TimeBuffer> times_;
  ShapeCache<YarnShape, YarnBuffers> yarns_;
  YarnDrawer yarn_drawer_;
  Batch<FaceShape> faces_;
  Batch<std::vector<Line>> isolines_, line_sets_, frame_lines_;
  Batch<std::vector<Point>> point_sets_, frame_points_;
  Counters last_;
  std::string shader_problem_;
  std::size_t next_refreshed_ = 0;
};

}  // namespace app
