// The words and numbers that stand at places in the view.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "app/panels/kit/widgets.h"
#include "app/panels/view/view.h"

namespace app {

namespace {

constexpr float room_between = 34.0f;  // two lines of the band, in plain pixels

std::optional<ImVec2> place_on(const PanelFrame& frame, const glm::vec3& at) {
  const Box& view = frame.layout.view;
  const glm::vec4 place = frame.scene.view.projection * frame.scene.view.view * glm::vec4(at, 1.0f);
  if (place.w <= 0.0f) return std::nullopt;
  return ImVec2(view.x + (0.5f + 0.5f * place.x / place.w) * view.width,
                view.y + (0.5f - 0.5f * place.y / place.w) * view.height);
}

// The top left corner of words of this size that stand clear of a line, below its middle.
ImVec2 below_line(const PanelFrame& frame, ImVec2 from, ImVec2 to, ImVec2 size) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  ImVec2 aside =
      length > 0.0f ? ImVec2((from.y - to.y) / length, (to.x - from.x) / length) : ImVec2(0.0f, 1.0f);
  if (aside.y < 0.0f) aside = ImVec2(-aside.x, -aside.y);
  const float reach =
      std::abs(aside.x) * 0.5f * size.x + std::abs(aside.y) * 0.5f * size.y + frame.units(11.0f);
  return {0.5f * (from.x + to.x) + aside.x * reach - 0.5f * size.x,
          0.5f * (from.y + to.y) + aside.y * reach - 0.5f * size.y};
}

// Up in the view, along the surface.
glm::vec3 up_along(const glm::mat4& view, const glm::vec3& normal) {
  const glm::vec3 up(view[0][1], view[1][1], view[2][1]);
  const glm::vec3 along = up - normal * glm::dot(up, normal);
  const float length = glm::length(along);
  return length > 0.2f ? along / length : glm::vec3(0.0f);
}

// "w - ε", "w" and "w + ε" where the band's lines cross the upright through the anchor, once there is room.
void draw_band_words(PanelFrame& frame) {
  if (!frame.scene.band || !frame.scene.show_surface) return;
  const Band& band = *frame.scene.band;
  const glm::vec3 up = up_along(frame.scene.view.view, band.normal);
  const auto inner = place_on(frame, band.centre + band.inner * up);
  const auto outer = place_on(frame, band.centre + band.outer * up);
  if (!inner || !outer || inner->y - outer->y < 2.0f * frame.units(room_between)) return;
  struct Edge {
    float reach;
    const char* words;
  };
  for (const Edge& edge : {Edge{band.inner, "w - ε"}, Edge{band.middle, "w"}, Edge{band.outer, "w + ε"}}) {
    const auto at = place_on(frame, band.centre + edge.reach * up);
    if (!at || edge.reach <= 0.0f) continue;
    const ImVec2 size = ImGui::CalcTextSize(edge.words);
    boxed_text(frame, ImVec2(at->x - 0.5f * size.x, at->y - size.y - frame.units(4.0f)), edge.words,
               theme().anchor);
  }
}

}  // namespace

void draw_captions(PanelFrame& frame) {
  draw_band_words(frame);
  for (const Caption& caption : frame.scene.captions) {
    const auto place = place_on(frame, caption.position);
    const auto other = caption.other_end ? place_on(frame, *caption.other_end) : std::nullopt;
    if (!place) continue;
    const ImVec2 size = ImGui::CalcTextSize(caption.text.c_str());
    const ImVec2 at = other ? below_line(frame, *place, *other, size)
                            : ImVec2(place->x + frame.units(9.0f), place->y - size.y - frame.units(7.0f));
    boxed_text(frame, at, caption.text, caption.colour);
  }
}

}  // namespace app
