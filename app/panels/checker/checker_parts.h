// What the files of the checker's panel share.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "app/checker/checker.h"
#include "app/panels/kit/frame.h"
#include "app/panels/kit/widgets.h"

namespace app {

// The text field. ImGui has a copy of its own while one types; what changes the text from outside gives the field
// another number, so that it is read anew.
struct CheckerField {
  std::string words;
  SharedText shown;                    // the session's text that `words` was last seen to be
  std::vector<std::size_t> starts{0};  // of lines of `words`
  std::size_t longest = 0;             // bytes of the longest line
  int number = 0;
  bool active = false;            // is typed into
  int focus = 0;                  // frames in which it is still to be given the keyboard
  TextCaret told;                 // the caret as the session was last told, or told of
  std::optional<TextCaret> jump;  // where it is to go
  std::size_t from = 0, to = 0;   // bytes: what is marked, or the caret
  std::size_t seen = 0;           // byte of the caret that was last brought into sight
};

struct CheckerDialog {
  bool asked = false, shown = false;
  TextBuffer path;
};

// A tick, a cross, a question mark or a dash: told apart without colours too. `r`: half its size.
void draw_verdict(ImDrawList& list, knit::LineVerdict verdict, ImVec2 middle, float r);
Colour colour_of(knit::LineVerdict verdict);
knit::LineVerdict line_verdict_of(CheckVerdict verdict);

void draw_checker_editor(PanelFrame& frame, ImVec2 size);
void draw_checker_list(PanelFrame& frame, float height);
void draw_checker_view(PanelFrame& frame);

}  // namespace app
