#include "app/window/frame.h"

#include "app/actions/picture_session.h"

#include <algorithm>
#include <utility>

#include "app/panels/kit/style.h"
#include "app/panels/offers/example_pictures.h"
#include "app/render/headless_gl.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr int frames_to_settle = 4;
// Words that are larger than this many times their plain size are enlarged: pictures of letters have to fit
// on the card.
constexpr float largest_font_scale = 4.0f;
// A picture of this height alone, and one with panels of this size, has words and lines of plain size.
constexpr float plain_height = 800.0f;
constexpr float plain_window_width = 1280.0f, plain_window_height = 720.0f;

FrameSize size_of(const FrameShape& shape) {
  return {shape.width, shape.height, static_cast<float>(shape.width_px) / shape.width,
          static_cast<float>(shape.height_px) / shape.height, shape.seconds};
}

// Of the view, in pixels of a plain screen.
double height_px_of(const Layout& layout) { return static_cast<double>(layout.view.height / layout.scale); }

FrameShape frame_shape_of(const FigureShape& figure) {
  const auto width = static_cast<float>(figure.width);
  const auto height = static_cast<float>(figure.height);
  const float grown = figure.panels
                          ? std::max(1.0f, std::min(width / plain_window_width, height / plain_window_height))
                          : std::max(0.5f, std::min(width, height) / plain_height);
  const float density = std::max(1.0f, grown / largest_font_scale);
  FrameShape shape;
  shape.width = width / density;
  shape.height = height / density;
  shape.width_px = figure.width;
  shape.height_px = figure.height;
  shape.unit_scale = grown / density;
  shape.pixel_scale = grown;
  return shape;
}

// Of lines and points, which a class shall see too.
float line_scale(const Session& session) {
  const double chosen = session.program->preferences.scale;
  return static_cast<float>(session.view->presenting ? std::max(chosen, projector_scale) : chosen);
}

}  // namespace

double view_aspect_of(const Session& session, const FigureShape& figure) {
  const FrameShape shape = frame_shape_of(figure);
  if (!figure.panels) return static_cast<double>(shape.width / shape.height);
  const float scale = ui_scale(session, shape.width, shape.height, shape.unit_scale);
  return layout_of(shape.width, shape.height, scale, layout_wish(session)).view_aspect();
}

FrameDrawer::FrameDrawer(const std::filesystem::path& assets) : fonts_folder_((assets / "fonts").string()) {
  load_look(1.0f, theme_);
}

// The parts that draw need their own context to go.
FrameDrawer::~FrameDrawer() { glue_.make_current(); }

void FrameDrawer::load_look(float scale, ThemeKind theme) {
  if (scale != fonts_scale_) {
    fonts_ = glue_.load_fonts(fonts_folder_, scale, style::text_size);
    if (fonts_scale_ > 0.0f) imgui_draw_.forget_fonts();
  }
  style::apply(scale, theme_of(theme));
  fonts_scale_ = scale;
  theme_ = theme;
}

FrameDrawer::Drawn FrameDrawer::lay_out(Session& session, const FrameShape& shape,
                                        const std::vector<InputEvent>& events, bool in_pieces) {
  glue_.make_current();
  const float scale = ui_scale(session, shape.width, shape.height, shape.unit_scale);
  if (scale != fonts_scale_ || session.program->preferences.theme != theme_)
    load_look(scale, session.program->preferences.theme);
  imgui_draw_.new_frame();
  glue_.begin_frame(size_of(shape), events);
  Drawn drawn;
  drawn.layout = layout_of(shape.width, shape.height, scale, layout_wish(session));
  apply(session, SetAspect{drawn.layout.view_aspect()});
  drawn.scene =
      describer_.describe(session, {height_px_of(drawn.layout), appeared(session, shape.seconds), in_pieces});
  unfinished_ = drawn.scene.unfinished;
  if (const Session* pinned = pinned_.refresh(session)) {
    drawn.other = other_describer_.describe(*pinned, {height_px_of(drawn.layout), 1.0, in_pieces});
    unfinished_ = unfinished_ || drawn.other->unfinished;
  }
  fill_pictures(session.program->assets);
  drawn.wishes =
      draw_ui(session, panels_, drawn.scene, drawn.layout, fonts_, drawn.other ? &*drawn.other : nullptr);
  const auto& pictures = panels_.own<ExamplePictures>();
  unfinished_ = unfinished_ || (pictures.wanted && !pictures.filled);
  glue_.end_frame();
  return drawn;
}

FrameDrawer::Drawn FrameDrawer::lay_out_alone(Session& session, const FrameShape& shape) {
  glue_.make_current();
  const float scale = shape.unit_scale * static_cast<float>(session.program->preferences.scale);
  if (scale != fonts_scale_ || session.program->preferences.theme != theme_)
    load_look(scale, session.program->preferences.theme);
  imgui_draw_.new_frame();
  glue_.begin_frame(size_of(shape), {});
  Drawn drawn;
  drawn.layout.scale = scale;
  drawn.layout.window = drawn.layout.view = {0.0f, 0.0f, shape.width, shape.height};
  apply(session, SetAspect{drawn.layout.view_aspect()});
  drawn.scene = describer_.describe(session, {height_px_of(drawn.layout), 1.0});
  draw_captions_alone(session, panels_, drawn.scene, drawn.layout, fonts_);
  glue_.end_frame();
  return drawn;
}

void FrameDrawer::fill_pictures(const std::filesystem::path& assets) {
  auto& pictures = panels_.own<ExamplePictures>();
  if (!pictures.wanted || pictures.filled) return;
  pictures.filled = true;
  for (const std::string& name : list_examples(assets)) {
    if (example_pictures_.count(name) == 0) {
      const auto image = read_png(assets / name / "picture.png");
      if (image) example_pictures_.emplace(name, texture_of(*image));
    }
    const auto found = example_pictures_.find(name);
    if (found != example_pictures_.end()) pictures.textures[name] = found->second.id();
  }
}

// A picture with more samples than are wished will do.
void FrameDrawer::paint(Drawn drawn, const FrameShape& shape, float chosen_scale) {
  const FrameSize size = size_of(shape);
  const Layout& layout = drawn.layout;
  Painted now{
      std::move(drawn.scene), std::move(drawn.other), layout.view,     layout.other_view,
      layout.window,          shape.width_px,         shape.height_px, shape.pixel_scale * chosen_scale};
  const bool same = painted_ == now && painted_samples_ >= shape.samples;
  if (!same || renderer_.refresh_next_program()) {
    painted_.reset();  // before the next run's rows take their room on the card
    target_.begin(shape.width_px, shape.height_px, shape.samples);
    const auto draw_in = [&](const Scene& scene, const Box& box) {
      const PixelBox place = pixels_of(box, layout.window, size.pixels_per_x, size.pixels_per_y);
      renderer_.draw(scene, {place.x, place.y, place.width, place.height}, now.pixel_scale);
    };
    draw_in(now.scene, now.view);
    if (now.other) draw_in(*now.other, now.other_view);
    painted_ = std::move(now);
    painted_samples_ = shape.samples;
    ++views_drawn_;
  }
  target_.resolve();
  imgui_draw_.draw();
}

Actions FrameDrawer::draw(Session& session, const FrameShape& shape, const std::vector<InputEvent>& events) {
  Drawn drawn = lay_out(session, shape, events, session.jobs->beside);
  Actions wishes = std::move(drawn.wishes);
  paint(std::move(drawn), shape, line_scale(session));
  return wishes;
}

Image FrameDrawer::figure(Session& session, const FigureShape& figure) {
  const FrameShape shape = frame_shape_of(figure);
  Drawn drawn;
  if (figure.panels) {
    // What was scrolled for the picture before does not count; panels find their size in some frames.
    forget_what_was_seen(panels_);
    for (int i = 0; i < frames_to_settle; ++i) drawn = lay_out(session, shape, {}, false);
  } else {
    drawn = lay_out_alone(session, shape);
    if (figure.transparent) drawn.scene.background = {0, 0, 0, 0};
  }
  paint(std::move(drawn), shape,
        figure.panels ? line_scale(session) : static_cast<float>(session.program->preferences.scale));
  return figure.transparent ? target_.read_with_alpha() : target_.read();
}

// The movement begins anew with each single step forward, unless they come too fast to be seen one by one.
double FrameDrawer::appeared(const Session& session, float seconds) {
  const std::size_t position = session.document ? session.document->timeline.position() : 0;
  const bool stepped = position == last_position_ + 1;
  const Playback& playback = session.view->playback;
  const bool slow = !playback.playing || playback.steps_per_second * motion_s <= 2.0;
  if (position != last_position_)
    since_step_s_ = stepped && slow && session.program->preferences.motion ? 0.0 : motion_s;
  else
    since_step_s_ = std::min(motion_s, since_step_s_ + static_cast<double>(seconds));
  last_position_ = position;
  return since_step_s_ / motion_s;
}

Image FrameDrawer::finished(const Session& session, int side) {
  Scene scene = Describer().describe(finished_piece(session));
  scene.background = {255, 255, 255};
  painted_.reset();
  target_.begin(side, side, 4);
  renderer_.draw(scene, {0, 0, side, side}, static_cast<float>(side) / 900.0f);
  target_.resolve();
  return target_.read();
}

const Box* FrameDrawer::place_of(std::string_view control) const {
  const auto found = panels_.controls.find(control);
  return found != panels_.controls.end() ? &found->second : nullptr;
}

std::variant<Image, std::string> finished_picture_of(const Session& session, int side) {
  auto opened = HeadlessGl::open();
  if (auto* error = std::get_if<std::string>(&opened)) return std::move(*error);
  try {
    FrameDrawer drawer(session.program->assets);
    return drawer.finished(session, side);
  } catch (const GlError& error) {
    return std::string(error.what());
  }
}

std::variant<Image, std::string> picture_of(Session& session, int width, int height) {
  auto opened = HeadlessGl::open();
  if (auto* error = std::get_if<std::string>(&opened)) return std::move(*error);
  try {
    FrameDrawer drawer(session.program->assets);
    FrameShape shape;
    shape.width = static_cast<float>(width);
    shape.height = static_cast<float>(height);
    shape.width_px = width;
    shape.height_px = height;
    // The camera frames the view only once its aspect is known; panels find their size in a few frames.
    drawer.draw(session, shape, {});
    if (!session.view->gaze.camera_kept) apply(session, FrameAll{});
    for (int i = 0; i < 3; ++i) drawer.draw(session, shape, {});
    return drawer.target().read();
  } catch (const GlError& error) {
    return std::string(error.what());
  }
}

}  // namespace app
