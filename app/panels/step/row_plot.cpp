// The plot of values a row of plots.h.
#include <algorithm>
#include <cmath>
#include <vector>

#include "app/panels/kit/frame.h"
#include "app/panels/kit/plots.h"
#include "app/panels/kit/widgets.h"

namespace app {

namespace {

using namespace plot_parts;

Colour ideal_line() { return theme().anchor; }
Colour ghost_line() { return theme().pinned; }

// From rows and values to the screen.
struct RowScale {
  Box ground;
  std::size_t rows;
  double high;
  [[nodiscard]] float column() const { return ground.width / static_cast<float>(rows); }
  [[nodiscard]] float x_of(std::size_t row) const { return ground.x + static_cast<float>(row) * column(); }
  [[nodiscard]] float middle_of(std::size_t row) const { return x_of(row) + 0.5f * column(); }
  [[nodiscard]] float y_of(double value) const {
    // Written so that what is no number lies on the axis.
    const double share = value > 0.0 ? std::min(value / high, 1.0) : 0.0;
    return ground.bottom() - ground.height * static_cast<float>(share);
  }
  [[nodiscard]] std::size_t row_at(float x) const {
    const float row = (x - ground.x) / column();
    return static_cast<std::size_t>(std::clamp(row, 0.0f, static_cast<float>(rows - 1)));
  }
  // Of more rows than there are places on the screen, every so many is drawn.
  [[nodiscard]] std::size_t stride() const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(1.0f / column())));
  }
};

RowScale scale_of(const RowPlot& plot, const Box& ground) {
  double high = std::max(1.0, plot.highest);
  for (const auto& series : {plot.values, plot.ideals, plot.ghosts}) {
    for (const double value : series) high = std::isfinite(value) ? std::max(high, value) : high;
  }
  const std::size_t current = plot.current ? *plot.current + 1 : 1;
  return {ground, std::max({current, plot.rows, plot.values.size(), plot.ghosts.size()}), 1.08 * high};
}

int ticks_in(const PanelFrame& frame, float height) {
  return std::clamp(static_cast<int>(height / frame.units(30.0f)), 1, 5);
}

void draw_value_axis(const PanelFrame& frame, const Stand& stand, const RowScale& scale) {
  const double step = tick_step(scale.high, ticks_in(frame, stand.ground.height));
  push_font(frame.fonts.small);
  const float half = 0.5f * ImGui::GetTextLineHeight();
  for (double value = 0.0; value <= scale.high; value += step) {
    const float y = whole(scale.y_of(value));
    if (value > 0.0) {
      fill(stand, stand.ground.x, y, stand.ground.right(), y + stand.line, style::packed(theme().outline));
    }
    text_at(ImVec2(stand.ground.x - frame.units(5.0f), y - half), 1.0f, theme().faint_text,
            fixed_text(value, 0));
  }
  pop_font();
}

// Row by row, from the step to the line.
void draw_gaps(const RowPlot& plot, const Stand& stand, const RowScale& scale) {
  const std::size_t count = std::min(plot.values.size(), plot.ideals.size());
  for (std::size_t i = 0; i < count; i += scale.stride()) {
    const float step = scale.y_of(plot.values[i]);
    const float line = scale.y_of(plot.ideals[i]);
    fill(stand, whole(scale.x_of(i)), std::min(step, line),
         whole(scale.x_of(std::min(i + scale.stride(), count))), std::max(step, line),
         style::packed(theme().warning, 110));
  }
}

void draw_values(const PanelFrame& frame, const RowPlot& plot, const Stand& stand, const RowScale& scale) {
  const float thick = whole(std::max(1.0f, frame.units(1.6f)));
  const std::size_t count = plot.values.size();
  std::vector<ImVec2> line;
  for (std::size_t i = 0; i < count; i += scale.stride()) {
    const float x0 = whole(scale.x_of(i));
    const float x1 = whole(scale.x_of(std::min(i + scale.stride(), count)));
    const float y = whole(scale.y_of(plot.values[i]));
    fill(stand, x0, y, x1, stand.ground.bottom(), style::packed(bar(), 70));
    // The step's riser: from the row before to this one.
    const float before = line.empty() ? y : line.back().y;
    fill(stand, x0, std::min(before, y), x0 + thick, std::max(before, y) + thick, style::packed(bar()));
    fill(stand, x0, y, x1, y + thick, style::packed(bar()));
    line.emplace_back(x0, y);
  }
  if (plot.gaps) draw_gaps(plot, stand, scale);
  line.clear();
  for (std::size_t i = 0; i < plot.ideals.size(); i += scale.stride()) {
    line.emplace_back(scale.middle_of(i), scale.y_of(plot.ideals[i]));
  }
  stand.list.AddPolyline(line.data(), static_cast<int>(line.size()), style::packed(ideal_line()),
                         ImDrawFlags_None, frame.units(1.6f));
}

// Steps like the values', thin, with nothing below; dashed, so that the two are told apart without their hues as well.
// Dashes lie where the plot has them, not where a row begins: rows may be narrower than one.
void draw_ghosts(const PanelFrame& frame, const RowPlot& plot, const Stand& stand, const RowScale& scale) {
  const float thick = whole(std::max(1.0f, frame.units(1.0f)));
  const std::size_t count = plot.ghosts.size();
  const ImU32 colour = style::packed(ghost_line());
  std::optional<float> before;
  for (std::size_t i = 0; i < count; i += scale.stride()) {
    const float x0 = whole(scale.x_of(i));
    const float x1 = whole(scale.x_of(std::min(i + scale.stride(), count)));
    const float y = whole(scale.y_of(plot.ghosts[i]));
    const float from = before.value_or(y);
    fill(stand, x0, std::min(from, y), x0 + thick, std::max(from, y) + thick, colour);
    fill_dashed(frame, stand, x0, y, x1, y + thick, colour);
    before = y;
  }
}

// A row picked out: a light band down the plot.
void draw_band(const PanelFrame& frame, const Stand& stand, const RowScale& scale, std::size_t row,
               std::uint8_t alpha) {
  const float x0 = whole(scale.x_of(row));
  const float x1 = std::max(x0 + whole(frame.units(2.0f)), whole(scale.x_of(row + 1)));
  fill(stand, x0, stand.ground.y, std::min(x1, stand.ground.right()), stand.ground.bottom(),
       style::packed(theme().text, alpha));
}

void draw_dots(const PanelFrame& frame, const RowPlot& plot, const Stand& stand, const RowScale& scale,
               std::size_t row) {
  if (row >= plot.values.size()) return;
  const float x = scale.middle_of(row);
  const auto dot = [&](double value, Colour colour) {
    const ImVec2 at(x, scale.y_of(value));
    stand.list.AddCircleFilled(at, frame.units(4.5f), style::packed(theme().background));
    stand.list.AddCircleFilled(at, frame.units(3.2f), style::packed(colour));
  };
  if (row < plot.ideals.size()) dot(plot.ideals[row], ideal_line());
  dot(plot.values[row], bar());
}

void draw_row_axis(const PanelFrame& frame, const RowPlot& plot, const Stand& stand, const RowScale& scale) {
  std::vector<AxisWord> words;
  if (plot.current) {
    words.push_back(
        {scale.middle_of(*plot.current), 0.5f, std::to_string(*plot.current + plot.first), theme().text});
  }
  words.push_back({stand.ground.x, 0.0f, "row " + std::to_string(plot.first)});
  words.push_back({stand.ground.right(), 1.0f, std::to_string(scale.rows - 1 + plot.first)});
  draw_axis_words(frame, stand, words);
}

float gutter_of(const PanelFrame& frame, double high) {
  push_font(frame.fonts.small);
  const float width = ImGui::CalcTextSize(fixed_text(std::max(high, 10.0), 0).c_str()).x;
  pop_font();
  return width + frame.units(6.0f);
}

void draw_keys(const PanelFrame& frame, const RowPlot& plot, const Stand& stand) {
  float left = stand.ground.right();
  if (!plot.ideals.empty())
    left = draw_key(frame, stand, plot.title, left, {plot.ideal_words, ideal_line(), true});
  const float next = draw_key(frame, stand, plot.title, left, {plot.value_words, bar(), true});
  if (!plot.ghosts.empty()) draw_key(frame, stand, plot.title, next, {"pinned", ghost_line(), true, true});
}

std::string row_words(const RowPlot& plot, std::size_t row) {
  const std::string tail = "\nLit in the view. Click: to the end of this row.";
  if (plot.words) return plot.words(row) + tail;
  std::string words = "Row " + std::to_string(row + plot.first) + ": " +
                      fixed_text(plot.values[row], plot.decimals) + " " + plot.value_words;
  if (row < plot.ideals.size()) words += ", " + fixed_text(plot.ideals[row], 1) + " " + plot.ideal_words;
  if (row < plot.ghosts.size()) words += ", " + fixed_text(plot.ghosts[row], plot.decimals) + " pinned";
  return words + "." + tail;
}

}  // namespace

std::optional<std::size_t> draw_row_plot(PanelFrame& frame, const RowPlot& plot, ImVec2 size) {
  const float gutter = plot.values.empty() ? 0.0f : gutter_of(frame, scale_of(plot, {}).high);
  const Stand stand = begin_stand(frame, plot.name, plot.title, size, gutter);
  if (plot.values.empty()) {
    draw_missing(frame, stand, plot.missing, plot.help);
    return std::nullopt;
  }
  const RowScale scale = scale_of(plot, stand.ground);
  std::optional<std::size_t> pointed;
  if (stand.inside) pointed = scale.row_at(ImGui::GetIO().MousePos.x);
  if (pointed && *pointed >= plot.values.size()) pointed.reset();
  draw_value_axis(frame, stand, scale);
  if (plot.current) draw_band(frame, stand, scale, *plot.current, 60);
  if (pointed) draw_band(frame, stand, scale, *pointed, 40);
  draw_values(frame, plot, stand, scale);
  draw_ghosts(frame, plot, stand, scale);
  if (plot.current) draw_dots(frame, plot, stand, scale, *plot.current);
  if (pointed) draw_dots(frame, plot, stand, scale, *pointed);
  draw_foot(stand);
  draw_row_axis(frame, plot, stand, scale);
  draw_keys(frame, plot, stand);
  if (pointed) {
    const auto row = static_cast<std::int32_t>(*pointed + plot.first);
    frame.rounds_under = RoundSpan{row, row};
  }
  if (stand.hovered && pointed) tooltip(frame, row_words(plot, *pointed));
  if (stand.hovered && !stand.inside) tooltip(frame, plot.help);
  return stand.clicked ? pointed : std::nullopt;
}

}  // namespace app
