#include "app/panels/kit/widgets.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "app/explain/window_words.h"
#include "app/scene/contrast.h"

namespace app {

void TextBuffer::set(const std::string& text) {
  bytes.fill('\0');
  std::copy_n(text.begin(), std::min(text.size(), bytes.size() - 1), bytes.begin());
}

bool begin_list(PanelFrame& frame, const char* id, const std::string& shown) {
  if (!ImGui::BeginCombo(id, shown.c_str())) return false;
  keep_list(frame);
  return true;
}

void keep_list(PanelFrame& frame) {
  auto& list = frame.own<HangingList>();
  list.open = true;
  if (list.to_close || key_pressed(Key::Escape)) ImGui::CloseCurrentPopup();
}

void begin_panel(const char* name, const Box& box, ImGuiWindowFlags more) {
  ImGui::SetNextWindowPos(ImVec2(box.x, box.y));
  ImGui::SetNextWindowSize(ImVec2(box.width, box.height));
  ImGui::Begin(name, nullptr, fixed_panel | more);
}

void push_raised_look(const PanelFrame& frame) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, frame.units(8.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, frame.units(1.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_PopupBorderSize, frame.units(1.0f));
}

void pop_raised_look() { ImGui::PopStyleVar(3); }

void heading(const PanelFrame& frame, const char* words) {
  push_font(frame.fonts.strong);
  faint_text(words);
  pop_font();
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float y = 0.5f * (low.y + high.y);
  const float end = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::GetWindowDrawList()->AddLine(ImVec2(high.x + frame.units(8.0f), y), ImVec2(end, y),
                                      style::packed(theme().outline), frame.units(1.0f));
}

bool folding_heading(const PanelFrame& frame, const char* words, bool open) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  const bool clicked = ImGui::InvisibleButton(words, ImVec2(ImGui::GetContentRegionAvail().x, line));
  const bool lit = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = style::packed(lit ? theme().text : theme().faint_text);
  const ImVec2 middle(at.x + 0.3f * line, at.y + 0.52f * line);
  const float r = 0.2f * line;
  if (open) {
    list.AddTriangleFilled(ImVec2(middle.x - r, middle.y - 0.6f * r), ImVec2(middle.x, middle.y + 0.9f * r),
                           ImVec2(middle.x + r, middle.y - 0.6f * r), colour);
  } else {
    list.AddTriangleFilled(ImVec2(middle.x - 0.6f * r, middle.y - r),
                           ImVec2(middle.x - 0.6f * r, middle.y + r), ImVec2(middle.x + 0.9f * r, middle.y),
                           colour);
  }
  push_font(frame.fonts.strong);
  const float left = at.x + 0.75f * line;
  list.AddText(ImVec2(left, at.y), colour, words);
  const float high = left + ImGui::CalcTextSize(words).x + frame.units(8.0f);
  pop_font();
  const float y = at.y + 0.5f * line;
  list.AddLine(ImVec2(high, y), ImVec2(ImGui::GetItemRectMax().x, y), style::packed(theme().outline),
               frame.units(1.0f));
  return clicked;
}

int segmented(const char* id, std::span<const std::string_view> names, int chosen, float width) {
  const ImGuiStyle& look = ImGui::GetStyle();
  const float gap = 1.0f;
  float spare = 0.0f;
  if (width > 0.0f) {
    float needed = -gap;
    for (const std::string_view name : names) {
      needed += ImGui::CalcTextSize(name.data(), name.data() + name.size(), true).x + gap;
    }
    spare = std::max(0.0f, width - needed) / static_cast<float>(names.size());
  } else {
    spare = 2.0f * look.FramePadding.x;
  }
  ImGui::PushID(id);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, look.ItemSpacing.y));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, look.FramePadding.y));
  int clicked = -1;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const std::string name(names[static_cast<std::size_t>(i)]);
    const bool lit = i == chosen;
    if (i > 0) ImGui::SameLine();
    if (lit) {
      ImGui::PushStyleColor(ImGuiCol_Button, style::vector(theme().accent));
      ImGui::PushStyleColor(ImGuiCol_ButtonHovered, style::vector(theme().accent));
      ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().on_accent));
    }
    ImGui::PushID(i);
    const float wide = ImGui::CalcTextSize(name.c_str(), nullptr, true).x + spare;
    if (ImGui::Button(name.c_str(), ImVec2(wide, 0.0f)) && !lit) clicked = i;
    ImGui::PopID();
    if (lit) ImGui::PopStyleColor(3);
  }
  ImGui::PopStyleVar(2);
  ImGui::PopID();
  return clicked;
}

bool lit_button(const char* words, bool lit) {
  if (lit) {
    ImGui::PushStyleColor(ImGuiCol_Button, style::vector(theme().accent));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, style::vector(theme().accent));
    ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().on_accent));
  }
  const bool clicked = ImGui::Button(words);
  if (lit) ImGui::PopStyleColor(3);
  return clicked;
}

bool wants_tooltip() {
  return ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) &&
         !ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

Box tip_box(const Box& item, const Box& window, ImVec2 size, float gap) {
  const auto inside = [](float at, float extent, float low, float high) {
    return std::floor(std::max(low, std::min(at, high - extent)));
  };
  const float x = inside(item.x, size.x, window.x, window.right());
  const float y = inside(item.y, size.y, window.y, window.bottom());
  const Box below{x, std::ceil(item.bottom() + gap), size.x, size.y};
  if (below.bottom() <= window.bottom()) return below;
  const Box above{x, std::floor(item.y - gap - size.y), size.x, size.y};
  if (above.y >= window.y) return above;
  const Box right{std::ceil(item.right() + gap), y, size.x, size.y};
  if (right.right() <= window.right()) return right;
  const Box left{std::floor(item.x - gap - size.x), y, size.x, size.y};
  // Nowhere clear of it: where most of the tip can be read.
  return left.x >= window.x ? left : Box{x, y, size.x, size.y};
}

float tip_width(const PanelFrame& frame) { return frame.units(340.0f); }

Box around_pointer(const PanelFrame& frame) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  const float aside = frame.units(12.0f);
  return {at.x - aside, at.y - aside, 2.0f * aside, 2.0f * aside};
}

Box tipped_item(const PanelFrame& frame) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool tall = high.y - low.y > frame.units(120.0f);
  return tall ? around_pointer(frame) : Box{low.x, low.y, high.x - low.x, high.y - low.y};
}

void begin_tip(const PanelFrame& frame, const Box& item, ImVec2 content) {
  const ImVec2 edge = ImGui::GetStyle().WindowPadding;
  const ImVec2 size(std::ceil(content.x) + 2.0f * edge.x, std::ceil(content.y) + 2.0f * edge.y);
  const Box box = tip_box(item, frame.layout.window, size, frame.units(4.0f));
  ImGui::SetNextWindowPos(ImVec2(box.x, box.y));
  ImGui::BeginTooltip();
  frame.memory.controls.insert_or_assign("tip", box);
}

void tooltip_about(const PanelFrame& frame, const Box& item, std::string_view words) {
  const std::string lines = wrapped_at_blanks(words, tip_width(frame));
  begin_tip(frame, item, ImGui::CalcTextSize(lines.c_str()));
  text(lines);
  ImGui::EndTooltip();
}

bool may_break(std::string_view words, std::size_t at) {
  const auto is_sign = [&](std::size_t place) {
    return place < words.size() && words[place] == '=' && place > 0 && words[place - 1] == ' ' &&
           place + 1 < words.size() && words[place + 1] == ' ';
  };
  if (at >= words.size() || words[at] != ' ' || at == 0) return at < words.size() && words[at] == ' ';
  if (is_sign(at + 1) || is_sign(at - 1)) return false;
  constexpr std::array<std::string_view, 6> units{"%", "cm", "mm", "m", "g", "yd"};
  const std::string_view next = words.substr(at + 1, words.find_first_of(" \n.,;:)", at + 1) - at - 1);
  const bool after_digit = words[at - 1] >= '0' && words[at - 1] <= '9';
  return !after_digit || std::find(units.begin(), units.end(), next) == units.end();
}

std::string wrapped_at_blanks(std::string_view words, float width) {
  const std::string shown_here = in_window_words(words);
  const std::string_view shown = shown_here;
  const auto wide = [](std::string_view part) {
    return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
  };
  std::string lines;
  for (std::size_t begin = 0; begin <= shown.size();) {
    const std::size_t feed = std::min(shown.find('\n', begin), shown.size());
    float x = 0.0f;
    for (std::size_t at = begin; at < feed;) {
      // A word goes with the blanks before it, unless it begins a line.
      const std::size_t first = std::min(shown.find_first_not_of(' ', at), feed);
      std::size_t end = first;
      while (end < feed && !may_break(shown, end)) ++end;
      const float more = wide(shown.substr(at, end - at));
      const bool breaks = x > 0.0f && x + more > width;
      if (breaks) lines += '\n';
      lines.append(shown.substr(breaks ? first : at, end - (breaks ? first : at)));
      x = breaks ? wide(shown.substr(first, end - first)) : x + more;
      at = end;
    }
    if (feed < shown.size()) lines += '\n';
    begin = feed + 1;
  }
  return lines;
}

void scroll_to_line(std::size_t line) {
  const float height = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
  const float lines = ImGui::GetWindowHeight() / height - 1.0f;  // below the heads
  const float above = std::floor(0.5f * (lines - 1.0f));
  ImGui::SetScrollY(height * std::max(0.0f, static_cast<float>(line) - above));
}

void tooltip(const PanelFrame& frame, std::string_view words) {
  if (wants_tooltip()) tooltip_about(frame, tipped_item(frame), words);
}

void text(std::string_view words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

void faint_text(std::string_view words) {
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().faint_text));
  text(words);
  ImGui::PopStyleColor();
}

void wrapped_text(std::string_view words) { wrapped_text(words, theme().text); }

void wrapped_text(std::string_view words, Colour colour) {
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  text(wrapped_at_blanks(words, ImGui::GetContentRegionAvail().x));
  ImGui::PopStyleColor();
}

void text_at(ImVec2 at, float align, Colour colour, const std::string& words) {
  // Glyphs are sharp only at whole places.
  const float left = at.x - (align > 0.0f ? align * ImGui::CalcTextSize(words.c_str()).x : 0.0f);
  ImGui::GetWindowDrawList()->AddText(ImVec2(std::floor(left + 0.5f), std::floor(at.y + 0.5f)),
                                      style::packed(colour), words.c_str());
}

std::string cut_to_width(std::string_view words, float width) {
  const std::string shown_here = in_window_words(words);
  const std::string_view shown = shown_here;
  const auto wide = [](std::string_view part) {
    return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
  };
  if (wide(shown) <= width) return std::string(shown);
  const std::string_view ellipsis = "...";
  const float room = width - wide(ellipsis);
  std::size_t low = 0;
  std::size_t high = shown.size();
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (wide(shown.substr(0, middle)) <= room) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  // Never through the middle of a character.
  while (low > 0 && (static_cast<unsigned char>(shown[low]) & 0xC0U) == 0x80U) --low;
  return std::string(shown.substr(0, low)) + std::string(ellipsis);
}

std::string with_commas(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string with_commas(std::size_t count, std::string_view one, std::string_view many) {
  return with_commas(count) + " " + std::string(count == 1 ? one : many);
}

std::string with_unit(std::string_view number, std::string_view unit) {
  std::string_view one = unit;
  if (one.ends_with("ches"))
    one.remove_suffix(2);
  else if (one.ends_with("s"))
    one.remove_suffix(1);
  return std::string(number) + " " + std::string(number == "1" ? one : unit);
}

std::string capitalised(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '-', ' ');
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

std::string with_capital(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

std::string words_of(const knit::Place& place) {
  std::string words = capitalised(knit::name_of(place.stage));
  if (place.row > 0) words += ", row " + std::to_string(place.row);
  return words + ", item " + std::to_string(place.item + 1);
}

void boxed_text(const PanelFrame& frame, ImVec2 at, const std::string& words, Colour colour) {
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const ImVec2 edge(frame.units(5.0f), frame.units(2.0f));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(at.x - edge.x, at.y - edge.y),
                     ImVec2(at.x + size.x + edge.x, at.y + size.y + edge.y),
                     style::packed(theme().background), frame.units(4.0f));
  list.AddText(at, style::packed(readable_on(colour, theme().background)), words.c_str());
}

}  // namespace app
