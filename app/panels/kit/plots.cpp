#include "app/panels/kit/plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "app/panels/kit/widgets.h"

namespace app {

namespace plot_parts {

float whole(float x) { return std::floor(x + 0.5f); }

void fill(const Stand& stand, float x0, float y0, float x1, float y1, ImU32 colour) {
  if (x1 > x0 && y1 > y0) stand.list.AddRectFilled(ImVec2(x0, y0), ImVec2(x1, y1), colour);
}

void fill_dashed(const PanelFrame& frame, const Stand& stand, float x0, float y0, float x1, float y1,
                 ImU32 colour) {
  const float dash = std::max(2.0f, whole(frame.units(4.0f)));
  const float period = dash + std::max(1.0f, whole(frame.units(2.0f)));
  for (float x = stand.ground.x + period * std::floor((x0 - stand.ground.x) / period); x < x1; x += period) {
    fill(stand, std::max(x0, x), y0, std::min(x1, x + dash), y1, colour);
  }
}

Stand begin_stand(PanelFrame& frame, const std::string& name, const std::string& title, ImVec2 size,
                  float gutter) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(name.c_str(), size);
  frame.mark(name);
  push_font(frame.fonts.small);
  const float axis = ImGui::GetTextLineHeight() + frame.units(2.0f);
  pop_font();
  const float head = ImGui::GetTextLineHeight() + frame.units(3.0f);
  const float top = whole(at.y + head);
  const float left = whole(at.x + gutter);
  const float bottom = std::max(top + 1.0f, whole(at.y + size.y - axis));
  const Box ground{left, top, std::max(1.0f, whole(at.x + size.x) - left), bottom - top};
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const bool inside = pointer.x >= ground.x && pointer.x < ground.right() && pointer.y >= ground.y &&
                      pointer.y < ground.bottom();
  Stand stand{
      *ImGui::GetWindowDrawList(),         at.x,    ground,          std::max(1.0f, whole(frame.units(1.0f))),
      ground.bottom() + frame.units(1.0f), clicked, wants_tooltip(), inside && ImGui::IsItemHovered()};
  text_at(at, 0.0f, theme().text, title);
  stand.list.AddRectFilled(ImVec2(ground.x, ground.y), ImVec2(ground.right(), ground.bottom()),
                           style::packed(theme().background), frame.units(2.0f));
  return stand;
}

void draw_foot(const Stand& stand) {
  fill(stand, stand.ground.x, stand.ground.bottom() - stand.line, stand.ground.right(), stand.ground.bottom(),
       style::packed(theme().faint_text, 130));
}

void draw_missing(const PanelFrame& frame, const Stand& stand, const std::string& words,
                  const std::string& help) {
  push_font(frame.fonts.small);
  const float y = stand.ground.y + 0.5f * (stand.ground.height - ImGui::GetTextLineHeight());
  text_at(ImVec2(stand.ground.x + 0.5f * stand.ground.width, y), 0.5f, theme().faint_text,
          "\xE2\x80\x93 " + words);
  pop_font();
  draw_foot(stand);
  if (stand.hovered) tooltip(frame, help);
}

void draw_axis_words(const PanelFrame& frame, const Stand& stand, std::span<const AxisWord> words) {
  push_font(frame.fonts.small);
  std::vector<std::array<float, 2>> taken;
  for (const AxisWord& word : words) {
    const float width = ImGui::CalcTextSize(word.words.c_str()).x;
    const float room = stand.ground.right() - width;
    const float left = std::max(stand.ground.x, std::min(word.x - word.align * width, room));
    const float gap = frame.units(5.0f);
    const bool free = std::all_of(taken.begin(), taken.end(), [&](const std::array<float, 2>& other) {
      return left > other[1] + gap || left + width < other[0] - gap;
    });
    if (!free) continue;
    taken.push_back({left, left + width});
    text_at(ImVec2(left, stand.axis_top), 0.0f, word.colour, word.words);
  }
  pop_font();
}

float draw_key(const PanelFrame& frame, const Stand& stand, const std::string& title, float right,
               const PlotKey& key) {
  const float title_end = stand.left + ImGui::CalcTextSize(title.c_str()).x;
  const float foot = stand.ground.y - frame.units(3.0f);
  push_font(frame.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(key.words.c_str());
  const float line = key.line ? frame.units(10.0f) : 0.0f;
  const float left = right - size.x - (key.line ? line + frame.units(4.0f) : 0.0f);
  const bool fits = left > title_end + frame.units(4.0f);
  if (fits) {
    text_at(ImVec2(right - size.x, foot - size.y), 0.0f, key.line ? theme().faint_text : key.colour,
            key.words);
    const float thick = std::max(2.0f, whole(frame.units(2.0f)));
    const float y = whole(foot - 0.5f * size.y);
    const ImU32 colour = style::packed(key.colour);
    const float middle = whole(left + 0.4f * line);
    if (key.dashed) {
      fill(stand, whole(left), y, middle, y + thick, colour);
      fill(stand, whole(left + 0.6f * line), y, whole(left + line), y + thick, colour);
    } else {
      fill(stand, whole(left), y, whole(left + line), y + thick, colour);
    }
  }
  pop_font();
  return fits ? left - frame.units(10.0f) : right;
}

}  // namespace plot_parts

double tick_step(double high, int most) {
  const double least = std::max(high, 0.0) / std::max(1, most);
  if (!(least > 1.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace app
