// One parameter's control, drawn from its line in knit::parameter_table().
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "app/panels/kit/commands.h"
#include "app/panels/kit/frame.h"
#include "app/panels/kit/lesson_marks.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/kit/panel_buttons.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/term_text.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/parameters/kept_choices.h"
#include "app/panels/parameters/knob_curve.h"
#include "app/panels/parameters/knob_notes.h"
#include "app/panels/parameters/parameters.h"
#include "app/panels/parameters/rhythm_dial.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/base/number_text.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"
#include "knit/rows/frame.h"

namespace app {

// Changes `parameters` when a person did; what the table refuses is left out.
void draw_knob(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters);

namespace {

// Of names side by side, as a control shows them where they fit.
float width_side_by_side(const PanelFrame& frame, const knit::Choice& choice) {
  float words = 0.0f;
  for (const std::string_view name : choice.names)
    words += ImGui::CalcTextSize(name.data(), name.data() + name.size()).x + frame.units(8.0f);
  return words;
}

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

  // What a person typed, judged as a whole; what is refused leaves its sentence.
  void take_typed(const std::string& text) const {
    knit::Parameters changed = parameters;
    auto trouble = knit::set_value(info, changed, text);
    if (!trouble) trouble = knit::fault_of(changed, frame.timeline()->input());
    if (!trouble) parameters = changed;
    set_trouble(trouble.value_or(""));
  }
  void set_trouble(std::string words) const {
    auto& troubles = frame.own<KnobTroubles>();
    if (words.empty()) {
      troubles.erase(std::string(info.key));
    } else {
      troubles[std::string(info.key)] = {knit::value_text(info, parameters), std::move(words)};
    }
  }
  // A drag stays where all parameters are allowed together: it goes as far that way as halving finds.
  template <class TextOf>
  void take_dragged(double now, double wished, const TextOf& text_of) const {
    constexpr int halvings = 8;
    double reach = wished;
    for (int i = 0; i < halvings; ++i) {
      knit::Parameters changed = parameters;
      if (!knit::set_value(info, changed, text_of(reach)) &&
          !knit::fault_of(changed, frame.timeline()->input())) {
        parameters = changed;
        return set_trouble("");
      }
      reach = now + 0.5 * (reach - now);
    }
  }

  // "0.05 mesh units" where it fits; one is "1 mesh unit".
  [[nodiscard]] std::string fitted(const std::string& number, float wide) const {
    if (info.unit.empty()) return number;
    const std::string whole = with_unit(number, info.unit);
    const float room = wide - 2.0f * ImGui::GetStyle().FramePadding.x;
    return ImGui::CalcTextSize(whole.c_str()).x < room ? whole : number;
  }

  // The value that follows from others, as far as there is room.
  [[nodiscard]] static std::string automatic(const PanelFrame& frame, const std::string& number, float wide) {
    std::string words = "auto (" + number + ")";
    const float room = wide - 2.0f * frame.units(3.0f);
    return ImGui::CalcTextSize(words.c_str()).x <= room ? words : "auto " + number;
  }

  // Lengths are dragged in proportion to themselves: they have no end.
  void operator()(const knit::Number& number) const {
    const bool is_length = number.high >= knit::no_limit;
    const bool dial = is_rhythm_dial(info);
    const double value =
        dial ? rhythm_dial_in_force(frame) : knit::effective_value(number, parameters).value_or(0.0);
    const std::string words = shown_number(value);
    const double high = is_length ? frame.timeline()->input().bounds.diagonal() : number.high;
    const bool from_zero = number.low > 0.0 || number.zero == knit::Zero::allowed;
    const bool teaches = has_curve(info);
    const float gap = frame.units(3.0f);
    const float room = teaches ? width - ImGui::GetFrameHeight() - gap : width;
    const NumberShape shape{
        knit::is_auto(number, parameters) ? automatic(frame, words, room) : fitted(words, room),
        knit::value_text(info, parameters),
        value,
        from_zero ? number.low : high * 1e-7,
        high,
        is_length || dial ? DragPace::ratio : DragPace::linear,
        teaches ? [&] { draw_curve(frame, info); } : std::function<void()>()};
    const auto marked = teaches ? curve_marks(frame, info, room) : std::nullopt;
    const NumberChange change = number_field(frame, "##value", shape, room);
    if (marked) take_typed(knit::number_text(*marked));
    if (change.typed) take_typed(*change.typed);
    if (change.dragged) take_dragged(value, *change.dragged, [](double to) { return knit::number_text(to); });
    if (teaches) {
      ImGui::SameLine(0.0f, gap);
      draw_curve_button(frame, info);
    }
  }

  void operator()(const knit::Count& count) const {
    const int value = count.get(parameters);
    const bool automatic = count.zero_means_auto && value == 0;
    const NumberShape shape{automatic ? "auto" : fitted(std::to_string(value), width),
                            knit::value_text(info, parameters),
                            static_cast<double>(value),
                            static_cast<double>(count.low),
                            static_cast<double>(count.high),
                            DragPace::whole};
    const NumberChange change = number_field(frame, "##value", shape, width);
    if (change.typed) take_typed(*change.typed);
    if (change.dragged)
      take_dragged(value, *change.dragged, [](double to) { return std::to_string(std::lround(to)); });
  }

  void operator()(const knit::Choice& choice) const {
    const int chosen = choice.get(parameters);
    const int clicked = width_side_by_side(frame, choice) <= width
                            ? segmented("choice", choice.names, chosen, width)
                            : dropdown(choice.names, chosen);
    if (clicked >= 0) choice.set(parameters, clicked);
  }

  void operator()(const knit::AxisChoice& choice) const {
    constexpr std::array<std::string_view, 4> names{"x", "y", "z", "custom"};
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
    constexpr std::array<std::string_view, 2> names{"auto", "custom"};
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
    number_parts(std::array{gauge.stitches, gauge.rounds}, 0.1, 1000.0, DragPace::ratio);
  }

  void operator()(const knit::PickedVertex& /*picked*/) const;

  // For names too long to stand side by side; gives the newly chosen one, or -1.
  [[nodiscard]] int dropdown(std::span<const std::string_view> names, int chosen) const {
    int clicked = -1;
    ImGui::SetNextItemWidth(width);
    if (!begin_list(frame, "##choice", std::string(names[static_cast<std::size_t>(chosen)]))) return clicked;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool now = static_cast<int>(i) == chosen;
      if (ImGui::Selectable(std::string(names[i]).c_str(), now) && !now) clicked = static_cast<int>(i);
    }
    ImGui::EndCombo();
    return clicked;
  }

  void direction_field(const glm::dvec3& direction) const {
    number_parts(std::array{direction.x, direction.y, direction.z}, -1.0, 1.0, DragPace::linear);
  }

  // Several numbers that are one value, side by side.
  template <std::size_t count>
  void number_parts(const std::array<double, count>& parts, double low, double high, DragPace pace) const {
    const float gap = frame.units(3.0f);
    const float wide = std::floor((width - static_cast<float>(count - 1) * gap) / static_cast<float>(count));
    const auto with_part = [&](std::size_t changed, const std::string& text) {
      std::string words;
      for (std::size_t i = 0; i < count; ++i)
        words += (i > 0 ? "," : "") + (i == changed ? text : knit::number_text(parts[i]));
      return words;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) ImGui::SameLine(0.0f, gap);
      const NumberShape shape{shown_number(parts[i]), knit::number_text(parts[i]), parts[i], low, high, pace};
      const NumberChange change = number_field(frame, ("##part" + std::to_string(i)).c_str(), shape, wide);
      frame.mark("knob/" + std::string(info.key) + "/" + std::to_string(i));
      if (change.typed) take_typed(with_part(i, *change.typed));
      if (change.dragged)
        take_dragged(parts[i], *change.dragged,
                     [&](double to) { return with_part(i, knit::number_text(to)); });
    }
  }
};

// A number that is typed, "auto", or a click in the view.
void Control::operator()(const knit::PickedVertex& /*picked*/) const {
  const Picking kind = info.key == knit::keys::start ? Picking::start : Picking::end;
  const bool picking = frame.session.view->gaze.picking == kind;
  const std::string value = knit::value_text(info, parameters);
  const float button = frame.units(50.0f);
  const NumberShape shape{value, value, 0.0, 0.0, 0.0, DragPace::none};
  const NumberChange change = number_field(frame, "##value", shape, width - button - frame.units(3.0f));
  frame.mark("knob/" + std::string(info.key));
  if (change.typed) take_typed(*change.typed);
  ImGui::SameLine(0.0f, frame.units(3.0f));
  if (picking) ImGui::PushStyleColor(ImGuiCol_Button, style::vector(theme().pressed));
  if (ImGui::Button("Pick", ImVec2(button, 0.0f))) frame.wish(SetPicking{picking ? Picking::nothing : kind});
  if (picking) ImGui::PopStyleColor();
  frame.mark("pick/" + std::string(info.key));
  tooltip(frame, "Then click the vertex in the view.");
}

// All digits, where the field does not show them.
std::string exact_value_words(PanelFrame& frame, const knit::ParameterInfo& info) {
  const knit::Parameters& now = frame.timeline()->parameters();
  if (const auto* number = std::get_if<knit::Number>(&info.kind)) {
    const double value = is_rhythm_dial(info) ? rhythm_dial_in_force(frame)
                                              : knit::effective_value(*number, now).value_or(0.0);
    return exact_words(shown_number(value), knit::number_text(value));
  }
  const bool several = std::holds_alternative<knit::GaugeChoice>(info.kind) ||
                       std::holds_alternative<knit::DirectionChoice>(info.kind) ||
                       std::holds_alternative<knit::AxisChoice>(info.kind);
  const std::string text = knit::value_text(info, now);
  return several && text.size() > 12 ? exact_words("", text) : "";
}

// As the knob shows it: none of its numbers with more digits than a screen's.
std::string default_words(const PanelFrame& frame, const knit::ParameterInfo& info) {
  std::string words;
  const std::string whole = knit::value_text(info, frame.session.document->defaults);
  for (std::size_t at = 0; at < whole.size();) {
    double value = 0.0;
    const char* begin = whole.data() + at;
    const auto read = knit::number_from(begin, whole.data() + whole.size(), value);
    const auto length = static_cast<std::size_t>(read.ptr - begin);
    const bool is_number = read.ec == std::errc() && whole[at] >= '0' && whole[at] <= '9';
    const bool is_long =
        is_number && std::count_if(begin, read.ptr, [](char c) { return c >= '0' && c <= '9'; }) > 5;
    words += is_long ? shown_number(value) : whole.substr(at, is_number ? length : 1);
    at += is_number ? length : 1;
  }
  return words;
}

std::string help_text(PanelFrame& frame, const knit::ParameterInfo& info) {
  std::string help(info.help);
  help += "\n\nRange: " + knit::range_text(info);
  if (!info.unit.empty()) help += " (" + std::string(info.unit) + ")";
  help += ".\nDefault here: " + default_words(frame, info) + ".";
  const bool drags = std::holds_alternative<knit::Number>(info.kind) ||
                     std::holds_alternative<knit::Count>(info.kind) ||
                     std::holds_alternative<knit::GaugeChoice>(info.kind);
  if (drags) help += "\nDrag to change it (with Shift slowly), click to type.";
  if (const std::string curve = has_curve(info) ? curve_words(frame, info) : ""; !curve.empty())
    help += "\n\n" + curve;
  return help + exact_value_words(frame, info);
}

// Under the knob, as long as it has the value that it had then.
void draw_trouble(PanelFrame& frame, const knit::ParameterInfo& info, const knit::Parameters& parameters) {
  auto& troubles = frame.own<KnobTroubles>();
  const auto found = troubles.find(info.key);
  if (found == troubles.end()) return;
  if (found->second.value != knit::value_text(info, parameters)) {
    troubles.erase(found);
    return;
  }
  wrapped_text(found->second.words, theme().problem);
  frame.mark("knob-trouble/" + std::string(info.key));
  if (found->second.fresh) ImGui::SetScrollHereY(1.0f);  // it may stand below the panel's edge
  found->second.fresh = false;
}

void draw_reset(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters, float x) {
  const std::string initial = knit::value_text(info, frame.session.document->defaults);
  if (initial == knit::value_text(info, parameters)) return;
  const float side = ImGui::GetFrameHeight();
  ImGui::SameLine(x);
  if (icon_button("reset", Icon::reset, ImVec2(side, side))) knit::set_value(info, parameters, initial);
  frame.mark("reset/" + std::string(info.key));
  tooltip(frame, "Back to " + default_words(frame, info) + ".");
}

// What there is from here to the right, as if the scrollbar stood there always: rows must not move under the pointer when
// a remark makes it come or go.
float steady_room() {
  // Whether the bar is there is not asked: the answer changes a frame before or after the room does.
  return ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - ImGui::GetStyle().ScrollbarSize;
}

// What a control needs at least so that nothing in it is cut; none: all that it usually has.
std::optional<float> least_width(const PanelFrame& frame, const knit::ParameterInfo& info, float usual) {
  if (std::holds_alternative<knit::Number>(info.kind) || std::holds_alternative<knit::Count>(info.kind))
    return frame.units(72.0f);  // a number of five digits
  const auto* choice = std::get_if<knit::Choice>(&info.kind);
  if (choice == nullptr) return std::nullopt;
  if (const float side_by_side = width_side_by_side(frame, *choice); side_by_side <= usual)
    return std::ceil(side_by_side);
  float longest = 0.0f;  // of a list, beside its arrow
  for (const std::string_view name : choice->names)
    longest = std::max(longest, ImGui::CalcTextSize(name.data(), name.data() + name.size()).x);
  return std::ceil(longest + ImGui::GetFrameHeight() + 2.0f * ImGui::GetStyle().FramePadding.x);
}

// Of the control at the right: a little more than half. It gives way to a long name beside it as far as it can.
float control_width(const PanelFrame& frame, const knit::ParameterInfo& info, const std::string& label,
                    float whole) {
  const float usual = frame.units(126.0f) + 0.5f * std::max(0.0f, whole - frame.units(240.0f));
  const float beside = std::floor(whole - ImGui::CalcTextSize(label.c_str()).x - frame.units(6.0f));
  const auto least = least_width(frame, info, usual);
  return least && beside >= *least ? std::min(usual, beside) : usual;
}

}  // namespace

void draw_knob(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters) {
  ImGui::PushID(info.key.data(), info.key.data() + info.key.size());
  const float left = ImGui::GetCursorPosX();
  const float whole = steady_room() - ImGui::GetFrameHeight() - frame.units(4.0f);
  const std::string label(info.label);
  const float control = control_width(frame, info, label, whole);
  // A long name has the line for itself; its tip leaves the field below free.
  const bool alone = ImGui::CalcTextSize(label.c_str()).x >= whole - control - frame.units(4.0f);
  ImGui::AlignTextToFramePadding();
  faint_text(label);
  explained_tooltip(frame, help_text(frame, info), label, alone ? ImGui::GetFrameHeightWithSpacing() : 0.0f);
  frame.mark("knob-label/" + std::string(info.key));
  if (!alone) ImGui::SameLine();
  ImGui::SetCursorPosX(left + std::max(0.0f, whole - control));
  ImGui::BeginGroup();
  std::visit(Control{frame, info, parameters, std::min(control, whole)}, info.kind);
  ImGui::EndGroup();
  if (frame.session.document->changes.open && ImGui::IsItemDeactivated()) frame.wish(Settle{});
  bring_lit_into_view(frame, "knob/" + std::string(info.key));
  if (!std::holds_alternative<knit::PickedVertex>(info.kind)) {
    frame.mark("knob/" + std::string(info.key));
    // The button and the marks of the curve have tips of their own; what is wrong, said below, is not to be covered.
    const bool troubled = frame.own<KnobTroubles>().count(info.key) > 0;
    if (!curve_is_pointed_at(frame, info) && !number_field_open(frame.memory) && !troubled)
      tooltip(frame, help_text(frame, info));
  }
  draw_reset(frame, info, parameters, left + whole + frame.units(4.0f));
  draw_trouble(frame, info, parameters);
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
  constexpr std::array<std::string_view, 2> names{"from the start", "from this step"};
  const char* const words = "Apply changes";
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
          "From this step: what is past stays as it is; the rest is run again.");
}

// What a change asks for. What is read before the run begins can only count from the start.
void wish_change(PanelFrame& frame, const knit::ParameterInfo& info, const knit::Parameters& changed,
                 bool held) {
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
    bool held = number_dragged(frame);  // a click is over, and so is what was typed
    if (is_short_rows_knob(info)) draw_kept_choices(frame, parameters);
    if (is_rhythm_dial(info)) held = draw_rhythm_dial(frame, info, parameters) || held;
    if (parameters == timeline.parameters()) continue;
    note_change_of(frame, info, timeline.parameters(), parameters);
    wish_change(frame, info, parameters, held);
  }
}

void draw_edits(PanelFrame& frame) {
  const knit::Timeline& timeline = *frame.timeline();
  if (timeline.edits().empty()) return;
  heading(frame, "Changes on the way");
  for (std::size_t i = 0; i < timeline.edits().size(); ++i) draw_edit(frame, timeline, i);
}

// Below the knobs, so that what is said of one moves none of the others.
void draw_foot(PanelFrame& frame, const knit::Timeline& timeline) {
  knit::Parameters parameters = timeline.parameters();
  draw_knob_notes(frame, parameters);
  if (parameters != timeline.parameters())
    wish_change(frame, *knit::find_parameter(knit::keys::gauge), parameters, false);
}

}  // namespace

void draw_parameters(PanelFrame& frame) {
  // Only the knobs scroll. The foot's height is known a frame late: a bar of the panel's own would come for that frame and
  // move the knobs from under the pointer.
  begin_panel("Parameters", frame.layout.parameters,
              ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_cross(frame, Panel::parameters);
  if (const knit::Timeline* timeline = frame.timeline()) {
    draw_mode(frame);
    const float foot = height_of_knob_notes(frame);
    ImGui::BeginChild("knobs", ImVec2(0.0f, -foot));
    draw_knobs(frame, *timeline);
    draw_edits(frame);
    ImGui::EndChild();
    draw_foot(frame, *timeline);
  } else {
    push_font(frame.fonts.strong);
    faint_text("Parameters");
    pop_font();
    wrapped_text("They appear here once a mesh is open.", theme().faint_text);
  }
  ImGui::End();
}

}  // namespace app
