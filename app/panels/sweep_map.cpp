// The map of sweep_plot.h: a grid's figures as colours.
#include <algorithm>
#include <cmath>
#include <vector>

#include "app/core/fixed_text.h"
#include "app/panels/plot_parts.h"
#include "app/panels/sweep_plot.h"
#include "app/panels/widgets.h"
#include "knit/narrate.h"

namespace app {

namespace {

using namespace plot_parts;

constexpr float least_cell_px = 3.0f;  // more cells than that: every so many is shown

Colour mixed(const Colour& a, const Colour& b, double share) {
  const auto part = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {part(a.r, b.r), part(a.g, b.g), part(a.b, b.b)};
}

Colour ramp(double share) {
  share = std::clamp(share, 0.0, 1.0);
  return share < 0.5 ? mixed(theme().time_low, theme().time_middle, 2.0 * share)
                     : mixed(theme().time_middle, theme().time_high, 2.0 * share - 1.0);
}

// One of the two directions of the grid: places on the screen, and the values that they show.
struct Direction {
  const std::vector<double>& values;
  std::size_t places;
  [[nodiscard]] std::size_t value_at(std::size_t place) const {
    return places < 2 ? 0 : place * (values.size() - 1) / (places - 1);
  }
  // In places, the middle of a cell being half: where a value stands between them.
  [[nodiscard]] double place_of(double value) const {
    const double share = (value - values.front()) / (values.back() - values.front());
    return 0.5 + share * static_cast<double>(places - 1);
  }
  [[nodiscard]] bool holds(double value) const { return value >= values.front() && value <= values.back(); }
};

struct Grid {
  Box ground;
  Direction across, up;
  [[nodiscard]] float x_of(double place) const {
    return ground.x + static_cast<float>(place / static_cast<double>(across.places)) * ground.width;
  }
  [[nodiscard]] float y_of(double place) const {
    return ground.bottom() - static_cast<float>(place / static_cast<double>(up.places)) * ground.height;
  }
  [[nodiscard]] std::size_t run_at(std::size_t column, std::size_t row) const {
    return across.value_at(column) * up.values.size() + up.value_at(row);
  }
};

Grid grid_of(const SweepPlot& plot, const Box& ground) {
  const auto places = [](std::size_t values, float room) {
    return std::max<std::size_t>(
        1, std::min(values, static_cast<std::size_t>(std::max(1.0f, room / least_cell_px))));
  };
  const auto& first = plot.work.first_values();
  const auto& second = plot.work.second_values();
  return {
      ground, {first, places(first.size(), ground.width)}, {second, places(second.size(), ground.height)}};
}

void draw_cells(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand, const Grid& grid) {
  const double low = plot.cache.lowest(plot.figure);
  const double high = plot.cache.highest(plot.figure);
  const auto& figures = plot.cache.of(plot.figure);
  const float dot = frame.units(1.6f);
  for (std::size_t column = 0; column < grid.across.places; ++column) {
    for (std::size_t row = 0; row < grid.up.places; ++row) {
      const std::size_t run = grid.run_at(column, row);
      if (!figures[run]) continue;
      const float x0 = whole(grid.x_of(static_cast<double>(column)));
      const float x1 = whole(grid.x_of(static_cast<double>(column + 1)));
      const float y0 = whole(grid.y_of(static_cast<double>(row + 1)));
      const float y1 = whole(grid.y_of(static_cast<double>(row)));
      const double share = high > low ? (*figures[run] - low) / (high - low) : 0.0;
      fill(stand, x0, y0, x1, y1, style::packed(ramp(share)));
      const bool room = x1 - x0 > 4.0f * dot && y1 - y0 > 4.0f * dot;
      if (room && plot.cache.outcomes()[run] == SweepOutcome::stopped)
        stand.list.AddCircleFilled(ImVec2(0.5f * (x0 + x1), 0.5f * (y0 + y1)), dot,
                                   style::packed(theme().problem));
    }
  }
}

// The present values as a cross of thin lines.
void draw_present(const SweepPlot& plot, const Stand& stand, const Grid& grid) {
  const ImU32 colour = style::packed(theme().anchor, 220);
  if (plot.present && grid.across.holds(*plot.present)) {
    const float x = whole(grid.x_of(grid.across.place_of(*plot.present)));
    fill(stand, x, stand.ground.y, x + stand.line, stand.ground.bottom(), colour);
  }
  if (plot.second_present && grid.up.holds(*plot.second_present)) {
    const float y = whole(grid.y_of(grid.up.place_of(*plot.second_present)));
    fill(stand, stand.ground.x, y, stand.ground.right(), y + stand.line, colour);
  }
}

void draw_axes(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand, const Grid& grid) {
  const std::string label(knit::find_parameter(plot.work.plan().axis.key)->label);
  const std::vector<AxisWord> words{
      {stand.ground.x, 0.0f, knit::short_number(grid.across.values.front())},
      {stand.ground.right(), 1.0f, knit::short_number(grid.across.values.back())},
      {stand.ground.x + 0.5f * stand.ground.width, 0.5f, label}};
  draw_axis_words(frame, stand, words);
  push_font(frame.fonts.small);
  const float line = ImGui::GetTextLineHeight();
  const float right = stand.ground.x - frame.units(5.0f);
  text_at(ImVec2(right, stand.ground.y), 1.0f, theme().faint_text, knit::short_number(grid.up.values.back()));
  text_at(ImVec2(right, stand.ground.bottom() - line), 1.0f, theme().faint_text,
          knit::short_number(grid.up.values.front()));
  pop_font();
}

// A ramp with the lowest and the highest figure, at the right end of the title's line.
void draw_ramp(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand) {
  if (!(plot.cache.lowest(plot.figure) <= plot.cache.highest(plot.figure))) return;
  const int decimals = decimals_of(plot.figure);
  push_font(frame.fonts.small);
  const std::string low = fixed_text(plot.cache.lowest(plot.figure), decimals);
  const std::string high = fixed_text(plot.cache.highest(plot.figure), decimals);
  const float gap = frame.units(5.0f);
  const float bottom = stand.ground.y - frame.units(5.0f);
  const float top = bottom - frame.units(8.0f);
  const float text_top = 0.5f * (top + bottom) - 0.5f * ImGui::GetTextLineHeight();
  const float right = stand.ground.right() - ImGui::CalcTextSize(high.c_str()).x - gap;
  const float left = right - frame.units(70.0f);
  text_at(ImVec2(stand.ground.right(), text_top), 1.0f, theme().faint_text, high);
  text_at(ImVec2(left - gap, text_top), 1.0f, theme().faint_text, low);
  constexpr int parts = 35;
  for (int i = 0; i < parts; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(parts);
    const float next = static_cast<float>(i + 1) / static_cast<float>(parts);
    fill(stand, left + share * (right - left), top, left + next * (right - left), bottom,
         style::packed(ramp(static_cast<double>(share))));
  }
  pop_font();
}

}  // namespace

SweepPointed draw_sweep_map(PanelFrame& frame, const SweepPlot& plot, ImVec2 size) {
  push_font(frame.fonts.small);
  const auto& second = plot.work.second_values();
  const float gutter = std::max(ImGui::CalcTextSize(knit::short_number(second.front()).c_str()).x,
                                ImGui::CalcTextSize(knit::short_number(second.back()).c_str()).x) +
                       frame.units(6.0f);
  pop_font();
  const std::string title(knit::find_parameter(plot.work.plan().second->key)->label);
  const Stand stand = begin_stand(frame, plot.name, title, size, gutter);
  const Grid grid = grid_of(plot, stand.ground);
  draw_cells(frame, plot, stand, grid);
  draw_present(plot, stand, grid);
  SweepPointed pointed;
  if (stand.inside) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const auto place = [](float share, std::size_t places) {
      return std::min(places - 1,
                      static_cast<std::size_t>(std::max(0.0f, share) * static_cast<float>(places)));
    };
    const std::size_t column = place((at.x - stand.ground.x) / stand.ground.width, grid.across.places);
    const std::size_t row = place((stand.ground.bottom() - at.y) / stand.ground.height, grid.up.places);
    pointed.run = grid.run_at(column, row);
    stand.list.AddRect(
        ImVec2(grid.x_of(static_cast<double>(column)), grid.y_of(static_cast<double>(row + 1))),
        ImVec2(grid.x_of(static_cast<double>(column + 1)), grid.y_of(static_cast<double>(row))),
        style::packed(theme().text), 0.0f, 0, stand.line);
  }
  pointed.clicked = stand.clicked && pointed.run.has_value();
  draw_axes(frame, plot, stand, grid);
  draw_ramp(frame, plot, stand);
  return pointed;
}

}  // namespace app
