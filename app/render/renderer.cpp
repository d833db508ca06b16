#include "app/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace app {

namespace {

// What stands behind the surface shows through this much: what is going on more than what is finished.
constexpr float hidden_now = 0.15f;
constexpr float hidden_finished = 0.08f;
constexpr float calm_finished = 0.45f;  // before the surface, while something else is bright

// Through finished faces those of the far side would only be grains of dust.
bool shows_hidden_sets(const Scene& scene) { return scene.faces.empty(); }

float alpha_of_finished(const Scene& scene, bool hidden) {
  if (hidden) return hidden_finished;
  return scene.calm ? calm_finished : 1.0f;
}

glm::vec3 rgb(const Colour& colour) { return glm::vec3(colour.r, colour.g, colour.b) / 255.0f; }
glm::vec4 rgba(const Colour& colour) { return {rgb(colour), static_cast<float>(colour.a) / 255.0f}; }

void depth(bool test, bool write, GLenum function = GL_LEQUAL) {
  (test ? glEnable : glDisable)(GL_DEPTH_TEST);
  glDepthMask(write ? GL_TRUE : GL_FALSE);
  glDepthFunc(function);
}

void blend(bool on) {
  (on ? glEnable : glDisable)(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  // Alpha is the part that is covered: 1 all over where the ground is opaque.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void clear(const Rect& viewport, const Colour& background) {
  const glm::vec4 colour = rgba(background);
  glEnable(GL_SCISSOR_TEST);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  // Colours are premultiplied where the ground is not opaque: that is what blending makes of them.
  glClearColor(colour.r * colour.a, colour.g * colour.a, colour.b * colour.a, colour.a);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace

struct Renderer::Frame {
  const Scene& scene;
  Frustum frustum;
  const MeshBuffers* mesh = nullptr;
  const TimeBuffer* times = nullptr;
  glm::vec2 viewport{1.0f};
  float scale = 1.0f;
  float extent = 1.0f;  // size of what is shown
  float push = 0.0f;    // how far the surface steps back behind the knit faces
};

Renderer::Renderer()
    : surface_({"camera.glsl", "surface.vert"}, {"ground.glsl", "light.glsl", "band.glsl", "surface.frag"}),
      surface_plain_({"camera.glsl", "surface.vert"},
                     {"ground.glsl", "light.glsl", "no_band.glsl", "surface.frag"}),
      face_({"camera.glsl", "face.vert"}, {"light.glsl", "band.glsl", "face.frag"}),
      face_plain_({"camera.glsl", "face.vert"}, {"light.glsl", "no_band.glsl", "face.frag"}),
      band_({"camera.glsl", "surface.vert"}, {"band.glsl", "band.frag"}),
      wire_({"camera.glsl", "surface.vert"}, {"ground.glsl", "light.glsl", "wire.frag"}),
      line_({"camera.glsl", "corner.glsl", "line.vert"}, {"line.frag"}),
      point_({"camera.glsl", "corner.glsl", "point.vert"}, {"point.frag"}),
      yarn_({"camera.glsl", "yarn.vert"}, {"light.glsl", "yarn.frag"}) {}

void Renderer::draw(const Scene& scene, Rect viewport, float ui_scale) {
  if (viewport.width <= 0 || viewport.height <= 0) {
    return;
  }
  refresh_next_program();
  last_ = {};
  upload(scene);
  Frame frame{.scene = scene,
              .frustum = Frustum(scene.view.projection * scene.view.view),
              .viewport = {viewport.width, viewport.height},
              .scale = ui_scale};
  frame.extent = faces_.extent().diagonal();
  if (scene.mesh != nullptr) {
    frame.mesh = &meshes_.get(scene.mesh);
    if (scene.times != nullptr) frame.times = &times_.get(scene.times);
    frame.extent = std::max(frame.extent, frame.mesh->extent());
  }
  const float longest_side = faces_.longest_side();
  frame.extent = frame.extent > 0.0f ? frame.extent : 1.0f;
  frame.push = std::min(longest_side * longest_side / frame.extent, 0.04f * frame.extent);

  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glDisable(GL_CULL_FACE);
  clear(viewport, scene.background);
  draw_yarn(frame, false);
  // Faces first: what they cover of the surface need not be lit.
  draw_faces(frame);
  draw_surface(frame);
  draw_yarn(frame, true);
  draw_band_alone(frame);
  draw_wire(frame);
  draw_lines(frame, true);
  draw_points(frame, true);
  draw_lines(frame, false);
  draw_points(frame, false);
  glBindVertexArray(0);
  glUseProgram(0);
  blend(false);
  depth(false, true, GL_LESS);
}

// Shapes whose last holder let go are freed first, so that a tuned run never holds two runs' rows.
void Renderer::upload(const Scene& scene) {
  meshes_.drop_dead();
  times_.drop_dead();
  yarns_.drop_dead();
  faces_.show(scene.faces);
  // Kept while they are not shown.
  if (scene.isolines) isolines_.show({&scene.isolines, 1});
  line_sets_.show(scene.line_sets);
  point_sets_.show(scene.point_sets);
  frame_lines_.show_once(scene.lines);
  frame_points_.show_once(scene.points);
}

void Renderer::start(const ShaderProgram& program, const Frame& frame) const {
  const Scene& scene = frame.scene;
  program.use();
  program.set("u_view", scene.view.view);
  program.set("u_projection", scene.view.projection);
  program.set("u_eye", scene.view.eye);
  program.set("u_parallel", scene.view.projection[3][3] == 0.0f ? 0.0f : 1.0f);
  program.set("u_viewport", frame.viewport);
  program.set("u_scale", frame.scale);
  program.set("u_push", frame.push);
  const glm::vec3 centre = frame.mesh != nullptr ? frame.mesh->centre() : glm::vec3(0.0f);
  const float middle = -(scene.view.view * glm::vec4(centre, 1.0f)).z;
  program.set("u_near", middle - 0.15f * frame.extent);
  program.set("u_far", middle + 0.25f * frame.extent);
  program.set("u_far_alpha", frame.mesh == nullptr || scene.show_surface ? 1.0f : 0.30f);
  program.set("u_toward", 0.0f);
  program.set("u_timed", scene.show_times ? static_cast<int>(scene.timed_vertices) : 0);
  program.set("u_ground", rgb(scene.ground));
  program.set("u_low", rgb(scene.time_low));
  program.set("u_middle", rgb(scene.time_middle));
  program.set("u_high", rgb(scene.time_high));
  program.set("u_band_colour", scene.band ? rgba(scene.band->colour) : glm::vec4(0.0f));
  if (scene.band) {
    program.set("u_band_centre", scene.band->centre);
    program.set("u_band_reach", glm::vec3(scene.band->inner, scene.band->middle, scene.band->outer));
  }
}

void Renderer::draw_surface(const Frame& frame) {
  if (frame.mesh == nullptr || !frame.scene.show_surface) {
    return;
  }
  depth(true, true);
  blend(false);
  start(frame.scene.band ? surface_ : surface_plain_, frame);
  const Scene& scene = frame.scene;
  const auto& told = scene.covered_by ? scene.covered_by : scene.times;
  last_.triangles += scene.covered && scene.times
                         ? frame.mesh->draw_uncovered(*scene.mesh, told, *frame.times, *scene.covered)
                         : frame.mesh->draw_triangles(frame.times);
  ++last_.draw_calls;
}

// Where the surface goes on from the faces, so that from outside nobody sees one of them from behind.
bool Renderer::closed_from_outside(const Frame& frame) const {
  const Scene& scene = frame.scene;
  const Extent extent = faces_.extent();
  const bool inside = glm::all(glm::greaterThanEqual(scene.view.eye, extent.low)) &&
                      glm::all(glm::lessThanEqual(scene.view.eye, extent.high));
  return frame.mesh != nullptr && scene.show_surface && scene.covered && !inside;
}

// What looks to the eye before all that it hides, the rest after all that hides it.
void Renderer::draw_yarn(const Frame& frame, bool behind) {
  const auto& yarn = frame.scene.yarn;
  if (yarn == nullptr || yarn->pieces.empty()) return;
  depth(true, true);
  blend(false);
  start(yarn_, frame);
  const YarnBuffers& buffers = yarns_.get(yarn);
  const Sight& view = frame.scene.view;
  const double stitch_px = yarn_stitch_px(buffers.extent(), yarn->width, view, frame.viewport.y, frame.scale);
  yarn_drawer_.list(buffers, yarn, view, yarn_detail(stitch_px));
  last_.triangles += behind ? yarn_drawer_.draw_behind(yarn_, buffers, *yarn)
                            : yarn_drawer_.draw_facing(yarn_, buffers, *yarn);
  ++last_.draw_calls;
}

void Renderer::draw_faces(const Frame& frame) {
  if (faces_.empty()) {
    return;
  }
  depth(true, true);
  blend(false);
  start(frame.scene.band ? face_ : face_plain_, frame);
  // The ground of yarn would hide the loops from one who looks at them from inside.
  if (frame.scene.yarn || closed_from_outside(frame)) glEnable(GL_CULL_FACE);
  last_.triangles += 2 * faces_.draw(frame.frustum);
  glDisable(GL_CULL_FACE);
  ++last_.draw_calls;
}

void Renderer::draw_band_alone(const Frame& frame) {
  if (frame.mesh == nullptr || frame.scene.show_surface || !frame.scene.band) {
    return;
  }
  depth(true, false);
  blend(true);
  start(band_, frame);
  frame.mesh->draw_triangles(frame.times);
  ++last_.draw_calls;
}

void Renderer::draw_wire(const Frame& frame) {
  if (frame.mesh == nullptr || !frame.scene.show_wire) {
    return;
  }
  // Where edges lie closer than a few pixels their sum would be a grey veil.
  const Sight& view = frame.scene.view;
  const glm::vec4 eye_space = view.view * glm::vec4(frame.mesh->centre(), 1.0f);
  const float clip_w = std::max((view.projection * eye_space).w, 1e-6f);
  const float pixels =
      frame.mesh->mean_edge() * view.projection[1][1] * frame.viewport.y / (2.0f * clip_w * frame.scale);
  const float strength = glm::smoothstep(1.5f, 14.0f, pixels);
  depth(true, false);
  blend(true);
  start(wire_, frame);
  wire_.set("u_toward", 0.0008f * frame.extent);
  wire_.set("u_alpha", (0.05f + 0.21f * strength) * (frame.scene.show_surface ? 1.0f : 1.5f));
  wire_.set("u_alpha_behind", frame.scene.show_surface ? 0.0f : 0.04f + 0.10f * strength);
  wire_.set("u_alone", frame.scene.show_surface ? 0.0f : 1.0f);
  glLineWidth(1.0f);
  frame.mesh->draw_edges(*frame.scene.mesh, frame.times);
  ++last_.draw_calls;
}

void Renderer::draw_lines(const Frame& frame, bool hidden) {
  depth(true, false, hidden ? GL_GREATER : GL_LEQUAL);
  blend(true);
  start(line_, frame);
  line_.set("u_toward", 0.0012f * frame.extent);
  line_.set("u_chord", 1.0f / frame.extent);
  line_.set("u_deepest", 0.02f * frame.extent);
  line_.set("u_alpha", alpha_of_finished(frame.scene, hidden));
  line_.set("u_round", hidden ? 0.0f : 1.0f);
  const auto draw = [&](const Batch<std::vector<Line>>& batch) {
    if (batch.empty()) return;
    const std::size_t drawn = batch.draw(frame.frustum);
    ++last_.draw_calls;
    last_.lines += hidden ? 0 : drawn;
  };
  if (!hidden || shows_hidden_sets(frame.scene)) {
    if (frame.scene.isolines) draw(isolines_);
    draw(line_sets_);
  }
  line_.set("u_alpha", hidden ? hidden_now : 1.0f);
  draw(frame_lines_);
}

void Renderer::draw_points(const Frame& frame, bool hidden) {
  depth(true, false, hidden ? GL_GREATER : GL_LEQUAL);
  blend(true);
  start(point_, frame);
  point_.set("u_toward", 0.0016f * frame.extent);
  point_.set("u_alpha", alpha_of_finished(frame.scene, hidden));
  const auto draw = [&](const Batch<std::vector<Point>>& batch) {
    if (batch.empty()) return;
    const std::size_t drawn = batch.draw(frame.frustum);
    ++last_.draw_calls;
    last_.points += hidden ? 0 : drawn;
  };
  if (!hidden || shows_hidden_sets(frame.scene)) draw(point_sets_);
  point_.set("u_alpha", hidden ? hidden_now : 1.0f);
  draw(frame_points_);
}

// One a frame: to look when all their files were saved takes a tenth of a millisecond.
bool Renderer::refresh_next_program() {
  const auto all = programs();
  next_refreshed_ = (next_refreshed_ + 1) % all.size();
  const bool changed = all.at(next_refreshed_)->refresh();
  shader_problem_.clear();
  for (const ShaderProgram* program : all)
    if (shader_problem_.empty()) shader_problem_ = program->problem();
  return changed;
}

std::array<ShaderProgram*, 9> Renderer::programs() {
  return {&surface_, &surface_plain_, &face_, &face_plain_, &band_, &wire_, &line_, &point_, &yarn_};
}

Renderer::Counters Renderer::counters() const {
  Counters counters = last_;
  counters.uploads = meshes_.uploads() + yarns_.uploads() + faces_.uploads() + isolines_.uploads() +
                     line_sets_.uploads() + point_sets_.uploads();
  counters.shapes_kept = meshes_.kept() + yarns_.kept() + faces_.kept() + isolines_.kept() +
                         line_sets_.kept() + point_sets_.kept();
  return counters;
}

}  // namespace app
