// The offer of repairs: what is wrong with a mesh that was not opened, what each repair would do, and the choice.
#include <algorithm>
#include <string>

#include "app/files/load.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/view/overlays.h"
#include "app/session/jobs.h"
#include "app/session/program.h"

namespace app {

namespace {

void draw_choice(PanelFrame& frame) {
  if (ImGui::Button("Repair and open")) frame.wish(RepairAndOpen{});
  frame.mark("repair/open");
  tooltip(frame, "The file stays as it is. One click brings back what is open now.");
  ImGui::SameLine();
  if (ImGui::Button("Not now")) frame.wish(DropRepairOffer{});
  frame.mark("repair/not-now");
  tooltip(frame, "The mesh is not opened; what is open stays.");
}

constexpr std::size_t most_piece_lines = 6, most_piece_buttons = 12;

// As `--piece N` with all repairs that are needed.
void wish_piece(PanelFrame& frame, const RepairOffer& offer, std::size_t number) {
  frame.wish(
      OpenFile{offer.source.file, {true, {knit::keeping_piece(number)}}, {{}, false, offer.source.curves}});
}

struct PieceAsked {
  int number = 2;  // of many: too many for a button each
};

void draw_piece_number(PanelFrame& frame, const RepairOffer& offer, std::size_t pieces) {
  int& number = frame.own<PieceAsked>().number;
  const int last = static_cast<int>(std::min(pieces, knit::most_pieces));
  number = std::clamp(number, 1, last);
  edit_number(frame, "##piece", number, 1, last, "", frame.units(110.0f));
  frame.mark("repair/piece-number");
  ImGui::SameLine();
  if (ImGui::Button("Open this piece")) wish_piece(frame, offer, static_cast<std::size_t>(number));
  frame.mark("repair/open-piece");
  tooltip(frame, "With the other repairs that it needs.");
  faint_text(piece_words(*offer.plan, static_cast<std::size_t>(number)));
}

// Each piece is knitted by itself. They are counted by their triangles, most first. A few stand in a line each with their
// share, more than that say it in their tooltips.
void draw_pieces(PanelFrame& frame, const RepairOffer& offer) {
  const std::size_t pieces = offer.plan->pieces.size();
  if (pieces < 2) return;
  wrapped_text("It is in " + std::to_string(pieces) +
                   " pieces, that of the most triangles first. Open one by its number:",
               theme().faint_text);
  if (pieces > most_piece_buttons) return draw_piece_number(frame, offer, pieces);
  const bool lines = pieces <= most_piece_lines;
  for (std::size_t number = 1; number <= pieces; ++number) {
    if (number > 1 && !lines) ImGui::SameLine(0.0f, frame.units(4.0f));
    const std::string words = std::to_string(number);
    if (ImGui::Button(words.c_str(), ImVec2(frame.units(32.0f), 0.0f))) wish_piece(frame, offer, number);
    frame.mark("repair/piece-" + words);
    const std::string size = piece_words(*offer.plan, number);
    tooltip(frame, size + ".\nOpens it alone, with the other repairs that it needs.");
    if (!lines) continue;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    faint_text(size);
    frame.mark("repair/piece-words-" + words);
  }
}

}  // namespace

void draw_repair_offer(PanelFrame& frame) {
  const auto& offer = frame.session.jobs->repair_offer;
  if (!offer || frame.session.jobs->opening) return;  // what is chosen is on its way
  const Box& view = frame.layout.view;
  const float margin = std::min(frame.units(10.0f), 0.1f * view.width);
  const float width = std::min(frame.units(520.0f), view.width - 2.0f * margin);
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, view.y + 0.5f * view.height), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
  push_raised_look(frame);
  ImGui::Begin("Repairs", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings);
  pop_raised_look();
  push_font(frame.fonts.strong);
  wrapped_text(offer->source.file.filename().string() + " cannot be knitted as it is");
  pop_font();
  wrapped_text(offer->finding);
  ImGui::Dummy(ImVec2(0.0f, frame.units(2.0f)));
  wrapped_text("This would make it fit:", theme().faint_text);
  for (const knit::RepairStep& step : offer->plan->steps) {
    ImGui::Bullet();
    ImGui::SameLine();
    wrapped_text(step.would);
  }
  ImGui::Dummy(ImVec2(0.0f, frame.units(2.0f)));
  draw_pieces(frame, *offer);
  draw_choice(frame);
  ImGui::End();
}

// The offer of a session that was saved aside before a crash: a calm banner at the foot of the view.

void draw_rescue(PanelFrame& frame) {
  if (!frame.session.program->rescued) return;
  const Box& view = frame.layout.view;
  const float margin = std::min(frame.units(10.0f), 0.1f * view.width);
  const float width = std::min(frame.units(460.0f), view.width - 2.0f * margin);
  // Notices have the view's head.
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, view.bottom() - frame.units(40.0f)),
                          ImGuiCond_Always, ImVec2(0.5f, 1.0f));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
  push_raised_look(frame);
  ImGui::Begin("Rescue", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  wrapped_text("The last session ended without being closed:");
  push_font(frame.fonts.strong);
  wrapped_text(frame.session.program->rescued->words);
  pop_font();
  ImGui::Dummy(ImVec2(0.0f, frame.units(2.0f)));
  const ImVec2 size(frame.units(90.0f), 0.0f);
  if (ImGui::Button("Open it", size)) frame.wish(TakeRescued{});
  frame.mark("rescue/open");
  tooltip(frame, "Takes the place of what is open.");
  ImGui::SameLine();
  if (ImGui::Button("Forget it", size)) frame.wish(DropRescued{});
  frame.mark("rescue/forget");
  tooltip(frame, "Removes what was saved aside.");
  ImGui::End();
}

}  // namespace app
