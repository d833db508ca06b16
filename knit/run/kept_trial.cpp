#include "knit/run/kept_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "knit/run/machine.h"
#include "knit/run/short_rows_due.h"

namespace knit {

namespace {

constexpr std::array ways{no_short_rows, 0, 1, 2};

// A piece of one tube has no events.
std::size_t ways_of(const TubePlan& plan) { return plan.tubes.size() == 1 ? 2 : ways.size(); }

ChartAt chart_at(const Input& input, const Parameters& parameters, const State& state,
                 const std::vector<double>& field, TubeId tube, std::int32_t beside) {
  return {input,
          field,
          *state.tubes,
          tube,
          rows_kept(*state.tubes, tube, beside),
          parameters.stitch,
          parameters.short_rows,
          false,
          state.short_rows.ahead};
}

// Once for each part of a tube, however many ways keep the same rows. As many charts as tubes, three times at most, and only
// for pieces that are settled: of no more than `most_stitches_to_try`; or for one tube, which is then worked by its chart.
void plan_ahead(const Input& input, const Parameters& parameters, State& state, const Heard& heard) {
  const std::vector<double> field = field_of(input, *state.graph);
  for (std::size_t i = 1; i < ways_of(*state.tubes); ++i) {
    for (TubeId tube = 0; tube < static_cast<TubeId>(state.tubes->tubes.size()); ++tube) {
      hear(heard, 0.0);
      if (!can_be_charted(*state.tubes, tube, ways[i])) continue;
      const ChartAt at = chart_at(input, parameters, state, field, tube, ways[i]);
      if (planned_ahead(at) != nullptr) continue;
      std::optional<PlannedPairs> planned;
      if (!advance_planning(at, planned, part_of(heard, 0.0, 0.0)).done) {
        planned->search = choose_arcs(*planned->chart, planned->rounds, at.stitch.width, planned->settings);
        advance_planning(at, planned);
      }
      state.short_rows.ahead.emplace_back(std::move(*planned));
    }
  }
}

// Arcs that pay, in all tubes.
std::int32_t arcs_that_pay(const Input& input, const Parameters& parameters, const State& state,
                           std::int32_t beside) {
  const std::vector<double> no_field;  // plans are only looked up
  std::int32_t arcs = 0;
  for (TubeId tube = 0; tube < static_cast<TubeId>(state.tubes->tubes.size()); ++tube) {
    if (!can_be_charted(*state.tubes, tube, beside)) continue;
    const PlannedPairs* planned = planned_ahead(chart_at(input, parameters, state, no_field, tube, beside));
    if (planned != nullptr && planned->none == NoChart::no)
      arcs += static_cast<std::int32_t>(planned->search.arcs.size());
  }
  return arcs;
}

// Those of another way are not needed again.
void keep_chosen_plans(const Input& input, const Parameters& parameters, State& state) {
  const std::vector<double> no_field;  // plans are only looked up
  std::vector<Shared<PlannedPairs>> chosen;
  for (const Shared<PlannedPairs>& known : state.short_rows.ahead) {
    if (*state.short_rows.kept == no_short_rows ||
        !can_be_charted(*state.tubes, known->tube, *state.short_rows.kept))
      continue;
    const ChartAt at = chart_at(input, parameters, state, no_field, known->tube, *state.short_rows.kept);
    if (planned_ahead(at) == &*known) chosen.push_back(known);
  }
  state.short_rows.ahead = std::move(chosen);
}

Parameters parameters_for(Parameters parameters, std::int32_t way) {
  constexpr std::array kept{KeptBeside::none, KeptBeside::one, KeptBeside::two};
  if (way == no_short_rows) {
    parameters.short_rows.rows = ShortRows::off;
  } else {
    parameters.short_rows.kept = kept[static_cast<std::size_t>(way)];
  }
  parameters.settle.settling = Settling::on;
  parameters.relax.relaxing = Relaxing::off;
  return parameters;
}

// How even they are, and how long the longest is.
void measure_wales(const Fabric& fabric, double stitch_height, KeptTry& made) {
  const std::vector<glm::dvec3> path = knitting_path(fabric);
  double count = 0.0, sum = 0.0, squares = 0.0, longest = 0.0;
  const auto add = [&](const std::vector<std::array<std::uint32_t, 2>>& wales) {
    for (const auto& [lower, upper] : wales) {
      const double length = glm::distance(path[lower], path[upper]);
      ++count;
      sum += length;
      squares += length * length;
      longest = std::max(longest, length);
    }
  };
  for (const auto& strip : fabric.strips()) add(strip->column_edges);
  for (const auto& deal : fabric.deals()) add(deal->column_edges);
  if (sum <= 0.0) return;
  const double mean = sum / count;
  made.wale_cv = static_cast<float>(std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean);
  made.longest_wale = static_cast<float>(longest / stitch_height);
}

// A tube that is due gets its arcs as they were chosen ahead: in a trial nobody looks at each.
void take_plan_ahead(const Input& input, const Parameters& parameters, State& state) {
  if (state.short_rows.planning || short_rows_due(parameters, state) != ShortRowsDue::plan) return;
  const TubeId tube = current_tube(*state.tubes, std::get<ContourWork>(state.work));
  const std::vector<double> no_field;  // plans are only looked up
  const PlannedPairs* known = planned_ahead(
      chart_at(input, parameters, state, no_field, tube, rows_beside_events(parameters, state)));
  if (known == nullptr || (known->none != NoChart::no && known->none != NoChart::no_pair)) return;
  state.short_rows.planning = *known;
  state.short_rows.planning->none = NoChart::no;
}

// Runs ahead until all has settled.
KeptTry settled(const Input& input, const Parameters& as_asked, State ahead, std::int32_t way,
                const Heard& heard) {
  KeptTry made{way, 0, 0, 0.0F, std::numeric_limits<float>::infinity()};
  double sum = 0.0;
  const Parameters parameters = parameters_for(as_asked, way);
  std::vector<Shared<PlannedPairs>> plans = std::move(ahead.short_rows.ahead);
  ahead.short_rows = {};
  ahead.short_rows.ahead = std::move(plans);
  while (ahead.stage() < Stage::pattern) {
    hear(heard, 0.0);
    take_plan_ahead(input, parameters, ahead);
    const bool settles = ahead.stage() == Stage::settle;
    const Step step = advance(input, parameters, ahead);
    if (is_stop(step)) return made;
    if (!settles) continue;
    if (const auto* work = std::get_if<SettleWork>(&ahead.work)) sum = work->sum;
    if (const auto* iteration = get_if<StitchesSettled>(step))
      sum = static_cast<double>(iteration->taken ? iteration->after : iteration->before);
  }
  made.stitches = static_cast<std::int32_t>(ahead.fabric.stitch_count());
  for (const auto& row : ahead.fabric.rows()) made.pairs += is_short(*row) ? 1 : 0;
  made.pairs /= 2;
  made.sum = static_cast<float>(sum / static_cast<double>(made.stitches));
  measure_wales(ahead.fabric, parameters.stitch.height, made);
  return made;
}

bool any_pays(const Input& input, const Parameters& parameters, const State& state) {
  for (std::size_t i = 1; i < ways_of(*state.tubes); ++i)
    if (arcs_that_pay(input, parameters, state, ways[i]) > 0) return true;
  return false;
}

KeptTry try_next(const Input& input, const Parameters& parameters, const State& state, const Heard& heard) {
  const std::vector<KeptTry>& tries = state.short_rows.tries;
  const std::int32_t way = ways[tries.size()];
  if (!tries.empty() && arcs_that_pay(input, parameters, state, way) == 0) {
    KeptTry same = tries.front();
    same.kept = way;
    return same;
  }
  return settled(input, parameters, state, way, heard);
}

KeptChosen choose(const State& state) {
  const std::vector<KeptTry>& tries = state.short_rows.tries;
  const KeptTry& best = best_of(tries);
  const bool refused =
      best.kept == no_short_rows &&
      std::any_of(tries.begin(), tries.end(), [&](const KeptTry& way) { return way.sum < best.sum; });
  return {best.kept, best.pairs, best.sum, tries.front().sum, refused ? ChosenBy::wales : ChosenBy::settling};
}

// About.
double stitches_of(const TubePlan& plan) {
  double stitches = 0.0;
  for (const Tube& tube : plan.tubes)
    for (const double length : tube.lengths) stitches += length / plan.stitch_width;
  return stitches;
}

// Where nothing has to be settled, or nothing can be. Plans ahead unless that would change nothing.
std::optional<KeptChosen> choose_unsettled(const Input& input, const Parameters& parameters, State& state,
                                           const Heard& heard) {
  const bool unsettled = parameters.settle.settling == Settling::off;
  const bool comparable = !unsettled && stitches_of(*state.tubes) <= most_stitches_to_try;
  const ChosenBy by = unsettled ? ChosenBy::unsettled : ChosenBy::too_many;
  if (!comparable && state.tubes->tubes.size() > 1) return KeptChosen{no_short_rows, 0, 0.0F, 0.0F, by};
  plan_ahead(input, parameters, state, heard);
  if (!any_pays(input, parameters, state))
    return KeptChosen{no_short_rows, 0, 0.0F, 0.0F, ChosenBy::no_arc_pays};
  if (comparable) return std::nullopt;
  return KeptChosen{0, arcs_that_pay(input, parameters, state, 0), 0.0F, 0.0F, by};
}

}  // namespace

std::vector<double> field_of(const Input& input, const TubeGraph& graph) {
  std::vector<double> field(input.mesh.positions.size(), 0.0);
  for (std::size_t v = 0; v < graph.surface.origin.size(); ++v)
    field[graph.surface.origin[v]] = graph.surface.values[v];
  return field;
}

ShortRowEvent advance_kept_choice(const Input& input, const Parameters& parameters, State& state,
                                  const Heard& heard) {
  ShortRowsMade& made = state.short_rows;
  if (made.chosen_for != to_choose_for(parameters)) {
    made.tries.clear();
    made.kept.reset();
    made.ahead.clear();
    made.chosen_for = to_choose_for(parameters);
  }
  if (made.tries.size() == ways_of(*state.tubes)) {
    const KeptChosen chosen = choose(state);
    made.kept = chosen.kept;
    keep_chosen_plans(input, parameters, state);
    return chosen;
  }
  if (made.tries.empty()) {
    if (const auto chosen = choose_unsettled(input, parameters, state, heard)) {
      made.kept = chosen->kept;
      keep_chosen_plans(input, parameters, state);
      return *chosen;
    }
  }
  made.tries.push_back(try_next(input, parameters, state, heard));
  const KeptTry& last = made.tries.back();
  return KeptTried{last.kept,
                   last.pairs,
                   last.stitches,
                   last.sum,
                   &best_of(made.tries) == &last,
                   !never_worse(last, made.tries.front())};
}

}  // namespace knit
