// The written pattern as a knitter reads it. The round at hand is lit and kept in sight; the line under the
// pointer lights its rounds in the view, the chart and the timeline, and the stitch under the pointer there lights
// its line here.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/panels/widgets.h"

namespace app {

namespace {

using Kind = PatternLine::Kind;

// Scrolled only as far as is needed to have the line in sight, with some lines around it.
void show_line(const PatternLayout::Placed& line) {
  const float seen = ImGui::GetWindowHeight();
  const float margin = std::min(3.0f * ImGui::GetTextLineHeight(), 0.25f * seen);
  const float lowest = line.top + line.height + margin - seen;
  const float highest = line.top - margin;
  const float now = ImGui::GetScrollY();
  if (now >= lowest && now <= highest) return;
  ImGui::SetScrollY(std::max(0.0f, now < lowest ? lowest : highest));
}

// The round that has come to hand, or to be meant elsewhere, since the last frame.
void follow(PanelFrame& frame) {
  PatternView& view = frame.ui.pattern_view;
  const auto follow_round = [&](std::int32_t round) {
    if (const auto line = view.layout.line_of(round)) show_line(view.layout.lines()[*line]);
  };
  const std::int32_t hand = round_at_hand(frame);
  if (hand != view.followed) follow_round(hand);
  view.followed = hand;
  // A line that is pointed at stays where it is.
  const auto meant = rounds_meant(frame.session);
  const bool elsewhere = meant && !ImGui::IsWindowHovered();
  if (elsewhere && meant != view.followed_meant) follow_round(meant->first);
  view.followed_meant = meant;
}

void draw_ground(const PanelFrame& frame, const PatternLayout::Placed& placed, ImVec2 at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + width, at.y + placed.height);
  const auto& rounds = placed.line.rounds;
  const auto meant = rounds_meant(frame.session);
  const bool is_meant = rounds && meant && rounds->first <= meant->last && meant->first <= rounds->last;
  if (rounds && rounds->holds(round_at_hand(frame))) {
    list.AddRectFilled(at, end, style::packed(theme().anchor, is_meant ? 70 : 40), frame.units(4.0f));
    list.AddRectFilled(at, ImVec2(at.x + frame.units(3.0f), end.y), style::packed(theme().anchor),
                       frame.units(1.5f));
  } else if (is_meant) {
    list.AddRectFilled(at, end, style::packed(theme().hovered), frame.units(4.0f));
  }
  if (placed.line.kind == Kind::remark)
    list.AddRectFilled(ImVec2(at.x + frame.units(8.0f), at.y + frame.units(2.0f)),
                       ImVec2(at.x + frame.units(11.0f), end.y - frame.units(2.0f)),
                       style::packed(theme().accent), frame.units(1.5f));
}

void draw_words(const PanelFrame& frame, const PatternLayout::Placed& placed, ImVec2 at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const PatternLine& line = placed.line;
  const float edge = frame.units(8.0f);
  const float y = std::floor(at.y + frame.units(2.0f));
  if (!line.label.empty()) {
    push_font(frame.fonts.strong);
    list.AddText(ImVec2(std::floor(at.x + edge), y), style::packed(theme().text), line.label.c_str());
    pop_font();
  }
  if (line.kind == Kind::item) {
    const float middle = y + 0.5f * ImGui::GetTextLineHeight();
    list.AddCircleFilled(ImVec2(at.x + edge + frame.units(4.0f), middle), frame.units(2.0f),
                         style::packed(theme().faint_text));
  }
  const bool faint = line.kind == Kind::faint || line.kind == Kind::heading;
  push_font(font_of(line.kind, frame.fonts));
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), ImVec2(std::floor(at.x + placed.words_left), y),
               style::packed(faint ? theme().faint_text : theme().text), line.words.c_str(), nullptr,
               std::max(frame.units(20.0f), width - placed.words_left - edge));
  if (line.kind == Kind::heading) {
    const float x = at.x + placed.words_left + ImGui::CalcTextSize(line.words.c_str()).x + edge;
    const float middle = std::floor(y + 0.5f * ImGui::GetTextLineHeight());
    list.AddLine(ImVec2(x, middle), ImVec2(at.x + width, middle), style::packed(theme().outline),
                 frame.units(1.0f));
  }
  pop_font();
}

void draw_line(PanelFrame& frame, std::size_t i, float width) {
  const PatternLayout::Placed& placed = frame.ui.pattern_view.layout.lines()[i];
  const auto& rounds = placed.line.rounds;
  ImGui::SetCursorPos(ImVec2(0.0f, placed.top));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (rounds) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("line", ImVec2(width, placed.height))) wish_round(frame, rounds->first);
    ImGui::PopID();
    frame.mark("pattern/round/" + std::to_string(rounds->first));
    if (ImGui::IsItemHovered()) frame.rounds_under = rounds;
  }
  draw_ground(frame, placed, at, width);
  draw_words(frame, placed, at, width);
}

void draw_document(PanelFrame& frame) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("pattern text", ImVec2(0.0f, 0.0f), true, ImGuiWindowFlags_AlwaysVerticalScrollbar);
  ImGui::PopStyleVar();
  const ChartCache& cache = frame.ui.chart;
  PatternLayout& layout = frame.ui.pattern_view.layout;
  const float width = ImGui::GetContentRegionAvail().x;
  layout.refresh(cache.pattern(), cache.key(), width, frame.fonts, frame.layout.scale);
  follow(frame);
  const float scroll = ImGui::GetScrollY();
  for (std::size_t i = layout.line_below(scroll); i < layout.lines().size(); ++i) {
    if (layout.lines()[i].top > scroll + ImGui::GetWindowHeight()) break;
    draw_line(frame, i, width);
  }
  ImGui::SetCursorPos(ImVec2(0.0f, 0.0f));
  ImGui::Dummy(ImVec2(width, layout.height()));
  ImGui::EndChild();
  frame.mark("pattern/text");
}

}  // namespace

void draw_pattern_text(PanelFrame& frame) {
  draw_pattern_fields(frame);
  if (frame.timeline() == nullptr || frame.ui.chart.rounds() == 0) {
    wrapped_text("The pattern appears once the stitches have their labels.", theme().faint_text);
  } else {
    if (!frame.timeline()->complete()) wrapped_text("As far as the run is worked out.", theme().faint_text);
    draw_document(frame);
  }
}

}  // namespace app
