// Draws Dear ImGui's panels with OpenGL, into the framebuffer that is bound.
#pragma once

namespace app {

class ImGuiDraw {
 public:
  // Needs a current OpenGL context and a current ImGui context, at destruction too. Throws GlError.
  ImGuiDraw();
  ~ImGuiDraw();
  ImGuiDraw(const ImGuiDraw&) = delete;
  ImGuiDraw& operator=(const ImGuiDraw&) = delete;

  // Before ImGui's own frame begins.
  void new_frame();
  // After it ended.
  void draw();
  // After fonts were loaded again, between frames.
  void forget_fonts();
};

}  // namespace app
