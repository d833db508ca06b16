#include "app/core/describe_meant.h"

#include <algorithm>

#include "app/core/palette.h"

namespace app {

namespace {

struct RoundLook {
  Colour colour;
  float width_px;
};

const knit::Row* row_at(const Session& session, std::int32_t number) {
  for (const knit::State* state : {&session.timeline->state(), &session.timeline->furthest()}) {
    const bool there = number >= 1 && static_cast<std::size_t>(number) <= state->rows.size();
    if (there) return &*state->rows[static_cast<std::size_t>(number) - 1];
  }
  return nullptr;
}

void describe_round(const knit::Row& row, const RoundLook& look, Scene& scene) {
  for (std::size_t i = 0; i < row.stitches.size(); ++i) {
    const glm::vec3 from(row.stitches[i].position);
    const glm::vec3 to(row.stitches[(i + 1) % row.stitches.size()].position);
    scene.lines.push_back({from, to, look.colour, look.width_px});
  }
}

void describe_stitch(const knit::Row& row, std::size_t stitch, Scene& scene) {
  const glm::vec3 at(row.stitches[stitch].position);
  scene.points.push_back({at, scene.theme->accepted, 12.0F});
  scene.captions.push_back({at,
                            "row " + std::to_string(row.number) + ", stitch " + std::to_string(stitch + 1),
                            scene.theme->accepted});
}

}  // namespace

void describe_meant(const Session& session, Scene& scene) {
  if (const knit::Row* row = session.knit_along ? row_at(session, *session.knit_along) : nullptr)
    describe_round(*row, {scene.theme->anchor, 5.0F}, scene);
  if (const auto& rounds = session.hovered_rounds) {
    const auto rows = static_cast<std::int32_t>(
        std::max(session.timeline->state().rows.size(), session.timeline->furthest().rows.size()));
    for (std::int32_t number = std::max(1, rounds->first); number <= std::min(rounds->last, rows); ++number)
      describe_round(*row_at(session, number), {scene.theme->accepted, 3.5F}, scene);
  }
  const auto& at = session.hovered_stitch;
  const knit::Row* row = at ? row_at(session, at->row) : nullptr;
  if (row == nullptr || at->stitch < 0) return;
  const auto stitch = static_cast<std::size_t>(at->stitch);
  if (stitch < row->stitches.size()) describe_stitch(*row, stitch, scene);
}

}  // namespace app
