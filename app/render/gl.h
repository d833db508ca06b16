// The one include of OpenGL, and what its two kinds need said differently: OpenGL 3.3 core through GLAD in a window
// of the system's, OpenGL ES 3.0 (WebGL 2) in a page.
#pragma once

#if defined(__EMSCRIPTEN__)
#include <GLES3/gl3.h>
#else
#include <glad/gl.h>
#endif

#include <cstddef>
#include <vector>

namespace app {

// The first lines of every shader.
#if defined(__EMSCRIPTEN__)
inline constexpr const char* shader_version = "#version 300 es\n";
inline constexpr const char* shader_precision =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
#else
inline constexpr const char* shader_version = "#version 330 core\n";
inline constexpr const char* shader_precision = "";
#endif

// Triangles of several runs of vertices, or of 32-bit indices that begin at byte offsets. WebGL 2 has no call for it.
#if defined(__EMSCRIPTEN__)
inline void draw_many(const std::vector<GLint>& firsts, const std::vector<GLsizei>& counts) {
  for (std::size_t i = 0; i < firsts.size(); ++i) glDrawArrays(GL_TRIANGLES, firsts[i], counts[i]);
}
inline void draw_many_indexed(const std::vector<GLsizei>& counts, const std::vector<const void*>& offsets) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    glDrawElements(GL_TRIANGLES, counts[i], GL_UNSIGNED_INT, offsets[i]);
}
#else
inline void draw_many(const std::vector<GLint>& firsts, const std::vector<GLsizei>& counts) {
  glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
}
inline void draw_many_indexed(const std::vector<GLsizei>& counts, const std::vector<const void*>& offsets) {
  glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                      static_cast<GLsizei>(counts.size()));
}
#endif

}  // namespace app
