#include "app/render/imgui_draw.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#if defined(__linux__)
#include <dlfcn.h>
#endif

#include "app/render/gl_handle.h"

namespace app {

namespace {

// The loader inside ImGui's backend closes libGL at shutdown, and 1.92 goes on calling into it at the next
// start.
void keep_libgl() {
#if defined(__linux__)
  dlopen("libGL.so.1", RTLD_LAZY | RTLD_NODELETE);
#endif
}

void start() {
  keep_libgl();
  if (!ImGui_ImplOpenGL3_Init(shader_version)) {
    throw GlError("The panels cannot be drawn: libGL.so.1 could not be loaded. On Debian install libgl1.");
  }
}

}  // namespace

ImGuiDraw::ImGuiDraw() { start(); }

ImGuiDraw::~ImGuiDraw() {
  if (ImGui::GetIO().BackendRendererUserData != nullptr) {
    ImGui_ImplOpenGL3_Shutdown();
  }
}

void ImGuiDraw::new_frame() { ImGui_ImplOpenGL3_NewFrame(); }

void ImGuiDraw::draw() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

// Older backends make the picture of the fonts once. A full restart, because 1.86 forgets its buffers but not
// their sizes when it is told to drop its objects alone.
void ImGuiDraw::forget_fonts() {
#if IMGUI_VERSION_NUM < 19200
  ImGui_ImplOpenGL3_Shutdown();
  start();
#endif
}

}  // namespace app
