#include "app/panels/tubes/tube_list.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "app/panels/kit/widgets.h"
#include "app/panels/tubes/tube_names.h"
#include "knit/model/words.h"
#include "knit/tubes/plan.h"

namespace app {

namespace {

constexpr std::size_t most_lines = 8;  // at once

float height_of_line(const PanelFrame& frame) {
  push_font(frame.fonts.small);
  const float height = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
  pop_font();
  return height;
}

std::string names_of_others(const knit::Tube& tube, knit::TubeId id) {
  std::vector<knit::TubeId> others;
  std::copy_if(tube.twins.begin(), tube.twins.end(), std::back_inserter(others),
               [&](knit::TubeId twin) { return twin != id; });
  return short_names(std::move(others));
}

std::string stitches_in_list(const TubesDrawing& drawing, knit::TubeId id) {
  if (drawing.tube(id).rows() == 0) return "";
  return stitches_of_tube(drawing.plan, id, drawing.seen.counts[static_cast<std::size_t>(id)], "");
}

void draw_line(PanelFrame& frame, const TubesDrawing& drawing, const ShownTube& shown, TubeListUse& use) {
  const knit::Tube& tube = drawing.tube(shown.id);
  const std::string letter = knit::tube_name(shown.id), name = "tube-line/" + letter;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight(), square = frame.units(7.0f);
  if (ImGui::Selectable(("##" + name).c_str(), shown.id == drawing.current,
                        ImGuiSelectableFlags_SpanAllColumns))
    use.clicked = shown.id;
  frame.mark(name);
  if (ImGui::IsItemHovered()) use.pointed = shown.id;
  tooltip(frame, tube_words(drawing.plan, drawing.seen.layout, shown.id,
                            drawing.seen.counts[static_cast<std::size_t>(shown.id)]));
  const float top = at.y + 0.5f * (line - square);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, top), ImVec2(at.x + square, top + square),
                                            style::packed(shown.colour));
  const Colour& colour = shown.begun ? theme().text : theme().faint_text;
  text_at(ImVec2(at.x + 1.6f * square, at.y), 0.0f, colour, letter);
  const std::array cells{std::to_string(tube.rows()), stitches_in_list(drawing, shown.id),
                         names_of_others(tube, shown.id)};
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  for (const std::string& cell : cells) {
    ImGui::TableNextColumn();
    text(cut_to_width(cell, ImGui::GetContentRegionAvail().x));  // the tip has all of it
  }
  ImGui::PopStyleColor();
}

}  // namespace

float height_of_tube_list(const PanelFrame& frame, std::size_t tubes) {
  return height_of_line(frame) * static_cast<float>(1 + std::min(tubes, most_lines)) + frame.units(2.0f);
}

TubeListUse draw_tube_list(PanelFrame& frame, const TubesDrawing& drawing) {
  constexpr ImGuiTableFlags flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  constexpr std::array heads{"Tube", "Rounds", "Stitches", "Alike"};
  constexpr std::array weights{0.8f, 0.9f, 1.0f, 1.3f};
  TubeListUse use;
  push_font(frame.fonts.small);
  const ImVec2 size(0.0f, height_of_tube_list(frame, drawing.tubes.size()));
  if (ImGui::BeginTable("tube table", static_cast<int>(heads.size()), flags, size)) {
    for (std::size_t i = 0; i < heads.size(); ++i)
      ImGui::TableSetupColumn(heads[i], ImGuiTableColumnFlags_WidthStretch, weights[i]);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(drawing.plan.order.size()));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const knit::TubeId id = drawing.plan.order[static_cast<std::size_t>(i)];
        draw_line(frame, drawing, drawing.tubes[static_cast<std::size_t>(id)], use);
      }
    ImGui::EndTable();
  }
  pop_font();
  return use;
}

}  // namespace app
