#include "app/describe/describe_step.h"

#include <glm/geometric.hpp>

#include "app/describe/describe_contours.h"
#include "app/describe/describe_selected.h"
#include "app/lessons/predict.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/rows/rows.h"
#include "knit/stitches/faces.h"

namespace app {

namespace {

glm::vec3 place_of(const Session& session, knit::VertexId vertex) {
  return glm::vec3(session.document->timeline.input().mesh.positions[vertex]);
}

// The row in the making, before it is closed: what has been kept, the anchor, and the verdicts since.
void describe_walk(const Session& session, const knit::RowWork& work, Scene& scene) {
  const knit::Ring& ring = *work.ring;
  const auto place = [&](std::int32_t order) {
    return place_of(session, ring.vertices[static_cast<std::size_t>(order)]);
  };
  const auto size = static_cast<std::int32_t>(ring.vertices.size());
  if (session.view->shows(Layer::cycle)) {
    for (std::int32_t order = 0; order < size; ++order) {
      const bool measured = order < work.walk.next;
      scene.points.push_back(
          {place(order), measured ? scene.theme->too_near : scene.theme->ring, measured ? 3.5F : 4.5F});
    }
  }
  const std::vector<std::int32_t>& kept = work.walk.kept;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const std::int32_t next = i + 1 < kept.size() ? kept[i + 1] : work.walk.anchor;
    if (session.view->shows(Layer::row_edges))
      scene.lines.push_back({place(kept[i]), place(next), scene.theme->row_edge, 2.4F});
    if (session.view->shows(Layer::stitches))
      scene.points.push_back({place(kept[i]), scene.theme->stitch, 7.0F});
  }
  if (session.view->shows(Layer::band)) {
    const knit::VertexId anchor =
        anchor_shown(session, ring.vertices[static_cast<std::size_t>(work.walk.anchor)]);
    scene.band = band_around(session, anchor, session.document->timeline.parameters(), scene);
    scene.points.push_back({scene.band->centre, scene.theme->anchor, 10.0F});
  }
}

Colour colour_of(const Theme& theme, knit::Verdict verdict) {
  switch (verdict) {
    case knit::Verdict::too_near:
      return theme.ring;
    case knit::Verdict::accepted:
      return theme.accepted;
    case knit::Verdict::too_far:
      return theme.too_far;
  }
  return theme.ring;
}

// A measured distance: a line between the two with its number.
void describe_distance(const Session& session, Scene& scene, knit::VertexId from, knit::VertexId to,
                       double distance, Colour colour) {
  const glm::vec3 a = place_of(session, from);
  const glm::vec3 b = place_of(session, to);
  scene.lines.push_back({a, b, colour, 3.0F});
  scene.points.push_back({b, colour, 9.0F});
  if (from != to) scene.captions.push_back({a, knit::short_number(distance), colour, b});
}

void describe_ends(const Session& session, const knit::EndsFound& ends, Scene& scene) {
  const glm::vec3 from = place_of(session, ends.start);
  const glm::vec3 to = place_of(session, ends.end);
  scene.lines.push_back({from, to, scene.theme->anchor, 2.5F});
  scene.points.push_back({from, scene.theme->time_low, 12.0F});
  scene.points.push_back({to, scene.theme->time_high, 12.0F});
  scene.captions.push_back({from, "start", scene.theme->text});
  scene.captions.push_back({to, "end", scene.theme->text});
}

void describe_last_label(const Session& session, std::int32_t row, std::int32_t cell, knit::Label label,
                         Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  const knit::LiveStitches cells = state.fabric.larger(*knit::planned_join(state, row));
  const glm::vec3 at(state.fabric.position(cells.at(cell)));
  scene.points.push_back({at, scene.theme->of(label), 13.0F});
  scene.captions.push_back({at, std::string(knit::name_of(label)), scene.theme->of(label)});
}

// `index`: counted from 1 in its strip, which may be finished by now.
void describe_last_face(const Session& session, std::int32_t row, std::int32_t index, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  const knit::Strip& strip = *knit::planned_strip(state, row);
  const knit::KnittingPath path(state.fabric);
  const knit::Face& face = strip.faces[static_cast<std::size_t>(index) - 1];
  for (const auto& [corner, next] : knit::Edges(static_cast<std::size_t>(face.corner_count), true)) {
    scene.lines.push_back({place_on(path, face.corners[corner]), place_on(path, face.corners[next]),
                           scene.theme->accepted, 3.0F});
  }
}

void describe_last_step(const Session& session, const knit::Step& step, Scene& scene) {
  if (const auto* measured = knit::get_if<knit::CandidateMeasured>(step)) {
    if (session.view->shows(Layer::cycle)) {
      describe_distance(session, scene, measured->anchor, measured->candidate, measured->distance,
                        colour_of(*scene.theme, measured->verdict));
    }
  } else if (const auto* missed = knit::get_if<knit::BandMissed>(step)) {
    if (session.view->shows(Layer::cycle)) {
      describe_distance(session, scene, missed->anchor, missed->taken, missed->distance,
                        scene.theme->problem);
    }
  } else if (const auto* timed = knit::get_if<knit::VertexTimed>(step)) {
    if (session.view->shows(Layer::times)) {
      scene.points.push_back({place_of(session, timed->vertex), scene.theme->accepted, 7.0F});
    }
  } else if (const auto* ends = knit::get_if<knit::EndsFound>(step)) {
    if (session.view->shows(Layer::times)) describe_ends(session, *ends, scene);
  } else if (const auto* main = knit::get_if<knit::MainPlaced>(step)) {
    if (session.view->shows(Layer::stitches))
      describe_last_label(session, step.place.row, main->cell, knit::Label::main, scene);
  } else if (const auto* shaping = knit::get_if<knit::ShapingPlaced>(step)) {
    if (session.view->shows(Layer::stitches))
      describe_last_label(session, step.place.row, shaping->cell, shaping->label, scene);
  } else if (const auto* made = knit::get_if<knit::FaceMade>(step)) {
    if (session.view->shows(Layer::faces)) describe_last_face(session, step.place.row, made->index, scene);
  }
}

void describe_cycle(const Session& session, std::span<const knit::VertexId> vertices, Scene& scene) {
  if (!session.view->shows(Layer::cycle)) return;
  for (const knit::VertexId v : vertices)
    scene.points.push_back({place_of(session, v), scene.theme->ring, 4.5F});
}

void describe_rows_stage(const Session& session, const knit::RowWork& work, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  switch (work.phase) {
    case knit::RowPhase::gather:
      return;
    case knit::RowPhase::order:
      describe_cycle(session, state.timing->levels.level(work.level), scene);
      return;
    case knit::RowPhase::measure:
    case knit::RowPhase::missed:
      describe_walk(session, work, scene);
      return;
    case knit::RowPhase::resample:
    case knit::RowPhase::share:
      break;
  }
  const auto& stitches = work.closed.stitches;
  for (const auto& [i, after] : knit::Edges(stitches.size(), true)) {
    const glm::vec3 at(stitches[i].position);
    const glm::vec3 next(stitches[after].position);
    const bool gap = after == 0;
    if (session.view->shows(Layer::stitches)) scene.points.push_back({at, scene.theme->stitch, 7.0F});
    if (!session.view->shows(Layer::row_edges)) continue;
    scene.lines.push_back({at, next, gap ? scene.theme->anchor : scene.theme->row_edge, gap ? 3.5F : 2.4F});
    if (gap)
      scene.captions.push_back(
          {0.5F * (at + next), knit::short_number(work.closed.gap), scene.theme->anchor});
  }
}

// Labels placed so far, as coloured stitches.
void describe_labels(const knit::State& state, const knit::Join& plan, std::size_t count, Scene& scene) {
  const knit::LiveStitches cells = state.fabric.larger(plan);
  for (std::size_t i = 0; i < count; ++i) {
    const knit::PlacedLabel& placed = plan.placed[i];
    const glm::vec3 at(state.fabric.position(cells.at(placed.cell)));
    scene.points.push_back({at, scene.theme->of(placed.label), 8.0F});
  }
}

void describe_stitches_stage(const Session& session, const knit::IndexWork& work, Scene& scene) {
  if (!session.view->shows(Layer::stitches)) return;
  const knit::State& state = session.document->timeline.state();
  for (const auto& join : state.fabric.joins()) {
    const bool plain = join->change() == 0;  // its mains merely go on
    if (!plain) describe_labels(state, *join, join->placed.size(), scene);
  }
  if (work.plan) describe_labels(state, *work.plan, static_cast<std::size_t>(work.placed), scene);
}

void describe_faces_stage(const Session& session, const knit::FacesWork& work, Scene& scene) {
  if (!work.plan) return;
  const knit::KnittingPath path(session.document->timeline.state().fabric);
  const auto made = static_cast<std::size_t>(work.made);
  if (session.view->shows(Layer::faces)) {
    scene.faces.push_back(std::make_shared<const FaceShape>(faces_of(*scene.theme, *work.plan, made, path)));
  }
  if (session.view->shows(Layer::column_edges)) {
    const std::vector<Line> columns = columns_of(*scene.theme, *work.plan, made, path);
    scene.lines.insert(scene.lines.end(), columns.begin(), columns.end());
  }
}

}  // namespace

FaceShape faces_of(const Theme& theme, const knit::Strip& strip, std::size_t count,
                   const knit::KnittingPath& path) {
  FaceShape shape;
  shape.faces.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const knit::Face& face = strip.faces[i];
    const glm::vec3 a = place_on(path, face.corners[0]);
    const glm::vec3 b = place_on(path, face.corners[1]);
    const glm::vec3 c = place_on(path, face.corners[2]);
    const bool quad = face.corner_count == 4;
    const glm::vec3 d = quad ? place_on(path, face.corners[3]) : c;
    const glm::vec3 across = glm::cross(c - a, quad ? d - b : c - b);
    const float length = glm::length(across);
    const glm::vec3 normal = length > 0.0F ? across / length : glm::vec3(0, 1, 0);
    shape.faces.push_back({{a, b, c, d}, normal, theme.of(face.label)});
  }
  return shape;
}

std::vector<Line> columns_of(const Theme& theme, const knit::Strip& strip, std::size_t count,
                             const knit::KnittingPath& path) {
  std::vector<Line> lines;
  lines.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [lower, upper] = strip.column_edges[i];
    lines.push_back({place_on(path, lower), place_on(path, upper), theme.column_edge, 1.3F});
  }
  return lines;
}

void describe_step(const Session& session, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  if (const auto* cast_on = std::get_if<knit::CastOnWork>(&state.work); cast_on != nullptr && cast_on->ring) {
    describe_cycle(session, cast_on->ring->vertices, scene);
    for (const knit::Stitch& stitch : cast_on->stitches) {
      if (!session.view->shows(Layer::stitches)) break;
      scene.points.push_back({glm::vec3(stitch.position), scene.theme->of(knit::Label::cast), 10.0F});
    }
  }
  describe_criticals(session, scene);
  if (const auto* contours = std::get_if<knit::ContourWork>(&state.work))
    describe_contours(session, *contours, scene);
  if (const auto* rows = std::get_if<knit::RowWork>(&state.work)) describe_rows_stage(session, *rows, scene);
  if (const auto* index = std::get_if<knit::IndexWork>(&state.work))
    describe_stitches_stage(session, *index, scene);
  if (const auto* faces = std::get_if<knit::FacesWork>(&state.work))
    describe_faces_stage(session, *faces, scene);
  if (const knit::Step* step = last_step(session)) describe_last_step(session, *step, scene);
  describe_meant(session, scene);
  describe_asked(session, scene);
}

Band band_around(const Session& session, knit::VertexId anchor, const knit::Parameters& parameters,
                 const Scene& scene) {
  const knit::Band reach = knit::band_of(parameters.rows, parameters.stitch);
  Band band;
  band.centre = glm::vec3(session.document->timeline.input().mesh.positions[anchor]);
  band.inner = static_cast<float>(reach.low);
  band.middle = static_cast<float>(parameters.stitch.width);
  band.outer = static_cast<float>(reach.high);
  band.colour = scene.theme->band;
  if (scene.mesh && anchor < scene.mesh->normals.size()) band.normal = scene.mesh->normals[anchor];
  return band;
}

knit::VertexId anchor_shown(const Session& session, knit::VertexId of_walk) {
  if (const auto asked = asked_vertex(session)) return asked->anchor;
  const knit::Step* step = last_step(session);
  if (step == nullptr) return of_walk;
  if (const auto* measured = knit::get_if<knit::CandidateMeasured>(*step)) return measured->anchor;
  if (const auto* missed = knit::get_if<knit::BandMissed>(*step)) return missed->anchor;
  return of_walk;
}

}  // namespace app
