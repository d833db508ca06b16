// A window's worth of panels without a window, for tests: what goes in are events, what comes out are wishes.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/describe/describe.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/style.h"
#include "app/panels/ui.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"

namespace desk {

using namespace app;

inline knit::Timeline small_run(const knit::Parameters& parameters) {
  return {knit::make_input(knit::sphere(16, 9, false)), parameters};
}

inline knit::Parameters wide_band() {
  knit::Parameters parameters;
  knit::give_width(parameters, 0.45);
  knit::give_epsilon(parameters, 0.2);
  return parameters;
}

class Desk {
 public:
  explicit Desk(float width = 1280, float height = 960, float scale = 1, const std::string& fonts_folder = "")
      : layout(layout_of(width, height, scale)),
        fonts_(glue_.load_fonts(fonts_folder, scale, style::text_size)) {
    style::apply(scale);
    glue_.set_clipboard(
        {[this] { return clipboard; }, [this](const std::string& text) { clipboard = text; }});
    session.view->aspect = layout.view_aspect();
  }

  void open(const knit::Parameters& parameters = wide_band()) {
    session.document = Document(small_run(parameters));
    session.document->defaults = wide_band();
    session.document->timeline.extend_to_end();
    session.view->gaze.camera.frame(session.document->timeline.input().bounds, session.view->aspect);
    settle();
  }
  Actions frame(const std::vector<InputEvent>& events = {}) {
    glue_.begin_frame({layout.window.width, layout.window.height, 1, 1, 1.0f / 60.0f}, events);
    const Scene scene = describer_.describe(session);
    Actions wishes = draw_ui(session, ui, scene, layout, fonts_, other ? &*other : nullptr);
    glue_.end_frame();
    return wishes;
  }
  void settle() {
    for (int i = 0; i < 3; ++i) frame();
  }
  Actions frames(std::initializer_list<InputEvent> events) {
    Actions all;
    for (const InputEvent& event : events) {
      for (Action& wish : frame({event})) all.push_back(std::move(wish));
    }
    return all;
  }

  MouseMove over(const std::string& control, float across = 0.5f) const {
    const auto box = ui.controls.find(control);
    INFO(control);
    REQUIRE(box != ui.controls.end());
    return {box->second.x + across * box->second.width, box->second.y + 0.5f * box->second.height};
  }
  Actions click(const std::string& control, float across = 0.5f, MouseButton button = MouseButton::Left) {
    return frames({over(control, across), MouseClick{button, true}, MouseClick{button, false}, MouseLeave{}});
  }
  Actions press(const Chord& chord) {
    if (chord.character != 0) return frames({Text{chord.character}});
    return frames({KeyPress{chord.key, true, chord.mods}, KeyPress{chord.key, false, chord.mods},
                   KeyPress{Key::LeftShift, false, {}}});
  }
  void type(const std::string& words) {
    for (const char c : words) CHECK(frames({Text{static_cast<char32_t>(c)}}).empty());
  }
  void act(const Actions& wishes) {
    for (const Action& wish : wishes) apply(session, wish);
  }

  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  Session session;
  std::optional<Scene> other;  // of the pinned run
  PanelMemory ui;
  Layout layout;
  std::string clipboard = "stitch-width = 0.5\n";

 private:
  ImGuiGlue glue_;
  Fonts fonts_;
  Describer describer_;
};

template <class T>
const T& only(const Actions& actions) {
  REQUIRE(actions.size() == 1);
  REQUIRE(actions[0].is<T>());
  return actions[0].template get<T>();
}

template <class T>
std::size_t count_of(const Actions& actions) {
  return static_cast<std::size_t>(
      std::count_if(actions.begin(), actions.end(), [](const Action& a) { return a.template is<T>(); }));
}

}  // namespace desk
