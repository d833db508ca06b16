#include "app/yarn/yarn_shown.h"

#include <algorithm>

#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/yarn/loop_ends.h"

namespace app {

namespace {

constexpr double ground_below = 0.40;  // in stitch widths: behind all loops
constexpr float ground_share = 0.30F;  // of the yarn's light

std::uint8_t darker(std::uint8_t part) {
  return static_cast<std::uint8_t>(static_cast<float>(part) * ground_share);
}
Colour darker(Colour colour) { return {darker(colour.r), darker(colour.g), darker(colour.b)}; }

// Of the row in progress, those picked so far.
std::uint32_t picked(const knit::State& state) {
  const auto* work = std::get_if<knit::RowWork>(&state.work);
  return work != nullptr ? static_cast<std::uint32_t>(work->walk.kept.size()) : 0;
}

// Whether the rows of one are the first of the other.
bool begins_with(const knit::Fabric& all, const knit::Fabric& first) {
  if (first.rows().size() > all.rows().size()) return false;
  return std::equal(first.rows().begin(), first.rows().end(), all.rows().begin(),
                    [](const auto& a, const auto& b) {
                      return a->id == b->id && a->tube == b->tube && a->stitches.size() == b->stitches.size();
                    });
}

// The stitches before the first row that no face reaches.
YarnUpTo until_strips(const knit::Fabric& fabric, bool whole) {
  const auto stitches = static_cast<std::uint32_t>(fabric.stitch_count());
  if (whole) return {stitches, true};
  const knit::RowId after = fabric.strips().back()->to + 1;
  return {fabric.has_row(after) ? fabric.first_on_path(after) : stitches, false};
}

// More than are drawn together at an end leave it open.
bool has_openings(const knit::Fabric& fabric, const knit::YarnCounts& counts) {
  return counts.bound_off > 0 || std::any_of(fabric.rows().begin(), fabric.rows().end(), [](const auto& row) {
           return row->on.empty() && row->stitches.size() > knit::drawn_together;
         });
}

knit::RowId rows_before(const knit::Fabric& fabric, const YarnUpTo& until) {
  knit::RowId rows = 0;
  while (fabric.has_row(rows + 1) && (until.whole || fabric.first_on_path(rows + 1) < until.stitches)) ++rows;
  return rows;
}

}  // namespace

void YarnShown::make_yarn(const knit::Fabric& fabric, const YarnLook& look, Of of) {
  of_ = std::move(of);
  positions_ = knit::knitting_path(fabric);
  yarn_ = yarn_as_looked(fabric, positions_, of_.stitch, look);
  out_ = outwards(fabric, positions_);
  closed_ = !has_openings(fabric, yarn_.counts);
  shape_ = nullptr;
}

void YarnShown::make_shapes(const knit::Fabric& fabric, const Look& look) {
  look_ = look;
  YarnShape shape = yarn_shape(yarn_, look.until, out_,
                               yarn_colours(fabric, positions_, of_.stitch, look.look, *look.theme));
  shape.width = static_cast<float>(of_.stitch.width);
  shape.closed = closed_ && look.until.whole;
  const Colour behind = look.look.by == YarnColours::wool ? look.look.wool : look.theme->stretch_even;
  ground_ = std::make_shared<const FaceShape>(yarn_ground(fabric, positions_, look.until, out_,
                                                          static_cast<float>(ground_below * of_.stitch.width),
                                                          darker(behind)));
  shape_ = std::make_shared<const YarnShape>(std::move(shape));
}

knit::RowId YarnShown::describe(const Session& session, const knit::Fabric& shown, Scene& scene) {
  if (!session.view->shows(Layer::yarn)) return 0;
  const knit::Timeline& timeline = session.document->timeline;
  const knit::State& state = timeline.state();
  const knit::State& furthest = timeline.furthest();
  const bool ahead = state.stage() <= knit::Stage::faces && !state.fabric.empty() &&
                     furthest.stage() > knit::Stage::faces && begins_with(furthest.fabric, state.fabric);
  if (!ahead && shown.strips().empty()) return 0;
  const knit::Fabric placed = ahead ? knit::placed_fabric(furthest) : knit::Fabric();
  const knit::Fabric& fabric = ahead ? placed : shown;
  const YarnUpTo until =
      ahead ? YarnUpTo{static_cast<std::uint32_t>(state.fabric.stitch_count()) + picked(state), false}
            : until_strips(fabric, state.stage() > knit::Stage::faces);
  const YarnLook& yarn_look = session.view->yarn;
  Of of{{}, {}, timeline.parameters().stitch, yarn_look.radius, yarn_look.easing};
  if (ahead) {
    // A fabric of placed stitches is made anew by each asking: what it is made of tells it.
    for (const auto& row : furthest.fabric.rows()) of.rows.push_back(row.pointer());
  } else {
    for (const auto& row : fabric.rows()) of.rows.push_back(row.pointer());
  }
  for (const auto& strip : fabric.strips()) of.strips.push_back(strip.pointer());
  if (of != of_) make_yarn(fabric, yarn_look, std::move(of));
  const Look look{yarn_look, scene.theme, until};
  if (shape_ == nullptr || look != look_) make_shapes(fabric, look);
  scene.yarn = shape_;
  scene.faces.push_back(ground_);
  return rows_before(ahead ? state.fabric : fabric, until);
}

}  // namespace app
