#include "knit/insight/waiting.h"

#include <algorithm>

namespace knit {

namespace {

// Of a tube that ends by itself, once all its rows are made.
bool is_bound_off(const TubePlan& plan, const Fabric& fabric, TubeId id) {
  const Tube& tube = plan.tube(id);
  if (plan.event(tube.top).kind != EventKind::bind_off) return false;
  const auto made = std::count_if(fabric.rows().begin(), fabric.rows().end(),
                                  [&](const auto& row) { return row->tube == id; });
  return made >= tube.rows();
}

}  // namespace

std::vector<TubeId> waiting_tubes(const State& state) {
  std::vector<TubeId> waiting;
  const auto* work = std::get_if<ContourWork>(&state.work);
  if (work == nullptr || !state.tubes) return waiting;
  const TubeId current = current_tube(*state.tubes, *work);
  for (const LiveLoop& loop : state.fabric.live()) {
    if (loop.tube != current && !is_bound_off(*state.tubes, state.fabric, loop.tube))
      waiting.push_back(loop.tube);
  }
  return waiting;
}

}  // namespace knit
