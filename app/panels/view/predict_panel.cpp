// Guessing: a card over the foot of the view that asks for the verdict before it falls.
#include <algorithm>
#include <string>

#include "app/lessons/predict.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/view/view.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/view.h"

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
  const Box& view = frame.layout.view;
  const float margin = frame.units(14.0f);
  const float width = std::min(view.width - 2.0f * margin, frame.units(560.0f));
  // Who knits along has the foot for that.
  const bool top = frame.session.view->gaze.knit_along.has_value();
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, top ? view.y + margin : view.bottom() - margin),
                          ImGuiCond_Always, ImVec2(0.5f, top ? 0.0f : 1.0f));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
  push_raised_look(frame);
  ImGui::Begin("Predict", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
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
