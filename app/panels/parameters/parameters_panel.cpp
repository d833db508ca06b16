// One parameter's control, drawn from its line in knit::parameter_table().
#include <algorithm>
#include <array>
#include <string>

#include "app/panels/kit/commands.h"
#include "app/panels/kit/frame.h"
#include "app/panels/kit/lesson_marks.h"
#include "app/panels/kit/panel_buttons.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/term_text.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/parameters/parameters.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"
#include "knit/rows/frame.h"

namespace app {

// Changes `parameters` when a person did; what the table refuses is left out.
void draw_knob(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters);

namespace {

// One overload a kind of parameter: a control of the given width that sets values through the table's own
// check.
struct Control {
  PanelFrame& frame;
  const knit::ParameterInfo& info;
  knit::Parameters& parameters;
  float width;

  void set(const std::string& text) const {
    knit::Parameters changed = parameters;
    if (!knit::set_value(info, changed, text)) parameters = changed;
  }

  // "%.4g mesh units" where it fits; one is "1 mesh unit".
  [[nodiscard]] std::string format(const char* number, const std::string& shown) const {
    if (info.unit.empty()) return number;
    const std::string whole = with_unit(shown, info.unit);
    const float room = width - 2.0f * ImGui::GetStyle().FramePadding.x;
    const bool fits = ImGui::CalcTextSize(whole.c_str()).x < room;
    return fits ? number + whole.substr(shown.size()) : number;
  }

  // Lengths are dragged in proportion to the mesh, others over decades.
  void operator()(const knit::Number& number) const {
    const double length = frame.timeline()->input().bounds.diagonal();
    const bool is_length = number.high >= knit::no_limit;
    const bool automatic = knit::is_auto(number, parameters);
    double value = knit::effective_value(number, parameters);
    const double high = is_length ? length : number.high;
    const bool zero_allowed = number.zero == knit::Zero::allowed;
    const double low = number.low > 0.0 ? number.low : zero_allowed ? 0.0 : high * 1e-7;
    const std::string digits = is_length || number.high >= 1000.0 ? "%.4g" : "%.2g";
    const std::string shape = automatic ? "auto (" + knit::short_number(value) + ")"
                                        : format(digits.c_str(), knit::short_number(value));
    const float speed = static_cast<float>(is_length ? 0.0004 * length : 0.002 * high);
    const ImGuiSliderFlags flags =
        is_length || zero_allowed ? ImGuiSliderFlags_None : ImGuiSliderFlags_Logarithmic;
    ImGui::SetNextItemWidth(width);
    if (ImGui::DragScalar("##value", ImGuiDataType_Double, &value, speed, &low, &high, shape.c_str(),
                          flags)) {
      set(knit::number_text(value));
    }
  }

  void operator()(const knit::Count& count) const {
    int value = count.get(parameters);
    const bool automatic = count.zero_means_auto && value == 0;
    const std::string shape = automatic ? "auto" : format("%d", std::to_string(value));
    ImGui::SetNextItemWidth(width);
    if (ImGui::DragInt("##value", &value, 0.1f, count.low, count.high, shape.c_str()))
      set(std::to_string(value));
  }

  void operator()(const knit::Choice& choice) const {
    const int chosen = choice.get(parameters);
    float words = 0.0f;
    for (const std::string_view name : choice.names)
      words += ImGui::CalcTextSize(name.data(), name.data() + name.size()).x + frame.units(8.0f);
    const int clicked =
        words <= width ? segmented("choice", choice.names, chosen, width) : dropdown(choice.names, chosen);
    if (clicked >= 0) choice.set(parameters, clicked);
  }

  void operator()(const knit::AxisChoice& choice) const {
    constexpr std::array<std::string_view, 4> names{"x", "y", "z", "other"};
    knit::Axis axis = choice.get(parameters);
    const int clicked = segmented("axis", names, static_cast<int>(axis.kind), width);
    if (clicked >= 0) {
      const knit::Axis before = axis;
      axis.kind = static_cast<knit::AxisKind>(clicked);
      // Begins where the axis was, so that the picture does not jump.
      if (axis.kind == knit::AxisKind::custom) axis.custom = before.direction();
      choice.set(parameters, axis);
    }
    if (axis.kind != knit::AxisKind::custom) return;
    direction_field(axis.custom);
  }

  void operator()(const knit::DirectionChoice& choice) const {
    constexpr std::array<std::string_view, 2> names{"auto", "other"};
    const auto direction = choice.get(parameters);
    const int clicked = segmented("direction", names, direction ? 1 : 0, width);
    if (clicked == 0) set("auto");
    if (clicked == 1 && !direction) {
      // Begins where rounds begin now, so that the picture does not jump.
      const knit::RowFrame now = knit::row_frame(parameters.timing.axis.direction(), std::nullopt);
      choice.set(parameters, now.right);
    }
    if (direction) direction_field(*direction);
  }

  void operator()(const knit::GaugeChoice& choice) const {
    const knit::Gauge gauge = choice.get(parameters);
    std::array<double, 2> parts{gauge.stitches, gauge.rounds};
    ImGui::SetNextItemWidth(width);
    if (ImGui::DragScalarN("##gauge", ImGuiDataType_Double, parts.data(), 2, 0.05f, nullptr, nullptr, "%.4g"))
      set(knit::number_text(parts[0]) + "," + knit::number_text(parts[1]));
  }

  void operator()(const knit::PickedVertex& /*picked*/) const;

  // For names too long to stand side by side; gives the newly chosen one, or -1.
  [[nodiscard]] int dropdown(std::span<const std::string_view> names, int chosen) const {
    int clicked = -1;
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo("##choice", std::string(names[static_cast<std::size_t>(chosen)]).c_str()))
      return clicked;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool now = static_cast<int>(i) == chosen;
      if (ImGui::Selectable(std::string(names[i]).c_str(), now) && !now) clicked = static_cast<int>(i);
    }
    ImGui::EndCombo();
    return clicked;
  }

  void direction_field(const glm::dvec3& direction) const {
    std::array<double, 3> parts{direction.x, direction.y, direction.z};
    ImGui::SetNextItemWidth(width);
    if (ImGui::DragScalarN("##direction", ImGuiDataType_Double, parts.data(), 3, 0.01f, nullptr, nullptr,
                           "%.2f")) {
      set(knit::number_text(parts[0]) + "," + knit::number_text(parts[1]) + "," +
          knit::number_text(parts[2]));
    }
  }
};

// A number that is typed, "auto", or a click in the view.
void Control::operator()(const knit::PickedVertex& /*picked*/) const {
  const Picking kind = info.key == knit::keys::start ? Picking::start : Picking::end;
  const bool picking = frame.session.view->gaze.picking == kind;
  VertexField& field = frame.own<VertexFields>()[std::string(info.key)];
  const std::string value = knit::value_text(info, parameters);
  if (field.shown != value) {
    field.shown = value;
    field.text.set(value);
    field.trouble.clear();
  }
  const float button = frame.units(50.0f);
  ImGui::SetNextItemWidth(width - button - frame.units(3.0f));
  ImGui::InputText("##value", field.text.bytes.data(), field.text.bytes.size(),
                   ImGuiInputTextFlags_AutoSelectAll);
  frame.mark("knob/" + std::string(info.key));
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    knit::Parameters changed = parameters;
    auto trouble = knit::set_value(info, changed, field.text.text());
    if (!trouble) trouble = knit::fault_of(changed, frame.timeline()->input());
    field.trouble = trouble.value_or("");
    if (!trouble) parameters = changed;
  }
  ImGui::SameLine(0.0f, frame.units(3.0f));
  if (picking) ImGui::PushStyleColor(ImGuiCol_Button, style::vector(theme().pressed));
  if (ImGui::Button("Pick", ImVec2(button, 0.0f))) frame.wish(SetPicking{picking ? Picking::nothing : kind});
  if (picking) ImGui::PopStyleColor();
  frame.mark("pick/" + std::string(info.key));
  tooltip(frame, "Then click the vertex in the view.");
}

std::string help_text(const PanelFrame& frame, const knit::ParameterInfo& info) {
  std::string help(info.help);
  help += "\n\nRange: " + knit::range_text(info);
  if (!info.unit.empty()) help += " (" + std::string(info.unit) + ")";
  help += ".\nDefault here: " + knit::value_text(info, frame.session.document->defaults) + ".";
  const bool drags =
      std::holds_alternative<knit::Number>(info.kind) || std::holds_alternative<knit::Count>(info.kind);
  if (drags) help += "\nDrag to change it, Ctrl+click to type.";
  return help;
}

void draw_reset(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters, float x) {
  const std::string initial = knit::value_text(info, frame.session.document->defaults);
  if (initial == knit::value_text(info, parameters)) return;
  const float side = ImGui::GetFrameHeight();
  ImGui::SameLine(x);
  if (icon_button("reset", Icon::reset, ImVec2(side, side))) knit::set_value(info, parameters, initial);
  frame.mark("reset/" + std::string(info.key));
  tooltip(frame, "Back to " + initial + ".");
}

}  // namespace

void draw_knob(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters) {
  ImGui::PushID(info.key.data(), info.key.data() + info.key.size());
  const float left = ImGui::GetCursorPosX();
  const float whole = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - frame.units(4.0f);
  const float control = frame.units(126.0f) + 0.5f * std::max(0.0f, whole - frame.units(240.0f));
  const std::string label(info.label);
  ImGui::AlignTextToFramePadding();
  faint_text(label);
  explained_tooltip(frame, help_text(frame, info), label);
  frame.mark("knob-label/" + std::string(info.key));
  // A long name has the line for itself.
  if (ImGui::CalcTextSize(label.c_str()).x < whole - control - frame.units(4.0f)) ImGui::SameLine();
  ImGui::SetCursorPosX(left + std::max(0.0f, whole - control));
  ImGui::BeginGroup();
  std::visit(Control{frame, info, parameters, std::min(control, whole)}, info.kind);
  ImGui::EndGroup();
  if (frame.session.document->changes.open && ImGui::IsItemDeactivated()) frame.wish(Settle{});
  bring_lit_into_view(frame, "knob/" + std::string(info.key));
  if (!std::holds_alternative<knit::PickedVertex>(info.kind)) {
    frame.mark("knob/" + std::string(info.key));
    tooltip(frame, help_text(frame, info));
  }
  draw_reset(frame, info, parameters, left + whole + frame.units(4.0f));
  const auto field = frame.own<VertexFields>().find(info.key);
  if (field != frame.own<VertexFields>().end() && !field->second.trouble.empty()) {
    wrapped_text(field->second.trouble, theme().problem);
  }
  ImGui::PopID();
}

// The left panel: every knob of the pipeline in its order, and the edits made on the way.

namespace {

struct Tool {
  Command command;
  Icon icon;
  const char* id;
  bool usable;
};

constexpr std::size_t tool_count = 4;

// With the gap before them, and the cross after them.
float width_of_tools(const PanelFrame& frame) {
  return static_cast<float>(tool_count) * (ImGui::GetFrameHeight() + frame.units(3.0f)) + frame.units(4.0f) +
         room_for_cross(frame);
}

// Undo, redo, copy and paste at the right end of a line.
void draw_tools(PanelFrame& frame) {
  const Changes none;
  const Changes& changes = frame.session.document ? frame.session.document->changes : none;
  const std::array<Tool, tool_count> tools{Tool{Command::undo, Icon::undo, "undo", !changes.undo.empty()},
                                           Tool{Command::redo, Icon::redo, "redo", !changes.redo.empty()},
                                           Tool{Command::copy, Icon::copy, "copy", true},
                                           Tool{Command::paste, Icon::paste, "paste", true}};
  const float side = ImGui::GetFrameHeight();
  const float gap = frame.units(3.0f);
  const auto count = static_cast<float>(tools.size());
  ImGui::SameLine();
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  float x = right - count * side - (count - 1.0f) * gap - room_for_cross(frame);
  for (const Tool& tool : tools) {
    const CommandInfo& info = info_of(tool.command);
    ImGui::SameLine(x);
    ImGui::BeginDisabled(!tool.usable);
    const bool clicked = icon_button(tool.id, tool.icon, ImVec2(side, side));
    ImGui::EndDisabled();
    frame.mark(tool.id);
    tooltip(frame, tooltip_of(info));
    if (clicked) {
      if (auto wish = info.make(frame.session)) frame.wish(std::move(*wish));
    }
    x += side + gap;
  }
}

void draw_mode(PanelFrame& frame) {
  constexpr std::array<std::string_view, 2> names{"from the start", "from here"};
  const char* const words = "A change counts";
  ImGui::AlignTextToFramePadding();
  if (ImGui::CalcTextSize(words).x + width_of_tools(frame) <= ImGui::GetContentRegionAvail().x) {
    faint_text(words);
  } else {
    ImGui::Dummy(ImVec2(0.0f, ImGui::GetFrameHeight()));  // in a narrow panel the buttons below say enough
  }
  draw_tools(frame);
  ImGui::BeginGroup();
  const int clicked =
      segmented("mode", names, frame.own<ChangeMode>().from_here ? 1 : 0, ImGui::GetContentRegionAvail().x);
  ImGui::EndGroup();
  if (clicked >= 0) frame.own<ChangeMode>().from_here = clicked == 1;
  frame.mark("mode");
  tooltip(frame,
          "From the start: the run becomes what it would have been with this value, and shows the same place "
          "in it.\n\n"
          "From here: what is past stays as it is; the rest is run anew.");
}

// What a change asks for. What is read before the run begins can only count from the start.
void wish_change(PanelFrame& frame, const knit::ParameterInfo& info, const knit::Parameters& changed) {
  const bool held = ImGui::IsAnyItemActive();  // a drag goes on; a click is over
  const bool from_start_only = !knit::can_change_at(info, knit::Place{});
  if (frame.own<ChangeMode>().from_here && !from_start_only) {
    frame.wish(EditFromHere{changed, held});
  } else {
    frame.wish(Tune{changed, held});
  }
}

std::string changes_text(const knit::Parameters& from, const knit::Parameters& to) {
  std::string words;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const std::string before = knit::value_text(info, from);
    const std::string after = knit::value_text(info, to);
    if (before == after) continue;
    if (!words.empty()) words += "\n";
    words.append(info.label).append(" ").append(before).append(" \xE2\x86\x92 ").append(after);
  }
  return words.empty() ? "nothing changes" : words;
}

void draw_edit(PanelFrame& frame, const knit::Timeline& timeline, std::size_t i) {
  const knit::Edit& edit = timeline.edits()[i];
  const knit::Parameters& before = i > 0 ? timeline.edits()[i - 1].parameters : timeline.base_parameters();
  const float side = ImGui::GetFrameHeight();
  ImGui::PushID(static_cast<int>(i));
  const float left = ImGui::GetCursorPosX();
  const float width = ImGui::GetContentRegionAvail().x - side - frame.units(6.0f);
  const std::string place = "From " + words_of(edit.at);
  if (ImGui::Selectable(cut_to_width(place, width).c_str(), false, 0, ImVec2(width, 0.0f))) {
    const auto& positions = frame.own<RunCache>().edits();
    if (i < positions.size()) frame.wish(SeekTo{positions[i]});
  }
  frame.mark("edit/" + std::to_string(i));
  tooltip(frame, place + ". Click: go there.");
  ImGui::SameLine(left + width + frame.units(6.0f));
  if (icon_button("remove", Icon::cross, ImVec2(side, side))) frame.wish(RemoveEdit{i});
  frame.mark("edit/" + std::to_string(i) + "/remove");
  tooltip(frame, "Take this change back.");
  wrapped_text(changes_text(before, edit.parameters), theme().faint_text);
  ImGui::PopID();
}

void draw_knobs(PanelFrame& frame, const knit::Timeline& timeline) {
  std::string_view group;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    // What nothing reads now would only be in the way.
    if (!knit::is_read(info, timeline.parameters())) continue;
    if (info.group != group) {
      group = info.group;
      heading(frame, std::string(group).c_str());
    }
    // Each knob starts from what is in force, so that one frame wishes at most what one hand did.
    knit::Parameters parameters = timeline.parameters();
    draw_knob(frame, info, parameters);
    if (parameters == timeline.parameters()) continue;
    wish_change(frame, info, parameters);
  }
}

void draw_edits(PanelFrame& frame) {
  const knit::Timeline& timeline = *frame.timeline();
  if (timeline.edits().empty()) return;
  heading(frame, "Changes on the way");
  for (std::size_t i = 0; i < timeline.edits().size(); ++i) draw_edit(frame, timeline, i);
}

}  // namespace

void draw_parameters(PanelFrame& frame) {
  begin_panel("Parameters", frame.layout.parameters);
  draw_cross(frame, Panel::parameters);
  if (const knit::Timeline* timeline = frame.timeline()) {
    draw_mode(frame);
    draw_knobs(frame, *timeline);
    draw_edits(frame);
  } else {
    push_font(frame.fonts.strong);
    faint_text("Parameters");
    pop_font();
    wrapped_text("They appear here once a mesh is open.", theme().faint_text);
  }
  ImGui::End();
}

}  // namespace app
