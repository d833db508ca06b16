// One picture of the program: the scene and the panels over it, drawn into a target. The same for the window
// and for pictures without a display.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/action.h"
#include "app/core/describe.h"
#include "app/panels/ui.h"
#include "app/render/image.h"
#include "app/render/imgui_draw.h"
#include "app/render/renderer.h"
#include "app/render/target.h"

namespace app {

// Of the picture on a pattern's page.
inline constexpr int page_picture_px = 900;

struct FrameShape {
  float width = 0.0f, height = 0.0f;  // window units
  int width_px = 0, height_px = 0;    // of the framebuffer
  float unit_scale = 1.0f;            // window units for one unit of a plain screen
  float pixel_scale = 1.0f;           // pixels for one pixel of a plain screen
  float seconds = 1.0f / 60.0f;       // since the frame before
  int samples = 4;                    // a pixel
};

class FrameDrawer {
 public:
  // Needs a current OpenGL context, at destruction too. Throws GlError.
  explicit FrameDrawer(const std::filesystem::path& assets);

  // Draws the session and returns what the person wished. Changes the session only by its view's aspect.
  Actions draw(Session& session, const FrameShape& shape, const std::vector<InputEvent>& events);

  // The finished knit mesh alone, on white, `side` pixels square. The target holds it afterwards.
  Image finished(const Session& session, int side);

  [[nodiscard]] const Target& target() const { return target_; }
  [[nodiscard]] const ImGuiGlue& glue() const { return glue_; }
  // A next frame is due even without an event; a click may wait to see whether it becomes a double click.
  [[nodiscard]] bool busy() const { return glue_.busy() || ui_.click.has_value(); }
  void set_clipboard(Clipboard clipboard) { glue_.set_clipboard(std::move(clipboard)); }

 private:
  void load_fonts(float scale);

  std::string fonts_folder_;
  ImGuiGlue glue_;
  ImGuiDraw imgui_draw_;
  Renderer renderer_;
  Target target_;
  Describer describer_;
  UiState ui_;
  Fonts fonts_;
  float fonts_scale_ = 0.0f;
};

// The finished knit mesh alone without any display, or why not.
std::variant<Image, std::string> finished_picture_of(const Session& session, int side);

// A picture of the session as its window would show it, `width` x `height` pixels, without any display; or
// why not.
std::variant<Image, std::string> picture_of(Session& session, int width, int height);

}  // namespace app
