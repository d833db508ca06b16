#include "app/core/describe_asked.h"

#include "app/core/lesson.h"
#include "app/core/predict.h"
#include "app/core/thing_places.h"

namespace app {

namespace {

void describe_vertex(const Session& session, const AskedVertex& asked, Scene& scene) {
  const auto& positions = session.timeline->input().mesh.positions;
  const glm::vec3 from(positions[asked.anchor]);
  const glm::vec3 to(positions[asked.candidate]);
  const Colour colour = scene.theme->selected;
  if (asked.anchor != asked.candidate) scene.lines.push_back({from, to, with_alpha(colour, 150), 2.0F});
  scene.points.push_back({to, colour, 12.0F});
  scene.captions.push_back({to, "?", colour});
}

// A row that is not made yet at this place of the run stands where it is going to be.
void describe_lit_row(const Session& session, std::int32_t row, Scene& scene) {
  auto places = stitch_places(session.timeline->state(), row);
  if (places.size() < 3) places = stitch_places(session.timeline->furthest(), row);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::vec3 from(places[i]);
    const glm::vec3 to(places[(i + 1) % places.size()]);
    scene.lines.push_back({from, to, scene.theme->selected, 3.5F});
  }
}

}  // namespace

void describe_asked(const Session& session, Scene& scene) {
  if (const auto asked = asked_vertex(session)) describe_vertex(session, *asked, scene);
  const LessonPage* page = session.lesson ? session.lesson->shown() : nullptr;
  if (page == nullptr) return;
  for (const Light& light : page->lights) {
    if (light.row > 0) describe_lit_row(session, light.row, scene);
  }
}

}  // namespace app
