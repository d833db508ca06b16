#include "knit/short_rows/short_rows_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "knit/short_rows/placing.h"

namespace knit {

namespace {

NoChart reason_of(NoPart why) {
  switch (why) {
    case NoPart::no_loop:
      return NoChart::no_loop;
    case NoPart::apart:
      return NoChart::apart;
    case NoPart::no_annulus:
      break;
  }
  return NoChart::no_annulus;
}

// Fills in the chart, or why there is none.
void chart_tube(const ChartAt& at, PlannedPairs& work, const Heard& heard) {
  const Tube& tube = at.plan.tube(at.tube);
  const auto low = static_cast<std::size_t>(work.low_row), high = static_cast<std::size_t>(work.high_row);
  const auto part = cut_tube(at.input, at.field, {tube.values[low], &*tube.curves[low]},
                             {tube.values[high], &*tube.curves[high]}, at.stitch.width);
  if (const auto* why = std::get_if<NoPart>(&part)) {
    work.none = reason_of(*why);
    return;
  }
  auto chart = make_tube_chart(std::get<TubePart>(part), at.stitch.height, chart_columns, heard);
  if (const auto* refusal = std::get_if<ChartRefusal>(&chart)) {
    work.residual = refusal->residual;
    work.none = refusal->reason == ChartRefusal::Reason::residual ? NoChart::residual : NoChart::not_solved;
    return;
  }
  work.residual = std::get<TubeChart>(chart).residual;
  work.rounds = full_rounds(std::get<TubeChart>(chart), at.stitch.height);
  work.chart = Shared(std::get<TubeChart>(std::move(chart)));
  if (work.rounds.crowded) work.none = NoChart::crowded;
}

// All but the chart and what follows from it.
PlannedPairs to_be_planned(const ChartAt& at) {
  PlannedPairs work;
  work.tube = at.tube;
  work.stitch_width = at.stitch.width;
  work.stitch_height = at.stitch.height;
  work.settings = {at.settings.turn_cost, at.settings.turn_step, at.settings.shortest};
  const Tube& tube = at.plan.tube(at.tube);
  work.low_row = at.kept.low;
  work.high_row = tube.rows() - 1 - at.kept.high;
  work.low_curve = tube.curves[static_cast<std::size_t>(work.low_row)];
  work.high_curve = tube.curves[static_cast<std::size_t>(work.high_row)];
  return work;
}

TubeCharted begin_planning(const ChartAt& at, std::optional<PlannedPairs>& work, const Heard& heard) {
  work = to_be_planned(at);
  if (const PlannedPairs* known = planned_ahead(at)) {
    work->residual = known->residual;
    work->chart = known->chart;
    work->rounds = known->rounds;
    work->none = known->none == NoChart::no_pair ? NoChart::no : known->none;  // pairs are yet to be chosen
  } else {
    chart_tube(at, *work, heard);
  }
  return {static_cast<std::int16_t>(at.tube),
          work->none,
          work->chart ? work->chart->levels() : 0,
          work->rounds.gaps() + 1,
          at.plan.tube(at.tube).rows() - at.kept.low - at.kept.high,
          static_cast<float>(work->residual),
          static_cast<float>(work->rounds.spacing)};
}

PairsChosen end_planning(const ChartAt& at, PlannedPairs& work) {
  if (work.search.arcs.empty()) work.none = NoChart::no_pair;
  if (at.middle) work.first_column = middle_of_arcs(work.search, work.chart->mirror);
  return {static_cast<std::int16_t>(at.tube), static_cast<std::int32_t>(work.search.arcs.size()),
          work.rounds.gaps() + 1, static_cast<float>(work.search.greatest_lag)};
}

std::size_t wrapped(std::int32_t place, std::int32_t all) {
  return static_cast<std::size_t>((place % all + all) % all);
}

// How many short-row stitches stand on each stitch of the round below: of all pairs, and of those that are worked.
struct Stacked {
  std::vector<std::int32_t> all, worked;
};
Stacked stacked(const GapWork& work, std::int32_t size) {
  Stacked stack{std::vector<std::int32_t>(static_cast<std::size_t>(size), 0), {}};
  stack.worked = stack.all;
  for (std::size_t i = 0; i < work.plans->pairs.size(); ++i) {
    const PairPlan& pair = work.plans->pairs[i];
    const auto at = static_cast<std::size_t>(work.worked);
    const std::int32_t worked = i < at ? 2 : i == at && work.out ? 1 : 0;
    for (std::int32_t place = pair.first; place <= pair.last; ++place) {
      stack.all[wrapped(place, size)] += 2;
      stack.worked[wrapped(place, size)] += worked;
    }
  }
  return stack;
}

Row short_row(const PlannedPairs& pairs, const Fabric& fabric, const Row& below, const GapWork& work) {
  const PairPlan& pair = work.plans->pairs[static_cast<std::size_t>(work.worked)];
  const std::int32_t size = size_of(below);
  const LiveStitches loop = fabric.live(below.tube);
  const auto first = static_cast<std::int32_t>(wrapped(pair.first, size));
  Row row;
  row.tube = below.tube;
  row.id = fabric.next_row();
  row.on = arc_of(loop, first, pair.stitches());
  row.level = below.level;
  row.time = below.time;
  row.closed = false;
  row.turned = ShortRow{loop.at(static_cast<std::int32_t>(wrapped(first - 1, size))),
                        loop.at(static_cast<std::int32_t>(wrapped(pair.last + 1, size))), work.out};
  const std::vector<double>& columns = *work.columns;
  const Stacked stack = stacked(work, size);
  const auto gap = static_cast<std::size_t>(below.level - pairs.low_row);
  const double low = pairs.rounds.levels[gap], high = pairs.rounds.levels[gap + 1];
  Ring ring;
  ring.ordered_by = OrderedBy::cut;
  for (std::int32_t place = pair.first; place <= pair.last; ++place) {
    const std::size_t i = wrapped(place, size);
    const double up = double(stack.worked[i] + 1) / double(stack.all[i] + 1);
    row.stitches.push_back({point_at(*pairs.chart, low + (high - low) * up, columns[i]), no_vertex});
    ring.points.push_back(row.stitches.back().position);
  }
  measure_arcs(ring);
  ring.length = ring.arc.back();  // from end to end
  row.ring = Shared(std::move(ring));
  return row;
}

}  // namespace

const PlannedPairs* planned_ahead(const ChartAt& at) {
  const PlannedPairs asked = to_be_planned(at);
  for (const Shared<PlannedPairs>& known : at.ahead) {
    if (known->tube == asked.tube && known->stitch_width == asked.stitch_width &&
        known->stitch_height == asked.stitch_height && known->settings == asked.settings &&
        known->low_row == asked.low_row && known->high_row == asked.high_row &&
        known->low_curve == asked.low_curve && known->high_curve == asked.high_curve)
      return &*known;
  }
  return nullptr;
}

PlanningStep advance_planning(const ChartAt& at, std::optional<PlannedPairs>& work, const Heard& heard) {
  if (!work) {
    const TubeCharted charted = begin_planning(at, work, heard);
    return {charted, work->none != NoChart::no};
  }
  if (work->search.done) return {end_planning(at, *work), true};
  const ArcStep step =
      advance_arcs(*work->chart, work->rounds, at.stitch.width, work->settings, work->search);
  if (const auto* lag = std::get_if<LagMeasured>(&step))
    return {GapMeasured{lag->gap, lag->column, static_cast<float>(lag->greatest),
                        static_cast<float>(lag->least)}};
  const auto& arc = std::get<ArcConsidered>(step);
  return {ArcTried{arc.gap, arc.from, arc.to, arc.taken, static_cast<float>(arc.gain),
                   static_cast<float>(arc.price)}};
}

TubePlan with_full_rounds(const TubePlan& plan, const PlannedPairs& pairs, const KeptRows& kept) {
  TubePlan made = plan;
  Tube& tube = made.tubes[static_cast<std::size_t>(pairs.tube)];
  const auto low = static_cast<std::size_t>(kept.low);
  const auto high = static_cast<std::size_t>(tube.rows() - 1 - kept.high);
  const double from = tube.values[low], to = tube.values[high];
  std::vector<double> values, lengths;
  std::vector<Shared<Ring>> curves;
  for (const double level : pairs.rounds.levels) {
    const auto below = std::min(static_cast<std::size_t>(level), pairs.chart->times.size() - 2);
    const double part = level - static_cast<double>(below);
    const double time = pairs.chart->times[below] * (1.0 - part) + pairs.chart->times[below + 1] * part;
    Ring ring = ring_at(*pairs.chart, level, pairs.first_column);
    values.push_back(from + (to - from) * time);
    lengths.push_back(ring.length);
    curves.emplace_back(std::move(ring));
  }
  const auto put = [&](auto& all, auto& rounds) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(low);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(high) + 1;
    all.insert(all.erase(begin, end), rounds.begin(), rounds.end());
  };
  put(tube.values, values);
  put(tube.lengths, lengths);
  put(tube.curves, curves);
  tube.spacing = pairs.rounds.spacing;
  return made;
}

std::vector<double> columns_of(const PlannedPairs& pairs, const Row& below) {
  const std::size_t gap = static_cast<std::size_t>(below.level - pairs.low_row);
  const Ring curve = ring_at(*pairs.chart, pairs.rounds.levels[gap], pairs.first_column);
  const double whole = pairs.chart->columns;
  std::vector<double> columns;
  columns.reserve(below.stitches.size());
  for (const Stitch& stitch : below.stitches) {
    double column = column_of(*pairs.chart, curve, pairs.first_column, nearest_arc(curve, stitch.position));
    if (!columns.empty()) {
      while (column <= columns.front()) column += whole;
      column = std::max(column, columns.back());
    }
    columns.push_back(column);
  }
  return columns;
}

PairPlans pairs_over(const PlannedPairs& pairs, const Row& below, std::span<const double> columns,
                     std::span<const std::uint8_t> plain) {
  PairPlans plans;
  const RoundBelow round{{columns.begin(), columns.end()},
                         {plain.begin(), plain.end()},
                         pairs.chart->columns,
                         pairs.chart->mirror.has_value()};
  place_pairs(pairs.arcs_over(below.level), round, plans);
  return plans;
}

Advanced<ShortRowEvent> advance_gap(const PlannedPairs& pairs, const Fabric& fabric, const Row& below,
                                    GapWork& work, std::optional<Row>& row) {
  if (work.dropped < static_cast<std::int32_t>(work.plans->dropped.size())) {
    const DroppedPair& dropped = work.plans->dropped[static_cast<std::size_t>(work.dropped++)];
    return ShortRowEvent(PairDropped{dropped.first, dropped.last, dropped.reason});
  }
  const PairPlan& pair = work.plans->pairs[static_cast<std::size_t>(work.worked)];
  if (!work.placed) {
    work.placed = true;
    return ShortRowEvent(PairPlaced{pair.first, pair.last, pair.moved, static_cast<float>(pair.gain),
                                    static_cast<float>(pair.price), static_cast<float>(pair.lag)});
  }
  row = short_row(pairs, fabric, below, work);
  const ShortRowWorked step{pair.stitches(), pair.first, pair.last, work.out};
  if (work.out) {
    ++work.worked;
    work.placed = work.out = false;
  } else {
    work.out = true;
  }
  return {ShortRowEvent(step), Ended::row};
}

}  // namespace knit
