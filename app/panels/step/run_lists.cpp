// What was unusual in all of the run, and what is selected.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/explain/why_words.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/stop_ways.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/offers/repair_buttons.h"
#include "app/panels/step/step_parts.h"
#include "app/session/document.h"
#include "app/session/remarks.h"
#include "knit/insight/narrate.h"
#include "knit/insight/problems.h"
#include "knit/insight/why.h"
#include "knit/model/words.h"
#include "knit/run/machine.h"

namespace app {

namespace {

// The list's lines: why the run stopped, what is not of a step (what was repaired, findings about the mesh, remarks on the
// finished piece), then unusual steps, worst first. Only stop and steps are problems: knit/insight/problem_counts.h.
struct Problem {
  std::string words;
  std::optional<std::size_t> position;  // to see it
  std::string line;                     // in the list; empty: the words, cut
  std::optional<knit::Element>
      thing{};  // or this, whose making is shown; with a position: what is selected there
};

// On the whole run, once it is finished and measured; worked out anew when either changes.
struct RemarkCache {
  std::shared_ptr<const knit::Closeness> closeness;
  knit::Parameters parameters;
  std::vector<knit::Remark> remarks;
};

const std::vector<knit::Remark>& remarks_in(const PanelFrame& frame) {
  auto& cache = frame.own<RemarkCache>();
  const auto& closeness = frame.session.document->closeness;
  const knit::Parameters& parameters = frame.timeline()->parameters_of_stop();
  if (closeness == cache.closeness && parameters == cache.parameters) return cache.remarks;
  cache.closeness = closeness;
  cache.parameters = parameters;
  cache.remarks.clear();
  if (closeness && closeness->coverage) cache.remarks = remarks_of(*frame.timeline(), &*closeness->coverage);
  return cache.remarks;
}

Problem problem_of_remark(const knit::Remark& remark) {
  return {"Piece: " + remark.words, std::nullopt, "", thing_of(remark)};
}

// What tells hundreds of the most frequent kind apart, in the width of the list; else empty.
std::string short_line(const knit::Step& step) {
  if (const auto* left = knit::get_if<knit::TubeLeftOut>(step)) {
    if (left->together > 0) return "";
    return std::string(left->handle ? "Hole" : "Limb") + " left out at " + knit::vertex_text(left->vertex);
  }
  const auto* missed = knit::get_if<knit::BandMissed>(step);
  if (missed == nullptr) return "";
  return "Row " + std::to_string(step.place.row) + ", stitch " + std::to_string(missed->stitch) +
         ": nothing in the band, " + knit::short_number(missed->distance) + " taken";
}

Problem problem_at(const PanelFrame& frame, std::size_t i) {
  const knit::Timeline& timeline = *frame.timeline();
  if (const knit::Step* stop = timeline.stop()) {
    if (i == 0) return {knit::narrate(*stop, timeline.parameters_of_stop()), timeline.known(), ""};
    --i;
  }
  const auto& repaired = frame.session.document->repaired;
  if (i < repaired.size()) return {"Mesh: " + repaired[i].did, std::nullopt, ""};
  i -= repaired.size();
  const auto& findings = frame.session.document->findings;
  if (i < findings.size()) return {"Mesh: " + findings[i].sentence, std::nullopt, ""};
  i -= findings.size();
  const std::vector<knit::Remark>& remarks = remarks_in(frame);
  if (i < remarks.size()) return problem_of_remark(remarks[i]);
  const std::size_t step = frame.own<RunCache>().ranked()[i - remarks.size()].step;
  Problem problem{knit::narrate(timeline.step(step), timeline.parameters_of_step(step)), step + 1,
                  short_line(timeline.step(step))};
  problem.thing = knit::thing_of_problem(timeline.step(step));
  return problem;
}

// The first ones whole, on as many lines as they need; of hundreds of others a line each, which all have short words for.
constexpr std::size_t told_whole = 60;

std::string problem_text(const Problem& problem, std::size_t i, float width) {
  const std::string& words = problem.line.empty() ? problem.words : problem.line;
  return i < told_whole ? wrapped_at_blanks(words, width) : cut_to_width(words, width);
}

void draw_problem(PanelFrame& frame, std::size_t i) {
  const Problem problem = problem_at(frame, i);
  ImGui::PushID(static_cast<int>(i));
  const std::string line = problem_text(problem, i, ImGui::GetContentRegionAvail().x);
  const bool here = problem.position && frame.timeline()->position() == *problem.position;
  const ImVec2 size(0.0f, ImGui::CalcTextSize(line.c_str()).y);
  if (ImGui::Selectable("##problem", here, 0, size)) {
    if (problem.position) frame.wish(SeekTo{*problem.position});
    if (problem.thing && problem.position) frame.wish(LookAt{*problem.thing});
    if (problem.thing && !problem.position) frame.wish(ShowWhy{*problem.thing});
  }
  frame.mark("problem/" + std::to_string(i));
  tooltip(frame, problem.position || problem.thing ? problem.words + "\n\nClick: go there." : problem.words);
  ImGui::SameLine(0.0f, 0.0f);
  ImGui::SetCursorPosX(ImGui::GetStyle().WindowPadding.x);
  text(line);
  ImGui::PopID();
}

// Over the list: repairs of what stands in it, and the way back.
void draw_repairs(PanelFrame& frame) {
  if (!frame.session.document) return;
  draw_repair_buttons(frame, "repair/");
  if (!frame.session.document->before_repair) return;
  if (ImGui::SmallButton("Undo the repairs")) frame.wish(UndoRepair{});
  frame.mark("repair/undo-here");
  tooltip(frame, "Back to what was open before.");
}

}  // namespace

std::size_t count_problems(const PanelFrame& frame) {
  if (frame.timeline() == nullptr) return 0;
  return frame.own<RunCache>().problem_counts(*frame.timeline()).total();
}

std::size_t count_remarks(const PanelFrame& frame) {
  if (frame.timeline() == nullptr) return 0;
  return frame.session.document->repaired.size() + frame.session.document->findings.size() +
         remarks_in(frame).size();
}

namespace {

// "3 problems: 2 stalls, 1 row resampled. 2 remarks on the finished piece."
std::string summary_words(const PanelFrame& frame) {
  const knit::ProblemCounts counts = frame.own<RunCache>().problem_counts(*frame.timeline());
  const std::size_t total = counts.total();
  std::string words = total == 0
                          ? "No problem" + std::string(frame.timeline()->complete() ? "." : " so far.")
                          : with_commas(total, "problem", "problems") + ": " + knit::words_of(counts) + ".";
  const std::size_t remarks = remarks_in(frame).size();
  const std::size_t of_mesh = count_remarks(frame) - remarks;
  if (remarks > 0) words += " " + with_commas(remarks, "remark", "remarks") + " on the finished piece.";
  if (of_mesh > 0) words += " " + with_commas(of_mesh, "remark", "remarks") + " on the mesh.";
  return words;
}

}  // namespace

void draw_problems(PanelFrame& frame) {
  ImGui::BeginChild("problem list", list_size(frame), true);
  if (frame.timeline() == nullptr) {
    ImGui::EndChild();
    return;
  }
  wrapped_text(summary_words(frame), theme().faint_text);
  frame.mark("problems/summary");
  // Why it stopped, then the ways on from there.
  const std::size_t count = count_problems(frame) + count_remarks(frame);
  const std::size_t first = frame.timeline()->stop() != nullptr ? 1 : 0;
  if (first > 0) draw_problem(frame, 0);
  draw_tried_ways(frame, "problems/");
  draw_repairs(frame);
  const std::size_t whole = std::min(count, told_whole);
  for (std::size_t i = first; i < whole; ++i) draw_problem(frame, i);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count - whole));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_problem(frame, whole + static_cast<std::size_t>(i));
  }
  ImGui::EndChild();
}

// What is selected, in words, with ways on from there: few lines, because the lists below need the room.

namespace {

// The buttons stand at the right end of the line.
void draw_buttons(PanelFrame& frame, const knit::Element& thing, float left) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 size(side, side);
  const float gap = frame.units(3.0f);
  ImGui::SameLine(left);
  if (ImGui::Button("Why##selected", ImVec2(0.0f, side))) frame.wish(ShowWhy{thing});
  frame.mark("selected/why");
  tooltip(frame, "To the step that made it, or decided on it");
  ImGui::SameLine(0.0f, gap);
  if (icon_button("selected back", Icon::back, size)) frame.wish(ToTouch{-1});
  frame.mark("selected/back");
  tooltip(frame, tooltip_of(info_of(Command::last_touch)));
  ImGui::SameLine(0.0f, gap);
  if (icon_button("selected forward", Icon::forward, size)) frame.wish(ToTouch{1});
  frame.mark("selected/forward");
  tooltip(frame, tooltip_of(info_of(Command::next_touch)));
  ImGui::SameLine(0.0f, gap);
  if (icon_button("selected close", Icon::cross, size)) frame.wish(Select{});
  frame.mark("selected/close");
  tooltip(frame, "Select nothing");
}

float width_of_buttons(const PanelFrame& frame) {
  const float word = ImGui::CalcTextSize("Why").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  return word + 3.0f * (ImGui::GetFrameHeight() + frame.units(3.0f));
}

}  // namespace

namespace {

void draw_sized(PanelFrame& frame, const knit::SizeRange& range) {
  const float side = ImGui::GetFrameHeight();
  const float left = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - side;
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().selected));
  text(cut_to_width(with_capital(knit::words_of(range)), left - ImGui::GetCursorPosX()));
  ImGui::PopStyleColor();
  frame.mark("selected");
  tooltip(frame, "Lit in the view, as far as they are made at this place of the run.");
  ImGui::SameLine(left);
  if (icon_button("selected close", Icon::cross, ImVec2(side, side))) frame.wish(Select{});
  frame.mark("selected/close");
  tooltip(frame, "Select nothing");
}

}  // namespace

void draw_selected(PanelFrame& frame) {
  if (!frame.session.document) return;
  if (const auto& range = frame.session.document->travel.sized) return draw_sized(frame, *range);
  if (!frame.session.document->travel.selected) return;
  const std::optional<knit::Element>& selected = frame.session.document->travel.selected;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(frame.units(5.0f), frame.units(2.0f)));
  const float left = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width_of_buttons(frame);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().selected));
  text(cut_to_width(capitalised(words_of(*selected)), left - ImGui::GetCursorPosX() - frame.units(6.0f)));
  ImGui::PopStyleColor();
  frame.mark("selected");
  draw_buttons(frame, *selected, left);
  ImGui::PopStyleVar();
  push_font(frame.fonts.small);
  const std::string words = why_words(*frame.timeline(), *selected);
  wrapped_text(words, theme().faint_text);
  pop_font();
  frame.mark("selected/words");
  tooltip(frame, words);
}

}  // namespace app
