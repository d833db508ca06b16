// The stage's pseudo-code: the line that just ran is lit, values stand at the ends of lines, what has no line
// stands below. Pointing at a variable shows it in the view.
#include "app/panels/step/step.h"
#include "app/panels/step/step_parts.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/explain/code_variables.h"
#include "app/panels/kit/widgets.h"
#include "app/session/learning.h"

namespace app {

namespace {

// One frame's drawing.
struct Page {
  PanelFrame& frame;
  const Explained& at;
  const std::vector<Variable>& variables;
  std::vector<const knit::CodeVariable*> shown;  // whose values stand at a line
  std::string_view under;                        // the variable under the pointer; empty: none

  [[nodiscard]] const Variable& variable(const knit::CodeVariable* of) const {
    return *std::find_if(variables.begin(), variables.end(), [&](const Variable& v) { return v.of == of; });
  }
  [[nodiscard]] bool is_shown(const knit::CodeVariable* of) const {
    return std::find(shown.begin(), shown.end(), of) != shown.end();
  }
};

std::string tooltip_of(const Variable& variable) {
  std::string words(variable.of->symbol);
  if (!variable.value.empty()) words += " = " + variable.value;
  return words + "\n" + std::string(variable.of->meaning);
}

// In the panels' own letters, whatever the code's are.
void plain_tooltip(const PanelFrame& frame, const std::string& words) {
  push_font(frame.fonts.text);
  tooltip(frame, words);
  pop_font();
}

// Something that stands for a variable: lit while it is pointed at.
void take_pointing(Page& page, const Variable& variable, ImVec2 at, ImVec2 size, const char* kind) {
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(size);
  page.frame.mark(std::string(kind) + std::string(variable.of->key));
  if (!ImGui::IsItemHovered()) return;
  page.under = variable.of->key;
  plain_tooltip(page.frame, tooltip_of(variable));
}

void light_pointed(const Page& page, std::string_view name, ImVec2 at, ImVec2 size) {
  if (name != page.frame.session.learning->pointed_variable) return;
  const float edge = page.frame.units(2.0f);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x - edge, at.y),
                                            ImVec2(at.x + size.x + edge, at.y + size.y),
                                            style::packed(theme().accent, 70), page.frame.units(3.0f));
}

// A bar at every line of the step, and the one that it ended at lit all along.
void draw_bar(const Page& page, std::size_t line, ImVec2 low, ImVec2 high) {
  if (!page.at.lines || !page.at.lines->holds(line)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Colour colour = page.at.stopped ? theme().problem : theme().accent;
  const bool last = line == page.at.lines->last;
  if (last) list.AddRectFilled(low, high, style::packed(colour, 42));
  const float width = std::floor(page.frame.units(last ? 3.0f : 2.0f) + 0.5f);
  list.AddRectFilled(low, ImVec2(low.x + width, high.y), style::packed(colour, last ? 255 : 120));
}

Colour colour_of(CodePart::Kind kind, bool ran) {
  switch (kind) {
    case CodePart::Kind::keyword:
      return theme().break_hit;
    case CodePart::Kind::variable:
      return theme().accent;
    case CodePart::Kind::plain:
      break;
  }
  return ran ? theme().text : theme().faint_text;
}

// Gives where the words end.
float draw_parts(Page& page, const CodeLine& line, ImVec2 at, bool ran) {
  const float height = ImGui::GetTextLineHeight();
  for (const CodePart& part : parts_of(line)) {
    const bool variable = part.kind == CodePart::Kind::variable;
    const std::string words(part.text);
    const ImVec2 size(ImGui::CalcTextSize(words.c_str()).x, height);
    if (variable) light_pointed(page, part.variable->key, at, size);
    ImGui::GetWindowDrawList()->AddText(at, style::packed(colour_of(part.kind, ran)), words.c_str());
    if (variable) take_pointing(page, page.variable(part.variable), at, size, "variable/");
    at.x += size.x;
  }
  return at.x;
}

// At the line's end, if there is room for it.
void draw_value(Page& page, const CodeLine& line, float from, ImVec2 end, bool ran) {
  if (line.value == nullptr || page.is_shown(line.value)) return;
  const Variable& variable = page.variable(line.value);
  const ImVec2 size = ImGui::CalcTextSize(variable.value.c_str());
  const ImVec2 at(std::floor(end.x - size.x), end.y);
  if (variable.value.empty() || at.x < from + page.frame.units(6.0f)) return;
  page.shown.push_back(variable.of);
  light_pointed(page, variable.of->key, at, size);
  ImGui::GetWindowDrawList()->AddText(at, style::packed(ran ? theme().text : theme().faint_text),
                                      variable.value.c_str());
  take_pointing(page, variable, at, size, "value/");
}

// A value that several lines give stands at the last of them that ran, or at none.
bool gives_value(const Explained& at, std::size_t number) {
  const auto lines = at.code->lines;
  const auto same = [&](const CodeLine& line) { return line.value == lines[number].value; };
  if (std::count_if(lines.begin(), lines.end(), same) == 1) return true;
  if (!at.lines || !at.lines->holds(number)) return false;
  const auto after = lines.begin() + static_cast<std::ptrdiff_t>(number) + 1;
  return std::none_of(after, lines.begin() + static_cast<std::ptrdiff_t>(at.lines->last) + 1, same);
}

// Where there is no room for all lines, the one that ran comes in sight when it is another.
void follow(const Page& page, ImVec2 low, ImVec2 high) {
  const auto here = static_cast<int>(page.frame.timeline()->position());
  int& followed = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("followed"), -1);
  if (followed == here) return;
  followed = here;
  const float top = ImGui::GetWindowPos().y;
  if (low.y < top || high.y > top + ImGui::GetWindowHeight()) ImGui::SetScrollFromPosY(low.y - top, 0.5f);
}

struct Lines {
  ImVec2 at;
  float width, height;  // of a line
  float indent;         // from the bar to the words
};

void draw_line(Page& page, const Lines& lines, std::size_t number) {
  const CodeLine& line = page.at.code->lines[number];
  const ImVec2 low(lines.at.x, std::floor(lines.at.y + static_cast<float>(number) * lines.height));
  const ImVec2 high(low.x + lines.width, low.y + lines.height);
  const bool ran = page.at.lines && page.at.lines->holds(number);
  const float top = std::floor(low.y + 0.5f * (lines.height - ImGui::GetTextLineHeight()));
  draw_bar(page, number, low, high);
  if (page.at.lines && page.at.lines->last == number) follow(page, low, high);
  text_at(ImVec2(low.x + lines.indent - page.frame.units(6.0f), top), 1.0f, theme().faint_text,
          std::to_string(number + 1));
  const std::string_view under_before = page.under;
  const float from = draw_parts(page, line, ImVec2(low.x + lines.indent, top), ran);
  if (gives_value(page.at, number))
    draw_value(page, line, from, ImVec2(high.x - page.frame.units(4.0f), top), ran);
  ImGui::SetCursorScreenPos(low);
  ImGui::Dummy(ImVec2(lines.width, lines.height));
  page.frame.mark("code/" + std::to_string(number + 1));
  if (page.under == under_before)
    plain_tooltip(page.frame, std::string(line.meaning) + "\n\n" + std::string(line.source) + ".");
}

void draw_lines(Page& page) {
  const PseudoCode& code = *page.at.code;
  push_font(page.frame.fonts.mono);
  const Lines lines{ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x,
                    std::floor(ImGui::GetTextLineHeight() + page.frame.units(2.0f)),
                    page.frame.units(11.0f) + ImGui::CalcTextSize("12").x};
  ImGui::GetWindowDrawList()->AddRectFilled(
      lines.at,
      ImVec2(lines.at.x + lines.width, lines.at.y + lines.height * static_cast<float>(code.lines.size())),
      style::packed(theme().raised, 110));
  for (std::size_t i = 0; i < code.lines.size(); ++i) draw_line(page, lines, i);
  pop_font();
  ImGui::SetCursorScreenPos(
      ImVec2(lines.at.x, lines.at.y + lines.height * static_cast<float>(code.lines.size())));
  ImGui::Dummy(ImVec2(0.0f, 0.0f));
}

// Name left, value right.
void draw_cell(Page& page, const Variable& variable, ImVec2 at, float width) {
  const ImVec2 size(width, ImGui::GetTextLineHeight());
  const std::string symbol(variable.of->symbol);
  const float left = ImGui::CalcTextSize(symbol.c_str()).x + page.frame.units(8.0f);
  const std::string value = cut_to_width(variable.value, width - left);
  light_pointed(page, variable.of->key, at, size);
  text_at(at, 0.0f, theme().accent, symbol);
  text_at(ImVec2(at.x + width, at.y), 1.0f, theme().text, value);
  take_pointing(page, variable, at, size, "variable/");
}

// Two columns; what is too long for one takes a line of its own. Keeps the room that a listing once needed, so
// that what stands below keeps still.
void draw_aside(Page& page) {
  push_font(page.frame.fonts.mono);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float all = ImGui::GetContentRegionAvail().x;
  const float gap = page.frame.units(20.0f);
  const float half = std::floor(0.5f * (all - gap));
  const float line = std::floor(ImGui::GetTextLineHeight() + page.frame.units(2.0f));
  float y = at.y;
  bool right = false;
  for (const Variable& variable : page.variables) {
    if (variable.value.empty() || page.is_shown(variable.of)) continue;
    const std::string words = std::string(variable.of->symbol) + variable.value;
    const bool wide = ImGui::CalcTextSize(words.c_str()).x + page.frame.units(8.0f) > half;
    if (wide && right) y += line;
    if (wide) right = false;
    draw_cell(page, variable, ImVec2(right ? at.x + half + gap : at.x, y), wide ? all : half);
    if (wide || right) y += line;
    right = !wide && !right;
  }
  if (right) y += line;
  pop_font();
  const auto key = ImGui::GetID(page.at.code);
  float& most = *ImGui::GetStateStorage()->GetFloatRef(key);
  most = std::max(most, (y - at.y) / page.frame.layout.scale);
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(all, page.frame.units(most)));
}

// Whether this panel, and not a script, has a variable pointed at.
bool& pointing() { return *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("pointing")); }

void wish_pointed(PanelFrame& frame, std::string_view name) {
  if (name == frame.session.learning->pointed_variable) return;
  if (name.empty() && !pointing()) return;
  pointing() = !name.empty();
  frame.wish(PointAt{std::string(name)});
}

}  // namespace

void leave_variables(PanelFrame& frame) {
  if (!frame.session.learning->pointed_variable.empty()) frame.wish(PointAt{});
}

void draw_pseudo_code(PanelFrame& frame) {
  const auto at = explained(frame.session);
  if (!at) return leave_variables(frame);
  const std::vector<Variable> variables = variables_of(frame.session);
  Page page{frame, *at, variables, {}, {}};
  heading(frame, std::string(at->code->title).c_str());
  frame.mark("code");
  draw_lines(page);
  draw_aside(page);
  wish_pointed(frame, page.under);
}

}  // namespace app
