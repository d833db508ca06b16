// What floats over the view: notices, the banner while a vertex is picked, a word while long work goes on.
#include <algorithm>
#include <memory>
#include <string>

#include "app/actions/opening.h"
#include "app/explain/found_words.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/offers/repair_buttons.h"
#include "app/panels/view/overlays.h"
#include "app/panels/view/view.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "knit/insight/narrate.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr ImGuiWindowFlags floating = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

Colour colour_of(Notice::Kind kind) {
  switch (kind) {
    case Notice::Kind::info:
      return theme().accent;
    case Notice::Kind::warning:
      return theme().warning;
    case Notice::Kind::error:
      return theme().problem;
  }
  return theme().accent;
}

const char* name_of(Notice::Kind kind) {
  switch (kind) {
    case Notice::Kind::info:
      return "";
    case Notice::Kind::warning:
      return "Warning: ";
    case Notice::Kind::error:
      return "Error: ";
  }
  return "";
}

void draw_notice(PanelFrame& frame, std::size_t i) {
  const Notice& notice = frame.session.outbox->notices[i];
  const float side = ImGui::GetFrameHeight();
  ImGui::PushID(static_cast<int>(i));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float bar = frame.units(4.0f);
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + bar + frame.units(8.0f));
  ImGui::BeginGroup();
  ImGui::Dummy(ImVec2(0.0f, frame.units(1.0f)));
  const std::string often = notice.times > 1 ? " (" + std::to_string(notice.times) + " times)" : "";
  text(wrapped_at_blanks(name_of(notice.kind) + notice.text + often,
                         end - frame.units(8.0f) - ImGui::GetCursorPosX()));
  ImGui::Dummy(ImVec2(0.0f, frame.units(1.0f)));
  ImGui::EndGroup();
  const float low = ImGui::GetItemRectMax().y;
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + bar, low),
                                            style::packed(colour_of(notice.kind)), frame.units(2.0f));
  ImGui::SameLine(end);
  if (icon_button("dismiss", Icon::cross, ImVec2(side, side))) frame.wish(DismissNotice{i});
  frame.mark("notice/" + std::to_string(i));
  tooltip(frame, tooltip_of(info_of(Command::close)));
  ImGui::PopID();
}

// What was found in a mesh of one's own: there until it is put away, or the run is gone through.
struct FoundLine {
  std::shared_ptr<const knit::Input> input;
  std::string words;
  bool away = false;
};

bool shows_found(const PanelFrame& frame) {
  const Session& session = frame.session;
  if (!session.document || session.document->source.file.empty() || session.learning->lesson) return false;
  auto& found = frame.own<FoundLine>();
  if (found.input != session.document->timeline.input_pointer())
    found = {session.document->timeline.input_pointer(), shape_words(session.document->timeline.input()),
             false};
  return !found.away && session.document->timeline.position() == 0;
}

void draw_found(PanelFrame& frame) {
  auto& found = frame.own<FoundLine>();
  const float side = ImGui::GetFrameHeight();
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side;
  ImGui::PushTextWrapPos(end - frame.units(8.0f));
  const std::string knitted = knitted_words(frame.session);
  text(found.words + (knitted.empty() ? "" : " " + knitted));
  ImGui::PopTextWrapPos();
  frame.mark("found");
  ImGui::SameLine(end);
  if (icon_button("found away", Icon::cross, ImVec2(side, side))) found.away = true;
  frame.mark("found/away");
  tooltip(frame, "Puts this line away.");
}

bool shows_note(const PanelFrame& frame) {
  return frame.session.document && !frame.session.document->place_note.empty() &&
         !frame.session.view->presenting;
}

// What is at the place that one went to, or why another is shown: whole, with a cross of its own. It goes when one goes on.
void draw_note(PanelFrame& frame) {
  const float side = ImGui::GetFrameHeight();
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side;
  ImGui::AlignTextToFramePadding();
  text(wrapped_at_blanks(frame.session.document->place_note,
                         end - frame.units(8.0f) - ImGui::GetCursorPosX()));
  frame.mark("place-note");
  ImGui::SameLine(end);
  if (icon_button("note away", Icon::cross, ImVec2(side, side))) frame.wish(PutNoteAway{});
  frame.mark("note/away");
  tooltip(frame, tooltip_of(info_of(Command::close)));
}

// The newest on top; when there are many, they scroll.
void draw_notices(PanelFrame& frame) {
  const bool found = shows_found(frame);
  const bool note = shows_note(frame);
  const bool notices = !frame.session.outbox->notices.empty();
  if (!notices && !found && !note) return;
  const Box& view = frame.layout.view;
  const float margin = std::min(frame.units(10.0f), 0.1f * view.width);
  const float width = view.width - 2.0f * margin;
  ImGui::SetNextWindowPos(ImVec2(view.x + margin, view.y + margin));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, 0.5f * view.height));
  push_raised_look(frame);
  ImGui::Begin("Notices", nullptr, floating);
  pop_raised_look();
  if (note) draw_note(frame);
  if (note && (found || notices)) ImGui::Separator();
  if (found) {
    draw_found(frame);
    draw_repair_buttons(frame, "found/");
  }
  if (found && notices) ImGui::Separator();
  for (std::size_t i = frame.session.outbox->notices.size(); i-- > 0;) {
    draw_notice(frame, i);
    if (i > 0) ImGui::Separator();
  }
  if (frame.session.document && frame.session.document->before_repair) {
    ImGui::Separator();
    if (ImGui::Button("Undo the repairs")) frame.wish(UndoRepair{});
    frame.mark("repair/undo");
    tooltip(frame, "Back to what was open before.");
  }
  ImGui::End();
}

void draw_picking(PanelFrame& frame) {
  if (frame.session.view->gaze.picking == Picking::nothing) return;
  const Box& view = frame.layout.view;
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, view.bottom() - frame.units(40.0f)),
                          ImGuiCond_Always, ImVec2(0.5f, 1.0f));
  push_raised_look(frame);
  ImGui::Begin("Picking", nullptr, floating);
  pop_raised_look();
  const bool start = frame.session.view->gaze.picking == Picking::start;
  ImGui::AlignTextToFramePadding();
  text(start ? "Click the start vertex in the view (t = 0)." : "Click the end vertex in the view (t = 1).");
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) frame.wish(SetPicking{Picking::nothing});
  frame.mark("picking/cancel");
  tooltip(frame, tooltip_of(info_of(Command::close)));
  ImGui::End();
}

constexpr double worth_a_word_s = 0.25;  // only what a person would notice waiting for

void begin_waiting(const PanelFrame& frame) {
  const Box& view = frame.layout.view;
  const float down = frame.session.document ? 0.5f : 0.9f;  // below the card of what can be opened
  ImGui::SetNextWindowPos(ImVec2(view.x + 0.5f * view.width, view.y + down * view.height), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  push_raised_look(frame);
  ImGui::Begin("Waiting", nullptr, floating);
  pop_raised_look();
}

// "settling the stitches ... 40 %", with a bar.
void draw_share(const PanelFrame& frame, const std::string& words, double share) {
  const float width = frame.units(300.0f);
  text(cut_to_width(words, width - frame.units(60.0f)) + " ... " +
       std::to_string(static_cast<int>(100.0 * share)) + " %");
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, style::vector(theme().accent));
  ImGui::ProgressBar(static_cast<float>(share), ImVec2(width, frame.units(6.0f)), "");
  ImGui::PopStyleColor();
}

void draw_opening(PanelFrame& frame) {
  const Opening& opening = *frame.session.jobs->opening;
  if (opening.seconds < worth_a_word_s) return;
  begin_waiting(frame);
  draw_share(frame, words_of(opening), opening.progress->share());
  faint_text(std::to_string(static_cast<int>(opening.seconds)) + " s so far");
  if (ImGui::Button("Cancel")) frame.wish(CancelWork{});
  frame.mark("waiting/cancel");
  tooltip(frame, "It is not opened; what is open stays.");
  ImGui::End();
}

void draw_waiting(PanelFrame& frame) {
  if (frame.session.jobs->opening) return draw_opening(frame);
  const auto& step = frame.session.jobs->run.long_step;
  if (!step || step->seconds < worth_a_word_s) return;
  begin_waiting(frame);
  const knit::Timeline& timeline = *frame.timeline();
  const std::string words = capitalised(knit::work_ahead(timeline.furthest()));
  if (const double share = step->work.share(); share > 0.0) {
    draw_share(frame, words, share);
  } else {
    text(words + "...");  // it does not say
  }
  const std::string triangles = with_commas(timeline.input().mesh.triangles.size());
  faint_text(triangles + " triangles, " + std::to_string(static_cast<int>(step->seconds)) + " s so far");
  if (ImGui::Button("Cancel")) frame.wish(CancelWork{});
  frame.mark("waiting/cancel");
  tooltip(frame, "Back to how it was before this change.");
  ImGui::End();
}

}  // namespace

void draw_view_overlays(PanelFrame& frame) {
  if (frame.session.view->checking) return draw_notices(frame);
  draw_welcome(frame);
  draw_first_start(frame);
  draw_stop_card(frame);
  draw_picking(frame);
  if (!frame.session.view->presenting) draw_positions(frame);
  draw_waiting(frame);
  draw_rescue(frame);
  draw_repair_offer(frame);
  draw_notices(frame);
}

}  // namespace app
