// The written pattern as a knitter reads it. The current round is lit and kept in sight; the line under the
// pointer lights its rounds in the view, the chart and the timeline, and the stitch under the pointer there lights
// its line here.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/files/pattern_export.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/kit/sides.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern.h"
#include "app/panels/pattern/pattern_parts.h"
#include "app/panels/pattern/piece_list.h"
#include "app/session/remarks.h"
#include "app/session/view.h"
#include "knit/insight/narrate.h"
#include "knit/model/settings_table.h"

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

// Knitting along, of the deal at hand; 0: of none.
std::int16_t current_deal(const PanelFrame& frame) {
  const Gaze& gaze = frame.session.view->gaze;
  return gaze.knit_along ? gaze.knit_along_deal : std::int16_t{0};
}

// The round that has come to hand, or to be meant elsewhere, since the last frame.
void follow(PanelFrame& frame) {
  PatternView& view = frame.own<PatternView>();
  const auto follow_round = [&](std::int32_t round, std::int16_t deal = 0) {
    if (const auto line = view.layout.line_of(round, deal)) show_line(view.layout.lines()[*line]);
  };
  const std::int32_t hand = current_round(frame);
  const std::int16_t deal = current_deal(frame);
  if (hand != view.followed || deal != view.followed_deal) follow_round(hand, deal);
  view.followed = hand;
  view.followed_deal = deal;
  // A line that is pointed at stays where it is.
  const auto meant = rounds_meant(frame.session);
  const bool elsewhere = meant && !ImGui::IsWindowHovered();
  if (elsewhere && meant != view.followed_meant) follow_round(meant->first);
  view.followed_meant = meant;
}

void draw_ground(const PanelFrame& frame, const PatternLayout::Placed& placed, ImVec2 at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + width, at.y + placed.height);
  const PatternLine& line = placed.line;
  const std::vector<RoundSpan> meant = all_rounds_meant(frame.session);
  const bool is_meant =
      std::any_of(meant.begin(), meant.end(), [&](const RoundSpan& span) { return line.is_meant(span); });
  const bool at_hand = line.kind == Kind::round && line.deal == current_deal(frame);
  if (at_hand && line.says(current_round(frame))) {
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

std::string mark_of(const PatternLine& line) {
  const std::string row = std::to_string(line.rounds->first);
  if (line.kind == Kind::named) return "pattern/named/" + row;
  if (line.kind == Kind::piece) return "pattern/piece/" + row;
  if (line.deal != 0) return "pattern/deal/" + row + "/" + std::to_string(line.deal);
  return (line.label.empty() && line.rounds->first > 1 ? "pattern/end/" : "pattern/round/") + row;
}

void draw_line(PanelFrame& frame, std::size_t i, float width) {
  const PatternLayout::Placed& placed = frame.own<PatternView>().layout.lines()[i];
  const auto& rounds = placed.line.rounds;
  ImGui::SetCursorPos(ImVec2(0.0f, placed.top));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (rounds) {
    ImGui::PushID(static_cast<int>(i));
    const PatternLine& line = placed.line;
    if (ImGui::InvisibleButton("line", ImVec2(width, placed.height)))
      wish_round(frame, rounds->first, line.deal);
    ImGui::PopID();
    frame.mark(mark_of(line));
    if (ImGui::IsItemHovered()) {
      frame.rounds_under = rounds;
      frame.twins_under = line.twins;
    }
  }
  draw_ground(frame, placed, at, width);
  draw_words(frame, placed, at, width);
}

void draw_document(PanelFrame& frame) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("pattern text", ImVec2(0.0f, 0.0f), true, ImGuiWindowFlags_AlwaysVerticalScrollbar);
  ImGui::PopStyleVar();
  const ChartCache& cache = frame.own<ChartCache>();
  PatternLayout& layout = frame.own<PatternView>().layout;
  const float width = ImGui::GetContentRegionAvail().x;
  const knit::LimbPlan* plan = cache.in_pieces() ? &cache.pieces().plan : nullptr;
  layout.refresh(cache.pattern(), plan, cache.key(), width, frame.fonts, frame.layout.scale);
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

// --- what a person says about the written pattern: its title, yarn, needle and style, folded away, and saving it

// What is typed stays as it is typed; only options that came from elsewhere replace it.
void refresh_fields(const Session& session, PatternFields& fields) {
  if (fields.shown == session.view->pattern) return;
  fields.shown = session.view->pattern;
  fields.title.set(session.view->pattern.title);
  fields.yarn.set(session.view->pattern.yarn);
  fields.colour.set(session.view->pattern.colour);
  fields.needle.set(session.view->pattern.needle_mm ? knit::number_text(*session.view->pattern.needle_mm)
                                                    : "");
  fields.trouble.clear();
}

void wish_options(PanelFrame& frame, const knit::PatternOptions& options) {
  frame.own<PatternFields>().shown = options;
  frame.wish(SetPatternOptions{options});
}

struct Field {
  const char* name;
  const char* hint;  // while it is empty
  const char* help;
};

// True when its words have changed.
bool draw_field(PanelFrame& frame, const Field& field, TextBuffer& buffer) {
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  faint_text(field.name);
  tooltip(frame, field.help);
  ImGui::SameLine(left + frame.units(64.0f));
  ImGui::SetNextItemWidth(-1.0f);
  const bool changed = ImGui::InputTextWithHint((std::string("##") + field.name).c_str(), field.hint,
                                                buffer.bytes.data(), buffer.bytes.size());
  frame.mark("pattern/" + std::string(field.name));
  tooltip(frame, field.help);
  return changed;
}

void draw_words(PanelFrame& frame, knit::PatternOptions options) {
  PatternFields& fields = frame.own<PatternFields>();
  const auto take = [&](const Field& field, TextBuffer& buffer, std::string& words) {
    if (!draw_field(frame, field, buffer)) return;
    words = buffer.text();
    wish_options(frame, options);
  };
  take({"Title", "the mesh's name", "Stands over the pattern and on the chart."}, fields.title,
       options.title);
  take({"Yarn", "by its weight alone", "What you call it: maker and name."}, fields.yarn, options.yarn);
  take({"Colour", "not said", "Of the yarn."}, fields.colour, options.colour);
}

// Taken as soon as it can be; blamed only once the hand has left it.
void draw_needle(PanelFrame& frame, knit::PatternOptions options) {
  PatternFields& fields = frame.own<PatternFields>();
  const Field field{"Needle", "mm; the usual one for the yarn", "In millimetres, from 0.5 to 50."};
  const bool changed = draw_field(frame, field, fields.needle);
  const bool left = ImGui::IsItemDeactivated();
  const std::string typed = fields.needle.text();
  const auto needle = needle_mm_of(typed);
  const bool usable = needle || typed.empty();
  if (changed && usable) {
    options.needle_mm = needle;
    wish_options(frame, options);
  }
  if (usable) fields.trouble.clear();
  if (left && !usable)
    fields.trouble = "The needle cannot be \"" + typed + "\" mm; give " + needle_range + ".";
  if (!fields.trouble.empty()) wrapped_text(fields.trouble, theme().problem);
}

void draw_style(PanelFrame& frame, knit::PatternOptions options) {
  const auto box = [&](const char* words, const char* mark, bool& on, const char* help) {
    if (ImGui::Checkbox(words, &on)) wish_options(frame, options);
    frame.mark(mark);
    tooltip(frame, help);
  };
  bool is_short = in_form(options, frame.timeline()->furthest()).form == knit::PatternForm::short_form;
  if (ImGui::Checkbox("Short form", &is_short)) {
    knit::PatternOptions chosen = options;
    chosen.form = is_short ? knit::PatternForm::short_form : knit::PatternForm::full;
    wish_options(frame, chosen);
  }
  frame.mark("pattern/short");
  tooltip(
      frame,
      "Shaping rounds are named once, and what comes again is said once: [Knit 2 rnds, inc rnd] 3 times. "
      "Where rounds have no sections that stay alike, they are written out. Ticked by itself where counts "
      "are in a rhythm.");
  box("Markers at main lines", "pattern/markers", options.markers,
      "Says where stitch markers are placed and slipped.");
  box("Repeats with stars", "pattern/stars", options.stars,
      "*K4, m1l; rep from * to end, in place of [K4, m1l] 6 times, where a round is one repeat.");
  bool wraps = options.turns == knit::ShortRowTurns::wrap;
  if (ImGui::Checkbox("Wrap and turn", &wraps)) {
    knit::PatternOptions chosen = options;
    chosen.turns = wraps ? knit::ShortRowTurns::wrap : knit::ShortRowTurns::german;
    wish_options(frame, chosen);
  }
  frame.mark("pattern/turns");
  tooltip(frame,
          "Short rows turn by wrap and turn (w&t), in place of German short rows with a double stitch (DS).");
}

void draw_save(PanelFrame& frame) {
  if (ImGui::Button("Save...")) ask_to_save(frame, "pattern");
  frame.mark("pattern/save");
  std::string help("The ending says the format: ");
  help.append(pattern_endings).append(". The chart alone: File, Save the chart.");
  tooltip(frame, help);
}

void draw_pattern_fields(PanelFrame& frame) {
  if (frame.timeline() == nullptr) return;
  PatternFields& fields = frame.own<PatternFields>();
  refresh_fields(frame.session, fields);
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  const float button =
      ImGui::CalcTextSize("Save...").x + 2.0f * ImGui::GetStyle().FramePadding.x + frame.units(2.0f);
  ImGui::SetNextItemOpen(fields.open);
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().faint_text));
  push_font(frame.fonts.strong);
  fields.open = ImGui::TreeNodeEx("Title, yarn, needle",
                                  ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_FramePadding);
  pop_font();
  ImGui::PopStyleColor();
  frame.mark("pattern/fields");
  ImGui::SameLine(right - button);
  draw_save(frame);
  if (!fields.open) return;
  draw_words(frame, *fields.shown);
  draw_needle(frame, *fields.shown);
  draw_style(frame, *fields.shown);
}

// Why the pattern ends early, or is none: what the run stopped for, and the way there.
void draw_stop(PanelFrame& frame) {
  const knit::Timeline& timeline = *frame.timeline();
  const knit::Step* stop = timeline.stop();
  if (stop == nullptr) return;
  const bool some = frame.own<ChartCache>().has_pattern();
  wrapped_text("The run stopped after step " + with_commas(timeline.known()) +
                   (some ? ", so the pattern ends early. " : ", so there is no pattern. ") +
                   knit::narrate(*stop, timeline.parameters_of_stop()),
               theme().problem);
  frame.mark("pattern/stop");
  if (timeline.position() == timeline.known()) return;
  if (ImGui::SmallButton("Show where it stopped")) frame.wish(SeekTo{timeline.known()});
  frame.mark("pattern/to-stop");
  tooltip(frame, "To the last step of the run, where it stopped.");
}

}  // namespace

template <>
void draw_side<SidePanel::pattern>(PanelFrame& frame) {
  draw_pattern_fields(frame);
  if (frame.timeline() != nullptr) frame.own<ChartCache>().refresh(frame.session);
  if (frame.timeline() != nullptr) draw_stop(frame);
  if (frame.timeline() == nullptr || !frame.own<ChartCache>().has_pattern()) {
    if (frame.timeline() != nullptr && frame.timeline()->stop() != nullptr) return;
    wrapped_text("The pattern appears once the stitches have their labels.", theme().faint_text);
  } else {
    if (!frame.timeline()->complete()) wrapped_text("As far as the run is worked out.", theme().faint_text);
    if (frame.own<ChartCache>().in_pieces()) draw_piece_list(frame, frame.own<ChartCache>());
    draw_document(frame);
  }
}

}  // namespace app
