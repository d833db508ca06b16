#include "app/render/target.h"

#include <algorithm>
#include <string>

namespace app {

namespace {

GlRenderbuffer storage(GLenum format, int samples, int width, int height) {
  GlRenderbuffer buffer = GlRenderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return buffer;
}

void attach(GLenum slot, const GlRenderbuffer& buffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, buffer.id());
}

bool complete() { return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }

}  // namespace

bool Target::make(int samples) {
  while (glGetError() != GL_NO_ERROR) {
  }
  const int wanted = samples > 1 ? samples : 0;
  drawn_ = GlFramebuffer::make();
  drawn_colour_ = storage(GL_RGBA8, wanted, width_, height_);
  drawn_depth_ = storage(GL_DEPTH_COMPONENT24, wanted, width_, height_);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  attach(GL_COLOR_ATTACHMENT0, drawn_colour_);
  attach(GL_DEPTH_ATTACHMENT, drawn_depth_);
  const bool drawn = complete();
  resolved_ = GlFramebuffer::make();
  resolved_colour_ = storage(GL_RGBA8, 0, width_, height_);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  attach(GL_COLOR_ATTACHMENT0, resolved_colour_);
  samples_ = samples;
  return drawn && complete() && glGetError() == GL_NO_ERROR;
}

void Target::begin(int width, int height, int samples) {
  if (width != width_ || height != height_ || samples != wanted_) {
    GLint largest = 0;
    GLint most_samples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
    if (width < 1 || height < 1 || width > largest || height > largest) {
      throw GlError("A picture of " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels cannot be drawn: each side must be 1 to " + std::to_string(largest) +
                    " pixels.");
    }
    width_ = width;
    height_ = height;
    wanted_ = samples;
    if (!(samples > 1 && most_samples >= samples && make(samples)) && !make(1)) {
      width_ = height_ = 0;
      throw GlError("The graphics driver offers no room for a picture of " + std::to_string(width) + " x " +
                    std::to_string(height) + " pixels.");
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  glViewport(0, 0, width_, height_);
}

void Target::resolve() {
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
}

Image Target::read_as_it_is() const {
  Image image{.width = width_, .height = height_, .rgba = {}};
  const std::size_t row = static_cast<std::size_t>(width_) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // OpenGL counts rows from below.
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(height_); top + 1 < bottom; ++top) {
    --bottom;
    auto* pixels = image.rgba.data();
    std::swap_ranges(pixels + top * row, pixels + (top + 1) * row, pixels + bottom * row);
  }
  return image;
}

Image Target::read() const {
  Image image = read_as_it_is();
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = 255;
  }
  return image;
}

// Blending has multiplied colours by what they cover; files want them as they are, or edges get a dark
// fringe.
Image Target::read_with_alpha() const {
  Image image = read_as_it_is();
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const unsigned alpha = image.rgba[i + 3];
    if (alpha == 255) {
      continue;
    }
    for (std::size_t c = i; c < i + 3; ++c) {
      const unsigned straight = alpha == 0 ? 0 : (image.rgba[c] * 255U + alpha / 2) / alpha;
      image.rgba[c] = static_cast<std::uint8_t>(std::min(straight, 255U));
    }
  }
  return image;
}

void Target::present(int window_width, int window_height) const {
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  const bool same = window_width == width_ && window_height == height_;
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, window_width, window_height, GL_COLOR_BUFFER_BIT,
                    same ? GL_NEAREST : GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace app
