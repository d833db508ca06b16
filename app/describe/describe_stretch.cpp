#include "app/describe/describe_stretch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr float even_px = 1.6F;       // wide, of an edge at ease
constexpr float stretched_px = 2.2F;  // and so much more of one that is not
constexpr float move_px = 1.2F;
constexpr double least_move = 0.03;  // in w

// Whether the place shown is within the stage that moves what is shown; its last step is, too.
bool is_within(const Session& session, knit::Stage stage) {
  const knit::Step* step = last_step(session);
  return session.document->timeline.state().stage() == stage ||
         (step != nullptr && step->place.stage == stage);
}

bool in_the_air(const Session& session) { return positions_shown(session) == Positions::relaxed; }

bool may_show(const Session& session) {
  const bool air = in_the_air(session);
  if (!air && !has_settled(session)) return false;
  return is_within(session, air ? knit::Stage::relax : knit::Stage::settle) ||
         !session.view->shows(Layer::faces);
}

}  // namespace

std::optional<StretchScale> stretch_shown(const Session& session) {
  if (!session.view->shows(Layer::stretch) || !may_show(session)) return std::nullopt;
  const knit::StitchSize& stitch = session.document->timeline.parameters().stitch;
  return StretchScale{stitch.width, stitch.height, in_the_air(session) ? full_in_the_air : full_stretch};
}

bool moves_shown(const Session& session) { return session.view->shows(Layer::moves) && may_show(session); }

void colour_by_stretch(const Theme& theme, double length, double full, std::vector<Line>& lines) {
  for (Line& line : lines) {
    const double strain = strain_of(static_cast<double>(glm::distance(line.from, line.to)) / length, full);
    line.colour = strain_colour(theme, strain);
    line.width_px = even_px + stretched_px * static_cast<float>(std::abs(strain));
  }
}

void make_plain(const Theme& theme, FaceShape& shape) {
  for (FaceShape::Face& face : shape.faces) face.colour = theme.ground;
}

void describe_moves(const Session& session, Scene& scene) {
  if (!moves_shown(session)) return;
  const knit::State& state = session.document->timeline.state();
  const std::vector<glm::dvec3> settled = knit::knitting_path(state.fabric);
  const auto relaxed = in_the_air(session) ? knit::relaxed_places(state) : nullptr;
  const std::vector<glm::dvec3>& from = relaxed ? settled : *state.placed;
  const std::vector<glm::dvec3>& to = relaxed ? *relaxed : settled;
  const double least = least_move * session.document->timeline.parameters().stitch.width;
  const auto every = static_cast<std::size_t>(scene.coarse);
  const Colour colour = scene.theme->accepted;
  for (std::size_t i = 0; i < std::min(from.size(), to.size()); i += every) {
    if (glm::distance(from[i], to[i]) < least) continue;
    scene.lines.push_back({glm::vec3(from[i]), glm::vec3(to[i]), colour, move_px});
  }
}

}  // namespace app
