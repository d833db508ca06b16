// From mesh to yarn: one slider for layers and positions together, and the yarn's colours while it is shown.
#include <array>
#include <cmath>
#include <string>

#include "app/actions/looking.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/view/overlays.h"
#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/session/view.h"
#include "knit/yarn/yarn.h"

namespace app {

namespace {

constexpr std::array<const char*, 4> looking_tips{
    "The mesh that came in.", "The stitches on it, and the faces between them.",
    "The stitches where they come to lie off the needles, stuffed.",
    "The loops, one yarn through all of them."};

knit::Parameters with_relaxing(const Session& session) {
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.relax.relaxing = knit::Relaxing::on;
  return parameters;
}

// The words under the slider are stops of it. One that there is nothing of yet is grey, and turns that on.
void draw_stop(PanelFrame& frame, Looking looking, bool on, bool missing) {
  const auto index = static_cast<std::size_t>(looking);
  const std::string key(looking_keys.at(index));
  ImGui::PushStyleColor(ImGuiCol_Text, style::packed(missing ? theme().faint_text : theme().text));
  if (lit_button(key.c_str(), on)) {
    if (missing) frame.wish(Tune{with_relaxing(frame.session)});
    frame.wish(ShowAs{looking});
  }
  ImGui::PopStyleColor();
  frame.mark("looking/" + key);
  tooltip(
      frame,
      missing
          ? "The piece has not been relaxed at this place. A click turns Relax on; it comes after the faces."
          : looking_tips.at(index));
}

void draw_slider_of(PanelFrame& frame, Looking now) {
  int stop = static_cast<int>(now);
  const int last = static_cast<int>(looking_keys.size()) - 1;
  ImGui::SetNextItemWidth(frame.units(236.0f));
  const std::string shown(looking_keys.at(static_cast<std::size_t>(stop)));
  if (ImGui::SliderInt("##looking", &stop, 0, last, shown.c_str(), ImGuiSliderFlags_NoInput) &&
      stop != static_cast<int>(now))
    frame.wish(ShowAs{static_cast<Looking>(stop)});
  frame.mark("looking");
  tooltip(
      frame,
      "From the mesh over its stitches and the piece in the air to the yarn. Layers and positions follow.");
}

std::uint8_t byte_of(float share) { return static_cast<std::uint8_t>(std::lround(255.0F * share)); }

bool draw_colour(PanelFrame& frame, const char* key, const char* words, const char* about, Colour& colour) {
  std::array<float, 3> rgb{static_cast<float>(colour.r) / 255.0F, static_cast<float>(colour.g) / 255.0F,
                           static_cast<float>(colour.b) / 255.0F};
  const bool changed = ImGui::ColorEdit3(words, rgb.data(), ImGuiColorEditFlags_NoInputs);
  frame.mark(key);
  tooltip(frame, about);
  if (changed) colour = {byte_of(rgb[0]), byte_of(rgb[1]), byte_of(rgb[2])};
  return changed;
}

bool draw_thickness(PanelFrame& frame, YarnLook& look) {
  auto radius = static_cast<float>(look.radius > 0.0 ? look.radius : knit::radius_of_width);
  ImGui::SetNextItemWidth(frame.units(96.0f));
  const bool thicker =
      ImGui::SliderFloat("##radius", &radius, static_cast<float>(least_yarn_radius),
                         static_cast<float>(most_yarn_radius), "radius %.3f", ImGuiSliderFlags_NoInput);
  if (thicker) look.radius = radius;
  frame.mark("yarn/radius");
  tooltip(frame, "The yarn's radius in widths of a stitch. At an eighth, 0.125, neighbours just touch.");
  ImGui::SameLine();
  bool eased = look.easing > 0;
  const bool switched = ImGui::Checkbox("make room", &eased);
  if (switched) look.easing = eased ? usual_yarn_easing : 0;
  frame.mark("yarn/easing");
  tooltip(frame, "Loops that overlap come apart a little. For a look from near.");
  return thicker || switched;
}

void draw_yarn_look(PanelFrame& frame) {
  YarnLook look = frame.session.view->yarn;
  bool changed = false;
  const std::array<std::string_view, 3> names{yarn_colours_keys[0], yarn_colours_keys[1],
                                              yarn_colours_keys[2]};
  const int clicked = segmented("yarn-shows", names, static_cast<int>(look.by), frame.units(236.0f));
  frame.mark("yarn/shows");
  tooltip(frame, "What the yarn's colour tells: its wool, which kind of stitch, or how far it is stretched.");
  if (clicked >= 0) look.by = static_cast<YarnColours>(clicked);
  changed = clicked >= 0;
  if (look.by == YarnColours::wool) {
    changed = draw_colour(frame, "yarn/colour", "Yarn", "The yarn's colour.", look.wool) || changed;
    ImGui::SameLine();
    changed =
        draw_colour(frame, "yarn/second", "Stripes", "The second colour of stripes.", look.second) || changed;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(frame.units(64.0f));
    changed =
        ImGui::SliderInt("##stripes", &look.stripe_rounds, 0, 12, look.stripe_rounds > 0 ? "%d" : "none") ||
        changed;
    frame.mark("yarn/stripes");
    tooltip(frame, "So many rounds of each colour by turns.");
  }
  changed = draw_thickness(frame, look) || changed;
  if (changed) frame.wish(SetYarnLook{look});
}

}  // namespace

bool has_looking_dial(const PanelFrame& frame) {
  return frame.timeline() != nullptr && !frame.timeline()->state().fabric.strips().empty();
}

void draw_looking_dial(PanelFrame& frame) {
  const Looking now = looking_of(frame.session);
  draw_slider_of(frame, now);
  for (std::size_t i = 0; i < looking_keys.size(); ++i) {
    if (i > 0) ImGui::SameLine(0.0f, frame.units(6.0f));
    const auto looking = static_cast<Looking>(i);
    draw_stop(frame, looking, looking == now, looking == Looking::relaxed && !has_relaxed(frame.session));
  }
  if (now == Looking::yarn) draw_yarn_look(frame);
}

}  // namespace app
