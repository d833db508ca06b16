#include "app/panels/candidate_plot.h"

#include <algorithm>
#include <cmath>

#include "app/panels/plot_parts.h"
#include "app/panels/widgets.h"
#include "knit/narrate.h"

namespace app {

namespace {

using namespace plot_parts;
using knit::CandidateVerdict;

// From places in the ring and distances to the screen.
struct RingScale {
  Box ground;
  std::size_t places;
  double high;
  [[nodiscard]] float x_of(std::int32_t order) const {
    const auto last = static_cast<float>(std::max<std::size_t>(1, places - 1));
    return ground.x + 4.0f + (ground.width - 8.0f) * static_cast<float>(order) / last;
  }
  [[nodiscard]] float y_of(double distance) const {
    const double share = std::clamp(distance / high, 0.0, 1.0);
    return ground.bottom() - ground.height * static_cast<float>(share);
  }
  [[nodiscard]] std::int32_t order_at(float x) const {
    const auto last = static_cast<float>(places - 1);
    const float order = (x - ground.x - 4.0f) / std::max(1.0f, ground.width - 8.0f) * last;
    return static_cast<std::int32_t>(std::floor(std::clamp(order, 0.0f, last) + 0.5f));
  }
};

RingScale scale_of(const knit::CandidateTable& table, const Box& ground) {
  double high = 1.3 * table.band.high;
  for (const knit::Candidate& candidate : table.candidates) high = std::max(high, 1.08 * candidate.distance);
  return {ground, table.candidates.size(), high > 0.0 ? high : 1.0};
}

struct Dot {
  Colour colour;
  float radius;
};
Dot dot_of(CandidateVerdict verdict) {
  switch (verdict) {
    case CandidateVerdict::first:
    case CandidateVerdict::accepted:
      return {theme().accepted, 2.8f};
    case CandidateVerdict::taken:
      return {theme().problem, 3.2f};
    case CandidateVerdict::too_far:
      return {theme().too_far, 2.2f};
    case CandidateVerdict::too_near:
    case CandidateVerdict::never_reached:
      break;
  }
  return {theme().too_near, 1.6f};
}

const knit::Candidate& at(const CandidatePlot& plot, std::int32_t order) {
  return plot.table.candidates[static_cast<std::size_t>(order)];
}

void draw_band_and_width(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
                         const RingScale& scale) {
  const float low = whole(scale.y_of(plot.table.band.low));
  const float high = whole(scale.y_of(plot.table.band.high));
  fill(stand, stand.ground.x, high, stand.ground.right(), std::max(low, high + stand.line),
       style::packed(theme().anchor, 46));
  const float width = whole(scale.y_of(plot.table.stitch_width));
  fill(stand, stand.ground.x, width, stand.ground.right(), width + stand.line,
       style::packed(theme().anchor, 150));
  push_font(frame.fonts.small);
  const float half = 0.5f * ImGui::GetTextLineHeight();
  const float right = stand.ground.x - frame.units(5.0f);
  text_at(ImVec2(right, width - half), 1.0f, theme().anchor, knit::short_number(plot.table.stitch_width));
  if (width + 3.0f * half < stand.ground.bottom())
    text_at(ImVec2(right, stand.ground.bottom() - 1.6f * half), 1.0f, theme().faint_text, "0");
  pop_font();
}

// Teeth: what one anchor measured, joined.
void draw_saw(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
              const RingScale& scale) {
  const float thick = std::max(1.0f, frame.units(1.0f));
  const auto& candidates = plot.table.candidates;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const knit::Candidate& to = candidates[i];
    if (to.step == knit::no_step) continue;
    const bool from_anchor = to.anchor_order == static_cast<std::int32_t>(i) - 1;
    const double before = from_anchor ? 0.0 : candidates[i - 1].distance;
    if (!from_anchor && candidates[i - 1].anchor_order != to.anchor_order) continue;
    const bool past = to.step < plot.position;
    stand.list.AddLine(ImVec2(scale.x_of(to.order - 1), scale.y_of(before)),
                       ImVec2(scale.x_of(to.order), scale.y_of(to.distance)),
                       style::packed(bar(), past ? 170 : 70), thick);
  }
}

void draw_dots(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
               const RingScale& scale) {
  const float room = stand.ground.width / static_cast<float>(std::max<std::size_t>(1, scale.places));
  const float shrink = std::clamp(room / frame.units(4.0f), 0.45f, 1.0f);
  for (const knit::Candidate& candidate : plot.table.candidates) {
    if (candidate.step == knit::no_step) continue;
    const Dot dot = dot_of(candidate.verdict);
    const bool past = candidate.step < plot.position;
    stand.list.AddCircleFilled(ImVec2(scale.x_of(candidate.order), scale.y_of(candidate.distance)),
                               frame.units(dot.radius) * shrink, style::packed(dot.colour, past ? 255 : 90),
                               8);
  }
}

void pick_out(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand, const RingScale& scale,
              std::int32_t order, Colour colour) {
  const float x = whole(scale.x_of(order));
  fill(stand, x, stand.ground.y, x + stand.line, stand.ground.bottom(), style::packed(colour, 120));
  if (at(plot, order).step == knit::no_step) return;
  const ImVec2 middle(scale.x_of(order), scale.y_of(at(plot, order).distance));
  stand.list.AddCircle(middle, frame.units(4.5f), style::packed(colour), 16, frame.units(1.5f));
}

std::string words_of(const knit::Candidate& candidate) {
  std::string words =
      "Vertex " + std::to_string(candidate.vertex) + ", place " + std::to_string(candidate.order) + ": ";
  if (candidate.step == knit::no_step) return words + "never reached so far.";
  if (candidate.verdict == CandidateVerdict::first) return words + "the row begins here.\nClick: go there.";
  return words + knit::short_number(candidate.distance) + " from stitch " + std::to_string(candidate.stitch) +
         ", " + std::string(knit::name_of(candidate.verdict)) + ".\nClick: go to the step that says so.";
}

void draw_ring_axis(const PanelFrame& frame, const CandidatePlot& plot, const Stand& stand,
                    const RingScale& scale) {
  std::vector<AxisWord> words;
  if (plot.current)
    words.push_back({scale.x_of(*plot.current), 0.5f, std::to_string(*plot.current), theme().text});
  words.push_back({stand.ground.x, 0.0f, "place 0"});
  words.push_back({stand.ground.right(), 1.0f, std::to_string(scale.places - 1)});
  draw_axis_words(frame, stand, words);
}

}  // namespace

std::optional<std::int32_t> draw_candidate_plot(PanelFrame& frame, const CandidatePlot& plot, ImVec2 size) {
  push_font(frame.fonts.small);
  const float gutter =
      ImGui::CalcTextSize(knit::short_number(plot.table.stitch_width).c_str()).x + frame.units(7.0f);
  pop_font();
  const std::string title = "Distance to the anchor";
  const Stand stand = begin_stand(frame, "plot/candidates", title, size, gutter);
  const RingScale scale = scale_of(plot.table, stand.ground);
  std::optional<std::int32_t> pointed;
  if (stand.inside) pointed = scale.order_at(ImGui::GetIO().MousePos.x);
  draw_band_and_width(frame, plot, stand, scale);
  draw_saw(frame, plot, stand, scale);
  draw_dots(frame, plot, stand, scale);
  if (plot.current) pick_out(frame, plot, stand, scale, *plot.current, theme().text);
  if (plot.selected) pick_out(frame, plot, stand, scale, *plot.selected, theme().selected);
  if (pointed) pick_out(frame, plot, stand, scale, *pointed, theme().faint_text);
  draw_foot(stand);
  draw_ring_axis(frame, plot, stand, scale);
  draw_key(frame, stand, title, stand.ground.right(), {"band", theme().anchor, true});
  if (stand.hovered && pointed) tooltip(frame, words_of(at(plot, *pointed)));
  if (stand.hovered && !stand.inside) {
    tooltip(frame,
            "How far each vertex of the cycle lies from the anchor it was measured against. The teeth "
            "end in the band; one that climbs out of it is a stall.");
  }
  return stand.clicked ? pointed : std::nullopt;
}

}  // namespace app
