// The tubes of a shape, drawn upward: what is knitted so far, what waits on holders, and a few sentences about them.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/kit/sides.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/tubes/tube_list.h"
#include "app/panels/tubes/tubes_drawing.h"
#include "knit/model/words.h"

namespace app {

namespace {

// What the symbols stand for, those that are there, on as many lines as they need.
void draw_key_of_symbols(const PanelFrame& frame, const TubesDrawing& drawing) {
  push_font(frame.fonts.small);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float right = start.x + ImGui::GetContentRegionAvail().x;
  const float line = ImGui::GetTextLineHeight();
  const float r = frame.units(3.5f);
  ImVec2 at = start;
  const auto next = [&](const std::string& words) {
    const float width = 4.0f * r + ImGui::CalcTextSize(words.c_str()).x;
    if (at.x > start.x && at.x + width > right) at = ImVec2(start.x, at.y + line);
    text_at(ImVec2(at.x + 3.0f * r, at.y), 0.0f, theme().faint_text, words);
    const ImVec2 middle(at.x + r, at.y + 0.55f * line);
    at.x += width + frame.units(6.0f);
    return middle;
  };
  const ImU32 colour = style::packed(theme().faint_text);
  for (const auto kind : {knit::EventKind::cast_on, knit::EventKind::split, knit::EventKind::join,
                          knit::EventKind::bind_off, knit::EventKind::ring_cast_on}) {
    const bool there =
        std::any_of(drawing.plan.events.begin(), drawing.plan.events.end(),
                    [&](const knit::TubeEvent& event) { return event_word(event.kind) == event_word(kind); });
    if (!there) continue;
    const ImVec2 middle = next(std::string(event_word(kind)));
    draw_event_symbol(drawing.list, kind, middle, r, colour, style::packed(theme().panel));
  }
  if (drawing.plan.held_most > 0) {
    const ImVec2 middle = next("on a holder");
    for (const float x : {-r, 0.4f * r})
      drawing.list.AddRectFilled(ImVec2(middle.x + x, middle.y - 0.3f * r),
                                 ImVec2(middle.x + x + r, middle.y + 0.3f * r),
                                 style::packed(theme().warning));
  }
  pop_font();
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy(ImVec2(1.0f, at.y + line - start.y));
}

// --- the panel -------------------------------------------------------------------------------------------------

// A row that is cast on is nowhere else than in the stages that make rows.
void wish_first_row(PanelFrame& frame, knit::RowId row) {
  const knit::Row* made = frame.timeline()->furthest().fabric.find_row(row);
  if (made != nullptr && made->on.empty())
    return frame.wish(SeekPlace{{knit::stage_of_row(row), row, INT32_MAX}});
  wish_row(frame, row);
}

// To the step that deals it, to where its tube begins, or to where it has ended; what a click does, in words.
std::string_view follow_event(PanelFrame& frame, const TubesDrawing& drawing, std::int32_t event,
                              bool clicked) {
  const knit::TubeEvent& of = drawing.plan.event(event);
  const auto rows_of = [&](const std::vector<knit::TubeId>& tubes) {
    const knit::TubeId tube = tubes.front();
    const knit::RowId first = drawing.place(tube).first_row;
    return RoundSpan{first, first + drawing.tube(tube).rows() - 1};
  };
  if (of.kind == knit::EventKind::cast_on || of.kind == knit::EventKind::bind_off) {
    const bool begins = of.kind == knit::EventKind::cast_on;
    const RoundSpan rows = rows_of(begins ? of.above : of.below);
    if (rows.first == 0) return "";
    if (clicked && begins) wish_first_row(frame, rows.first);
    if (clicked && !begins) frame.wish(SeekPlace{{knit::stage_of_row(rows.last), rows.last, INT32_MAX}});
    return begins ? "\nClick: to its first row." : "\nClick: to its last row.";
  }
  const auto& deals = frame.timeline()->furthest().fabric.deals();
  const auto deal =
      std::find_if(deals.begin(), deals.end(), [&](const auto& one) { return one->event == event; });
  if (deal == deals.end()) return "";
  const auto number = static_cast<std::int32_t>(deal - deals.begin()) + 1;
  if (clicked) frame.wish(SeekTo{knit::steps_of_deal(*frame.timeline(), number).begin + 1});
  return "\nClick: to the step that deals it.";
}

// The event under the pointer. Before the tubes, on whose ends events stand.
std::optional<std::int32_t> event_items(PanelFrame& frame, const TubesDrawing& drawing) {
  std::optional<std::int32_t> pointed;
  const float r = frame.units(6.0f);
  for (std::size_t i = 0; i < drawing.plan.events.size(); ++i) {
    const ImVec2 at = event_at(drawing, i);
    const auto event = static_cast<std::int32_t>(i);
    const std::string name = "tube-event/" + std::to_string(i);
    ImGui::SetCursorScreenPos(ImVec2(at.x - r, at.y - r));
    const bool clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(2.0f * r, 2.0f * r));
    frame.mark(name);
    if (ImGui::IsItemHovered()) pointed = event;
    const std::string_view does = follow_event(frame, drawing, event, clicked);
    tooltip(frame, event_words(drawing.plan, event) + std::string(does));
  }
  return pointed;
}

// The tube that the pointer is over.
std::optional<knit::TubeId> draw_tube_items(PanelFrame& frame, const TubesDrawing& drawing, bool over_event) {
  std::optional<knit::TubeId> pointed;
  const float room = 0.5f * static_cast<float>(drawing.seen.layout.column) * drawing.ground.width;
  for (const ShownTube& shown : drawing.tubes) {
    const TubePlace& place = drawing.place(shown.id);
    const float half = std::min(std::max(shown.half, frame.units(9.0f)), room);
    const float top = drawing.y_of(place.high);
    const std::string name = "tube/" + knit::tube_name(shown.id);
    ImGui::SetCursorScreenPos(ImVec2(shown.x - half, top));
    const bool clicked = ImGui::InvisibleButton(
        name.c_str(), ImVec2(std::max(1.0f, 2.0f * half), std::max(1.0f, drawing.y_of(place.low) - top)));
    frame.mark(name);
    if (ImGui::IsItemHovered()) pointed = shown.id;
    if (!over_event)
      tooltip(frame, tube_words(drawing.plan, drawing.seen.layout, shown.id,
                                drawing.seen.counts[static_cast<std::size_t>(shown.id)]));
    if (clicked && place.first_row > 0) wish_first_row(frame, place.first_row);
  }
  return pointed;
}

// In other panels: the tube's rounds, and those of its twins.
void light_rounds(PanelFrame& frame, const TubesDrawing& drawing, knit::TubeId pointed) {
  if (drawing.tube(pointed).rows() == 0) return;
  for (const knit::TubeId tube : twins_of(drawing, pointed)) {
    const knit::RowId first = drawing.place(tube).first_row;
    const RoundSpan rounds{first, first + drawing.tube(tube).rows() - 1};
    if (tube == pointed)
      frame.rounds_under = rounds;
    else if (first > 0)
      frame.twins_under.push_back(rounds);
  }
}

void draw_drawing(PanelFrame& frame, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float air = frame.units(12.0f);
  const TubesDrawing drawing =
      drawing_of(frame, {at.x, at.y + air, size.x, std::max(1.0f, size.y - 2.0f * air)});
  drawing.list.AddRectFilled(at, ImVec2(at.x + size.x, at.y + size.y), style::packed(theme().background),
                             frame.units(2.0f));
  const std::optional<std::int32_t> event = event_items(frame, drawing);
  const std::optional<knit::TubeId> pointed = draw_tube_items(frame, drawing, event.has_value());
  draw_tubes(frame, drawing, pointed);
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(size);
  frame.mark("tubes/drawing");
  draw_key_of_symbols(frame, drawing);
  const TubeListUse list = draw_tube_list(frame, drawing);
  frame.mark("tubes/list");
  if (list.clicked && drawing.place(*list.clicked).first_row > 0)
    wish_first_row(frame, drawing.place(*list.clicked).first_row);
  if (const auto tube = pointed ? pointed : list.pointed) light_rounds(frame, drawing, *tube);
}

float height_of_words(const std::vector<std::string>& words) {
  const float width = ImGui::GetContentRegionAvail().x;
  float height = 0.0f;
  for (const std::string& sentence : words)
    height +=
        ImGui::CalcTextSize(sentence.c_str(), nullptr, false, width).y + ImGui::GetStyle().ItemSpacing.y;
  return height;
}

// Instead of the drawing; empty: there is one.
std::string why_no_tubes(const PanelFrame& frame) {
  if (frame.timeline() == nullptr) return "Rows from contours show their tubes here, once a mesh is open.";
  const knit::Timeline& timeline = *frame.timeline();
  if (state_with_plan(timeline).tubes) return "";
  const std::string here = " Rows from contours show their tubes here";
  if (as_chosen(timeline.parameters(), timeline.furthest()).rows.source == knit::RowSource::rings)
    return "Rows come from the mesh's own rings, one tube from end to end." + here +
           ": choose contours in \"Rows from\".";
  if (timeline.stop() != nullptr)
    return "The run stops before its tubes are planned; the list of problems says why." + here + ".";
  return "The tubes are not planned yet: play on, or go to the end of the stage Tubes." + here + ".";
}

}  // namespace

template <>
void draw_side<SidePanel::tubes>(PanelFrame& frame) {
  const std::string why = why_no_tubes(frame);
  if (!why.empty()) {
    wrapped_text(why, theme().faint_text);
    frame.mark("tubes/none");
    return;
  }
  const std::vector<std::string>& words = seen_now(frame).words;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const knit::TubePlan& plan = *state_with_plan(*frame.timeline()).tubes;
  const float below = height_of_words(words) + height_of_tube_list(frame, plan.tubes.size()) +
                      3.0f * ImGui::GetTextLineHeight();
  // Of many events each has room for its symbol; then the panel scrolls.
  const float least = frame.units(std::max(240.0f, 8.0f * static_cast<float>(plan.events.size())));
  draw_drawing(frame, ImVec2(room.x, std::floor(std::max(least, room.y - below))));
  for (std::size_t i = 0; i < words.size(); ++i) {
    wrapped_text(words[i], i == 0 ? theme().text : theme().faint_text);
    frame.mark("tubes/words/" + std::to_string(i));
  }
  if (!frame.timeline()->state().tubes)
    wrapped_text("At this step they are not planned yet.", theme().warning);
}

}  // namespace app
