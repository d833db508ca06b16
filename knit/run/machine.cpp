#include "knit/run/machine.h"

#include <algorithm>
#include <utility>

#include "knit/model/bug.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/relax/relax_stage.h"
#include "knit/rhythm/rhythm_plan.h"
#include "knit/rhythm/segment_search.h"
#include "knit/run/kept_trial.h"
#include "knit/run/knitters_order.h"
#include "knit/run/short_rows_due.h"
#include "knit/settle/settle_stage.h"
#include "knit/stitches/below_joins.h"
#include "knit/stitches/short_join.h"

namespace knit {

namespace {

// --- What was left to itself, group by group: a step copies only what its stage reads

TimingSettings timing_as_chosen(const Parameters& parameters, const State& state) {
  TimingSettings timing = parameters.timing;
  if (timing.kind != TimingKind::by_itself) return timing;
  const auto* work = std::get_if<TimingWork>(&state.work);
  if (parameters.rows.source == RowSource::rings) {
    timing.kind = TimingKind::linear;  // no other time has rings
  } else if (state.timing) {
    timing.kind = state.timing->kind;
  } else if (work != nullptr && work->ends) {
    timing.kind = work->kind;
  }
  return timing;
}

StitchSettings stitches_as_chosen(StitchSettings stitches, const State& state) {
  if (state.short_rows.foreseen_by && state.short_rows.foreseen_by->for_good)
    return state.short_rows.foreseen_by->stitches;
  if (stitches.placement != PlacementPolicy::by_itself) return stitches;
  if (state.rows_from == RowSource::rings) stitches.placement = PlacementPolicy::thesis;
  if (state.rows_from == RowSource::contours) stitches.placement = PlacementPolicy::nearest;
  return stitches;
}

Settling settling_as_chosen(Settling settling, const State& state) {
  if (settling != Settling::by_itself || state.rows_from == RowSource::by_itself) return settling;
  return state.rows_from == RowSource::contours ? Settling::on : Settling::off;
}

// --- One step

// What a step did, and what ended with it.
struct Taken {
  Event what;
  Ended ended = Ended::step;

  template <class StageEvent>
  Taken(Advanced<StageEvent> advanced)
      : what(std::visit([](auto& happened) { return Event(std::move(happened)); }, advanced.what)),
        ended(advanced.ended) {}
};

template <class Product>
void keep(Fabric& fabric, Product&& made) {
  if (made) fabric.add(std::move(*made));
}
void keep(Fabric& fabric, Shared<Join>&& made) {
  if (made) fabric.add(std::move(made));
}
void keep(Fabric& fabric, Shared<Strip>&& made) {
  if (made) fabric.add(std::move(made));
}

// A row that is made, or in the making, on the live stitches of its tube.
struct WorkedRow {
  TubeId tube = 0;
  std::int32_t level = 0;
  std::int32_t below = 0, above = 0;  // stitches
  RowId id = 0;
};

// A round that comes of no segment, as the first on live stitches: to the count of its tube's rhythm, where that is one repeat.
std::optional<RepeatedRound> round_by_itself(const TubeRhythm& rhythm, const WorkedRow& row) {
  if (row.below == 0 || rhythm.count(row.level) != row.above || rhythm.is_joint(row.level)) return {};
  const bool in_pairs = rhythm.settings.style == RhythmStyle::pairs;
  const std::int32_t sections =
      row.below == row.above ? rhythm.plan.sections : sections_to_begin(row.below, row.above, in_pairs);
  if (sections == 0) return {};
  return RepeatedRound{row.below, row.above, sections, rhythm.settings.style, 0, row.id};
}

// How the row is worked if its count and the one below are of one rhythm. The last plan that has both says so.
std::optional<RepeatedRound> repeated_round(const State& state, const WorkedRow& row) {
  for (auto i = state.rhythms.size(); i-- > 0;) {
    const TubeRhythm& rhythm = *state.rhythms[i];
    if (rhythm.tube != row.tube || !rhythm.has(row.level)) continue;
    const bool begins = row.level == 0 && rhythm.from == 0;
    if (begins || rhythm.none != NoRhythm::no) return round_by_itself(rhythm, row);
    if (!rhythm.has(row.level - 1)) continue;
    if (rhythm.count(row.level - 1) != row.below || rhythm.count(row.level) != row.above) return {};
    RepeatedRound round{
        row.below, row.above, rhythm.plan.sections, rhythm.settings.style, rhythm.turn(row.level), row.id};
    if (rhythm.is_joint(row.level - 1)) {
      round.front_below = rhythm.front(row.level - 1);
      round.front_above = rhythm.front(row.level);
    }
    return round;
  }
  return {};
}

// How the row hangs that is about to begin, where its rhythm says so; else empty.
std::vector<std::int32_t> links_to_come(const State& state, const ContourWork& work) {
  if (work.phase != ContourPhase::begin || state.rhythms.empty()) return {};
  const TubeId tube = current_tube(*state.tubes, work);
  const std::int32_t below = state.fabric.live(tube).size();
  const auto round = repeated_round(state, {tube, work.row, below, work.count, state.fabric.next_row()});
  return round ? plan_repeats(*round).link : std::vector<std::int32_t>{};
}

Taken take_contours(const Input& input, const Parameters& parameters, State& state, ContourWork& work,
                    const Heard& heard) {
  const std::vector<std::int32_t> links = links_to_come(state, work);
  const ContourAt at{input,        *state.timing, *state.graph, *state.tubes,
                     state.fabric, state.rhythms, links,        begins_on_curve(parameters, state, work)};
  std::optional<Row> row;
  std::optional<Deal> deal;
  std::optional<TubePlan> plan;
  std::optional<TubeRhythm> rhythm;
  Taken taken = advance_contours(parameters.rows, parameters.rhythm, parameters.stitch, at, work,
                                 {row, deal, plan, rhythm}, heard);
  keep(state.fabric, std::move(row));
  keep(state.fabric, std::move(deal));
  if (plan) state.tubes = Shared(std::move(*plan));
  if (rhythm) state.rhythms.emplace_back(std::move(*rhythm));
  return taken;
}

// How stitches are placed from here on.
PlacedBy placing(const Parameters& parameters, const State& state) {
  const std::optional<PlacedBy>& foreseen_by = state.short_rows.foreseen_by;
  if (foreseen_by && foreseen_by->for_good) return *foreseen_by;
  return {stitches_as_chosen(parameters.stitches, state), parameters.stitch.width,
          parameters.rows.round_start, false};
}

// The join that a row will get; of the fabric's rows, or of the next one.
Join join_to_come(const Parameters& parameters, const State& state, const Fabric& fabric, const Row& row) {
  const JoinGround ground = ground_of(fabric, row);
  const PlacedBy by = placing(parameters, state);
  const bool follows = by.round_start == RoundStart::follow;
  const JoinAt at{row.id,
                  ground.from,
                  ground.below,
                  ground.joins.mains,
                  ground.joins.shaped,
                  ground.joins.cast_on,
                  &row,
                  follows,
                  is_short(row)
                      ? std::nullopt
                      : repeated_round(state, {row.tube, row.level, row.on.size(), size_of(row), row.id}),
                  false,
                  ground.marked};
  StitchSize stitch = parameters.stitch;
  stitch.width = by.stitch_width;
  Join join = plan_row_join(by.stitches, stitch, at);
  join.from = ground.from;
  return join;
}

// How the round to come will hang: it is worked ahead, on a copy.
std::vector<std::uint8_t> plain_to_come(const Input& input, const Parameters& parameters, State& state) {
  if (const PlacedBy by = placing(parameters, state); state.short_rows.foreseen_by != by) {
    state.short_rows.foreseen.clear();
    state.short_rows.foreseen_by = by;
  }
  State ahead = state;
  auto& work = std::get<ContourWork>(ahead.work);
  while (ahead.fabric.row_count() == state.fabric.row_count())
    take_contours(input, parameters, ahead, work, {});
  Fabric fabric = ahead.fabric;
  for (const Shared<Join>& join : state.short_rows.foreseen) fabric.add(join);
  const RowId known = state.short_rows.foreseen.empty() ? 0 : state.short_rows.foreseen.back()->to;
  for (RowId id = fabric.next_worked(known); id != 0; id = fabric.next_worked(id)) {
    Shared<Join> join(join_to_come(parameters, ahead, fabric, fabric.row(id)));
    if (id <= state.fabric.row_count()) state.short_rows.foreseen.push_back(join);
    fabric.add(std::move(join));
  }
  return plain_below(*fabric.joins().back());
}

Taken take_planning(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  const TubeId tube = current_tube(*state.tubes, std::get<ContourWork>(state.work));
  const KeptRows kept = rows_kept(*state.tubes, tube, rows_beside_events(parameters, state));
  const std::vector<double> field = field_of(input, *state.graph);
  const ChartAt at{input,
                   field,
                   *state.tubes,
                   tube,
                   kept,
                   parameters.stitch,
                   parameters.short_rows,
                   begins_in_middle(parameters, *state.tubes, tube, kept),
                   state.short_rows.ahead};
  std::optional<PlannedPairs>& planning = state.short_rows.planning;
  const PlanningStep step = advance_planning(at, planning, heard);
  if (step.done) {
    if (planning->none == NoChart::no) state.tubes = Shared(with_full_rounds(*state.tubes, *planning, kept));
    state.short_rows.tubes.emplace_back(std::move(*planning));
    planning.reset();
  }
  return Advanced<ShortRowEvent>(step.what);
}

Taken take_gap(const Input& input, const Parameters& parameters, State& state) {
  const auto& work = std::get<ContourWork>(state.work);
  const TubeId tube = current_tube(*state.tubes, work);
  const PlannedPairs& pairs = *pairs_of(state, tube);
  const Row& below = *last_round(state.fabric, tube);
  GapWork& gap = state.short_rows.gap;
  if (!gap.is_for(tube, work.row)) {
    const std::vector<std::uint8_t> plain = plain_to_come(input, parameters, state);
    Shared columns(columns_of(pairs, below));
    gap = {tube, work.row, Shared(pairs_over(pairs, below, *columns, plain)), columns};
  }
  std::optional<Row> row;
  Taken taken = advance_gap(pairs, state.fabric, below, gap, row);
  if (row) state.short_rows.foreseen_by->for_good = true;
  keep(state.fabric, std::move(row));
  return taken;
}

Taken take_choice_of_pairs(const Input& input, const Parameters& parameters, State& state,
                           const Heard& heard) {
  return Advanced<ShortRowEvent>(advance_kept_choice(input, parameters, state, heard));
}

Taken take_cast_on(const Input& input, const Parameters& parameters, State& state, CastOnWork& work) {
  std::optional<Row> row;
  Taken taken = advance_cast_on(input, parameters.rows, parameters.stitch, *state.timing, work,
                                {state.last_level, row});
  keep(state.fabric, std::move(row));
  return taken;
}

Taken take_first_row(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  if (auto* rings = std::get_if<CastOnWork>(&state.work))
    return take_cast_on(input, parameters, state, *rings);
  const ShortRowsDue due = short_rows_due(parameters, state);
  if (due == ShortRowsDue::choice) return take_choice_of_pairs(input, parameters, state, heard);
  if (due == ShortRowsDue::plan) return take_planning(input, parameters, state, heard);
  return take_contours(input, parameters, state, std::get<ContourWork>(state.work), heard);
}

Taken take_row(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  if (auto* contours = std::get_if<ContourWork>(&state.work)) {
    if (const auto due = short_rows_due(parameters, state); due != ShortRowsDue::none)
      return due == ShortRowsDue::plan ? take_planning(input, parameters, state, heard)
                                       : take_gap(input, parameters, state);
    return take_contours(input, parameters, state, *contours, heard);
  }
  const RingRow at{*state.timing, state.last_level, state.next.row, state.fabric};
  std::optional<Row> row;
  Taken taken =
      advance_rings(input, parameters.rows, parameters.stitch, at, std::get<RowWork>(state.work), row);
  keep(state.fabric, std::move(row));
  return taken;
}

// The join into row state.next.row; where no row is worked on another, there is none to make. What lies below is read
// until the join is planned; the steps that place label after label go by the plan.
Taken take_join(const Parameters& parameters, State& state) {
  const Fabric& fabric = state.fabric;
  const RowId id = state.next.row;
  auto& work = std::get<IndexWork>(state.work);
  const Row* row = fabric.find_row(id);
  if (row != nullptr && row->on.empty()) row = nullptr;
  const bool planned = work.phase == IndexPhase::place;
  JoinGround ground;
  if (!planned && row != nullptr) ground = ground_of(fabric, *row);
  if (!planned && row == nullptr) ground.below = fabric.row(1).stitches;
  const bool round = row != nullptr && !is_short(*row);
  const PlacedBy by = placing(parameters, state);
  const bool follows = state.tubes && by.round_start == RoundStart::follow;
  const JoinAt at{id,
                  ground.from,
                  ground.below,
                  ground.joins.mains,
                  ground.joins.shaped,
                  ground.joins.cast_on,
                  row,
                  follows,
                  round
                      ? repeated_round(state, {row->tube, row->level, row->on.size(), size_of(*row), row->id})
                      : std::nullopt,
                  fabric.next_worked(id) == 0,
                  ground.marked};
  StitchSize stitch = parameters.stitch;
  stitch.width = by.stitch_width;
  Shared<Join> join;
  Taken taken = advance_index(by.stitches, stitch, at, work, join);
  keep(state.fabric, std::move(join));
  return taken;
}

Taken take_strip(State& state) {
  const RowId row = state.next.row;
  const StripAt at{state.fabric, *state.fabric.join_into(row), state.fabric.next_worked(row) == 0};
  Shared<Strip> strip;
  Taken taken = advance_faces(at, std::get<FacesWork>(state.work), strip);
  keep(state.fabric, std::move(strip));
  return taken;
}

// The first step moves nobody.
Taken take_settling(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  Taken taken = advance_settle(input, parameters.settle, parameters.stitch, std::get<SettleWork>(state.work),
                               state.fabric, heard);
  if (!state.placed) state.placed = Shared(knitting_path(state.fabric));
  return taken;
}

Taken take_relaxing(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  const glm::dvec3 along = knitting_direction(parameters.timing, input.mesh);
  std::optional<KnittedPiece> piece;
  RelaxSettings relax = parameters.relax;
  if (!input.rims.empty()) relax.stuffing = 0.0;  // it would fall out
  Taken taken = advance_relax({state.fabric, parameters.stitch, along}, relax,
                              std::get<RelaxWork>(state.work), piece, heard);
  if (piece) state.relaxed = Shared(std::move(*piece));
  return taken;
}

Taken take_line(State& state) {
  const RowId row = state.next.row;
  const LineAt at{row, size_of(state.fabric.row(row)), state.fabric.join_into(row), state.next.item > 0,
                  row == state.fabric.row_count()};
  Shared<CountedLine> line;
  Taken taken = advance_pattern(at, line);
  if (line) state.lines.push_back(std::move(line));
  return taken;
}

// The last step of the stage timing, where nobody said what rows are made from.
Taken take_choice(const Input& input, State& state) {
  const RowsChosen chosen = choose_rows(input, *state.timing);
  state.rows_from = chosen.source;
  return Advanced<ChoiceEvent>(chosen, Ended::stage);
}

Taken take_tubes(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  const auto reorder = [&](const TubeGraph& graph, const TubePlan& plan) {
    const Parameters chosen = as_chosen(parameters, state);
    return in_knitters_order({input, *state.timing, graph, chosen.stitch, chosen.rows, chosen.stitches},
                             plan);
  };
  return advance_tubes(input, *state.timing, parameters.tubes, parameters.stitch,
                       std::get<TubesWork>(state.work), {state.graph, state.tubes}, reorder, heard);
}

Taken take(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  switch (state.next.stage) {
    case Stage::timing:
      if (state.timing) return take_choice(input, state);
      return advance_timing(input, timing_as_chosen(parameters, state), std::get<TimingWork>(state.work),
                            state.timing, heard);
    case Stage::tubes:
      return take_tubes(input, parameters, state, heard);
    case Stage::cast_on:
      return take_first_row(input, parameters, state, heard);
    case Stage::rows:
      return take_row(input, parameters, state, heard);
    case Stage::stitches:
      return take_join(parameters, state);
    case Stage::faces:
      return take_strip(state);
    case Stage::settle:
      return take_settling(input, parameters, state, heard);
    case Stage::relax:
      return take_relaxing(input, parameters, state, heard);
    case Stage::pattern:
      return take_line(state);
    case Stage::import:
    case Stage::done:
      break;
  }
  throw Bug("advance() was called on a finished state");
}

// --- From stage to stage -------------------------------------------------------------------------------------

void begin(State& state, Stage stage, std::int32_t row, Work work) {
  state.work = std::move(work);
  state.next = {stage, row, 0};
}

// What comes once all stitches are where they stay on the mesh.
void begin_in_the_air(const Parameters& parameters, State& state) {
  if (parameters.relax.relaxing == Relaxing::on) return begin(state, Stage::relax, 0, RelaxWork{});
  begin(state, Stage::pattern, 1, PatternWork{});
}

RowId first_worked(const State& state) { return std::max(state.fabric.next_worked(0), 2); }

void begin_next_stage(const Parameters& parameters, State& state) {
  switch (state.next.stage) {
    case Stage::timing:
      if (parameters.rows.source != RowSource::by_itself) state.rows_from = parameters.rows.source;
      if (state.rows_from == RowSource::by_itself) {
        ++state.next.item;
        return;
      }
      if (state.rows_from == RowSource::contours) return begin(state, Stage::tubes, 0, TubesWork{});
      return begin(state, Stage::cast_on, 1, CastOnWork{});
    case Stage::tubes:
      return begin(state, Stage::cast_on, 1, ContourWork{});
    case Stage::cast_on:
      // From contours the stage cast on ends only where no row follows; rings may have levels left.
      if (const Row* cast_on = state.fabric.find_row(1); cast_on != nullptr &&
                                                         std::holds_alternative<CastOnWork>(state.work) &&
                                                         cast_on->level < state.last_level) {
        return begin(state, Stage::rows, 2, row_work_at(cast_on->level + 1));
      }
      return begin(state, Stage::stitches, first_worked(state), IndexWork{});
    case Stage::rows:
      return begin(state, Stage::stitches, first_worked(state), IndexWork{});
    case Stage::stitches:
      if (state.fabric.joins().empty()) return begin(state, Stage::pattern, 1, PatternWork{});
      return begin(state, Stage::faces, first_worked(state), FacesWork{});
    case Stage::faces:
      if (settling_as_chosen(parameters.settle.settling, state) == Settling::on)
        return begin(state, Stage::settle, 0, SettleWork{});
      return begin_in_the_air(parameters, state);
    case Stage::settle:
      return begin_in_the_air(parameters, state);
    case Stage::relax:
      return begin(state, Stage::pattern, 1, PatternWork{});
    case Stage::pattern:
    case Stage::import:
    case Stage::done:
      return begin(state, Stage::done, 0, Finished{});
  }
}

// Joins and strips lead to the rows that are worked on others; all other stages go from row to row.
RowId row_after(const State& state) {
  const bool by_joins = state.next.stage == Stage::stitches || state.next.stage == Stage::faces;
  return by_joins ? state.fabric.next_worked(state.next.row) : state.next.row + 1;
}

void hand_on(const Parameters& parameters, State& state, Ended ended) {
  switch (ended) {
    case Ended::step:
      ++state.next.item;
      return;
    case Ended::row: {
      const bool first_row = state.next.stage == Stage::cast_on;
      state.next = {first_row ? Stage::rows : state.next.stage, row_after(state), 0};
      return;
    }
    case Ended::stage:
      return begin_next_stage(parameters, state);
  }
}

}  // namespace

Step advance(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  const Place place = state.next;
  Taken taken = take(input, parameters, state, heard);
  if (!is<Stopped>(taken.what)) hand_on(parameters, state, taken.ended);
  return {place, taken.what};
}

namespace {

constexpr std::size_t many_triangles = 20000;
constexpr std::size_t many_settled = 50;    // stitches: all iterations together take some milliseconds
constexpr std::size_t many_relaxed = 8000;  // stitches: one iteration takes some milliseconds
// Microseconds.
constexpr double of_a_triangle = 1.0, of_a_stitch = 2.0;
constexpr double part_of_a_frame = 2000.0, a_frame = 16000.0, a_blink = 100000.0;

}  // namespace

bool step_sweeps(const Input& input, const Parameters& parameters, const State& state) {
  if (std::holds_alternative<SettleWork>(state.work)) return true;
  if (const auto* relax = std::get_if<RelaxWork>(&state.work)) return relaxing_sweeps(*relax);
  const ShortRowsDue due = short_rows_due(parameters, state);
  if (due == ShortRowsDue::choice || (due == ShortRowsDue::plan && !state.short_rows.planning)) return true;
  if (const auto* tubes = std::get_if<TubesWork>(&state.work)) return next_sweeps_surface(*tubes);
  const auto* timing = std::get_if<TimingWork>(&state.work);
  return timing != nullptr && next_is_a_solve(input, parameters.timing, *timing);
}

namespace {

// Whether the next step plans a rhythm of many rows and stitches.
bool plans_long(const Input& input, const Parameters& parameters, const State& state) {
  const auto* work = std::get_if<ContourWork>(&state.work);
  if (work == nullptr || parameters.rhythm.counts == CountPlanning::whole) return false;
  const ContourAt at{input, *state.timing, *state.graph, *state.tubes, state.fabric, state.rhythms};
  if (!next_plans_rhythm(parameters.rhythm, parameters.stitch, at, *work)) return false;
  const std::vector<double>& lengths = state.tubes->tube(current_tube(*state.tubes, *work)).lengths;
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  return microseconds_to_plan(static_cast<double>(lengths.size()), longest / parameters.stitch.width) >
         a_blink;
}

}  // namespace

bool step_is_long(const Input& input, const Parameters& parameters, const State& state) {
  if (std::holds_alternative<SettleWork>(state.work)) return state.fabric.stitch_count() >= many_settled;
  if (const auto* relax = std::get_if<RelaxWork>(&state.work)) {
    const std::size_t stitches = state.fabric.stitch_count();
    return stitches >= many_relaxed || (next_factors(*relax) && stitches >= many_relaxed / 8);
  }
  if (short_rows_due(parameters, state) == ShortRowsDue::choice) return true;
  const auto* tubes = std::get_if<TubesWork>(&state.work);
  if (tubes != nullptr && tubes->phase == TubesPhase::plan && !tubes->plan &&
      microseconds_to_order(*tubes->graph, parameters.stitch) > a_frame)
    return true;
  if (plans_long(input, parameters, state)) return true;
  return input.mesh.triangles.size() >= many_triangles && step_sweeps(input, parameters, state);
}

bool change_takes_a_moment(const Input& input, const Parameters& before, const Parameters& after,
                           const State& end) {
  const std::size_t triangles = input.mesh.triangles.size();
  if (!end.tubes || triangles >= many_triangles || first_reader_of_change(before, after) != Stage::tubes)
    return false;
  const double smaller =
      (before.stitch.width * before.stitch.height) / (after.stitch.width * after.stitch.height);
  const double stitches = static_cast<double>(end.fabric.stitch_count()) * smaller;
  const double time = of_a_triangle * static_cast<double>(triangles) + of_a_stitch * stitches +
                      microseconds_to_order(*end.graph, after.stitch);
  return time > part_of_a_frame && time < a_blink;
}

Parameters as_chosen(Parameters parameters, const State& state) {
  parameters.timing = timing_as_chosen(parameters, state);
  if (parameters.rows.source == RowSource::by_itself) parameters.rows.source = state.rows_from;
  parameters.settle.settling = settling_as_chosen(parameters.settle.settling, state);
  parameters.stitches = stitches_as_chosen(parameters.stitches, state);
  return parameters;
}

Fabric placed_fabric(const State& state) {
  return state.placed ? state.fabric.moved_to(*state.placed) : state.fabric;
}

std::shared_ptr<const std::vector<glm::dvec3>> relaxed_places(const State& state) {
  using Aliased = std::shared_ptr<const std::vector<glm::dvec3>>;
  if (state.relaxed) {
    const auto piece = state.relaxed.pointer();
    return Aliased(piece, &piece->relaxed.positions);
  }
  const auto* work = std::get_if<RelaxWork>(&state.work);
  if (work == nullptr || !work->places) return nullptr;
  const auto places = work->places.pointer();
  return Aliased(places, &places->at);
}

const Join* planned_join(const State& state, RowId into) {
  const auto* work = std::get_if<IndexWork>(&state.work);
  const bool in_progress = work != nullptr && work->plan && work->plan->to == into;
  return in_progress ? &*work->plan : state.fabric.join_into(into);
}

const Strip* planned_strip(const State& state, RowId into) {
  const auto* work = std::get_if<FacesWork>(&state.work);
  const bool in_progress = work != nullptr && work->plan && work->plan->to == into;
  return in_progress ? &*work->plan : state.fabric.strip_into(into);
}

std::size_t copy_bytes(const State& state) {
  const std::size_t work = std::visit(
      [](const auto& stage) -> std::size_t {
        if constexpr (requires { stage.copy_bytes(); }) return stage.copy_bytes();
        return 0;
      },
      state.work);
  return sizeof(State) + state.fabric.copy_bytes() + sizeof(void*) * 2 * state.lines.size() + work;
}

}  // namespace knit
