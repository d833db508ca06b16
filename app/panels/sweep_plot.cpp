// The line of sweep_plot.h.
#include "app/panels/sweep_plot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/core/fixed_text.h"
#include "app/panels/plot_parts.h"
#include "app/panels/widgets.h"
#include "knit/narrate.h"

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
  if (plot.figure == SweepFigure::problems) low = 0.0;
  double air = 0.08 * (high - low);
  if (!(air > 0.0)) air = decimals_of(plot.figure) > 0 ? 0.01 : 1.0;
  const double below = plot.figure == SweepFigure::problems ? 0.0 : air;
  return {ground, values.front(), values.back(), low - below, high + air};
}

// Words for the ends of the figure's range.
std::string low_text(const SweepPlot& plot) {
  const bool from_zero = plot.figure == SweepFigure::problems;
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
  const double low = plot.figure == SweepFigure::problems ? 0.0 : plot.cache.lowest(plot.figure);
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

}  // namespace app
