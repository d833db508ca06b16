#include "app/panels/parameters/knob_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/compare/sweep_work.h"
#include "app/panels/kit/number_field.h"
#include "app/session/document.h"

namespace app {

namespace {

constexpr int curve_values = 96;
constexpr float mark_width = 9.0f;  // plain units: wide enough to be hit

// The sweep of this knob alone that still holds, or null.
const SweepWork* sweep_of(PanelFrame& frame, const knit::ParameterInfo& info) {
  const auto& sweep = frame.session.document->sweep;
  if (!sweep || sweep->plan.second || sweep->plan.axis.key != info.key) return nullptr;
  if (swept_otherwise(*sweep->work, *frame.timeline())) return nullptr;
  frame.own<SweepCache>().refresh(sweep->work);
  return sweep->work.get();
}

float share_of(const SweepWork& work, double value) {
  const double from = work.first_values().front();
  const double to = work.first_values().back();
  return to > from ? static_cast<float>(std::clamp((value - from) / (to - from), 0.0, 1.0)) : 0.0f;
}

struct CurveMark {
  double value = 0.0;
  SweepFigure figure = SweepFigure::problems;
};

// The stretch's end that is not an end of the sweep.
std::optional<double> end_of(const QuietStretch& quiet) {
  if (quiet.from_first && quiet.to_last) return std::nullopt;
  return quiet.from_first ? quiet.to : quiet.from;
}

// Where all problems end, and stalls alone where that is elsewhere.
std::vector<CurveMark> marks_of(PanelFrame& frame, const knit::ParameterInfo& info) {
  std::vector<CurveMark> marks;
  const SweepWork* work = sweep_of(frame, info);
  if (work == nullptr) return marks;
  const SweepCache& cache = frame.own<SweepCache>();
  for (const SweepFigure figure : {SweepFigure::problems, SweepFigure::stalls}) {
    const auto quiet = quiet_stretch(*work, cache, figure);
    const auto value = quiet ? end_of(*quiet) : std::nullopt;
    if (!value || (!marks.empty() && marks.front().value == *value)) continue;
    marks.push_back({*value, figure});
  }
  return marks;
}

std::string name_of(const CurveMark& mark, const knit::ParameterInfo& info) {
  const std::string name = "curve-mark/" + std::string(info.key);
  return mark.figure == SweepFigure::problems ? name : name + "/" + std::string(key_of(mark.figure));
}

struct CurveBox {
  ImVec2 low, high;
  [[nodiscard]] ImVec2 at(float across, float up) const {
    return {low.x + across * (high.x - low.x), high.y - up * (high.y - low.y)};
  }
};

void draw_figure_line(PanelFrame& frame, const SweepWork& work, SweepFigure figure, const CurveBox& box,
                      ImU32 colour) {
  const SweepCache& cache = frame.own<SweepCache>();
  const double low = counts_problems(figure) ? 0.0 : cache.lowest(figure);
  const double high = cache.highest(figure);
  const double range = high > low ? high - low : 1.0;
  std::vector<ImVec2> line;
  const auto end_line = [&] {
    if (line.size() > 1)
      ImGui::GetWindowDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()), colour,
                                              ImDrawFlags_None, frame.units(1.2f));
    line.clear();
  };
  for (std::size_t i = 0; i < work.first_values().size(); ++i) {
    const auto& value = cache.of(figure)[i];
    if (!value) {
      end_line();
      continue;
    }
    const auto up = static_cast<float>(0.06 + 0.88 * (*value - low) / range);
    line.push_back(box.at(share_of(work, work.first_values()[i]), up));
  }
  end_line();
}

bool curve_part_is_pointed_at(const PanelFrame& frame, const std::string& control) {
  const auto found = frame.memory.controls.find(control);
  if (found == frame.memory.controls.end()) return false;
  const Box& box = found->second;
  return ImGui::IsMouseHoveringRect(ImVec2(box.x, box.y), ImVec2(box.right(), box.bottom()));
}

}  // namespace

bool has_curve(const knit::ParameterInfo& info) {
  return info.key == knit::keys::epsilon || info.tie == knit::Tie::mesh_view;
}

void draw_curve_button(PanelFrame& frame, const knit::ParameterInfo& info) {
  const SweepWork* work = sweep_of(frame, info);
  const bool running = work != nullptr && work->running();
  const float side = ImGui::GetFrameHeight();
  const bool clicked = ImGui::Button("##curve", ImVec2(side, side));
  frame.mark("curve/" + std::string(info.key));
  const CurveBox box{ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
  const std::array points{box.at(0.2f, 0.7f), box.at(0.42f, 0.3f), box.at(0.6f, 0.45f), box.at(0.8f, 0.25f)};
  const Colour colour = running ? theme().accent : work != nullptr ? theme().text : theme().faint_text;
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                          style::packed(colour), ImDrawFlags_None, frame.units(1.5f));
  tooltip(frame,
          running ? "Stop trying values."
                  : "Tries many values in the background and draws behind this knob where the problems are. "
                    "The side Sweep shows more of it.");
  if (!clicked) return;
  if (running) return frame.wish(CancelSweep{});
  frame.wish(StartSweep{{usual_axis(info, frame.timeline()->parameters(), curve_values), std::nullopt}});
}

std::optional<double> curve_marks(PanelFrame& frame, const knit::ParameterInfo& info, float width) {
  std::optional<double> taken;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float wide = frame.units(mark_width);
  for (const CurveMark& mark : marks_of(frame, info)) {
    const float share = share_of(*sweep_of(frame, info), mark.value);
    const float left = std::clamp(at.x + share * width - 0.5f * wide, at.x, at.x + width - wide);
    const std::string name = name_of(mark, info);
    // First come, first hovered: the field around it leaves it the pointer.
    ImGui::SetCursorScreenPos(ImVec2(left, at.y));
    const bool clicked = ImGui::InvisibleButton(("##" + name).c_str(), ImVec2(wide, ImGui::GetFrameHeight()));
    frame.mark(name);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltip(frame, curve_words(frame, info) + " Click: take " + shown_number(mark.value) + ".");
    if (clicked) taken = mark.value;
  }
  ImGui::SetCursorScreenPos(at);
  return taken;
}

bool curve_is_pointed_at(const PanelFrame& frame, const knit::ParameterInfo& info) {
  const std::string key(info.key);
  return curve_part_is_pointed_at(frame, "curve/" + key) ||
         curve_part_is_pointed_at(frame, "curve-mark/" + key) ||
         curve_part_is_pointed_at(frame, "curve-mark/" + key + "/stalls");
}

void draw_curve(PanelFrame& frame, const knit::ParameterInfo& info) {
  const SweepWork* work = sweep_of(frame, info);
  if (work == nullptr) return;
  const CurveBox box{ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
  draw_figure_line(frame, *work, SweepFigure::stitches, box, style::packed(theme().faint_text, 70));
  draw_figure_line(frame, *work, SweepFigure::course_cv, box, style::packed(theme().accent, 90));
  draw_figure_line(frame, *work, SweepFigure::problems, box, style::packed(theme().problem, 150));
  const float size = frame.units(4.0f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const CurveMark& mark : marks_of(frame, info)) {
    const Colour colour = mark.figure == SweepFigure::problems ? theme().anchor : theme().text;
    const ImVec2 foot = box.at(share_of(*work, mark.value), 0.0f);
    list.AddLine(ImVec2(foot.x, box.low.y), foot, style::packed(colour, 160), frame.units(1.0f));
    list.AddTriangleFilled(ImVec2(foot.x - size, foot.y), ImVec2(foot.x, foot.y - 1.3f * size),
                           ImVec2(foot.x + size, foot.y), style::packed(colour));
  }
}

std::string curve_words(PanelFrame& frame, const knit::ParameterInfo& info) {
  const SweepWork* work = sweep_of(frame, info);
  if (work == nullptr || work->done() < work->total()) return "";
  const SweepCache& cache = frame.own<SweepCache>();
  const auto quiet = quiet_stretch(*work, cache, SweepFigure::problems);
  std::string words = quiet
                          ? words_of(*quiet, SweepFigure::problems)
                          : "Some problem at every value from " + shown_number(work->first_values().front()) +
                                " to " + shown_number(work->first_values().back()) + ".";
  const auto no_stall = quiet_stretch(*work, cache, SweepFigure::stalls);
  if (no_stall && no_stall != quiet) words += " " + words_of(*no_stall, SweepFigure::stalls);
  return words;
}

}  // namespace app
