#include "app/panels/kit/tube_marks.h"

#include <algorithm>
#include <array>

#include "app/panels/kit/style.h"
#include "knit/model/words.h"

namespace app {

namespace {

// Whether a tube is worked on stitches of that one, through tubes without rows too.
bool stands_on(const knit::TubePlan& plan, knit::TubeId id, knit::TubeId other) {
  const knit::TubeEvent& bottom = plan.event(plan.tube(id).bottom);
  if (bottom.kind == knit::EventKind::ring_cast_on) return false;
  return std::any_of(bottom.below.begin(), bottom.below.end(), [&](knit::TubeId below) {
    return below == other || (plan.tube(below).rows() == 0 && stands_on(plan, below, other));
  });
}

}  // namespace

std::vector<std::int32_t> yarns_of(const knit::TubePlan& plan) {
  std::vector<std::int32_t> yarns(plan.tubes.size(), -1);
  std::int32_t taken_up = 0;
  knit::TubeId before = -1;
  for (const knit::TubeId id : plan.order) {
    if (plan.tube(id).rows() == 0) continue;
    const bool goes_on = before >= 0 && stands_on(plan, id, before);
    yarns[static_cast<std::size_t>(id)] = goes_on ? yarns[static_cast<std::size_t>(before)] : taken_up++;
    before = id;
  }
  return yarns;
}

Colour yarn_colour(std::int32_t yarn) {
  constexpr std::array<std::size_t, 6> order{4, 2, 5, 6, 1, 3};
  if (yarn < 0) return theme().ring;
  return theme().labels[order[static_cast<std::size_t>(yarn) % order.size()]];
}

void draw_event_symbol(ImDrawList& list, knit::EventKind kind, ImVec2 at, float r, ImU32 colour,
                       ImU32 under) {
  switch (kind) {
    case knit::EventKind::cast_on:
      list.AddCircleFilled(at, r, colour);
      return;
    case knit::EventKind::split:
      list.AddTriangleFilled(ImVec2(at.x - r, at.y - r), ImVec2(at.x, at.y + r), ImVec2(at.x + r, at.y - r),
                             colour);
      return;
    case knit::EventKind::join:
      list.AddTriangleFilled(ImVec2(at.x - r, at.y + r), ImVec2(at.x + r, at.y + r), ImVec2(at.x, at.y - r),
                             colour);
      return;
    case knit::EventKind::bind_off:
      list.AddRectFilled(ImVec2(at.x - r, at.y - r), ImVec2(at.x + r, at.y + r), colour);
      return;
    case knit::EventKind::ring_cast_on:
    case knit::EventKind::ring_bind_off:
      list.AddCircleFilled(at, r, under);
      list.AddCircle(at, r, colour, 0, 0.5f * r);
      return;
  }
}

std::string names_of_tubes(std::span<const knit::TubeId> tubes) {
  std::string words;
  for (std::size_t i = 0; i < tubes.size(); ++i) {
    if (i > 0) words += i + 1 == tubes.size() ? " and " : ", ";
    words += knit::tube_name(tubes[i]);
  }
  return words;
}

std::string_view event_word(knit::EventKind kind) {
  switch (kind) {
    case knit::EventKind::cast_on:
      return "cast on";
    case knit::EventKind::split:
      return "split";
    case knit::EventKind::join:
      return "join";
    case knit::EventKind::bind_off:
      return "bind off";
    case knit::EventKind::ring_cast_on:
    case knit::EventKind::ring_bind_off:
      return "ring";
  }
  return "";
}

std::string event_words(const knit::TubePlan& plan, std::int32_t event) {
  const knit::TubeEvent& of = plan.event(event);
  const std::string below = names_of_tubes(of.below);
  const std::string above = names_of_tubes(of.above);
  const std::string at = " at " + knit::vertex_text(of.vertex) + ".";
  switch (of.kind) {
    case knit::EventKind::cast_on:
      return "Tube " + above + " begins" + at;
    case knit::EventKind::split:
      return "Tube " + below + " splits into " + above + at;
    case knit::EventKind::join:
      return "Tubes " + below + " join to " + above + at;
    case knit::EventKind::bind_off:
      return "Tube " + below + " ends" + at;
    case knit::EventKind::ring_cast_on:
      return "A ring: tubes " + above + " start from one edge, around " + knit::vertex_text(of.vertex) + ".";
    case knit::EventKind::ring_bind_off:
      return "A ring: tubes " + below + " end edge to edge, around " + knit::vertex_text(of.vertex) + ".";
  }
  return "";
}

}  // namespace app
