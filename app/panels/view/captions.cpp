// The words and numbers that stand at places in the view.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "app/panels/kit/widgets.h"
#include "app/panels/view/view.h"

namespace app {

namespace {

constexpr float room_between = 34.0f;  // two lines of the band, in plain pixels

// The view, or its half of the pinned run.
struct Half {
  const Scene& scene;
  const Box& box;
};

std::optional<ImVec2> place_on(const Half& half, const glm::vec3& at) {
  const Box& view = half.box;
  const glm::vec4 place = half.scene.view.projection * half.scene.view.view * glm::vec4(at, 1.0f);
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
void draw_band_words(const PanelFrame& frame, const Half& half) {
  if (!half.scene.band || !half.scene.show_surface) return;
  const Band& band = *half.scene.band;
  const glm::vec3 up = up_along(half.scene.view.view, band.normal);
  const auto inner = place_on(half, band.centre + band.inner * up);
  const auto outer = place_on(half, band.centre + band.outer * up);
  if (!inner || !outer || inner->y - outer->y < 2.0f * frame.units(room_between)) return;
  struct Edge {
    float reach;
    const char* words;
  };
  for (const Edge& edge : {Edge{band.inner, "w - ε"}, Edge{band.middle, "w"}, Edge{band.outer, "w + ε"}}) {
    const auto at = place_on(half, band.centre + edge.reach * up);
    if (!at || edge.reach <= 0.0f) continue;
    const ImVec2 size = ImGui::CalcTextSize(edge.words);
    if (at->y - size.y < frame.layout.view.y + frame.units(8.0f)) continue;  // would be cut at the head
    boxed_text(frame, ImVec2(at->x - 0.5f * size.x, at->y - size.y - frame.units(4.0f)), edge.words,
               theme().anchor);
  }
}

// Clear of a box of which nothing may be covered and which covers nothing: left of it or above it, whichever is nearer.
ImVec2 clear_of(const Box& box, const Half& half, ImVec2 at, ImVec2 size, float edge) {
  const float left = box.x - size.x - edge;
  const float above = box.y - size.y - edge;
  const bool free = at.x <= left || at.x >= box.right() + edge || at.y <= above || at.y >= box.bottom();
  if (free) return at;
  const bool aside = left >= half.box.x + edge && at.x - left <= at.y - above;
  return aside ? ImVec2(left, at.y) : ImVec2(at.x, above);
}

// Inside of the half and clear of the card at a stop and of the legend. `size`: of the words.
ImVec2 clear_place(const PanelFrame& frame, const Half& half, ImVec2 at, ImVec2 size) {
  const float edge = frame.units(6.0f);  // of the words' ground, and a gap
  at.x = std::max(half.box.x + edge, std::min(at.x, half.box.right() - size.x - edge));
  at.y = std::max(half.box.y + edge, std::min(at.y, half.box.bottom() - size.y - edge));
  if (const auto& card = frame.own<StopCardPlace>().box) at = clear_of(*card, half, at, size, edge);
  const auto legend = frame.memory.controls.find("legend-box");
  return legend != frame.memory.controls.end() ? clear_of(legend->second, half, at, size, edge) : at;
}

void draw_captions_of(const PanelFrame& frame, const Half& half, const std::string& mark) {
  draw_band_words(frame, half);
  int number = 0;
  for (const Caption& caption : half.scene.captions) {
    const auto place = place_on(half, caption.position);
    const auto other = caption.other_end ? place_on(half, *caption.other_end) : std::nullopt;
    if (!place) continue;
    const ImVec2 size = ImGui::CalcTextSize(caption.text.c_str());
    const ImVec2 wished = other ? below_line(frame, *place, *other, size)
                                : ImVec2(place->x + frame.units(9.0f), place->y - size.y - frame.units(7.0f));
    const bool seen = wished.x < half.box.right() && wished.x + size.x > half.box.x &&
                      wished.y < half.box.bottom() && wished.y + size.y > half.box.y;
    const ImVec2 at = seen ? clear_place(frame, half, wished, size) : wished;
    boxed_text(frame, at, caption.text, caption.colour);
    frame.memory.controls.insert_or_assign(mark + std::to_string(number++), Box{at.x, at.y, size.x, size.y});
  }
}

}  // namespace

void draw_captions(PanelFrame& frame) { draw_captions_of(frame, {frame.scene, frame.layout.view}, "tag/"); }

void draw_other_captions(PanelFrame& frame) {
  if (frame.other_scene != nullptr)
    draw_captions_of(frame, {*frame.other_scene, frame.layout.other_view}, "other-tag/");
}

}  // namespace app
