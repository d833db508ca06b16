#include "app/describe/describe_current_row.h"

#include <cstdint>

#include "app/describe/state_shown.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr float lit_row_px = 3.6F;
constexpr std::uint8_t lit_row_alpha = 235;

}  // namespace

void describe_current_row(const Session& session, Scene& scene) {
  const knit::Timeline& timeline = session.document->timeline;
  if (timeline.position() == 0 || timeline.state().finished() || !session.view->shows(Layer::row_edges))
    return;
  const knit::Place place = timeline.place();
  if (place.stage <= knit::Stage::rows) return;
  const Colour colour = with_alpha(scene.theme->accepted, lit_row_alpha);
  const StateShown shown(session);
  const knit::Row* row = shown->fabric.find_row(place.row);
  if (row == nullptr) return;
  for (const auto& [from, to] : knit::edges_of(*row)) {
    scene.lines.push_back(
        {glm::vec3(row->stitches[from].position), glm::vec3(row->stitches[to].position), colour, lit_row_px});
  }
}

}  // namespace app
