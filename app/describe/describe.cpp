#include "app/describe/describe.h"

#include <algorithm>
#include <cmath>

#include "app/describe/describe_contours.h"
#include "app/describe/describe_current_row.h"
#include "app/describe/describe_ends.h"
#include "app/describe/describe_motion.h"
#include "app/describe/describe_quantity.h"
#include "app/describe/describe_selected.h"
#include "app/describe/describe_step.h"
#include "app/describe/describe_symbols.h"
#include "app/describe/describe_tubes.h"
#include "app/describe/describe_variable.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/pins.h"
#include "app/session/program.h"
#include "app/session/shown.h"
#include "app/session/view.h"

namespace app {

namespace {

// `finished`: all rows are there, and those on the needle are bound off.
Colour stitch_colour(const Theme& theme, const knit::Fabric& fabric, const knit::Row& row, bool finished) {
  const bool cast = row.on.empty() || (finished && fabric.is_live(row.id));
  return cast ? theme.of(knit::Label::cast) : theme.stitch;
}

std::vector<Line> edges_of(const knit::Row& row, Colour colour) {
  std::vector<Line> lines;
  lines.reserve(row.stitches.size());
  for (const auto& [from, to] : knit::edges_of(row)) {
    lines.push_back(
        {glm::vec3(row.stitches[from].position), glm::vec3(row.stitches[to].position), colour, 1.8F});
  }
  return lines;
}

std::shared_ptr<const std::vector<Point>> stitches_of(const knit::Row& row, Colour colour,
                                                      float diameter_px) {
  std::vector<Point> points;
  points.reserve(row.stitches.size());
  for (const knit::Stitch& stitch : row.stitches)
    points.push_back({glm::vec3(stitch.position), colour, diameter_px});
  return std::make_shared<const std::vector<Point>>(std::move(points));
}

// A row is being picked, placed or labelled: it shall be the one bright thing.
bool in_the_making(const knit::State& state) {
  return std::holds_alternative<knit::RowWork>(state.work) ||
         std::holds_alternative<knit::ContourWork>(state.work) ||
         std::holds_alternative<knit::IndexWork>(state.work);
}

}  // namespace

// Shapes have their colours in them.
void Describer::take_look(const Session& session, const Theme& theme) {
  const auto stretch = session.document ? stretch_shown(session) : std::nullopt;
  if (theme_ == &theme && stretch_ == stretch) return;
  if (theme_ != &theme) ground_.forget_colours();
  theme_ = &theme;
  stretch_ = stretch;
  rows_.clear();
  strips_.clear();
}

// As it is shown. Where that is elsewhere than the fabric has them, each asking would make other rows, which a renderer has not yet.
const knit::Fabric& Describer::fabric_of(const Session& session) {
  const knit::State& state = session.document->timeline.state();
  const auto places = places_shown(session);
  if (!places) return state.fabric;
  if (placed_as_ != places) placed_ = shown_fabric(session);
  placed_as_ = places;
  return placed_;
}

void Describer::add_rows(const Session& session, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  const knit::Fabric& fabric = fabric_of(session);
  const auto& rows = fabric.rows();
  rows_.resize(std::max(rows_.size(), rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    RowShapes& kept = rows_[i];
    const auto row = rows[i].pointer();
    if (row->id <= rows_as_yarn_) continue;
    const bool ends_here = state.stage() > knit::Stage::rows;
    const Colour colour = stitch_colour(*scene.theme, fabric, *row, ends_here);
    if (kept.row != row || kept.colour != colour) {
      const Colour edge = colour == scene.theme->stitch ? scene.theme->row_edge : colour;
      std::vector<Line> edges = edges_of(*row, edge);
      if (stretch_) colour_by_stretch(*scene.theme, stretch_->width, stretch_->full, edges);
      kept = {
          row, colour, std::make_shared<const std::vector<Line>>(std::move(edges)),
          stretch_ ? stitches_of(*row, scene.theme->stretch_even, 2.4F) : stitches_of(*row, colour, 3.2F)};
    }
    if (session.view->shows(Layer::row_edges)) scene.line_sets.push_back(kept.edges);
    if (session.view->shows(Layer::stitches)) scene.point_sets.push_back(kept.stitches);
  }
}

void Describer::add_strips(const Session& session, Scene& scene) {
  const knit::Fabric& fabric = fabric_of(session);
  const knit::KnittingPath path(fabric);
  const auto& strips = fabric.strips();
  strips_.resize(std::max(strips_.size(), strips.size()));
  for (std::size_t i = 0; i < strips.size(); ++i) {
    StripShapes& kept = strips_[i];
    const auto strip = strips[i].pointer();
    auto about = fabric.products_about(strip->to);
    if (kept.strip != strip || kept.about != about) {
      FaceShape faces = faces_of(*scene.theme, *strip, strip->faces.size(), path);
      std::vector<Line> columns = columns_of(*scene.theme, *strip, strip->column_edges.size(), path);
      if (stretch_) {
        make_plain(*scene.theme, faces);
        colour_by_stretch(*scene.theme, stretch_->height, stretch_->full, columns);
      }
      kept = {strip, std::move(about), std::make_shared<const FaceShape>(std::move(faces)),
              std::make_shared<const std::vector<Line>>(std::move(columns))};
    }
    if (session.view->shows(Layer::faces)) scene.faces.push_back(kept.faces);
    if (session.view->shows(Layer::column_edges)) scene.line_sets.push_back(kept.columns);
  }
}

namespace {

// From the first row to the last that a finished strip reaches.
std::optional<TimeSpan> covered_by_faces(const Session& session, knit::RowId as_yarn, const Scene& scene) {
  const knit::Fabric& fabric = session.document->timeline.state().fabric;
  const bool faces = session.view->shows(Layer::faces) && !fabric.strips().empty();
  if ((!faces && as_yarn == 0) || scene.unfinished) return std::nullopt;
  const bool all = session.document->timeline.state().stage() > knit::Stage::faces;
  TimeSpan span{static_cast<float>(fabric.row(1).time), static_cast<float>(fabric.row(1).time)};
  const knit::RowId last = all ? fabric.row_count() : as_yarn > 0 ? as_yarn : fabric.strips().back()->to;
  for (knit::RowId id = 1; id <= last; ++id) {
    span.from = std::min(span.from, static_cast<float>(fabric.row(id).time));
    span.to = std::max(span.to, static_cast<float>(fabric.row(id).time));
  }
  return span;
}

}  // namespace

// Where tubes stand beside each other the times of one say nothing of the others.
void Describer::describe_covered(const Session& session, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  scene.covered = covered_by_faces(session, rows_as_yarn_, scene);
  if (!scene.covered || state.fabric.deals().empty()) return;
  scene.covered.reset();
  if (state.stage() <= knit::Stage::faces || !state.graph || !state.tubes) return;
  scene.covered_by = ends_.get(state.tubes.pointer(), false, [&] {
    return std::make_shared<const std::vector<float>>(
        ends_of(session.document->timeline.input(), *state.graph, *state.tubes));
  });
  scene.covered = TimeSpan{between_ends, between_ends};
}

Scene Describer::describe(const Session& session, const Showing& showing) {
  Scene scene;
  scene.theme = &theme_of(session.program->preferences.theme);
  take_look(session, *scene.theme);
  scene.background = scene.theme->background;
  scene.ground = scene.theme->ground;
  scene.time_low = scene.theme->time_low;
  scene.time_middle = scene.theme->time_middle;
  scene.time_high = scene.theme->time_high;
  scene.view = session.view->gaze.camera.view(session.view->aspect);
  if (session.view->checking && session.view->checker) {
    checked_.describe(*session.view->checker, session.view->aspect, scene);
    return scene;
  }
  if (!session.document) return scene;

  const knit::State& state = session.document->timeline.state();
  ground_.describe(session, showing.in_pieces, scene);
  scene.coarse = coarseness(session, showing.height_px);
  rows_as_yarn_ = 0;
  scene.calm = in_the_making(state);
  if (scene.coarse > 1) {
    coarse_.describe(session, fabric_of(session), {scene.coarse, stretch_}, showing.in_pieces, scene);
  } else {
    rows_as_yarn_ = yarn_.describe(session, fabric_of(session), scene);
    add_rows(session, scene);
    if (!scene.yarn) add_strips(session, scene);
    if (scene.yarn && state.stage() > knit::Stage::faces) scene.show_surface = false;
  }
  describe_covered(session, scene);
  describe_tubes(session, scene);
  if (!shows_both(session)) ghost_.describe(session, scene);  // it stands beside it
  describe_current_row(session, scene);
  describe_step(session, scene);
  describe_quantity(session, scene);
  describe_moves(session, scene);
  if (!scene.yarn) symbols_.describe(session, showing.height_px, scene);
  describe_sized(session, scene);
  describe_selected(session, scene);
  describe_variable(session, scene);
  describe_motion(session, showing.appeared, scene);
  return scene;
}

}  // namespace app
