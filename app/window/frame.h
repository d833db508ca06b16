// One picture of the program: the scene and the panels over it, drawn into a target. The same for the window
// and for pictures without a display.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/actions/pinned_session.h"
#include "app/describe/describe.h"
#include "app/describe/describe_motion.h"
#include "app/panels/ui.h"
#include "app/render/image.h"
#include "app/render/imgui_draw.h"
#include "app/render/picture_texture.h"
#include "app/render/renderer.h"
#include "app/render/target.h"
#include "app/session/action.h"

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

// A picture for a file.
struct FigureShape {
  int width = 0, height = 0;  // pixels
  bool panels = false;
  bool transparent = false;  // alone only
};
// Of the view in it; words and lines grow with the picture.
double view_aspect_of(const Session& session, const FigureShape& figure);

class FrameDrawer {
 public:
  // Needs a current OpenGL context, at destruction too. Throws GlError.
  explicit FrameDrawer(const std::filesystem::path& assets);
  ~FrameDrawer();
  FrameDrawer(const FrameDrawer&) = delete;
  FrameDrawer& operator=(const FrameDrawer&) = delete;

  // Draws the session and returns what the person wished. Changes the session only by its view's aspect.
  Actions draw(Session& session, const FrameShape& shape, const std::vector<InputEvent>& events);

  // The finished knit mesh alone, on white, `side` pixels square. The target holds it afterwards.
  Image finished(const Session& session, int side);

  // The session as a figure: the scene and its captions alone, or with the panels, which nobody points at.
  // Changes its view's aspect.
  Image figure(Session& session, const FigureShape& figure);

  [[nodiscard]] const Target& target() const { return target_; }
  [[nodiscard]] const ImGuiGlue& glue() const { return glue_; }
  // Why a shader saved meanwhile is not in use; for developers.
  [[nodiscard]] const std::string& shader_problem() const { return renderer_.shader_problem(); }
  // A next frame is due even without an event; a click may wait to see whether it becomes a double click.
  [[nodiscard]] bool busy() {
    return glue_.busy() || click_waits(panels_) || since_step_s_ < motion_s || unfinished_ ||
           pinned_.pending();
  }
  // Panels wait for a worker of theirs: looking now and then is enough.
  [[nodiscard]] bool waits_for_panels() { return panels_are_working(panels_); }
  // How often the view was drawn: not where the picture of before shows the same.
  [[nodiscard]] std::size_t views_drawn() const { return views_drawn_; }
  // Where a control stood in the last frame, by its name (PanelMemory::controls); null: it was not there.
  [[nodiscard]] const Box* place_of(std::string_view control) const;
  void set_clipboard(Clipboard clipboard) { glue_.set_clipboard(std::move(clipboard)); }

 private:
  struct Drawn {
    Scene scene;
    std::optional<Scene> other;  // of the pinned run, in layout.other_view
    Layout layout;
    Actions wishes;
  };
  double appeared(const Session& session, float seconds);
  void load_look(float scale, ThemeKind theme);
  // The panels' part of a frame, without a picture yet.
  Drawn lay_out(Session& session, const FrameShape& shape, const std::vector<InputEvent>& events,
                bool in_pieces);
  Drawn lay_out_alone(Session& session, const FrameShape& shape);
  // What panels have asked for and nobody has read yet.
  void fill_pictures(const std::filesystem::path& assets);
  void paint(Drawn drawn, const FrameShape& shape, float chosen_scale);

  // What the target's view was drawn from. While one types or points at panels it is the same from frame to frame, and
  // without a graphics card drawing it takes most of a frame's time.
  struct Painted {
    Scene scene;
    std::optional<Scene> other;
    Box view, other_view, window;
    int width_px = 0, height_px = 0;
    float pixel_scale = 1.0f;
    friend bool operator==(const Painted&, const Painted&) = default;
  };

  std::string fonts_folder_;
  ImGuiGlue glue_;
  ImGuiDraw imgui_draw_;
  Renderer renderer_;
  Target target_;
  Describer describer_, other_describer_;
  PinnedSession pinned_;
  PanelMemory panels_;
  std::optional<Painted> painted_;
  int painted_samples_ = 0;
  std::size_t views_drawn_ = 0;
  std::map<std::string, GlTexture> example_pictures_;
  bool unfinished_ = false;  // the last scene
  std::size_t last_position_ = 0;
  double since_step_s_ = motion_s;  // since the last step was taken; motion_s: long ago
  Fonts fonts_;
  float fonts_scale_ = 0.0f;
  ThemeKind theme_ = ThemeKind::dark;
};

// The finished knit mesh alone without any display, or why not.
std::variant<Image, std::string> finished_picture_of(const Session& session, int side);

// A picture of the session as its window would show it, `width` x `height` pixels, without any display; or
// why not.
std::variant<Image, std::string> picture_of(Session& session, int width, int height);

}  // namespace app
