// The text, and left of it for each line its number, its verdict and the stitches on the needles. Both scroll as one:
// the field is as large as its text, and what it stands in scrolls.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/panels/checker/checker_parts.h"

namespace app {

namespace {

const knit::CheckedLine* checked_line(const Checker& checker, std::size_t index) {
  const knit::CheckedSize* size = checker.shown();
  return size != nullptr ? line_numbered(*size, index + 1) : nullptr;
}

void measure(CheckerField& field) {
  field.starts = line_starts(field.words);
  field.longest = 0;
  for (std::size_t i = 0; i < field.starts.size(); ++i) {
    const std::size_t end = i + 1 < field.starts.size() ? field.starts[i + 1] : field.words.size();
    field.longest = std::max(field.longest, end - field.starts[i]);
  }
}

// What happened outside: another text, another place in it.
void take_over(CheckerField& field, const Checker& checker) {
  if (field.shown != checker.text) {
    if (*checker.text != field.words) {
      field.words = *checker.text;
      ++field.number;
      if (field.active) field.focus = 2;
      field.jump = checker.caret;
      measure(field);
    }
    field.shown = checker.text;
  }
  if (field.told != checker.caret) {
    field.told = checker.caret;
    field.jump = checker.caret;
    field.focus = 2;
  }
}

int grow_or_look(ImGuiInputTextCallbackData* data) {
  auto& field = *static_cast<CheckerField*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
    field.words.resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = field.words.data();
    return 0;
  }
  const auto bytes = static_cast<std::size_t>(data->BufTextLen);
  if (field.jump) {
    const std::size_t from = byte_of(field.starts, bytes, *field.jump);
    const std::size_t to = std::min(bytes, from + field.jump->length);
    data->SelectionStart = static_cast<int>(from);
    data->SelectionEnd = data->CursorPos = static_cast<int>(to);
    field.jump.reset();
    field.focus = 0;
  }
  const auto cursor = static_cast<std::size_t>(data->CursorPos);
  const bool marked = data->SelectionStart != data->SelectionEnd;
  const auto one = static_cast<std::size_t>(data->SelectionStart);
  const auto other = static_cast<std::size_t>(data->SelectionEnd);
  field.from = marked ? std::min(one, other) : cursor;
  field.to = marked ? std::max(one, other) : cursor;
  return 0;
}

// Only as far as is needed.
void bring_into_sight(CheckerField& field, ImVec2 glyph, float gutter) {
  const std::size_t caret = field.to;
  if (caret == field.seen) return;
  field.seen = caret;
  const TextCaret at = caret_at(field.starts, std::min(caret, field.words.size()));
  const float top = static_cast<float>(at.line - 1) * glyph.y;
  const float room = ImGui::GetWindowHeight() - 2.0f * glyph.y;
  const float now = ImGui::GetScrollY();
  if (top < now + glyph.y) ImGui::SetScrollY(std::max(0.0f, top - 2.0f * glyph.y));
  if (top + 2.0f * glyph.y > now + room) ImGui::SetScrollY(top + 3.0f * glyph.y - room);
  const float left = static_cast<float>(at.at) * glyph.x;
  const float wide = ImGui::GetWindowWidth() - gutter;
  if (left < ImGui::GetScrollX()) ImGui::SetScrollX(std::max(0.0f, left - 4.0f * glyph.x));
  if (left + 2.0f * glyph.x > ImGui::GetScrollX() + wide) ImGui::SetScrollX(left + 6.0f * glyph.x - wide);
}

struct InSight {
  ImVec2 text;                     // the first glyph, on the screen
  ImVec2 glyph;                    // width and height
  std::size_t first = 0, end = 0;  // lines in sight
};

// A thin line under what a sentence is about, as editors do it; and the line of the caret.
void draw_marks(const PanelFrame& frame, const Checker& checker, const CheckerField& field,
                const InSight& sight) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
  for (std::size_t i = sight.first; i < sight.end; ++i) {
    const float top = sight.text.y + static_cast<float>(i) * sight.glyph.y;
    if (i + 1 == checker.caret.line)
      list.AddRectFilled(ImVec2(ImGui::GetWindowPos().x, top), ImVec2(right, top + sight.glyph.y),
                         style::packed(theme().raised));
    const knit::CheckedLine* line = checked_line(checker, i);
    if (line == nullptr || !is_mistake(*line) || !checker.up_to_date()) continue;
    const std::size_t next = i + 1 < field.starts.size() ? field.starts[i + 1] - 1 : field.words.size();
    const std::size_t length = next - field.starts[i];
    const std::size_t from = line->word_length > 0 ? std::min(line->word_at, length) : 0;
    const std::size_t to = line->word_length > 0 ? std::min(length, from + line->word_length) : length;
    const char* const words = field.words.data() + field.starts[i];
    const float left = sight.text.x + ImGui::CalcTextSize(words, words + from).x;
    const float width = ImGui::CalcTextSize(words + from, words + to).x;
    const float y = top + sight.glyph.y - frame.units(1.0f);
    list.AddLine(ImVec2(left, y), ImVec2(left + width, y), style::packed(opaque(colour_of(line->verdict))),
                 frame.units(1.5f));
  }
}

struct Gutter {
  float number = 0.0f, mark = 0.0f, count = 0.0f;  // widths
  [[nodiscard]] float width() const { return number + mark + count; }
};

Gutter gutter_of(const Checker& checker, const CheckerField& field, ImVec2 glyph) {
  std::int64_t most = 100;
  if (const knit::CheckedSize* size = checker.shown())
    for (const knit::CheckedLine& line : size->lines) most = std::max(most, line.stitches.value_or(0));
  const auto digits = [&](std::size_t number) { return static_cast<float>(std::to_string(number).size()); };
  return {(digits(field.starts.size()) + 1.0f) * glyph.x, 2.0f * glyph.x,
          (digits(static_cast<std::size_t>(most)) + 1.5f) * glyph.x};
}

void draw_gutter(PanelFrame& frame, const Checker& checker, const Gutter& gutter, ImVec2 corner, float height,
                 const InSight& sight) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(corner, ImVec2(corner.x + gutter.width(), corner.y + height), true);
  for (std::size_t i = sight.first; i < sight.end; ++i) {
    const float top = sight.text.y + static_cast<float>(i) * sight.glyph.y;
    const bool here = i + 1 == checker.caret.line;
    text_at(ImVec2(corner.x + gutter.number - 0.5f * sight.glyph.x, top), 1.0f,
            here ? theme().text : theme().faint_text, std::to_string(i + 1));
    frame.memory.controls.insert_or_assign("checker/line/" + std::to_string(i + 1),
                                           Box{corner.x, top, gutter.width(), sight.glyph.y});
    const knit::CheckedLine* line = checked_line(checker, i);
    if (line == nullptr) continue;
    draw_verdict(list, line->verdict,
                 ImVec2(corner.x + gutter.number + 0.5f * gutter.mark, top + 0.5f * sight.glyph.y),
                 0.3f * sight.glyph.y);
    if (line->stitches)
      text_at(ImVec2(corner.x + gutter.width() - 0.8f * sight.glyph.x, top), 1.0f, theme().text,
              std::to_string(*line->stitches));
  }
  list.PopClipRect();
}

// In its scrolling window. True where the text changed.
bool draw_field(PanelFrame& frame, CheckerField& field, ImVec2 glyph) {
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const auto lines = static_cast<float>(field.starts.size());
  const ImVec2 size(std::max(room.x, (static_cast<float>(field.longest) + 4.0f) * glyph.x + 2.0f * padding.x),
                    std::max(room.y, (lines + 1.0f) * glyph.y + 2.0f * padding.y));
  if (field.focus > 0 && !ImGui::IsAnyMouseDown()) {
    ImGui::SetKeyboardFocusHere();
    --field.focus;
  }
  // Esc leaves the field; ImGui would take back with it all that was typed since it was entered.
  const bool leaves = field.active && key_pressed(Key::Escape);
  const std::string kept = leaves ? field.words : std::string();
  ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
  ImGui::PushID(field.number);
  field.words.reserve(field.words.size() + 1);
  const bool changed = ImGui::InputTextMultiline(
      "##text", field.words.data(), field.words.capacity() + 1, size,
      ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_CallbackAlways, grow_or_look, &field);
  field.active = ImGui::IsItemActive();
  frame.mark("checker/text");
  ImGui::PopID();
  ImGui::PopStyleColor();
  if (leaves) field.words = kept;
  return changed && !leaves;
}

void tell_caret(PanelFrame& frame, CheckerField& field) {
  if (!field.active || field.jump) return;
  TextCaret caret = caret_at(field.starts, std::min(field.from, field.words.size()));
  caret.length = field.to - field.from;
  if (caret == field.told) return;
  field.told = caret;
  frame.wish(GoToCheckedLine{caret.line, caret.at, caret.length});
}

}  // namespace

void draw_checker_editor(PanelFrame& frame, ImVec2 size) {
  const Checker& checker = *frame.session.view->checker;
  CheckerField& field = frame.own<CheckerField>();
  take_over(field, checker);
  push_font(frame.fonts.mono);
  const ImVec2 glyph(ImGui::CalcTextSize("0").x, ImGui::GetTextLineHeight());
  const Gutter gutter = gutter_of(checker, field, glyph);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(corner.x + gutter.width(), corner.y));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("lines", ImVec2(size.x - gutter.width(), size.y), true,
                    ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::PopStyleVar();
  InSight sight;
  sight.glyph = glyph;
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  sight.text = ImVec2(begin.x + ImGui::GetStyle().FramePadding.x, begin.y + ImGui::GetStyle().FramePadding.y);
  const float above = std::max(0.0f, corner.y - sight.text.y);
  sight.first = std::min(field.starts.size(), static_cast<std::size_t>(above / glyph.y));
  sight.end = std::min(field.starts.size(), sight.first + static_cast<std::size_t>(size.y / glyph.y) + 2);
  draw_marks(frame, checker, field, sight);
  if (draw_field(frame, field, glyph)) {
    measure(field);
    frame.wish(SetCheckedText{field.words, false});
  }
  tell_caret(frame, field);
  bring_into_sight(field, glyph, gutter.width());
  ImGui::EndChild();
  const ImVec2 after = ImGui::GetCursorScreenPos();
  draw_gutter(frame, checker, gutter, corner, size.y, sight);
  pop_font();
  ImGui::SetCursorScreenPos(ImVec2(corner.x, after.y));
}

}  // namespace app
