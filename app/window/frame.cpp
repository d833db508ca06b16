#include "app/window/frame.h"

#include "app/panels/style.h"
#include "app/render/headless_gl.h"

namespace app {

FrameDrawer::FrameDrawer(const std::filesystem::path& assets) : fonts_folder_((assets / "fonts").string()) {
  load_fonts(1.0f);
}

void FrameDrawer::load_fonts(float scale) {
  fonts_ = glue_.load_fonts(fonts_folder_, scale, style::text_size);
  style::apply(scale);
  if (fonts_scale_ > 0.0f) imgui_draw_.forget_fonts();
  fonts_scale_ = scale;
}

Actions FrameDrawer::draw(Session& session, const FrameShape& shape, const std::vector<InputEvent>& events) {
  if (shape.unit_scale != fonts_scale_) load_fonts(shape.unit_scale);
  const float pixels_per_x = static_cast<float>(shape.width_px) / shape.width;
  const float pixels_per_y = static_cast<float>(shape.height_px) / shape.height;
  imgui_draw_.new_frame();
  glue_.begin_frame({shape.width, shape.height, pixels_per_x, pixels_per_y, shape.seconds}, events);
  const Layout layout = layout_of(shape.width, shape.height, shape.unit_scale);
  apply(session, SetAspect{layout.view_aspect()});
  const Scene scene = describer_.describe(session);
  Actions wishes = draw_ui(session, ui_, scene, layout, fonts_);
  glue_.end_frame();

  target_.begin(shape.width_px, shape.height_px, shape.samples);
  const PixelBox view = pixels_of(layout.view, layout.window, pixels_per_x, pixels_per_y);
  renderer_.draw(scene, {view.x, view.y, view.width, view.height}, shape.pixel_scale);
  target_.resolve();
  imgui_draw_.draw();
  return wishes;
}

Image FrameDrawer::finished(const Session& session, int side) {
  Session shown = session;
  shown.timeline->seek(shown.timeline->known());
  shown.layers.fill(false);
  for (const Layer layer : {Layer::faces, Layer::column_edges, Layer::row_edges})
    shown.layers[static_cast<std::size_t>(layer)] = true;
  shown.knit_along.reset();
  shown.hovered_stitch.reset();
  shown.pinned.reset();
  shown.travel.selected.reset();
  shown.hovered_rounds.reset();
  shown.aspect = 1.0;
  shown.camera.frame(shown.timeline->input().bounds, shown.aspect);
  Scene scene = Describer().describe(shown);
  scene.background = {255, 255, 255};
  target_.begin(side, side, 4);
  renderer_.draw(scene, {0, 0, side, side}, static_cast<float>(side) / 900.0f);
  target_.resolve();
  return target_.read();
}

std::variant<Image, std::string> finished_picture_of(const Session& session, int side) {
  auto opened = HeadlessGl::open();
  if (auto* error = std::get_if<std::string>(&opened)) return std::move(*error);
  try {
    FrameDrawer drawer(session.assets);
    return drawer.finished(session, side);
  } catch (const GlError& error) {
    return std::string(error.what());
  }
}

std::variant<Image, std::string> picture_of(Session& session, int width, int height) {
  auto opened = HeadlessGl::open();
  if (auto* error = std::get_if<std::string>(&opened)) return std::move(*error);
  try {
    FrameDrawer drawer(session.assets);
    FrameShape shape;
    shape.width = static_cast<float>(width);
    shape.height = static_cast<float>(height);
    shape.width_px = width;
    shape.height_px = height;
    // The camera frames the view only once its aspect is known; panels find their size in a few frames.
    drawer.draw(session, shape, {});
    if (!session.camera_kept) apply(session, FrameAll{});
    for (int i = 0; i < 3; ++i) drawer.draw(session, shape, {});
    return drawer.target().read();
  } catch (const GlError& error) {
    return std::string(error.what());
  }
}

}  // namespace app
