// The parts of the step's panel.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <string>

#include "app/panels/kit/widgets.h"

namespace app {

void draw_pseudo_code(PanelFrame& frame);  // of the current stage, with its variables
void draw_selected(PanelFrame& frame);     // one line over the lists, with ways on from there
void draw_rows(PanelFrame& frame);
void draw_candidates(PanelFrame& frame);
void draw_problems(PanelFrame& frame);
void draw_breaks(PanelFrame& frame);

// Whether something is to be guessed, which what decided beside it would give away.
bool gives_away_causes(const Session& session);
// What is left of the panel for a list; where that is little the panel scrolls as a whole.
ImVec2 list_size(const PanelFrame& frame);

// Of the whole run so far, as comparing and sweeps count them.
std::size_t count_problems(const PanelFrame& frame);
// What the list of problems tells besides: of the mesh and of the finished piece.
std::size_t count_remarks(const PanelFrame& frame);

// A break condition that is typed.
struct BreakField {
  TextBuffer text;
  std::string trouble;  // why what was typed is none
};

}  // namespace app
