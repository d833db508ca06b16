// The histogram of plots.h.
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/panels/kit/plots.h"
#include "app/panels/kit/widgets.h"

namespace app {

namespace {

using namespace plot_parts;

float x_of(const HistogramPlot& plot, const Box& ground, double value) {
  // Written so that what is no number stands at the left.
  const double share = value > plot.low ? std::min((value - plot.low) / (plot.high - plot.low), 1.0) : 0.0;
  return ground.x + static_cast<float>(share) * ground.width;
}

// Where bin `i` begins: worked out so that the last one ends at the high end itself.
double edge_of_bin(const HistogramPlot& plot, std::size_t i) {
  return plot.low + (plot.high - plot.low) * static_cast<double>(i) / static_cast<double>(plot.bins.size());
}

std::string bin_words(const HistogramPlot& plot, std::size_t i, std::size_t total) {
  const std::string from = fixed_text(edge_of_bin(plot, i), plot.decimals);
  const std::string to = fixed_text(edge_of_bin(plot, i + 1), plot.decimals);
  std::string range = from + " to " + to + plot.unit;
  if (i == 0 && plot.open_below) range = "Up to " + to + plot.unit;
  if (i + 1 == plot.bins.size() && plot.open_above) range = from + plot.unit + " and more";
  const double share = 100.0 * static_cast<double>(plot.bins[i]) / static_cast<double>(total);
  return range + ": " + with_commas(plot.bins[i]) + " " + plot.counted + ", " + fixed_text(share, 1) + " %." +
         (plot.bins[i] == 0 ? ""
          : plot.lit == i   ? "\nLit in the view. Click: no longer."
                            : "\nClick: they light up in the view.");
}

void draw_bars(const PanelFrame& frame, const HistogramPlot& plot, const Stand& stand,
               std::optional<std::size_t> hovered) {
  const Box& ground = stand.ground;
  const auto count = static_cast<float>(plot.bins.size());
  const std::size_t most = *std::max_element(plot.bins.begin(), plot.bins.end());
  const float room = ground.height - frame.units(9.0f);  // the mean's mark stands above
  const float gap = ground.width / count >= frame.units(6.0f) ? stand.line : 0.0f;
  for (std::size_t i = 0; i < plot.bins.size(); ++i) {
    if (plot.bins[i] == 0) continue;
    const float x0 = whole(ground.x + static_cast<float>(i) * ground.width / count);
    const float x1 = whole(ground.x + static_cast<float>(i + 1) * ground.width / count);
    const double share = static_cast<double>(plot.bins[i]) / static_cast<double>(most);
    // A single one is still seen.
    const float high = std::max(2.0f * stand.line, whole(room * static_cast<float>(share)));
    const ImU32 colour = hovered == i    ? style::packed(theme().text)
                         : plot.lit == i ? style::packed(theme().selected)
                                         : style::packed(bar(), 205);
    fill(stand, x0, ground.bottom() - high, std::max(x0 + 1.0f, x1 - gap), ground.bottom(), colour);
  }
}

void dashed_upright(const PanelFrame& frame, const Stand& stand, float x, ImU32 colour) {
  const float x0 = whole(x - 0.5f * stand.line);
  const float dash = whole(frame.units(3.0f));
  for (float y = stand.ground.bottom() - dash; y > stand.ground.y; y -= 2.0f * dash) {
    fill(stand, x0, y, x0 + stand.line, y + dash, colour);
  }
}

void draw_mean(const PanelFrame& frame, const HistogramPlot& plot, const Stand& stand) {
  const ImU32 colour = style::packed(theme().anchor);
  const float x = whole(x_of(plot, stand.ground, *plot.mean));
  fill(stand, x - stand.line, stand.ground.y, x + stand.line, stand.ground.bottom(), colour);
  const float half = frame.units(4.0f);
  const float top = stand.ground.y;
  stand.list.AddTriangleFilled(ImVec2(x - half, top), ImVec2(x + half, top), ImVec2(x, top + 1.4f * half),
                               colour);
}

void draw_histogram_axis(const PanelFrame& frame, const HistogramPlot& plot, const Stand& stand) {
  // Ends are written short: 0, 0.5, 2.
  const auto short_text = [&](double value) {
    const int decimals = value == std::floor(value) ? 0 : 10.0 * value == std::floor(10.0 * value) ? 1 : 2;
    return fixed_text(value, decimals) + plot.axis_unit;
  };
  std::vector<AxisWord> words;
  if (plot.reference) {
    words.push_back(
        {x_of(plot, stand.ground, *plot.reference), 0.5f, short_text(*plot.reference), theme().text});
  }
  words.push_back({stand.ground.x, 0.0f, short_text(plot.low)});
  words.push_back({stand.ground.right(), 1.0f, short_text(plot.high) + (plot.open_above ? "+" : "")});
  draw_axis_words(frame, stand, words);
}

}  // namespace

std::pair<double, double> span_of_bin(const HistogramPlot& plot, std::size_t bin) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const bool first = bin == 0;
  const bool last = bin + 1 == plot.bins.size();
  return {first ? -endless : edge_of_bin(plot, bin), last ? endless : edge_of_bin(plot, bin + 1)};
}

std::optional<std::size_t> draw_histogram(PanelFrame& frame, const HistogramPlot& plot, ImVec2 size) {
  const Stand stand = begin_stand(frame, plot.name, plot.title, size, 0.0f);
  std::size_t total = 0;
  for (const std::size_t bin : plot.bins) total += bin;
  if (total == 0) {
    draw_missing(frame, stand, plot.missing, plot.help);
    return std::nullopt;
  }
  std::optional<std::size_t> hovered;
  if (stand.inside) {
    const float across = (ImGui::GetIO().MousePos.x - stand.ground.x) / stand.ground.width;
    const auto bin = static_cast<std::size_t>(std::max(0.0f, across) * static_cast<float>(plot.bins.size()));
    hovered = std::min(bin, plot.bins.size() - 1);
  }
  draw_bars(frame, plot, stand, hovered);
  if (plot.reference) {
    dashed_upright(frame, stand, x_of(plot, stand.ground, *plot.reference), style::packed(theme().text, 190));
  }
  if (plot.mean) {
    draw_mean(frame, plot, stand);
    const std::string words = "mean " + fixed_text(*plot.mean, plot.decimals);
    draw_key(frame, stand, plot.title, stand.ground.right(), {words, theme().anchor, false});
  }
  draw_foot(stand);
  draw_histogram_axis(frame, plot, stand);
  if (hovered && stand.hovered) {
    tooltip(frame, bin_words(plot, *hovered, total));
  } else if (stand.hovered) {
    tooltip(frame, plot.help);
  }
  const bool counts = hovered && plot.bins[*hovered] > 0;
  return stand.clicked && counts ? hovered : std::nullopt;
}

}  // namespace app
