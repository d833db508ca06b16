// What a person says about the written pattern: its title, yarn, needle and style, folded away, and saving it.
#include <string>

#include "app/core/pattern_file.h"
#include "app/panels/widgets.h"

namespace app {

namespace {

// What is typed stays as it is typed; only options that came from elsewhere replace it.
void refresh_fields(const Session& session, PatternFields& fields) {
  if (fields.shown == session.pattern) return;
  fields.shown = session.pattern;
  fields.title.set(session.pattern.title);
  fields.yarn.set(session.pattern.yarn);
  fields.colour.set(session.pattern.colour);
  fields.needle.set(session.pattern.needle_mm ? knit::number_text(*session.pattern.needle_mm) : "");
  fields.trouble.clear();
}

void wish_options(PanelFrame& frame, const knit::PatternOptions& options) {
  frame.ui.pattern_fields.shown = options;
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
  PatternFields& fields = frame.ui.pattern_fields;
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
  PatternFields& fields = frame.ui.pattern_fields;
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
  box("Markers at main lines", "pattern/markers", options.markers,
      "Says where stitch markers are placed and slipped.");
  box("Repeats with stars", "pattern/stars", options.stars,
      "*K4, m1l; rep from * to end, in place of [K4, m1l] 6 times, where a round is one repeat.");
}

void draw_save(PanelFrame& frame) {
  if (ImGui::Button("Save...")) frame.ui.save.wanted = ExportKind::pattern;
  frame.mark("pattern/save");
  tooltip(frame, std::string("The ending says the format: ") + pattern_endings +
                     ". The chart alone: File, Save the chart.");
}

}  // namespace

void draw_pattern_fields(PanelFrame& frame) {
  if (frame.timeline() == nullptr) return;
  PatternFields& fields = frame.ui.pattern_fields;
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

}  // namespace app
