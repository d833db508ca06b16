// The list of break conditions: what the run stops at, how often that is, and new ones to add.
#include <algorithm>
#include <array>
#include <string>

#include "app/panels/kit/commands.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/step/step_parts.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr std::array<std::string_view, 12> usual{"stall",       "gap",       "over-double",  "grows>4",
                                                 "shrinks>4",   "wider>1.5", "narrower<0.5", "label=m1l",
                                                 "label=k2tog", "split",     "join",         "hold"};
constexpr float shortest_break_list = 48.0f;  // plain units; below that the panel scrolls as a whole

void wish_with(PanelFrame& frame, const knit::BreakCondition& condition) {
  auto conditions = frame.session.view->breaks;
  conditions.push_back(condition);
  frame.wish(SetBreaks{std::move(conditions)});
}

void wish_without(PanelFrame& frame, std::size_t i) {
  auto conditions = frame.session.view->breaks;
  conditions.erase(conditions.begin() + static_cast<std::ptrdiff_t>(i));
  frame.wish(SetBreaks{std::move(conditions)});
}

void way_button(PanelFrame& frame, Command command, Icon icon, const char* control) {
  const CommandInfo& info = info_of(command);
  const float side = ImGui::GetFrameHeight();
  if (icon_button(control, icon, ImVec2(1.3f * side, side))) {
    if (auto action = info.make(frame.session)) frame.wish(std::move(*action));
  }
  frame.mark(control);
  tooltip(frame, tooltip_of(info));
  ImGui::SameLine(0.0f, frame.units(3.0f));
}

void take_typed(PanelFrame& frame) {
  BreakField& field = frame.own<BreakField>();
  const std::string typed = field.text.text();
  if (typed.empty()) return;
  const auto parsed = knit::parse_break(typed);
  if (const auto* error = std::get_if<std::string>(&parsed)) {
    field.trouble = *error;
    return;
  }
  field.trouble.clear();
  field.text.set("");
  wish_with(frame, std::get<knit::BreakCondition>(parsed));
}

// There and back, and a field for any condition.
void draw_head(PanelFrame& frame) {
  ImGui::BeginDisabled(frame.timeline() == nullptr || frame.session.view->breaks.empty());
  way_button(frame, Command::last_break, Icon::back, "break/last");
  way_button(frame, Command::next_break, Icon::forward, "break/next");
  ImGui::EndDisabled();
  BreakField& field = frame.own<BreakField>();
  const float button = frame.units(46.0f);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - frame.units(3.0f));
  const bool entered =
      ImGui::InputTextWithHint("##break", "row=14, wider>1.3, ...", field.text.bytes.data(),
                               field.text.bytes.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  frame.mark("break/field");
  tooltip(
      frame,
      "A condition to stop at: stage=rows, row=14, label=m1l, grows>4, shrinks>4, gap, stall, over-double, "
      "wider>1.3, narrower<0.7, split, join, hold. Widths count in stitch widths.");
  ImGui::SameLine(0.0f, frame.units(3.0f));
  const bool clicked = ImGui::Button("Add", ImVec2(button, 0.0f));
  frame.mark("break/add");
  if (entered || clicked) take_typed(frame);
  if (field.text.bytes[0] == '\0') field.trouble.clear();
  if (!field.trouble.empty()) wrapped_text(with_capital(field.trouble), theme().problem);
}

// "12", or "12..." while the run is not known to its end.
std::string count_words(const PanelFrame& frame, std::size_t i) {
  const auto words = [&](const BreakHits& hits) {
    return with_commas(hits.count(i)) + (hits.whole() ? "" : "...");
  };
  if (!frame.session.document) return words({});
  return words(frame.session.document->travel.hits);
}

void draw_condition(PanelFrame& frame, std::size_t i) {
  const auto& document = frame.session.document;
  const knit::BreakCondition& condition = frame.session.view->breaks[i];
  const bool here = document && document->travel.hits.holds(i, document->timeline.position());
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float dot = 0.24f * line;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 centre(at.x + 0.5f * line, at.y + 0.5f * line);
  if (here) {
    list.AddCircleFilled(centre, dot, style::packed(theme().break_hit));
  } else {
    list.AddCircle(centre, dot, style::packed(theme().faint_text), 0, frame.units(1.0f));
  }
  ImGui::PushID(static_cast<int>(i));
  const std::string count = count_words(frame, i);
  const float end = at.x + ImGui::GetContentRegionAvail().x - line;
  const float number = ImGui::CalcTextSize(count.c_str()).x;
  const float left = at.x + 1.3f * line;
  const float room = end - left - number - frame.units(14.0f);
  const std::string words = knit::words_of(condition);
  ImGui::SetCursorScreenPos(ImVec2(left, at.y));
  text(cut_to_width(with_capital(words), room));
  frame.mark("break/" + std::to_string(i));
  tooltip(frame, with_capital(words) + ".\nAs text: " + knit::text_of(condition) + ".\n" +
                     (here ? "Holds at the step shown." : "A filled dot: it holds at the step shown."));
  text_at(ImVec2(end - frame.units(6.0f), at.y), 1.0f, theme().faint_text, count);
  ImGui::SetCursorScreenPos(ImVec2(end, at.y));
  if (icon_button("remove", Icon::cross, ImVec2(line, line))) wish_without(frame, i);
  frame.mark("break/remove/" + std::to_string(i));
  tooltip(frame, "No longer stop at this.");
  ImGui::PopID();
}

// Buttons in lines, as many as fit.
void draw_usual(PanelFrame& frame) {
  const auto& have = frame.session.view->breaks;
  faint_text(have.empty() ? "Play, N and Shift+N stop at:" : "Also stop at:");
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const float gap = frame.units(4.0f);
  bool first = true;
  for (const std::string_view form : usual) {
    const auto parsed = knit::parse_break(form);
    const auto* condition = std::get_if<knit::BreakCondition>(&parsed);
    if (condition == nullptr || std::find(have.begin(), have.end(), *condition) != have.end()) continue;
    const std::string words(form);
    const float width = ImGui::CalcTextSize(words.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    if (!first && ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine(0.0f, gap);
    first = false;
    if (ImGui::Button(words.c_str())) wish_with(frame, *condition);
    frame.mark("break/usual/" + words);
    tooltip(frame, with_capital(knit::words_of(*condition)) + ".");
  }
}

}  // namespace

void draw_breaks(PanelFrame& frame) {
  draw_head(frame);
  const float height = std::max(frame.units(shortest_break_list), ImGui::GetContentRegionAvail().y);
  ImGui::BeginChild("break list", ImVec2(0.0f, height), true);
  for (std::size_t i = 0; i < frame.session.view->breaks.size(); ++i) draw_condition(frame, i);
  draw_usual(frame);
  ImGui::EndChild();
}

}  // namespace app
