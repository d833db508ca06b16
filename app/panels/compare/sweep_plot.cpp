// The line of sweep_plot.h.
#include "app/panels/compare/sweep_plot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/base/text.h"
#include "app/panels/kit/plots.h"
#include "app/panels/kit/widgets.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

using namespace plot_parts;

// From values and figures to the screen.
struct Scale {
  Box ground;
  double from, to, low, high;
  [[nodiscard]] float x_of(double value) const {
    const double share = to > from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : 0.0;
    return ground.x + static_cast<float>(share) * ground.width;
  }
  [[nodiscard]] float y_of(double figure) const {
    const double share = std::clamp((figure - low) / (high - low), 0.0, 1.0);
    return ground.bottom() - static_cast<float>(share) * ground.height;
  }
};

Scale scale_of(const SweepPlot& plot, const Box& ground) {
  const std::vector<double>& values = plot.work.first_values();
  double low = plot.cache.lowest(plot.figure);
  double high = plot.cache.highest(plot.figure);
  if (!(low <= high)) low = high = 0.0;
  // Few problems are near none; other figures are seen by how they differ.
  if (counts_problems(plot.figure)) low = 0.0;
  double air = 0.08 * (high - low);
  if (!(air > 0.0)) air = decimals_of(plot.figure) > 0 ? 0.01 : 1.0;
  const double below = counts_problems(plot.figure) ? 0.0 : air;
  return {ground, values.front(), values.back(), low - below, high + air};
}

// Words for the ends of the figure's range.
std::string low_text(const SweepPlot& plot) {
  const bool from_zero = counts_problems(plot.figure);
  return fixed_text(from_zero ? 0.0 : plot.cache.lowest(plot.figure), decimals_of(plot.figure));
}
std::string high_text(const SweepPlot& plot) {
  return fixed_text(plot.cache.highest(plot.figure), decimals_of(plot.figure));
}

bool has_values(const SweepPlot& plot) {
  return plot.cache.lowest(plot.figure) <= plot.cache.highest(plot.figure);
}

float gutter_of(const PanelFrame& frame) {
  push_font(frame.fonts.small);
  const float width = ImGui::CalcTextSize("00000").x;  // the same for all, so that they stand in line
  pop_font();
  return width + frame.units(6.0f);
}

void draw_figure_axis(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand,
                      const Scale& scale) {
  push_font(frame.fonts.small);
  const float line = ImGui::GetTextLineHeight();
  const auto put = [&](double figure, const std::string& words) {
    const float y = std::clamp(scale.y_of(figure) - 0.5f * line, stand.ground.y - 0.3f * line,
                               stand.ground.bottom() - 0.7f * line);
    text_at(ImVec2(stand.ground.x - frame.units(5.0f), y), 1.0f, theme().faint_text, words);
  };
  const double low = counts_problems(plot.figure) ? 0.0 : plot.cache.lowest(plot.figure);
  const double high = plot.cache.highest(plot.figure);
  put(low, low_text(plot));
  // Too near to each other they would lie over each other.
  if (scale.y_of(low) - scale.y_of(high) > line) put(high, high_text(plot));
  pop_font();
}

// Of more runs than places, each place shows the lowest and highest of its runs.
void draw_line(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand, const Scale& scale) {
  const SweepCache::Values& figures = plot.cache.of(plot.figure);
  const std::vector<double>& values = plot.work.first_values();
  const float thick = frame.units(1.5f);
  const bool crowded = static_cast<float>(values.size()) > 1.5f * stand.ground.width;
  std::vector<ImVec2> line;
  const auto end_line = [&] {
    if (line.size() == 1) stand.list.AddCircleFilled(line[0], thick, style::packed(bar()));
    if (line.size() > 1)
      stand.list.AddPolyline(line.data(), static_cast<int>(line.size()), style::packed(bar()),
                             ImDrawFlags_None, thick);
    line.clear();
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!figures[i]) {
      end_line();
      continue;
    }
    const ImVec2 at(scale.x_of(values[i]), scale.y_of(*figures[i]));
    if (crowded && !line.empty() && whole(line.back().x) == whole(at.x)) {
      fill(stand, whole(at.x), std::min(line.back().y, at.y), whole(at.x) + thick,
           std::max(line.back().y, at.y), style::packed(bar()));
      continue;
    }
    line.push_back(at);
  }
  end_line();
}

// Runs that stopped or were refused have a mark on the foot.
void draw_outcomes(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand, const Scale& scale) {
  const std::vector<double>& values = plot.work.first_values();
  const float high = whole(frame.units(4.0f));
  const float wide = std::max(stand.line, stand.ground.width / static_cast<float>(values.size()));
  float drawn_to = stand.ground.x;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SweepOutcome outcome = plot.cache.outcomes()[i];
    if (outcome != SweepOutcome::stopped && outcome != SweepOutcome::refused) continue;
    const float x0 = std::max(drawn_to, scale.x_of(values[i]) - 0.5f * wide);
    const float x1 = std::min(stand.ground.right(), scale.x_of(values[i]) + 0.5f * wide);
    if (x1 - x0 < 0.5f) continue;
    drawn_to = x1;
    fill(stand, x0, stand.ground.bottom() - high, x1, stand.ground.bottom(),
         style::packed(outcome == SweepOutcome::stopped ? theme().problem : theme().faint_text));
  }
}

void draw_upright(const Stand& stand, float x, float wide, ImU32 colour) {
  const float x0 = std::clamp(whole(x - 0.5f * wide), stand.ground.x, stand.ground.right() - wide);
  fill(stand, x0, stand.ground.y, x0 + wide, stand.ground.bottom(), colour);
}

void draw_value_axis(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand, const Scale& scale) {
  std::vector<AxisWord> words;
  if (plot.present && *plot.present >= scale.from && *plot.present <= scale.to)
    words.push_back({scale.x_of(*plot.present), 0.5f, knit::short_number(*plot.present), theme().anchor});
  words.push_back({stand.ground.x, 0.0f, knit::short_number(scale.from)});
  words.push_back({stand.ground.right(), 1.0f, knit::short_number(scale.to)});
  draw_axis_words(frame, stand, words);
}

std::size_t nearest_run(const std::vector<double>& values, const Scale& scale, float x) {
  const double share = (x - scale.ground.x) / scale.ground.width;
  const double value = scale.from + share * (scale.to - scale.from);
  const auto above = std::lower_bound(values.begin(), values.end(), value);
  if (above == values.begin()) return 0;
  if (above == values.end()) return values.size() - 1;
  const bool below = value - *(above - 1) < *above - value;
  return static_cast<std::size_t>(above - values.begin()) - (below ? 1U : 0U);
}

void draw_lit(const PanelFrame& frame, const SweepPlot& plot, const Stand& stand, const Scale& scale) {
  if (!plot.lit || *plot.lit >= plot.work.first_values().size()) return;
  const float x = scale.x_of(plot.work.first_values()[*plot.lit]);
  draw_upright(stand, x, stand.line, style::packed(theme().text, 110));
  const auto& figure = plot.cache.of(plot.figure)[*plot.lit];
  if (!figure) return;
  const ImVec2 at(x, scale.y_of(*figure));
  stand.list.AddCircleFilled(at, frame.units(4.5f), style::packed(theme().background));
  stand.list.AddCircleFilled(at, frame.units(3.2f), style::packed(bar()));
  draw_key(frame, stand, std::string(name_of(plot.figure)), stand.ground.right(),
           {fixed_text(*figure, decimals_of(plot.figure)), theme().text, false});
}

}  // namespace

SweepPointed draw_sweep_line(PanelFrame& frame, const SweepPlot& plot, ImVec2 size) {
  const Stand stand =
      begin_stand(frame, plot.name, std::string(name_of(plot.figure)), size, gutter_of(frame));
  const Scale scale = scale_of(plot, stand.ground);
  SweepPointed pointed;
  if (stand.inside) pointed.run = nearest_run(plot.work.first_values(), scale, ImGui::GetIO().MousePos.x);
  pointed.clicked = stand.clicked && pointed.run.has_value();
  if (plot.present && *plot.present >= scale.from && *plot.present <= scale.to)
    draw_upright(stand, scale.x_of(*plot.present), 2.0f * stand.line, style::packed(theme().anchor, 200));
  if (has_values(plot)) {
    draw_figure_axis(frame, plot, stand, scale);
    draw_line(frame, plot, stand, scale);
  }
  draw_outcomes(frame, plot, stand, scale);
  draw_lit(frame, plot, stand, scale);
  draw_foot(stand);
  draw_value_axis(frame, plot, stand, scale);
  return pointed;
}

// The map of sweep_plot.h: a grid's figures as colours.

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
