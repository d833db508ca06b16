// Where stitches that have settled or relaxed are shown: a switch at the right of the view, while it matters.
#include <algorithm>
#include <array>

#include "app/describe/describe_stretch.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/view/overlays.h"
#include "app/session/shown.h"

namespace app {

namespace {

constexpr float above_legend = 158.0f;  // plain units: as high as a legend without short rows

struct PositionsChoice {
  Positions positions;
  const char* words;
  const char* about;
};
constexpr std::array positions_choices{
    PositionsChoice{Positions::placed, "As placed", "Each stitch where its row was placed, on a level set."},
    PositionsChoice{Positions::settled, "As settled",
                    "Each stitch where it is at ease on the mesh, as far as it has settled."},
    PositionsChoice{Positions::relaxed, "In the air",
                    "Each stitch where it comes to lie off the needles, as far as it has relaxed."}};

bool is_there(const PanelFrame& frame, Positions positions) {
  if (positions == Positions::placed) return has_settled(frame.session);
  return positions == Positions::settled || has_relaxed(frame.session);
}

}  // namespace

namespace {

// Never hidden where another than the usual is shown.
bool has_choices(const PanelFrame& frame) {
  const bool settled = positions_shown(frame.session) == Positions::settled;
  const bool relaxed = has_relaxed(frame.session);
  if (!has_settled(frame.session) && !relaxed) return false;
  return !settled || relaxed || stretch_shown(frame.session) || moves_shown(frame.session);
}

void draw_choices(PanelFrame& frame) {
  faint_text("Stitches");
  for (const PositionsChoice& choice : positions_choices) {
    if (!is_there(frame, choice.positions)) continue;
    const bool on = positions_shown(frame.session) == choice.positions;
    const bool settled_here = choice.positions != Positions::settled || has_settled(frame.session);
    if (ImGui::RadioButton(settled_here ? choice.words : "On the mesh", on) && !on)
      frame.wish(SetPositions{choice.positions});
    frame.mark("positions/" + std::string(positions_keys.at(static_cast<std::size_t>(choice.positions))));
    tooltip(frame, choice.about);
  }
}

}  // namespace

void draw_positions(PanelFrame& frame) {
  const bool dial = has_looking_dial(frame), choices = has_choices(frame);
  if (!dial && !choices) return;
  const Box& view = frame.layout.view;
  float bottom = view.bottom() - frame.units(above_legend);
  const auto legend = frame.memory.controls.find("legend-box");
  if (legend != frame.memory.controls.end()) bottom = std::min(bottom, legend->second.y - frame.units(8.0f));
  ImGui::SetNextWindowPos(ImVec2(view.right() - frame.units(12.0f), bottom), ImGuiCond_Always,
                          ImVec2(1.0f, 1.0f));
  push_raised_look(frame);
  ImGui::Begin("Positions", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  if (dial) draw_looking_dial(frame);
  if (choices) draw_choices(frame);
  ImGui::End();
}

}  // namespace app
