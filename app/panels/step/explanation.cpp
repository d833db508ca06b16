// The step's panel: what the last step did, and what there is to see.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "app/explain/why_words.h"
#include "app/lessons/lesson.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/sides.h"
#include "app/panels/kit/term_text.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/step/step.h"
#include "app/panels/step/step_parts.h"
#include "app/session/learning.h"
#include "app/session/view.h"
#include "knit/model/words.h"

namespace app {

namespace {

void draw_place(PanelFrame& frame, const knit::Step* step) {
  const bool stopped = stop_shown(frame.session) != nullptr;
  push_font(frame.fonts.heading);
  if (step == nullptr) {
    text(frame.timeline() == nullptr ? "Nothing is open" : "The start");
  } else {
    text(capitalised(knit::name_of(step->place.stage)));
  }
  pop_font();
  if (step == nullptr) return;
  explains(frame, knit::name_of(step->place.stage));
  std::string where = step->place.row > 0 ? "row " + std::to_string(step->place.row) + ", " : "";
  where += "item " + std::to_string(step->place.item + 1);
  if (stopped) where += ", stopped";
  ImGui::SameLine();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + frame.units(4.0f));
  faint_text(where);
}

// Two columns: where the i-th of `count` begins.
struct Cells {
  std::size_t count;
  ImVec2 origin;
  float second;  // from the first column to the second
  float line;
  [[nodiscard]] std::size_t lines() const { return (count + 1) / 2; }
  [[nodiscard]] ImVec2 at(std::size_t i) const {
    const bool right = i >= lines();
    const std::size_t down = right ? i - lines() : i;
    return {right ? origin.x + second : origin.x, origin.y + static_cast<float>(down) * line};
  }
  [[nodiscard]] ImVec2 end() const { return {origin.x, origin.y + static_cast<float>(lines()) * line}; }
};

void draw_label(PanelFrame& frame, knit::Label label, std::size_t count, ImVec2 at, float width) {
  const std::string name(knit::name_of(label));
  const std::string number = with_commas(count);
  const float line = ImGui::GetTextLineHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(width, line));
  frame.mark("label/" + name);
  explained_tooltip(
      frame,
      "Colour of " + name + " on stitches and faces; the number is how many have been placed up to here.",
      name);
  const float side = 0.62f * line;
  const float top = at.y + 0.5f * (line - side);
  list.AddRectFilled(ImVec2(at.x, top), ImVec2(at.x + side, top + side), style::packed(theme().of(label)),
                     frame.units(2.0f));
  // The thesis's pale ones end somewhere, too.
  list.AddRect(ImVec2(at.x, top), ImVec2(at.x + side, top + side), style::packed(theme().faint_text, 150),
               frame.units(2.0f), 0, std::max(1.0f, std::floor(frame.units(1.0f))));
  list.AddText(ImVec2(at.x + side + frame.units(7.0f), at.y), style::packed(theme().text), name.c_str());
  push_font(frame.fonts.mono);
  const float wide = ImGui::CalcTextSize(number.c_str()).x;
  const Colour colour = count > 0 ? theme().text : theme().faint_text;
  list.AddText(ImVec2(at.x + width - wide, at.y), style::packed(colour), number.c_str());
  pop_font();
}

std::string counted(const char* name, std::size_t count) {
  return std::string(name) + (count > 0 ? " " + with_commas(count) : "") + "###" + name;
}

// "Problems 3", "Problems 0, remarks 5": what the list tells besides.
std::string problems_tab(std::size_t problems, std::size_t remarks) {
  std::string name = "Problems";
  if (problems > 0 || remarks > 0) name += " " + with_commas(problems);
  if (remarks > 0) name += ", remarks " + with_commas(remarks);
  return name + "###Problems";
}

// Of a line of buttons with these names.
float width_of_buttons(std::span<const std::string> names) {
  float width = 0.0f;
  for (const std::string& name : names) {
    width +=
        ImGui::CalcTextSize(name.c_str(), nullptr, true).x + 2.0f * ImGui::GetStyle().FramePadding.x + 1.0f;
  }
  return width;
}

void draw_lists(PanelFrame& frame) {
  const std::size_t rows = frame.timeline() != nullptr ? frame.timeline()->state().fabric.rows().size() : 0;
  const std::size_t problems = count_problems(frame);
  std::array<std::string, 4> names{counted("Rows", rows), counted("Candidates", 0),
                                   problems_tab(problems, count_remarks(frame)),
                                   counted("Breaks", frame.session.view->breaks.size())};
  // Numbers give way where there is too little room, those first that one sees at once in the list.
  const std::array<std::pair<std::size_t, std::string>, 3> shorter{
      {{0, counted("Rows", 0)}, {2, counted("Problems", problems)}, {3, counted("Breaks", 0)}}};
  for (const auto& [which, name] : shorter) {
    if (width_of_buttons(names) <= ImGui::GetContentRegionAvail().x) break;
    names.at(which) = name;
  }
  const std::array<std::string_view, 4> shown{names[0], names[1], names[2], names[3]};
  ImGui::BeginGroup();
  const int clicked = segmented("list", shown, static_cast<int>(frame.session.view->list), 0.0f);
  ImGui::EndGroup();
  frame.mark("list");
  if (frame.session.view->list == RunList::problems)
    tooltip(frame,
            "Problems are where the knit mesh goes wrong; remarks are what to know of the mesh and the "
            "finished piece.");
  if (clicked >= 0 && clicked != static_cast<int>(frame.session.view->list))
    frame.wish(ShowList{static_cast<RunList>(clicked)});
  switch (frame.session.view->list) {
    case RunList::rows:
      return draw_rows(frame);
    case RunList::candidates:
      return draw_candidates(frame);
    case RunList::problems:
      return draw_problems(frame);
    case RunList::breaks:
      return draw_breaks(frame);
  }
}

// What decided, under what was done; not while it plays, where it would come and go, nor where it is to be guessed.
void draw_cause(PanelFrame& frame) {
  const bool hidden = gives_away_causes(frame.session) || frame.session.view->playback.playing;
  const std::string words = hidden ? "" : cause(frame.session);
  if (words.empty()) return;
  push_font(frame.fonts.small);
  glossary_wrapped_text(frame, words, theme().text);
  pop_font();
  frame.mark("cause");
}

// Takes the same room for most sentences, so that what stands below keeps still while the run plays.
void draw_sentence(PanelFrame& frame, const std::string& words, Colour colour) {
  const float top = ImGui::GetCursorPosY();
  const float width = ImGui::GetContentRegionAvail().x;
  glossary_wrapped_text(frame, words, colour);
  frame.mark("sentence");
  const float least = (width < frame.units(400.0f) ? 3.0f : 2.0f) * ImGui::GetTextLineHeight();
  const float spare = top + least - (ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
  if (spare > 0.0f) {
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    ImGui::Dummy(ImVec2(width, spare));
  }
}

// The code and the lists need room there.
bool is_low(const PanelFrame& frame) { return frame.layout.explanation.height < frame.units(820.0f); }

void draw_last_step(PanelFrame& frame) {
  const knit::Step* stop = stop_shown(frame.session);
  const knit::Step* step = stop != nullptr ? stop : last_step(frame.session);
  draw_place(frame, step);
  draw_sentence(frame, sentence(frame.session), stop != nullptr ? theme().problem : theme().text);
  if (!is_low(frame)) draw_cause(frame);
  draw_pseudo_code(frame);
  if (is_low(frame)) draw_cause(frame);  // every line of the code and its values come first
}

struct Legend {
  std::optional<bool> open;  // as a person has folded it; none: as there is room
};

// The code and the lists need room: in a low window what there is to see folds away for them, unless a person
// has said how it should be.
bool shows_legend(const PanelFrame& frame) { return frame.own<Legend>().open.value_or(!is_low(frame)); }

bool draw_fold(PanelFrame& frame) {
  const bool open = shows_legend(frame);
  if (folding_heading(frame, open ? "Show" : "Show, labels", open)) frame.own<Legend>().open = !open;
  frame.mark("legend");
  tooltip(frame, open ? "Fold layers and labels away."
                      : "Layers to show or hide, and how often each label was placed.");
  return open;
}

void draw_layers(PanelFrame& frame) {
  if (!draw_fold(frame)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(frame.units(3.0f), frame.units(1.0f)));
  const float line = ImGui::GetFrameHeight() + frame.units(2.0f);
  // The first column has the longer names.
  const Cells cells{layer_count, ImGui::GetCursorScreenPos(), 0.54f * ImGui::GetContentRegionAvail().x, line};
  for (std::size_t i = 0; i < layer_count; ++i) {
    const auto layer = static_cast<Layer>(i);
    bool on = frame.session.view->shows(layer);
    const ImVec2 at = cells.at(i);
    ImGui::SetCursorScreenPos(at);
    // A wide fallback font must not reach into the other column.
    ImGui::PushClipRect(at, ImVec2(at.x + cells.second - frame.units(2.0f), at.y + line), true);
    if (ImGui::Checkbox(std::string(name_of(layer)).c_str(), &on)) frame.wish(SetLayer{layer, on});
    ImGui::PopClipRect();
    frame.mark("layer/" + std::string(key_of(layer)));
    tooltip(frame, tooltip_of(info_of(layer)));
  }
  ImGui::SetCursorScreenPos(cells.end());
  ImGui::PopStyleVar();
}

// Where short rows are asked for, whether or not one is worked yet: the lists below stay where they are.
bool has_turns(const PanelFrame& frame) {
  return frame.timeline() != nullptr &&
         frame.timeline()->parameters().short_rows.rows != knit::ShortRows::off;
}

void draw_legend(PanelFrame& frame) {
  using knit::Label;
  constexpr std::array all{Label::knit,  Label::main, Label::cast,      Label::m1r,        Label::m1l,
                           Label::k2tog, Label::ssk,  Label::turn_left, Label::turn_right, Label::marked};
  const std::span<const Label> labels = std::span(all).first(has_turns(frame) ? all.size() : all.size() - 3);
  heading(frame, "Labels");
  const LabelTally::Counts counts = frame.timeline() != nullptr
                                        ? frame.own<LabelTally>().count(frame.timeline()->state())
                                        : LabelTally::Counts{};
  const float gap = frame.units(22.0f);
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
  const Cells cells{labels.size(), ImGui::GetCursorScreenPos(), width + gap,
                    ImGui::GetTextLineHeight() + frame.units(2.0f)};
  for (std::size_t i = 0; i < labels.size(); ++i) {
    draw_label(frame, labels[i], counts[static_cast<std::size_t>(labels[i])], cells.at(i), width);
  }
  ImGui::SetCursorScreenPos(cells.end());
}

// Of what is selected, with the gap below it, as it was drawn last.
struct SelectedRoom {
  float height = 0.0f;
};

// The same at every step, whatever it says: the lists below keep their place and their height. What does not fit scrolls.
float step_height(const PanelFrame& frame) {
  constexpr float tallest = 480.0f, least = 150.0f, lists_least = 122.0f;  // plain units
  constexpr float lists_share = 0.21f;                                     // of the panel
  const float turns =
      shows_legend(frame) && has_turns(frame) ? ImGui::GetTextLineHeight() + frame.units(2.0f) : 0.0f;
  const float legend = turns + frame.units(shows_legend(frame) ? 270.0f : 30.0f);
  const float lists = std::max(frame.units(lists_least), lists_share * frame.layout.explanation.height);
  const float room = ImGui::GetContentRegionAvail().y - legend - lists;
  return std::max(frame.units(least),
                  std::min(room, frame.units(tallest)) - frame.own<SelectedRoom>().height);
}

}  // namespace

bool gives_away_causes(const Session& session) {
  return session.learning->prediction != nullptr || open_question(session) != nullptr;
}

template <>
void draw_side<SidePanel::step>(PanelFrame& frame) {
  ImGui::BeginChild("step", ImVec2(0.0f, step_height(frame)), false);
  draw_last_step(frame);
  ImGui::EndChild();
  frame.mark("step");
  draw_layers(frame);
  if (shows_legend(frame)) draw_legend(frame);
  const float top = ImGui::GetCursorPosY();
  draw_selected(frame);
  frame.own<SelectedRoom>().height = ImGui::GetCursorPosY() - top;
  draw_lists(frame);
}

}  // namespace app
