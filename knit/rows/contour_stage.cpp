#include "knit/rows/contour_stage.h"

#include <algorithm>
#include <utility>

#include "knit/mesh/mirror_plane.h"
#include "knit/model/bug.h"
#include "knit/rhythm/few_rounds.h"
#include "knit/rhythm/joint_plan.h"
#include "knit/rhythm/live_rhythm.h"
#include "knit/rhythm/rhythm_plan.h"
#include "knit/rows/body_halves.h"
#include "knit/rows/contour_rows.h"
#include "knit/rows/dealing.h"
#include "knit/rows/follow.h"
#include "knit/rows/frame.h"
#include "knit/timing/heights.h"

namespace knit {

namespace {

const Tube& tube_in_work(const ContourAt& at, const ContourWork& work) {
  return at.plan.tube(current_tube(at.plan, work));
}

// --- what comes next -----------------------------------------------------------------------------------------

// Whether the tube has been taken up and all its rows are made.
bool is_done(const ContourAt& at, const ContourWork& work, TubeId tube) {
  const auto& order = at.plan.order;
  const auto end = order.begin() + work.taken;
  const auto found = std::find(order.begin(), end, tube);
  if (found == end) return false;
  return found + 1 != end || work.row == at.plan.tube(tube).rows();
}

bool has_row(const Fabric& fabric, TubeId tube) {
  return std::any_of(fabric.rows().begin(), fabric.rows().end(),
                     [&](const auto& row) { return row->tube == tube; });
}

bool is_deal(const TubeEvent& event) {
  return event.kind != EventKind::cast_on && event.kind != EventKind::bind_off;
}

// Whether the next tube to be taken up is worked on what the event gives.
bool is_needed(const ContourAt& at, const ContourWork& work, const TubeEvent& event) {
  if (work.taken == static_cast<std::int32_t>(at.plan.order.size())) return false;
  const bool between = work.taken == 0 || work.row == at.plan.tube(current_tube(at.plan, work)).rows();
  const TubeId next = at.plan.order[static_cast<std::size_t>(work.taken)];
  return between && std::find(event.above.begin(), event.above.end(), next) != event.above.end();
}

// Edges of rings as soon as both sides are there; loops part and meet when a tube is worked on what comes of it.
bool can_be_dealt(const ContourAt& at, const ContourWork& work, const TubeEvent& event) {
  if (event.kind == EventKind::ring_cast_on)
    return std::all_of(event.above.begin(), event.above.end(),
                       [&](TubeId tube) { return has_row(at.fabric, tube); });
  if (event.kind != EventKind::ring_bind_off && !is_needed(at, work, event)) return false;
  return std::all_of(event.below.begin(), event.below.end(),
                     [&](TubeId tube) { return is_done(at, work, tube); });
}

// The first event that can be dealt now and is not; -1: none.
std::int32_t next_deal(const ContourAt& at, const ContourWork& work) {
  for (std::size_t i = 0; i < at.plan.events.size(); ++i) {
    const bool dealt = i < work.dealt.size() && work.dealt[i] != 0;
    if (!dealt && is_deal(at.plan.events[i]) && can_be_dealt(at, work, at.plan.events[i]))
      return static_cast<std::int32_t>(i);
  }
  return -1;
}

bool all_is_dealt(const ContourAt& at, const ContourWork& work) {
  for (std::size_t i = 0; i < at.plan.events.size(); ++i) {
    if (is_deal(at.plan.events[i]) && (i >= work.dealt.size() || work.dealt[i] == 0)) return false;
  }
  return true;
}

// Whether a tube without a row is left in the order; it makes no step that a stage could end with.
bool nothing_follows(const ContourAt& at, const ContourWork& work) {
  return work.taken == static_cast<std::int32_t>(at.plan.order.size()) && all_is_dealt(at, work);
}

// --- deals ---------------------------------------------------------------------------------------------------

// By their names in what is told.
DealTubes tubes_dealt(const Deal& deal) {
  const auto name = [](TubeId tube) { return static_cast<std::int16_t>(tube); };
  const bool parts = deal.kind == DealKind::split;
  const std::vector<TubeId>& pair = parts ? deal.to : deal.from;
  const std::vector<TubeId>& whole = parts ? deal.from : deal.to;
  return {name(pair[0]), name(pair[1]), whole.empty() ? std::int16_t{-1} : name(whole.front())};
}

// What a row is made by.
struct RowWish {
  const RowsSettings& rows;
  const RhythmSettings& rhythm;
  const StitchSize& stitch;
  const Heard& heard;
};

// In which the mesh mirrors; of the whole piece sought once.
std::optional<MirrorPlane> mirror_of(const RowWish& wish, const ContourAt& at) {
  for (const Shared<TubeRhythm>& rhythm : at.rhythms) {
    if (rhythm->mirror_sought) return rhythm->mirror;
  }
  const RowFrame frame = row_frame(at.timing.ends.direction, wish.rows.start_direction);
  return find_mirror_plane(at.input.mesh, frame.along, frame.right);
}

// What a tube's halves hold that are to be shaped apart; none where it is round, or does not lie in the plane.
std::optional<HalfIdeals> halves_apart(const RowWish& wish, const Tube& tube,
                                       const std::optional<MirrorPlane>& mirror) {
  if (!mirror || tube.rows() < fewest_rows_in_rhythm) return {};
  auto ideals = half_ideals(tube, *mirror, wish.stitch.width);
  if (!ideals || !wants_joint_plan(*ideals, wish.rhythm)) return {};
  return ideals;
}

// Front and back halves apart, where the tube is not round and begins at its back. A plan goes on from one of its kind only: its
// mains stand where they stand.
std::optional<RhythmPlan> plan_halves(const RowWish& wish, const ContourAt& at, TubeRhythm& made,
                                      const RhythmStart& start) {
  if (!may_plan_jointly(wish.rhythm) || start.live > 0) return {};
  made.mirror = mirror_of(wish, at);
  made.mirror_sought = true;
  std::int32_t front = 0;
  if (start.row > 0) {
    const TubeRhythm* before = rhythm_of(at.rhythms, made.tube);
    if (before == nullptr || !before->is_joint(start.row)) return {};
    front = before->front(start.row);
  }
  const auto ideals = halves_apart(wish, at.plan.tube(made.tube), made.mirror);
  if (!ideals) return {};
  return plan_joint(*ideals, wish.rhythm, start, front, wish.heard);
}

// The same on live stitches. They were turned when they were dealt, if halves were to be shaped apart then.
std::optional<LiveRhythm> plan_halves_on_loop(const RowWish& wish, const ContourAt& at, TubeRhythm& made) {
  if (!may_plan_jointly(wish.rhythm)) return {};
  made.mirror = mirror_of(wish, at);
  made.mirror_sought = true;
  const Tube& tube = at.plan.tube(made.tube);
  const auto ideals = halves_apart(wish, tube, made.mirror);
  if (!ideals) return {};
  std::vector<glm::dvec3> loop;
  for (const Stitch& stitch : at.fabric.stitches_of(at.fabric.live(made.tube)))
    loop.push_back(stitch.position);
  const auto live = static_cast<std::int32_t>(loop.size());
  const auto back = back_stitch(loop, *tube.curves.front(), *made.mirror);
  if (!back || std::min(*back, live - *back) > 1) return {};
  return plan_halves_on(*ideals, wish.rhythm, {live, tube.twins.size() > 1}, wish.heard);
}

// The rounds of a tube whose halves are shaped apart begin at its back.
void begin_at_backs(const RowWish& wish, const ContourAt& at, Deal& deal) {
  if (!may_plan_jointly(wish.rhythm)) return;
  const std::optional<MirrorPlane> mirror = mirror_of(wish, at);
  const RowId bridge = bridge_row(static_cast<std::int32_t>(at.fabric.deals().size()) + 1);
  for (std::size_t i = 0; i < deal.to.size(); ++i) {
    const Tube& tube = at.plan.tube(deal.to[i]);
    if (!halves_apart(wish, tube, mirror)) continue;
    std::vector<glm::dvec3> loop;
    for (std::int32_t stitch = 0; stitch < deal.given[i].size(); ++stitch) {
      const StitchRef ref = deal.given[i].at(stitch);
      loop.push_back(ref.row == bridge ? deal.bridge[static_cast<std::size_t>(ref.stitch)].position
                                       : at.fabric.position(ref));
    }
    if (const auto back = back_stitch(loop, *tube.curves.front(), *mirror))
      deal.given[i] = begun_at(deal.given[i], *back);
  }
}

Advanced<ContourEvent> find_gaps(const RowWish& wish, const ContourAt& at, std::int32_t event,
                                 ContourWork& work) {
  const StitchSize& stitch = wish.stitch;
  const bool in_rhythm = wish.rhythm.counts == CountPlanning::rhythm;
  const DealAt deal_at{at.input, at.plan, at.fabric, event, stitch.width, in_rhythm};
  const TubeEvent& what = at.plan.event(event);
  std::int64_t tried = 0;
  Deal deal;
  if (what.kind == EventKind::split) {
    const std::vector<Stitch> loop = at.fabric.stitches_of(at.fabric.live(what.below.front()));
    const ArcFound arc = find_arc(
        loop, {&*at.plan.tube(what.above[0]).lowest, &*at.plan.tube(what.above[1]).lowest}, what.position);
    deal = deal_split(deal_at, arc);
    tried = arc.tried;
  } else if (what.kind == EventKind::join) {
    deal = deal_join(deal_at, yarn_bringer(at.plan, at.plan.order, what));
    tried = deal.arcs[0] + deal.arcs[1];
  } else {
    deal = deal_ring(deal_at);
  }
  if (in_rhythm) begin_at_backs(wish, at, deal);
  const GapsFound step{
      deal.kind,        what.vertex,  static_cast<std::int32_t>(std::min<std::int64_t>(tried, INT32_MAX)),
      deal.arcs[0],     deal.arcs[1], static_cast<float>(deal.gap / stitch.width),
      tubes_dealt(deal)};
  work.phase = deal.bridge.empty() ? ContourPhase::give : ContourPhase::bridge;
  work.deal = Shared(std::move(deal));
  work.bridged = 0;
  return step;
}

BridgeCastOn cast_on_bridge(ContourWork& work) {
  const auto stitches = static_cast<std::int32_t>(work.deal->bridge.size());
  ++work.bridged;
  if (work.bridged == stitches) work.phase = ContourPhase::give;
  return {work.bridged, stitches};
}

// Of a tube that has ended by itself: its loop waits for nothing.
bool is_bound_off(const ContourAt& at, const ContourWork& work, TubeId tube) {
  return at.plan.event(at.plan.tube(tube).top).kind == EventKind::bind_off && is_done(at, work, tube);
}

// That are worked on after it.
std::int32_t loops_after(const ContourAt& at, const ContourWork& work, const Deal& deal) {
  const auto live = std::count_if(at.fabric.live().begin(), at.fabric.live().end(),
                                  [&](const LiveLoop& loop) { return !is_bound_off(at, work, loop.tube); });
  if (deal.kind == DealKind::ring_cast_on) return static_cast<std::int32_t>(live);
  return static_cast<std::int32_t>(live) + static_cast<std::int32_t>(deal.to.size()) -
         static_cast<std::int32_t>(deal.from.size());
}

Advanced<ContourEvent> give_loops(const ContourAt& at, ContourWork& work, std::optional<Deal>& made) {
  const Deal& deal = *work.deal;
  const bool split = deal.kind == DealKind::split;
  const auto& loops = split ? deal.given : deal.taken;
  LoopsDealt step{
      deal.kind, loops[0].size(),  loops[1].size(), 0, static_cast<std::int32_t>(deal.bridge.size()),
      0,         tubes_dealt(deal)};
  if (split) step.whole = deal.taken.front().size();
  if (deal.kind == DealKind::join) step.whole = deal.given.front().size();
  step.held = std::max(0, loops_after(at, work, deal) - 1);
  work.dealt.resize(at.plan.events.size(), 0);
  work.dealt[static_cast<std::size_t>(deal.event)] = 1;
  made = deal;
  work.deal = {};
  work.phase = ContourPhase::take;
  return {step, nothing_follows(at, work) ? Ended::stage : Ended::step};
}

// --- rows ----------------------------------------------------------------------------------------------------

// The tube's value as a time.
double time_at(const Timing& timing, double value) {
  return timing.retimed ? height_at(timing.scale, value) / timing.scale.total() : value;
}

// Asked for, and not planned for the rows to come as they are now.
bool rhythm_is_due(const RhythmSettings& rhythm, const StitchSize& stitch, const ContourAt& at,
                   const ContourWork& work) {
  if (rhythm.counts == CountPlanning::whole || work.row == tube_in_work(at, work).rows()) return false;
  const TubeRhythm* planned = rhythm_of(at.rhythms, current_tube(at.plan, work));
  return planned == nullptr || planned->settings != rhythm || planned->stitch_width != stitch.width ||
         planned->stitch_height != stitch.height;
}

// What the first row of a ring's second tube stands against.
std::int32_t across_the_ring(const ContourAt& at, TubeId tube) {
  const TubeEvent& bottom = at.plan.event(at.plan.tube(tube).bottom);
  if (bottom.kind != EventKind::ring_cast_on) return 0;
  for (const auto& row : at.fabric.rows()) {
    const bool other = row->tube != tube &&
                       std::find(bottom.above.begin(), bottom.above.end(), row->tube) != bottom.above.end();
    if (other) return size_of(*row);
  }
  return 0;
}

// Where the plan begins: at the tube's first row, or on the last that is made.
RhythmStart rhythm_start(const RowsSettings& rows, const ContourAt& at, const ContourWork& work) {
  const TubeId id = current_tube(at.plan, work);
  if (work.row == 0)
    return {0, at.fabric.empty() ? rows.cast_on : 0, SegmentEnd::start, across_the_ring(at, id)};
  const std::int32_t made = work.row;
  const std::int32_t last = made - 1;
  const TubeRhythm* before = rhythm_of(at.rhythms, id);
  const bool changed = before != nullptr && before->has(last) && before->role(last) == RowRole::change;
  return {last, at.fabric.live(id).size(), changed ? SegmentEnd::changed : SegmentEnd::rested};
}

RhythmPlanned planned_words(const TubeRhythm& made) {
  const RhythmPlan& plan = made.plan;
  const auto small = [](std::ptrdiff_t value) {
    return static_cast<std::int16_t>(std::min<std::ptrdiff_t>(value, INT16_MAX));
  };
  const auto shapes = [](const RhythmSegment& segment) { return segment.kind != SegmentKind::plain; };
  return {small(made.tube),
          small(plan.changes),
          small(plan.sections),
          small(std::count_if(plan.segments.begin(), plan.segments.end(), shapes)),
          small(std::count(plan.roles.begin(), plan.roles.end(), RowRole::change)),
          small(std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(plan.counts.size()) - 1)),
          small(plan.seen.row + 1),
          made.settings.style,
          made.none,
          static_cast<float>(plan.seen.local),
          static_cast<float>(plan.seen.belt),
          static_cast<float>(plan.score),
          plan.within,
          !plan.fronts.empty()};
}

// Stitches that the tube's first row is worked on, or stands against at the edge of a ring; 0: it is cast on.
std::int32_t stitches_below(const ContourAt& at, TubeId tube) {
  const std::int32_t live = at.fabric.live(tube).size();
  return live > 0 ? live : across_the_ring(at, tube);
}

// That a twin was given before it, if it has the same rows and was planned for the same. Halves are each tube's own: what is in front of
// one may be behind the other.
const TubeRhythm* rhythm_of_twin(const RowWish& wish, const ContourAt& at, TubeId id) {
  const Tube& tube = at.plan.tube(id);
  for (const TubeId twin : tube.twins) {
    const TubeRhythm* rhythm = twin != id ? rhythm_of(at.rhythms, twin) : nullptr;
    const bool same = rhythm != nullptr && rhythm->from == 0 && rhythm->none == NoRhythm::no &&
                      rhythm->plan.fronts.empty() && rhythm->settings == wish.rhythm &&
                      rhythm->stitch_width == wish.stitch.width &&
                      rhythm->stitch_height == wish.stitch.height &&
                      at.plan.tube(twin).lengths == tube.lengths;
    if (same && may_begin_on(rhythm->plan, stitches_below(at, id))) return rhythm;
  }
  return nullptr;
}

RhythmPlanned plan_rows(const RowWish& wish, const ContourAt& at, const ContourWork& work,
                        std::optional<TubeRhythm>& made) {
  const TubeId id = current_tube(at.plan, work);
  const Tube& tube = at.plan.tube(id);
  const RhythmStart start = rhythm_start(wish.rows, at, work);
  made = TubeRhythm{id, start.row, wish.rhythm, wish.stitch.width, wish.stitch.height};
  const TubeRhythm* twin = work.row == 0 ? rhythm_of_twin(wish, at, id) : nullptr;
  if (twin != nullptr) {
    made->plan = twin->plan;
    return planned_words(*made);
  }
  std::vector<double> ideals;
  for (const double length : tube.lengths) ideals.push_back(length / wish.stitch.width);
  RhythmSettings as_it_is = wish.rhythm;
  as_it_is.fit_size = FitSize::off;
  const std::int32_t live = work.row == 0 ? at.fabric.live(id).size() : 0;
  std::optional<LiveRhythm> plan;
  if (live == 0) {
    if (auto halves = plan_halves(wish, at, *made, start))
      plan = LiveRhythm{start.row, *std::move(halves)};
    else if (auto alone = plan_rhythm(resized_ideals(ideals), as_it_is, start, wish.heard))
      plan = LiveRhythm{start.row, *std::move(alone)};
  } else if (tube.rows() < fewest_rows_in_rhythm) {
    made->none = NoRhythm::few_rows;
  } else {
    plan = plan_halves_on_loop(wish, at, *made);
    if (!plan) plan = plan_rhythm_on(ideals, as_it_is, {live, tube.twins.size() > 1}, wish.heard);
  }
  if (plan) {
    made->from = plan->from;
    made->plan = std::move(plan->plan);
  } else if (made->none == NoRhythm::no) {
    made->none = NoRhythm::fits_none;
  }
  if (made->none != NoRhythm::no && live > 0)
    made->plan = plan_few_rounds(ideals, live, wish.rhythm.style == RhythmStyle::pairs);
  return planned_words(*made);
}

CutFound find_cut(const ContourAt& at, ContourWork& work) {
  const Tube& tube = tube_in_work(at, work);
  work.phase = ContourPhase::loop;
  return {current_tube(at.plan, work), work.row,
          time_at(at.timing, tube.values[static_cast<std::size_t>(work.row)])};
}

Advanced<ContourEvent> begin_row(const RowWish& wish, const ContourAt& at, ContourWork& work,
                                 std::optional<TubeRhythm>& rhythm) {
  if (!rhythm_is_due(wish.rhythm, wish.stitch, at, work)) return find_cut(at, work);
  const RhythmPlanned planned = plan_rows(wish, at, work, rhythm);
  work.phase = ContourPhase::cut;
  return planned;
}

Rowless why_rowless(const TubePlan& plan, const Tube& tube) {
  if (tube.rows() > 0) return Rowless::no;
  if (plan.event(tube.top).kind == EventKind::ring_cast_on) return Rowless::cast_on_edge;
  if (plan.event(tube.bottom).kind == EventKind::ring_bind_off) return Rowless::grafted;
  return Rowless::dealt_on;
}

// What waits once a tube is taken up: all other loops, and the one that was worked until now begins to.
void tell_waiting(const ContourAt& at, const ContourWork& work, TubeTaken& step) {
  const TubeId before = work.taken > 1 ? at.plan.order[static_cast<std::size_t>(work.taken) - 2] : -1;
  for (const LiveLoop& loop : at.fabric.live()) {
    if (loop.tube == step.tube || is_bound_off(at, work, loop.tube)) continue;
    ++step.held;
    if (loop.tube == before) step.aside = before;
  }
}

Advanced<ContourEvent> take_tube(const ContourAt& at, ContourWork& work) {
  if (work.taken == static_cast<std::int32_t>(at.plan.order.size()))
    throw Bug("no tube is left, and no deal");
  ++work.taken;
  work.row = 0;
  const TubeId id = current_tube(at.plan, work);
  const Tube& tube = at.plan.tube(id);
  work.phase = tube.rows() > 0 ? ContourPhase::cut : ContourPhase::take;
  TubeTaken step{id, tube.rows(), at.fabric.live(id).size(), static_cast<float>(tube.height),
                 static_cast<float>(tube.spacing)};
  step.rowless = why_rowless(at.plan, tube);
  tell_waiting(at, work, step);
  return {step, tube.rows() == 0 && nothing_follows(at, work) ? Ended::stage : Ended::step};
}

// The stitch was changed on the way: what is left is planned for it.
Advanced<ContourEvent> replan(const StitchSize& stitch, const ContourAt& at, ContourWork& work,
                              std::optional<TubePlan>& plan) {
  std::vector<std::int32_t> made(at.plan.tubes.size(), 0);
  for (const auto& row : at.fabric.rows())
    made[static_cast<std::size_t>(row->tube)] += is_short(*row) ? 0 : 1;
  plan = replan_rows(at.graph, at.plan, {stitch.width, stitch.height, 1}, made);
  RowsReplanned step{0, stitch.width, stitch.height};
  for (std::size_t id = 0; id < made.size(); ++id) step.rows += plan->tubes[id].rows() - made[id];
  const ContourAt then{at.input, at.timing, at.graph, *plan, at.fabric};
  return {step, step.rows == 0 && nothing_follows(then, work) ? Ended::stage : Ended::step};
}

// Between rows: deals first, then the next row of the tube, then the next tube.
Advanced<ContourEvent> go_on(const RowWish& wish, const ContourAt& at, ContourWork& work, ContourMade& made) {
  const StitchSize& stitch = wish.stitch;
  if (at.plan.stitch_width != stitch.width || at.plan.stitch_height != stitch.height)
    return replan(stitch, at, work, made.plan);
  if (const std::int32_t event = next_deal(at, work); event >= 0) return find_gaps(wish, at, event, work);
  if (work.taken > 0 && work.row < tube_in_work(at, work).rows())
    return begin_row(wish, at, work, made.rhythm);
  return take_tube(at, work);
}

LoopClosed close_loop(const ContourAt& at, ContourWork& work) {
  work.phase = ContourPhase::measure;
  return {static_cast<std::int32_t>(current_curve(at.plan, work).points.size())};
}

LengthMeasured measure(const StitchSize& stitch, const ContourAt& at, ContourWork& work) {
  work.phase = ContourPhase::count;
  const double length = current_curve(at.plan, work).length;
  return {length, length / stitch.width};
}

// What the tube's rhythm says of the row.
std::optional<ChosenCount> count_of_rhythm(const RhythmSettings& rhythm, const ContourAt& at,
                                           const ContourWork& work, double ideal) {
  if (rhythm.counts == CountPlanning::whole) return {};
  const TubeRhythm* planned = rhythm_of(at.rhythms, current_tube(at.plan, work));
  if (planned == nullptr || !planned->has(work.row)) return {};
  const RowRole role = planned->role(work.row);
  const std::int32_t count = planned->count(work.row);
  const std::int32_t live = at.fabric.live(planned->tube).size();
  if (role == RowRole::first && live > 0)
    return ChosenCount{count, count == live ? CountReason::rhythm_rest : CountReason::rhythm_begins, ideal};
  const bool changes = role == RowRole::change || role == RowRole::first;
  return ChosenCount{count, changes ? CountReason::rhythm_change : CountReason::rhythm_rest, ideal};
}

CountChosen count(const RowsSettings& rows, const RhythmSettings& rhythm, const StitchSize& stitch,
                  const ContourAt& at, ContourWork& work) {
  const TubeId id = current_tube(at.plan, work);
  const Tube& tube = at.plan.tube(id);
  std::int32_t below = at.fabric.live(id).size();
  if (below == 0) below = across_the_ring(at, id);
  const bool first = at.fabric.empty();
  const auto row = static_cast<std::size_t>(work.row);
  const std::optional<ChosenCount> in_rhythm =
      count_of_rhythm(rhythm, at, work, tube.lengths[row] / stitch.width);
  const ChosenCount chosen =
      in_rhythm ? *in_rhythm : choose_count(tube.lengths, row, below, stitch.width, first ? rows.cast_on : 0);
  work.count = chosen.count;
  work.phase = ContourPhase::begin;
  return {chosen.count, below, chosen.reason, chosen.ideal,
          current_curve(at.plan, work).length / chosen.count};
}

// Where a round begins whose halves are shaped apart.
std::optional<double> back_of_halves(const ContourAt& at, const ContourWork& work) {
  const TubeRhythm* rhythm = rhythm_of(at.rhythms, current_tube(at.plan, work));
  if (rhythm == nullptr || !rhythm->is_joint(work.row)) return {};
  return back_arc(current_curve(at.plan, work), *rhythm->mirror);
}

RoundBegun begin_round(const RowsSettings& rows, const StitchSize& stitch, const ContourAt& at,
                       ContourWork& work) {
  const Ring& curve = current_curve(at.plan, work);
  const LiveStitches live = at.fabric.under_short_rows(at.fabric.live(current_tube(at.plan, work)));
  RoundBegun step{0, 0.0, 0.0, 0.0};
  if (at.begins_on_curve) {
    step.arc = 0.0;
  } else if (const auto back = back_of_halves(at, work)) {
    step.arc = *back;
  } else if (!live.empty() && rows.round_start == RoundStart::follow) {
    const BegunRound begun =
        at.links.empty()
            ? follow_wale(curve, work.count, at.fabric.stitches_of(live), work.row == 0, stitch.height)
            : follow_links(curve, work.count, at.fabric.stitches_of(live), at.links);
    step = {begun.passes, begun.arc, begun.slid, begun.sum_of_squares / (stitch.height * stitch.height)};
  } else {
    const RowFrame frame = row_frame(at.timing.ends.direction, rows.start_direction);
    std::optional<glm::dvec3> below;
    if (!live.empty()) below = at.fabric.position(live.at(0));
    step.arc = arc_towards(curve, frame, below);
  }
  work.curve = Shared(begun_at(curve, step.arc));
  work.phase = ContourPhase::place;
  return step;
}

void finish_row(const ContourAt& at, ContourWork& work, std::optional<Row>& row) {
  const TubeId id = current_tube(at.plan, work);
  const double value = at.plan.tube(id).values[static_cast<std::size_t>(work.row)];
  row = Row{id,         at.fabric.next_row(),    at.fabric.live(id), work.row, time_at(at.timing, value),
            work.curve, std::move(work.stitches)};
  work.stitches.clear();
  work.curve = {};
  work.count = 0;
  ++work.row;
  work.phase = ContourPhase::take;
}

Advanced<ContourEvent> place(const ContourAt& at, ContourWork& work, std::optional<Row>& row) {
  const auto placed = static_cast<std::int32_t>(work.stitches.size());
  const Ring& curve = *work.curve;
  const StitchPlaced step{placed + 1, work.count, curve.length * placed / work.count};
  work.stitches.push_back({point_at(curve, step.arc), no_vertex});
  if (step.stitch < step.of) return step;
  const bool last_of_tube = work.row + 1 == tube_in_work(at, work).rows();
  finish_row(at, work, row);
  return {step, last_of_tube && nothing_follows(at, work) ? Ended::stage : Ended::row};
}

}  // namespace

const TubeRhythm* rhythm_of(std::span<const Shared<TubeRhythm>> rhythms, TubeId tube) {
  for (auto i = rhythms.size(); i-- > 0;) {
    if (rhythms[i]->tube == tube) return &*rhythms[i];
  }
  return nullptr;
}

TubeId current_tube(const TubePlan& plan, const ContourWork& work) {
  return work.taken > 0 ? plan.order[static_cast<std::size_t>(work.taken) - 1] : -1;
}

const Ring& current_curve(const TubePlan& plan, const ContourWork& work) {
  return *plan.tube(current_tube(plan, work)).curves[static_cast<std::size_t>(work.row)];
}

bool next_plans_rhythm(const RhythmSettings& rhythm, const StitchSize& stitch, const ContourAt& at,
                       const ContourWork& work) {
  const bool between = work.phase == ContourPhase::take || work.phase == ContourPhase::cut;
  return between && work.taken > 0 && at.plan.tubes.size() == 1 && rhythm_is_due(rhythm, stitch, at, work);
}

Advanced<ContourEvent> advance_contours(const RowsSettings& rows, const RhythmSettings& rhythm,
                                        const StitchSize& stitch, const ContourAt& at, ContourWork& work,
                                        ContourMade made, const Heard& heard) {
  switch (work.phase) {
    case ContourPhase::take:
      return go_on({rows, rhythm, stitch, heard}, at, work, made);
    case ContourPhase::cut:
      return begin_row({rows, rhythm, stitch, heard}, at, work, made.rhythm);
    case ContourPhase::loop:
      return close_loop(at, work);
    case ContourPhase::measure:
      return measure(stitch, at, work);
    case ContourPhase::count:
      return count(rows, rhythm, stitch, at, work);
    case ContourPhase::begin:
      return begin_round(rows, stitch, at, work);
    case ContourPhase::bridge:
      return cast_on_bridge(work);
    case ContourPhase::give:
      return give_loops(at, work, made.deal);
    case ContourPhase::place:
      break;
  }
  return place(at, work, made.row);
}

}  // namespace knit
