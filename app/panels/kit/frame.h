// What every panel is drawn with, and where it keeps what it remembers between frames.
#pragma once

#include <any>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <typeindex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "app/panels/kit/imgui_glue.h"
#include "app/panels/kit/layout.h"
#include "app/scene/scene.h"
#include "app/session/action.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

// Only what is the panels' own: nothing of the algorithm, and nothing that a script would need. A panel declares
// a type for what it remembers, beside its code, and gets the one value of it here; no other place lists them.
class PanelMemory {
 public:
  // Made when first asked for; stays where it is.
  template <class State>
  State& own() {
    std::any& kept = states_[typeid(State)];
    if (!kept.has_value()) kept.emplace<State>();
    return *std::any_cast<State>(&kept);
  }

  // Where controls stood in the last frame, by name ("play", "scrubber", "layer/surface"): for tests and for
  // whoever points at them.
  std::map<std::string, Box, std::less<>> controls;

 private:
  std::unordered_map<std::type_index, std::any> states_;
};

// One frame's drawing. Panels read the session and leave their wishes in `actions`.
struct PanelFrame {
  const Session& session;
  PanelMemory& memory;
  const Scene& scene;
  const Layout& layout;
  const Fonts& fonts;
  Actions actions;
  std::optional<RoundSpan> rounds_under = std::nullopt;  // the pointer, in whichever panel has it
  std::vector<RoundSpan> twins_under = {};               // of twins that the same words stand for
  const Scene* other_scene = nullptr;                    // of the pinned run; null: it is not seen

  template <class State>
  [[nodiscard]] State& own() const {
    return memory.own<State>();
  }
  void wish(Action action) { actions.push_back(std::move(action)); }
  // Notes where the last item stands.
  void mark(std::string_view control);
  // Plain-screen units in window units.
  [[nodiscard]] float units(float plain) const { return plain * layout.scale; }
  // Null while nothing is open.
  [[nodiscard]] const knit::Timeline* timeline() const {
    return session.document ? &session.document->timeline : nullptr;
  }
};

}  // namespace app
