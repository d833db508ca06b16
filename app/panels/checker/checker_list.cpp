// What is wrong or not understood, a line each, and over it the sentence of the line that one is in.
#include <algorithm>
#include <string>

#include "app/panels/checker/checker_parts.h"

namespace app {

namespace {

const knit::CheckedLine* line_of(const Checker& checker, std::size_t number) {
  const knit::CheckedSize* size = checker.shown();
  return size != nullptr ? line_numbered(*size, number) : nullptr;
}

std::string sentence_of(const knit::CheckedLine& line) {
  if (!line.sentence.empty()) return line.sentence;
  std::string words = "line " + std::to_string(line.number) + ": " + std::string(verdict_words(line.verdict));
  if (line.stitches)
    words += " " + with_commas(static_cast<std::size_t>(*line.stitches), "stitch", "stitches") + ".";
  return words;
}

void draw_here(PanelFrame& frame, const Checker& checker) {
  const knit::CheckedLine* line = line_of(checker, checker.caret.line);
  const std::string words = line != nullptr ? sentence_of(*line) : "No line of work.";
  const bool told = line != nullptr && is_mistake(*line);
  wrapped_text(words, told ? theme().text : theme().faint_text);
  frame.mark("checker/here");
}

void draw_mistake(PanelFrame& frame, const Checker& checker, const knit::CheckedLine& mistake) {
  ImGui::PushID(static_cast<int>(mistake.number));
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  if (ImGui::Selectable("##mistake", mistake.number == checker.caret.line, 0, ImVec2(width, line))) {
    const TextCaret mark = mark_of(checker, mistake);
    frame.wish(GoToCheckedLine{mark.line, mark.at, mark.length});
    frame.own<CheckerField>().told = {0, 0, 0};  // a second click goes there again
  }
  frame.mark("checker/mistake/" + std::to_string(mistake.number));
  const std::string words = sentence_of(mistake);
  const std::string cut = cut_to_width(words, width - 1.6f * line);
  if (cut != words) tooltip(frame, words);
  draw_verdict(*ImGui::GetWindowDrawList(), mistake.verdict, ImVec2(at.x + 0.6f * line, at.y + 0.5f * line),
               0.32f * line);
  text_at(ImVec2(at.x + 1.5f * line, at.y), 0.0f, theme().text, cut);
  ImGui::PopID();
}

}  // namespace

void draw_checker_list(PanelFrame& frame, float height) {
  const Checker& checker = *frame.session.view->checker;
  const float foot = ImGui::GetCursorPosY() + height;
  const auto mistakes =
      checker.shown() != nullptr ? mistakes_of(*checker.shown()) : std::vector<const knit::CheckedLine*>();
  if (ImGui::Button("Next mistake") && !mistakes.empty()) frame.wish(ToMistake{1});
  frame.mark("checker/next");
  tooltip(frame,
          "To the next line that does not add up or is not understood (F4), or the one before (Shift+F4).");
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::AlignTextToFramePadding();
  draw_here(frame, checker);
  ImGui::EndGroup();
  ImGui::BeginChild("mistakes", ImVec2(0.0f, std::max(1.0f, foot - ImGui::GetCursorPosY())), true);
  if (mistakes.empty()) faint_text(checker.text->empty() ? "" : "No line has a mistake.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(mistakes.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_mistake(frame, checker, *mistakes[static_cast<std::size_t>(i)]);
  ImGui::EndChild();
}

}  // namespace app
