#include "app/core/describe_band.h"

#include "app/core/predict.h"
#include "knit/rows.h"

namespace app {

Band band_around(const Session& session, knit::VertexId anchor, const knit::Parameters& parameters,
                 const Scene& scene) {
  const knit::Band reach = knit::band_of(parameters);
  Band band;
  band.centre = glm::vec3(session.timeline->input().mesh.positions[anchor]);
  band.inner = static_cast<float>(reach.low);
  band.middle = static_cast<float>(parameters.stitch_width);
  band.outer = static_cast<float>(reach.high);
  band.colour = scene.theme->band;
  if (scene.mesh && anchor < scene.mesh->normals.size()) band.normal = scene.mesh->normals[anchor];
  return band;
}

knit::VertexId anchor_shown(const Session& session, knit::VertexId of_walk) {
  if (const auto asked = asked_vertex(session)) return asked->anchor;
  const knit::Step* step = last_step(session);
  if (step == nullptr) return of_walk;
  if (const auto* measured = std::get_if<knit::CandidateMeasured>(&step->what)) return measured->anchor;
  if (const auto* missed = std::get_if<knit::BandMissed>(&step->what)) return missed->anchor;
  return of_walk;
}

}  // namespace app
