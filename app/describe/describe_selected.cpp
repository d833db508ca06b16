#include "app/describe/describe_selected.h"

#include <algorithm>
#include <span>

#include "app/describe/describe_step.h"
#include "app/describe/state_shown.h"
#include "app/describe/thing_places.h"
#include "app/explain/why_words.h"
#include "app/lessons/lesson.h"
#include "app/lessons/predict.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/rows/rows.h"

namespace app {

namespace {

// Brighter where it is there already, faint where it is still to come.
struct Glow {
  Colour colour;
  float width_px, diameter_px;
};

void light_up(std::span<const glm::dvec3> outline, const Glow& light, Scene& scene) {
  const std::size_t n = outline.size();
  if (n == 1) scene.points.push_back({glm::vec3(outline[0]), light.colour, light.diameter_px});
  const std::size_t sides = n == 2 ? 1 : n > 2 ? n : 0;
  for (std::size_t i = 0; i < sides; ++i) {
    scene.lines.push_back(
        {glm::vec3(outline[i]), glm::vec3(outline[(i + 1) % n]), light.colour, light.width_px});
  }
}

// The anchor that refused or took the vertex, the way to it and the band; gives the caption's words. Nothing is
// added where no anchor measured it; the current step writes its own distance.
std::string describe_measuring(const Session& session, const knit::VertexElement& thing, Scene& scene) {
  std::string name = words_of(thing);
  const knit::Timeline& timeline = session.document->timeline;
  const knit::VertexStory story = knit::story_of(timeline, thing.vertex);
  if (!story.decided || story.measured.empty() || *story.decided != story.measured.back()) return name;
  const knit::Step& step = timeline.step(*story.decided);
  const auto* measured = knit::get_if<knit::CandidateMeasured>(step);
  const auto* missed = knit::get_if<knit::BandMissed>(step);
  if (measured == nullptr && missed == nullptr) return name;
  const knit::VertexId anchor = measured != nullptr ? measured->anchor : missed->anchor;
  const double distance = measured != nullptr ? measured->distance : missed->distance;
  const auto& positions = timeline.input().mesh.positions;
  const glm::vec3 from(positions[anchor]);
  const glm::vec3 to(positions[thing.vertex]);
  if (session.view->shows(Layer::band))
    scene.band = band_around(session, anchor, timeline.parameters_of_step(*story.decided), scene);
  scene.points.push_back({from, scene.theme->anchor, 10.0F});
  if (timeline.position() == *story.decided + 1 && session.view->shows(Layer::cycle)) return "";
  if (anchor == thing.vertex) return name;
  scene.lines.push_back({from, to, scene.theme->selected, 3.0F});
  return name + ": " + knit::short_number(distance);
}

}  // namespace

void describe_sized(const Session& session, Scene& scene) {
  const auto& range = session.document->travel.sized;
  if (!range) return;
  const knit::StitchSize& stitch = session.document->timeline.parameters().stitch;
  for (const knit::SizedThing& thing : knit::things_of_size(*StateShown(session), stitch, *range))
    light_up(thing.outline(), {scene.theme->selected, 4.0F, 0.0F}, scene);
}

void describe_selected(const Session& session, Scene& scene) {
  const auto& selected = session.document->travel.selected;
  if (!selected) return;
  const knit::Timeline& timeline = session.document->timeline;
  const auto* vertex = std::get_if<knit::VertexElement>(&*selected);
  if (vertex != nullptr && vertex->vertex >= timeline.input().mesh.positions.size()) return;
  std::vector<glm::dvec3> outline = outline_of(timeline.input(), *StateShown(session), *selected);
  const bool there = !outline.empty();
  if (!there) outline = outline_of(timeline.input(), timeline.furthest(), *selected);
  if (outline.empty()) return;
  const Colour faint = with_alpha(scene.theme->selected, 110);
  light_up(outline, there ? Glow{scene.theme->selected, 5.0F, 13.0F} : Glow{faint, 2.5F, 9.0F}, scene);
  const std::string words =
      vertex != nullptr ? describe_measuring(session, *vertex, scene) : words_of(*selected);
  if (words.empty()) return;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& point : outline) middle += point / static_cast<double>(outline.size());
  scene.captions.push_back({glm::vec3(middle), words, there ? scene.theme->selected : faint});
}

namespace {

void describe_vertex(const Session& session, const AskedVertex& asked, Scene& scene) {
  const auto& positions = session.document->timeline.input().mesh.positions;
  const glm::vec3 from(positions[asked.anchor]);
  const glm::vec3 to(positions[asked.candidate]);
  const Colour colour = scene.theme->selected;
  if (asked.anchor != asked.candidate) scene.lines.push_back({from, to, with_alpha(colour, 150), 2.0F});
  scene.points.push_back({to, colour, 12.0F});
  scene.captions.push_back({to, "?", colour});
}

// A row that is not made yet at this place of the run stands where it is going to be.
void describe_lit_row(const Session& session, std::int32_t row, Scene& scene) {
  auto places = stitch_places(*StateShown(session), row);
  if (places.size() < 3) places = stitch_places(session.document->timeline.furthest(), row);
  for (const auto& [from, to] : knit::Edges(places.size(), true))
    scene.lines.push_back({glm::vec3(places[from]), glm::vec3(places[to]), scene.theme->selected, 3.5F});
}

}  // namespace

void describe_asked(const Session& session, Scene& scene) {
  if (const auto asked = asked_vertex(session)) describe_vertex(session, *asked, scene);
  const LessonPage* page = session.learning->lesson ? session.learning->lesson->shown() : nullptr;
  if (page == nullptr) return;
  for (const Light& light : page->lights) {
    if (light.row > 0) describe_lit_row(session, light.row, scene);
  }
}

namespace {

struct RoundLook {
  Colour colour;
  float width_px;
};

// `shown`: of the session.
const knit::Row* row_at(const Session& session, const knit::State& shown, std::int32_t number) {
  for (const knit::State* state : {&shown, &session.document->timeline.furthest()}) {
    if (const knit::Row* row = state->fabric.find_row(number)) return row;
  }
  return nullptr;
}

void describe_round(const knit::Row& row, const RoundLook& look, Scene& scene) {
  for (const auto& [from, to] : knit::edges_of(row)) {
    scene.lines.push_back({glm::vec3(row.stitches[from].position), glm::vec3(row.stitches[to].position),
                           look.colour, look.width_px});
  }
}

void describe_stitch(const knit::Row& row, std::size_t stitch, Scene& scene) {
  const glm::vec3 at(row.stitches[stitch].position);
  scene.points.push_back({at, scene.theme->accepted, 12.0F});
  scene.captions.push_back({at, "row " + std::to_string(row.id) + ", stitch " + std::to_string(stitch + 1),
                            scene.theme->accepted});
}

}  // namespace

void describe_meant(const Session& session, Scene& scene) {
  const StateShown shown(session);
  if (const knit::Row* row =
          session.view->gaze.knit_along ? row_at(session, *shown, *session.view->gaze.knit_along) : nullptr)
    describe_round(*row, {scene.theme->anchor, 5.0F}, scene);
  const Gaze& gaze = session.view->gaze;
  std::vector<RoundSpan> spans = gaze.hovered_twins;
  if (gaze.hovered_rounds) spans.insert(spans.begin(), *gaze.hovered_rounds);
  const knit::RowId rows =
      std::max(shown->fabric.row_count(), session.document->timeline.furthest().fabric.row_count());
  for (const RoundSpan& span : spans) {
    for (std::int32_t number = std::max(1, span.first); number <= std::min(span.last, rows); ++number)
      describe_round(*row_at(session, *shown, number), {scene.theme->accepted, 3.5F}, scene);
  }
  std::vector<StitchAt> stitches = gaze.hovered_twin_stitches;
  if (gaze.hovered_stitch) stitches.insert(stitches.begin(), *gaze.hovered_stitch);
  for (const StitchAt& at : stitches) {
    const knit::Row* row = row_at(session, *shown, at.row);
    if (row == nullptr || at.stitch < 0) continue;
    const auto stitch = static_cast<std::size_t>(at.stitch);
    if (stitch < row->stitches.size()) describe_stitch(*row, stitch, scene);
  }
}

}  // namespace app
