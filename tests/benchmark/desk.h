// A session as in a window of 1280 x 720, without the window: what is shown, and the panels, without OpenGL.
#pragma once

#include <filesystem>

#include "app/describe/describe.h"
#include "app/panels/kit/style.h"
#include "app/panels/ui.h"
#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"

namespace benchmark {

// The program's own part of a frame: what is shown, and the panels, without OpenGL.
class Desk {
 public:
  explicit Desk(const std::filesystem::path& assets)
      : fonts_(glue_.load_fonts((assets / "fonts").string(), 1.0f, app::style::text_size)),
        layout_(app::layout_of(1280.0f, 720.0f, 1.0f)) {
    app::style::apply(1.0f);
    session.program->assets = assets;
    session.jobs->beside = true;
  }
  void act(const app::Action& action) { app::apply(session, action); }
  void describe() { scene_ = describer_.describe(session, {600.0, 1.0, session.jobs->beside}); }
  void panels() {
    glue_.begin_frame({1280.0f, 720.0f, 1.0f, 1.0f, 1.0f / 60.0f}, {});
    app::draw_ui(session, ui_, scene_, layout_, fonts_);
    glue_.end_frame();
  }
  void frame() {
    describe();
    panels();
  }
  void finish() {
    while (!session.document->timeline.complete()) act(app::PassTime{0.0});
    act(app::ToLast{});
    for (int i = 0; i < 3; ++i) frame();
  }

  app::Session session;

 private:
  app::ImGuiGlue glue_;
  app::Fonts fonts_;
  app::Layout layout_;
  app::PanelMemory ui_;
  app::Describer describer_;
  app::Scene scene_;
};

}  // namespace benchmark
