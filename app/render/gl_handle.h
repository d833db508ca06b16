// OpenGL objects that free themselves, and the error that the drawing code throws. Everything in this folder
// lives and dies while its OpenGL context is current.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <utility>

#include "app/render/gl.h"

namespace app {

// what() is a sentence for a person, with the driver's log where there is one.
struct GlError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class Kind>
class GlHandle {
 public:
  GlHandle() = default;
  explicit GlHandle(GLuint id) : id_(id) {}
  GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0U)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlHandle() {
    if (id_ != 0) {
      Kind::destroy(id_);
    }
  }
  static GlHandle make() { return GlHandle(Kind::create()); }
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

struct BufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct VertexArrayKind {
  static GLuint create() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct FramebufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct RenderbufferKind {
  static GLuint create() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct ProgramKind {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};
struct ShaderKind {
  static void destroy(GLuint id) { glDeleteShader(id); }
};

using GlBuffer = GlHandle<BufferKind>;
using GlVertexArray = GlHandle<VertexArrayKind>;
using GlFramebuffer = GlHandle<FramebufferKind>;
using GlRenderbuffer = GlHandle<RenderbufferKind>;
using GlProgram = GlHandle<ProgramKind>;
using GlShader = GlHandle<ShaderKind>;

// OpenGL takes offsets into buffers as pointers. NOLINTNEXTLINE(performance-no-int-to-ptr)
inline const void* at_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

// An attribute of `size` floats in the buffer that is bound.
inline void floats(GLuint index, GLint size, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), at_offset(offset));
}

}  // namespace app
