#include "app/core/describe_selected.h"

#include "app/core/describe_band.h"
#include "app/core/palette.h"
#include "app/core/thing_places.h"
#include "app/core/why_words.h"
#include "knit/narrate.h"
#include "knit/rows.h"

namespace app {

namespace {

// Brighter where it is there already, faint where it is still to come.
struct Light {
  Colour colour;
  float width_px, diameter_px;
};

void light_up(const std::vector<glm::dvec3>& outline, const Light& light, Scene& scene) {
  const std::size_t n = outline.size();
  if (n == 1) scene.points.push_back({glm::vec3(outline[0]), light.colour, light.diameter_px});
  const std::size_t sides = n == 2 ? 1 : n > 2 ? n : 0;
  for (std::size_t i = 0; i < sides; ++i) {
    scene.lines.push_back(
        {glm::vec3(outline[i]), glm::vec3(outline[(i + 1) % n]), light.colour, light.width_px});
  }
}

// The anchor that refused or took the vertex, the way to it and the band; gives the caption's words. Nothing is
// added where no anchor measured it; the step at hand writes its own distance.
std::string describe_measuring(const Session& session, const knit::VertexThing& thing, Scene& scene) {
  std::string name = words_of(thing);
  const knit::Timeline& timeline = *session.timeline;
  const knit::VertexStory story = knit::story_of(timeline, thing.vertex);
  if (!story.decided || story.measured.empty() || *story.decided != story.measured.back()) return name;
  const knit::Step& step = timeline.step(*story.decided);
  const auto* measured = std::get_if<knit::CandidateMeasured>(&step.what);
  const auto* missed = std::get_if<knit::BandMissed>(&step.what);
  if (measured == nullptr && missed == nullptr) return name;
  const knit::VertexId anchor = measured != nullptr ? measured->anchor : missed->anchor;
  const double distance = measured != nullptr ? measured->distance : missed->distance;
  const auto& positions = timeline.input().mesh.positions;
  const glm::vec3 from(positions[anchor]);
  const glm::vec3 to(positions[thing.vertex]);
  if (session.shows(Layer::band))
    scene.band = band_around(session, anchor, timeline.parameters_of_step(*story.decided), scene);
  scene.points.push_back({from, scene.theme->anchor, 10.0F});
  if (timeline.position() == *story.decided + 1 && session.shows(Layer::cycle)) return "";
  if (anchor == thing.vertex) return name;
  scene.lines.push_back({from, to, scene.theme->selected, 3.0F});
  return name + ": " + knit::short_number(distance);
}

}  // namespace

void describe_selected(const Session& session, Scene& scene) {
  const auto& selected = session.travel.selected;
  if (!selected) return;
  const knit::Timeline& timeline = *session.timeline;
  const auto* vertex = std::get_if<knit::VertexThing>(&*selected);
  if (vertex != nullptr && vertex->vertex >= timeline.input().mesh.positions.size()) return;
  std::vector<glm::dvec3> outline = outline_of(timeline.input(), timeline.state(), *selected);
  const bool there = !outline.empty();
  if (!there) outline = outline_of(timeline.input(), timeline.furthest(), *selected);
  if (outline.empty()) return;
  const Colour faint = with_alpha(scene.theme->selected, 110);
  light_up(outline, there ? Light{scene.theme->selected, 5.0F, 13.0F} : Light{faint, 2.5F, 9.0F}, scene);
  const std::string words =
      vertex != nullptr ? describe_measuring(session, *vertex, scene) : words_of(*selected);
  if (words.empty()) return;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& point : outline) middle += point / static_cast<double>(outline.size());
  scene.captions.push_back({glm::vec3(middle), words, there ? scene.theme->selected : faint});
}

}  // namespace app
