// The pattern's shape: the mouse turns, moves and zooms it as it does the mesh; a click on a round goes to its line.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/checker/checked_shape.h"
#include "app/panels/checker/checker_parts.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/view/view.h"

namespace app {

namespace {

struct ShapeDrag {
  bool pans = false, moved = false;
};

constexpr double turn_per_unit = 0.008;
constexpr float still = 4.0f;               // plain units that a click may move
constexpr std::size_t most_pointed = 3000;  // rounds: of more only a click asks which one it is

glm::dvec2 pointer_on(const Box& view) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  return {2.0 * static_cast<double>((at.x - view.x) / view.width) - 1.0,
          1.0 - 2.0 * static_cast<double>((at.y - view.y) / view.height)};
}

void turn_shape(PanelFrame& frame) {
  ShapeDrag& drag = frame.own<ShapeDrag>();
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) drag = {!io.MouseDown[ImGuiMouseButton_Left] || key_mods().shift, false};
  if (ImGui::IsItemHovered()) {
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) frame.wish(FrameAll{});
    if (io.MouseWheel != 0.0f)
      frame.wish(Zoom{std::pow(0.88, static_cast<double>(io.MouseWheel)), pointer_on(frame.layout.view)});
  }
  if (!ImGui::IsItemActive()) return;
  for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle}) {
    const ImVec2 from = io.MouseClickedPos[button];
    drag.moved =
        drag.moved || (io.MouseDown[button] &&
                       std::hypot(io.MousePos.x - from.x, io.MousePos.y - from.y) > frame.units(still));
  }
  const ImVec2 by = io.MouseDelta;
  if (!drag.moved || (by.x == 0.0f && by.y == 0.0f)) return;
  const Box& view = frame.layout.view;
  if (drag.pans) {
    frame.wish(
        Pan{{2.0 * static_cast<double>(by.x / view.width), -2.0 * static_cast<double>(by.y / view.height)}});
  } else {
    const double turn = turn_per_unit / static_cast<double>(frame.layout.scale);
    frame.wish(Orbit{-static_cast<double>(by.x) * turn, static_cast<double>(by.y) * turn});
  }
}

std::size_t rounds_of(const knit::CheckedSize& size) {
  std::size_t rounds = 0;
  for (const knit::CheckedPiece& piece : size.pieces) rounds += piece.rounds.size();
  return rounds;
}

std::string words_of_line(const knit::CheckedSize& size, std::size_t line) {
  std::string words = "Line " + std::to_string(line);
  const knit::CheckedLine* told = line_numbered(size, line);
  if (told != nullptr && told->stitches)
    words += ": " + with_commas(static_cast<std::size_t>(*told->stitches), "stitch", "stitches");
  return words + ". A click goes there.";
}

void point_at_rounds(PanelFrame& frame, const Checker& checker) {
  const knit::CheckedSize* size = checker.shown();
  if (size == nullptr) return;
  const bool clicked = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                       !frame.own<ShapeDrag>().moved;
  const bool pointed = ImGui::IsItemHovered() && !ImGui::IsItemActive() && rounds_of(*size) <= most_pointed;
  if (!clicked && !pointed) return;
  const auto line =
      line_under(shape_of(*size, checker.gauge), frame.scene.view, pointer_on(frame.layout.view));
  if (!line) return;
  if (clicked) frame.wish(GoToCheckedLine{*line, 0, 0});
  if (pointed) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltip_about(frame, around_pointer(frame), words_of_line(*size, *line));
  }
}

// The size that it would have.
void draw_gauge(PanelFrame& frame, const Checker& checker) {
  const Box& view = frame.layout.view;
  ImGui::SetCursorScreenPos(ImVec2(view.x + frame.units(12.0f), view.y + frame.units(8.0f)));
  ImGui::AlignTextToFramePadding();
  faint_text("At");
  const auto field = [&](const char* name, double value) {
    ImGui::SameLine();
    const std::string shown = shown_number(value);
    edit_number(frame, name, value, {shown, shown, value, least_gauge, most_gauge, DragPace::ratio},
                frame.units(58.0f));
    frame.mark(name);
    return value;
  };
  CheckedGauge gauge = checker.gauge;
  gauge.stitches = field("checker/stitches", gauge.stitches);
  ImGui::SameLine();
  faint_text("x");
  gauge.rows = field("checker/rows", gauge.rows);
  ImGui::SameLine();
  faint_text("on 10 cm");
  if (gauge != checker.gauge) frame.wish(SetCheckedGauge{gauge.stitches, gauge.rows});
}

std::string size_words(const Checker& checker) {
  if (checker.shown() == nullptr) return "";
  const CheckedShape shape = shape_of(*checker.shown(), checker.gauge);
  if (shape.pieces.empty()) return "";
  double around = 0.0;
  double high = 0.0;
  for (const PlacedPiece& piece : shape.pieces) {
    around = std::max(around, piece.half * (piece.flat ? 2.0 : 2.0 * std::numbers::pi));
    high = std::max(high, piece.rounds.back().height);
  }
  const auto cm = [](double length) { return shown_number(std::round(10.0 * length) / 10.0) + " cm"; };
  return cm(around) + (shape.pieces.front().flat ? " wide, " : " around, ") + cm(high) + " high";
}

}  // namespace

void draw_checker_view(PanelFrame& frame) {
  const Checker& checker = *frame.session.view->checker;
  const Box& view = frame.layout.view;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  frame.memory.controls.erase("legend-box");  // there is none
  begin_panel(
      "Shape", view,
      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  draw_gauge(frame, checker);
  ImGui::SetCursorScreenPos(ImVec2(view.x, view.y));
  ImGui::InvisibleButton("shape", ImVec2(view.width, view.height),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  frame.mark("checker/view");
  turn_shape(frame);
  point_at_rounds(frame, checker);
  draw_captions(frame);
  const std::string words = size_words(checker);
  const float line = ImGui::GetTextLineHeight();
  if (!words.empty())
    boxed_text(frame, ImVec2(view.x + frame.units(12.0f), view.bottom() - line - frame.units(10.0f)), words,
               theme().faint_text);
  ImGui::End();
}

}  // namespace app
