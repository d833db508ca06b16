#include "app/panels/kit/view_help.h"

#include <imgui.h>

#include <utility>
#include <vector>

#include "app/panels/kit/commands.h"

namespace app {

std::string hint_words(float width) {
  const std::string last = text_of(info_of(Command::help).chords[1]) + " lists the keys";
  std::vector<std::string> hints;
  for (const MouseHelp& help : mouse_help) {
    if (!help.hint.empty()) hints.emplace_back(help.hint);
  }
  hints.push_back(text_of(info_of(Command::frame_all).chords[0]) + " frames");
  std::string words;
  for (const std::string& hint : hints) {
    std::string longer = words;
    longer.append(hint).append(", ");
    if (ImGui::CalcTextSize((longer + last).c_str()).x > width) break;
    words = std::move(longer);
  }
  return words + last;
}

}  // namespace app
