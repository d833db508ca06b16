#include "app/panels/captions_alone.h"

#include "app/panels/kit/widgets.h"

namespace app {

void draw_captions_alone(const Session& session, UiState& ui, const Scene& scene, const Layout& layout,
                         const Fonts& fonts) {
  PanelFrame frame{session, ui, scene, layout, fonts, {}};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  begin_panel("Captions", layout.view, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  draw_captions(frame);
  ImGui::End();
}

}  // namespace app
