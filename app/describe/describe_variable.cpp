#include "app/describe/describe_variable.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/describe/describe_contours.h"
#include "app/describe/describe_quantity.h"
#include "app/describe/describe_step.h"
#include "app/describe/state_shown.h"
#include "app/explain/code_variables.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/rows/ring.h"
#include "knit/rows/row_code.h"
#include "knit/rows/row_variables.h"
#include "knit/stitches/stitch_variables.h"
#include "knit/timing/timing_variables.h"
#include "knit/tubes/tubes_variables.h"

namespace app {

namespace var = knit::var;

namespace {

// What was measured last: by the step, or to come next by the walk.
struct Measured {
  knit::VertexId anchor = knit::no_vertex, candidate = knit::no_vertex;
  double distance = 0.0;
};

// One variable's light at one place of the run.
class VariableLight {
 public:
  VariableLight(const Session& session, const knit::CodeVariable& variable, const Explained& at, Scene& scene)
      : session_(session),
        variable_(variable),
        shown_(session),
        state_(*shown_),
        at_(at),
        scene_(scene),
        colour_(scene.theme->selected),
        row_(row_shown(state_, at.step != nullptr ? at.step->place.row : 0)) {}

  void timing();
  void row();
  void walk();
  void tubes();
  void tube_curves(const knit::Tube& tube);
  void deal(const knit::Deal& deal);
  void contour();
  void index();
  void strip();

 private:
  template <class Kind>
  [[nodiscard]] const Kind* step_as() const {
    return at_.step != nullptr ? knit::get_if<Kind>(*at_.step) : nullptr;
  }
  [[nodiscard]] glm::vec3 place(knit::VertexId vertex) const {
    return glm::vec3(session_.document->timeline.input().mesh.positions[vertex]);
  }
  [[nodiscard]] const knit::Parameters& parameters() const {
    return at_.stopped ? session_.document->timeline.parameters_of_stop() : parameters_of_last_step(session_);
  }
  [[nodiscard]] Measured measured() const;

  // What the step wrote makes room for it, and what is written at the same place.
  void caption(const glm::vec3& at, const std::string& words) {
    if (words.empty()) return;
    const auto in_the_way = [&](const Caption& other) {
      return other.position == at || other.colour != colour_;
    };
    scene_.captions.erase(std::remove_if(scene_.captions.begin(), scene_.captions.end(), in_the_way),
                          scene_.captions.end());
    scene_.captions.push_back({at, words, colour_});
  }
  void point(const glm::vec3& at, const std::string& words) {
    scene_.points.push_back({at, colour_, 13.0F});
    caption(at, words);
  }
  void vertex(knit::VertexId vertex, const std::string& words) {
    if (vertex != knit::no_vertex) point(place(vertex), words);
  }
  void line(const glm::vec3& from, const glm::vec3& to, const std::string& words) {
    scene_.lines.push_back({from, to, colour_, 5.0F});
    caption(0.5F * (from + to), words);
  }
  void ring(const std::string& words) {
    if (row_.ring == nullptr) return;
    add_loop(*row_.ring, colour_, 4.0F, scene_.lines);
    caption(glm::vec3(row_.ring->points.front()), words);
  }
  void stitches(const knit::Row* row, const std::string& words);
  void loop(const knit::LiveStitches& live, const std::string& words);
  [[nodiscard]] knit::LiveStitches worked_on(knit::RowId row) const;
  void mains_below(const knit::LiveStitches& below);
  void level(std::int32_t number, const std::string& words);
  void ends_line(const std::string& words);
  void criticals(knit::CriticalKind kind);
  void distance();
  void band();
  void gap(const std::string& name, double gap);
  void kept();
  void links(bool doubled_only, bool longest_only);
  void cell(std::int32_t cell, const std::string& words);

  // Whether it is one of these that is pointed at.
  template <class... Variables>
  [[nodiscard]] bool is(const Variables&... each) const {
    return ((&variable_ == &each) || ...);
  }

  const Session& session_;
  const knit::CodeVariable& variable_;
  StateShown shown_;
  const knit::State& state_;
  const Explained& at_;
  Scene& scene_;
  Colour colour_;
  RowShown row_;
};

Measured VariableLight::measured() const {
  if (const auto* step = step_as<knit::CandidateMeasured>())
    return {step->anchor, step->candidate, step->distance};
  if (const auto* step = step_as<knit::BandMissed>()) return {step->anchor, step->taken, step->distance};
  if (const auto* stop = step_as<knit::Stopped>(); stop != nullptr && stop->reason == knit::StopReason::stall)
    return {stop->vertex, knit::no_vertex, 0.0};
  const auto* work = std::get_if<knit::RowWork>(&state_.work);
  if (work == nullptr || !work->ring || work->phase > knit::RowPhase::missed) return {};
  return {work->ring->vertices[static_cast<std::size_t>(work->walk.anchor)], knit::no_vertex, 0.0};
}

void VariableLight::stitches(const knit::Row* row, const std::string& words) {
  if (row != nullptr) loop(knit::all_of(*row), words);
}

// Of one row or of several, bridges among them.
void VariableLight::loop(const knit::LiveStitches& live, const std::string& words) {
  const std::vector<knit::Stitch> stitches = state_.fabric.stitches_of(live);
  for (const auto& [i, next] : knit::Edges(stitches.size(), live.closed)) {
    const glm::vec3 from(stitches[i].position);
    scene_.lines.push_back({from, glm::vec3(stitches[next].position), colour_, 3.5F});
    scene_.points.push_back({from, colour_, 7.0F});
  }
  if (!stitches.empty())
    caption(glm::vec3(stitches.front().position),
            words + knit::stitch_count_text(static_cast<std::int64_t>(stitches.size())));
}

// What a row stands on, or will: of one in the making its tube's loop, which need not be the last row made.
knit::LiveStitches VariableLight::worked_on(knit::RowId row) const {
  const knit::Fabric& fabric = state_.fabric;
  if (const knit::Row* made = fabric.find_row(row)) return made->on;
  const auto* contour = std::get_if<knit::ContourWork>(&state_.work);
  if (contour == nullptr) return fabric.live_below(row);
  return contour->taken > 0 ? fabric.live(knit::current_tube(*state_.tubes, *contour)) : knit::LiveStitches{};
}

// A level's vertices, whether they are a ring already or not.
void VariableLight::level(std::int32_t number, const std::string& words) {
  if (!state_.timing || number < 0 || number >= state_.timing->levels.count()) return;
  const auto vertices = state_.timing->levels.level(number);
  for (const knit::VertexId v : vertices) scene_.points.push_back({place(v), colour_, 6.0F});
  caption(place(vertices.front()), words);
}

void VariableLight::ends_line(const std::string& words) {
  const knit::Ends* ends = ends_shown(state_);
  if (ends != nullptr) line(glm::vec3(ends->origin), glm::vec3(ends->origin + ends->direction), words);
}

void VariableLight::criticals(knit::CriticalKind kind) {
  const auto* work = std::get_if<knit::TimingWork>(&state_.work);
  const knit::Criticals* found = state_.timing                        ? &state_.timing->criticals
                                 : work != nullptr && work->criticals ? &*work->criticals
                                                                      : nullptr;
  if (found == nullptr) return;
  for (const knit::CriticalPoint& critical : found->points) {
    if (critical.kind == kind) point(place(critical.vertex), "");
  }
}

void VariableLight::timing() {
  const knit::Ends* ends = ends_shown(state_);
  const auto* timed = step_as<knit::VertexTimed>();
  if (is(var::minima)) return criticals(knit::CriticalKind::minimum);
  if (is(var::saddles)) return criticals(knit::CriticalKind::saddle);
  if (is(var::maxima)) return criticals(knit::CriticalKind::maximum);
  if (ends == nullptr) return;
  if (is(var::start)) return vertex(ends->start, "v_start");
  if (is(var::end, var::far)) return vertex(ends->end, "v_end");
  if (is(var::direction)) return ends_line("d");
  if (is(var::mag)) return ends_line(knit::short_number(glm::length(ends->direction)));
  if (is(var::height)) return ends_line("H");
  if (is(var::split_level)) {
    const auto* grouped = step_as<knit::LevelsGrouped>();
    if (grouped != nullptr) level(grouped->split_level, "splits");
  }
  if (timed == nullptr) return;
  if (is(var::vertex, var::clamped)) return vertex(timed->vertex, "vi");
  if (is(var::diff)) return line(place(ends->start), place(timed->vertex), "diff");
  if (!is(var::time)) return;
  vertex(timed->vertex, "t = " + knit::short_number(timed->time));
  const glm::dvec3 foot = ends->origin + timed->time * ends->direction;
  line(glm::vec3(ends->origin), glm::vec3(foot), "");
  scene_.lines.push_back({glm::vec3(foot), place(timed->vertex), colour_, 1.5F});
}

void VariableLight::distance() {
  const Measured m = measured();
  if (m.candidate == knit::no_vertex) return;
  point(place(m.candidate), "");
  line(place(m.anchor), place(m.candidate), "d = " + knit::short_number(m.distance));
}

// Around the anchor of the current step, though the next may be taken already.
void VariableLight::band() {
  const knit::VertexId anchor = measured().anchor;
  if (anchor == knit::no_vertex) return;
  const knit::Band band = knit::band_of(parameters().rows, parameters().stitch);
  scene_.band = band_around(session_, anchor, parameters(), scene_);
  scene_.band->colour = with_alpha(colour_, 140);
  point(place(anchor), "[" + knit::short_number(band.low) + ", " + knit::short_number(band.high) + "]");
}

void VariableLight::gap(const std::string& name, double gap) {
  const auto* work = std::get_if<knit::RowWork>(&state_.work);
  const auto arc = gap_arc(state_);
  const std::string words = name + knit::short_number(gap);
  if (arc) {
    add_arc(*work->ring, *arc, colour_, 4.0F, scene_);
    const glm::vec3 from(work->closed.stitches.back().position);
    return line(from, glm::vec3(work->closed.stitches.front().position), words);
  }
  if (row_.finished == nullptr) return;
  const auto& stitches = row_.finished->stitches;
  line(glm::vec3(stitches.back().position), glm::vec3(stitches.front().position), words);
}

// Of the row in the making.
void VariableLight::kept() {
  const auto* work = std::get_if<knit::RowWork>(&state_.work);
  if (row_.finished != nullptr) return stitches(row_.finished, "");
  if (work == nullptr || !work->ring || at_.step->place.row != state_.next.row) return;
  for (const std::int32_t order : work->walk.kept)
    scene_.points.push_back({glm::vec3(work->ring->points[static_cast<std::size_t>(order)]), colour_, 9.0F});
  point(glm::vec3(work->ring->points[static_cast<std::size_t>(work->walk.anchor)]), "");
}

void VariableLight::row() {
  const std::string t = row_.time ? "t = " + knit::short_number(*row_.time) : "";
  if (is(var::cycle, var::count))
    return row_.ring != nullptr ? ring("v") : level(row_.level.value_or(-1), "v");
  if (is(var::time, var::level, var::by, var::loops))
    return row_.ring != nullptr ? ring(t) : level(row_.level.value_or(-1), t);
  if (is(var::last_level)) return level(state_.last_level, "last level");
  if (is(var::length) && row_.ring != nullptr) return ring("L = " + knit::short_number(row_.ring->length));
  if (is(var::first) && row_.ring != nullptr) return point(glm::vec3(row_.ring->points.front()), "v[0]");
  if (is(var::below)) return loop(worked_on(at_.step->place.row), "worked on: ");
  if (is(var::n, var::k, var::picked)) return kept();
  walk();
}

// Of Algorithm 2 and the cast on: what is measured along the ring.
void VariableLight::walk() {
  if (is(var::anchor, var::stitch)) return vertex(measured().anchor, "v0");
  if (is(var::candidate, var::order)) {
    const Measured m = measured();
    if (m.candidate == knit::no_vertex) return;
    scene_.lines.push_back({place(m.anchor), place(m.candidate), colour_, 2.0F});
    return vertex(m.candidate, "vi");
  }
  if (is(var::d, var::metric)) return distance();
  if (is(var::width, var::epsilon, var::verdict, var::skipped)) return band();
  const auto* closed = step_as<knit::RowClosed>();
  const auto* shared = step_as<knit::GapShared>();
  if (is(var::gap, var::in_band, var::dropped_last) && closed != nullptr) return gap("g = ", closed->gap);
  if (shared != nullptr && is(var::gap, var::gap_after, var::share, var::how))
    return gap("g after = ", shared->gap_after);
  const auto* cast_on = step_as<knit::StitchCastOn>();
  if (cast_on == nullptr || row_.ring == nullptr || !is(var::arc, var::item)) return;
  add_arc(*row_.ring, RingArc{0.0, cast_on->arc}, colour_, 5.0F, scene_);
  point(glm::vec3(knit::point_at(*row_.ring, cast_on->arc)), "s = " + knit::short_number(cast_on->arc));
}

void VariableLight::tube_curves(const knit::Tube& tube) {
  for (const auto& curve : tube.curves) add_loop(*curve, colour_, 2.0F, scene_.lines);
}

void VariableLight::tubes() {
  const auto* found = step_as<knit::NodeFound>();
  if (found != nullptr) {
    const glm::vec3 at = place(found->vertex);
    return point(at, is(var::field_value) ? "t = " + knit::short_number(found->value) : "");
  }
  const auto* left = step_as<knit::TubeLeftOut>();
  if (left != nullptr) return point(place(left->vertex), "");
  if (!state_.tubes) return;
  for (const knit::Tube& tube : state_.tubes->tubes) tube_curves(tube);
}

// Of a deal in progress: its two sides and its bridge.
void VariableLight::deal(const knit::Deal& deal) {
  if (is(var::saddle, var::saddle_gap)) return point(glm::vec3(deal.saddle), "");
  if (is(var::bridge)) {
    for (const knit::Stitch& stitch : deal.bridge) point(glm::vec3(stitch.position), "");
    return;
  }
  const auto& sides = deal.kind == knit::DealKind::split ? deal.given : deal.taken;
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const bool meant = is(var::whole, var::arcs_tried) || (side == 0 ? is(var::one) : is(var::two));
    if (!meant) continue;
    for (const knit::StitchSpan& span : sides[side].spans) {
      for (std::int32_t i = 0; i < span.count && span.row > 0; ++i) {
        const glm::vec3 at(state_.fabric.position({span.row, span.first + i}));
        scene_.points.push_back({at, colour_, 9.0F});
      }
    }
  }
}

void VariableLight::contour() {
  const auto* work = std::get_if<knit::ContourWork>(&state_.work);
  const auto* placed = step_as<knit::StitchPlaced>();
  if (work != nullptr && work->deal) return deal(*work->deal);
  if (is(var::tube, var::rows, var::stitch_height, var::row_height, var::surface_height)) {
    if (work == nullptr || work->taken == 0) return;
    return tube_curves(state_.tubes->tube(knit::current_tube(*state_.tubes, *work)));
  }
  if (is(var::points, var::time, var::level)) {
    if (row_.ring != nullptr) ring(row_.time ? "t = " + knit::short_number(*row_.time) : "");
    return;
  }
  if (row_.ring == nullptr) return;
  const knit::Ring& loop = *row_.ring;
  const double w = parameters().stitch.width;
  if (placed != nullptr && is(var::arc, var::item)) {
    add_arc(loop, RingArc{0.0, placed->arc}, colour_, 5.0F, scene_);
    return point(glm::vec3(knit::point_at(loop, placed->arc)), "s = " + knit::short_number(placed->arc));
  }
  if (is(var::width)) {
    add_arc(loop, RingArc{0.0, std::min(w, loop.length)}, colour_, 5.0F, scene_);
    return point(glm::vec3(loop.points.front()), "w = " + knit::short_number(w));
  }
  const auto* chosen = step_as<knit::CountChosen>();
  if (chosen != nullptr && is(var::course, var::n, var::ideal, var::reason)) {
    for (std::int32_t i = 0; i < chosen->count; ++i) {
      const double arc = loop.length * i / chosen->count;
      scene_.points.push_back({glm::vec3(knit::point_at(loop, arc)), colour_, 7.0F});
    }
    return;
  }
  row();
}

// At its stitch of the larger row.
void VariableLight::cell(std::int32_t cell, const std::string& words) {
  const knit::Join* join = join_shown(state_, at_.step->place.row);
  if (join == nullptr || cell < 0) return;
  const knit::LiveStitches cells = state_.fabric.larger(*join);
  if (cell < cells.size()) point(glm::vec3(state_.fabric.position(cells.at(cell))), words);
}

void VariableLight::links(bool doubled_only, bool longest_only) {
  const knit::Join* plan = join_shown(state_, at_.step->place.row);
  if (plan == nullptr) return;
  const knit::Fabric& fabric = state_.fabric;
  const knit::LiveStitches larger = fabric.larger(*plan);
  const knit::LiveStitches smaller = fabric.smaller(*plan);
  std::vector<std::int32_t> hanging(static_cast<std::size_t>(smaller.size()), 0);
  for (const std::int32_t link : plan->link) ++hanging[static_cast<std::size_t>(link)];
  std::optional<Line> longest;
  for (std::size_t i = 0; i < plan->link.size(); ++i) {
    const std::int32_t link = plan->link[i];
    const Line wale{glm::vec3(fabric.position(larger.at(static_cast<std::int32_t>(i)))),
                    glm::vec3(fabric.position(smaller.at(link))), colour_, 3.0F};
    const bool doubled = hanging[static_cast<std::size_t>(link)] > 1;
    if (!longest || glm::distance(wale.from, wale.to) > glm::distance(longest->from, longest->to))
      longest = wale;
    if (!longest_only && (doubled || !doubled_only)) scene_.lines.push_back(wale);
  }
  if (longest_only && longest)
    line(longest->from, longest->to,
         knit::short_number(static_cast<double>(glm::distance(longest->from, longest->to))));
}

// Those of the rows that are worked on, as far as they are.
void VariableLight::mains_below(const knit::LiveStitches& below) {
  for (const knit::StitchSpan& span : below.spans) {
    const knit::Join* before = state_.fabric.join_into(span.row);
    if (before == nullptr) continue;
    for (const std::int32_t stitch : before->mains) {
      if (stitch >= span.first && stitch < span.first + span.count)
        point(glm::vec3(state_.fabric.position({span.row, stitch})), "");
    }
  }
}

void VariableLight::index() {
  if (at_.step == nullptr) return;
  const knit::RowId row = at_.step->place.row;
  const knit::Row* above = state_.fabric.find_row(row);
  if (above == nullptr || above->on.empty()) return;
  const auto* main = step_as<knit::MainPlaced>();
  const auto* shaping = step_as<knit::ShapingPlaced>();
  if (is(var::below)) return loop(above->on, "p = ");
  if (is(var::above)) return stitches(above, "n = ");
  if (is(var::mains)) return mains_below(above->on);
  if (is(var::links, var::sum)) return links(false, false);
  if (is(var::doubled)) return links(true, false);
  if (is(var::longest)) return links(false, true);
  if (is(var::cell, var::label, var::main)) {
    if (main != nullptr) return cell(main->cell, "cell " + std::to_string(main->cell + 1));
    if (shaping != nullptr) return cell(shaping->cell, "cell " + std::to_string(shaping->cell + 1));
  }
  if (is(var::partner) && shaping != nullptr) return cell(shaping->partner, "partner");
  const knit::Join* plan = join_shown(state_, at_.step->place.row);
  const bool of_mains = is(var::wanted, var::spacing, var::rule, var::mains_set);
  if (plan == nullptr || !of_mains) return;
  for (const knit::PlacedLabel& placed : plan->placed) {
    if (placed.label == knit::Label::main) cell(placed.cell, "");
  }
}

// Faces, and the rows that a line of the pattern is about.
void VariableLight::strip() {
  const auto* made = step_as<knit::FaceMade>();
  const auto* written = step_as<knit::LineWritten>();
  if (made != nullptr) {
    const knit::Strip* strip = knit::planned_strip(state_, at_.step->place.row);
    if (strip == nullptr) return;
    const knit::KnittingPath path(state_.fabric);
    const knit::Face& face = strip->faces[static_cast<std::size_t>(made->index) - 1];
    for (const auto& [i, next] : knit::Edges(static_cast<std::size_t>(face.corner_count), true))
      line(place_on(path, face.corners.at(i)), place_on(path, face.corners.at(next)), "");
    return;
  }
  if (written == nullptr) return;
  const knit::RowId row = at_.step->place.row;
  const bool of_below = is(var::consumed) && at_.step->place.item == 0;
  if (of_below) return loop(worked_on(row), "");
  stitches(state_.fabric.find_row(row), "");
}

}  // namespace

void describe_variable(const Session& session, Scene& scene) {
  const knit::CodeVariable* variable = variable_named(session.learning->pointed_variable);
  if (variable == nullptr || session.view->side != SidePanel::step) return;
  const auto at = explained(session);
  if (!at) return;
  VariableLight light(session, *variable, *at, scene);
  switch (at->code->stages.front()) {
    case knit::Stage::import:
    case knit::Stage::timing:
      return light.timing();
    case knit::Stage::tubes:
      return light.tubes();
    case knit::Stage::cast_on:
    case knit::Stage::rows:
      return at->code == &knit::contour_code ? light.contour() : light.row();
    case knit::Stage::stitches:
      return light.index();
    case knit::Stage::faces:
    case knit::Stage::pattern:
    case knit::Stage::done:
      return light.strip();
    case knit::Stage::settle:
    case knit::Stage::relax:  // of all stitches at once, which are shown anyway
      return;
  }
}

}  // namespace app
