#include "app/panels/kit/frame.h"

#include <imgui.h>

namespace app {

void PanelFrame::mark(std::string_view control) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  // What is scrolled out of its panel is not there to be pointed at.
  if (!ImGui::IsItemVisible()) return;
  memory.controls.insert_or_assign(std::string(control), Box{low.x, low.y, high.x - low.x, high.y - low.y});
}

}  // namespace app
