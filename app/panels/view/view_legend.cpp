#include "app/panels/view/overlays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/describe/describe_stretch.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/widgets.h"
#include "app/session/learning.h"
#include "app/session/view.h"
#include "knit/model/words.h"

namespace app {

namespace {

// Under the legend; words in the view keep clear of it.
void draw_ground(const PanelFrame& frame, const Box& box) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(box.x, box.y), ImVec2(box.right(), box.bottom()),
                                            style::packed(theme().background), frame.units(4.0f));
  frame.memory.controls.insert_or_assign("legend-box", box);
}

// What the mesh's colours say.
void draw_time_ramp(const PanelFrame& frame) {
  const Session& session = frame.session;
  if (frame.timeline() == nullptr || !session.view->shows(Layer::surface) ||
      !session.view->shows(Layer::times))
    return;
  if (frame.scene.timed_vertices == 0 || session.view->gaze.knit_along || session.learning->prediction)
    return;
  const Box& view = frame.layout.view;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = frame.units(90.0f);
  const float height = frame.units(7.0f);
  const ImVec2 low(view.right() - width - frame.units(14.0f), view.bottom() - height - frame.units(12.0f));
  const ImVec2 high(low.x + width, low.y + height);
  const float middle = low.x + 0.5f * width;
  const ImU32 a = style::packed(frame.scene.time_low);
  const ImU32 b = style::packed(frame.scene.time_middle);
  const ImU32 c = style::packed(frame.scene.time_high);
  const float y = low.y - ImGui::GetTextLineHeight() - frame.units(1.0f);
  const float edge = frame.units(5.0f);
  draw_ground(frame, {low.x - edge, y - edge, width + 2.0f * edge, high.y - y + 2.0f * edge});
  list.AddRectFilledMultiColor(low, ImVec2(middle, high.y), a, b, b, a);
  list.AddRectFilledMultiColor(ImVec2(middle, low.y), high, b, c, c, b);
  const ImU32 colour = style::packed(theme().faint_text);
  list.AddText(ImVec2(low.x, y), colour, "t = 0");
  list.AddText(ImVec2(high.x - ImGui::CalcTextSize("1").x, y), colour, "1");
}

struct LabelShown {
  knit::Label label;
  std::size_t count;
};

// Those that stand somewhere, in the order of the list of labels.
std::vector<LabelShown> labels_shown(PanelFrame& frame) {
  using knit::Label;
  constexpr std::array order{Label::knit,  Label::main, Label::cast,      Label::m1r,        Label::m1l,
                             Label::k2tog, Label::ssk,  Label::turn_left, Label::turn_right, Label::marked};
  const LabelTally::Counts counts = frame.own<LabelTally>().count(frame.timeline()->state());
  std::vector<LabelShown> shown;
  for (const Label label : order) {
    const std::size_t count = counts[static_cast<std::size_t>(label)];
    if (count > 0) shown.push_back({label, count});
  }
  return shown;
}

void draw_labels(PanelFrame& frame) {
  const std::vector<LabelShown> shown = labels_shown(frame);
  const Box& view = frame.layout.view;
  const float line = ImGui::GetTextLineHeight() + frame.units(1.0f);
  const float swatch = frame.units(10.0f);
  const float beside_swatch = swatch + frame.units(6.0f);
  float width = frame.units(104.0f);
  for (const LabelShown& label : shown) {
    const std::string name(knit::name_of(label.label));
    width = std::max(width, beside_swatch + ImGui::CalcTextSize(name.c_str()).x);
  }
  const float left = view.right() - width - frame.units(10.0f);
  const float top = view.bottom() - line * static_cast<float>(shown.size()) - frame.units(10.0f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float edge = frame.units(5.0f);
  draw_ground(frame, {left - edge, top - edge, view.right() - left, view.bottom() - top});
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const float y = top + line * static_cast<float>(i);
    const float at = y + 0.5f * (line - swatch);
    list.AddRectFilled(ImVec2(left, at), ImVec2(left + swatch, at + swatch),
                       style::packed(theme().of(shown[i].label)), frame.units(2.0f));
    text_at(ImVec2(left + beside_swatch, y), 0.0f, theme().text, std::string(knit::name_of(shown[i].label)));
  }
}

// How long edges are, beside what they should be; the same colours as in the view.
void draw_stretch_ramp(PanelFrame& frame, double full) {
  constexpr int parts = 24;
  const Box& view = frame.layout.view;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = frame.units(150.0f);
  const float height = frame.units(8.0f);
  const float line = ImGui::GetTextLineHeight() + frame.units(2.0f);
  const float edge = frame.units(6.0f);
  const ImVec2 low(view.right() - width - frame.units(18.0f),
                   view.bottom() - line - height - frame.units(12.0f));
  const float top = low.y - 2.0f * line;
  draw_ground(frame,
              {low.x - edge, top - edge, width + 2.0f * edge, low.y + height + line - top + 2.0f * edge});
  text_at(ImVec2(low.x, top), 0.0f, theme().text, "Length of an edge");
  text_at(ImVec2(low.x, top + line), 0.0f, theme().faint_text, "wale in h, course in w");
  const auto stretch_at = [full](float share) {
    return std::pow(full, 2.0 * static_cast<double>(share) - 1.0);
  };
  for (int i = 0; i < parts; ++i) {
    const float from = low.x + width * static_cast<float>(i) / parts;
    const float to = low.x + width * static_cast<float>(i + 1) / parts;
    const Colour colour = stretch_colour(theme(), stretch_at((static_cast<float>(i) + 0.5f) / parts), full);
    list.AddRectFilled(ImVec2(from, low.y), ImVec2(to, low.y + height), style::packed(colour));
  }
  struct Tick {
    const char* words;
    float share;
  };
  const bool narrow = full < full_stretch;
  for (const Tick& tick :
       {Tick{narrow ? "0.87" : "2/3", 0.0f}, Tick{"1", 0.5f}, Tick{narrow ? "1.15" : "3/2", 1.0f}}) {
    const float wide = ImGui::CalcTextSize(tick.words).x;
    text_at(ImVec2(low.x + tick.share * (width - wide), low.y + height + frame.units(1.0f)), 0.0f,
            theme().faint_text, tick.words);
  }
  frame.memory.controls.insert_or_assign("legend/stretch",
                                         Box{low.x, top, width, low.y + height + line - top});
}

// Nothing is left out in silence.
void draw_coarse_note(const PanelFrame& frame) {
  if (frame.scene.coarse <= 1) return;
  const std::string every = std::to_string(frame.scene.coarse);
  const Box& view = frame.layout.view;
  // Below what stands over each half.
  const float words = frame.layout.other_view.width > 0.0f ? 2.0f * ImGui::GetTextLineHeight() : 0.0f;
  const float down = words > 0.0f ? words + frame.units(20.0f) : frame.units(8.0f);
  boxed_text(frame, ImVec2(view.x + frame.units(12.0f), view.y + down),
             "Drawn coarsely: every " + every + "th row and stitch. Come nearer to see each.",
             theme().faint_text);
}

}  // namespace

void draw_view_legend(PanelFrame& frame) {
  draw_coarse_note(frame);
  const knit::Timeline* timeline = frame.timeline();
  if (timeline == nullptr || frame.session.view->gaze.knit_along) return;
  if (const auto scale = stretch_shown(frame.session)) return draw_stretch_ramp(frame, scale->full);
  const bool labelled = !timeline->state().fabric.joins().empty();
  const bool seen = frame.session.view->shows(Layer::faces) || frame.session.view->shows(Layer::stitches);
  if (labelled && seen) return draw_labels(frame);
  draw_time_ramp(frame);
}

}  // namespace app
