// An offscreen picture: drawn with several samples a pixel, resolved, then read back or shown in a window.
#pragma once

#include "app/render/gl_handle.h"
#include "app/render/image.h"

namespace app {

class Target {
 public:
  // Makes its buffers (again, if the size or the wish changed) and binds them for drawing, viewport and all.
  // As many samples a pixel as wished where the driver can, else 1. Throws GlError.
  void begin(int width, int height, int samples = 4);
  // Averages the samples into the picture and binds that, so that flat things (panels) can be drawn on top.
  void resolve();
  // The resolved picture, opaque.
  Image read() const;
  // The same of one that was drawn on a transparent ground: straight alpha, 0 where nothing was drawn.
  Image read_with_alpha() const;
  // Copies the resolved picture to the window's own framebuffer, and leaves that bound.
  void present(int window_width, int window_height) const;

  int samples() const { return samples_; }

 private:
  bool make(int samples);
  Image read_as_it_is() const;

  GlFramebuffer drawn_, resolved_;
  GlRenderbuffer drawn_colour_, drawn_depth_, resolved_colour_;
  int width_ = 0, height_ = 0, wanted_ = 0, samples_ = 0;
};

}  // namespace app
