#include "knit/insight/waiting.h"

#include <algorithm>

namespace knit {

namespace {

// Of a tube that ends by itself, once all its rows are made.
bool is_bound_off(const TubePlan& plan, TubeId id, std::int32_t rows_made) {
  const Tube& tube = plan.tube(id);
  return plan.event(tube.top).kind == EventKind::bind_off && rows_made >= tube.rows();
}

std::int32_t rows_made(const Fabric& fabric, TubeId id) {
  return static_cast<std::int32_t>(std::count_if(fabric.rows().begin(), fabric.rows().end(),
                                                 [&](const auto& row) { return row->tube == id; }));
}

// What hangs on needle and holders, taken on from row to row and from deal to deal.
class Replay {
 public:
  explicit Replay(const TubePlan& plan) : plan_(&plan), made_(plan.tubes.size(), 0) {}

  void take(const Row& row) {
    ++made_[static_cast<std::size_t>(row.tube)];
    put(row.tube, all_of(row));
  }
  void take(const Deal& deal) {
    if (deal.kind == DealKind::ring_cast_on) return;  // its two loops stay as they are
    for (const TubeId tube : deal.from)
      std::erase_if(live_, [&](const LiveLoop& loop) { return loop.tube == tube; });
    for (std::size_t i = 0; i < deal.to.size(); ++i) put(deal.to[i], deal.given[i]);
  }
  [[nodiscard]] std::vector<LiveLoop> waiting(TubeId worked) const {
    std::vector<LiveLoop> loops;
    std::copy_if(live_.begin(), live_.end(), std::back_inserter(loops), [&](const LiveLoop& loop) {
      return loop.tube != worked &&
             !is_bound_off(*plan_, loop.tube, made_[static_cast<std::size_t>(loop.tube)]);
    });
    return loops;
  }

 private:
  void put(TubeId tube, LiveStitches stitches) {
    const auto there =
        std::find_if(live_.begin(), live_.end(), [&](const LiveLoop& loop) { return loop.tube == tube; });
    if (there != live_.end())
      there->stitches = std::move(stitches);
    else
      live_.push_back({tube, std::move(stitches)});
  }

  const TubePlan* plan_;
  std::vector<std::int32_t> made_;  // rows, a tube
  std::vector<LiveLoop> live_;
};

}  // namespace

std::vector<LiveLoop> waiting_loops(const TubePlan& plan, const Fabric& fabric, RowId row) {
  Replay replay(plan);
  auto deal = fabric.deals().begin();
  const auto deals_before = [&](RowId id) {
    for (; deal != fabric.deals().end() && (*deal)->after < id; ++deal) replay.take(**deal);
  };
  for (RowId id = 1; id < row; ++id) {
    deals_before(id);
    replay.take(fabric.row(id));
  }
  deals_before(row);
  return replay.waiting(fabric.row(row).tube);
}

std::vector<LiveLoop> waiting_loops(const State& state) {
  std::vector<LiveLoop> waiting;
  if (!state.tubes) return waiting;
  if (const auto* work = std::get_if<ContourWork>(&state.work)) {
    const TubeId current = current_tube(*state.tubes, *work);
    for (const LiveLoop& loop : state.fabric.live()) {
      if (loop.tube != current && !is_bound_off(*state.tubes, loop.tube, rows_made(state.fabric, loop.tube)))
        waiting.push_back(loop);
    }
    return waiting;
  }
  const bool goes_by_rows = std::holds_alternative<IndexWork>(state.work) ||
                            std::holds_alternative<FacesWork>(state.work) ||
                            std::holds_alternative<PatternWork>(state.work);
  if (!goes_by_rows || !state.fabric.has_row(state.next.row)) return waiting;
  return waiting_loops(*state.tubes, state.fabric, state.next.row);
}

std::vector<TubeId> waiting_tubes(const State& state) {
  std::vector<TubeId> tubes;
  if (!std::holds_alternative<ContourWork>(state.work)) return tubes;
  for (const LiveLoop& loop : waiting_loops(state)) tubes.push_back(loop.tube);
  return tubes;
}

}  // namespace knit
