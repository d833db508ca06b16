// The centre: empty but for what lies over the scene. Drags, wheel and clicks become wishes about the camera.
#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <string>

#include "app/compare/beside_words.h"
#include "app/describe/pick.h"
#include "app/explain/why_words.h"
#include "app/facing/step_place.h"
#include "app/lessons/lesson.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/view_help.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/view/overlays.h"
#include "app/panels/view/view.h"
#include "app/session/document.h"
#include "app/session/pins.h"
#include "app/session/program.h"
#include "app/session/row_table.h"
#include "app/session/view.h"
#include "knit/model/words.h"

namespace app {

namespace {

// A drag that began in the view.
struct ViewDrag {
  enum class Kind : std::uint8_t { orbit, pan } kind = Kind::orbit;
  bool moved = false;  // far enough to be no click
};

constexpr double radians_per_unit = 0.008;
constexpr float hover_reach = 12.0f;  // plain units from the pointer to a stitch that it means
constexpr float click_reach = 4.0f;   // plain units that a click may move
constexpr float point_reach = 8.0f;   // plain units from a click to a stitch that it means
constexpr float edge_reach = 5.0f;    // and to an edge

// In [-1, 1] from the view's centre, up positive.
glm::dvec2 pointer_in(const Box& view) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  return {2.0 * static_cast<double>((at.x - view.x) / view.width) - 1.0,
          1.0 - 2.0 * static_cast<double>((at.y - view.y) / view.height)};
}

void move_camera(PanelFrame& frame, const ImVec2& by) {
  const Box& view = frame.layout.view;
  if (frame.own<ViewDrag>().kind == ViewDrag::Kind::pan) {
    const glm::dvec2 move(2.0 * static_cast<double>(by.x / view.width),
                          -2.0 * static_cast<double>(by.y / view.height));
    frame.wish(Pan{move});
    return;
  }
  const double turn = radians_per_unit / static_cast<double>(frame.layout.scale);
  frame.wish(Orbit{-static_cast<double>(by.x) * turn, static_cast<double>(by.y) * turn});
}

void handle_drag(PanelFrame& frame) {
  ViewDrag& drag = frame.own<ViewDrag>();
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) {
    const bool turns = io.MouseDown[ImGuiMouseButton_Left] && !key_mods().shift;
    drag = {turns ? ViewDrag::Kind::orbit : ViewDrag::Kind::pan, false};
  }
  if (!ImGui::IsItemActive()) return;
  ImVec2 by = io.MouseDelta;
  if (!drag.moved) {
    for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle}) {
      if (!io.MouseDown[button]) continue;
      by = ImVec2(io.MousePos.x - io.MouseClickedPos[button].x, io.MousePos.y - io.MouseClickedPos[button].y);
      drag.moved = std::hypot(by.x, by.y) > frame.units(click_reach);
    }
    if (!drag.moved) return;
  }
  if (by.x != 0.0f || by.y != 0.0f) move_camera(frame, by);
}

// A lesson's question is answered in the view.
std::optional<AnswerKind> wanted_click(const Session& session) {
  const Question* question = open_question(session);
  return question != nullptr && is_clicked(question->kind) ? std::optional(question->kind) : std::nullopt;
}

std::optional<knit::Element> thing_clicked(const PanelFrame& frame) {
  const Box& view = frame.layout.view;
  const glm::dvec2 place = pointer_in(view);
  const auto wanted = wanted_click(frame.session);
  if (wanted == AnswerKind::stitch) {
    const double reach = 2.0 * static_cast<double>(frame.units(hover_reach) / view.height);
    const auto stitch = pick_stitch(frame.session, place, reach);
    return stitch ? std::optional<knit::Element>(knit::StitchElement{stitch->row, stitch->stitch})
                  : std::nullopt;
  }
  if (key_mods().ctrl || wanted == AnswerKind::vertex) {
    const auto vertex = pick_vertex(frame.session, place);
    return vertex ? std::optional<knit::Element>(knit::VertexElement{*vertex}) : std::nullopt;
  }
  const auto reach = [&](float units) { return 2.0 * static_cast<double>(frame.units(units) / view.height); };
  return pick_thing(frame.session, place, {reach(point_reach), reach(edge_reach)});
}

// A click leads to why a thing is there; it waits until it can be no double click any more, which frames.
void handle_plain_click(PanelFrame& frame) {
  PendingClick& click = frame.own<PendingClick>();
  const ImGuiIO& io = ImGui::GetIO();
  if (click.waits && ImGui::GetTime() >= click.due) {
    if (wanted_click(frame.session)) {
      frame.wish(AnswerLesson{click.thing ? text_of(*click.thing) : ""});
    } else if (click.thing) {
      frame.wish(ShowWhy{*click.thing});
    } else if (frame.session.document &&
               (frame.session.document->travel.selected || frame.session.document->travel.sized)) {
      frame.wish(Select{});
    }
    click = {};
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    click = {};
    frame.own<ViewDrag>().moved = true;  // its release is no click
  }
  const bool released = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  if (!released || frame.own<ViewDrag>().moved || frame.session.view->gaze.picking != Picking::nothing)
    return;
  click = PendingClick{true, thing_clicked(frame),
                       ImGui::GetTime() + static_cast<double>(io.MouseDoubleClickTime)};
}

void handle_clicks(PanelFrame& frame) {
  handle_plain_click(frame);
  const bool picking = frame.session.view->gaze.picking != Picking::nothing;
  if (picking && ImGui::IsItemDeactivated() && !frame.own<ViewDrag>().moved &&
      ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    if (const auto vertex = pick_vertex(frame.session, pointer_in(frame.layout.view))) {
      frame.wish(PickVertex{*vertex});
    }
  }
  if (!ImGui::IsItemHovered()) return;
  if (!picking && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) frame.wish(FrameAll{});
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel != 0.0f) {
    frame.wish(Zoom{std::pow(0.88, static_cast<double>(wheel)), pointer_in(frame.layout.view)});
  }
}

// Where the run stood when something else set the camera: it has its way until the run goes on.
struct ViewFollowing {
  std::optional<Camera> camera;  // as it was left
  std::size_t held_at = 0;
};

void follow_step(PanelFrame& frame) {
  constexpr double at_once_s = 100.0;
  constexpr double longest_frame_s = 0.05;  // the first one after a rest
  const Camera& camera = frame.session.view->gaze.camera;
  ViewFollowing& following = frame.own<ViewFollowing>();
  const std::size_t position = frame.timeline()->position();
  const bool picking = frame.session.view->gaze.picking != Picking::nothing;
  if (following.camera != camera || ImGui::IsItemActive() || picking) following = {camera, position};
  // Played fast it goes round and round; one would only grow dizzy.
  constexpr double fastest_followed = 40.0;
  const Playback& playback = frame.session.view->playback;
  const bool too_fast = playback.playing && playback.steps_per_second > fastest_followed;
  if (!frame.session.view->following || too_fast || following.held_at == position) return;
  const auto place = step_place(frame.session);
  if (!place) return;
  const bool motion = frame.session.program->preferences.motion;
  const auto passed = static_cast<double>(ImGui::GetIO().DeltaTime);
  const double seconds = motion ? std::min(passed, longest_frame_s) : at_once_s;
  following.camera = turned_to(camera, *place, seconds);
  if (following.camera != camera) frame.wish(TurnToStep{seconds});
}

void draw_hint(const PanelFrame& frame) {
  const Box& view = frame.layout.view;
  const float height = ImGui::GetTextLineHeight();
  const float room = view.width - frame.units(170.0f);
  const ImVec2 at(view.x + frame.units(12.0f), view.bottom() - height - frame.units(10.0f));
  boxed_text(frame, at, cut_to_width(hint_words(room), room), theme().faint_text);
}

// "Row 20: 65 stitches" of the run in one half, both at the same row; while it is in progress "12 stitches so far".
std::string place_words(const PanelFrame& frame, bool of_pinned) {
  const knit::Timeline& timeline = *frame.timeline();
  const std::int32_t row = timeline.position() > 0 ? timeline.place().row : 0;
  if (row < 1) return "";
  const std::string head = "Row " + std::to_string(row) + ": ";
  const auto counted = [](std::int64_t count) {
    return knit::stitch_count_text(static_cast<std::int32_t>(count));
  };
  if (of_pinned) {
    const Pin& pin = *frame.session.document->pinned;
    const auto count = pinned_stitches(frame.session, row);
    if (!count) return pin.known ? "No row " + std::to_string(row) : "";
    return head + counted(*count);
  }
  if (const knit::Row* made = timeline.state().fabric.find_row(row))
    return head + counted(knit::size_of(*made));
  return head + counted(static_cast<std::int64_t>(stitches_so_far(timeline.state()))) + " so far";
}

// Over one half of the view: which run it is of and what is different there, and below it its row.
struct HalfWords {
  std::string values, row, mark;
};
void draw_half_words(const PanelFrame& frame, const Box& half, const HalfWords& words, Colour colour) {
  const float margin = frame.units(12.0f);
  const float width = half.width - 2.0f * margin;
  push_font(frame.fonts.strong);
  const ImVec2 at(half.x + margin, half.y + frame.units(8.0f));
  boxed_text(frame, at, cut_to_width(words.values, width), colour);
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 below(at.x, at.y + line + frame.units(4.0f));
  const std::string row = cut_to_width(words.row, width);
  if (!row.empty()) {
    boxed_text(frame, below, row, colour);
    frame.memory.controls.insert_or_assign("half/" + words.mark + "/row",
                                           Box{below.x, below.y, ImGui::CalcTextSize(row.c_str()).x, line});
  }
  pop_font();
}

}  // namespace

// The other half turns and zooms as the view does; what is clicked at is only in the view.
void draw_other_view(PanelFrame& frame) {
  const Box& half = frame.layout.other_view;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  begin_panel(
      "Other view", half,
      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  ImGui::InvisibleButton("other view", ImVec2(half.width, half.height),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  frame.mark("other-view");
  handle_drag(frame);
  if (ImGui::IsItemHovered()) {
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) frame.wish(FrameAll{});
    const float wheel = ImGui::GetIO().MouseWheel;
    if (wheel != 0.0f) frame.wish(Zoom{std::pow(0.88, static_cast<double>(wheel)), pointer_in(half)});
    if (!frame.session.view->presenting) {
      const ImVec2 at(half.x + frame.units(12.0f),
                      half.bottom() - ImGui::GetTextLineHeight() - frame.units(10.0f));
      boxed_text(frame, at,
                 cut_to_width("Stitches are picked in the right half", half.width - frame.units(24.0f)),
                 theme().faint_text);
    }
  }
  ImGui::GetBackgroundDrawList()->AddRectFilled(
      ImVec2(half.right(), half.y), ImVec2(frame.layout.view.x, half.bottom()), style::packed(theme().panel));
  draw_other_captions(frame);
  draw_half_words(frame, half,
                  {"Pinned: " + beside_words(frame.session).pinned, place_words(frame, true), "pinned"},
                  theme().pinned);
  ImGui::End();
}

void draw_view(PanelFrame& frame) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  begin_panel(
      "View", frame.layout.view,
      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  const Box& view = frame.layout.view;
  ImGui::InvisibleButton("view", ImVec2(view.width, view.height),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  frame.mark("view");
  const bool hovered = ImGui::IsItemHovered();
  if (frame.timeline() != nullptr) {
    handle_drag(frame);
    handle_clicks(frame);
    follow_step(frame);
    std::optional<StitchAt> under;
    if (hovered && !ImGui::IsItemActive()) {
      const double reach = static_cast<double>(frame.units(hover_reach) / view.height);
      under = pick_stitch(frame.session, pointer_in(view), 2.0 * reach);
    }
    if (under != frame.session.view->gaze.hovered_stitch) frame.wish(HoverStitch{under});
    const bool aims = frame.session.view->gaze.picking != Picking::nothing || wanted_click(frame.session);
    if (hovered && aims) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!frame.session.view->presenting) draw_view_legend(frame);
    draw_captions(frame);
    if (frame.layout.other_view.width > 0.0f)
      draw_half_words(frame, view,
                      {"Now: " + beside_words(frame.session).here, place_words(frame, false), "now"},
                      theme().text);
    if (hovered && !frame.session.view->presenting) draw_hint(frame);
  }
  ImGui::End();
}

}  // namespace app
