#include "app/panels/kit/number_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/base/text.h"
#include "knit/base/number_text.h"

namespace app {

namespace {

constexpr float units_a_percent = 4.0f;  // "every few": that far the pointer goes for 1 %
constexpr float click_reach = 3.0f;      // a click may tremble by so much
constexpr double slower = 0.1;           // with Shift
constexpr int patience = 12;             // frames that a field may wait for the keyboard

void begin_order(NumberFields& fields) {
  if (fields.frame == ImGui::GetFrameCount()) return;
  fields.frame = ImGui::GetFrameCount();
  fields.order_before = std::move(fields.order);
  fields.order.clear();
  // One that is not drawn any more keeps no keys back.
  if (fields.open != 0 && ++fields.waited > patience) fields.open = 0;
}

void open_field(NumberFields& fields, ImGuiID id) {
  fields.open = id;
  fields.fresh = true;
  fields.active = false;
  fields.waited = 0;
  fields.trouble = {};
}

// The field after this one in its window, or the one before; from the last to the first.
ImGuiID neighbour(const NumberFields& fields, ImGuiID id, bool back) {
  std::vector<ImGuiID> window;
  const auto self = std::find_if(fields.order_before.begin(), fields.order_before.end(),
                                 [&](const NumberFields::Place& place) { return place.field == id; });
  if (self == fields.order_before.end()) return 0;
  for (const NumberFields::Place& place : fields.order_before) {
    if (place.window == self->window) window.push_back(place.field);
  }
  const auto at = static_cast<std::size_t>(std::find(window.begin(), window.end(), id) - window.begin());
  return window[(at + (back ? window.size() - 1 : 1)) % window.size()];
}

// To a number that a person would have typed: steps of a thousandth of the range, or four digits of the value.
double rounded_drag(const NumberShape& shape, double exact) {
  if (shape.pace == DragPace::whole) return std::round(exact);
  const double scale = shape.pace == DragPace::ratio ? std::abs(exact) : shape.high - shape.low;
  if (!(scale > 0.0)) return exact;
  const double digits = 3.0 - std::floor(std::log10(scale));
  // Dividing by a whole power of ten gives the nearest double to the short text.
  const double power = std::pow(10.0, std::abs(digits));
  return digits >= 0.0 ? std::round(exact * power) / power : std::round(exact / power) * power;
}

void move_drag(const PanelFrame& frame, NumberFields& fields, const NumberShape& shape, float pixels) {
  double percent = static_cast<double>(pixels / frame.units(units_a_percent));
  if (key_mods().shift) percent *= slower;
  fields.exact = shape.pace == DragPace::ratio ? fields.exact * std::pow(1.01, percent)
                                               : fields.exact + 0.01 * percent * (shape.high - shape.low);
  fields.exact = std::clamp(fields.exact, shape.low, shape.high);
}

void paint_field(const PanelFrame& frame, const NumberShape& shape, bool troubled) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const ImGuiStyle& look = ImGui::GetStyle();
  const ImGuiCol ground = ImGui::IsItemActive()    ? ImGuiCol_FrameBgActive
                          : ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered
                                                   : ImGuiCol_FrameBg;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ImGui::GetColorU32(ground), look.FrameRounding);
  if (troubled)
    list.AddRect(low, high, style::packed(theme().problem), look.FrameRounding, 0, frame.units(1.5f));
  else if (look.FrameBorderSize > 0.0f)
    list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border), look.FrameRounding, 0, look.FrameBorderSize);
  if (shape.behind) shape.behind();
  const std::string words = cut_to_width(shape.shown, high.x - low.x - 2.0f * frame.units(3.0f));
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  list.AddText(ImVec2(std::floor(0.5f * (low.x + high.x - size.x) + 0.5f),
                      std::floor(0.5f * (low.y + high.y - size.y) + 0.5f)),
               ImGui::GetColorU32(ImGuiCol_Text), words.c_str());
}

NumberChange drag_field(PanelFrame& frame, const char* name, ImGuiID id, const NumberShape& shape,
                        float width) {
  NumberFields& fields = frame.own<NumberFields>();
  NumberChange change;
  ImGui::InvisibleButton(name, ImVec2(std::max(1.0f, width), ImGui::GetFrameHeight()));
  const float x = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated()) {
    fields.held = id;
    fields.dragging = false;
    fields.start_x = fields.last_x = x;
    fields.exact = std::clamp(shape.value, shape.low, std::max(shape.low, shape.high));
  }
  if (ImGui::IsItemActive() && fields.held == id && shape.pace != DragPace::none) {
    fields.dragging = fields.dragging || std::abs(x - fields.start_x) > frame.units(click_reach);
    if (fields.dragging && x != fields.last_x) {
      move_drag(frame, fields, shape, x - fields.last_x);
      fields.last_x = x;
      const double value = std::clamp(rounded_drag(shape, fields.exact), shape.low, shape.high);
      if (value != shape.value) change.dragged = value;
      fields.trouble = {};
    }
  }
  if (ImGui::IsItemDeactivated() && fields.held == id) {
    if (fields.dragging)
      change.let_go = true;
    else if (ImGui::IsItemHovered())
      open_field(fields, id);
    fields.held = 0;
    fields.dragging = false;
  }
  if (ImGui::IsItemHovered() || fields.held == id)
    ImGui::SetMouseCursor(shape.pace == DragPace::none ? ImGuiMouseCursor_TextInput
                                                       : ImGuiMouseCursor_ResizeEW);
  paint_field(frame, shape, fields.trouble.field == id && id != 0);
  return change;
}

bool clicked_elsewhere() {
  bool clicked = false;
  for (int button = 0; button < 3; ++button) clicked = clicked || ImGui::IsMouseClicked(button);
  return clicked && !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

NumberChange typed_field(NumberFields& fields, const char* name, ImGuiID id, const NumberShape& shape,
                         float width) {
  NumberChange change;
  if (fields.fresh) {
    fields.text.set(shape.full);
    fields.began_with = shape.full;
    fields.fresh = false;
  }
  if (!fields.active) ImGui::SetKeyboardFocusHere();
  ImGui::PushID(name);
  ImGui::SetNextItemWidth(width);
  // The callback does nothing; who has one for Tab keeps it from Dear ImGui's own going round.
  ImGui::InputText("##typed", fields.text.bytes.data(), fields.text.bytes.size(),
                   ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackCompletion,
                   [](ImGuiInputTextCallbackData*) { return 0; });
  ImGui::PopID();
  const bool active = ImGui::IsItemActive();
  fields.active = fields.active || active;
  fields.waited = active ? 0 : fields.waited;
  const bool escaped = key_pressed(Key::Escape);
  const bool tab = active && key_pressed(Key::Tab);
  const bool left = ImGui::IsItemDeactivated() || (fields.active && (!active || clicked_elsewhere()));
  if (!tab && !left) return change;
  fields.open = 0;
  if (!escaped && fields.text.text() != fields.began_with) change.typed = fields.text.text();
  if (tab) open_field(fields, neighbour(fields, id, key_mods().shift));
  return change;
}

std::optional<double> read_number(std::string_view words) {
  while (!words.empty() && words.front() == ' ') words.remove_prefix(1);
  while (!words.empty() && words.back() == ' ') words.remove_suffix(1);
  double value = 0.0;
  const auto [end, error] = knit::number_from(words.data(), words.data() + words.size(), value);
  if (error != std::errc() || end != words.data() + words.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

void refuse_typed(PanelFrame& frame, const char* name, const std::string& typed, const NumberShape& shape) {
  const bool whole = shape.pace == DragPace::whole;
  frame.own<NumberFields>().trouble = {
      ImGui::GetID(name), "\"" + typed + "\" is not a " + (whole ? "whole " : "") + "number from " +
                              shown_number(shape.low) + " to " + shown_number(shape.high) + "."};
}

}  // namespace

NumberChange number_field(PanelFrame& frame, const char* name, const NumberShape& shape, float width) {
  NumberFields& fields = frame.own<NumberFields>();
  begin_order(fields);
  const ImGuiID id = ImGui::GetID(name);
  fields.order.push_back({id, ImGui::GetWindowDrawList()});
  if (fields.open == id) return typed_field(fields, name, id, shape, width);
  return drag_field(frame, name, id, shape, width);
}

bool edit_number(PanelFrame& frame, const char* name, double& value, const NumberShape& shape, float width) {
  const NumberChange change = number_field(frame, name, shape, width);
  double wished = change.dragged.value_or(value);
  if (change.typed) {
    const double typed = read_number(*change.typed).value_or(std::nan(""));
    const bool whole = shape.pace != DragPace::whole || typed == std::round(typed);
    if (whole && typed >= shape.low && typed <= shape.high) {
      wished = typed;
    } else {
      refuse_typed(frame, name, *change.typed, shape);
    }
  }
  const auto& trouble = frame.own<NumberFields>().trouble;
  if (trouble.field == ImGui::GetID(name)) tooltip(frame, trouble.words);
  if (wished == value) return false;
  value = wished;
  return true;
}

bool edit_number(PanelFrame& frame, const char* name, int& value, int low, int high, const std::string& after,
                 float width) {
  const std::string full = std::to_string(value);
  double wished = value;
  const NumberShape shape{full + after,   full, wished, static_cast<double>(low), static_cast<double>(high),
                          DragPace::whole};
  if (!edit_number(frame, name, wished, shape, width)) return false;
  value = static_cast<int>(wished);
  return true;
}

bool number_field_open(PanelMemory& memory) { return memory.own<NumberFields>().open != 0; }

bool number_dragged(const PanelFrame& frame) { return frame.own<NumberFields>().dragging; }

std::string shown_number(double value) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.5g", value);
  std::string words(buffer.data(), static_cast<std::size_t>(length));
  // Not "1e+05": whole numbers below a million are read more easily.
  const bool whole = std::abs(value) >= 99999.5 && std::abs(value) < 1e6;
  return whole ? fixed_text(value, 0) : words;
}

std::string exact_words(const std::string& shown, const std::string& full) {
  return shown == full || full.empty() ? "" : "\nExactly " + full + ".";
}

}  // namespace app
