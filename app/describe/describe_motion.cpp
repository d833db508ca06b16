#include "app/describe/describe_motion.h"

#include <cmath>

#include "app/describe/thing_places.h"
#include "app/session/document.h"
#include "app/session/program.h"

namespace app {

namespace {

struct PlaceOf {
  const Session& session;
  const knit::Place& place;
  using Result = std::optional<glm::vec3>;

  [[nodiscard]] Result vertex(knit::VertexId v) const {
    return glm::vec3(session.document->timeline.input().mesh.positions[v]);
  }
  [[nodiscard]] Result middle_of(const knit::Element& thing) const {
    const auto outline =
        outline_of(session.document->timeline.input(), session.document->timeline.state(), thing);
    if (outline.empty()) return std::nullopt;
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& point : outline) sum += point;
    return glm::vec3(sum / static_cast<double>(outline.size()));
  }

  Result operator()(const knit::VertexTimed& s) const { return vertex(s.vertex); }
  Result operator()(const knit::StitchCastOn& s) const {
    const auto places = stitch_places(session.document->timeline.state(), place.row);
    if (!places.empty()) return glm::vec3(places.back());
    const auto* work = std::get_if<knit::CastOnWork>(&session.document->timeline.state().work);
    if (work == nullptr || work->stitches.empty()) return std::nullopt;
    return glm::vec3(work->stitches[static_cast<std::size_t>(s.stitch - 1) % work->stitches.size()].position);
  }
  Result operator()(const knit::CandidateMeasured& s) const { return vertex(s.candidate); }
  Result operator()(const knit::BandMissed& s) const { return vertex(s.taken); }
  Result operator()(const knit::StitchPlaced& s) const {
    return middle_of(knit::StitchElement{place.row, s.stitch - 1});
  }
  Result operator()(const knit::NodeFound& s) const { return vertex(s.vertex); }
  Result operator()(const knit::TubeLeftOut& s) const { return vertex(s.vertex); }
  Result operator()(const knit::GapsFound& s) const { return vertex(s.vertex); }
  // Of a deal in progress, which comes after those that are done.
  Result operator()(const knit::BridgeCastOn& s) const {
    const auto done = static_cast<std::int32_t>(session.document->timeline.state().fabric.deals().size());
    return middle_of(knit::StitchElement{knit::bridge_row(done + 1), s.stitch - 1});
  }
  Result operator()(const knit::MainPlaced& s) const {
    return middle_of(knit::LabelElement{place.row, s.cell});
  }
  Result operator()(const knit::ShapingPlaced& s) const {
    return middle_of(knit::LabelElement{place.row, s.cell});
  }
  Result operator()(const knit::FaceMade& s) const {
    return middle_of(knit::FaceElement{place.row, s.index - 1});
  }
  template <class Other>
  Result operator()(const Other& /*other*/) const {
    return std::nullopt;
  }
};

}  // namespace

std::optional<glm::vec3> place_of_step(const Session& session, const knit::Step& step) {
  return knit::visit_event(PlaceOf{session, step.place}, step.what);
}

void describe_motion(const Session& session, double appeared, Scene& scene) {
  if (appeared >= 1.0 || !session.program->preferences.motion) return;
  const knit::Step* step = last_step(session);
  const auto at = step != nullptr ? place_of_step(session, *step) : std::nullopt;
  if (!at) return;
  const double left = std::pow(1.0 - appeared, 2.0);
  const auto alpha = static_cast<std::uint8_t>(std::lround(40.0 + 120.0 * (1.0 - left)));
  scene.points.push_back(
      {*at, with_alpha(scene.theme->anchor, alpha), static_cast<float>(10.0 + 34.0 * left)});
}

}  // namespace app
