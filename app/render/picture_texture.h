// A picture that panels show: read from a PNG file once, kept by OpenGL with its smaller copies, so that it is smooth at
// any size.
#pragma once

#include "app/render/gl_handle.h"
#include "app/render/image.h"

namespace app {

struct TextureKind {
  static GLuint create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
using GlTexture = GlHandle<TextureKind>;

// Needs a current OpenGL context. Requires a picture with pixels.
GlTexture texture_of(const Image& image);

}  // namespace app
