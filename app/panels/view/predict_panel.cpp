// Guessing: a card below the view that asks for the verdict before it falls. It has room of its own, so that it never
// covers what one looks at.
#include <algorithm>
#include <string>

#include "app/lessons/predict.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/view/view.h"
#include "app/session/learning.h"
#include "app/session/program.h"

namespace app {

namespace {

void draw_streak(PanelFrame& frame, const Prediction& prediction) {
  const std::int32_t longest = frame.session.program->preferences.longest_streak;
  const std::string words = "streak " + std::to_string(prediction.streak) +
                            (longest > 0 ? ", longest " + std::to_string(longest) : "");
  const float side = ImGui::GetFrameHeight();
  const float width = ImGui::CalcTextSize(words.c_str()).x + side + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - width));
  faint_text(words);
  frame.mark("predict/streak");
  tooltip(frame, std::to_string(prediction.right) + " of " + std::to_string(prediction.guessed) +
                     " guesses were right.");
  ImGui::SameLine();
  if (icon_button("no more", Icon::cross, ImVec2(side, side))) frame.wish(SetPredicting{false});
  frame.mark("predict/close");
  tooltip(frame, "No more guessing (" + keys_of(info_of(Command::predict)) + ")");
}

void draw_guesses(PanelFrame& frame) {
  struct Offer {
    const char* words;
    const char* mark;
    Command command;
  };
  for (const Offer& offer : {Offer{"Too near", "predict/near", Command::guess_near},
                             Offer{"Accepted", "predict/accepted", Command::guess_accepted},
                             Offer{"Too far", "predict/far", Command::guess_far}}) {
    const CommandInfo& info = info_of(offer.command);
    if (ImGui::Button((std::string(offer.words) + " (" + keys_of(info) + ")").c_str()))
      frame.wish(*info.make(frame.session));
    frame.mark(offer.mark);
    ImGui::SameLine(0.0f, frame.units(6.0f));
  }
  if (ImGui::Button("Just show it")) frame.wish(StepBy{Unit::item, 1});
  frame.mark("predict/skip");
  tooltip(frame, "See the verdict without guessing; it does not count (" +
                     keys_of(info_of(Command::forward_item)) + ")");
}

}  // namespace

void draw_prediction(PanelFrame& frame) {
  if (!frame.session.learning->prediction || frame.timeline() == nullptr) return;
  const Prediction& prediction = *frame.session.learning->prediction;
  if (frame.layout.guess.height <= 0.0f) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.units(14.0f), frame.units(6.0f)));
  begin_panel("Predict", frame.layout.guess, ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar();
  const auto asked = asked_vertex(frame.session);
  ImGui::AlignTextToFramePadding();
  push_font(frame.fonts.strong);
  text(asked ? "Vertex " + std::to_string(asked->candidate) + ": what will the verdict be?"
             : std::string("Guess the next verdict"));
  pop_font();
  frame.mark("predict/question");
  draw_streak(frame, prediction);
  if (asked) {
    draw_guesses(frame);
  } else {
    faint_text("Play, or step on: it pauses before a vertex is measured.");
  }
  if (prediction.told) {
    const Colour colour = prediction.told->right ? theme().selected : theme().problem;
    wrapped_text((prediction.told->right ? "Right. " : "No. ") + prediction.told->words, colour);
    frame.mark("predict/told");
  }
  ImGui::End();
}

}  // namespace app
